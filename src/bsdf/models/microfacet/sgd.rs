//! The shifted gamma distribution of normals (Bagher, Soler and Holzschuch 2012, "Accurate fitting of
//! measured reflectances using a Shifted Gamma micro-facet distribution", section 4): a tail of power p
//! that an exponential ends.

use super::slopes::{height, ln_cos_squared, matched_width, sin_squared, slope_density};
use crate::num::{Lane, Vec3};

/// With the paper's width written as a and its power as p,
///
/// ```text
/// D(h) = K_ap e^(-x) x^(-p) / (pi cos^4),   x = a + tan^2 / a,   K_ap = 1 / (a Gamma(1 - p, a))
/// ```
///
/// where Gamma(s, x) is the upper incomplete gamma function. K_ap makes the projected area 1.
///
/// a follows from alpha, because the height at the normal is 1 / (pi alpha^2), as for GGX and Beckmann's
/// distribution:
///
/// ```text
/// alpha^2 = a^(1 + p) e^a Gamma(1 - p, a)
/// ```
///
/// This equation is solved for a at creation; it also gives the alpha of parameters that the paper's
/// authors have published. p = 0 is Beckmann's distribution (a = alpha^2). p = 2 equals GGX near the normal
/// (a near alpha) and in the tail up to a slope of sqrt(a).
///
/// alpha is in [1e-4, 1], p in [0, 4]. The authors' fits to 100 measured materials have p from 0 to 1.8,
/// half of them between 0.2 and 0.7 about a median of 0.44.
///
/// The area beyond an angle is Gamma(1 - p, x) / Gamma(1 - p, a), and normals are sampled by a table of its
/// inverse.
#[derive(Clone, Copy)]
pub(crate) struct ShiftedGamma<T> {
    at_normal: T,
    inverse: T,
    inverse_squared: T,
    p: T,
}

/// a for alpha and p. It is at least alpha^2, its value for p = 0, and 2.4 for alpha = 1 and p = 4.
fn width(alpha: f64, p: f64) -> f64 {
    let bounds = [2.0 * alpha.ln() - 0.5, 1.5];
    let ln_a = matched_width(alpha, bounds, |ln_a, tan_squared| {
        let lobe = ShiftedGamma::<f64>::of_numbers(1.0, ln_a.exp(), p);
        slope_density(|h| lobe.density(h), tan_squared)
    });
    ln_a.exp()
}

/// The least cos^2 whose tangent is computed. Below it the exponential is 0 for every a.
const LEAST_COS_SQUARED: f64 = 1e-10;

impl<T: Lane<Scalar = T>> ShiftedGamma<T> {
    /// The distribution for alpha and the power p.
    pub(crate) fn new(alpha: f64, p: f64) -> Self {
        Self::of_numbers(height(alpha), width(alpha, p), p)
    }

    fn of_numbers(at_normal: f64, a: f64, p: f64) -> Self {
        let [at_normal, inverse, inverse_squared, p] =
            [at_normal, 1.0 / a, 1.0 / (a * a), p].map(T::new);
        Self {
            at_normal,
            inverse,
            inverse_squared,
            p,
        }
    }

    /// D(h), per steradian. Divided by its value at the normal, e^(-x) x^(-p) is e^(-tan^2 / a) (1 + tan^2 / a^2)^(-p).
    #[inline(always)]
    pub(super) fn density<L: Lane<Scalar = T>>(&self, h: Vec3<L>) -> L {
        let cos_squared = h.z.squared().max(L::new(LEAST_COS_SQUARED));
        let tan_squared = sin_squared(h) / cos_squared;
        let power = L::splat(self.p) * (tan_squared * L::splat(self.inverse_squared)).ln_1p();
        let exponent =
            tan_squared * L::splat(self.inverse) + power + ln_cos_squared(h) * L::new(2.0);
        let density = L::splat(self.at_normal) * (-exponent).exp();
        L::select(h.z.gt(L::new(0.0)), density, L::new(0.0))
    }
}
