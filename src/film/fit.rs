//! Finds the size of a table, fills it, and has it measured.

mod errors;
mod shape;

use super::axes::Axes;
use super::table::{Curve, Table, reserve};
use crate::error::Error;
use crate::num::Rgb;
use crate::num::spline::LEAST_VALUES;
pub(super) use errors::Errors;

/// Colours at a cosine and a thickness, exact beside the tolerance. Calls at the same cosine one after
/// another are cheaper.
pub(super) type Source<'a> = dyn FnMut(f64, f64) -> Rgb<f64> + 'a;

/// What is to be tabulated.
pub(super) struct Task<'a> {
    pub source: &'a mut Source<'a>,
    /// Least and greatest thickness, nm.
    pub range: [f64; 2],
    /// The square of the ratio of the ambient's index and the layer's.
    pub tilt: f64,
    /// Whether a cosine of its own for every value is slow.
    pub is_costly: bool,
    pub limits: Limits,
}

/// What a table must hold.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The greatest error.
    pub tolerance: f64,
    /// Whether colours outside [0, 1] count.
    pub unclipped: bool,
    /// The greatest number of values.
    pub size: usize,
}

/// A table, and the errors found between its values.
pub(super) struct Fitted<T> {
    pub table: T,
    pub errors: Errors,
}

/// The part of the tolerance that an error found may have: the points between which it is looked for
/// are as many as the table's own, not all there are.
const FOUND: f64 = 0.5;
/// A table whose error is below this part of what is allowed is made smaller.
const WASTED: f64 = 0.3;
/// How often a table is made larger, or smaller.
const ATTEMPTS: usize = 8;
/// Values for a count that was estimated, within what is possible.
fn bounded(estimate: f64, limit: usize) -> usize {
    (estimate.ceil().min(1e6) as usize + 3).clamp(LEAST_VALUES + 2, limit)
}

/// A table over the cosine alone; none if the limits cannot be met.
pub(super) fn curve(
    source: &mut Source<'_>,
    limits: Limits,
) -> Result<Option<Fitted<Curve>>, Error> {
    let (shape, estimate) = shape::of_curve(source, &limits);
    let axes = Axes::new(shape, [0.0, 0.0]);
    let mut count = bounded(estimate, limits.size);
    for _ in 0..ATTEMPTS {
        let at = |i: f64| axes.point(i / (count - 1) as f64, 0.0).0;
        let mut values = reserve(count)?;
        values.extend((0..count).map(|i| source(at(i as f64), 0.0)));
        let table = Curve::new(&axes, &values)?;
        let errors = errors::of_curve(source, &table, limits, at);
        if errors.max <= FOUND * limits.tolerance {
            return Ok(Some(Fitted { table, errors }));
        }
        count = enlarged(count, errors.max, &limits);
        if count > limits.size {
            break;
        }
    }
    Ok(None)
}

/// A table over both coordinates; none if the limits cannot be met.
pub(super) fn table(task: &mut Task<'_>) -> Result<Option<Fitted<Table>>, Error> {
    let first = if task.is_costly { 2.0 } else { 1.0 };
    for handicap in [first, 0.2] {
        let (shape, estimates) = shape::of_table(task, handicap);
        let counts = estimates.map(|estimate| bounded(estimate, task.limits.size));
        let axes = Axes::new(shape, task.range);
        let fitted = grown(task, &axes, counts)?;
        if fitted.is_some() {
            return Ok(fitted);
        }
    }
    Ok(None)
}

/// A table on these axes, of the size that the limits take; none if they cannot be met.
fn grown(
    task: &mut Task<'_>,
    axes: &Axes,
    mut counts: [usize; 2],
) -> Result<Option<Fitted<Table>>, Error> {
    let limits = task.limits;
    let allowed = FOUND * limits.tolerance;
    let mut held: Option<Fitted<Table>> = None;
    for _ in 0..ATTEMPTS {
        let [width, height] = counts;
        if width * height > limits.size {
            break;
        }
        let (fitted, [across, along]) = filled(task, axes, counts)?;
        let max = fitted.errors.max;
        if max <= allowed {
            // Once smaller, if much too good, and as it was, if that was too small.
            if held.is_some() || max > WASTED * allowed {
                return Ok(Some(fitted));
            }
            let factor = (max / (0.7 * allowed)).cbrt().max(0.5);
            let smaller =
                |count: usize| ((count as f64 * factor).ceil() as usize).max(LEAST_VALUES + 2);
            counts = counts.map(smaller);
            held = Some(fitted);
            continue;
        }
        if held.is_some() {
            break;
        }
        // Whichever coordinate is to blame: what is found is taken for the error of the worse one, and the
        // other's is in proportion.
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
    Ok(held)
}

/// A table of so many values, its errors, and at the worst point those along each coordinate alone.
fn filled(
    task: &mut Task<'_>,
    axes: &Axes,
    [width, height]: [usize; 2],
) -> Result<(Fitted<Table>, [f64; 2]), Error> {
    let point = |i: f64, j: f64| axes.point(i / (width - 1) as f64, j / (height - 1) as f64);
    let mut values = reserve(width * height)?;
    values.resize(width * height, [0.0; 3]);
    for i in 0..width {
        for j in 0..height {
            let (c, d) = point(i as f64, j as f64);
            values[j * width + i] = (task.source)(c, d);
        }
    }
    let table = Table::new(axes, &values, width)?;
    let (errors, shares) = errors::of_table(task, &table, [width, height], &point);
    Ok((Fitted { table, errors }, shares))
}

/// A count with which an error, of order 3, would be small enough.
fn enlarged(count: usize, error: f64, limits: &Limits) -> usize {
    let factor = (error / (0.7 * FOUND * limits.tolerance)).cbrt();
    (count as f64 * factor.clamp(1.1, 2.0)).ceil() as usize
}
