//! What the test programs share: directions, random numbers, and descriptions drawn from the registry.

#![allow(dead_code)] // each test program uses a part

pub mod films;

use films::Kind;
use glam::{DVec3, Vec3};
use pellicle::bsdf::{Exception, Flags, ParamKind, RegisteredModel, Values};
use pellicle::{Bsdf, Description, Scalar, Status};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

pub fn rng(seed: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed)
}

/// A direction from polar angle and azimuth in degrees.
pub fn degrees(theta: f64, phi: f64) -> DVec3 {
    let (theta, phi) = (theta.to_radians(), phi.to_radians());
    DVec3::new(
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    )
}

/// A direction rounded to single precision, in both precisions: the same numbers, so that two
/// instances can be compared.
pub fn rounded(w: DVec3) -> (Vec3, DVec3) {
    let single = w.as_vec3();
    (single, single.as_dvec3())
}

/// Uniform over the upper hemisphere.
pub fn hemisphere(rng: &mut impl Rng) -> DVec3 {
    let z: f64 = 1.0 - rng.random::<f64>();
    let phi = std::f64::consts::TAU * rng.random::<f64>();
    let radius = (1.0 - z * z).sqrt();
    DVec3::new(radius * phi.cos(), radius * phi.sin(), z)
}

/// Three uniform numbers in [0, 1).
pub fn uniforms(rng: &mut impl Rng) -> [f32; 3] {
    // 24 bits: every value is representable and below 1.
    std::array::from_fn(|_| (rng.random::<u32>() >> 8) as f32 / 16_777_216.0)
}

/// A number in [min, max]: half of the time spread evenly, half by its logarithm, so that wide
/// ranges are seen at every scale, and so is what lies next to 0; now and then an end itself.
pub fn number(rng: &mut impl Rng, min: f32, max: f32) -> f32 {
    match rng.random_range(0..16) {
        0 => min,
        1 => max,
        2..=8 => min + (max - min) * rng.random::<f32>(),
        9..=10 if min == 0.0 => max * (-4.0 * rng.random::<f32>()).exp2().powf(3.3),
        _ => min + ((max - min + 1.0).ln() * rng.random::<f32>()).exp_m1(),
    }
    .clamp(min, max)
}

/// A direction on a side that the BSDF has: the upper, or either.
pub fn visible<T: Scalar>(bsdf: &Bsdf<T>, rng: &mut impl Rng) -> DVec3 {
    let up = hemisphere(rng);
    if bsdf.flags().contains(Flags::TRANSMISSION) && rng.random_bool(0.5) {
        -up
    } else {
        up
    }
}

/// Whether no lobe has a density.
pub fn is_dirac<T: Scalar>(bsdf: &Bsdf<T>) -> bool {
    bsdf.lobe_infos()
        .iter()
        .all(|lobe| lobe.flags.contains(Flags::DELTA))
}

/// A model's name and every parameter at its default, with a film if it needs one then.
pub fn defaults(entry: &RegisteredModel) -> Description {
    let description = Description::new(entry.name());
    if (entry.needs_film)(&Values::defaults(entry.info)) {
        let thickness = entry.info.film_thickness.unwrap();
        description
            .film(Kind::Lens.film())
            .set(entry.info.params[thickness].name(), &[300.0])
    } else {
        description
    }
}

/// So many combinations of choices are all tried; of further ones some.
const MOST_COMBINATIONS: usize = 128;

/// How many combinations of a model's choices [`Drawn::new`] runs through.
pub fn combinations(entry: &RegisteredModel) -> u64 {
    let counts = entry.info.params.iter().map(|param| match param.kind {
        ParamKind::Choice { choices } => choices.len(),
        _ => 1,
    });
    let extended = |product, count| {
        if product * count <= MOST_COMBINATIONS {
            product * count
        } else {
            product
        }
    };
    counts.fold(1, extended) as u64
}

/// A model with random parameters, all within their ranges.
pub struct Drawn {
    pub entry: &'static RegisteredModel,
    pub description: Description,
    choices: Vec<usize>,
}

impl Drawn {
    /// Draws until the combination is valid too (weights that must not sum to more than 1, parameters
    /// that not every choice takes). Seeds in a row run through all combinations of the choices.
    pub fn new(entry: &'static RegisteredModel, seed: u64) -> Self {
        let mut rng = rng(seed);
        for _ in 0..10_000 {
            let drawn = Self::candidate(entry, seed, &mut rng);
            match Bsdf::<f32>::new(&drawn.description) {
                Ok(_) => return drawn,
                Err(error) => assert!(
                    matches!(error.status, Status::OutOfRange | Status::Unsupported),
                    "{error}"
                ),
            }
        }
        panic!("no valid parameters found for {}", entry.name());
    }

    /// The choices follow from the combination's number as long as they are not too many, the others
    /// are drawn.
    fn candidate(entry: &'static RegisteredModel, combination: u64, rng: &mut impl Rng) -> Self {
        let mut description = Description::new(entry.name());
        let mut choices = Vec::new();
        let mut rest = combination;
        let mut combinations = 1;
        let mut values = Values::defaults(entry.info);
        for (index, param) in entry.info.params.iter().enumerate() {
            if entry.info.film_thickness == Some(index) {
                choices.push(0);
                continue;
            }
            let mut choice = 0;
            match param.kind {
                ParamKind::Number {
                    components,
                    min,
                    max,
                    ..
                } => {
                    let equal = rng.random_bool(0.3);
                    let first = number(rng, min, max);
                    let numbers: Vec<f32> = (0..components)
                        .map(|_| if equal { first } else { number(rng, min, max) })
                        .collect();
                    description = description.set(param.name(), &numbers);
                }
                ParamKind::Direction { min_z } => {
                    let mut w = hemisphere(rng).as_vec3();
                    if rng.random_bool(0.3) {
                        w = Vec3::Z;
                    }
                    w.z = w.z.max(min_z * 1.01);
                    description = description.set(param.name(), &w.to_array());
                }
                ParamKind::Choice { choices } => {
                    choice = rng.random_range(0..choices.len());
                    if combinations * choices.len() <= MOST_COMBINATIONS {
                        combinations *= choices.len();
                        choice = rest as usize % choices.len();
                        rest /= choices.len() as u64;
                    }
                    let name = choices[choice];
                    description = description.choose(param.name(), name);
                    values.set_choice(index, choice);
                }
            }
            choices.push(choice);
        }
        if (entry.needs_film)(&values) {
            // A smooth surface asks for a colour or two, a rough one for thousands.
            let mut lobes = entry.info.lobes.iter();
            let is_dirac = lobes.all(|lobe| lobe.flags.contains(Flags::DELTA));
            let kinds = if is_dirac {
                &Kind::ALL[..]
            } else {
                &Kind::QUICK
            };
            let film = kinds[rng.random_range(0..kinds.len())].film();
            let thickness = entry.info.film_thickness.unwrap();
            if let Some([min, max]) = film.varying_thickness_nm() {
                let thickness_nm = number(rng, min as f32, max as f32);
                description = description.set(entry.info.params[thickness].name(), &[thickness_nm]);
            }
            description = description.film(film);
        }
        Self {
            entry,
            description,
            choices,
        }
    }

    /// The description with all parameters varying that `may` chooses, as far as the model allows it, and of each
    /// how many components it has and its range: that of numbers, [0, 0] of directions.
    pub fn varying(&self, mut may: impl FnMut() -> bool) -> (Description, Vec<(usize, [f32; 2])>) {
        let info = &self.entry.info;
        let mut description = self.description.clone();
        let mut varying = Vec::new();
        for (index, param) in info.params.iter().enumerate() {
            let range = match param.kind {
                _ if !param.can_vary || !may() => continue,
                _ if info.film_thickness == Some(index) => [100.0, 200.0],
                ParamKind::Number { min, max, .. } => [min, max],
                _ => [0.0; 2],
            };
            let varied = description.clone().vary(param.name(), range[0], range[1]);
            if Bsdf::<f32>::new(&varied).is_ok() {
                description = varied;
                varying.push((param.components(), range));
            }
        }
        (description, varying)
    }

    /// What is chosen for the parameter of that name.
    pub fn choice(&self, name: &str) -> &'static str {
        let index = self.entry.info.param(name).unwrap();
        match self.entry.info.params[index].kind {
            ParamKind::Choice { choices } => choices[self.choices[index]],
            _ => panic!("{name} is no choice"),
        }
    }

    /// Whether the model has declared that it breaks a law with these parameters.
    pub fn is_excepted(&self, exception: &Option<Exception>) -> bool {
        exception
            .as_ref()
            .is_some_and(|exception| exception.applies(|param| self.choices[param]))
    }

    pub fn single(&self) -> Bsdf<f32> {
        Bsdf::new(&self.description).unwrap()
    }

    pub fn double(&self) -> Bsdf<f64> {
        Bsdf::new(&self.description).unwrap()
    }
}
