//! A compiled film.

use super::colors::{Colors, clamp_inputs, has_nan};
use super::description::FilmDescription;
use super::evaluator::Evaluator;
use super::plan::choose::plan;
use super::plan::film_plan::FilmPlan;
use super::repeated_media::repeated_media;
use super::table::spline::SplineTable;
use crate::error::Error;
use crate::num::{Lane, Real, Rgb, each};
use crate::optics::stack::Side;
use crate::optics::{ChannelWeights, Medium, Reference, attenuation_per_mm};
use std::fmt::Display;

/// A coating, compiled to the method that its [`FilmPlan`] names. Immutable; share it between threads.
///
/// `cos_theta` is the cosine of incidence on the side that the light comes from, clamped to \[1e-9, 1\];
/// `thickness_nm` is the thickness of the layer that varies, clamped to its range, and ignored if none
/// varies. NaN in either gives 0. Colours are linear, normalised so that a perfect mirror is (1, 1, 1),
/// and clipped to \[0, 1\] unless the description says `unclipped`. The tolerance does not hold for films
/// thinner than 0.001 nm at cosines below 1e-4: there a soap film turns from nothing into a mirror.
pub struct Film {
    description: FilmDescription,
    pub(super) evaluator: Evaluator,
    plan: FilmPlan,
    /// The range that thicknesses are clamped to, nm.
    thickness_nm: [f32; 2],
    reference: Reference,
    attenuation_per_mm: Rgb<f64>,
    /// The wavelengths at which spectra are given, nm.
    lambda_nm: [f64; 2],
    is_base_opaque: bool,
    /// By [`repeated_media`].
    pub(super) repeated_media: Box<[usize]>,
}

/// The least cosine; smaller ones are replaced by it. At 0 even the thinnest film is a perfect mirror,
/// while a base without film may reflect nothing.
pub(super) const LEAST_COSINE: f32 = 1e-9;

impl Film {
    /// Validates a description and compiles it.
    ///
    /// # Errors
    /// `OutOfRange`, `InvalidArgument`, `UnknownName` (method), `Unsupported` (a method that does not
    /// take such a film), `OutOfMemory`.
    pub fn new(description: &FilmDescription) -> Result<Self, Error> {
        description.check()?;
        let reference = Self::reference_of(description)?;
        let weights = ChannelWeights::new(description.white, description.color_space);
        let attenuation_per_mm = attenuation_per_mm(&description.base, &weights)?;
        let (evaluator, plan) = plan(description, &reference)?;
        Ok(Self::of_parts(
            description.clone(),
            reference,
            attenuation_per_mm,
            evaluator,
            plan,
        ))
    }

    /// The reference of a valid description.
    #[inline(never)]
    pub(super) fn reference_of(description: &FilmDescription) -> Result<Reference, Error> {
        let layers = description.layers.iter().map(|layer| layer.medium.clone());
        Reference::new(
            description.ambient.clone(),
            layers.collect(),
            description.base.clone(),
            description.white,
            description.color_space,
        )
    }

    pub(super) fn of_parts(
        description: FilmDescription,
        reference: Reference,
        attenuation_per_mm: Rgb<f64>,
        evaluator: Evaluator,
        plan: FilmPlan,
    ) -> Self {
        Self {
            attenuation_per_mm,
            evaluator,
            plan,
            thickness_nm: description.varying_range().map(|x| x as f32),
            reference,
            lambda_nm: if description.extrapolate {
                [0.0, f64::INFINITY]
            } else {
                description.range_nm()
            },
            is_base_opaque: description.is_base_opaque(),
            repeated_media: repeated_media(&description.layers),
            description,
        }
    }

    /// [`FilmDescription::is_base_opaque`], which looks at the base's index.
    #[inline(always)]
    pub(crate) fn is_base_opaque(&self) -> bool {
        self.is_base_opaque
    }

    /// [`FilmDescription::check_wavelength`], quick for wavelengths that are allowed.
    #[inline(always)]
    pub(crate) fn check_wavelength(&self, name: impl Display, nm: f64) -> Result<(), Error> {
        let [least, greatest] = self.lambda_nm;
        if nm > 0.0 && nm < f64::INFINITY && (least..=greatest).contains(&nm) {
            return Ok(());
        }
        self.description.check_wavelength(name, nm)
    }

    /// The description of the film.
    pub fn description(&self) -> &FilmDescription {
        &self.description
    }

    /// The method that evaluates the film, and its measured errors.
    pub fn plan(&self) -> &FilmPlan {
        &self.plan
    }

    /// The range of the thickness that varies, nm; `None` if none does.
    pub fn varying_thickness_nm(&self) -> Option<[f64; 2]> {
        self.description.varying()?;
        Some(self.description.varying_range())
    }

    /// Reflectance of unpolarised light from the ambient's side, linear RGB.
    #[inline(always)]
    pub fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        self.reflectance_lanes(cos_theta, thickness_nm)
    }

    /// [`Film::reflectance`] in each lane.
    #[inline(always)]
    pub(crate) fn reflectance_lanes<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
    ) -> Rgb<L> {
        let inputs = [cos_theta, thickness_nm];
        if has_nan(inputs) {
            return one_by_one(inputs, |c, d| self.reflectance_or_zero(c, d));
        }
        let [cos_theta, thickness_nm] = self.clamp_inputs(inputs);
        let rgb = match self.table() {
            Some(table) => table.at(cos_theta, thickness_nm),
            None => L::rgb(one_by_one([cos_theta, thickness_nm], |c, d| {
                self.unclipped(c, d)
            })),
        };
        L::channels(self.clip::<L>(rgb))
    }

    /// The table of the reflectance from the ambient's side, if the film has one over the cosine there.
    #[inline(always)]
    pub(super) fn table(&self) -> Option<&SplineTable> {
        match &self.evaluator {
            Evaluator::Tables(tables) => tables.over_ambient_cosine(),
            _ => None,
        }
    }

    #[inline(always)]
    pub(super) fn clamp_inputs<L: Lane<Scalar = f32>>(&self, inputs: [L; 2]) -> [L; 2] {
        let [least, greatest] = self.thickness_nm;
        clamp_inputs(
            inputs,
            [L::splat(LEAST_COSINE), L::splat(1.0)],
            [L::splat(least), L::splat(greatest)],
        )
    }

    #[inline(always)]
    pub(super) fn clip<L: Lane<Scalar = f32>>(&self, rgb: L::Rgb) -> L::Rgb {
        if self.description.unclipped {
            return rgb;
        }
        rgb.max(L::Rgb::new(0.0)).min(L::Rgb::new(1.0))
    }

    /// [`Film::reflectance`] for inputs of which one may be NaN, which is rare.
    #[cold]
    #[inline(never)]
    pub(super) fn reflectance_or_zero(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        let inputs = [cos_theta, thickness_nm];
        if has_nan(inputs) {
            return [0.0; 3];
        }
        let [cos_theta, thickness_nm] = self.clamp_inputs(inputs);
        let rgb = f32::rgb(self.unclipped(cos_theta, thickness_nm));
        f32::channels(self.clip::<f32>(rgb))
    }

    /// The unclipped reflectance for inputs in their ranges, by any evaluator.
    #[inline(never)]
    fn unclipped(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        match &self.evaluator {
            Evaluator::Tables(tables) => tables.reflectance(cos_theta, thickness_nm),
            Evaluator::Method(method) => method.compiled.reflectance(cos_theta, thickness_nm),
            Evaluator::Series(_) | Evaluator::Reference => {
                self.unclipped_colors(Side::Ambient, cos_theta, thickness_nm)
                    .reflectance
            }
        }
    }

    /// The unclipped colours for inputs in their ranges, by an evaluator that knows both sides.
    fn unclipped_colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        let (c, d) = (f64::from(cos_theta), f64::from(thickness_nm));
        match &self.evaluator {
            Evaluator::Tables(tables) => tables.colors(side, cos_theta, thickness_nm),
            Evaluator::Series(series) => series.at(side, c, d).to_f32(),
            Evaluator::Method(_) | Evaluator::Reference => self.converged(side, c, d).to_f32(),
        }
    }

    /// Reflectance and transmittance from either side; all 0 from a base that is opaque
    /// ([`FilmDescription::is_base_opaque`]). From the ambient's side the transmittance is the power that enters
    /// the base. On the base's side light travels as if the base had its index's real part alone, which is off by
    /// the order of k. Slow, and it allocates, where the film's plan is the series or the reference.
    ///
    /// # Errors
    /// `Unsupported`, if the description does not ask for transmittance.
    pub fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Result<Colors, Error> {
        if !self.description.transmittance {
            return Err(Error::unsupported(
                "this film keeps no transmittance: set transmittance = 1 in its description",
            ));
        }
        if side == Side::Base && self.is_base_opaque {
            return Ok(Colors::default());
        }
        let inputs = [cos_theta, thickness_nm];
        if has_nan(inputs) {
            return Ok(Colors::default());
        }
        let [cos_theta, thickness_nm] = self.clamp_inputs(inputs);
        let colors = self.unclipped_colors(side, cos_theta, thickness_nm);
        let clipped = |rgb: Rgb<f32>| f32::channels(self.clip::<f32>(f32::rgb(rgb)));
        Ok(Colors {
            reflectance: clipped(colors.reflectance),
            transmittance: clipped(colors.transmittance),
        })
    }

    /// The converged reflectance from the ambient's side by full wave optics, not clipped; 0 for NaN. For
    /// checking: it is slow and allocates.
    pub fn reference(&self, cos_theta: f64, thickness_nm: f64) -> Rgb<f64> {
        if cos_theta.is_nan() || thickness_nm.is_nan() {
            return [0.0; 3];
        }
        let cos_theta = cos_theta.clamp(0.0, 1.0);
        let thicknesses = self.description.thicknesses(thickness_nm);
        let found = self
            .reference
            .evaluate(Side::Ambient, cos_theta, &thicknesses);
        found.reflectance
    }

    /// Reflectance of unpolarised light from the ambient's side at one vacuum wavelength, nm, for spectral
    /// renderers; 0 for a NaN of the cosine or the thickness. It allocates.
    ///
    /// # Errors
    /// `OutOfRange` for a wavelength that [`FilmDescription::check_wavelength`] refuses.
    pub fn spectrum(
        &self,
        cos_theta: f64,
        thickness_nm: f64,
        wavelength_nm: f64,
    ) -> Result<f64, Error> {
        self.check_wavelength("wavelength_nm", wavelength_nm)?;
        if cos_theta.is_nan() || thickness_nm.is_nan() {
            return Ok(0.0);
        }
        let cos_theta = cos_theta.clamp(0.0, 1.0);
        let thicknesses = self.description.thicknesses(thickness_nm);
        Ok(self
            .reference
            .spectrum(Side::Ambient, cos_theta, &thicknesses, wavelength_nm)
            .unpolarized_reflectance())
    }

    /// The ambient medium and the base, for callers that refract directions themselves.
    pub fn half_spaces(&self) -> [&Medium; 2] {
        [&self.description.ambient, &self.description.base]
    }

    /// The attenuation 4 pi k / lambda of light in the base, per millimetre, for a renderer's volume there: the power
    /// falls by exp(-attenuation times the path), so it is the absorption coefficient. Each channel is the mean under
    /// its weights, which is exact for short paths; a channel whose negative weights prevail has 0. A base that is
    /// opaque has one, too.
    pub fn base_attenuation_per_mm(&self) -> Rgb<f64> {
        self.attenuation_per_mm
    }

    /// The unclipped colours by the reference.
    #[inline(never)]
    pub(super) fn converged(&self, side: Side, cos_theta: f64, thickness_nm: f64) -> Colors<f64> {
        let thicknesses = self.description.thicknesses(thickness_nm);
        Colors::from(self.reference.evaluate(side, cos_theta, &thicknesses))
    }
}

/// The colours of each lane's cosine and thickness in turn.
#[inline(always)]
pub(super) fn one_by_one<L: Lane<Scalar = f32>>(
    [cos_theta, thickness_nm]: [L; 2],
    color: impl Fn(f32, f32) -> Rgb<f32>,
) -> Rgb<L> {
    const MOST: usize = 16;
    let mut inputs = [[0.0; MOST]; 2];
    cos_theta.store(&mut inputs[0][..L::COUNT]);
    thickness_nm.store(&mut inputs[1][..L::COUNT]);
    let [cos_theta, thickness_nm] = inputs;
    let mut channels = [[0.0; MOST]; 3];
    for lane in 0..L::COUNT {
        let color = color(cos_theta[lane], thickness_nm[lane]);
        for (channel, number) in channels.iter_mut().zip(color) {
            channel[lane] = number;
        }
    }
    each!(channels, |numbers| L::load(&numbers[..L::COUNT]))
}
