//! Indices of the parameters, choices and lobes of `metallic_roughness`, in the order of its description.

pub(super) const BASE_COLOR: usize = 0;
pub(super) const METALLIC: usize = 1;
pub(super) const ROUGHNESS: usize = 2;
pub(super) const DIELECTRIC_FROM: usize = 3;
pub(super) const ETA: usize = 4;
pub(super) const F0: usize = 5;
pub(super) const DIFFUSE_FORM: usize = 6;
pub(super) const SIGMA_RADIANS: usize = 7;
pub(super) const DIFFUSE_ROUGHNESS: usize = 8;

/// The choices of `dielectric_from`.
pub(super) const FROM_ETA: usize = 0;
pub(super) const FROM_F0: usize = 1;

/// Choices of `diffuse_form`.
pub(super) const OREN_NAYAR: usize = 1;
pub(super) const DISNEY: usize = 2;

pub(super) const DIFFUSE_LOBE: usize = 0;
pub(super) const SPECULAR_LOBE: usize = 1;
