//! Every entry on every stack and range: errors, then times.

use crate::entry::{Compiled, Entry, PlanNote};
use crate::errors::Errors;
use crate::suite::{Point, RANGES, Range, Stack, points};
use crate::{parallel, timing};
use pellicle::Error;
use pellicle::num::Level;

/// Points per stack and range that errors are counted at.
pub const POINTS: usize = 1000;
/// Of the points for errors, and of those for times.
const SEEDS: [u64; 2] = [2002, 2017];

/// One stack over one range, with the answers.
struct Scene<'a> {
    stack: &'a Stack,
    range: Range,
    points: Vec<Point>,
    truth: Vec<[f64; 3]>,
}

/// One entry in one scene.
pub struct Cell {
    pub entry: Entry,
    pub stack: &'static str,
    pub range: Range,
    /// Whether the stack is one film on a base.
    pub is_one_layer: bool,
    /// Whether an index in it depends on the wavelength.
    pub has_dispersion: bool,
    pub errors: Errors,
    /// Of planned films.
    pub note: Option<PlanNote>,
    /// Per colour, by single calls.
    pub ns: f64,
    /// Per colour, by a batch call, at each of the processor's levels of instructions; empty: there are no
    /// batches.
    pub batch_ns: Vec<f64>,
    compiled: Compiled,
}

/// Runs everything, grouped by range.
pub fn run(stacks: &[Stack]) -> Result<Vec<Cell>, Error> {
    eprintln!("the truth");
    let scenes = scenes(stacks)?;
    let entries = Entry::all();
    let jobs: Vec<(&Scene, Entry)> = scenes
        .iter()
        .flat_map(|scene| entries.iter().map(move |entry| (scene, *entry)))
        .collect();
    eprintln!("errors");
    let cells = parallel::map(&jobs, |(scene, entry)| cell(scene, *entry));
    let cells: Result<Vec<Option<Cell>>, Error> = cells.into_iter().collect();
    let mut cells: Vec<Cell> = cells?.into_iter().flatten().collect();
    eprintln!("times");
    time(&mut cells);
    Ok(cells)
}

fn scenes(stacks: &[Stack]) -> Result<Vec<Scene<'_>>, Error> {
    let jobs: Vec<(Range, &Stack)> = RANGES
        .iter()
        .flat_map(|range| stacks.iter().map(move |stack| (*range, stack)))
        .filter(|(range, stack)| range.has_mirror || stack.is_one_layer())
        .collect();
    let scenes = parallel::map(&jobs, |&(range, stack)| {
        let points = points(range, POINTS, SEEDS[0]);
        let truth = stack.truth()?;
        Ok(Scene {
            stack,
            range,
            truth: points.iter().map(|p| truth.reflectance(*p)).collect(),
            points,
        })
    });
    scenes.into_iter().collect()
}

fn cell(scene: &Scene, entry: Entry) -> Result<Option<Cell>, Error> {
    let Some((compiled, note)) = Compiled::with_note(entry, scene.stack, scene.range)? else {
        return Ok(None);
    };
    let mut errors = Errors::default();
    for (point, truth) in scene.points.iter().zip(&scene.truth) {
        if compiled.is_exact() {
            errors.add_exact();
        } else {
            errors.add(compiled.reflectance(*point), *truth);
        }
    }
    Ok(Some(Cell {
        entry,
        stack: scene.stack.name,
        range: scene.range,
        is_one_layer: scene.stack.is_one_layer(),
        has_dispersion: scene.stack.has_dispersion(),
        errors,
        note,
        ns: f64::NAN,
        batch_ns: Vec::new(),
        compiled,
    }))
}

/// Times every cell. The repetitions of one are spread over the whole run, so that other work on the
/// machine disturbs one of them and not all.
fn time(cells: &mut [Cell]) {
    let points = RANGES.map(|range| points(range, timing::ALL_POINTS, SEEDS[1]));
    let levels = Level::all();
    let mut times = vec![(Vec::new(), vec![Vec::new(); levels.len()]); cells.len()];
    for repetition in 0..timing::REPETITIONS {
        for (cell, (single, batches)) in cells.iter().zip(&mut times) {
            let range = RANGES.iter().position(|range| *range == cell.range);
            let points = &points[range.unwrap_or(0)];
            single.push(timing::single_calls(&cell.compiled, points, repetition));
            let found = timing::batches(&cell.compiled, &levels, points, repetition);
            batches
                .iter_mut()
                .zip(found)
                .for_each(|(all, ns)| all.push(ns));
        }
    }
    for (cell, (single, batches)) in cells.iter_mut().zip(times) {
        cell.ns = timing::median(single);
        cell.batch_ns = medians(batches);
    }
}

/// Of each level, or none if there are no batches.
fn medians(batches: Vec<Vec<f64>>) -> Vec<f64> {
    let measured = batches.into_iter().filter(|times| !times.is_empty());
    measured.map(timing::median).collect()
}

/// One entry over several cells.
pub struct Summary {
    pub entry: Entry,
    /// Of all cells together.
    pub errors: Errors,
    /// The median of the cells, and the greatest.
    pub ns: f64,
    pub slowest_ns: f64,
    /// The same by batch calls, as in [`Cell`].
    pub batch_ns: Vec<f64>,
    /// One per planned film.
    pub notes: Vec<PlanNote>,
}

/// Every entry that has cells among these.
pub fn summaries<'a>(cells: impl Iterator<Item = &'a Cell>) -> Vec<Summary> {
    let cells: Vec<&Cell> = cells.collect();
    let summary = |entry: Entry| {
        let mut errors = Errors::default();
        let (mut ns, mut notes) = (Vec::new(), Vec::new());
        let mut batches = vec![Vec::new(); Level::all().len()];
        for cell in cells.iter().filter(|cell| cell.entry == entry) {
            errors.join(&cell.errors);
            ns.push(cell.ns);
            for (all, ns) in batches.iter_mut().zip(&cell.batch_ns) {
                all.push(*ns);
            }
            notes.extend(cell.note.clone());
        }
        (!ns.is_empty()).then(|| Summary {
            entry,
            errors,
            slowest_ns: ns.iter().copied().fold(0.0, f64::max),
            ns: timing::median(ns),
            batch_ns: medians(batches),
            notes,
        })
    };
    Entry::all().into_iter().filter_map(summary).collect()
}

/// The cells that all methods have: one film on a base, over one range.
pub fn shared(cells: &[Cell], range: Range) -> impl Iterator<Item = &Cell> {
    let is_shared = move |cell: &&Cell| cell.is_one_layer && cell.range == range;
    cells.iter().filter(is_shared)
}

/// Of these, the cells without dispersion.
pub fn constant(cells: &[Cell], range: Range) -> impl Iterator<Item = &Cell> {
    shared(cells, range).filter(|cell| !cell.has_dispersion)
}
