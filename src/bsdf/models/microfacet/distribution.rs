//! The distribution of normals that a description chooses.

use super::energy::{Energy, Reflected};
use super::masking::Masking;
use super::roughness::Roughness;
use super::tabulated::Tabulated;
use crate::bsdf::precision::Precision;
use crate::num::Vec3;

/// A distribution, with the tables that it needs.
pub(super) enum Distribution<T> {
    /// Its parameters are those of the [`Roughness`].
    Ggx,
    /// Its parameters are those of the [`Roughness`].
    Beckmann,
    /// For one alpha.
    Tabulated(Box<Tabulated<T>>),
}

/// A [`Distribution`], borrowed: a copy in a surface, since lanes write memory that a reference might point
/// to, and the compiler would read it again for each element.
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

/// Evaluates an expression in the [`Ndf`](super::ndf::Ndf) of a [`DistributionRef`] and a [`Roughness`]. The
/// choice is made where it is used, since an enumeration that holds lanes would be taken apart in memory.
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

impl<T: Precision> Distribution<T> {
    /// The albedo with F = 1, for one alpha or, if it varies, all of them. Not for stretched surfaces.
    pub fn energy(
        &self,
        roughness: &Roughness<T>,
        masking: Masking,
        is_varying: bool,
    ) -> Energy<T> {
        let lobe = |alpha: T, wo: Vec3<T>, [azimuth, other]: [T; 2]| {
            let roughness = roughness.with_alpha(alpha);
            // Of all but GGX the second number is the azimuth, or does not lead to the horizon.
            let u = match self {
                Self::Ggx => [azimuth, other],
                _ => [other, azimuth],
            };
            with_ndf!(self.borrowed(), roughness, |ndf| Reflected::by_ndf(
                &ndf, masking, [alpha; 2], wo, u
            ))
        };
        if is_varying {
            Energy::over_alpha(lobe)
        } else {
            Energy::of_alpha(roughness.alpha, |wo, u| lobe(roughness.alpha, wo, u))
        }
    }
}
