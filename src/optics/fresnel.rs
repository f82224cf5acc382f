//! The Fresnel reflectance of one interface, exact and by Schlick's approximation.

use super::Complex;
use crate::num::Real;

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

/// [`schlick`] with a reflectance `f90` in [f0, 1] at grazing angles in place of 1.
#[inline(always)]
pub fn schlick_between<T: Real>(f0: T, f90: T, cos_theta: T) -> T {
    f0 + (f90 - f0) * (T::new(1.0) - cos_theta).pow5()
}

/// [`schlick_between`] where f90 may be less than f0: both terms are positive, so that nothing cancels at grazing
/// angles. It takes 1 ns more.
#[inline(always)]
pub fn schlick_falling<T: Real>(f0: T, f90: T, cos_theta: T) -> T {
    let one = T::new(1.0);
    let rise = (one - cos_theta).pow5();
    (f0 * schlick_fall(cos_theta) + f90 * rise).min(one)
}

/// 1 - (1 - cos)^5, with all its digits at grazing angles too: with m = 1 - cos it is (1 - m)(1 + m + m^2 +
/// m^3 + m^4).
#[inline(always)]
fn schlick_fall<T: Real>(cos_theta: T) -> T {
    let one = T::new(1.0);
    let m = one - cos_theta;
    let m_squared = m.squared();
    cos_theta * ((one + m) * (one + m_squared) + m_squared.squared())
}

/// Transmittance (1 - f)(1 - (1 - cos)^5), the complement of [`schlick`]: GH02 eq. 9.
#[inline(always)]
pub fn schlick_transmittance<T: Real>(f0: T, cos_theta: T) -> T {
    (T::new(1.0) - f0) * schlick_fall(cos_theta)
}

/// Reflectance of unpolarised light. `cos_theta`, in [0, 1], is the cosine outside, and `eta` > 0 is the
/// index inside over that outside. The result is 1 beyond the critical angle and 0 for equal indices.
/// Fresnel 1823, with q = eta cos(angle inside) from q^2 = (eta - 1)(eta + 1) + cos^2, which has no
/// cancellation.
#[inline(always)]
pub fn dielectric_reflectance<T: Real>(cos_theta: T, eta: T) -> T {
    let (zero, half, one) = (T::new(0.0), T::new(0.5), T::new(1.0));
    let excess = (eta - one) * (eta + one);
    let q_squared = excess + cos_theta.squared();
    let q = q_squared.sqrt_positive();
    let along = eta.squared() * cos_theta;
    let is_matched = excess.equals(zero);
    let across = (cos_theta - q) / T::select(is_matched, one, cos_theta + q);
    let along = (along - q) / T::select(is_matched, one, along + q);
    let reflectance = (across.squared() + along.squared()) * half;
    let reflectance = T::select(q_squared.le(zero), one, reflectance);
    T::select(is_matched, zero, reflectance)
}

/// Reflectance of unpolarised light that arrives from vacuum at `cos_theta` in [0, 1] on a medium of index
/// eta + i k, eta > 0 and k >= 0: Born and Wolf, "Principles of Optics", section 14.2. With k = 0 it is
/// [`dielectric_reflectance`].
///
/// q = n cos(angle inside) follows from q^2 = n^2 - sin^2, whose real part is computed as (eta - 1)(eta +
/// 1) - k^2 + cos^2, without cancellation for indices close to 1.
#[inline(always)]
pub fn conductor_reflectance<T: Real>(cos_theta: T, eta: T, k: T) -> T {
    let (zero, half, one) = (T::new(0.0), T::new(0.5), T::new(1.0));
    let excess = Complex::new(
        (eta - one) * (eta + one) - k.squared(),
        T::new(2.0) * eta * k,
    );
    let q = (excess + Complex::real(cos_theta.squared())).sqrt_upper();
    let is_matched = excess.equals(Complex::real(zero));
    let along = (excess + Complex::real(one)).scaled(cos_theta);
    // The mean of |(cos - q) / (cos + q)|^2 and |(n^2 cos - q) / (n^2 cos + q)|^2, over one divisor.
    let across = Complex::real(cos_theta);
    let [upper, lower] = [(across - q).norm_squared(), (across + q).norm_squared()];
    let [upper_p, lower_p] = [(along - q).norm_squared(), (along + q).norm_squared()];
    let divisor = T::select(is_matched, one, lower * lower_p);
    let reflectance = half * (upper * lower_p + upper_p * lower) / divisor;
    T::select(is_matched, zero, reflectance)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ETAS: [f64; 7] = [0.4, 1.0 / 1.5, 0.99, 1.01, 1.33, 1.5, 4.0];

    /// Textbook values: ((eta - 1) / (eta + 1))^2 at normal incidence; at Brewster's angle, tan = eta, only
    /// s is reflected, with the amplitude (1 - eta^2) / (1 + eta^2); at grazing angles R = 1.
    #[test]
    fn dielectric_reflectance_has_textbook_values() {
        for eta in ETAS {
            let normal = ((eta - 1.0) / (eta + 1.0)).powi(2);
            assert!((dielectric_reflectance(1.0, eta) - normal).abs() < 1e-15);
            assert!((normal_reflectance(1.0, eta) - normal).abs() < 1e-15);
            let brewster = (1.0 + eta * eta).sqrt().recip();
            let s = (1.0 - eta * eta) / (1.0 + eta * eta);
            let found = dielectric_reflectance(brewster, eta);
            assert!((found - 0.5 * s * s).abs() < 1e-14, "{eta} {found}");
            assert_eq!(dielectric_reflectance(0.0, eta), 1.0);
        }
        // Glass at 60 degrees: rs = -0.4202, rp = -0.0424, from Snell's law and a table of cosines.
        assert!((dielectric_reflectance(0.5, 1.5f64) - 0.089_18).abs() < 1e-4);
    }

    /// From the denser side R = 1 beyond the critical angle, sin = eta, and only there.
    #[test]
    fn total_reflection_begins_at_the_critical_angle() {
        for eta in ETAS.into_iter().filter(|eta| *eta < 1.0) {
            let critical = (1.0 - eta * eta).sqrt();
            for part in [0.0, 0.3, 0.9, 1.0 - 1e-9] {
                assert_eq!(dielectric_reflectance(critical * part, eta), 1.0);
            }
            let single = dielectric_reflectance(0.999 * critical as f32, eta as f32);
            assert_eq!(single, 1.0);
            // R falls from there like a square root.
            let found = dielectric_reflectance(critical * (1.0 + 1e-8), eta);
            assert!(found < 1.0 && found > 0.99, "{eta} {found}");
        }
    }

    /// Where F falls to 0 at grazing angles, 1 - (1 - cos)^5 = 5 cos - 10 cos^2 + ... keeps its digits in single
    /// precision, and so does the transmittance.
    #[test]
    fn schlick_keeps_its_digits_at_grazing_angles() {
        for c in [1e-7f32, 9e-5, 1e-3, 0.03, 0.4, 1.0] {
            let x = f64::from(c);
            let expected = x * (5.0 - x * (10.0 - x * (10.0 - x * (5.0 - x))));
            for found in [schlick_falling(1.0, 0.0, c), schlick_transmittance(0.0, c)] {
                let error = (f64::from(found) / expected - 1.0).abs();
                assert!(error < 5e-7, "{c}: {found} {expected}");
            }
            assert!(
                (schlick_falling(0.3, 0.3, c) / 0.3 - 1.0).abs() < 5e-7,
                "{c}"
            );
        }
    }

    /// Equal indices reflect nothing, even at the cosine 0, where the amplitudes are 0 / 0.
    #[test]
    fn equal_indices_reflect_nothing() {
        for c in [0.0, f64::MIN_POSITIVE, 1e-200, 1e-9, 0.5, 1.0] {
            assert_eq!(dielectric_reflectance(c, 1.0), 0.0, "{c}");
            assert_eq!(dielectric_reflectance(c as f32, 1.0f32), 0.0, "{c}");
        }
    }

    /// Single precision keeps its digits: there is no cancellation for indices close to 1 or at grazing
    /// angles.
    #[test]
    fn single_precision_is_close_to_double() {
        for eta in ETAS.map(|eta| eta as f32) {
            for i in 0..=1000u16 {
                let c = (f32::from(i) / 1000.0).powi(2);
                let single = dielectric_reflectance(c, eta);
                let double = dielectric_reflectance(f64::from(c), f64::from(eta));
                // Near the critical angle rounding of the cosine itself is magnified.
                let gap = (f64::from(c).powi(2) + f64::from(eta).powi(2) - 1.0).abs();
                let allowed = 1e-6
                    + if eta < 1.0 {
                        1e-6 / gap.sqrt().max(1e-3)
                    } else {
                        0.0
                    };
                let error = (f64::from(single) - double).abs();
                assert!(error <= allowed, "{eta} {c}: {single} {double}");
            }
        }
    }

    /// At normal incidence R = ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2); at grazing angles R = 1; without
    /// absorption R is that of the dielectric, total reflection included.
    #[test]
    fn conductor_reflectance_has_textbook_values() {
        for eta in ETAS {
            for k in [0.0, 0.1, 3.0, 20.0f64] {
                let normal = ((eta - 1.0).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k);
                assert!((conductor_reflectance(1.0, eta, k) - normal).abs() < 1e-15);
                assert!((conductor_reflectance(0.0, eta, k) - 1.0).abs() < 1e-15);
            }
            for i in 0..=1000 {
                let c = f64::from(i) / 1000.0;
                let expected = dielectric_reflectance(c, eta);
                let found = conductor_reflectance(c, eta, 0.0);
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{eta} {c}: {found} {expected}"
                );
                let nearly = conductor_reflectance(c, eta, 1e-12);
                assert!(
                    (nearly - expected).abs() < 1e-5,
                    "{eta} {c}: {nearly} {expected}"
                );
            }
        }
        assert_eq!(conductor_reflectance(0.0, 1.0, 0.0), 0.0);
    }

    /// The error in single precision, over the ranges that the models accept.
    #[test]
    fn conductor_reflectance_keeps_its_digits() {
        for eta in [0.01, 0.2, 0.999, 1.0, 1.001, 1.5, 10.0f32] {
            for k in [0.0, 1e-6, 1e-3, 0.5, 4.0, 20.0f32] {
                for i in 0..=1000u16 {
                    let c = (f32::from(i) / 1000.0).powi(2);
                    let single = conductor_reflectance(c, eta, k);
                    let double = conductor_reflectance(f64::from(c), f64::from(eta), f64::from(k));
                    assert!(
                        (0.0..=1.000_001).contains(&single),
                        "{eta} {k} {c}: {single}"
                    );
                    // Near the critical angle of eta < 1 rounding of the cosine is magnified.
                    let gap = f64::from(c).powi(2) + f64::from(eta).powi(2) - 1.0;
                    let magnified = if eta < 1.0 {
                        1e-6 / gap.abs().sqrt().max(1e-3)
                    } else {
                        0.0
                    };
                    let error = (f64::from(single) - double).abs();
                    assert!(
                        error <= 2e-6 + magnified,
                        "{eta} {k} {c}: {single} {double}"
                    );
                }
            }
        }
    }
}
