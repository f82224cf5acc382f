//! Roughness along two axes, as the parameters describe it.

use super::params::{ALPHA, ANISOTROPY, ROTATION};
use crate::num::{Lane, Real};

/// The roughness along two axes, and the rotation of these axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roughness<T> {
    /// The geometric mean of both.
    pub alpha: T,
    anisotropy: T,
    /// The roughness along the rougher axis and across it.
    pub axes: [T; 2],
    /// Cosine and sine of the angle from +X to the rougher axis.
    pub turn: [T; 2],
    /// Whether the roughness is the same along both axes in all calls, so that their rotation has no
    /// effect.
    pub is_round: bool,
}

impl<T: Lane<Scalar = T>> Roughness<T> {
    /// The same roughness in every lane.
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

    /// The same roughness, with both axes known to be equal.
    #[inline(always)]
    pub fn round(self) -> Self {
        Self {
            axes: [self.alpha; 2],
            is_round: true,
            ..self
        }
    }

    /// The roughness with that alpha along both axes.
    pub fn with_alpha(self, alpha: T) -> Self {
        Self {
            alpha,
            axes: [alpha; 2],
            ..self
        }
    }

    /// Replaces the value of a parameter that varies per call. Other parameters have no effect.
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

/// alpha / a and alpha a with a = sqrt(1 - 0.9 anisotropy): Burley 2012, "Physically-Based Shading at
/// Disney", addendum.
#[inline(always)]
fn axes<T: Real>(alpha: T, anisotropy: T) -> [T; 2] {
    let aspect = (T::new(1.0) - T::new(0.9) * anisotropy).sqrt();
    [alpha / aspect, alpha * aspect]
}

#[inline(always)]
fn turn<T: Real>(rotation: T) -> [T; 2] {
    [rotation.cos_turns(), rotation.sin_turns()]
}
