//! Fresnel reflectance between two dielectrics, exact and in Schlick's approximation.

use crate::math::Real;

/// Reflectance at normal incidence between indices `eta_outside` and `eta_inside` (both > 0):
/// ((r0 - r1) / (r0 + r1))^2, GH02 eq. 8.
#[inline(always)]
pub fn normal_reflectance<T: Real>(eta_outside: T, eta_inside: T) -> T {
    ((eta_outside - eta_inside) / (eta_outside + eta_inside)).squared()
}

/// Reflectance f + (1 - f)(1 - cos)^5 for `cos_theta` in [0, 1]: Schlick 1994, GH02 eq. 7.
#[inline(always)]
pub fn schlick<T: Real>(f0: T, cos_theta: T) -> T {
    let one = T::new(1.0);
    f0 + (one - f0) * (one - cos_theta).pow5()
}

/// Transmittance (1 - f)(1 - (1 - cos)^5), the complement of [`schlick`]: GH02 eq. 9.
#[inline(always)]
pub fn schlick_transmittance<T: Real>(f0: T, cos_theta: T) -> T {
    let one = T::new(1.0);
    (one - f0) * (one - (one - cos_theta).pow5())
}

/// Reflectance of unpolarised light for `cos_theta` in [0, 1] on the outside, `eta` > 0 the index
/// inside over that outside; 1 beyond the critical angle, and 0 for equal indices. Fresnel 1823, with
/// q = eta cos(angle inside) from q^2 = (eta - 1)(eta + 1) + cos^2, which has no cancellation.
#[inline(always)]
pub fn dielectric_reflectance<T: Real>(cos_theta: T, eta: T) -> T {
    let (zero, half, one) = (T::new(0.0), T::new(0.5), T::new(1.0));
    let excess = (eta - one) * (eta + one);
    let q_squared = excess + cos_theta.squared();
    let q = q_squared.sqrt_positive();
    let along = eta.squared() * cos_theta;
    let is_matched = excess.equals(zero);
    let ratio = |a: T| ((a - q) / T::select(is_matched, one, a + q)).squared();
    let reflectance = (ratio(cos_theta) + ratio(along)) * half;
    let reflectance = T::select(q_squared.le(zero), one, reflectance);
    T::select(is_matched, zero, reflectance)
}
