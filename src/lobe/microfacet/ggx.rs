//! The distribution of Trowbridge and Reitz 1975, called GGX since Walter et al. 2007: the slopes of
//! an ellipsoid's surface, with long tails.

use super::distribution::{Normals, stretched};
use super::masking::Pair;
use crate::math::{Element, PI, Vec3};

/// GGX with a roughness along each axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ggx<T> {
    /// Along X and Y, > 0.
    pub alpha: [T; 2],
}

impl<T: Element> Ggx<T> {
    /// The same in every direction.
    #[inline(always)]
    pub fn isotropic(alpha: T) -> Self {
        Self { alpha: [alpha; 2] }
    }
}

impl<T: Element> Ggx<T> {
    /// Of the direction [`stretched`].
    #[inline(always)]
    fn length(&self, w: Vec3<T>) -> T {
        stretched(w, self.alpha).length_squared().sqrt()
    }
}

impl<T: Element> Normals<T> for Ggx<T> {
    /// Walter et al. 2007, eq. 33, and its anisotropic form, Burley 2012, eq. 13. The sine comes from
    /// h.x and h.y: for alpha = 1e-4 the whole lobe has h.z = 1 in single precision.
    #[inline(always)]
    fn density(&self, h: Vec3<T>) -> T {
        let [x, y] = self.alpha;
        // (hx / ax)^2 + (hy / ay)^2 + hz^2 with the divisors multiplied out.
        let both = x * y;
        let length_squared = (h.x * y).squared() + (h.y * x).squared() + (h.z * both).squared();
        let density = T::new(1.0 / PI) * both.squared() * both / length_squared.squared();
        T::select(h.z.gt(T::new(0.0)), density, T::new(0.0))
    }

    /// 1 + Lambda = (w.z + length) / (2 w.z), see [`Normals::averted_area`]: with those of both directions the
    /// differences of the lengths cancel on paper.
    #[inline(always)]
    fn smith(&self, pair: &Pair<T>) -> T {
        let ratio = pair.wo.z / pair.wi.z;
        T::new(0.5) / (self.length(pair.wo) + ratio * self.length(pair.wi))
    }

    #[inline(always)]
    fn visible(&self, wo: Vec3<T>, h: Vec3<T>) -> T {
        self.density(h) * T::new(2.0) / (wo.z + self.length(wo))
    }

    /// Lambda = (sqrt(1 + alpha^2 tan^2) - 1) / 2: Heitz 2014, eq. 72 and 80. Multiplied by w.z it is
    /// half the difference of two lengths, written without cancellation.
    #[inline(always)]
    fn averted_area(&self, w: Vec3<T>) -> T {
        let stretched = stretched(w, self.alpha);
        let across = stretched.x.squared() + stretched.y.squared();
        let length = (across + w.z.squared()).sqrt();
        T::new(0.5) * across / (length + w.z)
    }

    /// Visible normals: Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps",
    /// listing 3. The cap's height and radius are written without cancellation.
    #[inline(always)]
    fn sample(&self, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let one = T::new(1.0);
        let view = stretched(wo, self.alpha).normalized();
        let top = one + view.z;
        // z of the point on the cap is this less view.z; so the sine's square is (1 - z)(1 + z).
        let height = (one - u[1]) * top;
        let below = (view.x.squared() + view.y.squared()) / top;
        let sine = (u[1] * top * (height + below)).sqrt_positive();
        let x = sine * u[0].cos_turns() + view.x;
        let y = sine * u[0].sin_turns() + view.y;
        Vec3::new(x * self.alpha[0], y * self.alpha[1], height).normalized()
    }

    #[inline(always)]
    fn sample_density(&self, wo: Vec3<T>, h: Vec3<T>) -> T {
        self.visible(wo, h) * wo.dot(h).max(T::new(0.0))
    }

    #[inline(always)]
    fn reflected_density(&self, wo: Vec3<T>, h: Vec3<T>, _wo_dot_h: T) -> T {
        self.visible(wo, h) * T::new(0.25)
    }
}
