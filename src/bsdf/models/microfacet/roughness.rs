//! Roughness along two axes, as the parameters describe it.

use super::params::{ALPHA, ANISOTROPY, ROTATION};
use crate::num::{Lane, Real};

/// Roughness along two axes, and where they lie.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roughness<T> {
    /// Geometric mean of the two.
    pub alpha: T,
    anisotropy: T,
    /// Along the long axis and across it.
    pub axes: [T; 2],
    /// Cosine and sine of the angle from +X to the long axis.
    pub turn: [T; 2],
    /// Whether both axes are the same for all calls; then it does not matter where they lie.
    pub is_round: bool,
}

impl<T: Lane<Scalar = T>> Roughness<T> {
    /// The same everywhere.
    #[inline(always)]
    pub fn splat<L: Lane<Scalar = T>>(&self) -> Roughness<L> {
        Roughness {
            alpha: L::splat(self.alpha),
            anisotropy: L::splat(self.anisotropy),
            axes: [L::splat(self.axes[0]), L::splat(self.axes[1])],
            turn: [L::splat(self.turn[0]), L::splat(self.turn[1])],
            is_round: self.is_round,
        }
    }
}

impl<T: Real> Roughness<T> {
    pub fn new(alpha: T, anisotropy: T, rotation: T, is_round: bool) -> Self {
        Self {
            alpha,
            anisotropy,
            axes: axes(alpha, anisotropy),
            turn: turn(rotation),
            is_round,
        }
    }

    /// The same where it is known to be round.
    #[inline(always)]
    pub fn round(self) -> Self {
        Self {
            axes: [self.alpha; 2],
            is_round: true,
            ..self
        }
    }

    /// Round, with that alpha along both axes.
    pub fn with_alpha(self, alpha: T) -> Self {
        Self {
            alpha,
            axes: [alpha; 2],
            ..self
        }
    }

    /// Replaces the value of a parameter that varies per call; those of other kinds have no effect.
    #[inline(always)]
    pub fn vary(&mut self, param: usize, value: T) {
        match param {
            ALPHA => self.alpha = value,
            ANISOTROPY => self.anisotropy = value,
            ROTATION => self.turn = turn(value),
            _ => return,
        }
        self.axes = if self.is_round {
            [self.alpha; 2]
        } else {
            axes(self.alpha, self.anisotropy)
        };
    }
}

/// alpha over and times sqrt(1 - 0.9 anisotropy): Burley 2012, "Physically-Based Shading at Disney",
/// addendum.
#[inline(always)]
fn axes<T: Real>(alpha: T, anisotropy: T) -> [T; 2] {
    let aspect = (T::new(1.0) - T::new(0.9) * anisotropy).sqrt();
    [alpha / aspect, alpha * aspect]
}

#[inline(always)]
fn turn<T: Real>(rotation: T) -> [T; 2] {
    [rotation.cos_turns(), rotation.sin_turns()]
}
