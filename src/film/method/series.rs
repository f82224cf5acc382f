//! The series of fringes at every call.

use super::info::{Compile, MethodInfo};
use crate::error::Error;
use crate::film::evaluator::Evaluator;
use crate::film::fringe_series::series::FringeSeries;
use crate::film::plan::converge::uncertainty;
use crate::film::plan::planner::{Candidate, Planner, SLOW_POINTS};
use crate::film::plan::points::points;
use crate::film::table::errors::Errors;
use crate::num::Rgb;

/// The part of the tolerance that the error found may have: the errors of the series are narrow peaks.
const PEAKS: f64 = 0.05;
/// A series with this number of wavenumbers is not refined: it would take as long as the reference.
const MOST_WAVENUMBERS: usize = 4000;
/// The number of points at which a series is compared with a finer one.
const POINTS: usize = 2000;

/// [`FringeSeries`], with all harmonics of one layer.
pub(super) const INFO: MethodInfo = MethodInfo {
    name: "series",
    sizes: &[1],
    cost_ns: |_| 1e4,
    is_automatic: true,
    takes: |_| true,
    takes_words: "any film",
    allowed_error: |tolerance| PEAKS * tolerance,
    reason: "the cheapest method that holds the tolerance",
    compile: Compile::Film(|planner| compile(planner).map(Some)),
};

/// The series has at least twice the wavenumbers of the series that fills tables, because no spline smooths
/// the errors at single points.
fn compile(planner: &Planner<'_>) -> Result<Candidate, Error> {
    let description = planner.description;
    let allowed = (INFO.allowed_error)(planner.limits.tolerance);
    let mut count = planner.series.len();
    let (series, uncertainty) = loop {
        count *= 2;
        let series = FringeSeries::new(description, count)?;
        // The reference is too slow for the many points that find narrow resonances.
        let uncertainty = uncertainty(description, &series, POINTS, allowed)?;
        if uncertainty <= allowed || count >= MOST_WAVENUMBERS {
            break (series, uncertainty);
        }
    };
    let mut errors = [Errors::default(); 2];
    let points_with_reference = if uncertainty > allowed {
        0
    } else {
        SLOW_POINTS
    };
    for (side, c, d) in points(description, points_with_reference) {
        let (c32, d32) = (f64::from(c as f32), f64::from(d as f32));
        let found = series.at(side, c32, d32).to_f32();
        let truth = planner
            .reference
            .evaluate(side, c, &description.thicknesses(d));
        let unclipped = planner.limits.unclipped;
        let errors = &mut errors[side as usize];
        let wide = |rgb: Rgb<f32>| rgb.map(f64::from);
        errors.add(wide(found.reflectance), truth.reflectance, unclipped);
        if description.transmittance {
            errors.add(wide(found.transmittance), truth.transmittance, unclipped);
        }
    }
    for errors in &mut errors {
        errors.max = errors.max.max(uncertainty);
    }
    Ok(Candidate {
        errors,
        bytes: series.bytes(),
        size: format!("all harmonics at {} wavelengths", series.len()),
        evaluator: Evaluator::Series(series),
    })
}
