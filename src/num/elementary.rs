//! Elementary functions in single precision, without branches or tables.
//!
//! They are the methods of [`Real`] for `f32` and lanes of `f32`; double precision has its own. The C
//! library's `powf` and `cosf` cost 10 to 20 ns and cannot be vectorised; these cost a few ns and work in
//! lanes. The polynomials are our own minimax fits (Lawson's algorithm, weighted for relative error). A
//! comment beside each fit states its error, and a test measures the error of each function over its range:
//!
//! | function | range | greatest error |
//! |---|---|---|
//! | exp | [-87.3, 88] | 1.5 ulp |
//! | exp_m1 | [-87.3, 88] | 3 ulp |
//! | ln | all positive normal numbers | 1.5 ulp |
//! | ln_1p | (-1, 1e30] | 2 ulp |
//! | cos_turns, sin_turns | all finite numbers | 2e-7, absolute |

use super::Real;

/// The elementary functions of [`Real`] for a type in single precision.
macro_rules! elementary_methods {
    () => {
        elementary_methods!(exp, exp_m1, ln, ln_1p, cos_turns, sin_turns);
    };
    ($($name:ident),+) => {
        $(
            #[inline(always)]
            fn $name(self) -> Self {
                $crate::num::elementary::$name(self)
            }
        )+
    };
}
pub(in crate::num) use elementary_methods;

/// ln 2 in two parts. The first is 355/512, which has so few digits that n * LN2_HIGH is exact for every
/// exponent n of single precision; the second is the rest.
const LN2_HIGH: f64 = 0.693_359_375;
const LN2_LOW: f64 = -2.121_944_400_546_905_8e-4;
/// Below this argument e^x is less than the least normal number, and the result is 0.
const EXP_UNDERFLOW: f64 = -87.336;

/// Splits x = n ln 2 + r with |r| <= ln(2) / 2 and returns n and e^r - 1.
#[inline(always)]
fn reduce_exp<T: Real>(x: T) -> (T, T) {
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
pub(in crate::num) fn exp<T: Real>(x: T) -> T {
    let (n, m1) = reduce_exp(x);
    let value = (m1 + T::new(1.0)) * n.power_of_two();
    T::select(x.lt(T::new(EXP_UNDERFLOW)), T::new(0.0), value)
}

#[inline(always)]
pub(in crate::num) fn exp_m1<T: Real>(x: T) -> T {
    let (n, m1) = reduce_exp(x);
    let scale = n.power_of_two();
    // e^x - 1 = 2^n (e^r - 1) + (2^n - 1), which is exactly e^r - 1 for n = 0.
    m1 * scale + (scale - T::new(1.0))
}

/// ln(1 + f) + exponent ln 2 for 1 + f in [sqrt(1/2), sqrt(2)), by 2 atanh(f / (2 + f)).
#[inline(always)]
fn ln_reduced<T: Real>(f: T, exponent: T) -> T {
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
pub(in crate::num) fn ln<T: Real>(x: T) -> T {
    let (mantissa, exponent) = x.split();
    let value = ln_reduced(mantissa - T::new(1.0), exponent);
    T::select(x.le(T::new(0.0)), T::new(f64::NEG_INFINITY), value)
}

#[inline(always)]
pub(in crate::num) fn ln_1p<T: Real>(x: T) -> T {
    let one = T::new(1.0);
    let u = one + x;
    let (mantissa, exponent) = u.split();
    // The rounding error of 1 + x is added to the reduced argument, scaled as the mantissa is. The larger
    // of 1 and x is subtracted last, so that the difference is exact.
    let lost = T::select(x.gt(one), one - (u - x), x - (u - one));
    let f = (mantissa - one) + lost * (-exponent).power_of_two();
    let value = ln_reduced(f, exponent);
    T::select(u.le(T::new(0.0)), T::new(f64::NEG_INFINITY), value)
}

/// sin(2 pi t) for |t| <= 1/4: t P(t^2), relative error 5.4e-9.
#[inline(always)]
fn sin_quarter<T: Real>(t: T) -> T {
    let z = t * t;
    let p = T::new(39.710_948);
    let p = p * z + T::new(-76.574_996_5);
    let p = p * z + T::new(81.602_231_5);
    let p = p * z + T::new(-41.341_677_5);
    // The leading coefficient, about 2 pi, comes in two parts: its rounding to f32, and the rest.
    let p = p * z + T::new(-1.747e-7);
    t * T::new(6.283_185_482_025_146_5) + t * p
}

#[inline(always)]
pub(in crate::num) fn cos_turns<T: Real>(x: T) -> T {
    let fraction = (x - x.round()).abs();
    sin_quarter(T::new(0.25) - fraction)
}

#[inline(always)]
pub(in crate::num) fn sin_turns<T: Real>(x: T) -> T {
    let fraction = x - x.round();
    let quarter = T::new(0.25);
    let half = T::new(0.5);
    let folded = T::select(fraction.gt(quarter), half - fraction, fraction);
    let folded = T::select(fraction.lt(-quarter), -half - fraction, folded);
    sin_quarter(folded)
}
