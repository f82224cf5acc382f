//! The roughness of a surface: its distribution of normals as the parameters describe it.

use super::abc::Abc;
use super::blinn_phong::BlinnPhong;
use super::energy::{Energy, Reflected};
use super::masking::Masking;
use super::sgd::Sgd;
use super::{ALPHA, ANISOTROPY, ROTATION};
use crate::bsdf::precision::Precision;
use crate::num::{Lane, Real, Vec3};

/// A distribution, with the tables that it needs.
pub(super) enum Normalized<T> {
    /// Its numbers are those of the [`Shape`].
    Ggx,
    /// As for [`Normalized::Ggx`].
    Beckmann,
    /// For one alpha.
    BlinnPhong(Box<BlinnPhong<T>>),
    /// For one alpha and exponent.
    Abc(Box<Abc<T>>),
    /// For one alpha and p.
    Sgd(Box<Sgd<T>>),
}

impl<T: Lane<Scalar = T>> Normalized<T> {
    /// Which one it is.
    #[inline(always)]
    pub fn family(&self) -> Family<'_, T> {
        match self {
            Self::Ggx => Family::Ggx,
            Self::Beckmann => Family::Beckmann,
            Self::BlinnPhong(normals) => Family::BlinnPhong(normals),
            Self::Abc(normals) => Family::Abc(normals),
            Self::Sgd(normals) => Family::Sgd(normals),
        }
    }
}

/// [`Normalized`], borrowed.
#[derive(Clone, Copy)]
pub(super) enum Family<'a, T> {
    Ggx,
    Beckmann,
    BlinnPhong(&'a BlinnPhong<T>),
    Abc(&'a Abc<T>),
    Sgd(&'a Sgd<T>),
}

/// An expression in the normals of a [`Family`] and a [`Shape`]: the choice is made once per call.
macro_rules! with_normals {
    ($family:expr, $shape:expr, |$normals:ident| $body:expr) => {
        match $family {
            $crate::bsdf::models::microfacet::roughness::Family::Ggx => {
                let $normals = $crate::bsdf::models::microfacet::ggx::Ggx {
                    alpha: $shape.axes,
                    is_round: $shape.is_round,
                };
                $body
            }
            $crate::bsdf::models::microfacet::roughness::Family::Beckmann => {
                let $normals =
                    $crate::bsdf::models::microfacet::beckmann::Beckmann { alpha: $shape.axes };
                $body
            }
            $crate::bsdf::models::microfacet::roughness::Family::BlinnPhong($normals) => $body,
            $crate::bsdf::models::microfacet::roughness::Family::Abc($normals) => $body,
            $crate::bsdf::models::microfacet::roughness::Family::Sgd($normals) => $body,
        }
    };
}
pub(super) use with_normals;

impl<T: Precision> Normalized<T> {
    /// The albedo with F = 1, for one alpha or, if it varies, all of them. Not for stretched surfaces.
    pub fn energy(&self, shape: &Shape<T>, masking: Masking, is_varying: bool) -> Energy<T> {
        let lobe = |alpha: T, wo: Vec3<T>, [azimuth, other]: [T; 2]| {
            let shape = Shape {
                alpha,
                axes: [alpha; 2],
                ..*shape
            };
            // Of all but GGX the second number is the azimuth, or does not lead to the horizon.
            let u = match self {
                Self::Ggx => [azimuth, other],
                _ => [other, azimuth],
            };
            with_normals!(self.family(), shape, |normals| Reflected::by_normals(
                &normals, masking, [alpha; 2], wo, u
            ))
        };
        if is_varying {
            Energy::over_alpha(lobe)
        } else {
            Energy::of_alpha(shape.alpha, |wo, u| lobe(shape.alpha, wo, u))
        }
    }
}

/// Roughness along two axes, and where they lie.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape<T> {
    /// Geometric mean of the two.
    pub alpha: T,
    anisotropy: T,
    /// Along the long axis and across it.
    pub axes: [T; 2],
    /// Cosine and sine of the angle from +X to the long axis.
    pub turn: [T; 2],
    /// Whether both axes are the same for all calls; then it does not matter where they lie.
    pub is_round: bool,
}

impl<T: Lane<Scalar = T>> Shape<T> {
    /// The same everywhere.
    #[inline(always)]
    pub fn splat<L: Lane<Scalar = T>>(&self) -> Shape<L> {
        Shape {
            alpha: L::splat(self.alpha),
            anisotropy: L::splat(self.anisotropy),
            axes: [L::splat(self.axes[0]), L::splat(self.axes[1])],
            turn: [L::splat(self.turn[0]), L::splat(self.turn[1])],
            is_round: self.is_round,
        }
    }
}

impl<T: Real> Shape<T> {
    pub fn new(alpha: T, anisotropy: T, rotation: T, is_round: bool) -> Self {
        Self {
            alpha,
            anisotropy,
            axes: axes(alpha, anisotropy),
            turn: turn(rotation),
            is_round,
        }
    }

    /// The same where it is known to be round.
    #[inline(always)]
    pub fn round(self) -> Self {
        Self {
            axes: [self.alpha; 2],
            is_round: true,
            ..self
        }
    }

    /// Replaces the value of a parameter that varies per call; those of other kinds have no effect.
    #[inline(always)]
    pub fn vary(&mut self, param: usize, value: T) {
        match param {
            ALPHA => self.alpha = value,
            ANISOTROPY => self.anisotropy = value,
            ROTATION => self.turn = turn(value),
            _ => return,
        }
        self.axes = if self.is_round {
            [self.alpha; 2]
        } else {
            axes(self.alpha, self.anisotropy)
        };
    }
}

/// alpha over and times sqrt(1 - 0.9 anisotropy): Burley 2012, "Physically-Based Shading at Disney",
/// addendum.
#[inline(always)]
fn axes<T: Real>(alpha: T, anisotropy: T) -> [T; 2] {
    let aspect = (T::new(1.0) - T::new(0.9) * anisotropy).sqrt();
    [alpha / aspect, alpha * aspect]
}

#[inline(always)]
fn turn<T: Real>(rotation: T) -> [T; 2] {
    [rotation.cos_turns(), rotation.sin_turns()]
}
