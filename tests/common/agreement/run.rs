//! Many elements, on all processors.

use super::bounds::{of_method, of_variant};
use super::films::{self, Subject};
use super::row::Row;
use super::surface;
use super::variants::{Variant, variants};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use std::sync::Mutex;

/// What to check.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub seed: u64,
    /// Elements, at least: all rows together.
    pub evaluations: u64,
}

/// Elements that a surface is sampled at, and evaluated at; and those of a film in one batch. No multiple
/// of what batches are cut into.
const SURFACE_ELEMENTS: usize = 2043;
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

    /// Its part number `number`, of as many as it takes for so many elements.
    fn check(&self, settings: &Settings, task: usize, number: u64, left: usize) -> Row {
        let mut row = self.row();
        let seed = (settings.seed << 48) ^ ((task as u64) << 32) ^ number;
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        match self {
            Self::Model(variant) => {
                let count = SURFACE_ELEMENTS.min(left.div_ceil(2));
                surface::check(variant, count, &mut rng, &mut row);
            }
            Self::Film(film) => {
                let count = FILM_ELEMENTS.min(left);
                film.check(count, &mut rng, &mut row);
            }
        }
        row
    }

    /// Elements in comparison with other tasks'.
    fn share(&self) -> f64 {
        match self {
            Self::Model(_) => 1.0,
            Self::Film(film) => 1.0 / film.slowness() as f64,
        }
    }

    fn part(&self) -> usize {
        match self {
            Self::Model(_) => 2 * SURFACE_ELEMENTS,
            Self::Film(_) => FILM_ELEMENTS,
        }
    }
}

/// The rows, films of one method together. `progress` is told now and then how many elements are done.
pub fn run(settings: &Settings, progress: impl Fn(u64) + Sync) -> Vec<Row> {
    let models = variants().into_iter().map(Task::Model);
    let tasks: Vec<Task> = models
        .chain(
            films::subjects()
                .into_iter()
                .map(|subject| Task::Film(Box::new(subject))),
        )
        .collect();
    let shares: f64 = tasks.iter().map(Task::share).sum();
    let elements =
        |task: &Task| (settings.evaluations as f64 * task.share() / shares).ceil() as usize;
    let parts = tasks.iter().enumerate().flat_map(|(index, task)| {
        let (all, part) = (elements(task), task.part());
        (0..all.div_ceil(part)).map(move |number| (index, number, all - number * part))
    });
    let next = Mutex::new(parts);
    let rows = Mutex::new(tasks.iter().map(Task::row).collect::<Vec<Row>>());
    let work = || {
        loop {
            let part = next.lock().unwrap().next();
            let Some((index, number, left)) = part else {
                return;
            };
            let row = tasks[index].check(settings, index, number as u64, left);
            let mut rows = rows.lock().unwrap();
            rows[index].merge(row);
            progress(rows.iter().map(|row| row.evaluations).sum());
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    merged(rows.into_inner().unwrap())
}

/// Rows of one name are one.
fn merged(all: Vec<Row>) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for more in all {
        match rows.iter_mut().find(|row| row.name == more.name) {
            Some(row) => row.merge(more),
            None => rows.push(more),
        }
    }
    rows
}
