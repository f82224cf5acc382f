//! Spectral calls: values, densities and samples at up to 16 wavelengths at once.
//!
//! A wavelength is evaluated as a surface of its own, in a lane: its parameters are the numbers at that wavelength, and
//! all three channels are equal. So the density of a wavelength is the one with which its own colour would choose among
//! the lobes, as if it had been the hero.
//!
//! **Weights.** A direction is sampled for one wavelength, the hero, and serves all of them. weight_j = value_j / mean of
//! the densities of all wavelengths is the balance heuristic if every wavelength is as often the hero as any other
//! (Wilkie et al. 2014, "Hero Wavelength Spectral Sampling", eq. 8 to 11).

use super::call::Call;
use super::info::Flags;
use super::instance::Bsdf;
use super::job::{Direction, are_uniform};
use super::precision::Precision;
use super::varying::{MAX_FLOATS, MAX_VARYING, VaryingValues};
use super::wavelengths::{MAX_WAVELENGTHS, PerWavelength, SpectralCall, SpectralValues};
use crate::error::Error;
use std::fmt::Display;

/// The wavelengths of a call, and what is given for each of them.
#[derive(Clone, Copy, Debug)]
pub struct AtWavelengths<'a, T: Precision = f32> {
    /// Vacuum wavelengths, nm: 1 to [`MAX_WAVELENGTHS`] numbers above 0 and, without `extrapolate` in the film's
    /// description, within the range of its media.
    pub lambda_nm: &'a [T],
    /// The number of the wavelength that directions are sampled for. Evaluations do not use it.
    pub hero: usize,
    /// As in [`Bsdf::eval`], but colours have one number for each wavelength, see
    /// [`Bsdf::spectral_varying_floats`]; with `None` every parameter has its default.
    pub varying: Option<&'a [T]>,
}

/// A direction sampled for a wavelength, the hero. Without a valid sample every field is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralSample<T: Precision = f32> {
    /// The direction to the light, of unit length.
    pub wi: T::Vector,
    /// The refractive index on wi's side over that on wo's side, for the hero; 1 for a reflection.
    pub eta: T,
    /// The flags of the chosen lobe.
    pub flags: Flags,
    /// The number of the chosen lobe, an index into [`Bsdf::lobe_infos`].
    pub lobe: usize,
    /// The probability with which the hero chose that lobe.
    pub lobe_probability: T,
    /// Whether only the hero goes in this direction: a medium disperses, and the ray was refracted. The other
    /// wavelengths have weight and density 0, and the hero's weight counts for all of them.
    pub is_hero_only: bool,
}

impl<T: Precision> Bsdf<T> {
    /// The number of values in the `varying` of a spectral call with `count` wavelengths: colours have one per wavelength,
    /// other parameters as many as they have components.
    pub fn spectral_varying_floats(&self, count: usize) -> usize {
        let numbers = |param: &super::info::ParamInfo| match param.is_color() {
            true => count,
            false => param.components(),
        };
        self.varying().map(|varying| numbers(varying.param)).sum()
    }

    /// f(wo, wi) |wi.z| at each wavelength, and for each the density of wi as if it had been the hero.
    ///
    /// `value` and `pdf` have the length of `lambda_nm`. Films and media are evaluated by wave optics at each wavelength,
    /// refractive indices given at three wavelengths are interpolated, and nothing is clipped to a colour space.
    ///
    /// # Errors
    /// `InvalidArgument` (a wrong length), `OutOfRange` (a wavelength, the hero) or `Unsupported`: a colour with three
    /// different numbers that does not vary, or a spread of thickness. Nothing is then written.
    pub fn eval_spectral(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        at: &AtWavelengths<T>,
        call: &Call,
        value: &mut [T],
        pdf: &mut [T],
    ) -> Result<(), Error> {
        let mut room = SpectralRoom::new();
        let spectral = self.spectral_call(at, call, &mut room)?;
        check_lengths(spectral.count, [("value", value.len()), ("pdf", pdf.len())])?;
        let mut found = SpectralValues::new();
        if let (Some(wo), Some(wi)) = (self.direction(wo), self.direction(wi))
            && !spectral.lobes.is_empty()
        {
            self.kernel.eval_spectral(wo, wi, &spectral, &mut found);
        }
        value.copy_from_slice(&found.value[..spectral.count]);
        pdf.copy_from_slice(&found.pdf[..spectral.count]);
        Ok(())
    }

    /// Samples a direction for the hero. `pdf` receives the densities as if each wavelength had been the hero; for a DELTA
    /// lobe the probabilities of choosing it. `weight` receives value / mean of `pdf`, for a DELTA lobe throughput / mean
    /// of `pdf`. `u` is as for [`Bsdf::sample`].
    ///
    /// The weights suit a renderer that draws the hero anew for every call, each wavelength as often as any other. One
    /// that keeps the hero along a path multiplies the values, weight times mean of `pdf`, and the densities along it, and
    /// divides by the mean of the products; once the hero is alone it calls with that wavelength only.
    ///
    /// # Errors
    /// As for [`Bsdf::eval_spectral`].
    pub fn sample_spectral(
        &self,
        wo: T::Vector,
        u: T::Vector,
        at: &AtWavelengths<T>,
        call: &Call,
        weight: &mut [T],
        pdf: &mut [T],
    ) -> Result<SpectralSample<T>, Error> {
        let mut room = SpectralRoom::new();
        let spectral = self.spectral_call(at, call, &mut room)?;
        let lengths = [("weight", weight.len()), ("pdf", pdf.len())];
        check_lengths(spectral.count, lengths)?;
        let u: [T; 3] = u.into();
        let mut found = SpectralValues::new();
        let (mut drawn, mut is_hero_only) = (Direction::none(), false);
        if let Some(wo) = self.direction(wo)
            && are_uniform(u)
            && !spectral.lobes.is_empty()
        {
            (drawn, is_hero_only) = self.kernel.sample_spectral(wo, u, &spectral, &mut found);
        }
        weight.copy_from_slice(&found.value[..spectral.count]);
        pdf.copy_from_slice(&found.pdf[..spectral.count]);
        let lobe = drawn.lobe.to_f32() as usize;
        Ok(SpectralSample {
            wi: drawn.wi.to_array().into(),
            eta: drawn.eta,
            flags: self.sampled_flags(lobe, drawn.lobe_probability > T::new(0.0)),
            lobe,
            lobe_probability: drawn.lobe_probability,
            is_hero_only,
        })
    }

    /// Checks a call and lays its numbers out by wavelength.
    fn spectral_call<'a>(
        &'a self,
        at: &AtWavelengths<T>,
        call: &Call,
        room: &'a mut SpectralRoom<'a, T>,
    ) -> Result<SpectralCall<'a, T>, Error> {
        let AtWavelengths {
            lambda_nm,
            hero,
            varying,
        } = *at;
        let count = lambda_nm.len();
        self.check_wavelength_count(count, hero)?;
        for (i, nm) in lambda_nm.iter().enumerate() {
            self.check_wavelength(format_args!("lambda_nm[{i}]"), (*nm).into())?;
        }
        let varying = match varying {
            Some(numbers) => self.by_wavelength(numbers, count, room)?,
            None => {
                self.check_spectral_defaults(|_| true)?;
                VaryingValues::none()
            }
        };
        Ok(SpectralCall {
            lambda_nm: padded(lambda_nm),
            count,
            hero,
            varying,
            lobes: self.wanted_lobes(call),
            transport: call.transport,
        })
    }

    /// Refuses a BSDF without spectral calls, and a number of wavelengths and a hero that no call has.
    pub(crate) fn check_wavelength_count(&self, count: usize, hero: usize) -> Result<(), Error> {
        if !(1..=MAX_WAVELENGTHS).contains(&count) {
            return Err(Error::out_of_range(format!(
                "the number of wavelengths = {count} is outside [1, {MAX_WAVELENGTHS}]"
            )));
        }
        if hero >= count {
            return Err(Error::out_of_range(format!(
                "hero = {hero} is outside [0, {}], the {count} wavelengths",
                count - 1
            )));
        }
        match &self.spectral_refusal {
            Some(refusal) => Err(Error::unsupported(refusal.clone())),
            None => Ok(()),
        }
    }

    /// Refuses a vacuum wavelength, nm, that is not finite and above 0 or outside the ranges of a film's media.
    pub(crate) fn check_wavelength(&self, name: impl Display, nm: f64) -> Result<(), Error> {
        match self.kernel.film() {
            Some(film) => film.check_wavelength(name, nm),
            None if nm > 0.0 && nm < f64::INFINITY => Ok(()),
            None => Err(Error::out_of_range(format!(
                "{name} = {nm} is not finite and above 0"
            ))),
        }
    }

    /// Refuses defaults that are colours with three different numbers. `is_default` tells which of the varying
    /// parameters a call does not give.
    pub(crate) fn check_spectral_defaults(
        &self,
        is_default: impl Fn(usize) -> bool,
    ) -> Result<(), Error> {
        for (at, varying) in self.varying().enumerate() {
            let defaults = varying.defaults;
            let is_color = varying.param.is_color() && is_default(at);
            if is_color && defaults.iter().any(|other| *other != defaults[0]) {
                return Err(Error::invalid(format!(
                    "the call gives no values of the colour '{}', whose default has three different numbers, \
                     which do not determine a spectrum",
                    varying.param.name()
                )));
            }
        }
        Ok(())
    }

    /// One column for each component of what varies, with the values at each wavelength.
    fn by_wavelength<'a>(
        &'a self,
        numbers: &[T],
        count: usize,
        room: &'a mut SpectralRoom<'a, T>,
    ) -> Result<VaryingValues<'a, T>, Error> {
        let needed = self.spectral_varying_floats(count);
        if numbers.len() != needed {
            return Err(Error::invalid(format!(
                "varying has {} numbers; {count} wavelengths take {needed}",
                numbers.len()
            )));
        }
        let SpectralRoom { columns, slices } = room;
        // A colour has one column, which serves for its three components.
        let (mut rest, mut used, mut columns_of) = (numbers, 0, [(0, 0); MAX_VARYING]);
        for (varying, columns_of) in self.varying().zip(&mut columns_of) {
            let components = varying.param.components();
            if varying.param.is_color() {
                let (own, after) = rest.split_at(count);
                columns[used] = padded(own);
                (*columns_of, used, rest) = ((used, 0), used + 1, after);
            } else {
                let (own, after) = rest.split_at(components);
                for (column, number) in columns[used..].iter_mut().zip(own) {
                    *column = [*number; MAX_WAVELENGTHS];
                }
                (*columns_of, used, rest) = ((used, 1), used + components, after);
            }
        }
        let columns: &'a [PerWavelength<T>] = columns;
        let mut floats = 0;
        for (varying, (first, step)) in self.varying().zip(columns_of) {
            for component in 0..varying.param.components() {
                slices[floats] = &columns[first + component * step];
                floats += 1;
            }
        }
        Ok(self.varying_columns(&slices[..floats]))
    }
}

/// Memory for the values of what varies.
struct SpectralRoom<'a, T> {
    columns: [PerWavelength<T>; MAX_FLOATS],
    slices: [&'a [T]; MAX_FLOATS],
}

impl<T: Precision> SpectralRoom<'_, T> {
    fn new() -> Self {
        Self {
            columns: [[T::new(0.0); MAX_WAVELENGTHS]; MAX_FLOATS],
            slices: [&[]; MAX_FLOATS],
        }
    }
}

/// The numbers, with the last one repeated.
fn padded<T: Copy>(numbers: &[T]) -> PerWavelength<T> {
    std::array::from_fn(|i| numbers[i.min(numbers.len() - 1)])
}

fn check_lengths(count: usize, lengths: [(&str, usize); 2]) -> Result<(), Error> {
    for (name, length) in lengths {
        if length != count {
            return Err(Error::invalid(format!(
                "{name} has room for {length} numbers; there are {count} wavelengths"
            )));
        }
    }
    Ok(())
}
