//! The SSE2 register of [`super::rgb_lanes`].

#![allow(unsafe_code)]

use super::super::scalar::SQRT_HALF_BITS;
use std::arch::x86_64::*;

/// Four numbers.
pub(super) type Numbers = __m128;
/// Four masks, all bits set or none.
pub(super) type Bits = __m128;

/// Functions over intrinsics that take values, no pointers. They are unsafe to call only because other processors
/// might lack the instructions.
macro_rules! functions {
    ($($(#[$attribute:meta])* fn $name:ident($($argument:ident: $type:ty),*) -> $result:ty $body:block)*) => {
        $(
            $(#[$attribute])*
            #[inline(always)]
            pub(super) fn $name($($argument: $type),*) -> $result {
                // SAFETY: SSE2 is part of the x86-64 baseline, for which alone this file is compiled.
                unsafe { $body }
            }
        )*
    };
}

functions! {
    fn splat(number: f32) -> Numbers { _mm_set1_ps(number) }
    /// Red, green, blue, blue.
    fn from_channels(rgb: [f32; 3]) -> Numbers { _mm_setr_ps(rgb[0], rgb[1], rgb[2], rgb[2]) }
    fn channels(a: Numbers) -> [f32; 3] {
        let green = _mm_shuffle_ps::<0b01_01_01_01>(a, a);
        let blue = _mm_movehl_ps(a, a);
        [_mm_cvtss_f32(a), _mm_cvtss_f32(green), _mm_cvtss_f32(blue)]
    }
    fn add(a: Numbers, b: Numbers) -> Numbers { _mm_add_ps(a, b) }
    fn sub(a: Numbers, b: Numbers) -> Numbers { _mm_sub_ps(a, b) }
    fn mul(a: Numbers, b: Numbers) -> Numbers { _mm_mul_ps(a, b) }
    fn div(a: Numbers, b: Numbers) -> Numbers { _mm_div_ps(a, b) }
    fn and(a: Bits, b: Bits) -> Bits { _mm_and_ps(a, b) }
    fn or(a: Bits, b: Bits) -> Bits { _mm_or_ps(a, b) }
    fn not(a: Bits) -> Bits { _mm_xor_ps(a, _mm_castsi128_ps(_mm_set1_epi32(-1))) }
    fn any(a: Bits) -> bool { _mm_movemask_ps(a) != 0 }
    fn neg(a: Numbers) -> Numbers { _mm_xor_ps(a, _mm_set1_ps(-0.0)) }
    fn abs(a: Numbers) -> Numbers { _mm_andnot_ps(_mm_set1_ps(-0.0), a) }
    fn sqrt(a: Numbers) -> Numbers { _mm_sqrt_ps(a) }
    /// The second number if either is NaN, as the comparison of two `f32` chooses.
    fn min(a: Numbers, b: Numbers) -> Numbers { _mm_min_ps(a, b) }
    /// As [`min`].
    fn max(a: Numbers, b: Numbers) -> Numbers { _mm_max_ps(a, b) }
    /// To whole numbers, as for `f32`: adds and subtracts 2^23 of the same sign.
    fn round(a: Numbers) -> Numbers {
        let whole = _mm_set1_ps(8_388_608.0);
        let sign = _mm_and_ps(a, _mm_set1_ps(-0.0));
        let shift = _mm_or_ps(whole, sign);
        select(lt(abs(a), whole), sub(add(a, shift), shift), a)
    }
    fn lt(a: Numbers, b: Numbers) -> Bits { _mm_cmplt_ps(a, b) }
    fn le(a: Numbers, b: Numbers) -> Bits { _mm_cmple_ps(a, b) }
    fn equals(a: Numbers, b: Numbers) -> Bits { _mm_cmpeq_ps(a, b) }
    fn select(mask: Bits, yes: Numbers, no: Numbers) -> Numbers {
        _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no))
    }
    /// Mantissas in [sqrt(1/2), sqrt(2)), and exponents.
    fn split(a: Numbers) -> (Numbers, Numbers) {
        let sqrt_half = _mm_set1_epi32(SQRT_HALF_BITS);
        let above = _mm_sub_epi32(_mm_castps_si128(a), sqrt_half);
        let fraction = _mm_and_si128(above, _mm_set1_epi32(0x007f_ffff));
        let mantissa = _mm_castsi128_ps(_mm_add_epi32(fraction, sqrt_half));
        (mantissa, _mm_cvtepi32_ps(_mm_srai_epi32::<23>(above)))
    }
    /// Shifts the lowest bits into the exponent field.
    fn bits_to_exponent(a: Numbers) -> Numbers {
        _mm_castsi128_ps(_mm_slli_epi32::<23>(_mm_castps_si128(a)))
    }
}

/// Four neighbouring numbers.
///
/// # Safety
/// They must be readable, and the pointer a multiple of 16.
#[inline(always)]
pub(super) unsafe fn load(numbers: *const f32) -> Numbers {
    // SAFETY: the caller's promise.
    unsafe { _mm_load_ps(numbers) }
}
