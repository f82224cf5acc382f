//! Three colour channels as one number.
//!
//! A formula that depends on the wavelength is written for one channel and evaluated with
//! [`Element::Rgb`], which holds all three: three numbers side by side in general, one register of
//! four lanes for single precision. So a single call costs one evaluation, not three.

use super::{Mask, Real};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A real number that colours are made of.
pub trait Element: Real {
    /// Three of them, with every operation applied to each.
    type Rgb: Real;
    /// Red, green and blue.
    fn rgb(channels: [Self; 3]) -> Self::Rgb;
    /// The same in every channel.
    fn gray(self) -> Self::Rgb;
    /// Red, green and blue.
    fn channels(rgb: Self::Rgb) -> [Self; 3];
    /// Three entries from each of three rows of a table, the first at `from`, the rows `stride` entries
    /// apart.
    ///
    /// # Panics
    /// If they are not all in the table.
    fn load_block(table: &[Entry<Self>], from: usize, stride: usize) -> [[Self::Rgb; 3]; 3];
    /// The entry of a table whose number is the nearest to the whole number `index`; the first for NaN.
    ///
    /// # Panics
    /// If the table is empty.
    fn load_entry<const N: usize>(table: &[[Self; N]], index: Self) -> [Self; N];
}

/// Three channels and a filler, which must equal one of them: placed as registers take them.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(16))]
pub struct Entry<T>([T; 4]);

impl<T: Copy> Entry<T> {
    /// The filler is the last channel.
    #[inline(always)]
    pub fn new([r, g, b]: [T; 3]) -> Self {
        Self([r, g, b, b])
    }
}

/// Numbers whose channels have no register to share.
macro_rules! side_by_side {
    ($t:ty) => {
        impl Element for $t {
            type Rgb = Triple<$t>;
            #[inline(always)]
            fn rgb(channels: [$t; 3]) -> Triple<$t> {
                Triple(channels)
            }
            #[inline(always)]
            fn gray(self) -> Triple<$t> {
                Triple([self; 3])
            }
            #[inline(always)]
            fn channels(rgb: Triple<$t>) -> [$t; 3] {
                rgb.0
            }
            #[inline(always)]
            fn load_block(table: &[Entry<$t>], from: usize, stride: usize) -> [[Triple<$t>; 3]; 3] {
                std::array::from_fn(|row| {
                    std::array::from_fn(|entry| {
                        let [r, g, b, _] = table[from + row * stride + entry].0;
                        Triple([r, g, b])
                    })
                })
            }
            #[inline(always)]
            fn load_entry<const N: usize>(table: &[[$t; N]], index: $t) -> [$t; N] {
                table[(index as usize).min(table.len() - 1)]
            }
        }
    };
}

side_by_side!(f64);
#[cfg(not(target_arch = "x86_64"))]
side_by_side!(f32);

/// Three numbers, or three truth values, side by side.
#[derive(Clone, Copy, Debug)]
pub struct Triple<T>(pub [T; 3]);

impl<T: Copy> Triple<T> {
    #[inline(always)]
    fn map<U>(self, f: impl Fn(T) -> U) -> Triple<U> {
        Triple(self.0.map(f))
    }

    #[inline(always)]
    fn zip<U: Copy, V>(self, other: Triple<U>, f: impl Fn(T, U) -> V) -> Triple<V> {
        Triple(std::array::from_fn(|c| f(self.0[c], other.0[c])))
    }
}

macro_rules! channelwise_operator {
    ($trait:ident, $method:ident) => {
        impl<T: $trait<Output = T> + Copy> $trait for Triple<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a.$method(b))
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
        self.map(T::neg)
    }
}

impl<T: Not<Output = T> + Copy> Not for Triple<T> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        self.map(T::not)
    }
}

impl<M: Mask> Mask for Triple<M> {
    #[inline(always)]
    fn any(self) -> bool {
        self.0.into_iter().any(M::any)
    }
}

macro_rules! channelwise {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                self.map(T::$method)
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
        self.zip(other, T::min)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, T::max)
    }
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        self.map(T::is_finite)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        self.zip(other, T::lt)
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        self.zip(other, T::le)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> Self::Mask {
        self.zip(other, T::equals)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(std::array::from_fn(|c| {
            T::select(mask.0[c], yes.0[c], no.0[c])
        }))
    }
}
