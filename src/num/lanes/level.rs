//! The sets of instructions, and work that runs with any of them.

use super::super::Lane;
use super::f32_lanes::{F32Lanes, Instructions};

/// Work on numbers in single precision, as many at once as there may be.
pub trait Work<T> {
    /// What comes of it.
    type Output;
    /// Does it with `L` numbers side by side. Must be `#[inline(always)]`, as must all that it calls and
    /// that should be fast: only what is inlined uses the instructions.
    fn run<L: Lane<Scalar = T>>(self) -> Self::Output;
}

/// A set of instructions that this processor has.
#[derive(Clone, Copy, Debug)]
pub struct Level(fearless_simd::Level);

impl Level {
    /// The widest that this processor has. It allocates: for create(), not for what evaluates.
    pub fn chosen() -> Self {
        let all = Self::all();
        all[all.len() - 1]
    }

    /// All that this processor has, the narrowest first.
    pub fn all() -> Vec<Self> {
        let best = fearless_simd::Level::new();
        #[cfg(target_arch = "x86_64")]
        {
            let narrower = [
                best.as_sse2().map(fearless_simd::Level::Sse2),
                best.as_avx2().map(fearless_simd::Level::Avx2),
                best.as_avx512().map(fearless_simd::Level::Avx512),
            ];
            narrower.into_iter().flatten().map(Self).collect()
        }
        #[cfg(not(target_arch = "x86_64"))]
        vec![Self(best)]
    }

    /// "sse2", "avx2", "avx512", "neon", or "scalar" where there is none of them.
    pub fn name(self) -> &'static str {
        use fearless_simd::Level as Found;
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Found::Avx512(_) => "avx512",
            #[cfg(target_arch = "x86_64")]
            Found::Avx2(_) => "avx2",
            #[cfg(target_arch = "x86_64")]
            _ => "sse2",
            #[cfg(target_arch = "aarch64")]
            Found::Neon(_) => "neon",
            #[cfg(not(target_arch = "x86_64"))]
            _ => "scalar",
        }
    }

    /// Does the work with these instructions.
    #[inline]
    pub fn run<W: Work<f32>>(self, work: W) -> W::Output {
        use fearless_simd::Level as Found;
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Found::Avx512(token) => run_with(token, work),
            #[cfg(target_arch = "x86_64")]
            Found::Avx2(token) => run_with(token, work),
            #[cfg(target_arch = "x86_64")]
            Found::Sse2(token) => run_with(token, work),
            #[cfg(target_arch = "aarch64")]
            Found::Neon(token) => run_with(token, work),
            _ => work.run::<f32>(),
        }
    }
}

#[inline(always)]
fn run_with<S: Instructions, W: Work<f32>>(token: S, work: W) -> W::Output {
    token.vectorize(
        #[inline(always)]
        || work.run::<F32Lanes<S>>(),
    )
}
