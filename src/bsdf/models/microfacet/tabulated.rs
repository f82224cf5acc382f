//! Isotropic distributions without a closed form of Smith's masking, with tables made at creation for one
//! alpha.

use super::abc::Abc;
use super::blinn_phong::BlinnPhong;
use super::half_vector::HalfVector;
use super::ndf::{GREATEST, Ndf};
use super::projected::Projected;
use super::quantile::Quantile;
use super::sgd::ShiftedGamma;
use crate::num::{Lane, Vec3};

/// The density D(h) of one of these distributions.
#[derive(Clone, Copy)]
pub(crate) enum Profile<T> {
    BlinnPhong(BlinnPhong<T>),
    Abc(Abc<T>),
    ShiftedGamma(ShiftedGamma<T>),
}

/// A distribution with its tables.
pub(crate) struct Tabulated<T> {
    profile: Profile<T>,
    projected: Projected<T>,
    /// `None` for Blinn's distribution, which is sampled in closed form.
    quantile: Option<Quantile<T>>,
}

impl<T: Lane<Scalar = T>> Tabulated<T> {
    /// Blinn's distribution.
    pub(crate) fn blinn_phong(alpha: f64) -> Self {
        let exact = BlinnPhong::<f64>::new(alpha);
        Self {
            profile: Profile::BlinnPhong(BlinnPhong::new(alpha)),
            projected: Projected::new(alpha, |h| exact.density(h)),
            quantile: None,
        }
    }

    /// The ABC distribution with the exponent C.
    pub(crate) fn abc(alpha: f64, exponent: f64) -> Self {
        let exact = Abc::<f64>::new(alpha, exponent);
        Self {
            profile: Profile::Abc(Abc::new(alpha, exponent)),
            projected: Projected::new(alpha, |h| exact.density(h)),
            quantile: Some(Quantile::new(alpha, |h| exact.density(h))),
        }
    }

    /// The shifted gamma distribution with the power p.
    pub(crate) fn shifted_gamma(alpha: f64, p: f64) -> Self {
        let exact = ShiftedGamma::<f64>::new(alpha, p);
        Self {
            profile: Profile::ShiftedGamma(ShiftedGamma::new(alpha, p)),
            projected: Projected::new(alpha, |h| exact.density(h)),
            quantile: Some(Quantile::new(alpha, |h| exact.density(h))),
        }
    }
}

impl<T: Lane<Scalar = T>> Profile<T> {
    /// D(h), per steradian; 0 for h.z <= 0.
    #[inline(always)]
    fn density<L: Lane<Scalar = T>>(&self, h: Vec3<L>) -> L {
        match self {
            Self::BlinnPhong(profile) => profile.density(h),
            Self::Abc(profile) => profile.density(h),
            Self::ShiftedGamma(profile) => profile.density(h),
        }
    }
}

impl<T: Lane<Scalar = T>, L: Lane<Scalar = T>> Ndf<L> for &Tabulated<T> {
    #[inline(always)]
    fn density(&self, h: Vec3<L>) -> L {
        self.profile.density(h)
    }

    #[inline(always)]
    fn cos_times_lambda(&self, w: Vec3<L>) -> L {
        self.projected.cos_times_lambda(w)
    }

    #[inline(always)]
    fn sample(&self, _wo: Vec3<L>, u: [L; 2]) -> Vec3<L> {
        match (&self.profile, &self.quantile) {
            (Profile::BlinnPhong(profile), _) => profile.sample(u),
            (_, Some(quantile)) => quantile.sample(u),
            // No other pair exists.
            _ => Vec3::zero(),
        }
    }

    /// The density of sampled normals, D(h) h.z, over 4 <wo, h>, whose inverse is clamped to [`GREATEST`].
    #[inline(always)]
    fn reflected_density(&self, pair: &HalfVector<L>, d: L) -> L {
        let jacobian = (L::new(0.25) / pair.cos_half).min(L::new(GREATEST));
        d * pair.h().z * jacobian
    }
}
