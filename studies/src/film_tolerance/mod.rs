//! A film keeps its tolerance: its error against the reference stays within, on random stacks at random points.

pub mod comparison;
pub mod draw;
pub mod kind;
pub mod points;
pub mod report;
pub mod stack;
pub mod summary;
#[cfg(test)]
mod tests;

use crate::shared::directions;
use crate::shared::progress::Progress;
use comparison::{Outcome, check};
use kind::Kind;
use points::points;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What to check.
#[derive(Clone, Debug)]
pub struct Settings {
    pub seed: u64,
    /// Numbers in the seed's series of stacks.
    pub stacks: Range<usize>,
    /// Only stacks of this kind.
    pub kind: Option<Kind>,
    /// Points of each stack; some kinds have fewer, see [`Kind::points`].
    pub points: usize,
    pub tolerances: Vec<f64>,
}

/// Checks all stacks at all tolerances, in their order.
pub fn run(settings: &Settings) -> Vec<Outcome> {
    let (progress, done) = (Progress::new(), AtomicUsize::new(0));
    let of_kind = |number: &usize| settings.kind.is_none_or(|kind| kind == Kind::of(*number));
    let numbers: Vec<usize> = settings.stacks.clone().filter(of_kind).collect();
    let count = numbers.len();
    let outcomes = numbers.into_par_iter().flat_map_iter(|number| {
        let stack = kind::stack(settings.seed, number);
        let points = points(
            &stack,
            settings.seed,
            number,
            stack.kind.points(settings.points),
        );
        let truth = stack.truth(&points);
        let tolerances = settings.tolerances.iter();
        let found = tolerances.map(|tolerance| check(number, &stack, *tolerance, &points, &truth));
        let found: Vec<Outcome> = found.collect();
        for film in found.iter().filter(|film| film.exceptions > 0) {
            eprintln!("{}", report::line(settings.seed, film));
        }
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        progress.say(|| format!("{done} of {count} stacks"));
        found
    });
    outcomes.collect()
}

/// Random numbers for one purpose of one stack.
fn rng(seed: u64, stack: usize, purpose: u64) -> Pcg64Mcg {
    directions::rng((seed << 32) ^ ((stack as u64) << 4) ^ purpose)
}
