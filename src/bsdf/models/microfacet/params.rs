//! Indices of the parameters, choices and lobes of `microfacet`, in the order of its description.

pub(super) const DISTRIBUTION: usize = 0;
pub(super) const MASKING: usize = 1;
pub(super) const FRESNEL: usize = 2;
pub(super) const ALPHA: usize = 3;
pub(super) const ANISOTROPY: usize = 4;
pub(super) const ROTATION: usize = 5;
pub(super) const F0: usize = 6;
pub(super) const F90: usize = 7;
pub(super) const ETA: usize = 8;
pub(super) const K: usize = 9;
pub(super) const METAL: usize = 10;
pub(super) const THICKNESS_NM: usize = 11;
pub(super) const ABC_EXPONENT: usize = 12;
pub(super) const SGD_P: usize = 13;
pub(super) const ENERGY_COMPENSATION: usize = 14;
pub(super) const THICKNESS_SPREAD_NM: usize = 15;

/// The choices of `distribution`.
pub(super) const GGX: usize = 0;
pub(super) const BECKMANN: usize = 1;
pub(super) const BLINN_PHONG: usize = 2;
pub(super) const ABC: usize = 3;
pub(super) const SGD: usize = 4;

/// Choices of `masking`.
pub(super) const SCHLICK_MASKING: usize = 1;
pub(super) const IMPLICIT: usize = 4;

/// The choices of `fresnel`.
pub(super) const SCHLICK: usize = 0;
pub(super) const DIELECTRIC: usize = 1;
pub(super) const CONDUCTOR: usize = 2;
pub(super) const FILM: usize = 3;

/// A choice of `energy_compensation`.
pub(super) const OFF: usize = 0;

/// A choice of `metal`.
pub(super) const CUSTOM: usize = 0;

/// The lobes of a rough surface.
pub(super) const REFLECTION_LOBE: usize = 0;
pub(super) const MULTIPLE_LOBE: usize = 1;
