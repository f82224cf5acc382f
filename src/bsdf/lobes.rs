//! Numbers for each lobe of a BSDF, and sets of lobes.

use super::info::{Flags, LobeInfo};
use crate::num::Real;

/// The greatest number of lobes of a model.
pub const MAX_LOBES: usize = 5;

/// One number per lobe. Numbers beyond the lobes of the model are 0.
pub type PerLobe<T> = [T; MAX_LOBES];

/// A set of lobes of one BSDF, by their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LobeSet(u8);

impl LobeSet {
    /// Every lobe.
    pub const ALL: Self = Self(u8::MAX);

    /// The lobes whose flags are all in `flags`.
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

    /// Whether every lobe is in the set.
    #[inline(always)]
    pub fn is_all(self) -> bool {
        self == Self::ALL
    }

    /// Whether no lobe is in the set.
    #[inline(always)]
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether a lobe is in the set.
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

/// Probabilities in proportion to shares of the reflected light; all 0 if the shares are. Each share is
/// divided by the sum, because the inverse of a very small sum would be infinite.
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

/// The density over all lobes: the sum of the probabilities times the densities.
#[inline(always)]
pub fn mixture_density<T: Real>(shares: &PerLobe<T>, densities: &PerLobe<T>) -> T {
    let mut sum = T::new(0.0);
    for lobe in 0..MAX_LOBES {
        sum = sum + shares[lobe] * densities[lobe];
    }
    sum
}
