//! Who is tried, and what each compiles to.

use super::scene::Scene;
use super::stack::Stack;
use pellicle::film::{CompiledMethod, Film, FilmDescription, OneLayer, OneLayerMethod};
use pellicle::num::Rgb;
use pellicle::optics::RGB_WAVELENGTHS_NM;
use pellicle::{Bsdf, Description};
use std::cell::OnceCell;

/// One method with one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contender {
    /// The model `layered`, variant `paper`, at the mirror direction (GH02 eq. 5).
    Layered,
    /// A method for one film on a base.
    Kind(OneLayerMethod),
    /// A film made to use a method, within a tolerance.
    Forced(&'static str, f64),
    /// A film as the plan compiles it for a tolerance.
    Planned(f64),
}

/// The methods that may be asked for by name and can fail.
pub const FORCED: [&str; 7] = [
    "two_beam",
    "airy_rgb",
    "quadrature",
    "harmonics",
    "bands",
    "series",
    "table",
];

/// A contender, ready for a stack.
pub enum Compiled {
    Layered(Box<(Bsdf<f32>, Bsdf<f64>)>),
    Method(Box<CompiledTwice>),
    Film(Box<Film>),
    /// Why it does not take the stack.
    Refused(String),
}

/// A method in single precision, and when it is asked for in double.
pub struct CompiledTwice {
    kind: OneLayerMethod,
    layer: OneLayer,
    single: Box<dyn CompiledMethod<f32>>,
    double: OnceCell<Box<dyn CompiledMethod<f64>>>,
}

impl Contender {
    /// The columns of the pictures, from the paper's model to ours.
    pub const DRAWN: [Self; 9] = [
        Self::Layered,
        Self::Kind(OneLayerMethod::TwoBeam),
        Self::Kind(OneLayerMethod::AiryRgb),
        Self::Kind(OneLayerMethod::Harmonics(3)),
        Self::Kind(OneLayerMethod::Quadrature(16)),
        Self::Kind(OneLayerMethod::Bands(32)),
        Self::Forced("series", 2e-3),
        Self::Planned(2e-3),
        Self::Planned(2e-4),
    ];

    /// Those that the tables have besides.
    pub const FURTHER: [Self; 5] = [
        Self::Kind(OneLayerMethod::Quadrature(64)),
        Self::Kind(OneLayerMethod::Harmonics(16)),
        Self::Kind(OneLayerMethod::Bands(256)),
        Self::Forced("table", 2e-3),
        Self::Planned(1e-2),
    ];

    /// As tables name it.
    pub fn name(self) -> String {
        match self {
            Self::Layered => "layered, paper".into(),
            Self::Kind(OneLayerMethod::TwoBeam) => "two_beam".into(),
            Self::Kind(OneLayerMethod::AiryRgb) => "airy_rgb".into(),
            Self::Kind(OneLayerMethod::Quadrature(count)) => format!("quadrature {count}"),
            Self::Kind(OneLayerMethod::Bands(count)) => format!("bands {count}"),
            Self::Kind(OneLayerMethod::Harmonics(order)) => {
                format!("harmonics {order}")
            }
            Self::Forced(method, tolerance) => format!("{method}, {tolerance:e}"),
            Self::Planned(tolerance) => format!("plan, {tolerance:e}"),
        }
    }

    /// What error is promised, if any.
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Self::Forced(_, tolerance) | Self::Planned(tolerance) => Some(tolerance),
            Self::Layered | Self::Kind(_) => None,
        }
    }

    /// For a scene, at a place on its horizontal axis.
    pub fn compile(self, scene: &Scene, x: f64) -> Compiled {
        let stack = scene.stack_at(x);
        match self {
            Self::Layered => layered(&stack),
            Self::Kind(kind) => method(kind, &stack),
            Self::Planned(tolerance) => film(&stack.description(scene.range_nm(x), tolerance)),
            Self::Forced(method, tolerance) => film(&FilmDescription {
                method: Some(method.into()),
                ..stack.description(scene.range_nm(x), tolerance)
            }),
        }
    }
}

impl Compiled {
    /// Linear RGB in single precision; none if it was refused.
    pub fn single(&self, cos_theta: f32, thickness_nm: f32) -> Option<Rgb<f32>> {
        Some(match self {
            Self::Layered(bsdf) if cos_theta > 0.0 => {
                let sine = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
                let [wo, wi] = [sine, -sine].map(|x| glam::Vec3::new(x, 0.0, cos_theta));
                let value = bsdf.0.eval(wo, wi, Some(&[thickness_nm]));
                value.map(|channel| channel / cos_theta)
            }
            Self::Layered(_) => [0.0; 3],
            Self::Method(method) => method.single.reflectance(cos_theta, thickness_nm),
            Self::Film(film) => film.reflectance(cos_theta, thickness_nm),
            Self::Refused(_) => return None,
        })
    }

    /// In double precision; films have none of their own.
    pub fn double(&self, cos_theta: f64, thickness_nm: f64) -> Option<Rgb<f64>> {
        Some(match self {
            Self::Layered(bsdf) => {
                let sine = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
                let [wo, wi] = [sine, -sine].map(|x| glam::DVec3::new(x, 0.0, cos_theta));
                let value = bsdf.1.eval(wo, wi, Some(&[thickness_nm]));
                value.map(|channel| channel / cos_theta)
            }
            Self::Method(method) => {
                let compile = || method.kind.double(&method.layer).unwrap();
                let double = method.double.get_or_init(compile);
                double.reflectance(cos_theta, thickness_nm)
            }
            Self::Film(_) | Self::Refused(_) => return None,
        })
    }
}

fn method(kind: OneLayerMethod, stack: &Stack) -> Compiled {
    let layer = stack.one_layer();
    Compiled::Method(Box::new(CompiledTwice {
        kind,
        single: kind.single(&layer).unwrap(),
        double: OnceCell::new(),
        layer,
    }))
}

fn film(description: &FilmDescription) -> Compiled {
    match Film::new(description) {
        Ok(film) => Compiled::Film(Box::new(film)),
        Err(error) => Compiled::Refused(error.message.into_owned()),
    }
}

/// The paper's model with all the weight on its specular part. Its lower boundary is given what
/// Fresnel's equations say at normal incidence, and the half wave where the index falls: the most that
/// its parameters can say of a stack.
fn layered(stack: &Stack) -> Compiled {
    let [mut eta, mut base, mut is_falling] = [[0.0f32; 3], [0.0; 3], [0.0; 3]];
    for (c, nm) in RGB_WAVELENGTHS_NM.into_iter().enumerate() {
        let [film, below] = [&stack.film, &stack.base].map(|medium| medium.index(nm));
        let amplitude = (film - below) * (film + below).inverse();
        eta[c] = film.re as f32;
        base[c] = amplitude.norm_squared().min(1.0) as f32;
        is_falling[c] = amplitude.re as f32;
    }
    let ambient = stack.ambient.index(RGB_WAVELENGTHS_NM[1]).re as f32;
    let shift = if is_falling[1] > 0.0 {
        "half_wave"
    } else {
        "none"
    };
    let description = Description::new("layered")
        .choose("variant", "paper")
        .choose("phase_shift", shift)
        .set("eta", &eta)
        .set("ambient_eta", &[ambient])
        .set("base", &base)
        .set("specular_weight", &[1.0])
        .set("diffuse_weight", &[0.0])
        .vary("thickness_nm", 0.0, 1e5);
    let bsdf = Bsdf::new(&description).and_then(|single| Ok((single, Bsdf::new(&description)?)));
    match bsdf {
        Ok(bsdf) => Compiled::Layered(Box::new(bsdf)),
        Err(error) => Compiled::Refused(error.message.into_owned()),
    }
}
