//! Fits a table: chooses its axes and its size, fills it and measures it.

use super::axes::Axes;
use super::axis_choice;
use super::errors::{self, Errors};
use super::spline::{SplineTable, reserve};
use super::task::{ColorSource, FitLimits, FitTask};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::num::spline::LEAST_VALUES;

/// A table, and its errors between its values.
pub(in crate::film) type Fitted = (SplineTable, Errors);

/// The part of the tolerance that the error found may have: it is measured at about as many points as
/// the table has values, and greater errors may lie between them.
const FOUND: f64 = 0.5;
/// A table whose error is below this part of the allowed one is made smaller.
const WASTED: f64 = 0.3;
/// A film is given up if its error is above this part of the error three sizes before: where values lie closer and
/// the error does not fall, the colours have a step, and the larger tables would all fail. One or two sizes in vain
/// prove nothing, since each may enlarge the wrong coordinate alone.
const STALLED: f64 = 0.97;
/// A table of more values than this whose error is this multiple of the allowed one is given up: the colours have
/// features that are much narrower than its steps, and patches find them with fewer values.
const LARGE: usize = 6000;
const HOPELESS: f64 = 12.0;
/// The number of sizes that are tried.
const ATTEMPTS: usize = 8;

/// The number of values for an estimate, within the limits of a table.
fn bounded(estimate: f64, limit: usize) -> usize {
    (estimate.ceil().min(1e6) as usize + 3).clamp(LEAST_VALUES + 2, limit)
}

/// A table over the cosine, or over the thickness too if a layer varies within this range, nm.
pub(super) fn of_film(
    description: &FilmDescription,
    source: &mut ColorSource<'_>,
    range: [f64; 2],
    tilt: f64,
    limits: FitLimits,
) -> Result<Option<Fitted>, Error> {
    if description.varying().is_none() {
        return over_cosine(source, limits);
    }
    over_both(&mut FitTask {
        source,
        range,
        tilt,
        is_costly: description.layers.len() > 1,
        limits,
    })
}

/// A table over the cosine alone; `None` if the limits cannot be met.
pub(super) fn over_cosine(
    source: &mut ColorSource<'_>,
    limits: FitLimits,
) -> Result<Option<Fitted>, Error> {
    let (params, estimate) = axis_choice::over_cosine(source, &limits);
    let axes = Axes::new(params, [0.0, 0.0]);
    let mut count = bounded(estimate, limits.size);
    for _ in 0..ATTEMPTS {
        let at = |i: f64| axes.point(i / (count - 1) as f64, 0.0).0;
        let mut values = reserve(count)?;
        values.extend((0..count).map(|i| source(at(i as f64), 0.0)));
        let table = SplineTable::over_cosine(&axes, &values)?;
        let errors = errors::over_cosine(source, &table, count, limits, at);
        if errors.max <= FOUND * limits.tolerance {
            return Ok(Some((table, errors)));
        }
        count = enlarged(count, errors.max, &limits);
        if count > limits.size {
            break;
        }
    }
    Ok(None)
}

/// A table over both coordinates; `None` if the limits cannot be met.
pub(super) fn over_both(task: &mut FitTask<'_>) -> Result<Option<Fitted>, Error> {
    let first = if task.is_costly { 2.0 } else { 1.0 };
    for handicap in [first, 0.2] {
        let (params, estimates) = axis_choice::over_both(task, handicap);
        let counts = estimates.map(|estimate| bounded(estimate, task.limits.size));
        let axes = Axes::new(params, task.range);
        let fitted = grown(task, &axes, counts)?;
        if fitted.is_some() {
            return Ok(fitted);
        }
    }
    Ok(None)
}

/// A table on given axes, as large as the limits ask for; `None` if they cannot be met.
fn grown(
    task: &mut FitTask<'_>,
    axes: &Axes,
    mut counts: [usize; 2],
) -> Result<Option<Fitted>, Error> {
    let limits = task.limits;
    let allowed = FOUND * limits.tolerance;
    let mut larger_fit: Option<Fitted> = None;
    let mut before = [f64::INFINITY; 3];
    for _ in 0..ATTEMPTS {
        let [width, height] = counts;
        if width * height > limits.size {
            break;
        }
        let (fitted, [across, along]) = filled(task, axes, counts)?;
        let max = fitted.1.max;
        if max <= allowed {
            // A table that is much too good is made smaller once, and taken if the smaller one fails.
            if larger_fit.is_some() || max > WASTED * allowed {
                return Ok(Some(fitted));
            }
            let factor = (max / (0.7 * allowed)).cbrt().max(0.5);
            let smaller =
                |count: usize| ((count as f64 * factor).ceil() as usize).max(LEAST_VALUES + 2);
            counts = counts.map(smaller);
            larger_fit = Some(fitted);
            continue;
        }
        let is_hopeless = width * height > LARGE && max > HOPELESS * allowed;
        if larger_fit.is_some() || max > STALLED * before[0] || is_hopeless {
            break;
        }
        before = [before[1], before[2], max];
        // The greatest error is attributed to the worse coordinate, and the other one's is in
        // proportion.
        let share = max / across.max(along).max(f64::MIN_POSITIVE);
        let larger = [(width, across), (height, along)].map(|(count, error)| {
            if error * share > 0.3 * allowed {
                enlarged(count, error * share, &limits)
            } else {
                count
            }
        });
        counts = if larger == counts {
            counts.map(|count| count + count / 4)
        } else {
            larger
        };
    }
    Ok(larger_fit)
}

/// A table of a given size with its errors, and its errors along each coordinate alone at the worst
/// point.
fn filled(
    task: &mut FitTask<'_>,
    axes: &Axes,
    [width, height]: [usize; 2],
) -> Result<(Fitted, [f64; 2]), Error> {
    let point = |i: f64, j: f64| axes.point(i / (width - 1) as f64, j / (height - 1) as f64);
    let mut values = reserve(width * height)?;
    values.resize(width * height, [0.0; 3]);
    for i in 0..width {
        for j in 0..height {
            let (c, d) = point(i as f64, j as f64);
            values[j * width + i] = (task.source)(c, d);
        }
    }
    let table = SplineTable::over_both(axes, &values, width)?;
    let (errors, shares) = errors::over_both(task, &table, [width, height], &point);
    Ok(((table, errors), shares))
}

/// The count that makes an error of order 3 small enough.
fn enlarged(count: usize, error: f64, limits: &FitLimits) -> usize {
    let factor = (error / (0.7 * FOUND * limits.tolerance)).cbrt();
    (count as f64 * factor.clamp(1.1, 2.0)).ceil() as usize
}
