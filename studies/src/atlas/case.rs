//! Models and the parameters that they are tried over.

use crate::error_maps::axis::{Axis, Scale};
use crate::shared::draw::names;
use pellicle::bsdf::{Exception, find};
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use pellicle::{Description, Error};
use std::sync::Arc;

/// Choices of a model, each with its parameter.
type Choices = &'static [(&'static str, &'static str)];
/// Sets the numbers of a map, the one across among them.
type Set = Box<dyn Fn(Description, f32) -> Description + Send + Sync>;

/// A model, and the parameter that changes across its map.
pub struct Case {
    pub model: &'static str,
    choices: Choices,
    /// Further words of the name; may be empty.
    detail: &'static str,
    /// The parameter.
    pub x: Axis,
    set: Set,
}

fn case(
    model: &'static str,
    choices: Choices,
    detail: &'static str,
    x: Axis,
    set: impl Fn(Description, f32) -> Description + Send + Sync + 'static,
) -> Case {
    let set = Box::new(set);
    Case {
        model,
        choices,
        detail,
        x,
        set,
    }
}

impl Case {
    /// Model, choices and details.
    pub fn name(&self) -> String {
        let choices = self.choices.iter().map(|(_, choice)| *choice);
        let words = [self.model].into_iter().chain(choices).chain([self.detail]);
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        words.join(", ")
    }

    /// The description with the parameter at a value.
    pub fn describe(&self, x: f64) -> Description {
        let description = Description::new(self.model);
        let chosen = |d: Description, (name, choice): &(&str, &str)| d.choose(name, choice);
        let description = self.choices.iter().fold(description, chosen);
        (self.set)(description, x as f32)
    }

    /// Whether the model declares that with these choices it is not reciprocal, and that it does not conserve energy.
    pub fn declared(&self) -> Result<[bool; 2], Error> {
        let entry = find(self.model)?;
        let chosen = |param: usize| {
            let name = entry.info.params[param].name();
            let given = self.choices.iter().find(|(param, _)| *param == name);
            let position =
                |(_, choice): &(&str, &str)| names(entry, param).iter().position(|n| n == choice);
            given.and_then(position).unwrap_or(0)
        };
        let exceptions = [&entry.info.not_reciprocal, &entry.info.not_conserving];
        let applies = |exception: &Exception| exception.applies(chosen);
        Ok(exceptions.map(|exception| exception.as_ref().is_some_and(applies)))
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

const ROUGHNESS: Axis = linear("roughness", [0.0, 1.0], &[0.0, 0.5, 1.0]);
const REFLECTANCE: Axis = linear("reflectance", [0.0, 1.0], &[0.0, 0.5, 1.0]);
const SIGMA: Axis = linear("sigma", [0.0, std::f64::consts::FRAC_PI_2], &[0.0, 0.8]);
const INDEX: Axis = linear("index", [1.0, 4.0], &[1.0, 2.0, 4.0]);
const WIDE_INDEX: Axis = linear("index", [1.0, 10.0], &[1.0, 5.0, 10.0]);
const EXTINCTION: Axis = linear("k", [0.0, 20.0], &[0.0, 10.0, 20.0]);
const BUBBLE: Axis = linear("thickness (nm)", [0.0, 900.0], &[0.0, 450.0, 900.0]);
const THICKNESS: Axis = Axis {
    name: "thickness (nm)",
    scale: Scale::Log,
    first: 1.0,
    last: 1e5,
    ticks: &[1.0, 300.0, 1e5],
};

const fn linear(name: &'static str, [first, last]: [f64; 2], ticks: &'static [f64]) -> Axis {
    Axis {
        name,
        scale: Scale::Linear,
        first,
        last,
        ticks,
    }
}

/// The roughness of the microfacet maps that have another parameter across.
const FIXED_ALPHA: f32 = 0.1;

/// All cases. Surfaces are white where the parameters allow it: white ones show every excess.
pub fn all() -> Vec<Case> {
    let mut cases = diffuse();
    cases.extend(phong_and_layered());
    cases.extend(distributions());
    cases.extend(fresnel());
    cases
}

fn diffuse() -> Vec<Case> {
    let white = |name: &'static str| {
        move |model: Description, x| model.set("reflectance", &[1.0]).set(name, &[x])
    };
    let lambert = |model: Description, x| model.set("reflectance", &[x]);
    vec![
        case("lambert", &[], "", REFLECTANCE, lambert),
        case(
            "oren_nayar",
            &[("form", "full")],
            "",
            SIGMA,
            white("sigma_radians"),
        ),
        case(
            "oren_nayar",
            &[("form", "qualitative")],
            "",
            SIGMA,
            white("sigma_radians"),
        ),
        case("disney_diffuse", &[], "", ROUGHNESS, white("roughness")),
    ]
}

fn phong_and_layered() -> Vec<Case> {
    let phong = |model: Description, x| {
        let model = model.set("diffuse", &[0.0]).set("specular", &[1.0]);
        model.set("exponent", &[x])
    };
    let layered = |variant: Choices, x, names: &'static [&'static str]| {
        let set = move |model, x| {
            names
                .iter()
                .fold(model, |model: Description, name| model.set(name, &[x]))
        };
        case("layered", variant, "", x, set)
    };
    const ENERGY: Choices = &[("variant", "energy")];
    const PAPER: Choices = &[("variant", "paper")];
    const EXPONENTS: &[&str] = &["exponent_reflection", "exponent_transmission"];
    vec![
        case("phong", &[], "", EXPONENT, phong),
        layered(ENERGY, EXPONENT, EXPONENTS),
        layered(ENERGY, INDEX, &["eta"]),
        layered(ENERGY, THICKNESS, &["thickness_nm"]),
        layered(PAPER, EXPONENT, EXPONENTS),
        layered(PAPER, INDEX, &["eta"]),
    ]
}

fn distributions() -> Vec<Case> {
    let rough = |choices: Choices, detail, set: fn(Description) -> Description| {
        case("microfacet", choices, detail, ALPHA, move |model, x| {
            set(model).set("f0", &[1.0]).set("alpha", &[x])
        })
    };
    const GGX: Choices = &[("distribution", "ggx"), ("masking", "smith")];
    const BECKMANN: Choices = &[("distribution", "beckmann"), ("masking", "smith")];
    const V_GROOVES: Choices = &[("distribution", "beckmann"), ("masking", "cook_torrance")];
    const BLINN_PHONG: Choices = &[("distribution", "blinn_phong"), ("masking", "smith")];
    const SGD: Choices = &[("distribution", "sgd"), ("masking", "smith")];
    const ABC: Choices = &[("distribution", "abc"), ("masking", "smith")];
    const ABC_SCHLICK: Choices = &[("distribution", "abc"), ("masking", "schlick")];
    let plain = |model| model;
    vec![
        rough(GGX, "", plain),
        rough(GGX, "stretched", |model| {
            model
                .set("anisotropy", &[1.0])
                .set("rotation_turns", &[0.1])
        }),
        rough(GGX, "compensated", |model| {
            model.choose("energy_compensation", "on")
        }),
        rough(BECKMANN, "", plain),
        rough(V_GROOVES, "", plain),
        rough(BLINN_PHONG, "", plain),
        rough(SGD, "", plain),
        rough(ABC, "", plain),
        rough(ABC_SCHLICK, "exponent 0.5", |model| {
            model.set("abc_exponent", &[0.5])
        }),
    ]
}

fn fresnel() -> Vec<Case> {
    let rough = |choices: Choices, x, name: &'static str| {
        case("microfacet", choices, "", x, move |model, x| {
            model.set("alpha", &[FIXED_ALPHA]).set(name, &[x])
        })
    };
    let metallic = |detail, metallic: f32| {
        case(
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
    let on_bubble =
        move |model: Description, x| model.film(Arc::clone(&bubble)).set("thickness_nm", &[x]);
    let rough_bubble = on_bubble.clone();
    vec![
        rough(&[("fresnel", "dielectric")], WIDE_INDEX, "eta"),
        rough(&[("fresnel", "conductor")], EXTINCTION, "k"),
        case(
            "microfacet",
            &[("fresnel", "film")],
            "soap",
            BUBBLE,
            move |model, x| rough_bubble(model.set("alpha", &[FIXED_ALPHA]), x),
        ),
        case("film", &[], "soap", BUBBLE, on_bubble),
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

/// A new model needs a map: this names the one that has none. Every case can be created over its whole axis.
#[test]
fn every_model_has_a_map() {
    let cases = all();
    let has_map = |name: &str| cases.iter().any(|case| case.model == name);
    let names = pellicle::bsdf::models().iter().map(|entry| entry.name());
    let missing: Vec<&str> = names.filter(|name| !has_map(name)).collect();
    assert!(
        missing.is_empty(),
        "no map in studies/src/atlas/case.rs: {missing:?}"
    );
    for case in &cases {
        for part in [0.0, 0.5, 1.0] {
            let found = super::laws::Subject::new(case, case.x.at(part));
            assert!(found.is_ok(), "{}: {:?}", case.name(), found.err());
        }
    }
}
