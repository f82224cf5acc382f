//! The choice of the distribution of normals.

use super::energy::{Energy, Reflected};
use super::masking::Masking;
use super::roughness::Roughness;
use super::tabulated::Tabulated;
use crate::num::Vec3;

/// A distribution, with its tables if it has any.
pub(super) enum Distribution<T> {
    /// Its parameters are those of the [`Roughness`].
    Ggx,
    /// Its parameters are those of the [`Roughness`].
    Beckmann,
    /// A distribution with tables for one alpha.
    Tabulated(Box<Tabulated<T>>),
}

/// A [`Distribution`] whose tables are borrowed. A surface has a copy of it, because the compiler would
/// read a reference again for each element after lanes have written to memory.
#[derive(Clone, Copy)]
pub(super) enum DistributionRef<'a, T> {
    Ggx,
    Beckmann,
    Tabulated(&'a Tabulated<T>),
}

impl<T> Distribution<T> {
    #[inline(always)]
    pub fn borrowed(&self) -> DistributionRef<'_, T> {
        match self {
            Self::Ggx => DistributionRef::Ggx,
            Self::Beckmann => DistributionRef::Beckmann,
            Self::Tabulated(tabulated) => DistributionRef::Tabulated(tabulated),
        }
    }
}

/// Evaluates an expression for the [`Ndf`](super::ndf::Ndf) of a [`DistributionRef`] and a [`Roughness`].
/// It is a macro because an enumeration with lanes in it would be stored to memory.
macro_rules! with_ndf {
    ($distribution:expr, $roughness:expr, |$ndf:ident| $body:expr) => {
        match $distribution {
            $crate::bsdf::models::microfacet::distribution::DistributionRef::Ggx => {
                let $ndf = $crate::bsdf::models::microfacet::ggx::Ggx {
                    alpha: $roughness.axes,
                    is_round: $roughness.is_round,
                };
                $body
            }
            $crate::bsdf::models::microfacet::distribution::DistributionRef::Beckmann => {
                let $ndf = $crate::bsdf::models::microfacet::beckmann::Beckmann {
                    alpha: $roughness.axes,
                };
                $body
            }
            $crate::bsdf::models::microfacet::distribution::DistributionRef::Tabulated($ndf) => {
                $body
            }
        }
    };
}
pub(super) use with_ndf;

impl Distribution<f64> {
    /// The table of the albedo with F = 1, for one alpha or, if there is none, for all of them. Surfaces
    /// must be isotropic.
    pub fn energy(&self, masking: Masking, alpha: Option<f64>) -> Energy<f64> {
        let lobe = |alpha: f64, wo: Vec3<f64>, [azimuth, other]: [f64; 2]| {
            let roughness = Roughness::isotropic(alpha);
            // For all distributions but GGX the second number is the azimuth, or does not lead to the
            // horizon.
            let u = match self {
                Self::Ggx => [azimuth, other],
                _ => [other, azimuth],
            };
            with_ndf!(self.borrowed(), roughness, |ndf| Reflected::by_ndf(
                &ndf, masking, [alpha; 2], wo, u
            ))
        };
        match alpha {
            None => Energy::over_alpha(lobe),
            Some(alpha) => Energy::of_alpha(alpha, |wo, u| lobe(alpha, wo, u)),
        }
    }
}
