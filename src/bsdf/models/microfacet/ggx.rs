//! The distribution of Trowbridge and Reitz 1975, called GGX since Walter et al. 2007: the normals of an
//! ellipsoid, with long tails.

use super::half_vector::HalfVector;
use super::ndf::{Ndf, stretched};
use crate::num::{Lane, PI, Vec3};

/// GGX with a roughness along each axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ggx<T> {
    /// The roughness along X and along Y, > 0.
    pub alpha: [T; 2],
    /// Whether both are known to be equal, so that less is computed.
    pub is_round: bool,
}

impl<T: Lane> Ggx<T> {
    /// GGX with the same roughness along both axes.
    #[inline(always)]
    pub fn isotropic(alpha: T) -> Self {
        Self {
            alpha: [alpha; 2],
            is_round: true,
        }
    }

    /// The length of the direction after [`stretched`].
    #[inline(always)]
    fn length(&self, w: Vec3<T>) -> T {
        let across = if self.is_round {
            self.alpha[0].squared() * (w.x.squared() + w.y.squared())
        } else {
            let stretched = stretched(w, self.alpha);
            stretched.x.squared() + stretched.y.squared()
        };
        (across + w.z.squared()).sqrt()
    }

    /// D of the direction along `v`, given the squared length of `v`. Walter et al. 2007, eq. 33, and its
    /// anisotropic form, Burley 2012, eq. 13, with the divisors multiplied out. The sine is computed from
    /// v.x and v.y, because for alpha = 1e-4 the whole lobe has h.z = 1 in single precision.
    #[inline(always)]
    fn density_along(&self, v: Vec3<T>, length_squared: T) -> T {
        let [x, y] = self.alpha;
        let both = x * y;
        let (factor, divisor) = if self.is_round {
            (both, v.x.squared() + v.y.squared() + both * v.z.squared())
        } else {
            // (vx / ax)^2 + (vy / ay)^2 + vz^2
            let across = (v.x * y).squared() + (v.y * x).squared();
            (both.squared() * both, across + (v.z * both).squared())
        };
        T::new(1.0 / PI) * factor * (length_squared / divisor).squared()
    }
}

impl<T: Lane> Ndf<T> for Ggx<T> {
    #[inline(always)]
    fn density(&self, h: Vec3<T>) -> T {
        let density = self.density_along(h, T::new(1.0));
        T::select(h.z.gt(T::new(0.0)), density, T::new(0.0))
    }

    #[inline(always)]
    fn density_between(&self, pair: &HalfVector<T>) -> T {
        self.density_along(pair.sum, pair.length_squared)
    }

    /// 1 + Lambda = (w.z + length) / (2 w.z), see [`Ndf::cos_times_lambda`]. In 1 + Lambda(wo) + Lambda(wi)
    /// the cosines cancel, which leaves the sum of two lengths.
    #[inline(always)]
    fn smith(&self, pair: &HalfVector<T>) -> T {
        let ratio = pair.wo.z / pair.wi.z;
        T::new(0.5) / (self.length(pair.wo) + ratio * self.length(pair.wi))
    }

    /// Lambda = (sqrt(1 + alpha^2 tan^2) - 1) / 2: Heitz 2014, eq. 72 and 80. w.z Lambda is half the
    /// difference of two lengths, here written without cancellation.
    #[inline(always)]
    fn cos_times_lambda(&self, w: Vec3<T>) -> T {
        let stretched = stretched(w, self.alpha);
        let across = stretched.x.squared() + stretched.y.squared();
        let length = (across + w.z.squared()).sqrt();
        T::new(0.5) * across / (length + w.z)
    }

    /// Visible normals: Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps",
    /// listing 3. Height and radius on the cap are written without cancellation.
    #[inline(always)]
    fn sample(&self, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let one = T::new(1.0);
        let view = stretched(wo, self.alpha).normalized();
        let top = one + view.z;
        // The z of the point on the cap is height - view.z; the squared sine (1 - z)(1 + z) follows.
        let height = (one - u[1]) * top;
        let below = (view.x.squared() + view.y.squared()) / top;
        let sine = (u[1] * top * (height + below)).sqrt_positive();
        let x = sine * u[0].cos_turns() + view.x;
        let y = sine * u[0].sin_turns() + view.y;
        Vec3::new(x * self.alpha[0], y * self.alpha[1], height).normalized()
    }

    /// The density of visible normals, G1 D <wo, h> / wo.z, over 4 <wo, h>.
    #[inline(always)]
    fn reflected_density(&self, pair: &HalfVector<T>, d: T) -> T {
        d * T::new(0.5) / (pair.wo.z + self.length(pair.wo))
    }
}
