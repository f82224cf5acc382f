//! A plane wave in the media of a stack, and the matrix of a layer that it crosses.
//!
//! The symbols are those of [`stack`](super::stack).

use super::Complex;
use crate::num::{Mask, PI, Real};

/// Index of the s polarisation (E parallel to the layers) in pairs.
pub const S: usize = 0;
/// Index of the p polarisation (H parallel to the layers) in pairs.
pub const P: usize = 1;

/// A |q|^2 below this counts as q = 0, the critical angle, in s / q.
const CRITICAL: f64 = 1e-30;

/// A plane wave that arrives in the near half-space.
#[derive(Clone, Copy, Debug)]
pub struct Incidence<T> {
    pub(super) index: T,
    /// n0 cos theta.
    normal: T,
    /// cos theta / n0.
    normal_over_permittivity: T,
}

impl<T: Real> Incidence<T> {
    /// A wave in a medium of real index, at a cosine in [0, 1].
    #[inline(always)]
    pub fn new(index: T, cos_theta: T) -> Self {
        Self {
            index,
            normal: index * cos_theta,
            normal_over_permittivity: cos_theta / index,
        }
    }

    /// w for s and p.
    #[inline(always)]
    pub fn immittance(&self) -> [T; 2] {
        [self.normal, self.normal_over_permittivity]
    }

    /// The wave with the same tangential wave vector in a medium of complex index.
    ///
    /// q^2 = n^2 - n0^2 sin^2 = (n - n0)(n + n0) + (n0 cos)^2, which has no cancellation at grazing angles.
    /// Im q >= 0, so that the wave decays away from the light, both in absorbing media and beyond the
    /// critical angle.
    #[inline(always)]
    pub fn wave(&self, index: Complex<T>) -> Wave<T> {
        let near = Complex::real(self.index);
        let difference = (index - near) * (index + near);
        let q_squared = difference + Complex::real(self.normal.squared());
        let is_near = index.equals(near);
        let (re, zero) = (q_squared.re, T::new(0.0));
        // Without absorption the root is real or imaginary: the same number in a third of the time.
        let root = if (!q_squared.im.equals(zero)).any() {
            q_squared.sqrt_upper()
        } else {
            let (root, is_beyond) = (re.abs().sqrt(), re.lt(zero));
            Complex::new(
                T::select(is_beyond, zero, root),
                T::select(is_beyond, root, zero),
            )
        };
        // The root of a square may be off by an ulp, and the square may underflow.
        let q = Complex::select(is_near, Complex::real(self.normal), root);
        let ratio = q * (index * index).inverse();
        let near_ratio = Complex::real(self.normal_over_permittivity);
        Wave {
            index,
            immittance: [q, Complex::select(is_near, near_ratio, ratio)],
        }
    }
}

/// A plane wave in one medium.
#[derive(Clone, Copy, Debug)]
pub struct Wave<T> {
    pub(super) index: Complex<T>,
    /// w for s and p; for s it is q itself.
    pub immittance: [Complex<T>; 2],
}

/// c, s and s / q of a layer, with E = exp(2 i q d 2 pi / lambda).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing<T> {
    /// sqrt(E / |E|): the phase that a wave gains on one crossing.
    pub phase: Complex<T>,
    /// (1 + E) / 2.
    pub cosine: Complex<T>,
    /// (1 - E) / 2.
    pub sine: Complex<T>,
    /// s / q, which tends to -2 pi i d / lambda at the critical angle.
    pub sine_over_q: Complex<T>,
    /// |E|.
    pub decay: T,
}

impl<T: Real> Crossing<T> {
    /// The crossing of a layer whose thickness is given in vacuum wavelengths. 1 - E is a sum of terms that
    /// keep their digits near E = 1.
    #[inline(always)]
    pub fn new(q: Complex<T>, thickness: T) -> Self {
        let (half, one) = (T::new(0.5), T::new(1.0));
        let half_turns = q.re * thickness;
        let (sin, cos) = (half_turns.sin_turns(), half_turns.cos_turns());
        let loss = round_trip_loss(q, thickness);
        let decay = one - loss;
        let sine = Complex::new(loss * half + decay * sin.squared(), -(decay * sin * cos));
        let is_critical = q.norm_squared().lt(T::new(CRITICAL));
        let safe = Complex::select(is_critical, Complex::real(one), q);
        let limit = Complex::new(T::new(0.0), -(thickness * T::new(2.0 * PI)));
        Self {
            phase: Complex::new(cos, sin),
            cosine: Complex::real(one) - sine,
            sine,
            sine_over_q: Complex::select(is_critical, limit, sine * safe.inverse()),
            decay,
        }
    }
}

/// 1 - |E| for a thickness in vacuum wavelengths. The exponential is skipped where no lane absorbs.
#[inline(always)]
pub(crate) fn round_trip_loss<T: Real>(q: Complex<T>, thickness: T) -> T {
    let b = q.im * thickness * T::new(4.0 * PI);
    let absorbs = b.gt(T::new(0.0)).any();
    if absorbs { -(-b).exp_m1() } else { T::new(0.0) }
}

/// The matrix of a layer, for s and p.
#[derive(Clone, Copy, Debug)]
pub struct Slab<T> {
    /// c = (1 + E) / 2.
    cosine: Complex<T>,
    /// w s for s and p.
    forth: [Complex<T>; 2],
    /// s / w for s and p.
    back: [Complex<T>; 2],
    /// sqrt(E / |E|).
    pub(super) phase: Complex<T>,
    /// |E|, the factor of the power on a crossing.
    pub(crate) decay: T,
}

impl<T: Real> Slab<T> {
    /// (U, V) on the near side of the layer for (U, V) on its far side.
    #[inline(always)]
    pub(crate) fn carry(
        &self,
        pol: usize,
        u: Complex<T>,
        v: Complex<T>,
    ) -> (Complex<T>, Complex<T>) {
        (
            self.cosine * u + self.forth[pol] * v,
            self.cosine * v + self.back[pol] * u,
        )
    }

    /// E = c - s, the determinant of the matrix.
    #[inline(always)]
    pub(crate) fn round_trip(&self) -> Complex<T> {
        self.cosine + self.cosine - Complex::real(T::new(1.0))
    }

    /// The matrix of a layer of that thickness for a wave in its medium.
    #[inline(always)]
    pub fn new(wave: &Wave<T>, thickness_nm: T, wavelength_nm: T) -> Self {
        Self::in_wavelengths(wave, thickness_nm / wavelength_nm)
    }

    /// [`Slab::new`], of a thickness in vacuum wavelengths.
    #[inline(always)]
    pub(crate) fn in_wavelengths(wave: &Wave<T>, thickness: T) -> Self {
        let crossing = Crossing::new(wave.immittance[S], thickness);
        let permittivity = wave.index * wave.index;
        Self {
            phase: crossing.phase,
            cosine: crossing.cosine,
            forth: [
                wave.immittance[S] * crossing.sine,
                wave.immittance[P] * crossing.sine,
            ],
            back: [crossing.sine_over_q, crossing.sine_over_q * permittivity],
            decay: crossing.decay,
        }
    }
}
