//! Surfaces with random parameters, some of which vary.

use super::variants::Variant;
use crate::common::films::Kind;
use crate::common::{hemisphere, number};
use glam::Vec3;
use pellicle::bsdf::{ParamKind, Values};
use pellicle::{Bsdf, Description, Status};
use rand::{Rng, RngExt};

/// A range that a number is drawn from; none: a direction.
pub type Range = Option<[f32; 2]>;

/// Parameters within their ranges, some of which vary.
pub struct Drawn {
    pub description: Description,
    /// The same in words.
    pub text: String,
    /// Of each number that varies; of a direction the first of three.
    pub ranges: Vec<(Range, usize)>,
}

impl Variant {
    /// Until the combination is valid: weights must not sum to more than 1, not every choice takes every
    /// parameter.
    pub fn drawn(&self, rng: &mut impl Rng) -> (Drawn, Bsdf<f32>) {
        for _ in 0..100_000 {
            let drawn = self.candidate(rng);
            match Bsdf::new(&drawn.description) {
                Ok(bsdf) => return (drawn, bsdf),
                Err(error) => assert!(
                    matches!(error.status, Status::OutOfRange | Status::Unsupported),
                    "{error}"
                ),
            }
        }
        panic!("no valid parameters found for {}", self.name);
    }

    fn candidate(&self, rng: &mut impl Rng) -> Drawn {
        let info = self.entry.info;
        let mut description = Description::new(self.entry.name());
        let mut text = self.entry.name().to_owned();
        let mut values = Values::defaults(info);
        let mut ranges = Vec::new();
        let any_varies = rng.random_bool(0.5);
        for (index, param) in info.params.iter().enumerate() {
            let varies = any_varies && param.can_vary && rng.random_bool(0.5);
            match param.kind {
                _ if info.film_thickness == Some(index) => {}
                ParamKind::Number { min, max, .. } => {
                    let count = param.components();
                    let first = number(rng, min, max);
                    let is_gray = rng.random_bool(0.3);
                    let own = |_| {
                        if is_gray {
                            first
                        } else {
                            number(rng, min, max)
                        }
                    };
                    let mut numbers: Vec<f32> = (0..count).map(own).collect();
                    text += &format!(", {}", param.name());
                    if varies {
                        let [a, b] = [number(rng, min, max), number(rng, min, max)];
                        let (min, max) = (a.min(b), a.max(b));
                        numbers.iter_mut().for_each(|n| *n = n.clamp(min, max));
                        text += &format!(" varying in [{min:?}, {max:?}], else");
                        description = description.vary(param.name(), min, max);
                        ranges.push((Some([min, max]), count));
                    }
                    text += &format!(" {numbers:?}");
                    description = description.set(param.name(), &numbers);
                }
                ParamKind::Direction { min_z } => {
                    let mut w = hemisphere(rng).as_vec3();
                    w.z = w.z.max(min_z * 1.01);
                    let w = if rng.random_bool(0.3) { Vec3::Z } else { w };
                    text += &format!(", {}", param.name());
                    description = description.set(param.name(), &w.to_array());
                    if varies {
                        text += " varying, else";
                        description = description.vary(param.name(), 0.0, 0.0);
                        ranges.push((None, 3));
                    }
                    text += &format!(" {:?}", w.to_array());
                }
                ParamKind::Choice { choices } => {
                    let chosen = self.choices[index];
                    let chosen = chosen.unwrap_or_else(|| rng.random_range(0..choices.len()));
                    values.set_choice(index, chosen);
                    let choice = choices[chosen];
                    text += &format!(", {} {choice}", param.name());
                    description = description.choose(param.name(), choice);
                }
            }
        }
        let Some(thickness) = info.film_thickness else {
            return Drawn {
                description,
                text,
                ranges,
            };
        };
        if (self.entry.needs_film)(&values) {
            let kind = Kind::QUICK[rng.random_range(0..Kind::QUICK.len())];
            text += &format!(", film {kind:?}");
            let film = kind.film();
            let name = info.params[thickness].name();
            if let Some(range) = film.varying_thickness_nm() {
                let [min, max] = range.map(|nm| nm as f32);
                let own = number(rng, min, max);
                text += &format!(", {name} {own:?}");
                description = description.set(name, &[own]);
                if any_varies {
                    text += " unless it varies";
                    description = description.vary(name, min, max);
                    ranges.push((Some([min, max]), 1));
                }
            }
            description = description.film(film);
        }
        Drawn {
            description,
            text,
            ranges,
        }
    }
}

/// The varying numbers of one element.
pub fn varying(ranges: &[(Range, usize)], rng: &mut impl Rng, numbers: &mut Vec<f32>) {
    for (range, count) in ranges {
        match range {
            Some([min, max]) => numbers.extend((0..*count).map(|_| number(rng, *min, *max))),
            None => numbers.extend((hemisphere(rng) * 2.0).as_vec3().to_array()),
        }
    }
}
