//! A film, compiled: what every user of this module holds.

use super::FilmDescription;
use super::plan::{Plan, plan};
use super::table::{Curve, Lanes, Table};
use crate::error::{Error, Status};
use crate::num::{Lane, Real, Rgb, each};
use crate::optics::stack::Side;
use crate::optics::{Medium, Reference};

/// A coating, compiled to the method that its [`Plan`] names. Immutable; share it between threads.
///
/// `cos_theta` is the cosine of incidence on the side that the light comes from, held in \[0, 1\];
/// `thickness_nm` that of the layer that varies, held in its range, and ignored if none does. NaN in
/// either gives 0. Colours are linear, normalised so that a perfect mirror is (1, 1, 1), and clipped
/// to \[0, 1\] unless the description says `unclipped`. Films thinner than 0.001 nm at cosines below 1e-4 are
/// not held to the tolerance: there a soap film turns from nothing into a mirror.
pub struct Film {
    description: FilmDescription,
    pub(super) compiled: Compiled,
    plan: Plan,
    /// What thicknesses and colours are held in.
    thickness_nm: [f32; 2],
    color: [Lanes; 2],
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

/// What a plan compiles to. Most films are a table, which deserves to be called directly.
pub(super) enum Compiled {
    Table(Table),
    Curve(Curve),
    Other(Box<dyn Evaluator>),
    /// The film's own, at every call.
    Reference,
}

/// A compiled method. Arguments are within their ranges and not NaN; results are not clipped.
pub(super) trait Evaluator: Send + Sync {
    /// From the ambient's side.
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32>;
    /// From either side; called only if the description asks for transmittance, for which none is chosen
    /// that knows reflectance alone.
    fn colors(&self, _side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        Colors {
            reflectance: self.reflectance(cos_theta, thickness_nm),
            transmittance: [0.0; 3],
        }
    }
}

impl Colors {
    pub(super) fn rounded(reflectance: Rgb<f64>, transmittance: Rgb<f64>) -> Self {
        let [reflectance, transmittance] =
            [reflectance, transmittance].map(|rgb| rgb.map(|x| x as f32));
        Self {
            reflectance,
            transmittance,
        }
    }
}

/// Cosines below this are taken for it. At 0 a film mirrors however thin it is, and nothing does not.
const LEAST_COSINE: f32 = 1e-9;

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
        let (compiled, plan) = plan(description, &reference)?;
        let color = if description.unclipped {
            [f32::NEG_INFINITY, f32::INFINITY]
        } else {
            [0.0, 1.0]
        };
        Ok(Self {
            description: description.clone(),
            compiled,
            plan,
            thickness_nm: description.varying_range().map(|x| x as f32),
            color: color.map(f32::gray),
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
        self.description.varying()?;
        Some(self.description.varying_range())
    }

    /// Reflectance from the ambient's side.
    #[inline(always)]
    pub fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        let Some((cos_theta, thickness_nm)) = self.held(cos_theta, thickness_nm) else {
            return [0.0; 3];
        };
        self.finished(match &self.compiled {
            Compiled::Table(table) => table.at(cos_theta, thickness_nm),
            Compiled::Curve(curve) => curve.at(cos_theta),
            _ => f32::rgb(self.untabulated(cos_theta, thickness_nm)),
        })
    }

    /// [`Film::reflectance`] of as many as there are.
    #[inline(always)]
    pub(crate) fn reflectance_lanes<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
    ) -> Rgb<L> {
        let is_number = cos_theta.equals(cos_theta) & thickness_nm.equals(thickness_nm);
        let [cos_theta, thickness_nm] = self.held_lanes(cos_theta, thickness_nm);
        let rgb = match &self.compiled {
            Compiled::Table(table) => L::channels(table.lanes(cos_theta, thickness_nm)),
            Compiled::Curve(curve) => L::channels(curve.lanes(cos_theta)),
            _ => self.untabulated_lanes(cos_theta, thickness_nm),
        };
        self.finished_lanes(is_number, rgb)
    }

    /// The arguments within their ranges, which a NaN is too.
    #[inline(always)]
    pub(super) fn held_lanes<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
    ) -> [L; 2] {
        let [min, max] = self.thickness_nm;
        [
            cos_theta.max(L::splat(LEAST_COSINE)).min(L::new(1.0)),
            thickness_nm.max(L::splat(min)).min(L::splat(max)),
        ]
    }

    #[inline(always)]
    pub(super) fn finished_lanes<L: Lane<Scalar = f32>>(
        &self,
        is_number: L::Mask,
        rgb: Rgb<L>,
    ) -> Rgb<L> {
        let [least, greatest] = self.color;
        let [least, ..] = L::channels(L::splat_rgb(least));
        let [greatest, ..] = L::channels(L::splat_rgb(greatest));
        each!(rgb, |channel| L::select(
            is_number,
            channel.max(least).min(greatest),
            L::new(0.0)
        ))
    }

    #[inline(always)]
    fn untabulated_lanes<L: Lane<Scalar = f32>>(&self, cos_theta: L, thickness_nm: L) -> Rgb<L> {
        const MOST: usize = 16;
        let mut given = [[0.0; MOST]; 2];
        cos_theta.store(&mut given[0][..L::COUNT]);
        thickness_nm.store(&mut given[1][..L::COUNT]);
        let [cos_theta, thickness_nm] = given;
        let mut channels = [[0.0; MOST]; 3];
        for place in 0..L::COUNT {
            let color = self.untabulated(cos_theta[place], thickness_nm[place]);
            for (channel, number) in channels.iter_mut().zip(color) {
                channel[place] = number;
            }
        }
        each!(channels, |numbers| L::load(&numbers[..L::COUNT]))
    }

    #[inline(never)]
    fn untabulated(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        match &self.compiled {
            Compiled::Other(other) => other.reflectance(cos_theta, thickness_nm),
            _ => {
                self.converged(Side::Ambient, cos_theta, thickness_nm)
                    .reflectance
            }
        }
    }

    /// Reflectance and transmittance from either side; all 0 from a base that absorbs. From a base
    /// beside which a half-space disperses it is the reference that answers, which is slow and allocates:
    /// every wavelength has a critical angle of its own there.
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
        let colors = match &self.compiled {
            _ if side == Side::Base && self.description.disperses() => {
                self.converged(side, cos_theta, thickness_nm)
            }
            Compiled::Reference => self.converged(side, cos_theta, thickness_nm),
            Compiled::Other(other) => other.colors(side, cos_theta, thickness_nm),
            Compiled::Table(_) | Compiled::Curve(_) => {
                return Err(Error::new(
                    Status::Internal,
                    "a film with transmittance was compiled for one side",
                ));
            }
        };
        Ok(Colors {
            reflectance: self.finished(f32::rgb(colors.reflectance)),
            transmittance: self.finished(f32::rgb(colors.transmittance)),
        })
    }

    /// The converged reflectance by full wave optics, not clipped: slow, for checking. Allocates.
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

    /// Reflectance of unpolarised light at one vacuum wavelength (nm, > 0), for spectral renderers;
    /// indices outside 380-780 nm are those at its ends. Allocates.
    pub fn spectrum(&self, cos_theta: f64, thickness_nm: f64, wavelength_nm: f64) -> f64 {
        if cos_theta.is_nan() || thickness_nm.is_nan() {
            return 0.0;
        }
        let cos_theta = cos_theta.clamp(0.0, 1.0);
        let thicknesses = self.description.thicknesses(thickness_nm);
        self.reference
            .spectrum(Side::Ambient, cos_theta, &thicknesses, wavelength_nm)
            .unpolarized_reflectance()
    }

    /// What the reference finds.
    #[inline(never)]
    fn converged(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        let thicknesses = self.description.thicknesses(f64::from(thickness_nm));
        let found = self
            .reference
            .evaluate(side, f64::from(cos_theta), &thicknesses);
        Colors::rounded(found.reflectance, found.transmittance)
    }

    /// The arguments within their ranges; none if one is NaN.
    #[inline(always)]
    fn held(&self, cos_theta: f32, thickness_nm: f32) -> Option<(f32, f32)> {
        let [min, max] = self.thickness_nm;
        let is_number = !(cos_theta.is_nan() || thickness_nm.is_nan());
        let cos_theta = Real::min(Real::max(cos_theta, LEAST_COSINE), 1.0);
        is_number.then(|| (cos_theta, Real::min(Real::max(thickness_nm, min), max)))
    }

    #[inline(always)]
    fn finished(&self, rgb: Lanes) -> Rgb<f32> {
        let [min, max] = self.color;
        f32::channels(rgb.max(min).min(max))
    }

    /// The ambient medium and the base, for those who refract.
    pub fn half_spaces(&self) -> [&Medium; 2] {
        [&self.description.ambient, &self.description.base]
    }
}
