//! Random evaluations of every model and of random films, in batches: no result is NaN, infinite,
//! negative or above its bound. Shared by the test of half a million (tests/evaluations.rs) and the run of
//! 1e9 (examples/evaluations, `./x check evaluations`).
//!
//! Work comes in units: one description with one set of instructions, and many inputs. Three of four
//! units are models, in the order of the registry and of their choices, the fourth is a film.

pub mod bounds;
mod film_unit;
mod inputs;
mod model_unit;
mod planes;

use super::common;
use super::promise;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Elements of one batch.
const BATCH: usize = 1024;

/// How much to do.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub seed: u64,
    /// Values, samples, albedos and colours to be looked at, at least.
    pub evaluations: u64,
    /// Batches per description.
    pub batches: usize,
}

/// What was looked at.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Descriptions.
    pub units: u64,
    /// Elements of batches, by what was called.
    pub evaluated: BTreeMap<&'static str, u64>,
    /// By model: the greatest weight of a sample over its bound, with what gave it.
    pub weights: BTreeMap<&'static str, (f32, String)>,
    /// What broke the contract, the first few.
    pub failures: Vec<String>,
}

impl Tally {
    /// Elements of all calls together.
    pub fn total(&self) -> u64 {
        self.evaluated.values().sum()
    }

    fn count(&mut self, call: &'static str, elements: usize) {
        *self.evaluated.entry(call).or_default() += elements as u64;
    }

    /// Keeps what went wrong, unless that is known well enough.
    fn fail(&mut self, what: impl FnOnce() -> String) {
        if self.failures.len() < 20 {
            self.failures.push(what());
        }
    }

    fn weight(&mut self, model: &'static str, weight: f32, what: impl FnOnce() -> String) {
        if self
            .weights
            .get(model)
            .is_none_or(|greatest| weight > greatest.0)
        {
            self.weights.insert(model, (weight, what()));
        }
    }

    fn add(&mut self, other: Self) {
        self.units += other.units;
        for (call, elements) in other.evaluated {
            *self.evaluated.entry(call).or_default() += elements;
        }
        for (model, (weight, what)) in other.weights {
            self.weight(model, weight, || what);
        }
        for failure in other.failures {
            self.fail(|| failure);
        }
    }
}

/// Works through units on all processors until enough is done. `progress` is told the tally so far.
pub fn run(settings: &Settings, progress: impl Fn(&Tally) + Sync) -> Tally {
    let state = Mutex::new((0, Tally::default()));
    let work = || {
        loop {
            let number = {
                let mut state = state.lock().unwrap();
                if state.1.total() >= settings.evaluations {
                    return;
                }
                state.0 += 1;
                state.0 - 1
            };
            let mut tally = Tally {
                units: 1,
                ..Tally::default()
            };
            if number % 4 == 3 {
                film_unit::run(settings, number / 4, &mut tally);
            } else {
                model_unit::run(settings, number - number / 4, &mut tally);
            }
            let mut state = state.lock().unwrap();
            state.1.add(tally);
            progress(&state.1);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    state.into_inner().unwrap().1
}
