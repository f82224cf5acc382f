//! Four double-precision numbers in a plain array. The compiler uses instructions of the width that the
//! processor has, and every width gives the same bits.

use super::super::{Mask, PI, Real};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Four double-precision numbers, one per lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct F64x4([f64; F64x4::COUNT]);

/// A mask: one truth value per lane, all bits set or none.
#[derive(Clone, Copy, Debug, Default)]
pub struct F64Mask([u64; F64x4::COUNT]);

/// 1.5 * 2^52. Adding it rounds to a whole number, whose integer is then in the lowest bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// The least argument of exp. Below it the result is 0, because e^x would be less than the least normal
/// number.
const LEAST_EXPONENT: f64 = -708.0;
/// The greatest argument of exp; greater ones are clamped to it.
const GREATEST_EXPONENT: f64 = 709.0;
/// ln 2 in two parts. The first has few enough digits that its products with whole exponents are exact.
const LN2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN2_LOW: f64 = 1.908_214_929_270_587_7e-10;

impl F64x4 {
    /// Number of lanes.
    pub const COUNT: usize = 4;

    /// The vector whose lane i is `number(i)`.
    #[inline(always)]
    pub fn from_fn(number: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(number))
    }

    /// The numbers in the order of the lanes.
    #[inline(always)]
    pub fn to_array(self) -> [f64; Self::COUNT] {
        self.0
    }

    /// The sum of the lanes.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        let [a, b, c, d] = self.0;
        (a + c) + (b + d)
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i])))
    }

    /// e^r - 1 and 2^n, for x = n ln 2 + r clamped to the range of exp.
    #[inline(always)]
    fn reduced_exp(self) -> [Self; 2] {
        let x = self
            .max(Self::new(LEAST_EXPONENT))
            .min(Self::new(GREATEST_EXPONENT));
        let whole = Self::new(WHOLE);
        let shifted = x * Self::new(std::f64::consts::LOG2_E) + whole;
        let n = shifted - whole;
        let r = (x - n * Self::new(LN2_HIGH)) - n * Self::new(LN2_LOW);
        // (e^r - 1) / r = sum r^j / (j + 1)!, with four terms side by side.
        let (r2, c) = (r * r, Self::new);
        let r4 = r2 * r2;
        let low = (c(1.0) + r * c(0.5)) + r2 * (c(1.0 / 6.0) + r * c(1.0 / 24.0));
        let middle =
            (c(1.0 / 120.0) + r * c(1.0 / 720.0)) + r2 * (c(1.0 / 5040.0) + r * c(1.0 / 40_320.0));
        let high = (c(1.0 / 362_880.0) + r * c(1.0 / 3_628_800.0))
            + r2 * (c(1.0 / 39_916_800.0) + r * c(1.0 / 479_001_600.0));
        let sum = low + r4 * (middle + r4 * high);
        // The integer n is in the lowest bits, from where a shift moves it into the exponent field.
        let power = shifted.map(|s| f64::from_bits((s.to_bits().wrapping_add(1023)) << 52));
        [r * sum, power]
    }

    /// Cosine and sine of 2 pi x for |x| < 2^50, with an error of 1e-11: Taylor's series about the nearest
    /// quarter of a turn. The C library's functions do not work in lanes and differ between machines.
    #[inline(always)]
    pub fn circle(self) -> [Self; 2] {
        let whole = Self::new(WHOLE);
        let shifted = self * Self::new(4.0) + whole;
        let t = (self - (shifted - whole) * Self::new(0.25)) * Self::new(2.0 * PI);
        let z = t * t;
        // Pairs of terms are summed side by side, which takes half as long as one term after another.
        let (z2, c) = (z * z, Self::new);
        let sine = (c(1.0) - z * c(1.0 / 6.0))
            + z2 * ((c(1.0 / 120.0) - z * c(1.0 / 5040.0))
                + z2 * (c(1.0 / 362_880.0) - z * c(1.0 / 39_916_800.0)));
        let sine = sine * t;
        let cosine = (c(1.0) - z * c(0.5))
            + z2 * ((c(1.0 / 24.0) - z * c(1.0 / 720.0))
                + z2 * ((c(1.0 / 40_320.0) - z * c(1.0 / 3_628_800.0))
                    + z2 * c(1.0 / 479_001_600.0)));
        let quarter: [u64; Self::COUNT] = shifted.0.map(f64::to_bits);
        let is_odd = F64Mask(quarter.map(|q| 0u64.wrapping_sub(q & 1)));
        let sign = |x: Self| {
            let flipped = |i: usize| f64::from_bits(x.0[i].to_bits() ^ ((quarter[i] & 2) << 62));
            Self(std::array::from_fn(flipped))
        };
        [
            sign(Self::select(is_odd, -sine, cosine)),
            sign(Self::select(is_odd, cosine, sine)),
        ]
    }
}

macro_rules! operator {
    ($type:ident, $trait:ident, $method:ident) => {
        impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|i| {
                    $trait::$method(self.0[i], other.0[i])
                }))
            }
        }
    };
}

operator!(F64x4, Add, add);
operator!(F64x4, Sub, sub);
operator!(F64x4, Mul, mul);
operator!(F64x4, Div, div);
operator!(F64Mask, BitAnd, bitand);
operator!(F64Mask, BitOr, bitor);

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

impl Not for F64Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(Not::not))
    }
}

impl Mask for F64Mask {
    #[inline(always)]
    fn any(self) -> bool {
        let [a, b, c, d] = self.0;
        (a | b | c | d) != 0
    }
}

/// The methods that [`Real`] for `f64` does in each lane.
macro_rules! per_lane {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                self.map(Real::$method)
            }
        )*
    };
}

macro_rules! per_lane_pair {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|i| Real::$method(self.0[i], other.0[i])))
            }
        )*
    };
}

macro_rules! comparison {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self, other: Self) -> F64Mask {
                let is_set = |i: usize| Real::$method(self.0[i], other.0[i]);
                F64Mask(std::array::from_fn(|i| if is_set(i) { u64::MAX } else { 0 }))
            }
        )*
    };
}

impl Real for F64x4 {
    type Mask = F64Mask;
    const EPSILON: f64 = f64::EPSILON;

    #[inline(always)]
    fn new(value: f64) -> Self {
        Self([value; Self::COUNT])
    }
    per_lane!(sqrt, abs, round, power_of_two, ln, ln_1p);
    per_lane_pair!(min, max);
    comparison!(lt, le, equals);
    #[inline(always)]
    fn is_finite(self) -> F64Mask {
        self.abs().lt(Self::new(f64::INFINITY))
    }
    #[inline(always)]
    fn select(mask: F64Mask, yes: Self, no: Self) -> Self {
        let chosen = |i: usize| {
            let (yes, no) = (yes.0[i].to_bits(), no.0[i].to_bits());
            f64::from_bits((yes & mask.0[i]) | (no & !mask.0[i]))
        };
        Self(std::array::from_fn(chosen))
    }

    /// x = n ln 2 + r, and Taylor's series of e^r. The relative error is 1e-14.
    #[inline(always)]
    fn exp(self) -> Self {
        let [quotient, power] = self.reduced_exp();
        let value = (Self::new(1.0) + quotient) * power;
        Self::select(self.lt(Self::new(LEAST_EXPONENT)), Self::new(0.0), value)
    }
    /// As [`Real::exp`]: 2^n (e^r - 1) + (2^n - 1), of which the second term is exactly 0 for n = 0.
    #[inline(always)]
    fn exp_m1(self) -> Self {
        let [m1, power] = self.reduced_exp();
        m1 * power + (power - Self::new(1.0))
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let parts = self.0.map(Real::split);
        (
            Self(parts.map(|part| part.0)),
            Self(parts.map(|part| part.1)),
        )
    }
    #[inline(always)]
    fn cos_turns(self) -> Self {
        self.circle()[0]
    }
    #[inline(always)]
    fn sin_turns(self) -> Self {
        self.circle()[1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circle_is_cosine_and_sine() {
        for i in -4000..4000 {
            let turns = f64::from(i) * 0.00713;
            let (sin, cos) = (2.0 * PI * turns).sin_cos();
            let found = F64x4::new(turns).circle().map(|x| x.to_array()[1]);
            assert!((found[0] - cos).abs() < 1e-10, "{turns}");
            assert!((found[1] - sin).abs() < 1e-10, "{turns}");
        }
    }

    #[test]
    fn exp_is_that_of_the_standard_library() {
        for i in -70_700..70_900 {
            let x = f64::from(i) * 0.01;
            let found = Real::exp(F64x4::new(x)).to_array()[2];
            assert!((found / x.exp() - 1.0).abs() < 3e-14, "{x}: {found}");
            let found = F64x4::new(x).exp_m1().to_array()[1];
            let error = if x == 0.0 {
                found
            } else {
                found / x.exp_m1() - 1.0
            };
            assert!(error.abs() < 3e-14, "e^{x} - 1: {found}");
        }
        for x in [1e-3, -2e-7, 3e-12, -1e-300] {
            let found = F64x4::new(x).exp_m1().to_array()[3];
            assert!(
                (found / x.exp_m1() - 1.0).abs() < 1e-15,
                "e^{x} - 1: {found}"
            );
        }
        for (x, expected) in [(-709.0, 0.0), (f64::NEG_INFINITY, 0.0), (0.0, 1.0)] {
            assert_eq!(Real::exp(F64x4::new(x)).to_array(), [expected; 4]);
        }
    }

    #[test]
    fn each_number_is_on_its_own() {
        let a = F64x4::from_fn(|i| i as f64);
        let b = F64x4::new(1.5);
        assert_eq!((a * b - a).to_array(), [0.0, 0.5, 1.0, 1.5]);
        assert_eq!(
            F64x4::select(a.lt(b), a, b).to_array(),
            [0.0, 1.0, 1.5, 1.5]
        );
        assert_eq!(a.sum(), 6.0);
        assert!(a.gt(b).any() && !a.gt(F64x4::new(3.0)).any());
    }
}
