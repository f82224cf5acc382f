//! Reflectance and transmittance of plane layers between two half-spaces, at one wavelength.
//!
//! The tangential fields are propagated from the far half-space to the near one (Abeles 1950; Macleod,
//! "Thin-Film Optical Filters", section 2). With q = n cos theta in units of 2 pi / lambda and the
//! immittance w = q for s, q / n^2 for p (the ratio of the tangential fields: H over E, E over H), a layer
//! of thickness d maps the two fields (U, V), U = w V in the far half-space, by
//!
//! ```text
//! U' = c U + w s V         c = (1 + E) / 2        E = exp(2 i q d 2 pi / lambda)
//! V' = c V + (s / w) U     s = (1 - E) / 2
//! R  = |(w0 V - U) / (w0 V + U)|^2
//! T  = 4 w0 Re(w_far) prod |E| / |w0 V + U|^2
//! ```
//!
//! This is the characteristic matrix times exp(i q d 2 pi / lambda). With Im q >= 0 no exponential grows,
//! however thick and absorbing the layer is. Unlike the amplitudes r + r' E of a sum over reflections, U
//! and w0 V keep their digits for thin films at grazing angles, where r tends to -1. The quotient does not
//! depend on the scale of the fields, so large fields are scaled down.

use super::Complex;
pub(crate) use super::waves::{Crossing, round_trip_loss};
pub use super::waves::{Incidence, P, S, Slab, Wave};
use crate::num::{Mask, Real};

/// A value of |w0 V + U| below this counts as 0: cosine and film are both too small to reflect.
const VANISHED: f64 = 1e-37;
/// Fields greater than this are scaled to 1. Its square is within the range of single precision.
const LARGE: f64 = 1e12;
/// A layer of a stack.
#[derive(Clone, Copy, Debug)]
pub struct Layer<T> {
    /// Complex index.
    pub index: Complex<T>,
    /// Thickness >= 0, nm.
    pub thickness_nm: T,
}

/// Layers between an ambient medium and a base.
#[derive(Clone, Copy, Debug)]
pub struct Stack<'a, T> {
    /// Index of the ambient medium, which is transparent; >= 1.
    pub ambient: T,
    /// The layers; the first one is next to the ambient medium.
    pub layers: &'a [Layer<T>],
    /// Complex index of the base.
    pub base: Complex<T>,
}

/// The side that the light comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The light comes from the ambient medium.
    Ambient,
    /// The light comes from the base, in which it travels as if the extinction there were 0: how a wave decays on
    /// its way to the stack is no property of the stack. What that leaves out is of the order of k.
    Base,
}

/// Reflectance and transmittance: the fractions of the power that are reflected and that enter the far
/// half-space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<T> {
    /// R for s and p.
    pub reflectance: [T; 2],
    /// T for s and p. For an absorbing half-space this is the power that crosses its surface.
    pub transmittance: [T; 2],
}

impl<T: Real> Response<T> {
    /// R of unpolarised light.
    #[inline(always)]
    pub fn unpolarized_reflectance(&self) -> T {
        (self.reflectance[S] + self.reflectance[P]) * T::new(0.5)
    }

    /// T of unpolarised light.
    #[inline(always)]
    pub fn unpolarized_transmittance(&self) -> T {
        (self.transmittance[S] + self.transmittance[P]) * T::new(0.5)
    }

    /// A = 1 - R - T for s and p, the power that the layers absorb.
    #[inline(always)]
    pub fn absorptance(&self) -> [T; 2] {
        [S, P].map(|pol| T::new(1.0) - self.reflectance[pol] - self.transmittance[pol])
    }
}

impl<T: Real<Mask = bool>> Stack<'_, T> {
    /// The response to a plane wave whose direction has the cosine `cos_theta`, in [0, 1], in the
    /// half-space that it comes from, at a vacuum wavelength in nm. At total internal reflection and at
    /// cosine 0, R = 1; if all media have the same index, R = 0 at every cosine.
    ///
    /// These hold exactly: a layer of thickness 0 has no effect, neighbours of equal index act as one
    /// layer, and a layer with the index of the half-space beside it does not change the reflectance.
    pub fn respond(&self, side: Side, cos_theta: T, wavelength_nm: T) -> Response<T> {
        self.respond_with_poles(side, cos_theta, wavelength_nm).0
    }

    /// The response and, for s and p, the denominators w0 V + U. They are smooth functions of the
    /// wavelength, and small near resonances.
    pub(super) fn respond_with_poles(
        &self,
        side: Side,
        cos_theta: T,
        wavelength_nm: T,
    ) -> (Response<T>, [Complex<T>; 2]) {
        let layers = self.layers.iter().copied();
        let ambient = Complex::real(self.ambient);
        match side {
            Side::Ambient => {
                let incidence = Incidence::new(self.ambient, cos_theta);
                cross(incidence, layers.rev(), self.base, wavelength_nm)
            }
            Side::Base => {
                let incidence = Incidence::new(self.base.re, cos_theta);
                cross(incidence, layers, ambient, wavelength_nm)
            }
        }
    }
}

/// Propagates the fields through layers, given in the order from the far half-space to the near one.
#[inline(always)]
fn cross<T: Real<Mask = bool>>(
    near: Incidence<T>,
    layers: impl Iterator<Item = Layer<T>>,
    far: Complex<T>,
    wavelength_nm: T,
) -> (Response<T>, [Complex<T>; 2]) {
    let far_wave = near.wave(far);
    let mut fields = [S, P].map(|pol| Fields::behind(&far_wave, pol));
    // The medium that the fields have reached, and the thickness of it that has not been crossed yet.
    let mut reached = Layer {
        index: far,
        thickness_nm: T::new(0.0),
    };
    let mut is_far = true;
    let mut cross_reached = |reached: Layer<T>, is_far: bool| {
        let slab = Slab::new(
            &near.wave(reached.index),
            reached.thickness_nm,
            wavelength_nm,
        );
        for (pol, fields) in fields.iter_mut().enumerate() {
            *fields = if is_far {
                fields.weakened(&slab)
            } else {
                fields.through(&slab, pol)
            };
        }
    };
    for layer in layers.filter(|layer| layer.thickness_nm.gt(T::new(0.0))) {
        if layer.index.equals(reached.index) {
            reached.thickness_nm = reached.thickness_nm + layer.thickness_nm;
        } else {
            if reached.thickness_nm.gt(T::new(0.0)) {
                cross_reached(reached, is_far);
            }
            (reached, is_far) = (layer, false);
        }
    }
    // A layer with the index of the near half-space only changes the phase of the wave.
    let is_near = reached.index.equals(Complex::real(near.index));
    if !is_near && reached.thickness_nm.gt(T::new(0.0)) {
        cross_reached(reached, is_far);
    }
    let near_immittance = near.immittance();
    let ends = [S, P].map(|pol| fields[pol].meet(near_immittance[pol], far_wave.immittance[pol]));
    let response = Response {
        reflectance: [ends[S].reflectance, ends[P].reflectance],
        transmittance: [ends[S].transmittance, ends[P].transmittance],
    };
    (response, [ends[S].pole, ends[P].pole])
}

/// The tangential fields of one polarisation, up to a common factor.
#[derive(Clone, Copy, Debug)]
pub struct Fields<T> {
    pub(super) u: Complex<T>,
    pub(super) v: Complex<T>,
    /// The product of |E| over the layers crossed, times the square of `scale`.
    pub(super) weight: T,
    /// The product of all factors that the fields were scaled by.
    scale: T,
}

/// R, T and w0 V + U of one polarisation.
pub(super) struct End<T> {
    pub(super) reflectance: T,
    pub(super) transmittance: T,
    pole: Complex<T>,
}

impl<T: Real> Fields<T> {
    /// The fields at the surface of the far half-space, from which no wave returns: U = w V.
    #[inline(always)]
    pub fn behind(far: &Wave<T>, pol: usize) -> Self {
        let one = T::new(1.0);
        Self {
            u: far.immittance[pol],
            v: Complex::real(one),
            weight: one,
            scale: one,
        }
    }

    /// The fields after a layer with the index of the far half-space, which only weakens the wave.
    #[inline(always)]
    fn weakened(self, slab: &Slab<T>) -> Self {
        Self {
            weight: self.weight * slab.decay,
            ..self
        }
    }

    /// The fields after a layer.
    #[inline(always)]
    pub fn through(self, slab: &Slab<T>, pol: usize) -> Self {
        let (u, v) = slab.carry(pol, self.u, self.v);
        let fields = Self {
            u,
            v,
            weight: self.weight * slab.decay,
            scale: self.scale,
        };
        let magnitude = fields.u.magnitude().max(fields.v.magnitude());
        let is_large = magnitude.gt(T::new(LARGE));
        if !is_large.any() {
            return fields;
        }
        let one = T::new(1.0);
        let scale = one / T::select(is_large, magnitude, one);
        Self {
            u: fields.u.scaled(scale),
            v: fields.v.scaled(scale),
            weight: fields.weight * scale * scale,
            scale: fields.scale * scale,
        }
    }

    /// R at the surface of the near half-space with the immittance `near`, and T into the far half-space
    /// with the immittance `far`.
    #[inline(always)]
    pub(super) fn meet(&self, near: T, far: Complex<T>) -> End<T> {
        let (zero, one) = (T::new(0.0), T::new(1.0));
        let incident = self.v.scaled(near) + self.u;
        let reflected = self.v.scaled(near) - self.u;
        let magnitude = incident.magnitude();
        let vanished = magnitude.lt(T::new(VANISHED));
        let inverse = one / T::select(vanished, one, magnitude);
        let norm = incident.scaled(inverse).norm_squared();
        let norm = T::select(vanished, one, norm);
        let reflectance = reflected.scaled(inverse).norm_squared() / norm;
        let flux = (near * inverse) * (far.re * inverse);
        let transmittance = T::new(4.0) * self.weight * flux / norm;
        End {
            reflectance: T::select(vanished, zero, reflectance),
            transmittance: T::select(vanished, one, transmittance),
            pole: incident.scaled(one / self.scale),
        }
    }
}
