//! Elementary functions in single precision, without branches or tables.
//!
//! The C library's `powf` and `cosf` cost 10 to 20 ns and cannot be vectorised; these cost a few
//! and are written over [`Single`], so that lanes of f32 get them too. The polynomials are our own
//! minimax fits (Lawson's algorithm, weighted for relative error); the error of each fit is beside
//! it, and `tests/optics/elementary.rs` measures the error of the whole function over its range:
//!
//! | function | range | greatest error |
//! |---|---|---|
//! | exp | [-87.3, 88] | 1.5 ulp |
//! | exp_m1 | [-87.3, 88] | 3 ulp |
//! | ln | all positive normal numbers | 1.5 ulp |
//! | ln_1p | (-1, 1e30] | 2 ulp |
//! | cos_turns, sin_turns | all finite numbers | 2e-7, absolute |

use super::Real;

/// Single-precision numbers, alone or in lanes: what the polynomials need beyond [`Real`].
pub(super) trait Single: Real {
    /// Splits a positive normal number into m * 2^e with m in [sqrt(1/2), sqrt(2)).
    fn split(self) -> (Self, Self);
    /// 2^self for a whole number in [-126, 127].
    fn power_of_two(self) -> Self;
}

/// The functions of this file as methods of a [`Single`] number's [`Real`].
macro_rules! elementary_methods {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                elementary::$method(self)
            }
        )*
    };
}
pub(super) use elementary_methods;

/// The bits of sqrt(1/2): subtracted from a number's bits, they make the exponent field count from
/// there, so that mantissas come out in [sqrt(1/2), sqrt(2)).
pub(super) const SQRT_HALF_BITS: i32 = 0x3f35_04f3;

/// 1.5 * 2^23 + 127: added to a whole number, it puts the number and the exponent's bias into the
/// low bits of the mantissa, from where a shift lifts them into the exponent field. No conversion
/// with its checks for NaN and range is needed.
pub(super) const EXPONENT_SHIFT: f64 = 12_582_912.0 + 127.0;

impl Single for f32 {
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

/// ln 2 in two parts: the first is 355/512, so short that n * LN2_HIGH is exact for every exponent
/// of single precision; the second is what remains.
const LN2_HIGH: f64 = 0.693_359_375;
const LN2_LOW: f64 = -2.121_944_400_546_905_8e-4;
/// Below this e^x is less than the least normal number; the result is 0.
const EXP_UNDERFLOW: f64 = -87.336;

/// x = n ln 2 + r with |r| <= ln(2)/2; returns n and e^r - 1.
#[inline(always)]
fn reduce_exp<T: Single>(x: T) -> (T, T) {
    let x = x.max(T::new(EXP_UNDERFLOW)).min(T::new(88.0));
    let n = (x * T::new(std::f64::consts::LOG2_E)).round();
    let r = (x - n * T::new(LN2_HIGH)) - n * T::new(LN2_LOW);
    // e^r - 1 = r + r^2 P(r); relative error 1.4e-8 on |r| <= 0.3466.
    let p = T::new(1.394_643_93e-3);
    let p = p * r + T::new(8.366_577_29e-3);
    let p = p * r + T::new(4.166_628_22e-2);
    let p = p * r + T::new(0.166_665_43);
    let p = p * r + T::new(0.500_000_006);
    (n, r + r * r * p)
}

#[inline(always)]
pub(super) fn exp<T: Single>(x: T) -> T {
    let (n, m1) = reduce_exp(x);
    let value = (m1 + T::new(1.0)) * n.power_of_two();
    T::select(x.lt(T::new(EXP_UNDERFLOW)), T::new(0.0), value)
}

#[inline(always)]
pub(super) fn exp_m1<T: Single>(x: T) -> T {
    let (n, m1) = reduce_exp(x);
    let scale = n.power_of_two();
    // 2^n (e^r - 1) + (2^n - 1): for n = 0 exactly e^r - 1.
    m1 * scale + (scale - T::new(1.0))
}

/// ln(1 + f) + exponent ln 2 for 1 + f in [sqrt(1/2), sqrt(2)), by 2 atanh(f / (2 + f)).
#[inline(always)]
fn ln_reduced<T: Single>(f: T, exponent: T) -> T {
    let s = f / (T::new(2.0) + f);
    let z = s * s;
    // 2 atanh(s) = 2 s + s z P(z); relative error 8.1e-10 on |s| <= 0.1716. Written around f, since
    // 2 s = f - s f, its leading term is exact.
    let p = T::new(0.298_717_277);
    let p = p * z + T::new(0.399_775_416);
    let p = p * z + T::new(0.666_667_764);
    let correction = s * (z * p - f) + exponent * T::new(LN2_LOW);
    exponent * T::new(LN2_HIGH) + (f + correction)
}

#[inline(always)]
pub(super) fn ln<T: Single>(x: T) -> T {
    let (mantissa, exponent) = x.split();
    let value = ln_reduced(mantissa - T::new(1.0), exponent);
    T::select(x.le(T::new(0.0)), T::new(f64::NEG_INFINITY), value)
}

#[inline(always)]
pub(super) fn ln_1p<T: Single>(x: T) -> T {
    let one = T::new(1.0);
    let u = one + x;
    let (mantissa, exponent) = u.split();
    // What rounding 1 + x lost goes back into the reduced argument, scaled as the mantissa is. The
    // larger of 1 and x is subtracted last, so that the difference is exact.
    let lost = T::select(x.gt(one), one - (u - x), x - (u - one));
    let f = (mantissa - one) + lost * (-exponent).power_of_two();
    let value = ln_reduced(f, exponent);
    T::select(u.le(T::new(0.0)), T::new(f64::NEG_INFINITY), value)
}

/// sin(2 pi t) for |t| <= 1/4: t P(t^2), relative error 5.4e-9.
#[inline(always)]
fn sin_quarter<T: Single>(t: T) -> T {
    let z = t * t;
    let p = T::new(39.710_948);
    let p = p * z + T::new(-76.574_996_5);
    let p = p * z + T::new(81.602_231_5);
    let p = p * z + T::new(-41.341_677_5);
    // The leading coefficient 2 pi in two parts: the fit's own value less its rounding to f32.
    let p = p * z + T::new(-1.747e-7);
    t * T::new(6.283_185_482_025_146_5) + t * p
}

#[inline(always)]
pub(super) fn cos_turns<T: Single>(x: T) -> T {
    let fraction = (x - x.round()).abs();
    sin_quarter(T::new(0.25) - fraction)
}

#[inline(always)]
pub(super) fn sin_turns<T: Single>(x: T) -> T {
    let fraction = x - x.round();
    let quarter = T::new(0.25);
    let half = T::new(0.5);
    let folded = T::select(fraction.gt(quarter), half - fraction, fraction);
    let folded = T::select(fraction.lt(-quarter), -half - fraction, folded);
    sin_quarter(folded)
}
