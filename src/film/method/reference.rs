//! Converged wave optics at every call.

use super::info::{Compile, MethodInfo};
use crate::film::evaluator::Evaluator;
use crate::film::plan::planner::Candidate;
use crate::film::plan::points::points;
use crate::film::table::errors::Errors;

/// The number of points at which the reference's own convergence is asked for.
const POINTS: usize = 3;
/// The reference is taken to hold every tolerance from here on.
const ALWAYS: f64 = 1e-4;

/// [`Reference`](crate::optics::Reference): slow, and it allocates.
pub(super) const INFO: MethodInfo = MethodInfo {
    name: "reference",
    sizes: &[1],
    cost_ns: |_| 1e5,
    is_automatic: true,
    takes: |_| true,
    takes_words: "any film",
    allowed_error: |tolerance| {
        if tolerance >= ALWAYS {
            f64::INFINITY
        } else {
            tolerance
        }
    },
    reason: "no faster method holds the tolerance",
    compile: Compile::Film(|planner| {
        let mut errors = [Errors::default(); 2];
        for (side, c, d) in points(planner.description, POINTS) {
            let thicknesses = planner.description.thicknesses(d);
            let change = planner.reference.evaluate(side, c, &thicknesses).change;
            errors[side as usize].add([change; 3], [0.0; 3], true);
        }
        Ok(Some(Candidate {
            evaluator: Evaluator::Reference,
            errors,
            bytes: 0,
            size: "converged wave optics".into(),
        }))
    }),
};
