//! [`Real`] for `f32` and `f64`.

use super::elementary::elementary_methods;
use super::{Mask, PI, Real};

impl Mask for bool {
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// The bits of sqrt(1/2) in single precision. Subtracting them from the bits of a number makes the exponent
/// field count from sqrt(1/2), so that mantissas are in [sqrt(1/2), sqrt(2)).
pub(super) const SQRT_HALF_BITS: i32 = 0x3f35_04f3;

/// 1.5 * 2^23 + 127. Adding it to a whole number puts the number and the exponent's bias into the low bits
/// of the mantissa, from where a shift moves them into the exponent field. This avoids a conversion to
/// integer and its checks for NaN and range.
pub(super) const EXPONENT_SHIFT: f64 = 12_582_912.0 + 127.0;

/// The methods that are the same for `f32` and `f64`.
macro_rules! scalar_operations {
    ($t:ty) => {
        type Mask = bool;
        const EPSILON: f64 = <$t>::EPSILON as f64;
        #[inline(always)]
        fn new(value: f64) -> Self {
            value as $t
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            <$t>::sqrt(self)
        }
        #[inline(always)]
        fn abs(self) -> Self {
            <$t>::abs(self)
        }
        #[inline(always)]
        fn min(self, other: Self) -> Self {
            if self < other { self } else { other }
        }
        #[inline(always)]
        fn max(self, other: Self) -> Self {
            if self > other { self } else { other }
        }
        #[inline(always)]
        fn is_finite(self) -> bool {
            <$t>::is_finite(self)
        }
        #[inline(always)]
        fn lt(self, other: Self) -> bool {
            self < other
        }
        #[inline(always)]
        fn le(self, other: Self) -> bool {
            self <= other
        }
        #[inline(always)]
        fn equals(self, other: Self) -> bool {
            self == other
        }
        #[inline(always)]
        fn select(mask: bool, yes: Self, no: Self) -> Self {
            if mask { yes } else { no }
        }
    };
}

impl Real for f32 {
    scalar_operations!(f32);

    #[inline(always)]
    fn round(self) -> Self {
        // Adding and subtracting 2^23 with the sign of the number rounds to the nearest whole number
        // without a call to the C library, which the SSE2 baseline would otherwise need. Every f32 from
        // 2^23 on is whole.
        const WHOLE: f32 = 8_388_608.0;
        let shift = WHOLE.copysign(self);
        let rounded = (self + shift) - shift;
        if self.abs() < WHOLE { rounded } else { self }
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let above = (self.to_bits() as i32).wrapping_sub(SQRT_HALF_BITS);
        let mantissa = f32::from_bits(((above & 0x007f_ffff) + SQRT_HALF_BITS) as u32);
        (mantissa, (above >> 23) as f32)
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        f32::from_bits((self + EXPONENT_SHIFT as f32).to_bits() << 23)
    }
    elementary_methods!();
}

impl Real for f64 {
    scalar_operations!(f64);

    #[inline(always)]
    fn round(self) -> Self {
        self.round_ties_even()
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        const SQRT_HALF: i64 = std::f64::consts::FRAC_1_SQRT_2.to_bits() as i64;
        let above = (self.to_bits() as i64).wrapping_sub(SQRT_HALF);
        let mantissa = f64::from_bits(((above & ((1 << 52) - 1)) + SQRT_HALF) as u64);
        (mantissa, (above >> 52) as f64)
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        f64::from_bits(((self as i64 + 1023) as u64) << 52)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        f64::exp(self)
    }
    #[inline(always)]
    fn exp_m1(self) -> Self {
        f64::exp_m1(self)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        f64::ln(self)
    }
    #[inline(always)]
    fn ln_1p(self) -> Self {
        f64::ln_1p(self)
    }
    #[inline(always)]
    fn cos_turns(self) -> Self {
        ((self - self.round_ties_even()) * (2.0 * PI)).cos()
    }
    #[inline(always)]
    fn sin_turns(self) -> Self {
        ((self - self.round_ties_even()) * (2.0 * PI)).sin()
    }
}
