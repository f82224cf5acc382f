//! The lobe cos^e about an axis, which Phong's model and the layered model share.

use crate::math::{PI, Real, Rgb, Vec3, warp};

/// max(0, <a, b>)^e for unit vectors a and b.
///
/// The cosine is 1 - |a - b|^2 / 2, and its logarithm is taken of the second term alone: near the
/// axis the cosine in single precision has no digits left for an exponent of 1e5 to amplify.
#[inline(always)]
pub fn power_of_cosine<T: Real>(a: Vec3<T>, b: Vec3<T>, exponent: T) -> T {
    let complement = a.minus(b).length_squared() * T::new(0.5);
    let power = (exponent * (-complement).ln_1p()).exp();
    T::select(complement.lt(T::new(1.0)), power, T::new(0.0))
}

/// max(0, <a, b>)^(e / 2), the root of [`power_of_cosine`]; 0 where that is below 1e-17. So products of two
/// of them and of what multiplies them are 0 or far from the least normal number, below which
/// processors are slow.
#[inline(always)]
pub fn root_of_power<T: Real>(a: Vec3<T>, b: Vec3<T>, exponent: T) -> T {
    const LEAST: f64 = -39.14; // ln 1e-17
    let complement = a.minus(b).length_squared() * T::new(0.5);
    let logarithm = T::new(0.5) * exponent * (-complement).ln_1p();
    let is_seen = complement.lt(T::new(1.0)) & logarithm.gt(T::new(LEAST));
    T::select(is_seen, logarithm.exp(), T::new(0.0))
}

/// (e + 2) / (2 pi), with which cos^e reflects no more than it receives: Lafortune and Willems 1994,
/// eq. 6. Not the normalisation of the density, which lacks the cosine of reflection.
#[inline(always)]
pub fn conserving_normalization<T: Real>(exponent: T) -> T {
    (exponent + T::new(2.0)) * T::new(0.5 / PI)
}

/// A direction about `axis` with density (e + 1) / (2 pi) cos^e per solid angle.
#[inline(always)]
pub fn sample_about<T: Real>(axis: Vec3<T>, exponent: T, u: [T; 2]) -> Vec3<T> {
    axis.frame_to_world(warp::power_cosine(exponent, u[0], u[1]))
}

/// Estimate of the integral of cos^e wi.z over the hemisphere, for a lobe whose axis has the given
/// z: only its ratio to other lobes' integrals matters, to choose between them.
///
/// For a narrow lobe it is 2 pi / (e + 2) times the mean of max(0, wi.z) over the lobe. With the
/// lobe's spread sigma^2 = 1 / (e + 2), that mean goes from z to 0.4 sigma at the horizon (the mean
/// of half a normal distribution), which (z + sqrt(z^2 + 0.64 sigma^2)) / 2 follows.
#[inline(always)]
pub fn estimated_integral<T: Real>(exponent: T, axis_z: T) -> T {
    T::new(std::f64::consts::TAU) / (exponent + T::new(2.0)) * smooth_cosine(exponent, axis_z)
}

/// The mean of max(0, wi.z) over the lobe, see [`estimated_integral`].
#[inline(always)]
pub fn smooth_cosine<T: Real>(exponent: T, axis_z: T) -> T {
    let variance = T::new(0.64) / (exponent + T::new(2.0));
    (axis_z + (axis_z.squared() + variance).sqrt()) * T::new(0.5)
}

/// Mean of three channels.
#[inline(always)]
pub fn mean<T: Real>([r, g, b]: Rgb<T>) -> T {
    (r + g + b) * T::new(1.0 / 3.0)
}
