//! A film, compiled: what every user of this module holds.

use super::FilmDescription;
use super::plan::{Plan, plan};
use crate::error::Error;
use crate::math::Rgb;
use crate::optics::stack::Side;
use crate::optics::{Medium, Reference};

/// A coating, compiled to the method that its [`Plan`] names. Immutable; share it between threads.
///
/// `cos_theta` is the cosine of incidence on the side that the light comes from, held in \[0, 1\];
/// `thickness_nm` that of the layer that varies, held in its range, and ignored if none does. NaN in
/// either gives 0. Colours are linear, normalised so that a perfect mirror is (1, 1, 1), and clipped
/// to \[0, 1\] unless the description says `unclipped`.
pub struct Film {
    description: FilmDescription,
    evaluator: Box<dyn Evaluator>,
    plan: Plan,
    reference: Reference,
}

/// Reflectance and transmittance of unpolarised light, RGB.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Colors {
    /// What returns to the side that it came from.
    pub reflectance: Rgb<f32>,
    /// What arrives on the other side, as power.
    pub transmittance: Rgb<f32>,
}

/// A compiled method. Arguments are within their ranges and not NaN; results are not clipped.
pub(super) trait Evaluator: Send + Sync {
    /// From the ambient's side.
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32>;
    /// From either side; called only if the description asks for transmittance.
    fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors;
}

impl Film {
    /// Validates a description and compiles it.
    ///
    /// # Errors
    /// `OutOfRange`, `InvalidArgument`, `UnknownName` (method), `Unsupported` (a method that does not
    /// take such a film), `OutOfMemory`.
    pub fn new(description: &FilmDescription) -> Result<Self, Error> {
        description.check()?;
        let layers = description.layers.iter().map(|layer| layer.medium.clone());
        let reference = Reference::new(
            description.ambient.clone(),
            layers.collect(),
            description.base.clone(),
            description.white,
            description.color_space,
        )?;
        let (evaluator, plan) = plan(description, &reference)?;
        Ok(Self {
            description: description.clone(),
            evaluator,
            plan,
            reference,
        })
    }

    /// What it was made from.
    pub fn description(&self) -> &FilmDescription {
        &self.description
    }

    /// How it is evaluated, and how well.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The range of the thickness that varies, nm, if one does.
    pub fn varying_thickness_nm(&self) -> Option<[f64; 2]> {
        let varying = self.description.varying()?;
        Some(self.description.layers[varying].thickness_nm)
    }

    /// Reflectance from the ambient's side.
    #[inline]
    pub fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        match self.held(cos_theta, thickness_nm) {
            Some((cos_theta, thickness_nm)) => {
                self.finished(self.evaluator.reflectance(cos_theta, thickness_nm))
            }
            None => [0.0; 3],
        }
    }

    /// Reflectance and transmittance from either side; all 0 from a base that absorbs.
    ///
    /// # Errors
    /// `Unsupported`, if the description does not ask for transmittance.
    pub fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Result<Colors, Error> {
        if !self.description.transmittance {
            return Err(Error::unsupported(
                "this film keeps no transmittance: set transmittance = 1 in its description",
            ));
        }
        let Some((cos_theta, thickness_nm)) = self.held(cos_theta, thickness_nm) else {
            return Ok(Colors::default());
        };
        if side == Side::Base && self.description.base.absorbs() {
            return Ok(Colors::default());
        }
        let colors = self.evaluator.colors(side, cos_theta, thickness_nm);
        Ok(Colors {
            reflectance: self.finished(colors.reflectance),
            transmittance: self.finished(colors.transmittance),
        })
    }

    /// The converged reflectance by full wave optics, not clipped: slow, for checking. Allocates.
    pub fn reference(&self, cos_theta: f64, thickness_nm: f64) -> Rgb<f64> {
        if cos_theta.is_nan() || thickness_nm.is_nan() {
            return [0.0; 3];
        }
        let cos_theta = cos_theta.clamp(0.0, 1.0);
        let thicknesses = self.thicknesses(thickness_nm);
        let found = self
            .reference
            .evaluate(Side::Ambient, cos_theta, &thicknesses);
        found.reflectance
    }

    /// Reflectance of unpolarised light at one vacuum wavelength (nm, > 0), for spectral renderers;
    /// indices outside 380-780 nm are those at its ends. Allocates.
    pub fn spectrum(&self, cos_theta: f64, thickness_nm: f64, wavelength_nm: f64) -> f64 {
        if cos_theta.is_nan() || thickness_nm.is_nan() {
            return 0.0;
        }
        let cos_theta = cos_theta.clamp(0.0, 1.0);
        let thicknesses = self.thicknesses(thickness_nm);
        self.reference
            .spectrum(Side::Ambient, cos_theta, &thicknesses, wavelength_nm)
            .unpolarized_reflectance()
    }

    /// One thickness per layer.
    fn thicknesses(&self, varying_nm: f64) -> Vec<f64> {
        let thickness = |layer: &super::FilmLayer| {
            let [min, max] = layer.thickness_nm;
            varying_nm.clamp(min, max)
        };
        self.description.layers.iter().map(thickness).collect()
    }

    /// The arguments within their ranges; none if one is NaN.
    #[inline(always)]
    fn held(&self, cos_theta: f32, thickness_nm: f32) -> Option<(f32, f32)> {
        let [min, max] = self.plan.thickness_nm;
        let is_number = !(cos_theta.is_nan() || thickness_nm.is_nan());
        is_number.then(|| (cos_theta.clamp(0.0, 1.0), thickness_nm.clamp(min, max)))
    }

    #[inline(always)]
    fn finished(&self, rgb: Rgb<f32>) -> Rgb<f32> {
        if self.description.unclipped {
            rgb
        } else {
            rgb.map(|channel| channel.clamp(0.0, 1.0))
        }
    }

    /// The ambient medium and the base, for those who refract.
    pub fn half_spaces(&self) -> [&Medium; 2] {
        [&self.description.ambient, &self.description.base]
    }
}
