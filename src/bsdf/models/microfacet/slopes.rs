//! Isotropic distributions of normals as distributions of slopes, for the integrals at creation.
//!
//! P22 = D cos^4 is the density of the slopes of facets (Smith 1967; Walter et al. 2007, appendix A), which
//! for isotropic distributions is a function of the squared slope t = tan^2. Integrals are over ln t, so
//! that every decade of slopes, of which there may be eight, gets the same number of nodes.

use crate::num::{PI, Real, Vec3};

/// D at the normal, 1 / (pi alpha^2), which defines alpha for every distribution.
pub(super) fn height(alpha: f64) -> f64 {
    1.0 / (PI * alpha * alpha)
}

/// The normal with that squared slope whose azimuth is that of +X.
fn normal(tan_squared: f64) -> Vec3<f64> {
    let cos_squared = 1.0 / (1.0 + tan_squared);
    Vec3::new((tan_squared * cos_squared).sqrt(), 0.0, cos_squared.sqrt())
}

/// P22 of a density D at a squared slope.
pub(super) fn slope_density(density: impl Fn(Vec3<f64>) -> f64, tan_squared: f64) -> f64 {
    density(normal(tan_squared)) / (1.0 + tan_squared).squared()
}

/// ln cos^2 of the angle of a unit vector to +Z, without cancellation near the normal and near the horizon.
/// h.z must be a positive normal number.
#[inline(always)]
pub(super) fn ln_cos_squared<T: Real>(h: Vec3<T>) -> T {
    let sin_squared = sin_squared(h);
    let is_near = sin_squared.lt(T::new(0.5));
    let near = (-sin_squared.min(T::new(0.5))).ln_1p();
    T::select(is_near, near, h.z.ln() * T::new(2.0))
}

/// sin^2 of the angle of a unit vector to +Z, computed from x and y, which keep its digits.
#[inline(always)]
pub(super) fn sin_squared<T: Real>(h: Vec3<T>) -> T {
    h.x.squared() + h.y.squared()
}

/// The distance h in ln t of the nodes of [`matched_width`]. The trapezoidal rule converges exponentially
/// (Trefethen and Weideman 2014, "The Exponentially Convergent Trapezoidal Rule", theorem 5.1). The
/// relative error for the sharpest integrand, t e^(-t), is 2 |Gamma(1 + 2 pi i / h)| = 1.2e-11, by its
/// Fourier transform.
const STEP: f64 = 0.35;

/// The logarithm of the width, between two bounds, for which a distribution of height 1 at the normal has
/// the projected area pi alpha^2, so that after normalisation its height is 1 / (pi alpha^2).
///
/// `slopes` is P22 over its value at 0, as a function of the logarithm of the width and of t. The equation
/// is solved by the Illinois method, a modified regula falsi (Dowell and Jarratt 1971, "A Modified Regula
/// Falsi Method").
pub(super) fn matched_width(alpha: f64, bounds: [f64; 2], slopes: impl Fn(f64, f64) -> f64) -> f64 {
    // Below the first node the integrand is t to within rounding, and beyond the last one it is at most 1 /
    // t.
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
