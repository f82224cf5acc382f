//! Distributions that are the same all around and have no closed form of masking: their normals by
//! tables, made at creation for one alpha.

use super::distribution::Normals;
use super::projected::Projected;
use super::quantile::Quantile;
use crate::num::{Lane, PI, Vec3};

/// The function D(h) of such a distribution, with its parameters set.
pub(crate) trait Profile<T> {
    /// D(h), per steradian; 0 for h.z <= 0.
    fn density<L: Lane<Scalar = T>>(&self, h: Vec3<L>) -> L;
}

/// Such a distribution whose sampling has no closed form either.
pub(crate) struct Tabulated<T, P> {
    profile: P,
    projected: Projected<T>,
    quantile: Quantile<T>,
}

impl<T: Lane<Scalar = T>, P: Profile<T>> Tabulated<T, P> {
    /// `exact` is `profile` in double precision.
    pub(super) fn new(alpha: f64, profile: P, exact: &impl Profile<f64>) -> Self {
        Self {
            profile,
            projected: Projected::new(alpha, |h| exact.density(h)),
            quantile: Quantile::new(alpha, |h| exact.density(h)),
        }
    }
}

impl<T: Lane<Scalar = T>, L: Lane<Scalar = T>, P: Profile<T>> Normals<L> for &Tabulated<T, P> {
    #[inline(always)]
    fn density(&self, h: Vec3<L>) -> L {
        self.profile.density(h)
    }

    #[inline(always)]
    fn averted_area(&self, w: Vec3<L>) -> L {
        self.projected.averted_area(w)
    }

    #[inline(always)]
    fn sample(&self, _wo: Vec3<L>, u: [L; 2]) -> Vec3<L> {
        self.quantile.sample(u)
    }

    /// D(h) h.z
    #[inline(always)]
    fn sample_density(&self, _wo: Vec3<L>, h: Vec3<L>) -> L {
        self.profile.density(h) * h.z
    }
}

/// D at the normal, 1 / (pi alpha^2): what alpha means for all of them.
pub(super) fn height(alpha: f64) -> f64 {
    1.0 / (PI * alpha * alpha)
}
