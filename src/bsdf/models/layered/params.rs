//! Indices of the parameters, choices and lobes of `layered`, in the order of its description.

use crate::bsdf::info::{Choice, chosen};

pub(super) const ETA: usize = 0;
pub(super) const AMBIENT_ETA: usize = 1;
pub(super) const EXPONENT_REFLECTION: usize = 2;
pub(super) const EXPONENT_TRANSMISSION: usize = 3;
pub(super) const THICKNESS_NM: usize = 4;
pub(super) const BASE_NORMAL: usize = 5;
pub(super) const BASE: usize = 6;
pub(super) const SPECULAR_WEIGHT: usize = 7;
pub(super) const DIFFUSE_WEIGHT: usize = 8;
pub(super) const VARIANT: usize = 9;
pub(super) const PHASE_SHIFT: usize = 10;

pub(super) const VARIANT_PAPER: usize = 1;
pub(super) const PAPER: Choice = chosen(VARIANT, VARIANT_PAPER);
pub(super) const PHASE_SHIFT_HALF_WAVE: usize = 1;

pub(super) const MIRROR_LOBE: usize = 0;
/// The refracted lobe of red; those of green and blue are the next two.
pub(super) const REFRACTED_LOBE: usize = 1;
pub(super) const DIFFUSE_LOBE: usize = 4;
