//! BSDFs with random parameters, some of which vary within ranges that creation accepts.

use super::batch::Varying;
use super::directions::{hemisphere, number};
use super::films::Kind;
use glam::Vec3;
use pellicle::bsdf::{Exception, ParamKind, RegisteredModel, Values, models};
use pellicle::{Bsdf, Description, Status};
use rand::{Rng, RngExt};

/// A model has a variant for each combination of its first choices, as long as they are at most this many.
const MOST_COMBINATIONS: usize = 32;

/// A model with some of its choices made.
pub struct Variant {
    pub entry: &'static RegisteredModel,
    /// Model and choices.
    pub name: String,
    /// What is chosen for each parameter; none: anything.
    pub choices: Vec<Option<usize>>,
}

/// The variants of all models: all combinations of a model's first choices, the others at their defaults; and each
/// of these others with anything before it, and the defaults after it.
pub fn variants() -> Vec<Variant> {
    models().iter().flat_map(variants_of).collect()
}

/// The names that a parameter can be; none if it is no choice.
pub fn names(entry: &RegisteredModel, param: usize) -> Vec<&'static str> {
    match entry.info.params[param].kind {
        ParamKind::Choice { choices } => choices.to_vec(),
        _ => Vec::new(),
    }
}

/// The variants of one model.
pub fn variants_of(entry: &'static RegisteredModel) -> Vec<Variant> {
    let params = entry.info.params.len();
    let count = |param: usize| names(entry, param).len().max(1);
    let mut combined = 0;
    let mut product = 1;
    while combined < params && product * count(combined) <= MOST_COMBINATIONS {
        product *= count(combined);
        combined += 1;
    }
    let mut all = Vec::new();
    for combination in 0..product {
        let mut rest = combination;
        let mut choices = vec![Some(0); params];
        for (param, choice) in choices.iter_mut().enumerate().take(combined) {
            *choice = Some(rest % count(param));
            rest /= count(param);
        }
        all.push(Variant::new(entry, choices, 0..combined));
    }
    for param in (combined..params).filter(|param| count(*param) > 1) {
        for choice in 0..count(param) {
            let mut choices = vec![None; params];
            choices[param..].fill(Some(0));
            choices[param] = Some(choice);
            all.push(Variant::new(entry, choices, param..param + 1));
        }
    }
    all
}

impl Variant {
    fn new(
        entry: &'static RegisteredModel,
        choices: Vec<Option<usize>>,
        named: std::ops::Range<usize>,
    ) -> Self {
        let mut name = entry.name().to_owned();
        for param in named {
            let all = names(entry, param);
            if let (2.., Some(choice)) = (all.len(), choices[param]) {
                let choice = all[choice];
                let is_first = name.len() == entry.name().len();
                name += &match (["on", "off", "none"].contains(&choice), is_first) {
                    (true, _) => format!(" {} {choice}", entry.info.params[param].name()),
                    (false, true) => format!(" {choice}"),
                    (false, false) => format!("/{choice}"),
                };
            }
        }
        Self {
            entry,
            name,
            choices,
        }
    }
}

/// A parameter that varies.
#[derive(Clone, Copy, Debug)]
pub struct Varied {
    pub name: &'static str,
    pub components: usize,
    /// Of its numbers; none of a direction.
    pub range: Option<[f32; 2]>,
}

/// A description that creation accepts.
pub struct Drawn {
    pub entry: &'static RegisteredModel,
    pub description: Description,
    /// In the order of a call's varying numbers.
    pub varied: Vec<Varied>,
    choices: Vec<usize>,
    /// The range of the film's thickness, if there is a film whose thickness varies.
    thickness_nm: Option<[f32; 2]>,
    /// The greatest deviation of that thickness that the film averages over, nm.
    most_spread_nm: f32,
}

/// Times a range is drawn for a parameter before it stays fixed.
const RANGES_TRIED: usize = 8;

impl Drawn {
    /// Random parameters. Each that can vary does so with the probability `varies`, unless creation refuses every
    /// range about its number.
    pub fn new(variant: &Variant, varies: f64, rng: &mut impl Rng) -> (Self, Bsdf) {
        let (mut drawn, mut bsdf, values) = Self::fixed(variant, rng);
        for (index, param) in variant.entry.info.params.iter().enumerate() {
            if !param.can_vary || values[index].is_empty() || !rng.random_bool(varies) {
                continue;
            }
            for _ in 0..RANGES_TRIED {
                let range = drawn.range(index, &values[index], rng);
                let [min, max] = range.unwrap_or_default();
                let varied = drawn.description.clone().vary(param.name(), min, max);
                if let Ok(found) = Bsdf::new(&varied) {
                    (drawn.description, bsdf) = (varied, found);
                    let (name, components) = (param.name(), param.components());
                    drawn.varied.push(Varied {
                        name,
                        components,
                        range,
                    });
                    break;
                }
            }
        }
        (drawn, bsdf)
    }

    /// A range about numbers; none for a direction.
    fn range(&self, param: usize, numbers: &[f32], rng: &mut impl Rng) -> Option<[f32; 2]> {
        let [min, max] = match self.entry.info.params[param].kind {
            _ if self.entry.info.film_thickness == Some(param) => self.thickness_nm?,
            _ if self.entry.info.film_thickness_spread == Some(param) => [0.0, self.most_spread_nm],
            ParamKind::Number { min, max, .. } => [min, max],
            _ => return None,
        };
        let least = numbers.iter().copied().fold(max, f32::min);
        let greatest = numbers.iter().copied().fold(min, f32::max);
        Some([number(rng, min, least), number(rng, greatest, max)])
    }

    /// Draws until the combination is valid: weights must not sum to more than 1, not every choice takes every
    /// parameter. With the numbers of each parameter.
    fn fixed(variant: &Variant, rng: &mut impl Rng) -> (Self, Bsdf, Vec<Vec<f32>>) {
        for _ in 0..100_000 {
            let (drawn, values) = Self::candidate(variant, rng);
            match Bsdf::new(&drawn.description) {
                Ok(bsdf) => return (drawn, bsdf, values),
                Err(error) => assert!(
                    matches!(error.status, Status::OutOfRange | Status::Unsupported),
                    "{error}"
                ),
            }
        }
        panic!("no valid parameters found for {}", variant.name);
    }

    /// Parameters that the choices ignore are left out.
    fn candidate(variant: &Variant, rng: &mut impl Rng) -> (Self, Vec<Vec<f32>>) {
        let info = variant.entry.info;
        let mut defaults = Values::defaults(info);
        let draw = |(index, chosen): (usize, &Option<usize>)| {
            let count = names(variant.entry, index).len();
            chosen.unwrap_or_else(|| rng.random_range(0..count.max(1)))
        };
        let choices: Vec<usize> = variant.choices.iter().enumerate().map(draw).collect();
        let mut description = Description::new(variant.entry.name());
        let mut values = Vec::new();
        for (index, param) in info.params.iter().enumerate() {
            let mut numbers = Vec::new();
            match param.kind {
                _ if [info.film_thickness, info.film_thickness_spread].contains(&Some(index))
                    || !param.is_used(|p| choices[p]) => {}
                ParamKind::Number { min, max, .. } => {
                    let is_equal = rng.random_bool(0.3);
                    let count = if is_equal { 1 } else { param.components() };
                    numbers = (0..count).map(|_| number(rng, min, max)).collect();
                    numbers.resize(param.components(), numbers[0]);
                }
                ParamKind::Direction { min_z } => {
                    let w = hemisphere(rng).as_vec3();
                    let w = if rng.random_bool(0.3) { Vec3::Z } else { w };
                    numbers = vec![w.x, w.y, w.z.max(min_z * 1.01)];
                }
                ParamKind::Choice { choices: all } => {
                    defaults.set_choice(index, choices[index]);
                    description = description.choose(param.name(), all[choices[index]]);
                }
            }
            if !numbers.is_empty() {
                description = description.set(param.name(), &numbers);
            }
            values.push(numbers);
        }
        let (mut thickness_nm, mut most_spread_nm) = (None, 0.0);
        if (variant.entry.needs_film)(&defaults) {
            let film = Kind::QUICK[rng.random_range(0..Kind::QUICK.len())].film();
            let param = info.film_thickness.unwrap();
            thickness_nm = film
                .varying_thickness_nm()
                .map(|range| range.map(|nm| nm as f32));
            most_spread_nm = film.thickness_spread_max_nm();
            let ranges = [
                (Some(param), thickness_nm),
                (
                    info.film_thickness_spread,
                    (most_spread_nm > 0.0).then_some([0.0, most_spread_nm]),
                ),
            ];
            for (param, range) in ranges {
                if let (Some(param), Some([min, max])) = (param, range) {
                    values[param] = vec![number(rng, min, max)];
                    description = description.set(info.params[param].name(), &values[param]);
                }
            }
            description = description.film(film);
        }
        let drawn = Self {
            entry: variant.entry,
            description,
            varied: Vec::new(),
            choices,
            thickness_nm,
            most_spread_nm,
        };
        (drawn, values)
    }

    /// What is chosen for the parameter of that name.
    pub fn choice(&self, name: &str) -> &'static str {
        let param = self.entry.info.param(name).unwrap();
        names(self.entry, param)[self.choices[param]]
    }

    /// Whether the model declares that it breaks a law with these choices.
    pub fn is_excepted(&self, exception: &Option<Exception>) -> bool {
        let applies = |exception: &Exception| exception.applies(|param| self.choices[param]);
        exception.as_ref().is_some_and(applies)
    }

    /// The varying numbers of a batch. `draw` appends those of one parameter.
    pub fn varying<R: Rng>(
        &self,
        count: usize,
        rng: &mut R,
        draw: impl Fn(&mut R, &Varied, &mut Vec<f32>),
    ) -> Varying {
        let mut numbers = Vec::new();
        for _ in 0..count {
            self.varied
                .iter()
                .for_each(|varied| draw(rng, varied, &mut numbers));
        }
        let components = self.varied.iter().map(|varied| varied.components).collect();
        Varying {
            numbers,
            components,
        }
    }
}
