//! The precisions that compiled models exist in.

use crate::math::Element;

/// One number at a time, so that code may branch: `f32` for renderers, `f64` as the oracle.
pub trait Precision: Element<Mask = bool> + PartialOrd + Default {
    /// Rounded to single precision, in which films are evaluated.
    fn to_f32(self) -> f32;
}

impl Precision for f32 {
    #[inline(always)]
    fn to_f32(self) -> f32 {
        self
    }
}

impl Precision for f64 {
    #[inline(always)]
    fn to_f32(self) -> f32 {
        self as f32
    }
}
