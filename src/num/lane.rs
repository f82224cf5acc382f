//! `Lane`: the number type of a surface, one number or one in each lane of a register.
//!
//! A formula that depends on the wavelength is written for one channel and evaluated with [`Lane::Rgb`],
//! which has all three channels: three numbers in general, one register of four lanes for a single `f32` on
//! x86-64 and 64-bit ARM. There a single call costs one evaluation instead of three.

use super::Real;
use super::rgb::{Triple, each};
use super::table::{INDEX_BIAS, TableBlock, TableEntry};
use super::table::{load_block, weighted};

/// A real number, or a register of real numbers with one lane for each surface.
pub trait Lane: Real {
    /// Three colour channels; every operation applies to each of them.
    type Rgb: Real;
    /// The type of one lane.
    type Scalar: Lane<Scalar = Self::Scalar>;
    /// Number of lanes.
    const COUNT: usize;
    /// The same number in every lane.
    fn splat(number: Self::Scalar) -> Self;
    /// Runs `work` in a function that is not inlined, compiled for the instructions of these lanes. It
    /// keeps long code that has many callers from being copied. `work` must be `#[inline(always)]`.
    fn outlined<R>(work: impl FnOnce() -> R) -> R;
    /// Loads one number per lane from a slice of length [`Lane::COUNT`].
    fn load(numbers: &[Self::Scalar]) -> Self;
    /// Stores one number per lane to a slice of length [`Lane::COUNT`].
    fn store(self, numbers: &mut [Self::Scalar]);
    /// Writes [`Lane::COUNT`] numbers to memory that may not be initialised.
    ///
    /// # Safety
    /// They must be writable; any alignment.
    #[allow(unsafe_code)]
    unsafe fn write(self, target: *mut Self::Scalar);
    /// Red, green and blue.
    fn rgb(channels: [Self; 3]) -> Self::Rgb;
    /// The same number in every channel.
    fn gray(self) -> Self::Rgb;
    /// Red, green and blue.
    fn channels(rgb: Self::Rgb) -> [Self; 3];
    /// The same colour in every lane.
    #[inline(always)]
    fn splat_rgb(rgb: <Self::Scalar as Lane>::Rgb) -> Self::Rgb {
        Self::rgb(each!(Self::Scalar::channels(rgb), |channel| Self::splat(
            channel
        )))
    }
    /// The table entry at the whole number `index`, clamped to the table; the first entry for NaN.
    ///
    /// # Panics
    /// If the table is empty.
    fn load_entry<const N: usize>(table: &[[Self::Scalar; N]], index: Self) -> [Self; N];
    /// The weighted sum of three neighbouring entries of a table. `first` is the index of the first one, a
    /// whole number in [0, 2^22], plus `INDEX_BIAS`.
    ///
    /// # Panics
    /// If they are not all in the table.
    fn weighted_row(
        table: &[TableEntry<Self::Scalar>],
        first: Self,
        weights: [Self; 3],
    ) -> Self::Rgb;
    /// The weighted sum of a block of 3 x 3 entries of a table whose rows have `stride` entries.
    ///
    /// # Panics
    /// If they are not all in the table.
    fn weighted_block(
        table: &[TableEntry<Self::Scalar>],
        stride: usize,
        block: TableBlock<Self>,
    ) -> Self::Rgb;
}

/// The methods of a [`Lane`] whose colours are [`Triple`]s.
macro_rules! triple_methods {
    () => {
        #[inline(always)]
        fn rgb(channels: [Self; 3]) -> Triple<Self> {
            Triple(channels)
        }
        #[inline(always)]
        fn gray(self) -> Triple<Self> {
            Triple([self; 3])
        }
        #[inline(always)]
        fn channels(rgb: Triple<Self>) -> [Self; 3] {
            rgb.0
        }
    };
}
pub(super) use triple_methods;

/// The methods of a [`Lane`] that is one number.
macro_rules! scalar_methods {
    () => {
        type Scalar = Self;
        const COUNT: usize = 1;
        #[inline(always)]
        fn splat(number: Self) -> Self {
            number
        }
        #[inline(always)]
        fn outlined<R>(work: impl FnOnce() -> R) -> R {
            work()
        }
        #[inline(always)]
        fn load(numbers: &[Self]) -> Self {
            numbers[0]
        }
        #[inline(always)]
        fn store(self, numbers: &mut [Self]) {
            numbers[0] = self;
        }
        #[inline(always)]
        #[allow(unsafe_code)]
        unsafe fn write(self, target: *mut Self) {
            // SAFETY: the caller vouches for it.
            unsafe { target.write_unaligned(self) }
        }
        #[inline(always)]
        fn splat_rgb(rgb: Self::Rgb) -> Self::Rgb {
            rgb
        }
        #[inline(always)]
        fn load_entry<const N: usize>(table: &[[Self; N]], index: Self) -> [Self; N] {
            table[(index as usize).min(table.len() - 1)]
        }
    };
}
pub(super) use scalar_methods;

/// Implements [`Lane`] for a number whose colours are [`Triple`]s.
macro_rules! side_by_side {
    ($t:ty) => {
        impl Lane for $t {
            type Rgb = Triple<Self>;
            triple_methods!();
            scalar_methods!();
            #[inline(always)]
            fn weighted_row(
                table: &[TableEntry<Self>],
                first: Self,
                weights: [Self; 3],
            ) -> Triple<Self> {
                let [row, ..] = load_block(table, (f64::from(first) - INDEX_BIAS) as usize, 0);
                weighted(row, weights.map(Self::gray))
            }
            #[inline(always)]
            fn weighted_block(
                table: &[TableEntry<Self>],
                stride: usize,
                block: TableBlock<Self>,
            ) -> Triple<Self> {
                let [column, row] = block
                    .first
                    .map(|biased| (f64::from(biased) - INDEX_BIAS) as usize);
                let rows = load_block(table, row * stride + column, stride);
                let across = block.across.map(Self::gray);
                weighted(
                    rows.map(|row| weighted(row, across)),
                    block.along.map(Self::gray),
                )
            }
        }
    };
}

side_by_side!(f64);
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
side_by_side!(f32);
