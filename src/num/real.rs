//! `Real`: the number type that formulas are generic over.
//!
//! Single calls use `f32`, batches use lanes of `f32`, and tests compare both with `f64`. Comparisons
//! return masks and `select` chooses between two computed values, so that formulas have no branches and
//! hold for every number of lanes.

use std::fmt::Debug;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The result of a comparison: one truth value per lane.
pub trait Mask:
    Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> + 'static
{
    /// Whether any lane is set. It is used to skip work that no lane needs, never to choose a formula.
    fn any(self) -> bool;
}

/// A real number, or one in each lane of a register.
///
/// Elementary functions are accurate to a few units in the last place of the type. Each states its domain;
/// arguments outside it give unspecified values, which may be infinite or NaN, and never a panic.
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

    /// The distance from 1 to the next greater number.
    const EPSILON: f64;

    /// A constant in every lane, rounded once from double precision.
    fn new(value: f64) -> Self;

    /// Square root; the argument must not be negative.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The lesser of two; the second if either is NaN.
    fn min(self, other: Self) -> Self;
    /// The greater of two; the second if either is NaN.
    fn max(self, other: Self) -> Self;
    /// The nearest whole number; halves go to the even one.
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
    /// Per lane: `yes` where the mask is set, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Splits a positive normal number into m * 2^e with m in [sqrt(1/2), sqrt(2)).
    fn split(self) -> (Self, Self);
    /// 2^self, for a whole number that is the exponent of a normal number.
    fn power_of_two(self) -> Self;

    /// e^x for x <= 88; 0 where the result would be less than the least normal number.
    fn exp(self) -> Self;
    /// e^x - 1 for x <= 88, accurate near 0.
    fn exp_m1(self) -> Self;
    /// Natural logarithm of a normal number; -infinity at 0.
    fn ln(self) -> Self;
    /// ln(1 + x) for x >= -1, accurate near 0.
    fn ln_1p(self) -> Self;
    /// cos(2 pi x). The argument is in turns, so that its whole part can be subtracted exactly: a phase of
    /// thousands of turns keeps all its digits.
    fn cos_turns(self) -> Self;
    /// sin(2 pi x), with the argument in turns as in [`Real::cos_turns`].
    fn sin_turns(self) -> Self;

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
    /// sqrt(max(0, x)), for squares that rounding may make negative.
    #[inline(always)]
    fn sqrt_positive(self) -> Self {
        self.max(Self::new(0.0)).sqrt()
    }
}
