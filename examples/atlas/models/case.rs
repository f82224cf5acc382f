//! Models and the parameters that they are tried over.

use crate::atlas::axis::{Axis, Scale};
use pellicle::bsdf::{Exception, ParamKind, find};
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use pellicle::{Description, Error};
use std::sync::Arc;

/// Choices of a model, each with its parameter.
pub type Choices = &'static [(&'static str, &'static str)];
/// What sets the numbers that a map has, the one across among them.
type Set = Box<dyn Fn(Description, f32) -> Description + Send + Sync>;

/// A model, and the parameter that changes across its map.
pub struct Case {
    pub model: &'static str,
    pub choices: Choices,
    /// Further words that tell it from like ones; may be empty.
    pub detail: &'static str,
    /// Of the parameter.
    pub x: Axis,
    set: Set,
}

impl Case {
    fn new(
        model: &'static str,
        choices: Choices,
        detail: &'static str,
        x: Axis,
        set: impl Fn(Description, f32) -> Description + Send + Sync + 'static,
    ) -> Self {
        let set = Box::new(set);
        Self {
            model,
            choices,
            detail,
            x,
            set,
        }
    }

    /// Model, choices and details.
    pub fn name(&self) -> String {
        let choices = self.choices.iter().map(|(_, choice)| *choice);
        let detail = Some(self.detail).filter(|detail| !detail.is_empty());
        let words: Vec<&str> = [self.model]
            .into_iter()
            .chain(choices)
            .chain(detail)
            .collect();
        words.join(", ")
    }

    /// With the parameter at a value.
    pub fn describe(&self, x: f64) -> Description {
        let description = Description::new(self.model);
        let chosen = |d: Description, (name, choice): &(&str, &str)| d.choose(name, choice);
        let description = self.choices.iter().fold(description, chosen);
        (self.set)(description, x as f32)
    }

    /// Whether the model says that with these choices it is not reciprocal, and that it does not conserve
    /// energy.
    pub fn declared(&self) -> Result<[bool; 2], Error> {
        let info = find(self.model)?.info;
        let chosen = |param: usize| {
            let param = &info.params[param];
            let ParamKind::Choice { choices } = &param.kind else {
                return 0;
            };
            let given = self.choices.iter().find(|(name, _)| *name == param.name());
            let is_given = |choice: &str| given.is_some_and(|given| choice == given.1);
            choices
                .iter()
                .position(|choice| is_given(choice))
                .unwrap_or(0)
        };
        let is_excepted = |exception: &Option<Exception>| {
            exception
                .as_ref()
                .is_some_and(|exception| exception.applies(chosen))
        };
        Ok([&info.not_reciprocal, &info.not_conserving].map(is_excepted))
    }
}

const ALPHA: Axis = Axis {
    name: "alpha",
    scale: Scale::Log,
    first: 1e-4,
    last: 1.0,
    ticks: &[1e-4, 1e-2, 1.0],
};

const EXPONENT: Axis = Axis {
    name: "exponent",
    scale: Scale::Log,
    first: 0.1,
    last: 1e5,
    ticks: &[0.1, 100.0, 1e5],
};

const ROUGHNESS: Axis = Axis {
    name: "roughness",
    scale: Scale::Linear,
    first: 0.0,
    last: 1.0,
    ticks: &[0.0, 0.5, 1.0],
};

const INDEX: Axis = Axis {
    name: "index",
    first: 1.0,
    last: 4.0,
    ticks: &[1.0, 2.0, 4.0],
    ..ROUGHNESS
};

/// Roughness of the microfacet maps that have another parameter across.
const FIXED_ALPHA: f32 = 0.1;

/// All cases. Surfaces are white wherever that can be said: white ones show every excess.
pub fn all() -> Vec<Case> {
    let mut cases = diffuse();
    cases.extend(phong_and_layered());
    cases.extend(distributions());
    cases.extend(fresnel());
    cases
}

fn diffuse() -> Vec<Case> {
    let sigma = Axis {
        name: "sigma_radians",
        last: std::f64::consts::FRAC_PI_2,
        ticks: &[0.0, 0.8],
        ..ROUGHNESS
    };
    let reflectance = Axis {
        name: "reflectance",
        ..ROUGHNESS
    };
    let white = |name: &'static str| {
        move |model: Description, x| model.set("reflectance", &[1.0]).set(name, &[x])
    };
    vec![
        Case::new("lambert", &[], "", reflectance, |model, x| {
            model.set("reflectance", &[x])
        }),
        Case::new(
            "oren_nayar",
            &[("form", "full")],
            "",
            sigma,
            white("sigma_radians"),
        ),
        Case::new(
            "oren_nayar",
            &[("form", "qualitative")],
            "",
            sigma,
            white("sigma_radians"),
        ),
        Case::new("disney_diffuse", &[], "", ROUGHNESS, white("roughness")),
    ]
}

fn phong_and_layered() -> Vec<Case> {
    let thickness = Axis {
        name: "thickness (nm)",
        scale: Scale::Log,
        first: 1.0,
        last: 1e5,
        ticks: &[1.0, 300.0, 1e5],
    };
    let layered = |variant: Choices, x, parameters: &'static [&'static str]| {
        Case::new("layered", variant, "", x, move |model, x| {
            parameters
                .iter()
                .fold(model, |model, name| model.set(name, &[x]))
        })
    };
    const ENERGY: Choices = &[("variant", "energy")];
    const PAPER: Choices = &[("variant", "paper")];
    const EXPONENTS: &[&str] = &["exponent_reflection", "exponent_transmission"];
    let phong = |model: Description, x| {
        let model = model.set("diffuse", &[0.0]).set("specular", &[1.0]);
        model.set("exponent", &[x])
    };
    vec![
        Case::new("phong", &[], "", EXPONENT, phong),
        layered(ENERGY, EXPONENT, EXPONENTS),
        layered(ENERGY, INDEX, &["eta"]),
        layered(ENERGY, thickness, &["thickness_nm"]),
        layered(PAPER, EXPONENT, EXPONENTS),
        layered(PAPER, INDEX, &["eta"]),
    ]
}

fn distributions() -> Vec<Case> {
    let case = |choices: Choices, detail, set: fn(Description) -> Description| {
        Case::new("microfacet", choices, detail, ALPHA, move |model, x| {
            set(model).set("f0", &[1.0]).set("alpha", &[x])
        })
    };
    let plain = |model: Description| model;
    vec![
        case(&[("distribution", "ggx"), ("masking", "smith")], "", plain),
        case(
            &[("distribution", "ggx"), ("masking", "smith")],
            "stretched",
            |model| {
                model
                    .set("anisotropy", &[1.0])
                    .set("rotation_turns", &[0.1])
            },
        ),
        case(
            &[("distribution", "ggx"), ("masking", "smith")],
            "compensated",
            |model| model.choose("energy_compensation", "on"),
        ),
        case(
            &[("distribution", "beckmann"), ("masking", "smith")],
            "",
            plain,
        ),
        case(
            &[("distribution", "beckmann"), ("masking", "cook_torrance")],
            "",
            plain,
        ),
        case(
            &[("distribution", "blinn_phong"), ("masking", "smith")],
            "",
            plain,
        ),
        case(&[("distribution", "sgd"), ("masking", "smith")], "", plain),
        case(&[("distribution", "abc"), ("masking", "smith")], "", plain),
        case(
            &[("distribution", "abc"), ("masking", "schlick")],
            "exponent 0.5",
            |model| model.set("abc_exponent", &[0.5]),
        ),
    ]
}

fn fresnel() -> Vec<Case> {
    let wide = Axis {
        last: 10.0,
        ticks: &[1.0, 5.0, 10.0],
        ..INDEX
    };
    let extinction = Axis {
        name: "k",
        first: 0.0,
        last: 20.0,
        ticks: &[0.0, 10.0, 20.0],
        ..INDEX
    };
    let thickness = Axis {
        name: "thickness (nm)",
        first: 0.0,
        last: 900.0,
        ticks: &[0.0, 450.0, 900.0],
        ..INDEX
    };
    let rough = |choices: Choices, x, name: &'static str| {
        Case::new("microfacet", choices, "", x, move |model, x| {
            model.set("alpha", &[FIXED_ALPHA]).set(name, &[x])
        })
    };
    let metallic = |detail, metallic: f32| {
        Case::new(
            "metallic_roughness",
            &[],
            detail,
            ROUGHNESS,
            move |model, x| {
                let white = model.set("base_color", &[1.0]).set("metallic", &[metallic]);
                white.set("roughness", &[x])
            },
        )
    };
    let bubble = bubble();
    let film = Arc::clone(&bubble);
    vec![
        rough(&[("fresnel", "dielectric")], wide, "eta"),
        rough(&[("fresnel", "conductor")], extinction, "k"),
        Case::new(
            "microfacet",
            &[("fresnel", "film")],
            "soap",
            thickness,
            move |model, x| {
                let model = model.set("alpha", &[FIXED_ALPHA]).film(Arc::clone(&bubble));
                model.set("thickness_nm", &[x])
            },
        ),
        Case::new("film", &[], "soap", thickness, move |model, x| {
            model.film(Arc::clone(&film)).set("thickness_nm", &[x])
        }),
        metallic("dielectric", 0.0),
        metallic("metal", 1.0),
    ]
}

/// Water between vacuum and vacuum.
fn bubble() -> Arc<Film> {
    let water = Medium::named("water").unwrap();
    let bubble = FilmDescription {
        transmittance: true,
        ..FilmDescription::new(Medium::vacuum()).layer(water, [0.0, 900.0])
    };
    Arc::new(Film::new(&bubble).unwrap())
}
