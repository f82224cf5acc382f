//! The two precisions of a BSDF.

use super::kernel::Kernel;
use super::values::Values;
use crate::error::Error;
use crate::film::Film;
use crate::num::{F32x4, Lane, Level, Rgb, Work};

/// The compiler of a model in one precision.
pub type Prepare<T> = fn(&Values<T>) -> Result<Box<dyn Kernel<T>>, Error>;

/// The precision of a BSDF: `f32` with `glam::Vec3` for renderers, or `f64` with `glam::DVec3`, which tests
/// compare it with.
pub trait Precision: Lane<Mask = bool, Scalar = Self> + PartialOrd + Default + Into<f64> {
    /// The vector type of calls.
    type Vector: Into<[Self; 3]> + From<[Self; 3]> + Copy;

    /// The lanes of spectral calls, a wavelength in each.
    type Wavelengths: Lane<Scalar = Self>;

    /// The number rounded to single precision, in which films are evaluated.
    fn to_f32(self) -> f32;

    /// Does the work of a batch at a level. Double precision has no batches and does nothing.
    #[doc(hidden)]
    fn dispatch<W: Work<Self, Output = ()>>(level: Level, work: W);

    /// [`Film::reflectance`] in each lane.
    #[doc(hidden)]
    fn reflectance<L: Lane<Scalar = Self>>(film: &Film, cos_theta: L, thickness_nm: L) -> Rgb<L>;

    /// [`Film::reflectance_spread`] in each lane, for deviations that creation has accepted.
    #[doc(hidden)]
    fn reflectance_spread<L: Lane<Scalar = Self>>(
        film: &Film,
        cos_theta: L,
        thickness_nm: L,
        spread_nm: L,
    ) -> Rgb<L>;

    /// Calls the compiler of this precision.
    #[doc(hidden)]
    fn prepare(
        single: impl FnOnce() -> Prepare<f32>,
        double: impl FnOnce() -> Prepare<f64>,
        values: &Values<Self>,
    ) -> Result<Box<dyn Kernel<Self>>, Error>;
}

impl Precision for f32 {
    type Vector = glam::Vec3;
    type Wavelengths = F32x4;

    #[inline(always)]
    fn to_f32(self) -> f32 {
        self
    }

    #[inline(always)]
    fn dispatch<W: Work<f32, Output = ()>>(level: Level, work: W) {
        level.run(work);
    }

    #[inline(always)]
    fn reflectance<L: Lane<Scalar = f32>>(film: &Film, cos_theta: L, thickness_nm: L) -> Rgb<L> {
        L::outlined(
            #[inline(always)]
            || film.reflectance_lanes(cos_theta, thickness_nm),
        )
    }

    #[inline(always)]
    fn reflectance_spread<L: Lane<Scalar = f32>>(
        film: &Film,
        cos_theta: L,
        thickness_nm: L,
        spread_nm: L,
    ) -> Rgb<L> {
        L::outlined(
            #[inline(always)]
            || film.spread_lanes(cos_theta, thickness_nm, spread_nm),
        )
    }

    fn prepare(
        single: impl FnOnce() -> Prepare<f32>,
        _double: impl FnOnce() -> Prepare<f64>,
        values: &Values<f32>,
    ) -> Result<Box<dyn Kernel<f32>>, Error> {
        single()(values)
    }
}

impl Precision for f64 {
    type Vector = glam::DVec3;
    type Wavelengths = Self;

    #[inline(always)]
    fn to_f32(self) -> f32 {
        self as f32
    }

    #[inline(always)]
    fn dispatch<W: Work<f64, Output = ()>>(_level: Level, _work: W) {}

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

    #[inline(always)]
    fn reflectance_spread<L: Lane<Scalar = f64>>(
        film: &Film,
        cos_theta: L,
        thickness_nm: L,
        spread_nm: L,
    ) -> Rgb<L> {
        let [c, d, spread_nm] = [cos_theta, thickness_nm, spread_nm].map(|number| {
            let mut numbers = [0.0; 1];
            number.store(&mut numbers);
            numbers[0] as f32
        });
        film.spread_or_plain(c, d, spread_nm)
            .map(|channel| L::new(f64::from(channel)))
    }

    fn prepare(
        _single: impl FnOnce() -> Prepare<f32>,
        double: impl FnOnce() -> Prepare<f64>,
        values: &Values<f64>,
    ) -> Result<Box<dyn Kernel<f64>>, Error> {
        double()(values)
    }
}
