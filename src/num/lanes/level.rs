//! The choice of SIMD instructions at run time, and work that runs with any of them.

use super::super::Lane;
use super::f32_lanes::F32Lanes;
use super::instructions::Instructions;
use crate::error::Error;

/// Work that is written once for any number of lanes.
pub trait Work<T> {
    /// The result.
    type Output;
    /// Does the work in lanes of type `L`. This method and everything that it calls in its inner loops must
    /// be `#[inline(always)]`, because only inlined code uses the instructions.
    fn run<L: Lane<Scalar = T>>(self) -> Self::Output;
}

/// A set of SIMD instructions that this processor has, or none ("scalar").
#[derive(Clone, Copy, Debug)]
pub struct Level(Width);

#[derive(Clone, Copy, Debug)]
enum Width {
    Single,
    Lanes(fearless_simd::Level),
}

impl Level {
    /// One number at a time, as in single calls.
    pub const SCALAR: Self = Self(Width::Single);

    /// The level with the widest registers that this processor has.
    pub fn widest() -> Self {
        Self(Width::Lanes(fearless_simd::Level::new()))
    }

    /// All levels that this processor has, the narrowest first; [`Level::SCALAR`] only if there is no
    /// other.
    pub fn all() -> Vec<Self> {
        let best = fearless_simd::Level::new();
        #[cfg(target_arch = "x86_64")]
        {
            let narrower = [
                best.as_sse2().map(fearless_simd::Level::Sse2),
                best.as_avx2().map(fearless_simd::Level::Avx2),
                best.as_avx512().map(fearless_simd::Level::Avx512),
            ];
            let levels = narrower.into_iter().flatten();
            levels.map(|level| Self(Width::Lanes(level))).collect()
        }
        #[cfg(not(target_arch = "x86_64"))]
        vec![Self(Width::Lanes(best))]
    }

    /// The level with that [`Level::name`].
    ///
    /// # Errors
    /// `UnknownName`, if this processor has no level of that name; the message lists the names that it has.
    pub fn named(name: &str) -> Result<Self, Error> {
        let levels = || std::iter::once(Self::SCALAR).chain(Self::all());
        let found = levels().find(|level| level.name() == name);
        found.ok_or_else(|| Error::unknown("simd_level", name, levels().map(Self::name)))
    }

    /// The name: "scalar", "sse2", "avx2", "avx512" or "neon".
    pub fn name(self) -> &'static str {
        use fearless_simd::Level as Found;
        match self.0 {
            Width::Single => "scalar",
            #[cfg(target_arch = "x86_64")]
            Width::Lanes(Found::Avx512(_)) => "avx512",
            #[cfg(target_arch = "x86_64")]
            Width::Lanes(Found::Avx2(_)) => "avx2",
            #[cfg(target_arch = "x86_64")]
            Width::Lanes(_) => "sse2",
            #[cfg(target_arch = "aarch64")]
            Width::Lanes(Found::Neon(_)) => "neon",
            #[cfg(not(target_arch = "x86_64"))]
            Width::Lanes(_) => "scalar",
        }
    }

    /// Whether this is [`Level::SCALAR`].
    pub fn is_scalar(self) -> bool {
        self.name() == "scalar"
    }

    /// Does the work with the instructions of this level.
    ///
    /// # Panics
    /// At the level "scalar": no loop is compiled for it, because its callers make single calls instead.
    #[inline]
    pub fn run<W: Work<f32>>(self, work: W) -> W::Output {
        use fearless_simd::Level as Found;
        let Width::Lanes(found) = self.0 else {
            panic!("no loop is compiled for the level \"scalar\"");
        };
        match found {
            #[cfg(target_arch = "x86_64")]
            Found::Avx512(token) => run_with(token, work),
            #[cfg(target_arch = "x86_64")]
            Found::Avx2(token) => run_with(token, work),
            #[cfg(target_arch = "x86_64")]
            Found::Sse2(token) => run_with(token, work),
            #[cfg(target_arch = "aarch64")]
            Found::Neon(token) => run_with(token, work),
            _ => panic!("no loop is compiled for the level \"scalar\""),
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
