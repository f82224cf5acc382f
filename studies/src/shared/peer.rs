//! The ways to a film's colour that are compared.

use super::bsdf;
use super::habit::Habit;
use super::stack::{Stack, Truth};
use pellicle::film::{CompiledMethod, Film, FilmDescription, OneLayer, OneLayerMethod as Kind};
use pellicle::num::Rgb;
use pellicle::optics::RGB_WAVELENGTHS_NM;
use pellicle::{Bsdf, Description, Error};
use std::sync::OnceLock;

/// One way with one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Peer {
    /// The model `layered`, variant `paper`, at the mirror direction (GH02 eq. 5).
    Layered,
    /// A method for one film on a base.
    Method(Kind),
    /// A film that has to use a method, within a tolerance.
    Forced(&'static str, f64),
    /// A film as the plan compiles it for a tolerance.
    Planned(f64),
    /// Converged wave optics, but for a habit of Cycles.
    Habit(Habit),
    /// Converged wave optics.
    Reference,
}

/// The methods that can be asked for by name and can fail.
pub const FORCED: [&str; 7] = [
    "two_beam",
    "airy_rgb",
    "quadrature",
    "harmonics",
    "bands",
    "series",
    "table",
];

/// Harmonics of that order.
pub const fn harmonics(order: usize) -> Kind {
    Kind::Harmonics(order)
}

/// The number of wavelengths, bands or harmonics; 0 if the method has no size.
pub fn size(kind: Kind) -> usize {
    match kind {
        Kind::TwoBeam | Kind::AiryRgb => 0,
        Kind::Quadrature(size) | Kind::Bands(size) | Kind::Harmonics(size) => size,
    }
}

/// Every method in every size that a plan may choose.
pub fn all_kinds() -> Vec<Kind> {
    let sized = |n| [Kind::Quadrature(n), Kind::Bands(n), harmonics(n)];
    let small = [Kind::TwoBeam, Kind::AiryRgb].into_iter();
    small.chain((1..=256).flat_map(sized)).collect()
}

/// Whether a film's plan says that it evaluates a method in that size.
pub fn uses(film: &Film, kind: Kind) -> bool {
    film.plan().reason.starts_with(&format!("{}:", kind.cost()))
}

/// The name of the method that the plan chose.
pub fn method_of(film: &Film) -> String {
    film.plan().method.to_owned()
}

/// A method in single precision, and when it is asked for in double.
pub struct TwoPrecisions {
    kind: Kind,
    layer: OneLayer,
    pub single: Box<dyn CompiledMethod<f32>>,
    double: OnceLock<Box<dyn CompiledMethod<f64>>>,
}

impl TwoPrecisions {
    pub fn new(kind: Kind, layer: OneLayer) -> Result<Self, Error> {
        Ok(Self {
            kind,
            single: kind.single(&layer)?,
            double: OnceLock::new(),
            layer,
        })
    }

    /// Linear RGB in double precision, not clipped.
    pub fn double(&self, cos_theta: f64, thickness_nm: f64) -> Rgb<f64> {
        let compile = || self.kind.double(&self.layer).unwrap();
        let double = self.double.get_or_init(compile);
        double.reflectance(cos_theta, thickness_nm)
    }
}

/// A peer, ready for one stack.
pub enum Compiled {
    Layered(Box<(Bsdf<f32>, Bsdf<f64>)>),
    Method(Box<TwoPrecisions>),
    Film(Box<Film>),
    /// The stack stands in for the truth where the habit changes nothing.
    Habit(Habit, Box<Stack>),
    Reference(Box<Truth>),
    /// Why it does not take the stack.
    Refused(String),
}

impl Peer {
    /// The name in tables, without the setting.
    pub fn name(self) -> &'static str {
        match self {
            Self::Layered => "layered, paper",
            Self::Method(Kind::Harmonics(_)) => "harmonics",
            Self::Method(kind) => kind.name(),
            Self::Forced(name, _) => name,
            Self::Planned(_) => "plan",
            Self::Habit(habit) => habit.name(),
            Self::Reference => "reference",
        }
    }

    /// The size or the tolerance; empty if there is none.
    pub fn setting(self) -> String {
        match self {
            Self::Method(kind) if size(kind) > 0 => size(kind).to_string(),
            Self::Forced(_, tolerance) | Self::Planned(tolerance) => format!("{tolerance:e}"),
            _ => String::new(),
        }
    }

    /// Name and setting.
    pub fn title(self) -> String {
        format!("{} {}", self.name(), self.setting())
            .trim_end()
            .to_owned()
    }

    /// The error that is promised, if any is.
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Self::Forced(_, tolerance) | Self::Planned(tolerance) => Some(tolerance),
            _ => None,
        }
    }

    /// For a stack over a range of thickness, nm.
    pub fn compile(self, stack: &Stack, thickness_nm: [f64; 2]) -> Compiled {
        let film =
            |description: &FilmDescription| Ok(Compiled::Film(Box::new(Film::new(description)?)));
        let compiled = match self {
            Self::Layered => layered(stack),
            Self::Method(kind) => match stack.one_layer() {
                Some(layer) => {
                    TwoPrecisions::new(kind, layer).map(|m| Compiled::Method(Box::new(m)))
                }
                None => return Compiled::Refused("takes one film on a base".into()),
            },
            Self::Planned(tolerance) => film(&stack.description(thickness_nm, tolerance)),
            Self::Forced(method, tolerance) => film(&FilmDescription {
                method: Some(method.into()),
                ..stack.description(thickness_nm, tolerance)
            }),
            Self::Habit(habit) => Ok(Compiled::Habit(habit, Box::new(stack.clone()))),
            Self::Reference => stack
                .truth()
                .map(|truth| Compiled::Reference(Box::new(truth))),
        };
        compiled.unwrap_or_else(|error| Compiled::Refused(error.message.into_owned()))
    }
}

impl Compiled {
    /// Linear RGB in single precision; none if the stack was refused.
    pub fn single(&self, cos_theta: f32, thickness_nm: f32) -> Option<Rgb<f32>> {
        Some(match self {
            Self::Layered(bsdf) if cos_theta > 0.0 => {
                let sine = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
                let [wo, wi] = [sine, -sine].map(|x| glam::Vec3::new(x, 0.0, cos_theta));
                let (value, _) = bsdf::value_pdf(&bsdf.0, wo, wi, Some(&[thickness_nm]));
                value.map(|channel| channel / cos_theta)
            }
            Self::Layered(_) => [0.0; 3],
            Self::Method(method) => method.single.reflectance(cos_theta, thickness_nm),
            Self::Film(film) => film.reflectance(cos_theta, thickness_nm),
            Self::Reference(truth) => {
                let found = truth.reflectance(cos_theta.into(), thickness_nm.into());
                found.map(|channel| channel as f32)
            }
            Self::Habit(..) | Self::Refused(_) => return None,
        })
    }

    /// The same where the truth is known, which habits need: they change it here and there.
    pub fn beside(&self, truth: Rgb<f64>, cos_theta: f32, thickness_nm: f32) -> Option<Rgb<f32>> {
        let Self::Habit(habit, stack) = self else {
            return self.single(cos_theta, thickness_nm);
        };
        let changed = habit.changed(stack, cos_theta.into(), thickness_nm.into());
        Some(changed.unwrap_or(truth).map(|channel| channel as f32))
    }

    /// The same formula in double precision; films have none of their own.
    pub fn double(&self, cos_theta: f64, thickness_nm: f64) -> Option<Rgb<f64>> {
        Some(match self {
            Self::Layered(bsdf) => {
                let sine = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
                let [wo, wi] = [sine, -sine].map(|x| glam::DVec3::new(x, 0.0, cos_theta));
                let (value, _) = bsdf::value_pdf(&bsdf.1, wo, wi, Some(&[thickness_nm]));
                value.map(|channel| channel / cos_theta)
            }
            Self::Method(method) => method.double(cos_theta, thickness_nm),
            Self::Reference(truth) => truth.reflectance(cos_theta, thickness_nm),
            Self::Film(_) | Self::Habit(..) | Self::Refused(_) => return None,
        })
    }
}

/// The paper's model with all its weight on the specular part. Its lower boundary gets what Fresnel's equations
/// say at normal incidence, and the half wave where the index falls: its parameters cannot say more of a stack.
fn layered(stack: &Stack) -> Result<Compiled, Error> {
    let amplitudes = RGB_WAVELENGTHS_NM.map(|nm| {
        let [film, below] = [&stack.film, &stack.base].map(|medium| medium.index(nm));
        (film - below) * (film + below).inverse()
    });
    let base = amplitudes.map(|amplitude| amplitude.norm_squared().min(1.0) as f32);
    let eta = RGB_WAVELENGTHS_NM.map(|nm| stack.film.index(nm).re as f32);
    let ambient = stack.ambient.index(RGB_WAVELENGTHS_NM[1]).re as f32;
    let is_falling = amplitudes[1].re > 0.0;
    let description = Description::new("layered")
        .choose("variant", "paper")
        .choose("phase_shift", if is_falling { "half_wave" } else { "none" })
        .set("eta", &eta)
        .set("ambient_eta", &[ambient])
        .set("base", &base)
        .set("specular_weight", &[1.0])
        .set("diffuse_weight", &[0.0])
        .vary("thickness_nm", 0.0, 1e5);
    let bsdfs = (Bsdf::new(&description)?, Bsdf::new(&description)?);
    Ok(Compiled::Layered(Box::new(bsdfs)))
}
