//! The amplitudes of the multiple-beam series in one layer of a stack, for any layers around it.

use crate::num::{F64x4, Real, angle_turns};
use crate::optics::Complex;
use crate::optics::stack::{Incidence, P, S, Side, Slab};

/// A stack at four wavenumbers, and the side that the light comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct StackMedia<'a> {
    pub side: Side,
    /// Complex indices of the ambient, the layers and the base.
    pub indices: &'a [Complex<F64x4>],
    /// Least and greatest thickness of each layer, nm.
    pub ranges: &'a [[f64; 2]],
    /// The layer whose beams are summed; `None` if there is no layer.
    pub summed: Option<usize>,
}

/// The amplitudes of the series for one polarisation, without the summed layer's damping: they do not
/// depend on its thickness.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BeamTerms {
    /// r_top of [`FringeSeries`](super::series::FringeSeries).
    pub top: Complex<F64x4>,
    pub g: Complex<F64x4>,
    pub h: Complex<F64x4>,
    /// T without interference and damping, times 1 - |g|^2.
    pub through: F64x4,
    /// ln |g|, and the angle of -g in turns.
    pub ln_g: F64x4,
    pub turn: F64x4,
    /// The denominators of r_top and of the reflection at the layers below: both are small near a resonance.
    pub denominators: [Complex<F64x4>; 2],
}

// Functions and not closures: those are compiled without the lanes' instructions where they are not inlined.
impl StackMedia<'_> {
    /// Medium i, counted from the side of the light.
    #[inline(always)]
    fn medium(&self, i: usize) -> Complex<F64x4> {
        match self.side {
            Side::Ambient => self.indices[i],
            Side::Base => self.indices[self.indices.len() - 1 - i],
        }
    }

    /// The layer that is medium i.
    #[inline(always)]
    fn slab(&self, near: Incidence<F64x4>, i: usize, wavelength_nm: F64x4) -> Slab<F64x4> {
        let layer = match self.side {
            Side::Ambient => i - 1,
            Side::Base => self.indices.len() - 2 - i,
        };
        let thickness_nm = F64x4::new(self.ranges[layer][0]);
        Slab::new(&near.wave(self.medium(i)), thickness_nm, wavelength_nm)
    }

    /// The terms for s and p at a cosine on the side of the light, and 2 q of the summed layer.
    #[inline(always)]
    pub(super) fn terms(&self, cos_theta: f64, sigma: F64x4) -> ([BeamTerms; 2], Complex<F64x4>) {
        let (zero, one) = (F64x4::new(0.0), F64x4::new(1.0));
        let last = self.indices.len() - 1;
        let summed = self.summed.map_or(last, |layer| match self.side {
            Side::Ambient => layer + 1,
            Side::Base => last - 1 - layer,
        });
        let near = Incidence::new(self.medium(0).re, F64x4::new(cos_theta));
        let far = near.wave(self.medium(last));
        let inside = near.wave(self.medium(summed));
        let wavelength_nm = one / sigma;
        let near_w = near.immittance();
        let real = Complex::real;
        // The fields below the summed layer, carried there from the far half-space.
        let [s, p] = far.immittance;
        let mut below = [(s, real(one)), (p, real(one))];
        let mut decay = one;
        for i in (summed + 1..last).rev() {
            let cross = self.slab(near, i, wavelength_nm);
            for (pol, (u, v)) in below.iter_mut().enumerate() {
                (*u, *v) = cross.carry(pol, *u, *v);
            }
            decay = decay * cross.decay;
        }
        // The layers above it as a matrix per polarisation, whose columns are the images of (1, 0) and (0,
        // 1).
        let mut above = [[(real(one), real(zero)), (real(zero), real(one))]; 2];
        let mut determinant = real(one);
        for i in (1..summed.min(last)).rev() {
            let cross = self.slab(near, i, wavelength_nm);
            for (pol, columns) in above.iter_mut().enumerate() {
                for (u, v) in columns {
                    (*u, *v) = cross.carry(pol, *u, *v);
                }
            }
            decay = decay * cross.decay;
            determinant = determinant * cross.round_trip();
        }
        let around = |pol: usize| Surroundings {
            near: real(near_w[pol]),
            far: far.immittance[pol].re,
            below: below[pol],
            above: above[pol],
            determinant,
            decay,
        };
        let terms = [
            around(S).terms(inside.immittance[S]),
            around(P).terms(inside.immittance[P]),
        ];
        let round = if summed == last {
            real(zero)
        } else {
            inside.immittance[S].scaled(F64x4::new(2.0))
        };
        (terms, round)
    }
}

/// The media around the summed layer, for one polarisation; w is the immittance of
/// [`stack`](crate::optics::stack).
struct Surroundings {
    /// w of the near half-space.
    near: Complex<F64x4>,
    /// Re w of the far half-space.
    far: F64x4,
    /// The tangential fields (U, V) below the summed layer.
    below: (Complex<F64x4>, Complex<F64x4>),
    /// The matrix of the layers above it: the images of the fields (1, 0) and (0, 1).
    above: [(Complex<F64x4>, Complex<F64x4>); 2],
    /// The product of E of all layers above it.
    determinant: Complex<F64x4>,
    /// The product of |E| of all layers but the summed one.
    decay: F64x4,
}

impl Surroundings {
    /// The terms for w of the summed layer.
    #[inline(always)]
    fn terms(&self, w1: Complex<F64x4>) -> BeamTerms {
        let w0 = self.near;
        let (u2, v2) = self.below;
        let [(a, c), (b, d)] = self.above;
        let (p, q) = (w0 * (c * w1 + d), a * w1 + b);
        let (p1, q1) = (w0 * (d - c * w1), b - a * w1);
        let inverse = safe_inverse(p + q);
        let sum = w1 * v2 + u2;
        let bottom = (w1 * v2 - u2) * safe_inverse(sum);
        let g = (p1 + q1) * inverse * bottom;
        let h = w0 * w1 * self.determinant * inverse * inverse * bottom;
        // 4 w0 Re(w far) |E| / |(w1 v2 + u2) / (2 w1) (p + q)|^2
        let forward = (sum * safe_inverse(w1)).scaled(F64x4::new(0.5)) * (p + q);
        let flux = F64x4::new(4.0) * w0.re * self.far;
        let least = F64x4::new(f64::MIN_POSITIVE);
        BeamTerms {
            top: (p - q) * inverse,
            g,
            h: h.scaled(F64x4::new(4.0)),
            through: flux * self.decay / forward.norm_squared().max(least),
            ln_g: g.norm_squared().max(least).ln() * F64x4::new(0.5),
            turn: angle_turns(-g.im, -g.re),
            denominators: [p + q, sum],
        }
    }
}

/// 1 / z, and 0 for z = 0.
#[inline(always)]
pub(super) fn safe_inverse(z: Complex<F64x4>) -> Complex<F64x4> {
    let (zero, one) = (F64x4::new(0.0), F64x4::new(1.0));
    let is_zero = z.norm_squared().lt(F64x4::new(f64::MIN_POSITIVE));
    let inverse = Complex::select(is_zero, Complex::real(one), z).inverse();
    Complex::select(is_zero, Complex::real(zero), inverse)
}
