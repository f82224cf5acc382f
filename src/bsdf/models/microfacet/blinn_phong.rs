//! Blinn's distribution of normals, a power of the cosine (Blinn 1977, "Models of Light Reflection for
//! Computer Synthesized Pictures"; normalised by Walter et al. 2007, eq. 30).

use super::slopes::{height, ln_cos_squared};
use crate::num::{Lane, Vec3};

/// D(h) = (e + 2) / (2 pi) h.z^e with the exponent e = 2 / alpha^2 - 2, so that D = 1 / (pi alpha^2) at the
/// normal, as for GGX and Beckmann's distribution. For small alpha the lobe is nearly Beckmann's. alpha = 1
/// gives e = 0, a constant density.
///
/// alpha is in [1e-4, 1]. Smith's Lambda has no closed form. Walter et al. 2007, section 5.2, approximate
/// it (1.5 % off for alpha = 0.3); here the exact one is tabulated.
#[derive(Clone, Copy)]
pub(crate) struct BlinnPhong<T> {
    at_normal: T,
    half_exponent: T,
    /// alpha^2, for sampling by ln h.z^2 = alpha^2 ln(1 - u).
    alpha_squared: T,
}

impl<T: Lane<Scalar = T>> BlinnPhong<T> {
    /// The distribution for alpha.
    pub(crate) fn new(alpha: f64) -> Self {
        Self {
            at_normal: T::new(height(alpha)),
            half_exponent: T::new(1.0 / (alpha * alpha) - 1.0),
            alpha_squared: T::new(alpha * alpha),
        }
    }

    /// D(h), per steradian.
    #[inline(always)]
    pub(super) fn density<L: Lane<Scalar = T>>(&self, h: Vec3<L>) -> L {
        let exponent = L::splat(self.half_exponent) * ln_cos_squared(h);
        let density = L::splat(self.at_normal) * exponent.exp();
        L::select(h.z.gt(L::new(0.0)), density, L::new(0.0))
    }

    /// Samples a normal with the density D(h) h.z. The share of the projected area beyond an angle,
    /// h.z^(e + 2) = (h.z^2)^(1 / alpha^2), is inverted (Walter et al. 2007, eq. 31 and 32). sin^2 is
    /// computed by expm1, because 1 - h.z^2 has lost its digits.
    #[inline(always)]
    pub(super) fn sample<L: Lane<Scalar = T>>(&self, u: [L; 2]) -> Vec3<L> {
        let ln_cos_squared = L::splat(self.alpha_squared) * (-u[0]).ln_1p();
        let sine = (-ln_cos_squared.exp_m1()).sqrt_positive();
        let cosine = (ln_cos_squared * L::new(0.5)).exp();
        Vec3::new(sine * u[1].cos_turns(), sine * u[1].sin_turns(), cosine)
    }
}
