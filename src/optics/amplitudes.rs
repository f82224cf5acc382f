//! Complex amplitudes of plane layers between two half-spaces, for light whose polarisation matters.
//!
//! The fields are those of [`stack`](super::stack), whose symbols are used here. They are ours times
//! prod exp(i q d 2 pi / lambda), so that with V = 1 in the far half-space
//!
//! ```text
//! r   = (w0 V - U) / (w0 V + U)
//! t_s = 2 w0 prod exp(i q d 2 pi / lambda) / (w0 V + U)
//! t_p = (n0 / n_far) times the same: V is H there, and |H| = n |E|
//! ```
//!
//! Signs, phases and the time factor exp(-i omega t) are those of Byrnes, "Multilayer optical calculations"
//! (arXiv:1603.02720, eqs. 4 to 6 and 10 to 18) and of his Python package tmm: r_p = -r_s at normal incidence.

use super::Complex;
use super::stack::{Fields, Incidence, P, Response, S, Slab, Wave};
use crate::num::Real;

/// Thicker layers count as this thick, in vacuum wavelengths. Beyond 2^50 turns double precision has no digits of the
/// phase left, and the lanes' sine and cosine end; |q| is at most 1.5e3.
const THICKEST: f64 = 5e11;

/// Ratios of the electric fields of reflected and transmitted light to that of the incident light, with
/// their phases: reflected light at the first surface of the stack, transmitted light at the last.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Amplitudes<T> {
    /// r for s and p; |r|^2 = R.
    pub reflection: [Complex<T>; 2],
    /// t for s and p, just behind the last surface. With the indices n and the cosines c of the two
    /// half-spaces, T = |t|^2 Re(n c) / (n0 c0) for s and |t|^2 Re(n c*) / (n0 c0) for p.
    pub transmission: [Complex<T>; 2],
}

/// The fields on their way from the far half-space to the near one, in double precision or lanes of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Propagation<T> {
    near: Incidence<T>,
    far: Wave<T>,
    /// 1 / wavelength, per nm.
    wavenumber: T,
    fields: [Fields<T>; 2],
    /// The product of sqrt(E / |E|) over the layers crossed.
    phase: Complex<T>,
}

impl<T: Real> Propagation<T> {
    /// The fields at the surface of the far half-space.
    #[inline(always)]
    pub fn new(near: Incidence<T>, far: Complex<T>, wavelength_nm: T) -> Self {
        let far = near.wave(far);
        Self {
            near,
            far,
            wavenumber: T::new(1.0) / wavelength_nm,
            fields: [Fields::behind(&far, S), Fields::behind(&far, P)],
            phase: Complex::real(T::new(1.0)),
        }
    }

    /// The wave in a layer of that index, for [`Propagation::cross`].
    #[inline(always)]
    pub fn wave(&self, index: Complex<T>) -> Wave<T> {
        self.near.wave(index)
    }

    /// The fields on the near side of a layer. One of thickness 0 changes nothing.
    #[inline(always)]
    pub fn cross(&mut self, wave: &Wave<T>, thickness_nm: T) {
        let thickness = (thickness_nm * self.wavenumber).min(T::new(THICKEST));
        let slab = Slab::in_wavelengths(wave, thickness);
        self.fields = [
            self.fields[S].through(&slab, S),
            self.fields[P].through(&slab, P),
        ];
        self.phase = self.phase * slab.phase;
    }

    /// r and t, when every layer has been crossed.
    #[inline(always)]
    pub fn amplitudes(&self) -> Amplitudes<T> {
        let near = self.near.immittance();
        let s = meet(&self.fields[S], near[S], self.phase);
        let p = meet(&self.fields[P], near[P], self.phase);
        let ratio = self.far.index.inverse().scaled(self.near.index);
        Amplitudes {
            reflection: [s[0], p[0]],
            transmission: [s[1], p[1] * ratio],
        }
    }

    /// R and T, when every layer has been crossed.
    #[inline(always)]
    pub fn response(&self) -> Response<T> {
        let near = self.near.immittance();
        let s = self.fields[S].meet(near[S], self.far.immittance[S]);
        let p = self.fields[P].meet(near[P], self.far.immittance[P]);
        Response {
            reflectance: [s.reflectance, p.reflectance],
            transmittance: [s.transmittance, p.transmittance],
        }
    }
}

/// The ratios V_reflected / V_incident and V_far / V_incident. |w0 V + U|^2 is within the range of double
/// precision: fields are at most 1e12, and cosines at least 1e-9.
#[inline(always)]
fn meet<T: Real>(fields: &Fields<T>, near: T, phase: Complex<T>) -> [Complex<T>; 2] {
    let forth = fields.v.scaled(near);
    let inverse = (forth + fields.u).inverse();
    let crossed = T::new(2.0) * near * fields.weight.sqrt();
    [
        (forth - fields.u) * inverse,
        (phase * inverse).scaled(crossed),
    ]
}
