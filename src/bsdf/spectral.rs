//! Spectral calls: values, densities and samples at up to 16 wavelengths at once.
//!
//! A wavelength is evaluated as a surface of its own, in a lane: its parameters are the numbers at that wavelength, and
//! all three channels are equal. So the density of a wavelength is the one with which its own colour would choose among
//! the lobes, as if it had been the hero.
//!
//! **Weights.** A direction is sampled for one wavelength, the hero, and serves all of them. weight_j = value_j / mean of
//! the densities of all wavelengths is the balance heuristic if every wavelength is as often the hero as any other
//! (Wilkie et al. 2014, "Hero Wavelength Spectral Sampling").

use super::call::Call;
use super::info::Flags;
use super::instance::Bsdf;
use super::job::{Direction, are_uniform};
use super::precision::Precision;
use super::varying::{MAX_FLOATS, VaryingValues};
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
    /// The number of values in the `varying` of a spectral call with `count` wavelengths. A colour has one value for each
    /// wavelength, another parameter one for each of its components.
    pub fn spectral_varying_floats(&self, count: usize) -> usize {
        let each = self.varying();
        each.map(|varying| varying.param.spectral_components(count))
            .sum()
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
        self.check_spectral(at)?;
        check_lengths(at, [("value", value.len()), ("pdf", pdf.len())])?;
        self.eval_spectral_checked(wo, wi, at, call, value, pdf);
        Ok(())
    }

    /// [`Bsdf::eval_spectral`] with what it accepts.
    pub(crate) fn eval_spectral_checked(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        at: &AtWavelengths<T>,
        call: &Call,
        value: &mut [T],
        pdf: &mut [T],
    ) {
        let mut found = SpectralValues::new();
        if let (Some(wo), Some(wi)) = (self.direction(wo), self.direction(wi)) {
            self.with_spectral_call(at, call, |spectral| {
                self.kernel.eval_spectral(wo, wi, spectral, &mut found);
            });
        }
        found.copy_to(value, pdf);
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
        self.check_spectral(at)?;
        check_lengths(at, [("weight", weight.len()), ("pdf", pdf.len())])?;
        Ok(self.sample_spectral_checked(wo, u, at, call, weight, pdf))
    }

    /// [`Bsdf::sample_spectral`] with what it accepts.
    pub(crate) fn sample_spectral_checked(
        &self,
        wo: T::Vector,
        u: T::Vector,
        at: &AtWavelengths<T>,
        call: &Call,
        weight: &mut [T],
        pdf: &mut [T],
    ) -> SpectralSample<T> {
        let u: [T; 3] = u.into();
        let mut found = SpectralValues::new();
        let (mut drawn, mut is_hero_only) = (Direction::none(), false);
        if let Some(wo) = self.direction(wo).filter(|_| are_uniform(u)) {
            self.with_spectral_call(at, call, |spectral| {
                (drawn, is_hero_only) = self.kernel.sample_spectral(wo, u, spectral, &mut found);
            });
        }
        found.copy_to(weight, pdf);
        let lobe = drawn.lobe.to_f32() as usize;
        SpectralSample {
            wi: drawn.wi.to_array().into(),
            eta: drawn.eta,
            flags: self.sampled_flags(lobe, drawn.lobe_probability > T::new(0.0)),
            lobe,
            lobe_probability: drawn.lobe_probability,
            is_hero_only,
        }
    }

    /// Calls `f` with the numbers of a call laid out by wavelength, if at least one lobe takes part.
    fn with_spectral_call(
        &self,
        at: &AtWavelengths<T>,
        call: &Call,
        f: impl FnOnce(&SpectralCall<T>),
    ) {
        let AtWavelengths {
            lambda_nm,
            hero,
            varying,
        } = *at;
        let lobes = self.wanted_lobes(call);
        if lobes.is_empty() {
            return;
        }
        // Most calls give no values, and need no memory for them.
        let mut room;
        let varying = match varying {
            Some(numbers) => {
                room = SpectralRoom::new();
                self.by_wavelength(numbers, lambda_nm.len(), &mut room)
            }
            None => VaryingValues::none(),
        };
        f(&SpectralCall {
            lambda_nm: padded(lambda_nm),
            count: lambda_nm.len(),
            hero,
            varying,
            lobes,
            transport: call.transport,
        });
    }

    fn check_spectral(&self, at: &AtWavelengths<T>) -> Result<(), Error> {
        let count = at.lambda_nm.len();
        self.check_wavelength_count(count, at.hero)?;
        for (i, nm) in at.lambda_nm.iter().enumerate() {
            self.check_wavelength(format_args!("lambda_nm[{i}]"), (*nm).into())?;
        }
        let Some(numbers) = at.varying else {
            return self.check_spectral_defaults(|_| true);
        };
        let needed = self.spectral_varying_floats(count);
        if numbers.len() != needed {
            return Err(Error::invalid(format!(
                "varying has {} numbers; {count} wavelengths take {needed}",
                numbers.len()
            )));
        }
        Ok(())
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

    /// One column for each component of what varies, with the values at each wavelength. A colour has one column, which
    /// serves for its three components.
    fn by_wavelength<'a>(
        &'a self,
        numbers: &[T],
        count: usize,
        room: &'a mut SpectralRoom<'a, T>,
    ) -> VaryingValues<'a, T> {
        let SpectralRoom { columns, slices } = room;
        let mut columns = columns.iter_mut();
        let mut filled = |values| -> &'a [T] {
            let column = columns.next().expect("there is room for all parameters");
            *column = values;
            column
        };
        let (mut rest, mut floats) = (numbers, 0);
        for varying in self.varying() {
            let (own, after) = rest.split_at(varying.param.spectral_components(count));
            let slices = &mut slices[floats..][..varying.param.components()];
            if varying.param.is_color() {
                slices.fill(filled(padded(own)));
            } else {
                for (slice, number) in slices.iter_mut().zip(own) {
                    *slice = filled([*number; MAX_WAVELENGTHS]);
                }
            }
            (rest, floats) = (after, floats + slices.len());
        }
        self.varying_columns(&slices[..floats])
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

fn check_lengths<T: Precision>(
    at: &AtWavelengths<T>,
    lengths: [(&str, usize); 2],
) -> Result<(), Error> {
    let count = at.lambda_nm.len();
    for (name, length) in lengths {
        if length != count {
            return Err(Error::invalid(format!(
                "{name} has room for {length} numbers; there are {count} wavelengths"
            )));
        }
    }
    Ok(())
}
