//! Single wavelengths of a film, by full wave optics: amplitudes, reflectance and transmittance. They need
//! no tables and allocate nothing.
//!
//! A lane is one wavelength of one element, so that four wavelengths of a call, or of the elements of a
//! batch, are evaluated side by side. Lanes do not depend on each other: a batch finds the bits of single
//! calls.

use super::film::{Film, LEAST_COSINE};
use crate::error::Error;
use crate::num::{F64x4, Real, widest};
use crate::optics::stack::{Incidence, P, Response, S, Side};
use crate::optics::{Amplitudes, Complex, Propagation};

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
    /// description need not ask for. All is 0 from a base that absorbs, and for NaN.
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
        check(lambda_nm, found)?;
        let ray = rays(cos_theta, thickness_nm, lambda_nm);
        self.each_amplitudes(side, lambda_nm.len(), ray, |i, value| found[i] = value);
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
        check(lambda_nm, found)?;
        let ray = rays(cos_theta, thickness_nm, lambda_nm);
        self.each_response(side, lambda_nm.len(), ray, |i, value| found[i] = value);
        Ok(())
    }

    /// The amplitudes of `count` rays. Rays are asked for, and amplitudes found, in order and once each.
    #[inline(always)]
    pub(crate) fn each_amplitudes(
        &self,
        side: Side,
        count: usize,
        ray: impl FnMut(usize) -> Ray,
        mut found: impl FnMut(usize, Amplitudes<f64>),
    ) {
        self.each_four(side, count, ray, |lanes, propagation, is_dark| {
            let zero = Complex::real(F64x4::new(0.0));
            let light = |value| lanes_of(Complex::select(is_dark, zero, value));
            let all = propagation.amplitudes();
            let [r, t] = [all.reflection, all.transmission].map(|pair| pair.map(light));
            for (lane, i) in lanes.enumerate() {
                let value = Amplitudes {
                    reflection: [r[S][lane], r[P][lane]],
                    transmission: [t[S][lane], t[P][lane]],
                };
                found(i, value);
            }
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
        self.each_four(side, count, ray, |lanes, propagation, is_dark| {
            let light = |value| F64x4::select(is_dark, F64x4::new(0.0), value).to_array();
            let all = propagation.response();
            let [r, t] = [all.reflectance, all.transmittance].map(|pair| pair.map(light));
            for (lane, i) in lanes.enumerate() {
                let value = Response {
                    reflectance: [r[S][lane], r[P][lane]],
                    transmittance: [t[S][lane], t[P][lane]],
                };
                found(i, value);
            }
        });
    }

    /// Calls `finish` with the numbers of each four rays, their fields at the first surface, and where they
    /// bring no light.
    #[inline(always)]
    fn each_four(
        &self,
        side: Side,
        count: usize,
        mut ray: impl FnMut(usize) -> Ray,
        mut finish: impl FnMut(std::ops::Range<usize>, Propagation<F64x4>, <F64x4 as Real>::Mask),
    ) {
        widest(
            #[inline(always)]
            || {
                let mut first = 0;
                while first < count {
                    let lanes = first..count.min(first + F64x4::COUNT);
                    let mut rays = [ray(first); F64x4::COUNT];
                    for lane in 1..F64x4::COUNT {
                        // The last ray fills lanes that are left over.
                        let is_left_over = first + lane >= count;
                        rays[lane] = if is_left_over {
                            rays[lane - 1]
                        } else {
                            ray(first + lane)
                        };
                    }
                    let cos_theta = F64x4::from_fn(|lane| rays[lane].cos_theta);
                    let thickness_nm = F64x4::from_fn(|lane| rays[lane].thickness_nm);
                    let wavelength_nm = F64x4::from_fn(|lane| rays[lane].wavelength_nm);
                    let is_nan = !(cos_theta.equals(cos_theta) & thickness_nm.equals(thickness_nm));
                    let is_dark = if self.sends_no_light(side) {
                        F64x4::new(0.0).equals(F64x4::new(0.0))
                    } else {
                        is_nan
                    };
                    let propagation = self.propagate(side, cos_theta, thickness_nm, wavelength_nm);
                    finish(lanes, propagation, is_dark);
                    first += F64x4::COUNT;
                }
            },
        );
    }

    /// Whether nothing arrives from that side.
    fn sends_no_light(&self, side: Side) -> bool {
        side == Side::Base && self.description().base.absorbs()
    }

    /// The fields at the first surface. Inputs are clamped; NaN becomes a number.
    #[inline(always)]
    fn propagate(
        &self,
        side: Side,
        cos_theta: F64x4,
        thickness_nm: F64x4,
        wavelength_nm: F64x4,
    ) -> Propagation<F64x4> {
        let description = self.description();
        let least = F64x4::new(f64::from(LEAST_COSINE));
        let cos_theta = cos_theta.max(least).min(F64x4::new(1.0));
        let [ambient, base] = [&description.ambient, &description.base]
            .map(|medium| medium.index_lanes(wavelength_nm));
        let (near, far) = match side {
            Side::Ambient => (ambient, base),
            Side::Base => (base, ambient),
        };
        let mut fields = Propagation::new(Incidence::new(near.re, cos_theta), far);
        let layers = &description.layers;
        for step in 0..layers.len() {
            let layer = match side {
                Side::Ambient => &layers[layers.len() - 1 - step],
                Side::Base => &layers[step],
            };
            let [min, max] = layer.thickness_nm.map(F64x4::new);
            let index = layer.medium.index_lanes(wavelength_nm);
            fields.cross(index, thickness_nm.max(min).min(max), wavelength_nm);
        }
        fields
    }
}

/// The number in each lane.
#[inline(always)]
fn lanes_of(value: Complex<F64x4>) -> [Complex<f64>; F64x4::COUNT] {
    let [re, im] = [value.re.to_array(), value.im.to_array()];
    std::array::from_fn(|lane| Complex::new(re[lane], im[lane]))
}

/// Refuses a wavelength that is not finite and above 0. `name` is what the caller calls it.
#[inline(always)]
pub(crate) fn check_wavelength(nm: f64, name: impl FnOnce() -> String) -> Result<(), Error> {
    if nm > 0.0 && nm < f64::INFINITY {
        return Ok(());
    }
    Err(wrong_wavelength(nm, &name()))
}

#[cold]
fn wrong_wavelength(nm: f64, name: &str) -> Error {
    Error::out_of_range(format!("{name} = {nm} is not finite and above 0"))
}

fn check<T>(lambda_nm: &[f64], found: &[T]) -> Result<(), Error> {
    if found.len() != lambda_nm.len() {
        return Err(Error::invalid(format!(
            "{} wavelengths need as many results, not {}",
            lambda_nm.len(),
            found.len()
        )));
    }
    for (at, nm) in lambda_nm.iter().enumerate() {
        check_wavelength(*nm, || format!("lambda_nm[{at}]"))?;
    }
    Ok(())
}

fn rays(cos_theta: f64, thickness_nm: f64, lambda_nm: &[f64]) -> impl Fn(usize) -> Ray {
    move |i| Ray {
        cos_theta,
        thickness_nm,
        wavelength_nm: lambda_nm[i],
    }
}
