//! The precisions that compiled models exist in.

use super::mixture::{Mixture, Surfaces};
use super::tile::Tiles;
use crate::film::Film;
use crate::num::{Lane, Rgb};

/// One number at a time, so that code may branch: `f32` for renderers, `f64` as the oracle.
pub trait Precision: Lane<Mask = bool, Scalar = Self> + PartialOrd + Default + Into<f64> {
    /// Rounded to single precision, in which films are evaluated.
    fn to_f32(self) -> f32;

    /// [`Film::reflectance`], as many at once as there are.
    fn reflectance<L: Lane<Scalar = Self>>(film: &Film, cos_theta: L, thickness_nm: L) -> Rgb<L>;

    /// The model as one that takes tiles, if they exist in this precision.
    fn tiles<M: Surfaces<Self>>(model: &Mixture<M>) -> Option<&dyn Tiles>;
}

impl Precision for f32 {
    #[inline(always)]
    fn to_f32(self) -> f32 {
        self
    }

    #[inline(always)]
    fn reflectance<L: Lane<Scalar = f32>>(film: &Film, cos_theta: L, thickness_nm: L) -> Rgb<L> {
        L::apart(
            #[inline(always)]
            || film.reflectance_lanes(cos_theta, thickness_nm),
        )
    }

    fn tiles<M: Surfaces<f32>>(model: &Mixture<M>) -> Option<&dyn Tiles> {
        Some(model)
    }
}

impl Precision for f64 {
    #[inline(always)]
    fn to_f32(self) -> f32 {
        self as f32
    }

    #[inline(always)]
    fn reflectance<L: Lane<Scalar = f64>>(film: &Film, cos_theta: L, thickness_nm: L) -> Rgb<L> {
        let single = |number: L| {
            let mut numbers = [0.0; 1];
            number.store(&mut numbers);
            numbers[0] as f32
        };
        film.reflectance(single(cos_theta), single(thickness_nm))
            .map(|channel| L::new(f64::from(channel)))
    }

    fn tiles<M: Surfaces<f64>>(_model: &Mixture<M>) -> Option<&dyn Tiles> {
        None
    }
}
