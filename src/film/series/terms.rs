//! What a stack is to one of its layers: the factors of the series over that layer's round trips.

use crate::num::{F64x4, Real, angle_turns};
use crate::optics::Complex;
use crate::optics::stack::{Incidence, P, S, Side, Slab};

/// The media of a stack at some wavenumbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Media<'a> {
    pub side: Side,
    /// Ambient, layers, base.
    pub indices: &'a [Complex<F64x4>],
    /// Least and greatest thickness of each layer.
    pub ranges: &'a [[f64; 2]],
    /// The layer whose round trips are counted; none: there is no layer.
    pub summed: Option<usize>,
}

/// What does not depend on the thickness of the summed layer, for one polarisation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms {
    pub top: Complex<F64x4>,
    pub g: Complex<F64x4>,
    pub h: Complex<F64x4>,
    /// T without interference and damping, times 1 - |g|^2.
    pub through: F64x4,
    /// ln |g|, and the angle of -g in turns.
    pub ln_g: F64x4,
    pub turn: F64x4,
}

impl Media<'_> {
    /// The terms of s and p, and 2 q of the summed layer.
    #[inline(always)]
    pub(super) fn terms(&self, cos_theta: f64, sigma: F64x4) -> ([Terms; 2], Complex<F64x4>) {
        let (zero, one) = (F64x4::new(0.0), F64x4::new(1.0));
        let last = self.indices.len() - 1;
        // Media from the light onwards.
        let medium = |i: usize| match self.side {
            Side::Ambient => self.indices[i],
            Side::Base => self.indices[last - i],
        };
        let summed = self.summed.map_or(last, |layer| match self.side {
            Side::Ambient => layer + 1,
            Side::Base => last - 1 - layer,
        });
        let near = Incidence::new(medium(0).re, F64x4::new(cos_theta));
        let far = near.wave(medium(last));
        let inside = near.wave(medium(summed));
        let wavelength_nm = one / sigma;
        let slab = |i: usize| {
            let layer = match self.side {
                Side::Ambient => i - 1,
                Side::Base => last - 1 - i,
            };
            let thickness_nm = F64x4::new(self.ranges[layer][0]);
            Slab::new(&near.wave(medium(i)), thickness_nm, wavelength_nm)
        };
        let near_w = near.immittance();
        let real = Complex::real;
        // The layers below the summed one, from the far half-space.
        let [s, p] = far.immittance;
        let mut below = [(s, real(one)), (p, real(one))];
        let mut decay = one;
        for i in (summed + 1..last).rev() {
            let cross = slab(i);
            for (pol, (u, v)) in below.iter_mut().enumerate() {
                (*u, *v) = cross.carry(pol, *u, *v);
            }
            decay = decay * cross.decay;
        }
        // The layers above it, as a matrix per polarisation: images of (1, 0) and (0, 1).
        let mut above = [[(real(one), real(zero)), (real(zero), real(one))]; 2];
        let mut determinant = real(one);
        for i in (1..summed.min(last)).rev() {
            let cross = slab(i);
            for (pol, columns) in above.iter_mut().enumerate() {
                for (u, v) in columns {
                    (*u, *v) = cross.carry(pol, *u, *v);
                }
            }
            decay = decay * cross.decay;
            determinant = determinant * cross.round_trip();
        }
        let both = |pol: usize| Outside {
            near: real(near_w[pol]),
            far: far.immittance[pol].re,
            below: below[pol],
            above: above[pol],
            determinant,
            decay,
        };
        let both = [
            both(S).terms(inside.immittance[S]),
            both(P).terms(inside.immittance[P]),
        ];
        let round = if summed == last {
            real(zero)
        } else {
            inside.immittance[S].scaled(F64x4::new(2.0))
        };
        (both, round)
    }
}

/// What surrounds the summed layer, for one polarisation.
struct Outside {
    /// w of both half-spaces.
    near: Complex<F64x4>,
    far: F64x4,
    /// The fields below it.
    below: (Complex<F64x4>, Complex<F64x4>),
    /// What the layers above it make of the fields (1, 0) and (0, 1).
    above: [(Complex<F64x4>, Complex<F64x4>); 2],
    /// E of all layers above it, and |E| of all but itself.
    determinant: Complex<F64x4>,
    decay: F64x4,
}

impl Outside {
    /// `w1`: of the summed layer.
    #[inline(always)]
    fn terms(&self, w1: Complex<F64x4>) -> Terms {
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
        Terms {
            top: (p - q) * inverse,
            g,
            h: h.scaled(F64x4::new(4.0)),
            through: flux * self.decay / forward.norm_squared().max(least),
            ln_g: g.norm_squared().max(least).ln() * F64x4::new(0.5),
            turn: angle_turns(-g.im, -g.re),
        }
    }
}

/// 1 / z; 0 for 0.
#[inline(always)]
pub(super) fn safe_inverse(z: Complex<F64x4>) -> Complex<F64x4> {
    let (zero, one) = (F64x4::new(0.0), F64x4::new(1.0));
    let is_zero = z.norm_squared().lt(F64x4::new(f64::MIN_POSITIVE));
    let inverse = Complex::select(is_zero, Complex::real(one), z).inverse();
    Complex::select(is_zero, Complex::real(zero), inverse)
}
