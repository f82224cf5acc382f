//! Isotropic distributions of normals by their slopes, as they are integrated at creation.
//!
//! P22 = D cos^4 is the density of slopes of facets (Smith 1967; Walter et al. 2007, appendix A), here a
//! function of the squared slope t = tan^2 alone. Integrals run over ln t: whatever lies between the tip
//! and the horizon, be it eight decades, has the same share of the nodes.

use crate::num::{PI, Real, Vec3};

/// D at the normal, 1 / (pi alpha^2): what alpha means for every distribution.
pub(super) fn height(alpha: f64) -> f64 {
    1.0 / (PI * alpha * alpha)
}

/// The normal over +X with that squared slope.
fn normal(tan_squared: f64) -> Vec3<f64> {
    let cos_squared = 1.0 / (1.0 + tan_squared);
    Vec3::new((tan_squared * cos_squared).sqrt(), 0.0, cos_squared.sqrt())
}

/// P22 of a density D at a squared slope.
pub(super) fn slope_density(density: impl Fn(Vec3<f64>) -> f64, tan_squared: f64) -> f64 {
    density(normal(tan_squared)) / (1.0 + tan_squared).squared()
}

/// ln cos^2 of a unit vector's angle to +Z, to its last digits near both ends; h.z must be a positive
/// normal number.
#[inline(always)]
pub(super) fn ln_cos_squared<T: Real>(h: Vec3<T>) -> T {
    let sin_squared = sin_squared(h);
    let is_near = sin_squared.lt(T::new(0.5));
    let near = (-sin_squared.min(T::new(0.5))).ln_1p();
    T::select(is_near, near, h.z.ln() * T::new(2.0))
}

/// sin^2 of a unit vector's angle to +Z, from the components that have its digits.
#[inline(always)]
pub(super) fn sin_squared<T: Real>(h: Vec3<T>) -> T {
    h.x.squared() + h.y.squared()
}

/// Distance h in ln t of the nodes of [`matched_width`]. The trapezoidal rule converges exponentially
/// (Trefethen and Weideman 2014, "The Exponentially Convergent Trapezoidal Rule", theorem 5.1); the
/// sharpest integrand, t e^(-t), is summed with a relative error of 2 |Gamma(1 + 2 pi i / h)|, by its
/// Fourier transform: 1.2e-11.
const STEP: f64 = 0.35;

/// The logarithm of the width, between two bounds, with which a distribution of height 1 at the normal
/// has the projected area pi alpha^2; so that normalised it has the height 1 / (pi alpha^2) there.
///
/// `slopes` is P22 over its value at 0, as a function of the width's logarithm and of t. Regula falsi, modified so that no end stays (Dowell and Jarratt 1971,
/// "A Modified Regula Falsi Method", called Illinois).
pub(super) fn matched_width(alpha: f64, bounds: [f64; 2], slopes: impl Fn(f64, f64) -> f64) -> f64 {
    // Below the first node the integrand is t to within rounding; beyond the last one at most 1 / t.
    let from = 2.0 * alpha.ln() - 32.0;
    let nodes = ((32.0 - from) / STEP) as u32;
    let excess = |width: f64| {
        let area: f64 = (0..nodes)
            .map(|k| (from + STEP * f64::from(k)).exp())
            .map(|t| slopes(width, t) * t)
            .sum();
        (area * STEP).ln() - 2.0 * alpha.ln()
    };
    let [mut a, mut b] = bounds;
    let [mut at_a, mut at_b] = [excess(a), excess(b)];
    for _ in 0..100 {
        let c = b - at_b * (b - a) / (at_b - at_a);
        let at_c = excess(c);
        if at_c.abs() < 1e-12 || (b - a).abs() < 1e-14 {
            return c;
        }
        if (at_c > 0.0) == (at_b > 0.0) {
            at_a *= 0.5;
        } else {
            (a, at_a) = (b, at_b);
        }
        (b, at_b) = (c, at_c);
    }
    b
}
