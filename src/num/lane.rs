//! `Lane`: the number type of a surface, alone or several side by side.
//!
//! A formula that depends on the wavelength is written for one channel and evaluated with
//! [`Lane::Rgb`], which holds all three: three numbers side by side in general, one register of
//! four lanes for a single `f32`. So a single call costs one evaluation, not three.

use super::Real;
use super::rgb::{Triple, each};
use super::table::{INDEX_BIAS, TableBlock, TableEntry};
use super::table::{load_block, weighted};

/// A real number that colours are made of; or several side by side, one for each of as many surfaces.
pub trait Lane: Real {
    /// Three of them, with every operation applied to each.
    type Rgb: Real;
    /// One number.
    type Scalar: Lane<Scalar = Self::Scalar>;
    /// How many there are side by side.
    const COUNT: usize;
    /// The same everywhere.
    fn splat(number: Self::Scalar) -> Self;
    /// What `work` gives, of lanes in a function of its own: for what is long and called from many places.
    /// `work` must be `#[inline(always)]`.
    fn outlined<R>(work: impl FnOnce() -> R) -> R;
    /// The numbers of a slice, which must be [`Lane::COUNT`].
    fn load(numbers: &[Self::Scalar]) -> Self;
    /// Into a slice of [`Lane::COUNT`].
    fn store(self, numbers: &mut [Self::Scalar]);
    /// Writes [`Lane::COUNT`] numbers to memory that may not be initialised.
    ///
    /// # Safety
    /// They must be writable; any alignment.
    #[allow(unsafe_code)]
    unsafe fn write(self, target: *mut Self::Scalar);
    /// Red, green and blue.
    fn rgb(channels: [Self; 3]) -> Self::Rgb;
    /// The same in every channel.
    fn gray(self) -> Self::Rgb;
    /// Red, green and blue.
    fn channels(rgb: Self::Rgb) -> [Self; 3];
    /// The same colour everywhere.
    #[inline(always)]
    fn splat_rgb(rgb: <Self::Scalar as Lane>::Rgb) -> Self::Rgb {
        Self::rgb(each!(Self::Scalar::channels(rgb), |channel| Self::splat(
            channel
        )))
    }
    /// The entry of a table whose number is the nearest to the whole number `index`; the first for NaN.
    ///
    /// # Panics
    /// If the table is empty.
    fn load_entry<const N: usize>(table: &[[Self::Scalar; N]], index: Self) -> [Self; N];
    /// The weighted sum of three entries of a table, the first at `first`, a whole number in [0, 2^22]
    /// plus [`INDEX_BIAS`](super::table::INDEX_BIAS).
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

/// The methods of an [`Lane`] whose channels have no register to share.
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

/// The methods of an [`Lane`] that is one number.
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

/// A number whose channels have no register to share.
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
#[cfg(not(target_arch = "x86_64"))]
side_by_side!(f32);
