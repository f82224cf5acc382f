//! Sets of SIMD instructions, and what table look-ups need of them.
//!
//! A register is one, two or four quads of four numbers each. A table entry fills a quad, so that one load
//! fetches all its numbers. Lane 4 q + n of a register is number n of quad q. For each n from 0 to 3 one
//! register holds the entries for lanes n of all quads. Transposing these four registers gives one register
//! for each number of an entry, with the lanes in order.

#![allow(unsafe_code)]

use fearless_simd::prelude::*;

/// The greatest number of lanes.
pub(super) const MAX_LANES: usize = 16;

/// A set of SIMD instructions.
pub trait Instructions: Simd {
    /// Proves that the processor has the instructions. Lanes exist only in code that [`super::Level::run`]
    /// started, which has checked that.
    const TOKEN: Self;
    /// Whether there is an instruction that rounds to whole numbers.
    const ROUND: bool;
    /// Loads the entry `index[4 q + n]` of the table that begins at `start` into quad q, for every q.
    ///
    /// # Safety
    /// Every entry must be within the table.
    unsafe fn entries(
        self,
        start: *const [f32; 4],
        index: &[u32; MAX_LANES],
        n: usize,
    ) -> Self::f32s;
    /// [`Instructions::entries`] for each entry and for the two entries after it.
    ///
    /// # Safety
    /// All three entries must be within the table.
    #[inline(always)]
    unsafe fn three(
        self,
        start: *const [f32; 4],
        index: &[u32; MAX_LANES],
        n: usize,
    ) -> [Self::f32s; 3] {
        // SAFETY: the caller's promise.
        unsafe {
            [
                self.entries(start, index, n),
                self.entries(start.add(1), index, n),
                self.entries(start.add(2), index, n),
            ]
        }
    }
    /// Copies number n of each quad into all four of its lanes, for n from 0 to 3.
    fn spread(self, numbers: Self::f32s) -> [Self::f32s; 4];
    /// Number n of each quad of register m becomes number m of the same quad of register n.
    fn transposed(self, rows: [Self::f32s; 4]) -> [Self::f32s; 4];
}

/// The constants, which are written alike for every set of instructions.
macro_rules! token {
    ($round:expr) => {
        const ROUND: bool = $round;
        // SAFETY: lanes of these instructions exist only in code that `Level::run` started after checking
        // the processor.
        const TOKEN: Self = unsafe { Self::assume_supported() };
    };
}

macro_rules! one_quad {
    ($($token:ident: $round:expr),*) => {
        $(
            impl Instructions for fearless_simd::$token {
                token!($round);
                #[inline(always)]
                unsafe fn entries(
                    self,
                    start: *const [f32; 4],
                    index: &[u32; MAX_LANES],
                    n: usize,
                ) -> Self::f32s {
                    // SAFETY: the caller's promise.
                    Self::f32s::simd_from(self, unsafe { start.add(index[n] as usize).read() })
                }
                #[inline(always)]
                fn spread(self, numbers: Self::f32s) -> [Self::f32s; 4] {
                    let (low, high) = (numbers.zip_low(numbers), numbers.zip_high(numbers));
                    [
                        low.zip_low(low),
                        low.zip_high(low),
                        high.zip_low(high),
                        high.zip_high(high),
                    ]
                }
                #[inline(always)]
                fn transposed(self, [a, b, c, d]: [Self::f32s; 4]) -> [Self::f32s; 4] {
                    let (low_ac, high_ac) = (a.zip_low(c), a.zip_high(c));
                    let (low_bd, high_bd) = (b.zip_low(d), b.zip_high(d));
                    [
                        low_ac.zip_low(low_bd),
                        low_ac.zip_high(low_bd),
                        high_ac.zip_low(high_bd),
                        high_ac.zip_high(high_bd),
                    ]
                }
            }
        )*
    };
}

#[cfg(target_arch = "x86_64")]
one_quad!(Sse2: false);
#[cfg(target_arch = "aarch64")]
one_quad!(Neon: true);

/// The methods that differ only in the width of the intrinsics.
#[cfg(target_arch = "x86_64")]
macro_rules! wide_quads {
    ($permute:ident, $unpack_low:ident, $unpack_high:ident, $shuffle:ident) => {
        #[inline(always)]
        fn spread(self, numbers: Self::f32s) -> [Self::f32s; 4] {
            let numbers = numbers.into();
            // SAFETY: the token proves the instructions.
            unsafe {
                [
                    $permute::<0b00_00_00_00>(numbers).simd_into(self),
                    $permute::<0b01_01_01_01>(numbers).simd_into(self),
                    $permute::<0b10_10_10_10>(numbers).simd_into(self),
                    $permute::<0b11_11_11_11>(numbers).simd_into(self),
                ]
            }
        }
        #[inline(always)]
        fn transposed(self, [a, b, c, d]: [Self::f32s; 4]) -> [Self::f32s; 4] {
            let (a, b, c, d) = (a.into(), b.into(), c.into(), d.into());
            // SAFETY: the token proves the instructions.
            unsafe {
                let (low_ab, high_ab) = ($unpack_low(a, b), $unpack_high(a, b));
                let (low_cd, high_cd) = ($unpack_low(c, d), $unpack_high(c, d));
                [
                    $shuffle::<0b01_00_01_00>(low_ab, low_cd).simd_into(self),
                    $shuffle::<0b11_10_11_10>(low_ab, low_cd).simd_into(self),
                    $shuffle::<0b01_00_01_00>(high_ab, high_cd).simd_into(self),
                    $shuffle::<0b11_10_11_10>(high_ab, high_cd).simd_into(self),
                ]
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
mod x86_64 {
    use super::{Instructions, MAX_LANES};
    use fearless_simd::prelude::*;
    use fearless_simd::{Avx2, Avx512};
    use std::arch::x86_64::*;

    impl Instructions for Avx2 {
        token!(true);
        #[inline(always)]
        unsafe fn entries(
            self,
            start: *const [f32; 4],
            index: &[u32; MAX_LANES],
            n: usize,
        ) -> Self::f32s {
            // SAFETY: the caller's promise; the token proves the instructions.
            unsafe {
                let quad = |q: usize| start.add(index[4 * q + n] as usize).cast();
                let first = _mm256_castps128_ps256(_mm_loadu_ps(quad(0)));
                _mm256_insertf128_ps::<1>(first, _mm_loadu_ps(quad(1))).simd_into(self)
            }
        }
        // One load fetches two entries.
        #[inline(always)]
        unsafe fn three(
            self,
            start: *const [f32; 4],
            index: &[u32; MAX_LANES],
            n: usize,
        ) -> [Self::f32s; 3] {
            // SAFETY: the caller's promise; the token proves the instructions.
            unsafe {
                let two = |q: usize| start.add(index[4 * q + n] as usize).cast();
                let (a, b) = (_mm256_loadu_ps(two(0)), _mm256_loadu_ps(two(1)));
                [
                    _mm256_permute2f128_ps::<0b10_0000>(a, b).simd_into(self),
                    _mm256_permute2f128_ps::<0b11_0001>(a, b).simd_into(self),
                    self.entries(start.add(2), index, n),
                ]
            }
        }
        wide_quads!(
            _mm256_permute_ps,
            _mm256_unpacklo_ps,
            _mm256_unpackhi_ps,
            _mm256_shuffle_ps
        );
    }

    impl Instructions for Avx512 {
        token!(true);
        #[inline(always)]
        unsafe fn entries(
            self,
            start: *const [f32; 4],
            index: &[u32; MAX_LANES],
            n: usize,
        ) -> Self::f32s {
            // SAFETY: the caller's promise; the token proves the instructions.
            unsafe {
                let quad = |q: usize| start.add(index[4 * q + n] as usize).cast();
                let all = _mm512_castps128_ps512(_mm_loadu_ps(quad(0)));
                let all = _mm512_insertf32x4::<1>(all, _mm_loadu_ps(quad(1)));
                let all = _mm512_insertf32x4::<2>(all, _mm_loadu_ps(quad(2)));
                _mm512_insertf32x4::<3>(all, _mm_loadu_ps(quad(3))).simd_into(self)
            }
        }
        // One load fetches two entries.
        #[inline(always)]
        unsafe fn three(
            self,
            start: *const [f32; 4],
            index: &[u32; MAX_LANES],
            n: usize,
        ) -> [Self::f32s; 3] {
            // SAFETY: the caller's promise; the token proves the instructions.
            unsafe {
                let two = |q: usize| start.add(index[4 * q + n] as usize).cast();
                let low = _mm512_castps256_ps512(_mm256_loadu_ps(two(0)));
                let low = _mm512_insertf32x8::<1>(low, _mm256_loadu_ps(two(1)));
                let high = _mm512_castps256_ps512(_mm256_loadu_ps(two(2)));
                let high = _mm512_insertf32x8::<1>(high, _mm256_loadu_ps(two(3)));
                [
                    _mm512_shuffle_f32x4::<0b10_00_10_00>(low, high).simd_into(self),
                    _mm512_shuffle_f32x4::<0b11_01_11_01>(low, high).simd_into(self),
                    self.entries(start.add(2), index, n),
                ]
            }
        }
        wide_quads!(
            _mm512_permute_ps,
            _mm512_unpacklo_ps,
            _mm512_unpackhi_ps,
            _mm512_shuffle_ps
        );
    }
}
