//! Descriptions drawn from the registry, and what may vary in them.

use super::films::Kind;
use super::{hemisphere, number, rng};
use glam::Vec3;
use pellicle::bsdf::{Exception, Flags, ParamKind, RegisteredModel, Values};
use pellicle::film::Film;
use pellicle::{Bsdf, Description, Status};
use rand::{Rng, RngExt};
use std::sync::Arc;

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

/// Up to this number all combinations of choices are tried; beyond it some.
const MOST_COMBINATIONS: usize = 128;

/// The number of combinations of a model's choices that [`Drawn::new`] runs through.
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

/// A parameter that varies, and the range of each of its components: [0, 0] for a direction.
#[derive(Clone, Copy, Debug)]
pub struct Variation {
    /// Index of the parameter.
    pub param: usize,
    pub range: [f32; 2],
}

/// A model with random parameters, all within their ranges.
pub struct Drawn {
    pub entry: &'static RegisteredModel,
    pub description: Description,
    seed: u64,
    choices: Vec<usize>,
    /// What is set for each parameter; nothing for a choice, and for a thickness that the film does not take.
    numbers: Vec<Vec<f32>>,
    film: Option<Arc<Film>>,
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

    fn candidate(entry: &'static RegisteredModel, combination: u64, rng: &mut impl Rng) -> Self {
        let choices = draw_choices(entry, combination, rng);
        let params = entry.info.params.iter().enumerate();
        let mut numbers: Vec<Vec<f32>> = params
            .map(|(index, param)| {
                let of_film = [entry.info.film_thickness, entry.info.film_thickness_spread];
                if of_film.contains(&Some(index)) || !param.is_used(|p| choices[p]) {
                    vec![]
                } else {
                    draw_numbers(&param.kind, rng)
                }
            })
            .collect();
        let mut values = Values::defaults(entry.info);
        for (index, choice) in choices.iter().enumerate() {
            values.set_choice(index, *choice);
        }
        let mut film = None;
        if (entry.needs_film)(&values) {
            let used = draw_film(entry, rng);
            if let Some([min, max]) = used.varying_thickness_nm() {
                let thickness = entry.info.film_thickness.unwrap();
                numbers[thickness] = vec![number(rng, min as f32, max as f32)];
                let spread = entry.info.film_thickness_spread.unwrap();
                let most = used.thickness_spread_max_nm();
                if most > 0.0 {
                    numbers[spread] = vec![number(rng, 0.0, most)];
                }
            }
            film = Some(used);
        }
        let mut drawn = Self {
            entry,
            description: Description::default(),
            seed: combination,
            choices,
            numbers,
            film,
        };
        drawn.description = drawn.with(&[]);
        drawn
    }

    /// The description with other numbers for some parameters.
    pub fn with(&self, changes: &[(usize, Vec<f32>)]) -> Description {
        let mut description = Description::new(self.entry.name());
        for (index, param) in self.entry.info.params.iter().enumerate() {
            let changed = changes.iter().find(|(changed, _)| *changed == index);
            let numbers = changed.map_or(&self.numbers[index], |(_, numbers)| numbers);
            description = match param.kind {
                ParamKind::Choice { .. } if !param.is_used(|p| self.choices[p]) => description,
                ParamKind::Choice { choices } => {
                    let name = choices[self.choices[index]];
                    description.choose(param.name(), name)
                }
                _ if numbers.is_empty() => description,
                _ => description.set(param.name(), numbers),
            };
        }
        match &self.film {
            Some(film) => description.film(Arc::clone(film)),
            None => description,
        }
    }

    /// The description with the parameters varying that `may` chooses by their indices, as far as the model
    /// allows it, each over the range that [`Self::accepted_range`] draws.
    pub fn varied(
        &self,
        rng: &mut impl Rng,
        may: impl Fn(usize) -> bool,
    ) -> (Description, Vec<Variation>) {
        let mut description = self.description.clone();
        let mut variations = Vec::new();
        for param in (0..self.entry.info.params.len()).filter(|param| may(*param)) {
            if let Some(range) = self.accepted_range(&description, param, rng) {
                let name = self.entry.info.params[param].name();
                description = description.vary(name, range[0], range[1]);
                variations.push(Variation { param, range });
            }
        }
        (description, variations)
    }

    /// A range within which creation accepts that a parameter varies, in addition to what varies already;
    /// `None` if it cannot vary. Now and then it is all that the parameter can be; else it is drawn, and drawn
    /// closer to the parameter's own value as long as it is refused.
    fn accepted_range(
        &self,
        description: &Description,
        param: usize,
        rng: &mut impl Rng,
    ) -> Option<[f32; 2]> {
        let info = &self.entry.info.params[param];
        let refusal = |[min, max]: [f32; 2]| {
            let varied = description.clone().vary(info.name(), min, max);
            Bsdf::<f32>::new(&varied).err().map(|error| error.status)
        };
        let own = &self.numbers[param];
        let film_range = self
            .film
            .as_ref()
            .and_then(|film| film.varying_thickness_nm());
        let [least, greatest] = match info.kind {
            _ if !info.can_vary || own.is_empty() => return None,
            _ if self.entry.info.film_thickness == Some(param) => film_range?.map(|nm| nm as f32),
            _ if self.entry.info.film_thickness_spread == Some(param) => {
                [0.0, self.film.as_ref()?.thickness_spread_max_nm()]
            }
            ParamKind::Number { min, max, .. } => [min, max],
            _ => return refusal([0.0; 2]).is_none().then_some([0.0; 2]),
        };
        let own_least = own.iter().copied().fold(f32::INFINITY, f32::min);
        let own_greatest = own.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let whole = rng.random_bool(0.2).then_some([least, greatest]);
        let mut closeness = 1.0;
        for _ in 0..8 {
            let mut ends = [(); 2].map(|()| number(rng, least, greatest));
            ends.sort_by(f32::total_cmp);
            let min = own_least + (ends[0].min(own_least) - own_least) * closeness;
            let max = own_greatest + (ends[1].max(own_greatest) - own_greatest) * closeness;
            let around = [[min, max], [min, own_least], [own_greatest, max]];
            for range in whole.into_iter().chain([ends]).chain(around) {
                match refusal(range) {
                    _ if range[0] >= range[1] => {}
                    None => return Some(range),
                    Some(Status::Unsupported) => return None,
                    Some(_) => {}
                }
            }
            closeness *= 0.5;
        }
        None
    }

    /// As [`Self::varied`], for parameters chosen in a row without their indices; of each that varies the
    /// number of its components and its range.
    pub fn varying(&self, mut may: impl FnMut() -> bool) -> (Description, Vec<(usize, [f32; 2])>) {
        let chosen: Vec<bool> = self.entry.info.params.iter().map(|_| may()).collect();
        let (description, variations) = self.varied(&mut rng(self.seed), |param| chosen[param]);
        let of = |variation: Variation| {
            let components = self.entry.info.params[variation.param].components();
            (components, variation.range)
        };
        (description, variations.into_iter().map(of).collect())
    }

    /// Numbers for one call of a parameter that varies: within its range, ends included; a direction that
    /// the parameter itself could be, of any length.
    pub fn draw_within(&self, variation: Variation, rng: &mut impl Rng) -> Vec<f32> {
        let info = &self.entry.info.params[variation.param];
        match info.kind {
            ParamKind::Direction { .. } => {
                let length = rng.random_range(0.5..2.0);
                let w = draw_numbers(&info.kind, rng);
                w.into_iter().map(|number| number * length).collect()
            }
            _ => {
                let [min, max] = variation.range;
                (0..info.components())
                    .map(|_| number(rng, min, max))
                    .collect()
            }
        }
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

/// The choices follow from the combination's number as long as their product is small, the others are drawn;
/// 0 for a parameter that is no choice.
fn draw_choices(entry: &RegisteredModel, combination: u64, rng: &mut impl Rng) -> Vec<usize> {
    let mut rest = combination as usize;
    let mut combinations = 1;
    let mut draw = |kind: &ParamKind| {
        let ParamKind::Choice { choices } = kind else {
            return 0;
        };
        if combinations * choices.len() > MOST_COMBINATIONS {
            return rng.random_range(0..choices.len());
        }
        combinations *= choices.len();
        let choice = rest % choices.len();
        rest /= choices.len();
        choice
    };
    let params = entry.info.params.iter();
    params.map(|param| draw(&param.kind)).collect()
}

/// Numbers within a parameter's own range; none for a choice.
fn draw_numbers(kind: &ParamKind, rng: &mut impl Rng) -> Vec<f32> {
    match *kind {
        ParamKind::Number {
            components,
            min,
            max,
            ..
        } => {
            let is_equal = rng.random_bool(0.3);
            let first = number(rng, min, max);
            let mut draw = |_| {
                if is_equal {
                    first
                } else {
                    number(rng, min, max)
                }
            };
            (0..components).map(&mut draw).collect()
        }
        ParamKind::Direction { min_z } => {
            let mut w = hemisphere(rng).as_vec3();
            if rng.random_bool(0.3) {
                w = Vec3::Z;
            }
            w.z = w.z.max(min_z * 1.01);
            w.to_array().to_vec()
        }
        ParamKind::Choice { .. } => vec![],
    }
}

/// A smooth surface asks its film for a colour or two, a rough one for thousands: that gets a quick one.
fn draw_film(entry: &RegisteredModel, rng: &mut impl Rng) -> Arc<Film> {
    let mut lobes = entry.info.lobes.iter();
    let is_dirac = lobes.all(|lobe| lobe.flags.contains(Flags::DELTA));
    let kinds = if is_dirac {
        &Kind::ALL[..]
    } else {
        &Kind::QUICK
    };
    kinds[rng.random_range(0..kinds.len())].film()
}
