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
    /// Cosine and sine of the angle from +X to the rougher axis; 1 and 0 if no axis is rougher, so that an
    /// anisotropy of 0 is the same surface whether it varies or not.
    pub turn: [T; 2],
    /// `turn` for an anisotropy other than 0.
    given_turn: [T; 2],
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
            given_turn: [L::splat(self.given_turn[0]), L::splat(self.given_turn[1])],
            is_round: self.is_round,
        }
    }
}

impl<T: Real> Roughness<T> {
    pub fn new(alpha: T, anisotropy: T, rotation: T, is_round: bool) -> Self {
        let given_turn = turn(rotation);
        Self {
            alpha,
            anisotropy,
            axes: axes(alpha, anisotropy),
            turn: effective_turn(anisotropy, given_turn),
            given_turn,
            is_round,
        }
    }

    /// The same roughness along both axes.
    pub fn isotropic(alpha: T) -> Self {
        let zero = T::new(0.0);
        Self::new(alpha, zero, zero, true)
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

    /// Replaces the value of a parameter that varies per call. Other parameters have no effect.
    #[inline(always)]
    pub fn vary(&mut self, param: usize, value: T) {
        match param {
            ALPHA => self.alpha = value,
            ANISOTROPY => self.anisotropy = value,
            ROTATION => self.given_turn = turn(value),
            _ => return,
        }
        self.turn = effective_turn(self.anisotropy, self.given_turn);
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

#[inline(always)]
fn effective_turn<T: Real>(anisotropy: T, given: [T; 2]) -> [T; 2] {
    let (zero, one) = (T::new(0.0), T::new(1.0));
    let is_anisotropic = anisotropy.gt(zero);
    [
        T::select(is_anisotropic, given[0], one),
        T::select(is_anisotropic, given[1], zero),
    ]
}
