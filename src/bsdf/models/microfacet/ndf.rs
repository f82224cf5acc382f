//! The trait of distributions of normals.

use super::half_vector::HalfVector;
use crate::num::{Lane, Vec3};

/// Factors that are unbounded at the horizon are clamped to this number, so that their product with D,
/// which is at most 1 / (pi 1e-8), is finite in single precision. It has an effect only within 1e-30 of the
/// horizon.
pub(super) const GREATEST: f64 = 1e30;

/// A distribution of microfacet normals with its parameters set. It may borrow tables made at creation.
///
/// `wo` and `w` have z > 0; `h` has unit length and z >= 0.
pub(crate) trait Ndf<T: Lane>: Copy {
    /// D(h), per steradian; 0 for h.z <= 0. The integral of D(h) h.z over the hemisphere is 1.
    fn density(&self, h: Vec3<T>) -> T;

    /// D of the half vector of two directions.
    #[inline(always)]
    fn density_between(&self, pair: &HalfVector<T>) -> T {
        self.density(pair.h())
    }

    /// w.z Lambda(w) with Smith's Lambda (Heitz 2014, eq. 42 and 43). It is the integral of D(h) max(0,
    /// -<w, h>): the area, projected along w and per area of the surface, of the facets that face away from
    /// w. It is finite at the horizon, where Lambda is not. G1 is w.z / (w.z + cos_times_lambda).
    fn cos_times_lambda(&self, w: Vec3<T>) -> T;

    /// Samples a normal of unit length for the viewer wo from two uniform numbers in [0, 1).
    fn sample(&self, wo: Vec3<T>, u: [T; 2]) -> Vec3<T>;

    /// G / (4 n.v) with Smith's masking, G = 1 / (1 + Lambda(wo) + Lambda(wi)): Heitz 2014, eq. 99.
    #[inline(always)]
    fn smith(&self, pair: &HalfVector<T>) -> T {
        let (nv, nl) = (pair.wo.z, pair.wi.z);
        let seen = nv + self.cos_times_lambda(pair.wo);
        T::new(0.25) / (seen + nv / nl * self.cos_times_lambda(pair.wi))
    }

    /// The density, per steradian of wi, of wi as the mirror image of wo about a sampled h: the density of
    /// h, per steradian of h, over 4 <wo, h> (Walter et al. 2007, eq. 14). `d` is [`Ndf::density_between`].
    fn reflected_density(&self, pair: &HalfVector<T>, d: T) -> T;
}

/// The direction, not normalised, in the space in which a distribution with roughness `alpha` along X and Y
/// has alpha = 1.
#[inline(always)]
pub(super) fn stretched<T: Lane>(w: Vec3<T>, alpha: [T; 2]) -> Vec3<T> {
    Vec3::new(w.x * alpha[0], w.y * alpha[1], w.z)
}
