//! Three colour channels as one number.
//!
//! A formula that depends on the wavelength is written for one channel and evaluated with
//! [`Lane::Rgb`], which holds all three: three numbers side by side in general, one register of
//! four lanes for single precision. So a single call costs one evaluation, not three.

use super::{Mask, Real};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// What a closure makes of each of three values. What handles lanes must be inlined into code that was
/// compiled for their instructions; closures given to `map` on arrays are not.
macro_rules! each {
    ($values:expr, |$value:pat_param| $body:expr) => {{
        let [a, b, c] = $values;
        [
            {
                let $value = a;
                $body
            },
            {
                let $value = b;
                $body
            },
            {
                let $value = c;
                $body
            },
        ]
    }};
}
pub(crate) use each;

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
    fn apart<R>(work: impl FnOnce() -> R) -> R;
    /// The numbers of a slice, which must be [`Lane::COUNT`].
    fn load(numbers: &[Self::Scalar]) -> Self;
    /// Into a slice of [`Lane::COUNT`].
    fn store(self, numbers: &mut [Self::Scalar]);
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
    /// The weighted sum of three entries of a table, the first at `first`, a whole number in [0, 2^22].
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

/// Which entries of a table, and their weights.
#[derive(Clone, Copy, Debug)]
pub struct TableBlock<T> {
    /// Column and row of the first, whole numbers in [0, 2^22].
    pub first: [T; 2],
    /// Weights of the columns.
    pub across: [T; 3],
    /// Weights of the rows.
    pub along: [T; 3],
}

/// A whole number in [0, 2^22]; for others any.
#[inline(always)]
pub(super) fn whole(number: f32) -> usize {
    // From 2^23 on floats are whole, and count in their lowest bits.
    const WHOLE: f32 = 8_388_608.0;
    ((number + WHOLE).to_bits() & 0x007f_ffff) as usize
}

/// Three channels and a filler, which must equal one of them: placed as registers take them.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(16))]
pub struct TableEntry<T>([T; 4]);

impl<T: Copy> TableEntry<T> {
    /// The filler is the last channel.
    #[inline(always)]
    pub fn new([r, g, b]: [T; 3]) -> Self {
        Self([r, g, b, b])
    }
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
        fn apart<R>(work: impl FnOnce() -> R) -> R {
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

/// The sum of three, each times its weight.
#[inline(always)]
pub(super) fn weighted<C: Real>([a, b, c]: [C; 3], [u, v, w]: [C; 3]) -> C {
    a * u + b * v + c * w
}

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
                let [row, ..] = load_block(table, first as usize, 0);
                weighted(row, weights.map(Self::gray))
            }
            #[inline(always)]
            fn weighted_block(
                table: &[TableEntry<Self>],
                stride: usize,
                block: TableBlock<Self>,
            ) -> Triple<Self> {
                let [column, row] = block.first.map(|number| number as usize);
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

/// Three entries from each of three rows of a table, the first at `from`, the rows `stride` entries
/// apart. For single precision on x86-64 there is another.
///
/// # Panics
/// If they are not all in the table.
#[inline(always)]
fn load_block<T: Copy>(
    table: &[TableEntry<T>],
    from: usize,
    stride: usize,
) -> [[Triple<T>; 3]; 3] {
    std::array::from_fn(|row| {
        std::array::from_fn(|entry| {
            let [r, g, b, _] = table[from + row * stride + entry].0;
            Triple([r, g, b])
        })
    })
}

side_by_side!(f64);
#[cfg(not(target_arch = "x86_64"))]
side_by_side!(f32);

/// Three numbers, or three truth values, side by side.
#[derive(Clone, Copy, Debug)]
pub struct Triple<T>(pub [T; 3]);

/// `$f` of each channel of one or of two triples. Not by a function of functions: those that handle lanes
/// must be named where they are called, or they are not inlined.
macro_rules! per_channel {
    ($f:expr, $a:expr) => {
        Triple([$f($a.0[0]), $f($a.0[1]), $f($a.0[2])])
    };
    ($f:expr, $a:expr, $b:expr) => {
        Triple([
            $f($a.0[0], $b.0[0]),
            $f($a.0[1], $b.0[1]),
            $f($a.0[2], $b.0[2]),
        ])
    };
}

macro_rules! channelwise_operator {
    ($trait:ident, $method:ident) => {
        impl<T: $trait<Output = T> + Copy> $trait for Triple<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                per_channel!(T::$method, self, other)
            }
        }
    };
}

channelwise_operator!(Add, add);
channelwise_operator!(Sub, sub);
channelwise_operator!(Mul, mul);
channelwise_operator!(Div, div);
channelwise_operator!(BitAnd, bitand);
channelwise_operator!(BitOr, bitor);

impl<T: Neg<Output = T> + Copy> Neg for Triple<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        per_channel!(T::neg, self)
    }
}

impl<T: Not<Output = T> + Copy> Not for Triple<T> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        per_channel!(T::not, self)
    }
}

impl<M: Mask> Mask for Triple<M> {
    #[inline(always)]
    fn any(self) -> bool {
        self.0[0].any() | self.0[1].any() | self.0[2].any()
    }
}

macro_rules! channelwise {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                per_channel!(T::$method, self)
            }
        )*
    };
}

impl<T: Real> Real for Triple<T> {
    type Mask = Triple<T::Mask>;
    const EPSILON: f64 = T::EPSILON;

    #[inline(always)]
    fn new(value: f64) -> Self {
        Self([T::new(value); 3])
    }
    channelwise!(
        sqrt, abs, round, exp, exp_m1, ln, ln_1p, cos_turns, sin_turns
    );
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        per_channel!(T::min, self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        per_channel!(T::max, self, other)
    }
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        per_channel!(T::is_finite, self)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        per_channel!(T::lt, self, other)
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        per_channel!(T::le, self, other)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> Self::Mask {
        per_channel!(T::equals, self, other)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let (Self(yes), Self(no)) = (yes, no);
        Self(each!([0, 1, 2], |c| T::select(mask.0[c], yes[c], no[c])))
    }
}
