//! Numbers for each lobe of a BSDF, and sets of lobes.

use super::info::{Flags, LobeInfo};
use crate::num::Real;

/// The most lobes that a model may have.
pub const MAX_LOBES: usize = 5;

/// One number per lobe; those beyond the model's own lobes are 0.
pub type PerLobe<T> = [T; MAX_LOBES];

/// A set of lobes of one BSDF, by their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LobeSet(u8);

impl LobeSet {
    /// Every lobe.
    pub const ALL: Self = Self(u8::MAX);

    /// Those of `lobes` all of whose flags are wanted.
    #[inline(always)]
    pub fn wanted(lobes: &[LobeInfo], flags: Flags) -> Self {
        if flags == Flags::ALL {
            return Self::ALL;
        }
        let mut set = 0;
        for (lobe, info) in lobes.iter().enumerate() {
            if flags.contains(info.flags) {
                set |= 1 << lobe;
            }
        }
        let all = (1u8 << lobes.len()) - 1;
        if set == all { Self::ALL } else { Self(set) }
    }

    /// Whether every lobe is in it.
    #[inline(always)]
    pub fn is_all(self) -> bool {
        self == Self::ALL
    }

    /// Whether no lobe is in it.
    #[inline(always)]
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether a lobe is in it.
    #[inline(always)]
    pub fn contains(self, lobe: usize) -> bool {
        self.0 & (1 << lobe) != 0
    }
}

const _: () = assert!(MAX_LOBES < 8, "a set of lobes is one byte");

/// A number for the first lobe, 0 for the others.
#[inline(always)]
pub fn first_lobe<T: Real>(number: T) -> PerLobe<T> {
    let mut numbers = [T::new(0.0); MAX_LOBES];
    numbers[0] = number;
    numbers
}

/// Shares of the reflected light as probabilities: divided by their sum, or all 0 with it. Each is
/// divided, as the sum may be so small that its inverse is infinite.
#[inline(always)]
pub fn normalized<T: Real>(shares: PerLobe<T>) -> PerLobe<T> {
    let zero = T::new(0.0);
    let mut sum = zero;
    for share in shares {
        sum = sum + share;
    }
    let is_dark = sum.le(zero);
    let divisor = T::select(is_dark, T::new(1.0), sum);
    let mut probabilities = shares;
    for probability in &mut probabilities {
        *probability = T::select(is_dark, zero, *probability / divisor);
    }
    probabilities
}

/// The density of all lobes together.
#[inline(always)]
pub fn mixture_density<T: Real>(shares: &PerLobe<T>, densities: &PerLobe<T>) -> T {
    let mut sum = T::new(0.0);
    for lobe in 0..MAX_LOBES {
        sum = sum + shares[lobe] * densities[lobe];
    }
    sum
}
