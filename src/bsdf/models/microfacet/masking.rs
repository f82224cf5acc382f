//! Masking and shadowing, the factor G: which part of the facets both directions see.

use super::distribution::{GREATEST, Normals};
use crate::num::{Lane, Real, Vec3};

/// The choices of the parameter `masking`, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Masking {
    /// Exact for the distribution, heights correlated.
    Smith,
    /// Rational in the cosines.
    Schlick,
    /// Kelemen's approximation of [`Masking::CookTorrance`].
    Kelemen,
    /// V-shaped grooves.
    CookTorrance,
    /// The product of the cosines.
    Implicit,
}

/// Two directions and what lies between them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair<T> {
    /// To the viewer.
    pub wo: Vec3<T>,
    /// To the light.
    pub wi: Vec3<T>,
    /// A vector along the half vector h, whose largest component is 1 in magnitude.
    pub sum: Vec3<T>,
    /// The length of `sum`, and its square.
    pub length: T,
    pub length_squared: T,
    /// <wo, h> = <wi, h>, in (0, 1].
    pub cos_half: T,
}

impl<T: Real> Pair<T> {
    /// Of two directions with z > 0. The sum is divided by its largest component before its length
    /// is taken, since along the surface both may be as small as numbers can be. Sums of nearly
    /// opposite components are exact, so h keeps its digits where a narrow lobe needs them. For unit
    /// vectors <wo, h> is half the length of the sum, which is never 0.
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

    /// The half vector, unit.
    #[inline(always)]
    pub fn h(&self) -> Vec3<T> {
        let mut h = self.sum.scaled(T::new(1.0) / self.length);
        h.z = h.z.max(T::new(LEAST_NORMAL));
        h
    }

    /// With all directions turned about +Z by the angle of the given cosine and sine.
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

/// The direction turned about +Z by the angle of the given cosine and sine.
#[inline(always)]
pub(super) fn turned<T: Real>(w: Vec3<T>, [cos, sin]: [T; 2]) -> Vec3<T> {
    Vec3::new(w.x * cos - w.y * sin, w.x * sin + w.y * cos, w.z)
}

/// The least number whose inverse is one in single precision, but for rounding.
const LEAST_SUM: f64 = 1.2e-38;

/// Half vectors are at least this high: it changes none above the horizon's last 1e-30, and lets
/// distributions take their logarithm.
const LEAST_NORMAL: f64 = 1e-30;

impl Masking {
    /// In the order of the parameter's choices.
    pub const ALL: [Self; 5] = [
        Self::Smith,
        Self::Schlick,
        Self::Kelemen,
        Self::CookTorrance,
        Self::Implicit,
    ];

    /// [`Normals::smith`], where it is asked for: all that masking needs of the distribution.
    #[inline(always)]
    pub fn of_normals<T: Lane, N: Normals<T>>(self, normals: &N, pair: &Pair<T>) -> T {
        if self == Self::Smith {
            normals.smith(pair)
        } else {
            T::new(0.0)
        }
    }

    /// G / (4 n.v), which times D and F is the value f(wo, wi) n.l: the cosines of the definition are
    /// cancelled on paper, because their products vanish in rounding at the horizon. Those of
    /// [`Masking::Kelemen`] and [`Masking::CookTorrance`] are held at [`GREATEST`].
    #[inline(always)]
    pub fn factor<T: Lane>(self, smith: T, alpha: [T; 2], pair: &Pair<T>) -> T {
        let (one, quarter) = (T::new(1.0), T::new(0.25));
        let (nv, nl) = (pair.wo.z, pair.wi.z);
        let vh = pair.cos_half;
        match self {
            Self::Smith => smith,
            // G1 = n.v / (n.v (1 - k) + k), k = m sqrt(2 / pi): Schlick 1994, eq. 19, as the lecture
            // prints it.
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

    /// G of a perfect mirror, the limit for alpha = 0.
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
