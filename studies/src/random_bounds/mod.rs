//! Random evaluations of every model and of random films, in batches: no result is NaN, infinite, negative or above
//! its bound.
//!
//! The work comes in units: one description at one level of instructions, and many inputs. Every sixteenth unit is a film,
//! the others are random variants of the models in the order of the registry.

pub mod bounds;
mod film;
mod inputs;
mod model;
pub mod report;
#[cfg(test)]
mod tests;

use crate::shared::draw::{Variant, variants_of};
use crate::shared::progress::Progress;
use pellicle::bsdf::models;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Every unit of this number is a film.
const FILM_STRIDE: usize = 16;
/// Units between two looks at whether enough is done.
const ROUND: usize = 64;
/// The failures that are kept.
const FAILURES: usize = 20;

/// How much to do.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub seed: u64,
    /// The least number of values, samples, albedos and colours.
    pub evaluations: u64,
    /// Batches of each description, and elements of each batch.
    pub batches: usize,
    pub elements: usize,
}

/// What was looked at.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// The number of descriptions.
    pub units: u64,
    /// The number of elements by the function that was called.
    pub evaluated: BTreeMap<&'static str, u64>,
    /// By model: the greatest weight of a sample over its bound, and where it was found.
    pub weights: BTreeMap<&'static str, (f32, String)>,
    /// By model: the number of descriptions.
    pub draws: BTreeMap<&'static str, u64>,
    /// By model and parameter: the number of descriptions in which it varied.
    pub varied: BTreeMap<(&'static str, &'static str), u64>,
    /// Results that break the contract, the first few.
    pub failures: Vec<String>,
}

impl Tally {
    /// The number of elements of all calls together.
    pub fn total(&self) -> u64 {
        self.evaluated.values().sum()
    }

    fn count(&mut self, call: &'static str, elements: usize) {
        *self.evaluated.entry(call).or_default() += elements as u64;
    }

    fn fail(&mut self, what: impl FnOnce() -> String) {
        if self.failures.len() < FAILURES {
            self.failures.push(what());
        }
    }

    fn weight(&mut self, model: &'static str, weight: f32, what: impl FnOnce() -> String) {
        let known = self.weights.get(model);
        if known.is_none_or(|greatest| weight > greatest.0) {
            self.weights.insert(model, (weight, what()));
        }
    }

    fn join(mut self, other: Self) -> Self {
        fn add<K: Ord>(to: &mut BTreeMap<K, u64>, from: BTreeMap<K, u64>) {
            from.into_iter()
                .for_each(|(key, n)| *to.entry(key).or_default() += n);
        }
        self.units += other.units;
        add(&mut self.evaluated, other.evaluated);
        add(&mut self.draws, other.draws);
        add(&mut self.varied, other.varied);
        for (model, (weight, what)) in other.weights {
            self.weight(model, weight, || what);
        }
        self.failures.extend(other.failures);
        self.failures.truncate(FAILURES);
        self
    }
}

/// Works through units until enough is done.
pub fn run(settings: &Settings) -> Tally {
    let variants: Vec<Vec<Variant>> = models().iter().map(variants_of).collect();
    let unit = |number: usize| {
        let mut tally = Tally {
            units: 1,
            ..Tally::default()
        };
        if number % FILM_STRIDE == FILM_STRIDE - 1 {
            film::run(settings, number / FILM_STRIDE, &mut tally);
        } else {
            let number = number - number / FILM_STRIDE;
            model::run(
                settings,
                number,
                &variants[number % variants.len()],
                &mut tally,
            );
        }
        tally
    };
    let (progress, mut tally) = (Progress::new(), Tally::default());
    while tally.total() < settings.evaluations {
        let units = tally.units as usize..tally.units as usize + ROUND;
        tally = tally.join(
            units
                .into_par_iter()
                .map(unit)
                .reduce(Tally::default, Tally::join),
        );
        let (done, failures) = (tally.total(), tally.failures.len());
        progress.say(|| format!("{done} of {}, {failures} failures", settings.evaluations));
    }
    tally
}

/// What every result is.
fn is_good(x: f32) -> bool {
    x.is_finite() && x >= 0.0
}
