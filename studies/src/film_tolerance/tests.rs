use super::comparison::{Outcome, check};
use super::kind::{self, KINDS, Kind};
use super::points::{Point, points};
use super::stack::{Index, Stack, Truth};
use super::summary::{PROMISES, Promise, Summary};
use super::{Settings, draw, run};
use std::time::Duration;

const SEED: u64 = 50;

/// 16 stacks at each tolerance, at 200 points each: a method or a measure that breaks the promise of one film in ten is
/// found. `./x check film_tolerance` tries 100 stacks at all tolerances, and asks that few films fall back to the
/// reference.
#[test]
fn films_stay_within_their_tolerance() {
    const STACKS: usize = 16;
    for (i, promise) in PROMISES.into_iter().enumerate() {
        let outcomes = run(&Settings {
            seed: SEED,
            kind: None,
            stacks: i * STACKS..(i + 1) * STACKS,
            points: 200,
            tolerances: vec![promise.tolerance],
        });
        assert_eq!(outcomes.len(), STACKS);
        let broken = outcomes.iter().filter(|outcome| outcome.exceptions > 0);
        let broken: Vec<String> = broken
            .map(|outcome| format!("{}: {outcome:?}", kind::stack(SEED, outcome.number)))
            .collect();
        assert!(broken.is_empty(), "{broken:#?}");
    }
}

/// A stack that is checked from both sides, its points and their truth.
fn example() -> (Stack, Vec<Point>, Vec<Truth>) {
    let mut stacks = (0..).map(|number| (number, draw::general(SEED, number)));
    let (number, stack) = stacks.find(|(_, stack)| stack.both_sides).unwrap();
    let points = points(&stack, SEED, number, 60);
    let truth = stack.truth(&points);
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
        |truth| &mut truth.sides.as_mut().unwrap()[0],
        |truth| &mut truth.sides.as_mut().unwrap()[1],
        |truth| &mut truth.sides.as_mut().unwrap()[2],
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
fn too_many_fallbacks_are_a_failure() {
    let outcome = |number, method: &str| Outcome {
        number,
        kind: Kind::General,
        both_sides: false,
        tolerance: 1e-2,
        method: method.to_owned(),
        refusal: None,
        bytes: 0,
        compile_time: Duration::ZERO,
        points: 1,
        exceptions: 0,
        worst: None,
    };
    let promise = Promise::new(1e-2, 0.02);
    for (fallbacks, failures) in [(2, 0), (3, 1)] {
        let method = |i| match i {
            0 => "refused",
            _ if i < fallbacks => "reference",
            _ => "table",
        };
        let outcomes: Vec<Outcome> = (0..100).map(|i| outcome(i, method(i))).collect();
        let summary = Summary::new(promise, outcomes.iter());
        assert_eq!(summary.failures().len(), failures);
    }
    let mut broken = outcome(0, "table");
    broken.exceptions = 1;
    let summary = Summary::new(promise, std::iter::once(&broken));
    assert_eq!(summary.failures().len(), 1);
}

type Is<'a> = &'a dyn Fn(&Stack) -> bool;

/// The stacks are what they are said to be, and every rare case occurs.
#[test]
fn the_stacks_cover_the_space() {
    let stacks: Vec<Stack> = (0..1000)
        .map(|number| draw::general(SEED, number))
        .collect();
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

/// A thousand stacks have what each kind is for.
#[test]
fn the_kinds_cover_their_cases() {
    let stacks: Vec<Stack> = (0..1000).map(|number| kind::stack(SEED, number)).collect();
    for (stack, number) in stacks.iter().zip(0..) {
        assert_eq!(stack.kind, Kind::of(number));
        if stack.kind == Kind::General {
            assert_eq!(*stack, draw::general(SEED, number));
        }
        stack.reference();
    }
    let of = |kind| stacks.iter().filter(move |stack| stack.kind == kind);
    for ((kind, name), count) in KINDS.into_iter().zip([480, 250, 250, 10, 10]) {
        assert_eq!(of(kind).count(), count, "{name}");
    }
    let constant = |index: &Index| index.medium().constant();
    for stack in of(Kind::Constant) {
        assert!(stack.both_sides && constant(&stack.base).is_some_and(|index| index.im == 0.0));
    }
    let is_dispersing = |stack: &&Stack| {
        let same = stack.ambient == stack.base;
        same || stack
            .critical_interval()
            .is_some_and(|[least, greatest]| greatest > least)
    };
    assert!(of(Kind::Dispersing).all(|stack| stack.both_sides));
    assert!(of(Kind::Dispersing).filter(is_dispersing).count() >= 249);
    for name in kind::not_opaque() {
        let with = of(Kind::Dispersing).filter(|stack| stack.base == Index::Named(name));
        assert!(with.count() >= 3, "{name}");
    }
    let ambients = of(Kind::Dispersing).filter(|stack| constant(&stack.ambient).is_none());
    assert!((80..170).contains(&ambients.count()));
    let has_lines = |index: &Index| matches!(index, Index::Lines(_));
    assert!(of(Kind::Lines).all(|stack| {
        has_lines(&stack.base) || stack.layers.iter().any(|layer| has_lines(&layer.0))
    }));
    assert!(of(Kind::Thick).all(|stack| stack.varying_nm().unwrap()[1] >= 3e4));
}

/// Of the points a quarter is within or next to the critical angles of glass, .7497 to .7582.
#[test]
fn points_are_concentrated_at_critical_angles() {
    let stack = Stack {
        kind: Kind::Dispersing,
        ambient: Index::VACUUM,
        base: Index::Named("BK7"),
        ..draw::general(SEED, 3)
    };
    let near = |kind| {
        let stack = Stack {
            kind,
            ..stack.clone()
        };
        let points = points(&stack, SEED, 3, 1000);
        let is_near = |point: &&Point| (0.749..=0.759).contains(&point[0]);
        points.iter().filter(is_near).count()
    };
    assert!(near(Kind::General) < 50);
    assert!(
        (200..=300).contains(&near(Kind::Dispersing)),
        "{}",
        near(Kind::Dispersing)
    );
}
