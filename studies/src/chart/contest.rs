//! Every peer on every stack and range: errors, then times.

use super::errors::Errors;
use super::suite::{Named, RANGES, Range, points};
use super::timing;
use crate::shared::peer::{Compiled, Peer, harmonics, method_of};
use pellicle::film::OneLayerMethod as Kind;
use pellicle::num::Level;
use rayon::prelude::*;
use std::time::Instant;

/// Points per stack and range at which errors are counted.
pub const POINTS: usize = 1000;
/// Of the points for errors, and of those for times.
const SEEDS: [u64; 2] = [2002, 2017];

/// Tolerances of the planned films, coarsest first.
const TOLERANCES: [f64; 3] = [1e-2, 2e-3, 2e-4];

/// The peer that times are compared with: three harmonics, the best that renderers use.
pub const BASELINE: Peer = Peer::Method(harmonics(3));

/// Everyone, each method from coarse to fine.
pub fn peers() -> Vec<Peer> {
    let mut kinds = vec![Kind::TwoBeam, Kind::AiryRgb];
    kinds.extend([4, 8, 16, 32, 64].map(Kind::Quadrature));
    kinds.extend([8, 16, 32, 64].map(Kind::Bands));
    kinds.extend([1, 2, 3, 4, 5].map(harmonics));
    let methods = kinds.into_iter().map(Peer::Method);
    methods
        .chain(TOLERANCES.map(Peer::Planned))
        .chain([Peer::Reference])
        .collect()
}

/// What the plan says about a film.
#[derive(Clone, Debug)]
pub struct PlanNote {
    pub method: String,
    pub measured_max: f64,
    pub bytes: usize,
    /// Wall time of the compilation.
    pub compile_ms: f64,
}

/// One peer on one stack over one range.
pub struct Cell {
    pub peer: Peer,
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
    /// Per colour by a batch call, at each level of the processor's instructions; empty if there are no batches.
    pub batch_ns: Vec<f64>,
    compiled: Compiled,
}

/// Runs everything, grouped by range.
pub fn run(stacks: &[Named]) -> Vec<Cell> {
    let of_range = |range: Range| {
        let takes_part = move |stack: &&Named| range.has_mirror || stack.1.is_one_layer();
        stacks
            .iter()
            .filter(takes_part)
            .map(move |stack| (stack, range))
    };
    let scenes: Vec<(&Named, Range)> = RANGES.into_iter().flat_map(of_range).collect();
    eprintln!("errors");
    let cells = scenes
        .into_par_iter()
        .flat_map_iter(|(stack, range)| cells(stack, range));
    let mut cells: Vec<Cell> = cells.collect();
    eprintln!("times");
    time(&mut cells);
    cells
}

/// All peers that take a stack.
fn cells((name, stack): &Named, range: Range) -> Vec<Cell> {
    let points = points(range, POINTS, SEEDS[0]);
    let reference = stack.truth().unwrap();
    let truth = points
        .iter()
        .map(|p| reference.reflectance(p[0].into(), p[1].into()));
    let truth: Vec<[f64; 3]> = truth.collect();
    let cell = |peer: Peer| {
        let start = Instant::now();
        let compiled = peer.compile(stack, range.nm);
        let compile_ms = start.elapsed().as_secs_f64() * 1e3;
        let note = match &compiled {
            Compiled::Refused(_) => return None,
            Compiled::Film(film) => Some(PlanNote {
                method: method_of(film),
                measured_max: film.plan().measured_max,
                bytes: film.plan().bytes,
                compile_ms,
            }),
            _ => None,
        };
        // Asking the reference again, also where the plan chose it, would only take time.
        let is_planned_reference = note.as_ref().is_some_and(|note| note.method == "reference");
        let is_exact = peer == Peer::Reference || is_planned_reference;
        let mut errors = Errors::default();
        for (point, truth) in points.iter().zip(&truth) {
            match compiled.single(point[0], point[1]).filter(|_| !is_exact) {
                Some(color) => errors.add(color, *truth),
                None => errors.add_exact(),
            }
        }
        Some(Cell {
            peer,
            stack: name,
            range,
            is_one_layer: stack.is_one_layer(),
            has_dispersion: stack.has_dispersion(),
            errors,
            note,
            ns: f64::NAN,
            batch_ns: Vec::new(),
            compiled,
        })
    };
    peers().into_iter().filter_map(cell).collect()
}

/// Times every cell. The repetitions of one are spread over the whole run, so that other work on the machine disturbs
/// one of them and not all.
fn time(cells: &mut [Cell]) {
    let points = RANGES.map(|range| points(range, timing::ALL_POINTS, SEEDS[1]));
    let levels = Level::all();
    let mut times = vec![(Vec::new(), vec![Vec::new(); levels.len()]); cells.len()];
    for repetition in 0..timing::REPETITIONS {
        for (cell, (single, batches)) in cells.iter().zip(&mut times) {
            let range = RANGES
                .iter()
                .position(|range| *range == cell.range)
                .unwrap();
            single.push(timing::single_calls(
                &cell.compiled,
                &points[range],
                repetition,
            ));
            let found = timing::batches(&cell.compiled, &levels, &points[range], repetition);
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

/// One peer over several cells.
pub struct Summary {
    pub peer: Peer,
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

/// Every peer that has cells among these.
pub fn summaries<'a>(cells: impl Iterator<Item = &'a Cell>) -> Vec<Summary> {
    let cells: Vec<&Cell> = cells.collect();
    let summary = |peer: Peer| {
        let mut errors = Errors::default();
        let (mut ns, mut notes) = (Vec::new(), Vec::new());
        let mut batches = vec![Vec::new(); Level::all().len()];
        for cell in cells.iter().filter(|cell| cell.peer == peer) {
            errors.join(&cell.errors);
            ns.push(cell.ns);
            let of_levels = batches.iter_mut().zip(&cell.batch_ns);
            of_levels.for_each(|(all, ns)| all.push(*ns));
            notes.extend(cell.note.clone());
        }
        (!ns.is_empty()).then(|| Summary {
            peer,
            errors,
            slowest_ns: ns.iter().copied().fold(0.0, f64::max),
            ns: timing::median(ns),
            batch_ns: medians(batches),
            notes,
        })
    };
    peers().into_iter().filter_map(summary).collect()
}

/// The cells that all methods have: one film on a base, over one range.
pub fn shared(cells: &[Cell], range: Range) -> impl Iterator<Item = &Cell> {
    cells
        .iter()
        .filter(move |cell| cell.is_one_layer && cell.range == range)
}

/// Of these, the cells without dispersion.
pub fn constant(cells: &[Cell], range: Range) -> impl Iterator<Item = &Cell> {
    shared(cells, range).filter(|cell| !cell.has_dispersion)
}
