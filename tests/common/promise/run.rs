//! Many stacks, on all processors.

use super::comparison::{Outcome, check};
use super::points::{Point, points};
use super::stack::Stack;
use super::truth::{Truth, has_sides, truth};
use super::{draw, truth_file};
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// What to check.
#[derive(Clone, Debug)]
pub struct Settings {
    pub seed: u64,
    /// Numbers in the seed's series of stacks.
    pub stacks: Range<usize>,
    /// Points of each.
    pub points: usize,
    pub tolerances: Vec<f64>,
    /// Where the truth is kept, if it is.
    pub truth_folder: Option<PathBuf>,
}

/// What was found of one stack.
#[derive(Clone, Debug)]
pub struct Checked {
    /// One per tolerance.
    pub outcomes: Vec<Outcome>,
    /// Points whose truth had to be computed, and what that took.
    pub truth_points: usize,
    pub truth_time: Duration,
}

/// Checks all stacks, in their order. `progress` is told how many are done and the latest.
pub fn run(settings: &Settings, progress: impl Fn(usize, &Checked) + Sync) -> Vec<Checked> {
    let next = Mutex::new(settings.stacks.clone());
    let done = Mutex::new(Vec::new());
    let work = || {
        loop {
            let number = next.lock().unwrap().next();
            let Some(number) = number else { return };
            let checked = check_stack(settings, number);
            let mut done = done.lock().unwrap();
            progress(done.len() + 1, &checked);
            done.push((number, checked));
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let mut done = done.into_inner().unwrap();
    done.sort_by_key(|(number, _)| *number);
    done.into_iter().map(|(_, checked)| checked).collect()
}

fn check_stack(settings: &Settings, number: usize) -> Checked {
    let stack = draw::stack(settings.seed, number);
    let checked = || {
        let points = points(&stack, settings.seed, number, settings.points);
        let start = Instant::now();
        let (truth, truth_points) = all_truth(settings, &stack, &points);
        let truth_time = start.elapsed();
        let check = |tolerance: &f64| check(number, &stack, *tolerance, &points, &truth);
        Checked {
            outcomes: settings.tolerances.iter().map(check).collect(),
            truth_points,
            truth_time,
        }
    };
    catch_unwind(AssertUnwindSafe(checked)).unwrap_or_else(|panic| {
        eprintln!("while checking stack {number}: {stack}");
        resume_unwind(panic)
    })
}

/// The truth at every point, and at how many of them it had to be computed.
fn all_truth(settings: &Settings, stack: &Stack, points: &[Point]) -> (Vec<Truth>, usize) {
    let folder = settings.truth_folder.as_deref();
    let mut known = folder.map_or_else(Vec::new, |f| truth_file::load(f, stack, points));
    let missing = points.len() - known.len();
    if missing > 0 {
        let reference = stack.reference();
        for (i, point) in points.iter().enumerate().skip(known.len()) {
            known.push(truth(stack, &reference, *point, has_sides(stack, i)));
        }
        if let Some(folder) = folder {
            truth_file::save(folder, stack, points, &known);
        }
    }
    (known, missing)
}
