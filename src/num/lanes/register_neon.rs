//! The NEON register of [`super::rgb_lanes`].

#![allow(unsafe_code)]

use super::super::scalar::SQRT_HALF_BITS;
use std::arch::aarch64::*;

/// Four numbers.
pub(super) type Numbers = float32x4_t;
/// Four masks, all bits set or none.
pub(super) type Bits = uint32x4_t;

/// Functions over intrinsics that take values, no pointers. They are unsafe to call only because other processors
/// might lack the instructions.
macro_rules! functions {
    ($($(#[$attribute:meta])* fn $name:ident($($argument:ident: $type:ty),*) -> $result:ty $body:block)*) => {
        $(
            $(#[$attribute])*
            #[inline(always)]
            pub(super) fn $name($($argument: $type),*) -> $result {
                // SAFETY: NEON is part of the baseline of 64-bit ARM, for which alone this file is compiled.
                unsafe { $body }
            }
        )*
    };
}

functions! {
    fn splat(number: f32) -> Numbers { vdupq_n_f32(number) }
    /// Red, green, blue, blue.
    fn from_channels(rgb: [f32; 3]) -> Numbers {
        let red_green = vsetq_lane_f32::<0>(rgb[0], vdupq_n_f32(rgb[2]));
        vsetq_lane_f32::<1>(rgb[1], red_green)
    }
    fn channels(a: Numbers) -> [f32; 3] {
        [vgetq_lane_f32::<0>(a), vgetq_lane_f32::<1>(a), vgetq_lane_f32::<2>(a)]
    }
    fn add(a: Numbers, b: Numbers) -> Numbers { vaddq_f32(a, b) }
    fn sub(a: Numbers, b: Numbers) -> Numbers { vsubq_f32(a, b) }
    fn mul(a: Numbers, b: Numbers) -> Numbers { vmulq_f32(a, b) }
    fn div(a: Numbers, b: Numbers) -> Numbers { vdivq_f32(a, b) }
    fn and(a: Bits, b: Bits) -> Bits { vandq_u32(a, b) }
    fn or(a: Bits, b: Bits) -> Bits { vorrq_u32(a, b) }
    fn not(a: Bits) -> Bits { vmvnq_u32(a) }
    fn any(a: Bits) -> bool { vmaxvq_u32(a) != 0 }
    fn neg(a: Numbers) -> Numbers { vnegq_f32(a) }
    fn abs(a: Numbers) -> Numbers { vabsq_f32(a) }
    fn sqrt(a: Numbers) -> Numbers { vsqrtq_f32(a) }
    /// To whole numbers, as for `f32`: adds and subtracts 2^23 of the same sign. NEON's own instruction keeps the
    /// sign of a zero.
    fn round(a: Numbers) -> Numbers {
        let whole = vdupq_n_f32(8_388_608.0);
        let shift = vbslq_f32(vdupq_n_u32(1 << 31), a, whole);
        select(lt(abs(a), whole), sub(add(a, shift), shift), a)
    }
    fn lt(a: Numbers, b: Numbers) -> Bits { vcltq_f32(a, b) }
    fn le(a: Numbers, b: Numbers) -> Bits { vcleq_f32(a, b) }
    fn equals(a: Numbers, b: Numbers) -> Bits { vceqq_f32(a, b) }
    fn select(mask: Bits, yes: Numbers, no: Numbers) -> Numbers { vbslq_f32(mask, yes, no) }
    /// Mantissas in [sqrt(1/2), sqrt(2)), and exponents.
    fn split(a: Numbers) -> (Numbers, Numbers) {
        let sqrt_half = vdupq_n_s32(SQRT_HALF_BITS);
        let above = vsubq_s32(vreinterpretq_s32_f32(a), sqrt_half);
        let fraction = vandq_s32(above, vdupq_n_s32(0x007f_ffff));
        let mantissa = vreinterpretq_f32_s32(vaddq_s32(fraction, sqrt_half));
        (mantissa, vcvtq_f32_s32(vshrq_n_s32::<23>(above)))
    }
    /// Shifts the lowest bits into the exponent field.
    fn bits_to_exponent(a: Numbers) -> Numbers {
        vreinterpretq_f32_s32(vshlq_n_s32::<23>(vreinterpretq_s32_f32(a)))
    }
}

/// The second number if either is NaN, as the comparison of two `f32` chooses; NEON's own minimum is NaN.
#[inline(always)]
pub(super) fn min(a: Numbers, b: Numbers) -> Numbers {
    select(lt(a, b), a, b)
}

/// As [`min`].
#[inline(always)]
pub(super) fn max(a: Numbers, b: Numbers) -> Numbers {
    select(lt(b, a), a, b)
}

/// Four neighbouring numbers.
///
/// # Safety
/// They must be readable.
#[inline(always)]
pub(super) unsafe fn load(numbers: *const f32) -> Numbers {
    // SAFETY: the caller's promise.
    unsafe { vld1q_f32(numbers) }
}
