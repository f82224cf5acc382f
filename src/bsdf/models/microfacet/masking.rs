//! Masking and shadowing, the factor G: the part of the facets that both directions see.

use super::half_vector::HalfVector;
use super::ndf::{GREATEST, Ndf};
use crate::num::{Lane, Real, Vec3};

/// The choices of the parameter `masking`, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Masking {
    /// Smith's masking, which is exact for the distribution, with correlated heights.
    Smith,
    /// Schlick's approximation.
    Schlick,
    /// Kelemen's approximation of [`Masking::CookTorrance`].
    Kelemen,
    /// V-shaped grooves.
    CookTorrance,
    /// The product of the cosines.
    Implicit,
}

impl Masking {
    /// All of them, in the order of the parameter's choices.
    pub const ALL: [Self; 5] = [
        Self::Smith,
        Self::Schlick,
        Self::Kelemen,
        Self::CookTorrance,
        Self::Implicit,
    ];

    /// [`Ndf::smith`] for [`Masking::Smith`], the only one that depends on the distribution; 0 for the
    /// others.
    #[inline(always)]
    pub fn of_ndf<T: Lane, N: Ndf<T>>(self, ndf: &N, pair: &HalfVector<T>) -> T {
        if self == Self::Smith {
            ndf.smith(pair)
        } else {
            T::new(0.0)
        }
    }

    /// G / (4 n.v), whose product with D and F is the value f(wo, wi) n.l. The formulas are simplified so
    /// that no product of cosines, which could underflow at the horizon, is left. The factors of
    /// [`Masking::Kelemen`] and [`Masking::CookTorrance`] are clamped to [`GREATEST`].
    #[inline(always)]
    pub fn factor<T: Lane>(self, smith: T, alpha: [T; 2], pair: &HalfVector<T>) -> T {
        let (one, quarter) = (T::new(1.0), T::new(0.25));
        let (nv, nl) = (pair.wo.z, pair.wi.z);
        let vh = pair.cos_half;
        match self {
            Self::Smith => smith,
            // G1 = n.v / (n.v (1 - k) + k), k = m sqrt(2 / pi): Schlick 1994, eq. 19, as in the lecture.
            Self::Schlick => {
                let toward = schlick_denominator(pair.wo, alpha);
                quarter * nl / (toward * schlick_denominator(pair.wi, alpha))
            }
            // G = (n.l)(n.v) / (v.h)^2: Kelemen and Szirmay-Kalos 2001, eq. 6.
            Self::Kelemen => (quarter * nl / vh / vh).min(T::new(GREATEST)),
            // G = min(1, 2 (n.h)(n.v) / (v.h), 2 (n.h)(n.l) / (v.h)): Cook and Torrance 1982, eq. 5.
            Self::CookTorrance => {
                let open = quarter / nv;
                let grooved = T::new(0.5) * pair.h().z * (nl / nv).min(one) / vh;
                open.min(grooved).min(T::new(GREATEST))
            }
            // G = (n.l)(n.v): the lecture's G_implicit.
            Self::Implicit => quarter * nl,
        }
    }

    /// G of a perfect mirror: the limit for alpha = 0.
    #[inline(always)]
    pub fn of_mirror<T: Real>(self, cos_theta: T) -> T {
        match self {
            Self::Implicit => cos_theta.squared(),
            _ => T::new(1.0),
        }
    }
}

/// n.v (1 - k) + k
#[inline(always)]
fn schlick_denominator<T: Real>(w: Vec3<T>, alpha: [T; 2]) -> T {
    let k = along(w, alpha) * T::new(std::f64::consts::FRAC_2_PI.sqrt());
    w.z * (T::new(1.0) - k) + k
}

/// The roughness along the azimuth of w: Heitz 2014, eq. 80.
#[inline(always)]
fn along<T: Real>(w: Vec3<T>, [x, y]: [T; 2]) -> T {
    let sine_squared = w.x.squared() + w.y.squared();
    let stretched = (w.x * x).squared() + (w.y * y).squared();
    let is_above = sine_squared.equals(T::new(0.0));
    let divisor = T::select(is_above, T::new(1.0), sine_squared);
    T::select(is_above, x, (stretched / divisor).sqrt())
}
