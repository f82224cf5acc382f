//! The half vector of two directions, in a form that keeps its digits.

use crate::num::{Real, Vec3};

/// The least divisor: about the least number whose inverse is finite in single precision.
const LEAST_SUM: f64 = 1.2e-38;

/// The least z of a half vector, so that distributions can take its logarithm.
const LEAST_NORMAL: f64 = 1e-30;

/// Two directions and the half vector between them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfVector<T> {
    /// The direction to the viewer.
    pub wo: Vec3<T>,
    /// The direction to the light.
    pub wi: Vec3<T>,
    /// A vector along the half vector h, whose largest component is 1 in magnitude.
    pub sum: Vec3<T>,
    /// The length of `sum`, and its square.
    pub length: T,
    pub length_squared: T,
    /// <wo, h> = <wi, h>, in (0, 1].
    pub cos_half: T,
}

impl<T: Real> HalfVector<T> {
    /// The half vector of two directions with z > 0. The sum is divided by its largest component before its
    /// length is computed, because at grazing angles the sum may be too short to be squared. Sums of nearly
    /// opposite components are exact, so that h keeps the digits that a narrow lobe needs. For unit vectors
    /// <wo, h> is half the length of the sum, which is never 0.
    #[inline(always)]
    pub fn new(wo: Vec3<T>, wi: Vec3<T>) -> Self {
        let sum = wo.plus(wi);
        let largest = sum.x.abs().max(sum.y.abs()).max(sum.z);
        let sum = sum.scaled(T::new(1.0) / largest.max(T::new(LEAST_SUM)));
        let length_squared = sum.length_squared();
        let length = length_squared.sqrt();
        let half = largest * length * T::new(0.5);
        Self {
            wo,
            wi,
            sum,
            length,
            length_squared,
            cos_half: half.min(T::new(1.0)),
        }
    }

    /// The half vector, of unit length.
    #[inline(always)]
    pub fn h(&self) -> Vec3<T> {
        let mut h = self.sum.scaled(T::new(1.0) / self.length);
        h.z = h.z.max(T::new(LEAST_NORMAL));
        h
    }

    /// All directions rotated about +Z by the angle with the given cosine and sine.
    #[inline(always)]
    pub fn turned(&self, turn: [T; 2]) -> Self {
        Self {
            wo: turned(self.wo, turn),
            wi: turned(self.wi, turn),
            sum: turned(self.sum, turn),
            ..*self
        }
    }
}

/// A direction rotated about +Z by the angle with the given cosine and sine.
#[inline(always)]
pub(super) fn turned<T: Real>(w: Vec3<T>, [cos, sin]: [T; 2]) -> Vec3<T> {
    Vec3::new(w.x * cos - w.y * sin, w.x * sin + w.y * cos, w.z)
}
