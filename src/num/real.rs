//! `Real`: the number type that formulas are generic over.
//!
//! `f32` serves single calls, lanes of `f32` serve batches, and `f64` is the oracle that tests compare
//! with. Comparisons return masks and `select` chooses between two computed values, so a formula has no
//! branches and holds for every width.

use super::elementary;
use std::fmt::Debug;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The result of a comparison: one truth value per lane.
pub trait Mask:
    Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> + 'static
{
    /// Whether any lane is set. Used to skip work that no lane needs, never to choose a formula.
    fn any(self) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// A real number, or several side by side.
///
/// Elementary functions are accurate to a few units in the last place of the type; each states its
/// domain. Arguments outside it give unspecified finite or non-finite values, never a panic.
pub trait Real:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// One truth value per lane.
    type Mask: Mask;

    /// The distance from 1 to the next number.
    const EPSILON: f64;

    /// The same constant in every lane, rounded once from double precision.
    fn new(value: f64) -> Self;

    /// Square root; the argument must not be negative.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// The lesser of two; the second if either is NaN.
    fn min(self, other: Self) -> Self;
    /// The greater of two; the second if either is NaN.
    fn max(self, other: Self) -> Self;
    /// The nearest whole number.
    fn round(self) -> Self;
    /// Whether each lane is neither NaN nor infinite.
    fn is_finite(self) -> Self::Mask;

    /// `self < other`
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`
    fn le(self, other: Self) -> Self::Mask;
    /// `self == other`
    fn equals(self, other: Self) -> Self::Mask;
    /// `self > other`
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// `self >= other`
    #[inline(always)]
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }
    /// Per lane: `yes` where the mask is set, `no` elsewhere. Both are already computed.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Splits a positive normal number into m * 2^e with m in [sqrt(1/2), sqrt(2)).
    fn split(self) -> (Self, Self);
    /// 2^self for a whole number that is the exponent of a normal number.
    fn power_of_two(self) -> Self;

    /// e^x for x <= 88; 0 below the least normal number's logarithm.
    #[inline(always)]
    fn exp(self) -> Self {
        elementary::exp(self)
    }
    /// e^x - 1 for x <= 88, accurate near 0.
    #[inline(always)]
    fn exp_m1(self) -> Self {
        elementary::exp_m1(self)
    }
    /// Natural logarithm of a normal number; -infinity at 0.
    #[inline(always)]
    fn ln(self) -> Self {
        elementary::ln(self)
    }
    /// ln(1 + x) for x >= -1, accurate near 0.
    #[inline(always)]
    fn ln_1p(self) -> Self {
        elementary::ln_1p(self)
    }
    /// cos(2 pi x). The argument counts turns, so that its whole part can be subtracted exactly: a
    /// phase of thousands of turns keeps all its digits.
    #[inline(always)]
    fn cos_turns(self) -> Self {
        elementary::cos_turns(self)
    }
    /// sin(2 pi x), as [`Real::cos_turns`].
    #[inline(always)]
    fn sin_turns(self) -> Self {
        elementary::sin_turns(self)
    }

    /// x^2
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
    /// x^5, the power of Schlick's approximation.
    #[inline(always)]
    fn pow5(self) -> Self {
        self.squared().squared() * self
    }
    /// sqrt(max(0, x)): for squares that rounding may push below 0.
    #[inline(always)]
    fn sqrt_positive(self) -> Self {
        self.max(Self::new(0.0)).sqrt()
    }
}

/// The bits of sqrt(1/2) in single precision: subtracted from a number's bits, they make the exponent
/// field count from there, so that mantissas lie in [sqrt(1/2), sqrt(2)).
pub(super) const SQRT_HALF_BITS: i32 = 0x3f35_04f3;

/// 1.5 * 2^23 + 127: added to a whole number, it puts the number and the exponent's bias into the
/// low bits of the mantissa; a shift moves them into the exponent field. No conversion with its checks
/// for NaN and range is needed.
pub(super) const EXPONENT_SHIFT: f64 = 12_582_912.0 + 127.0;

/// The methods that both scalar instances share.
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
        // Adding and taking away 2^23 of the same sign rounds to the nearest whole number without
        // a call to the C library, which the SSE2 baseline would otherwise need. From there on
        // every float is whole.
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
        ((self - self.round_ties_even()) * (2.0 * super::PI)).cos()
    }
    #[inline(always)]
    fn sin_turns(self) -> Self {
        ((self - self.round_ties_even()) * (2.0 * super::PI)).sin()
    }
}
