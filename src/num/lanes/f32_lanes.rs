//! As many numbers in single precision side by side as a register of the processor holds.
//!
//! Every operation does to each number what `f32` does to one, to the last bit, on every level: nothing
//! is fused, and no approximate inverse is used.

#![allow(unsafe_code)]

use super::super::elementary::{self, EXPONENT_SHIFT, SQRT_HALF_BITS, Single, elementary_methods};
use super::super::rgb::{TableBlock, Triple, triple_methods, whole};
use super::super::{Lane, Mask, Real, TableEntry};
use super::look_up;
use super::quad_ops::QuadOps;
use fearless_simd::prelude::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A set of instructions.
pub(super) trait Instructions: QuadOps {
    /// The proof that the processor has them. Numbers are made in code that [`super::Level::run`] started,
    /// which has it.
    const TOKEN: Self;
    /// Whether they round to whole numbers.
    const ROUND: bool;
}

macro_rules! instructions {
    ($($token:ident: $round:expr),*) => {
        $(
            impl Instructions for fearless_simd::$token {
                const ROUND: bool = $round;
                // SAFETY: `F32Lanes` of these instructions exist only where `Level::run` has found them.
                const TOKEN: Self = unsafe { Self::assume_supported() };
            }
        )*
    };
}

#[cfg(target_arch = "x86_64")]
instructions!(Sse2: false, Avx2: true, Avx512: true);
#[cfg(target_arch = "aarch64")]
instructions!(Neon: true);

/// Numbers.
#[derive(Clone, Copy, Debug)]
pub struct F32Lanes<S: Instructions>(pub(super) S::f32s);

/// A truth value per number.
#[derive(Clone, Copy)]
pub struct F32Mask<S: Instructions>(S::mask32s);

macro_rules! operator {
    ($type:ident, $trait:ident, $method:ident) => {
        impl<S: Instructions> $trait for $type<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0))
            }
        }
    };
}

operator!(F32Lanes, Add, add);
operator!(F32Lanes, Sub, sub);
operator!(F32Lanes, Mul, mul);
operator!(F32Lanes, Div, div);
operator!(F32Mask, BitAnd, bitand);
operator!(F32Mask, BitOr, bitor);

impl<S: Instructions> Neg for F32Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Instructions> Not for F32Mask<S> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

impl<S: Instructions> Mask for F32Mask<S> {
    #[inline(always)]
    fn any(self) -> bool {
        self.0.any_true()
    }
}

impl<S: Instructions> Real for F32Lanes<S> {
    type Mask = F32Mask<S>;
    const EPSILON: f64 = f32::EPSILON as f64;

    #[inline(always)]
    fn new(value: f64) -> Self {
        Self::splat(value as f32)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // x86 gives the second number if either is NaN, as asked for; others need the comparison.
        if cfg!(target_arch = "x86_64") {
            Self(self.0.min(other.0))
        } else {
            Self::select(self.lt(other), self, other)
        }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if cfg!(target_arch = "x86_64") {
            Self(self.0.max(other.0))
        } else {
            Self::select(self.gt(other), self, other)
        }
    }
    #[inline(always)]
    fn round(self) -> Self {
        if S::ROUND {
            return Self(self.0.round_ties_even());
        }
        // As for f32: 2^23 of the same sign, where all floats are whole.
        let whole = Self::new(8_388_608.0);
        let shift = Self(whole.0.copysign(self.0));
        Self::select(self.abs().lt(whole), (self + shift) - shift, self)
    }
    #[inline(always)]
    fn is_finite(self) -> F32Mask<S> {
        self.abs().lt(Self::new(f64::INFINITY))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> F32Mask<S> {
        F32Mask(self.0.simd_lt(other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> F32Mask<S> {
        F32Mask(self.0.simd_le(other.0))
    }
    #[inline(always)]
    fn equals(self, other: Self) -> F32Mask<S> {
        F32Mask(self.0.simd_eq(other.0))
    }
    #[inline(always)]
    fn select(mask: F32Mask<S>, yes: Self, no: Self) -> Self {
        Self(mask.0.select(yes.0, no.0))
    }
    elementary_methods!(exp, exp_m1, ln, ln_1p, cos_turns, sin_turns);
}

impl<S: Instructions> Single for F32Lanes<S> {
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let bits: S::i32s = self.0.bitcast();
        let above = bits - SQRT_HALF_BITS;
        let mantissa = (above & 0x007f_ffff) + SQRT_HALF_BITS;
        (Self(mantissa.bitcast()), Self((above >> 23).to_float()))
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        let shifted = self + Self::new(EXPONENT_SHIFT);
        let bits: S::u32s = shifted.0.bitcast();
        Self((bits << 23).bitcast())
    }
}

impl<S: Instructions> Lane for F32Lanes<S> {
    type Rgb = Triple<Self>;
    type Scalar = f32;
    const COUNT: usize = S::f32s::LEN;

    #[inline(always)]
    fn splat(number: f32) -> Self {
        Self(S::f32s::simd_from(S::TOKEN, number))
    }
    #[inline(always)]
    fn apart<R>(work: impl FnOnce() -> R) -> R {
        S::TOKEN.vectorize(work)
    }
    #[inline(always)]
    fn load(numbers: &[f32]) -> Self {
        Self(S::f32s::from_slice(S::TOKEN, numbers))
    }
    #[inline(always)]
    fn store(self, numbers: &mut [f32]) {
        self.0.store_slice(numbers);
    }
    triple_methods!();

    #[inline(always)]
    fn load_entry<const N: usize>(table: &[[f32; N]], index: Self) -> [Self; N] {
        let last = Self::new((table.len() - 1) as f64);
        let index = index.max(Self::new(0.0)).min(last);
        let mut found = [index; N];
        if let Some(table) = fours(table) {
            for (number, of_entry) in found.iter_mut().zip(look_up::entries(table, index)) {
                *number = of_entry;
            }
            return found;
        }
        let mut numbers = [[0.0; MOST]; N];
        for (place, index) in index.0.as_slice().iter().enumerate() {
            for (numbers, number) in numbers.iter_mut().zip(table[whole(*index)]) {
                numbers[place] = number;
            }
        }
        for (number, numbers) in found.iter_mut().zip(&numbers) {
            *number = Self::load(&numbers[..Self::COUNT]);
        }
        found
    }
    #[inline(always)]
    fn weighted_row(table: &[TableEntry<f32>], first: Self, weights: [Self; 3]) -> Triple<Self> {
        look_up::weighted_row(table, first, weights)
    }
    #[inline(always)]
    fn weighted_block(
        table: &[TableEntry<f32>],
        stride: usize,
        block: TableBlock<Self>,
    ) -> Triple<Self> {
        look_up::weighted_block(table, stride, block)
    }
}

/// The same table, if its entries are four numbers.
#[inline(always)]
fn fours<const N: usize>(table: &[[f32; N]]) -> Option<&[[f32; 4]]> {
    let (entries, rest) = table.as_flattened().as_chunks();
    (N == 4 && rest.is_empty()).then_some(entries)
}

/// The most numbers side by side.
pub(super) const MOST: usize = 16;
