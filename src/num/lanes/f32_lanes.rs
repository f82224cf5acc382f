//! A register of single-precision numbers, one per lane, for any set of instructions.
//!
//! Every operation returns, in each lane, exactly the bits that `f32` returns: no operation is fused, and no
//! approximate inverse is used.

#![allow(unsafe_code)]

use super::super::elementary::elementary_methods;
use super::super::scalar::{EXPONENT_SHIFT, SQRT_HALF_BITS};
use super::super::{Mask, Real};
use super::instructions::Instructions;
use fearless_simd::prelude::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A register of numbers, one per lane.
#[derive(Clone, Copy, Debug)]
pub struct F32Lanes<S: Instructions>(pub(super) S::f32s);

/// A mask: one truth value per lane.
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
        Self(S::f32s::simd_from(S::TOKEN, value as f32))
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
        // x86 returns the second number if either is NaN, as required; other processors need the comparison.
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
        // As for f32: add and subtract 2^23 of the same sign.
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
    elementary_methods!();
}
