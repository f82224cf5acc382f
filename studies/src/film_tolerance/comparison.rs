//! One film against the truth.

use super::kind::Kind;
use super::points::Point;
use super::stack::{Stack, Truth};
use crate::shared::peer::method_of;
use crate::shared::stack::clipped_error;
use pellicle::film::Film;
use pellicle::optics::stack::Side;
use std::time::{Duration, Instant};

/// The method that a film falls back to.
pub const FALLBACK: &str = "reference";
/// What is said in place of a method where there is no film.
pub const REFUSED: &str = "refused";
/// A film that the reference itself evaluates is compared at every point of this number.
const FALLBACK_STRIDE: usize = 100;

/// What was found of one film.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The number of its stack.
    pub number: usize,
    pub kind: Kind,
    pub both_sides: bool,
    pub tolerance: f64,
    /// The method, or [`REFUSED`].
    pub method: String,
    /// Why it was refused, if it was.
    pub refusal: Option<String>,
    pub bytes: usize,
    pub compile_time: Duration,
    /// The number of points compared.
    pub points: usize,
    /// The number of points at which a colour was off by more than the tolerance.
    pub exceptions: usize,
    /// The greatest error.
    pub worst: Option<Difference>,
}

/// A colour, the true colour, and the difference.
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
    let film = Film::new(&description);
    let mut outcome = Outcome {
        number,
        kind: stack.kind,
        both_sides: stack.both_sides,
        tolerance,
        method: film.as_ref().map_or(REFUSED.to_owned(), method_of),
        refusal: film.as_ref().err().map(ToString::to_string),
        bytes: film.as_ref().map_or(0, |film| film.plan().bytes),
        compile_time: start.elapsed(),
        points: 0,
        exceptions: 0,
        worst: None,
    };
    let Ok(film) = film else {
        return outcome;
    };
    let is_fallback = outcome.method == FALLBACK;
    let stride = if is_fallback { FALLBACK_STRIDE } else { 1 };
    for (point, truth) in points.iter().zip(truth).step_by(stride) {
        outcome.add(differences(&film, *point, truth));
    }
    outcome
}

impl Outcome {
    /// The greatest error, in tolerances.
    pub fn ratio(&self) -> f64 {
        self.worst.as_ref().map_or(0.0, |worst| worst.error) / self.tolerance
    }

    fn add(&mut self, differences: Vec<Difference>) {
        self.points += 1;
        let is_within = differences.iter().all(|d| d.error <= self.tolerance);
        self.exceptions += usize::from(!is_within);
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
    let [cos_theta, thickness_nm] = point;
    let difference = |what, found, truth| Difference {
        what,
        point,
        found,
        truth,
        error: clipped_error(found, truth),
    };
    let found = film.reflectance(cos_theta, thickness_nm);
    let mut differences = vec![difference("reflectance", found, truth.reflectance)];
    if let Some([transmittance, base_reflectance, base_transmittance]) = truth.sides {
        let [ambient, base] = [Side::Ambient, Side::Base]
            .map(|side| film.colors(side, cos_theta, thickness_nm).unwrap());
        differences.extend([
            difference("R of both", ambient.reflectance, truth.reflectance),
            difference("T", ambient.transmittance, transmittance),
            difference("R from the base", base.reflectance, base_reflectance),
            difference("T from the base", base.transmittance, base_transmittance),
        ]);
    }
    differences
}
