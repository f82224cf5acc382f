//! Batches in single precision against the f64 instance of the same formulas, at every level of instructions and
//! by single calls, over the whole registry and films of every method.
//!
//! Both instances get the same single-precision numbers. So what a narrow lobe makes of the rounding of its inputs
//! does not count, and what it makes of the rounding within the formulas does.

pub mod bounds;
pub mod elements;
pub mod films;
pub mod report;
pub mod row;
pub mod surface;
pub mod tally;
#[cfg(test)]
mod tests;

use crate::shared::directions::rng;
use crate::shared::draw::{Variant, variants};
use crate::shared::progress::Progress;
use bounds::{of_method, of_variant};
use films::Subject;
use pellicle::num::Level;
use rayon::prelude::*;
use row::Row;
use std::sync::atomic::{AtomicU64, Ordering};

/// What to check.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub seed: u64,
    /// The least number of elements of all rows together.
    pub evaluations: u64,
    /// The number of elements at which a surface is sampled, and evaluated.
    pub surface_elements: usize,
}

/// The elements of a film in one batch. It is no multiple of what batches are cut into.
const FILM_ELEMENTS: usize = 4091;

enum Task {
    Model(Variant),
    Film(Box<Subject>),
}

impl Task {
    fn row(&self) -> Row {
        match self {
            Self::Model(variant) => Row::new(&variant.name, of_variant(&variant.name)),
            Self::Film(film) => Row::new(&film.name(), of_method(film.method, film.tolerance())),
        }
    }

    /// One part of at most `most` elements.
    fn check(&self, seed: u64, most: usize) -> Row {
        let (mut row, mut rng) = (self.row(), rng(seed));
        match self {
            Self::Model(variant) => {
                surface::check(variant, most.div_ceil(2), &mut rng, &mut row);
            }
            Self::Film(film) => film.check(most, &mut rng, &mut row),
        }
        row
    }

    /// The number of elements in proportion to other tasks'.
    fn share(&self) -> f64 {
        match self {
            Self::Model(_) => 1.0,
            Self::Film(film) => 1.0 / film.slowness() as f64,
        }
    }

    fn part(&self, settings: &Settings) -> usize {
        match self {
            Self::Model(_) => 2 * settings.surface_elements,
            Self::Film(_) => FILM_ELEMENTS,
        }
    }
}

/// The rows of the table. Films of one method share a row.
pub fn run(settings: &Settings) -> Vec<Row> {
    let films = films::subjects().into_iter().map(Box::new);
    let models = variants().into_iter().map(Task::Model);
    let tasks: Vec<Task> = models.chain(films.map(Task::Film)).collect();
    let shares: f64 = tasks.iter().map(Task::share).sum();
    let parts = tasks.iter().enumerate().flat_map(|(index, task)| {
        let all = (settings.evaluations as f64 * task.share() / shares).ceil() as usize;
        let part = task.part(settings);
        (0..all.div_ceil(part)).map(move |number| (index, number, part.min(all - number * part)))
    });
    let (progress, done) = (Progress::new(), AtomicU64::new(0));
    let parts: Vec<(usize, usize, usize)> = parts.collect();
    let found = parts.into_par_iter().map(|(index, number, most)| {
        let seed = (settings.seed << 48) ^ ((index as u64) << 32) ^ number as u64;
        let row = tasks[index].check(seed, most);
        let done = done.fetch_add(row.evaluations, Ordering::Relaxed) + row.evaluations;
        progress.say(|| format!("{done} of {} elements", settings.evaluations));
        row
    });
    let mut rows: Vec<Row> = Vec::new();
    for more in found.collect::<Vec<Row>>() {
        match rows.iter_mut().find(|row| row.name == more.name) {
            Some(row) => row.merge(more),
            None => rows.push(more),
        }
    }
    rows
}

/// Calls `add` with every element that a batch finds at the first level of instructions, and with those that
/// another level, or a single call, finds otherwise: then with the name of that level and the first one's element.
/// Returns what the first level finds.
pub fn at_every_level<T>(
    batch: impl Fn(Level) -> Vec<T>,
    single: impl Fn(usize) -> T,
    is_same: impl Fn(&T, &T) -> bool,
    mut add: impl FnMut(usize, &T, Option<(&str, &T)>),
) -> Vec<T> {
    let levels = Level::all();
    let first = batch(levels[0]);
    for (i, found) in first.iter().enumerate() {
        add(i, found, None);
    }
    let more = levels[1..].iter();
    let mut others: Vec<_> = more.map(|level| (level.name(), batch(*level))).collect();
    others.push(("single call", (0..first.len()).map(single).collect()));
    for (name, found) in others {
        for (i, (first, found)) in first.iter().zip(&found).enumerate() {
            if !is_same(first, found) {
                add(i, found, Some((name, first)));
            }
        }
    }
    first
}
