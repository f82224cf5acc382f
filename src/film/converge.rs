//! How many nodes a [`Series`] needs.

use super::FilmDescription;
use super::fit::Errors;
use super::points::{measured_range, points};
use super::series::{Powers, Series};
use crate::error::Error;
use crate::optics::Reference;
use crate::optics::stack::Side;

/// The numbers of nodes grow by half.
const LEAST_NODES: usize = 32;
const MOST_NODES: usize = 1600;
/// Where a series is compared with the next one: so many points, and these: cosines; thicknesses as parts
/// of the range; and some, nm, where thin metals resonate and where fringes are many and not yet faded.
const POINTS: usize = 150;
const COSINES: [f64; 7] = [1.0, 0.62, 0.27, 0.085, 0.021, 0.0037, 0.0008];
const PARTS: [f64; 4] = [1.0, 0.0, 0.37, 0.029];
const SOME_NM: [f64; 9] = [
    5.3, 24.0, 110.0, 640.0, 1800.0, 3100.0, 4300.0, 7500.0, 12_000.0,
];
/// The difference of two series is so many times the error of the finer one, or more: that falls faster
/// than any power of the nodes once they resolve the spectrum.
const FASTER: f64 = 3.0;
/// About so many points where two series differ most, so many others are compared, first within this factor
/// of the cosine and of the thickness (its logarithm), at last within that.
const CLIMBS: usize = 16;
const CLIMB: u32 = 40;
const FARTHEST: f64 = 0.7;
const NEAREST: f64 = 1e-3;
/// One in so many of them is compared with the reference.
const SELDOM: usize = 9;

/// The series whose error is less than this where films are hardest, and that error: by what one with two
/// thirds of its nodes differs from it, and by the reference. If none is, the best there is.
pub(super) fn converged(
    description: &FilmDescription,
    reference: &Reference,
    tolerance: f64,
) -> Result<(Series, f64), Error> {
    let points: Vec<_> = corners(description)
        .chain(points(description, POINTS))
        .collect();
    let mut nodes = LEAST_NODES;
    let coarse = Series::new(description, nodes)?;
    let mut values = evaluated(&coarse, &points);
    let mut best: Option<(Series, f64)> = None;
    while best.as_ref().is_none_or(|(_, max)| *max > tolerance) && nodes < MOST_NODES {
        nodes += nodes / 2;
        let fine = Series::new(description, nodes)?;
        let found = evaluated(&fine, &points);
        let error = greatest(description, &values, &found) / FASTER;
        values = found;
        if best.as_ref().is_none_or(|(_, max)| error < *max) {
            best = Some((fine, error));
        }
    }
    let (series, mut error) = best.unwrap_or((coarse, f64::INFINITY));
    if error <= tolerance {
        let seldom: Vec<_> = points.iter().step_by(SELDOM).copied().collect();
        let truth = seldom.iter().map(|&(side, c, d)| {
            let found = reference.evaluate(side, c, &description.thicknesses(d));
            Powers {
                reflectance: found.reflectance,
                transmittance: found.transmittance,
            }
        });
        let truth: Vec<_> = truth.collect();
        error = error.max(greatest(description, &evaluated(&series, &seldom), &truth));
    }
    Ok((series, error))
}

/// The greatest difference of a series and one with half as many nodes again, at so many points and about
/// those where it is greatest: resonances are ridges, and seldom is a point on top of one. The search ends with
/// the first difference that is not allowed.
pub(super) fn uncertainty(
    description: &FilmDescription,
    series: &Series,
    count: usize,
    allowed: f64,
) -> Result<f64, Error> {
    let fine = Series::new(description, series.len() + series.len() / 2)?;
    let difference = |&point: &(Side, f64, f64)| {
        let [series, fine] = [series, &fine].map(|series| evaluated(series, &[point]));
        greatest(description, &series, &fine)
    };
    let mut found = Vec::with_capacity(count);
    for point in points(description, count) {
        let error = difference(&point);
        if error > allowed {
            return Ok(error);
        }
        found.push((error, point));
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    let [least, greatest] = measured_range(description);
    let mut random = 0.5;
    let climbed = found.into_iter().take(CLIMBS).map(|(mut best, mut top)| {
        for step in 0..CLIMB {
            let part = f64::from(step) / f64::from(CLIMB);
            let reach = FARTHEST * (NEAREST / FARTHEST).powf(part);
            let mut factor = |by: f64| {
                random = (random + by).fract();
                (reach * (2.0 * random - 1.0)).exp()
            };
            let (side, c, d) = top;
            let c = (c * factor(0.754_877_666)).min(1.0);
            let d = (least + (d - least) * factor(0.569_840_291)).min(greatest);
            let error = difference(&(side, c, d));
            if error > best {
                (best, top) = (error, (side, c, d));
            }
        }
        best
    });
    Ok(climbed.fold(0.0, f64::max))
}

fn evaluated(series: &Series, points: &[(Side, f64, f64)]) -> Vec<Powers> {
    let values = points.iter().map(|&(side, c, d)| series.at(side, c, d));
    values.collect()
}

fn greatest(description: &FilmDescription, found: &[Powers], expected: &[Powers]) -> f64 {
    let mut errors = Errors::default();
    for (found, expected) in found.iter().zip(expected) {
        errors.add(found.reflectance, expected.reflectance, true);
        if description.transmittance {
            errors.add(found.transmittance, expected.transmittance, true);
        }
    }
    errors.max
}

/// The corners of the range, from all sides.
fn corners(description: &FilmDescription) -> impl Iterator<Item = (Side, f64, f64)> {
    let [least, greatest] = measured_range(description);
    let parts = PARTS.map(|part| least + part * (greatest - least));
    let mut thicknesses: Vec<f64> = parts.into_iter().chain(SOME_NM).collect();
    thicknesses.retain(|d| (least..=greatest).contains(d));
    thicknesses.dedup();
    description.sides().iter().flat_map(move |&side| {
        let thicknesses = thicknesses.clone();
        COSINES
            .into_iter()
            .flat_map(move |c| thicknesses.clone().into_iter().map(move |d| (side, c, d)))
    })
}
