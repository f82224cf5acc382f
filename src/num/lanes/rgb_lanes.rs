//! Red, green and blue in the four lanes of one register, of SSE2 or NEON, which every x86-64 and every 64-bit ARM
//! processor has. The fourth lane repeats blue, so that it adds no subnormal number and no floating-point exception
//! of its own.

#![allow(unsafe_code)]

use super::super::elementary::elementary_methods;
use super::super::lane::scalar_methods;
use super::super::scalar::EXPONENT_SHIFT;
use super::super::table::{TableBlock, TableEntry, unbiased, weighted};
use super::super::{Lane, Mask, Real};
#[cfg(target_arch = "aarch64")]
use super::register_neon as register;
#[cfg(target_arch = "x86_64")]
use super::register_sse2 as register;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Three colour channels in single precision.
#[derive(Clone, Copy, Debug)]
pub struct RgbLanes(register::Numbers);

/// A mask: one truth value per lane, all bits set or none.
#[derive(Clone, Copy, Debug)]
pub struct RgbMask(register::Bits);

impl Lane for f32 {
    type Rgb = RgbLanes;
    #[inline(always)]
    fn rgb(channels: [f32; 3]) -> RgbLanes {
        RgbLanes(register::from_channels(channels))
    }
    #[inline(always)]
    fn gray(self) -> RgbLanes {
        RgbLanes(register::splat(self))
    }
    #[inline(always)]
    fn channels(rgb: RgbLanes) -> [f32; 3] {
        register::channels(rgb.0)
    }
    scalar_methods!();
    #[inline(always)]
    fn weighted_row(table: &[TableEntry<f32>], first: f32, weights: [f32; 3]) -> RgbLanes {
        let [row, ..] = load_block(table, unbiased(first), 0);
        weighted(row, weights.map(f32::gray))
    }
    #[inline(always)]
    fn weighted_block(
        table: &[TableEntry<f32>],
        stride: usize,
        block: TableBlock<f32>,
    ) -> RgbLanes {
        let [column, row] = block.first.map(unbiased);
        let rows = load_block(table, row * stride + column, stride);
        let across = block.across.map(f32::gray);
        weighted(
            rows.map(|row| weighted(row, across)),
            block.along.map(f32::gray),
        )
    }
}

/// Loads three entries from each of three rows of a table. The first entry is at `from`, and rows are
/// `stride` entries apart.
///
/// # Panics
/// If an entry is outside the table.
#[inline(always)]
fn load_block(table: &[TableEntry<f32>], from: usize, stride: usize) -> [[RgbLanes; 3]; 3] {
    // No sum overflows, because a slice has at most isize::MAX bytes.
    if stride >= table.len() || from >= table.len() || from + 2 * stride + 2 >= table.len() {
        outside();
    }
    let start = table.as_ptr();
    std::array::from_fn(|row| {
        std::array::from_fn(|entry| {
            // SAFETY: the index is at most from + 2 stride + 2, which is in the table; entries are aligned.
            RgbLanes(unsafe { register::load(start.add(from + row * stride + entry).cast()) })
        })
    })
}

/// It takes no arguments, because callers would prepare them in the fast path too.
#[cold]
#[inline(never)]
fn outside() -> ! {
    panic!("entries outside a table")
}

macro_rules! operator {
    ($type:ident, $trait:ident, $method:ident, $function:ident) => {
        impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(register::$function(self.0, other.0))
            }
        }
    };
}

operator!(RgbLanes, Add, add, add);
operator!(RgbLanes, Sub, sub, sub);
operator!(RgbLanes, Mul, mul, mul);
operator!(RgbLanes, Div, div, div);
operator!(RgbMask, BitAnd, bitand, and);
operator!(RgbMask, BitOr, bitor, or);

impl Neg for RgbLanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(register::neg(self.0))
    }
}

impl Not for RgbMask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(register::not(self.0))
    }
}

impl Mask for RgbMask {
    #[inline(always)]
    fn any(self) -> bool {
        register::any(self.0)
    }
}

impl Real for RgbLanes {
    type Mask = RgbMask;
    const EPSILON: f64 = f32::EPSILON as f64;

    #[inline(always)]
    fn new(value: f64) -> Self {
        Self(register::splat(value as f32))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(register::sqrt(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(register::abs(self.0))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(register::min(self.0, other.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(register::max(self.0, other.0))
    }
    #[inline(always)]
    fn round(self) -> Self {
        Self(register::round(self.0))
    }
    #[inline(always)]
    fn is_finite(self) -> RgbMask {
        self.abs().lt(Self::new(f64::INFINITY))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> RgbMask {
        RgbMask(register::lt(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> RgbMask {
        RgbMask(register::le(self.0, other.0))
    }
    #[inline(always)]
    fn equals(self, other: Self) -> RgbMask {
        RgbMask(register::equals(self.0, other.0))
    }
    #[inline(always)]
    fn select(mask: RgbMask, yes: Self, no: Self) -> Self {
        Self(register::select(mask.0, yes.0, no.0))
    }
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let (mantissa, exponent) = register::split(self.0);
        (Self(mantissa), Self(exponent))
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        let shifted = self + Self::new(EXPONENT_SHIFT);
        Self(register::bits_to_exponent(shifted.0))
    }
    elementary_methods!();
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The name of a function, its scalar form and its form in lanes.
    type Unary = (&'static str, fn(f32) -> f32, fn(RgbLanes) -> RgbLanes);

    /// Each lane of every operation has the bits of the scalar operation.
    #[test]
    fn lanes_equal_scalars() {
        let numbers = [
            0.0, 1e-30, 3e-4, 0.25, 0.5, 0.7, 1.0, 1.5, 2.5, 37.3, 8.1e5, 9e6, 1e30,
        ];
        let signed: Vec<f32> = numbers.iter().flat_map(|&x| [x, -x]).collect();
        let unary: [Unary; 9] = [
            ("neg", Neg::neg, Neg::neg),
            ("abs", Real::abs, Real::abs),
            ("round", Real::round, Real::round),
            ("exp", Real::exp, Real::exp),
            ("exp_m1", Real::exp_m1, Real::exp_m1),
            ("ln", |x| Real::ln(x.abs()), |x| x.abs().ln()),
            ("ln_1p", |x| Real::ln_1p(x.abs()), |x| x.abs().ln_1p()),
            ("cos_turns", Real::cos_turns, Real::cos_turns),
            ("sqrt", |x| Real::sqrt(x.abs()), |x| x.abs().sqrt()),
        ];
        for (name, scalar, lanes) in unary {
            for three in signed.windows(3) {
                let three: [f32; 3] = three.try_into().unwrap();
                let found = f32::channels(lanes(f32::rgb(three)));
                let expected = three.map(scalar);
                assert_eq!(
                    found.map(f32::to_bits),
                    expected.map(f32::to_bits),
                    "{name} {three:?}"
                );
            }
        }
        for &a in &signed {
            for &b in &signed {
                let (x, y) = (f32::gray(a), f32::gray(b));
                let pick = |mask| f32::channels(RgbLanes::select(mask, x, y))[2];
                let scalar_pick = |mask: bool| if mask { a } else { b };
                let pairs = [
                    (f32::channels(x + y)[0], a + b),
                    (f32::channels(x - y)[1], a - b),
                    (f32::channels(x * y)[2], a * b),
                    (f32::channels(x.min(y))[0], Real::min(a, b)),
                    (f32::channels(x.max(y))[1], Real::max(a, b)),
                    (pick(x.lt(y)), scalar_pick(a < b)),
                    (pick(x.le(y) & !x.equals(y)), scalar_pick(a < b)),
                    (pick(x.gt(y) | x.equals(y)), scalar_pick(a >= b)),
                ];
                for (found, expected) in pairs {
                    assert_eq!(found.to_bits(), expected.to_bits(), "{a} {b}");
                }
            }
        }
    }
}
