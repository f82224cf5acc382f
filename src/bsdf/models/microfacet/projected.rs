//! Smith's masking for isotropic distributions without a closed form of it: w.z Lambda(w), tabulated over
//! the cosine.

use super::cubics::{Cubics, keep_falling};
use super::slopes::slope_density;
use crate::num::{Lane, Vec3};

/// The number of pieces of the table, which takes 2 KiB in single precision.
const PIECES: usize = 128;

/// w.z Lambda(w), see [`Ndf::cos_times_lambda`](super::ndf::Ndf::cos_times_lambda).
///
/// With mu = cot theta and the slope r of a facet, it is sin theta times A(mu), which is Heitz 2014, eq.
/// 43, after integration over the azimuth:
///
/// ```text
/// A(mu) = 2 integral from mu to infinity of P22(r) (sqrt(r^2 - mu^2) - mu acos(mu / r)) r dr
/// A'(mu) = -2 integral from mu to infinity of P22(r) acos(mu / r) r dr
/// ```
///
/// A is convex and falls from A(0), which is the mean slope over pi, to 0. The table has A / A(0) as a
/// function of sqrt(mu) / (sqrt(mu) + sqrt(A(0))). A has a cusp at 0 if the slopes have a sharp peak, and
/// falls as 1 / mu if they reach the horizon; in this coordinate it is a parabola at both ends.
///
/// The error of G1 = w.z / (w.z + w.z Lambda) is at most 1e-7 (the unit tests measure it). G1 is in [0, 1]
/// and, apart from rounding, does not fall with w.z.
pub(super) struct Projected<T> {
    at_horizon: T,
    curve: Cubics<T, PIECES>,
}

impl<T: Lane<Scalar = T>> Projected<T> {
    /// The table for a normalised density D, whose greatest value is 1 / (pi alpha^2), at the normal.
    pub(super) fn new(alpha: f64, density: impl Fn(Vec3<f64>) -> f64) -> Self {
        let integrals = |mu: f64| integrals(alpha, &density, mu);
        let [at_horizon, _] = integrals(0.0);
        let mut knots: Vec<[f64; 2]> = (0..PIECES)
            .map(|k| {
                let x = k as f64 / PIECES as f64;
                let root = x / (1.0 - x);
                let [area, slope] = integrals(at_horizon * root * root);
                // mu / A(0) = root^2, its derivative is 2 root / (1 - x)^2.
                let stretch = 2.0 * root / ((1.0 - x) * (1.0 - x)) / PIECES as f64;
                [area / at_horizon, slope * stretch]
            })
            .collect();
        knots.push([0.0, 0.0]);
        keep_falling(&mut knots);
        Self {
            at_horizon: T::new(at_horizon),
            curve: Cubics::new(&knots),
        }
    }

    /// w.z Lambda(w) for w.z >= 0.
    #[inline(always)]
    pub(super) fn cos_times_lambda<L: Lane<Scalar = T>>(&self, w: Vec3<L>) -> L {
        let most = L::splat(self.at_horizon) * (w.x.squared() + w.y.squared()).sqrt();
        let root = w.z.sqrt_positive();
        let x = root / (root + most.sqrt());
        // Rounding may make a piece that ends at 0 slightly negative.
        let share = self.curve.at(x * L::new(PIECES as f64)).max(L::new(0.0));
        most * share
    }
}

/// The distance h of the nodes in ln s. The relative error for the sharpest integrand, s^3 e^(-s^2), is 2
/// |Gamma(3/2 + i pi / h)| / Gamma(3/2) = 1.5e-8, by its Fourier transform.
const STEP: f64 = 0.22;
/// The sum ends with a term below this fraction of it. The terms left out are at most 5 times as much.
const LAST: f64 = 1e-9;

/// A(mu) and A'(mu), with r^2 = mu^2 + s^2, by the trapezoidal rule in ln s.
fn integrals(alpha: f64, density: impl Fn(Vec3<f64>) -> f64, mu: f64) -> [f64; 2] {
    // The part below `least` is less than `least`, because s^2 P22 < 1 for slopes whose density falls. For
    // s below mu the terms grow with the fifth power of s. A(0) is at least 2 alpha / (3 pi), the value for
    // a disk of constant density.
    let least = (1e-9 * alpha).max(5e-3 * mu);
    let mut sums = [0.0; 2];
    for k in 0.. {
        let s = least * (STEP * f64::from(k)).exp();
        let angle = s.atan2(mu);
        let measure = slope_density(&density, mu * mu + s * s) * s * s;
        let term = (s - mu * angle) * measure;
        sums[0] += term;
        sums[1] -= angle * measure;
        // From there on the terms fall at least as fast as 1 / s.
        let is_late = s > alpha.max(mu);
        if is_late && term <= LAST * sums[0].max(mu).max(alpha) {
            break;
        }
    }
    sums.map(|sum| 2.0 * STEP * sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bsdf::models::microfacet::slopes::sin_squared;
    use crate::num::PI;
    use statrs::function::erf::erfc;

    /// The greatest relative error of w.z + w.z Lambda, which is that of G1.
    fn worst(
        alpha: f64,
        density: impl Fn(Vec3<f64>) -> f64,
        cos_times_lambda: impl Fn(f64, f64) -> f64,
    ) -> [f64; 2] {
        let (double, single) = (
            Projected::<f64>::new(alpha, &density),
            Projected::<f32>::new(alpha, &density),
        );
        let mut errors = [0.0; 2];
        for i in 0..10_000 {
            // From cos = 1e-6 alpha to tan = 1e-4.
            let cotangent = alpha * 1e-6 * (1e10 / alpha).powf(f64::from(i) / 9999.0);
            let z = cotangent / (1.0 + cotangent * cotangent).sqrt();
            let x = 1.0 / (1.0 + cotangent * cotangent).sqrt();
            let truth = z + cos_times_lambda(x, z);
            let w = Vec3::new(x as f32, 0.0, z as f32);
            let found = [
                z + double.cos_times_lambda(Vec3::new(x, 0.0, z)),
                z + f64::from(single.cos_times_lambda(w)),
            ];
            for (worst, found) in errors.iter_mut().zip(found) {
                *worst = f64::max(*worst, (found / truth - 1.0).abs());
            }
        }
        println!(
            "alpha = {alpha}: {:.1e}, in single precision {:.1e}",
            errors[0], errors[1]
        );
        errors
    }

    /// Walter et al. 2007, eq. 33, and Heitz 2014, eq. 72; Beckmann's distribution, section 5 there.
    #[test]
    fn is_the_closed_form_of_ggx_and_beckmann() {
        for alpha in [1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.6, 1.0] {
            let squared = alpha * alpha;
            let ggx = |h: Vec3<f64>| {
                let length_squared = sin_squared(h) / squared + h.z * h.z;
                1.0 / (PI * squared * length_squared * length_squared)
            };
            let of_ggx = |x: f64, z: f64| {
                let across = x * x * squared;
                0.5 * across / ((across + z * z).sqrt() + z)
            };
            let [double, single] = worst(alpha, ggx, of_ggx);
            assert!(double < 1e-7 && single < 4e-7);
            let beckmann = |h: Vec3<f64>| {
                let cos_squared = h.z * h.z;
                let exponent = sin_squared(h) / cos_squared / squared;
                (-exponent).exp() / (PI * squared * cos_squared * cos_squared)
            };
            let of_beckmann = |x: f64, z: f64| {
                let a = z / (alpha * x);
                let sum = (-a * a).exp() / (a * PI.sqrt()) - erfc(a);
                0.5 * z * sum
            };
            let [double, single] = worst(alpha, beckmann, of_beckmann);
            assert!(double < 1e-7 && single < 4e-7);
        }
    }

    /// w.z Lambda is 0 for w along the normal and the mean slope over pi at the horizon, and is defined
    /// everywhere.
    #[test]
    fn is_defined_at_both_ends() {
        let even = |_: Vec3<f64>| 1.0 / PI;
        let projected = Projected::<f32>::new(1.0, even);
        assert_eq!(projected.cos_times_lambda(Vec3::new(0.0, 0.0, 1.0f32)), 0.0);
        for z in [0.0, f32::MIN_POSITIVE, 1e-20] {
            let area = projected.cos_times_lambda(Vec3::new(1.0, 0.0, z));
            assert!((area - 0.5).abs() < 1e-6, "{z}: {area}");
        }
    }
}
