//! Fresnel reflectance between two dielectrics, in Schlick's approximation.

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
