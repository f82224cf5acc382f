//! One film against the truth.

use super::points::Point;
use super::stack::Stack;
use super::truth::Truth;
use pellicle::film::Film;
use pellicle::optics::stack::Side;
use std::time::{Duration, Instant};

/// The method that a film falls back to.
pub const FALLBACK: &str = "reference";
/// A film that is evaluated by the reference itself is compared at every so many points.
const FALLBACK_STRIDE: usize = 100;

/// What was found of one film.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The number of its stack.
    pub number: usize,
    pub both_sides: bool,
    pub tolerance: f64,
    pub method: String,
    pub bytes: usize,
    pub compile_time: Duration,
    /// Points compared.
    pub points: usize,
    /// Points at which a colour was off by more than the tolerance.
    pub exceptions: usize,
    /// Where it was off most.
    pub worst: Option<Difference>,
}

impl Outcome {
    /// The greatest error, in tolerances.
    pub fn ratio(&self) -> f64 {
        self.worst.as_ref().map_or(0.0, |worst| worst.error) / self.tolerance
    }
}

/// A colour and what it should be.
#[derive(Clone, Debug)]
pub struct Difference {
    pub what: &'static str,
    pub point: Point,
    pub found: [f32; 3],
    pub truth: [f64; 3],
    pub error: f64,
}

/// Compiles the film of a stack and compares it.
pub fn check(
    number: usize,
    stack: &Stack,
    tolerance: f64,
    points: &[Point],
    truth: &[Truth],
) -> Outcome {
    let description = stack.description(tolerance);
    let start = Instant::now();
    let film = Film::new(&description).unwrap_or_else(|error| panic!("{stack}: {error}"));
    let compile_time = start.elapsed();
    let plan = film.plan();
    let mut outcome = Outcome {
        number,
        both_sides: stack.both_sides,
        tolerance,
        method: plan.method.to_owned(),
        bytes: plan.bytes,
        compile_time,
        points: 0,
        exceptions: 0,
        worst: None,
    };
    let stride = if outcome.method == FALLBACK {
        FALLBACK_STRIDE
    } else {
        1
    };
    for (point, truth) in points.iter().zip(truth).step_by(stride) {
        outcome.add(differences(&film, *point, truth));
    }
    outcome
}

impl Outcome {
    fn add(&mut self, differences: Vec<Difference>) {
        self.points += 1;
        let within = differences.iter().all(|d| d.error <= self.tolerance);
        self.exceptions += usize::from(!within);
        for difference in differences {
            let worst = self.worst.as_ref().map_or(-1.0, |worst| worst.error);
            if difference.error > worst {
                self.worst = Some(difference);
            }
        }
    }
}

/// All colours of a film at one point.
fn differences(film: &Film, point: Point, truth: &Truth) -> Vec<Difference> {
    let Point {
        cos_theta,
        thickness_nm,
    } = point;
    let difference = |what, found, truth| Difference {
        what,
        point,
        found,
        truth,
        error: error(found, truth),
    };
    let found = film.reflectance(cos_theta, thickness_nm);
    let mut differences = vec![difference("reflectance", found, truth.reflectance)];
    if let Some(sides) = &truth.sides {
        let [ambient, base] = [Side::Ambient, Side::Base]
            .map(|side| film.colors(side, cos_theta, thickness_nm).unwrap());
        differences.extend([
            difference("R of both", ambient.reflectance, truth.reflectance),
            difference("T", ambient.transmittance, sides.transmittance),
            difference(
                "R from the base",
                base.reflectance,
                sides.reflectance_from_base,
            ),
            difference(
                "T from the base",
                base.transmittance,
                sides.transmittance_from_base,
            ),
        ]);
    }
    differences
}

/// The greatest error of a channel on clipped colours; infinite if one is not a number.
pub fn error(found: [f32; 3], truth: [f64; 3]) -> f64 {
    let errors = found.iter().zip(truth).map(|(found, truth)| {
        let error = (f64::from(*found) - truth.clamp(0.0, 1.0)).abs();
        if error.is_nan() { f64::INFINITY } else { error }
    });
    errors.fold(0.0, f64::max)
}
