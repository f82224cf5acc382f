//! A film's tolerance is a promise: its error against the reference stays within. 50 random stacks
//! here; `./x check promise` tries 1,000, and asks that few films fall back to the reference.

#[path = "common/promise/mod.rs"]
mod promise;

use promise::comparison::{Outcome, check, error};
use promise::points::points;
use promise::run::{Settings, run};
use promise::stack::{Index, Stack};
use promise::summary::{PROMISES, Promise, Summary};
use promise::truth::{Truth, has_sides, truth};
use promise::{draw, truth_file};
use std::time::Duration;

const SEED: u64 = 50;

#[test]
fn films_stay_within_their_tolerance() {
    let settings = Settings {
        seed: SEED,
        stacks: 0..50,
        points: 200,
        tolerances: PROMISES.map(|promise| promise.tolerance).into(),
        truth_folder: None,
    };
    let checked = run(&settings, |_, _| {});
    let outcomes: Vec<Outcome> = checked.into_iter().flat_map(|c| c.outcomes).collect();
    assert_eq!(outcomes.len(), 150);
    let broken = outcomes.iter().filter(|outcome| outcome.exceptions > 0);
    let broken: Vec<String> = broken
        .map(|outcome| format!("{}: {outcome:?}", draw::stack(SEED, outcome.number)))
        .collect();
    assert!(broken.is_empty(), "{broken:#?}");
}

/// A stack that is checked from both sides, its points and their truth.
fn example() -> (Stack, Vec<promise::points::Point>, Vec<Truth>) {
    let number = (0..).find(|number| draw::stack(SEED, *number).both_sides);
    let number = number.unwrap();
    let stack = draw::stack(SEED, number);
    let points = points(&stack, SEED, number, 60);
    let reference = stack.reference();
    let truth = |(i, point)| truth(&stack, &reference, point, has_sides(&stack, i));
    let truth = points.iter().copied().enumerate().map(truth).collect();
    (stack, points, truth)
}

/// The comparison itself can fail: it finds one wrong channel of any colour, and NaN.
#[test]
fn a_perturbed_truth_is_found() {
    const TOLERANCE: f64 = 1e-2;
    let (stack, points, truth) = example();
    let exceptions = |truth: &[Truth]| check(0, &stack, TOLERANCE, &points, truth).exceptions;
    assert_eq!(exceptions(&truth), 0);
    let perturbations: [fn(&mut Truth) -> &mut [f64; 3]; 4] = [
        |truth| &mut truth.reflectance,
        |truth| &mut truth.sides.as_mut().unwrap().transmittance,
        |truth| &mut truth.sides.as_mut().unwrap().reflectance_from_base,
        |truth| &mut truth.sides.as_mut().unwrap().transmittance_from_base,
    ];
    for color in perturbations {
        for channel in 0..3 {
            let mut perturbed = truth.clone();
            let value = &mut color(&mut perturbed[0])[channel];
            *value += if *value < 0.5 { 0.025 } else { -0.025 };
            assert_eq!(exceptions(&perturbed), 1);
            color(&mut perturbed[0])[channel] = f64::NAN;
            assert_eq!(exceptions(&perturbed), 1);
        }
    }
}

#[test]
fn errors_are_those_of_clipped_colours() {
    assert_eq!(error([1.0, 0.0, 0.5], [1.25, -0.5, 0.5]), 0.0);
    assert_eq!(error([1.0, 0.0, 0.5], [0.75, -0.5, 0.5]), 0.25);
    assert_eq!(error([f32::NAN, 0.0, 0.0], [0.0; 3]), f64::INFINITY);
}

#[test]
fn too_many_fallbacks_are_a_failure() {
    let outcome = |number, method: &str| Outcome {
        number,
        both_sides: false,
        tolerance: 1e-2,
        method: method.to_owned(),
        bytes: 0,
        compile_time: Duration::ZERO,
        points: 1,
        exceptions: 0,
        worst: None,
    };
    let promise = Promise {
        tolerance: 1e-2,
        greatest_fallback: 0.02,
    };
    for (fallbacks, failures) in [(2, 0), (3, 1)] {
        let method = |i| if i < fallbacks { "reference" } else { "table" };
        let outcomes: Vec<Outcome> = (0..100).map(|i| outcome(i, method(i))).collect();
        let summary = Summary::new(promise, outcomes.iter());
        assert_eq!(summary.failures().len(), failures);
    }
    let mut broken = outcome(0, "table");
    broken.exceptions = 1;
    let summary = Summary::new(promise, std::iter::once(&broken));
    assert_eq!(summary.failures().len(), 1);
}

/// What was kept of a stack is used for that stack, up to the first point that differs.
#[test]
fn kept_truth_is_that_of_the_stack_and_its_points() {
    let (stack, points, truth) = example();
    let folder = std::env::temp_dir().join(format!("pellicle-truth-{}", std::process::id()));
    truth_file::save(&folder, &stack, &points, &truth);
    assert_eq!(truth_file::load(&folder, &stack, &points), truth);
    assert_eq!(
        truth_file::load(&folder, &stack, &points[..40]),
        truth[..40]
    );
    let mut others = points;
    others[30].cos_theta *= 0.5;
    assert_eq!(truth_file::load(&folder, &stack, &others), truth[..30]);
    let mut other = stack.clone();
    other.base = Index::constant(1.234, 0.0);
    assert_eq!(truth_file::load(&folder, &other, &others), []);
    std::fs::remove_dir_all(folder).unwrap();
}

type Is<'a> = &'a dyn Fn(&Stack) -> bool;

/// The stacks are what they are said to be, and every rare case occurs.
#[test]
fn the_stacks_cover_the_space() {
    let stacks: Vec<Stack> = (0..1000).map(|number| draw::stack(SEED, number)).collect();
    let count = |is: Is| stacks.iter().filter(|stack| is(stack)).count();
    for stack in &stacks {
        stack.reference();
        assert!((1..=5).contains(&stack.layers.len()));
        for (index, [min, max]) in &stack.layers {
            assert!(0.0 <= *min && min <= max && *max <= 3000.0);
            let index = index.medium().index(550.0);
            assert!((1.0..=4.0).contains(&index.re) && (0.0..=8.0).contains(&index.im));
        }
    }
    let absorbs = |index: &Index| index.medium().absorbs();
    let is_dispersive = |index: &Index| index.medium().constant().is_none();
    let varying = count(&|stack| stack.varying_nm().is_some());
    assert!((760..=840).contains(&varying), "{varying}");
    for layers in 1..=5 {
        assert!(count(&|stack| stack.layers.len() == layers) > 150);
    }
    let cases: [(&str, Is); 9] = [
        ("denser ambient", &|s| s.ambient != Index::VACUUM),
        ("soap", &|s| s.base == s.ambient),
        ("absorbing base", &|s| absorbs(&s.base)),
        ("named base", &|s| matches!(s.base, Index::Named(_))),
        ("absorbing layer", &|s| {
            s.layers.iter().any(|l| absorbs(&l.0))
        }),
        ("dispersive layer", &|s| {
            s.layers.iter().any(|l| is_dispersive(&l.0))
        }),
        ("equal neighbours", &|s| {
            s.layers.windows(2).any(|pair| pair[0].0 == pair[1].0)
        }),
        ("layer like vacuum", &|s| {
            s.layers.iter().any(|l| l.0 == Index::VACUUM)
        }),
        ("both sides", &|s| s.both_sides),
    ];
    for (name, is) in cases {
        assert!((20..=900).contains(&count(is)), "{name}: {}", count(is));
    }
}
