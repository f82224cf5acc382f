//! Single wavelengths of a film, by full wave optics: amplitudes, reflectance and transmittance. They need
//! no tables and allocate nothing.
//!
//! A lane is one wavelength of one element, so that four wavelengths of a call, or of the elements of a
//! batch, are evaluated side by side. Lanes do not depend on each other: a batch finds the bits of single
//! calls.

use super::film::{Film, LEAST_COSINE};
use super::repeated_media::KEPT;
use crate::error::Error;
use crate::num::{F64x4, Real, widest};
use crate::optics::stack::{Incidence, Response, Side, Wave};
use crate::optics::{Amplitudes, Complex, Propagation};

type LaneMask = <F64x4 as Real>::Mask;

/// Cosines, thicknesses (nm) and wavelengths (nm) of four rays.
type FourRays = [[f64; F64x4::COUNT]; 3];
/// Real and imaginary parts of r_s, r_p, t_s and t_p.
type FourAmplitudes = [[f64; F64x4::COUNT]; 8];
/// R_s, R_p, T_s and T_p.
type FourResponses = [[f64; F64x4::COUNT]; 4];

/// What a lane is about.
#[derive(Clone, Copy)]
pub(crate) struct Ray {
    pub cos_theta: f64,
    pub thickness_nm: f64,
    pub wavelength_nm: f64,
}

impl Film {
    /// Complex r_s, r_p, t_s and t_p at vacuum wavelengths (nm, > 0), written to the elements of
    /// `found`. `cos_theta` and `thickness_nm` are as for [`Film::colors`], whose `transmittance` the
    /// description need not ask for. All is 0 from an opaque base, and for NaN.
    ///
    /// # Errors
    /// `OutOfRange` (a wavelength), `InvalidArgument` (`found` has not the length of `lambda_nm`); `found` is
    /// then as it was.
    pub fn amplitudes(
        &self,
        side: Side,
        cos_theta: f64,
        thickness_nm: f64,
        lambda_nm: &[f64],
        found: &mut [Amplitudes<f64>],
    ) -> Result<(), Error> {
        check(self, lambda_nm, found)?;
        let ray = rays(cos_theta, thickness_nm, lambda_nm);
        self.each_amplitudes(
            side,
            lambda_nm.len(),
            ray,
            |x| x,
            |i, value| found[i] = value,
        );
        Ok(())
    }

    /// Reflectance and transmittance at vacuum wavelengths, for s and p; otherwise as
    /// [`Film::amplitudes`].
    ///
    /// # Errors
    /// As for [`Film::amplitudes`].
    pub fn responses(
        &self,
        side: Side,
        cos_theta: f64,
        thickness_nm: f64,
        lambda_nm: &[f64],
        found: &mut [Response<f64>],
    ) -> Result<(), Error> {
        check(self, lambda_nm, found)?;
        let ray = rays(cos_theta, thickness_nm, lambda_nm);
        self.each_response(side, lambda_nm.len(), ray, |i, value| found[i] = value);
        Ok(())
    }

    /// The amplitudes of `count` rays, rounded. Rays are asked for, and amplitudes found, in order and once each.
    #[inline(always)]
    pub(crate) fn each_amplitudes<T: Real>(
        &self,
        side: Side,
        count: usize,
        ray: impl FnMut(usize) -> Ray,
        round: impl Fn(f64) -> T + Copy,
        mut found: impl FnMut(usize, Amplitudes<T>),
    ) {
        let solve = |rays: &FourRays| self.four_amplitudes(side, rays).map(|row| row.map(round));
        each_four(count, ray, solve, |i, lane, solved| {
            let part = |at: usize| Complex::new(solved[at][lane], solved[at + 1][lane]);
            let value = Amplitudes {
                reflection: [part(0), part(2)],
                transmission: [part(4), part(6)],
            };
            found(i, value);
        });
    }

    /// The responses to `count` rays, as in [`Film::each_amplitudes`].
    #[inline(always)]
    pub(crate) fn each_response(
        &self,
        side: Side,
        count: usize,
        ray: impl FnMut(usize) -> Ray,
        mut found: impl FnMut(usize, Response<f64>),
    ) {
        let solve = |rays: &FourRays| self.four_responses(side, rays);
        each_four(count, ray, solve, |i, lane, solved| {
            let value = Response {
                reflectance: [solved[0][lane], solved[1][lane]],
                transmittance: [solved[2][lane], solved[3][lane]],
            };
            found(i, value);
        });
    }

    #[inline(never)]
    fn four_amplitudes(&self, side: Side, rays: &FourRays) -> FourAmplitudes {
        let mut solved = FourAmplitudes::default();
        widest(
            #[inline(always)]
            || {
                let (fields, is_dark) = self.propagate(side, rays);
                let Amplitudes {
                    reflection: [r_s, r_p],
                    transmission: [t_s, t_p],
                } = fields.amplitudes();
                let parts = [
                    r_s.re, r_s.im, r_p.re, r_p.im, t_s.re, t_s.im, t_p.re, t_p.im,
                ];
                store_lit(parts, is_dark, &mut solved);
            },
        );
        solved
    }

    #[inline(never)]
    fn four_responses(&self, side: Side, rays: &FourRays) -> FourResponses {
        let mut solved = FourResponses::default();
        widest(
            #[inline(always)]
            || {
                let (fields, is_dark) = self.propagate(side, rays);
                let found = fields.response();
                let ([r_s, r_p], [t_s, t_p]) = (found.reflectance, found.transmittance);
                store_lit([r_s, r_p, t_s, t_p], is_dark, &mut solved);
            },
        );
        solved
    }

    /// Whether nothing arrives from that side.
    fn sends_no_light(&self, side: Side) -> bool {
        side == Side::Base && self.is_base_opaque()
    }

    /// The fields at the first surface, and the lanes that bring no light. Inputs are clamped; NaN becomes a
    /// number.
    #[inline(always)]
    fn propagate(&self, side: Side, rays: &FourRays) -> (Propagation<F64x4>, LaneMask) {
        let description = self.description();
        let [cos_theta, thickness_nm, wavelength_nm] = [
            F64x4::from_fn(|lane| rays[0][lane]),
            F64x4::from_fn(|lane| rays[1][lane]),
            F64x4::from_fn(|lane| rays[2][lane]),
        ];
        let is_number = cos_theta.equals(cos_theta) & thickness_nm.equals(thickness_nm);
        let is_dark = if self.sends_no_light(side) {
            is_number | !is_number
        } else {
            !is_number
        };
        let least = F64x4::new(f64::from(LEAST_COSINE));
        let cos_theta = cos_theta.max(least).min(F64x4::new(1.0));
        let ambient = description.ambient.index_lanes(wavelength_nm);
        let base = description.base.index_lanes(wavelength_nm);
        let (near, far) = match side {
            Side::Ambient => (ambient, base),
            Side::Base => (base, ambient),
        };
        let mut fields = Propagation::new(Incidence::new(near.re, cos_theta), far, wavelength_nm);
        let layers = &description.layers;
        let mut kept: [Option<Wave<F64x4>>; KEPT] = [None; KEPT];
        for step in 0..layers.len() {
            let at = match side {
                Side::Ambient => layers.len() - 1 - step,
                Side::Base => step,
            };
            let layer = &layers[at];
            let wave = match kept.get(self.repeated_media[at]) {
                Some(Some(wave)) => *wave,
                other => {
                    let wave = fields.wave(layer.medium.index_lanes(wavelength_nm));
                    if other.is_some() {
                        kept[self.repeated_media[at]] = Some(wave);
                    }
                    wave
                }
            };
            let [min, max] = layer.thickness_nm;
            let thickness_nm = thickness_nm.max(F64x4::new(min)).min(F64x4::new(max));
            fields.cross(&wave, thickness_nm);
        }
        (fields, is_dark)
    }
}

/// Stores numbers, 0 in dark lanes.
#[inline(always)]
fn store_lit<const N: usize>(
    numbers: [F64x4; N],
    is_dark: LaneMask,
    stored: &mut [[f64; F64x4::COUNT]; N],
) {
    for i in 0..N {
        stored[i] = F64x4::select(is_dark, F64x4::new(0.0), numbers[i]).to_array();
    }
}

/// Solves `count` rays, four at a time, and calls `found` with the number of a ray, its lane and what was solved.
#[inline(always)]
fn each_four<T>(
    count: usize,
    mut ray: impl FnMut(usize) -> Ray,
    solve: impl Fn(&FourRays) -> T,
    mut found: impl FnMut(usize, usize, &T),
) {
    let mut first = 0;
    while first < count {
        let used = F64x4::COUNT.min(count - first);
        let mut rays = FourRays::default();
        for lane in 0..F64x4::COUNT {
            if lane < used {
                let ray = ray(first + lane);
                rays[0][lane] = ray.cos_theta;
                rays[1][lane] = ray.thickness_nm;
                rays[2][lane] = ray.wavelength_nm;
            } else {
                // The first ray fills lanes that are left over.
                for numbers in &mut rays {
                    numbers[lane] = numbers[0];
                }
            }
        }
        let solved = solve(&rays);
        for lane in 0..used {
            found(first + lane, lane, &solved);
        }
        first += used;
    }
}

fn check<T>(film: &Film, lambda_nm: &[f64], found: &[T]) -> Result<(), Error> {
    if found.len() != lambda_nm.len() {
        return Err(Error::invalid(format!(
            "{} wavelengths need as many results, not {}",
            lambda_nm.len(),
            found.len()
        )));
    }
    for (at, nm) in lambda_nm.iter().enumerate() {
        film.check_wavelength(format_args!("lambda_nm[{at}]"), *nm)?;
    }
    Ok(())
}

fn rays(cos_theta: f64, thickness_nm: f64, lambda_nm: &[f64]) -> impl Fn(usize) -> Ray {
    #[inline(always)]
    move |i| Ray {
        cos_theta,
        thickness_nm,
        wavelength_nm: lambda_nm[i],
    }
}
