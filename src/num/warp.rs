//! Warps of two uniform numbers in [0, 1) to directions around +Z, with their densities.

use super::{PI, Real, Vec3};

/// A direction with z >= 0 and the density z / pi per solid angle.
#[inline(always)]
pub fn cosine_hemisphere<T: Real>(u1: T, u2: T) -> Vec3<T> {
    let radius = u1.sqrt();
    let one = T::new(1.0);
    Vec3::new(
        radius * u2.cos_turns(),
        radius * u2.sin_turns(),
        (one - u1).sqrt_positive(),
    )
}

/// Density of [`cosine_hemisphere`] per solid angle, for `cos_theta` >= 0.
#[inline(always)]
pub fn cosine_hemisphere_pdf<T: Real>(cos_theta: T) -> T {
    cos_theta * T::new(1.0 / PI)
}

/// A direction with z >= 0 and the density (e + 1) / (2 pi) z^e per solid angle, for an exponent e >= 0.
///
/// z = v^(1 / (e + 1)) with v = 1 - u1. The complement 1 - z is computed directly, by expm1, because for e
/// = 1e5 most of the lobe has 1 - z < 1e-4 and z alone has lost its digits.
#[inline(always)]
pub fn power_cosine<T: Real>(exponent: T, u1: T, u2: T) -> Vec3<T> {
    let one = T::new(1.0);
    let complement = -((-u1).ln_1p() / (exponent + one)).exp_m1();
    let sine = (complement * (T::new(2.0) - complement)).sqrt_positive();
    Vec3::new(
        sine * u2.cos_turns(),
        sine * u2.sin_turns(),
        one - complement,
    )
}

/// The factor (e + 1) / (2 pi) of z^e in the density of [`power_cosine`].
#[inline(always)]
pub fn power_cosine_normalization<T: Real>(exponent: T) -> T {
    (exponent + T::new(1.0)) * T::new(0.5 / PI)
}
