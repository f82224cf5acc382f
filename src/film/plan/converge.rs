//! The number of wavenumbers that a [`FringeSeries`] needs.

use super::points::{measured_range, points};
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::fringe_series::series::FringeSeries;
use crate::film::table::errors::Errors;
use crate::optics::Reference;
use crate::optics::critical_cosine;
use crate::optics::stack::Side;
use std::f64::consts::TAU;

/// The searches for a series: whether it is graded, and the least and the greatest number of wavenumbers, each half
/// as large again as the one before. A graded series takes longer for each angle, but wants fewer wavenumbers where
/// resonances are narrow.
const SEARCHES: [(bool, [usize; 2]); 3] =
    [(false, [32, 400]), (true, [32, 300]), (false, [400, 1600])];
/// A series is compared with the next one at this number of points and at all pairs of the following
/// cosines and thicknesses: parts of the range, and thicknesses (nm) at which thin metals resonate or
/// many fringes have not yet faded.
const POINTS: usize = 150;
const COSINES: [f64; 7] = [1.0, 0.62, 0.27, 0.085, 0.021, 0.0037, 0.0008];
const PARTS: [f64; 4] = [1.0, 0.0, 0.37, 0.029];
const SOME_NM: [f64; 9] = [
    5.3, 24.0, 110.0, 640.0, 1800.0, 3100.0, 4300.0, 7500.0, 12_000.0,
];
/// A series of a stack of several layers is also compared with a graded one just beyond the critical angle of each
/// layer: at this wavelength, nm, and at these decays of the amplitude across the layer, in nepers. Light tunnels through
/// the layer there, to resonances behind it that are narrow and still show; few of the points above meet one.
const TUNNEL_NM: f64 = 550.0;
const DECAYS: [f64; 8] = [0.3, 0.6, 1.0, 1.4, 1.8, 2.4, 3.2, 4.0];
/// The number of wavelengths whose critical angles are looked at, where a half-space disperses: the error of a branch
/// point is great where it lies on a resonance, which may be narrow. The first and the last, nm: the channels are
/// small beyond.
const BRANCHES: usize = 24;
const BRANCHES_NM: [f64; 2] = [410.0, 690.0];
/// The difference of two series is at least this multiple of the error of the finer one: once the
/// wavenumbers resolve the spectrum, the error falls faster than any power of their number.
const FASTER: f64 = 3.0;
/// The search for the greatest difference of two series starts at this number of points.
const CLIMBS: usize = 16;
/// The number of steps of each search.
const CLIMB: u32 = 40;
/// The greatest step of the logarithms of cosine and thickness, at the start and at the end.
const FARTHEST: f64 = 0.7;
const NEAREST: f64 = 1e-3;
/// One point in this number is compared with the reference; every point, if a medium is given by a table.
const SELDOM: usize = 9;

/// The coarsest series whose error is below the tolerance where films are hardest, and that error; if
/// there is none, the best one. The error is estimated by the difference from a series with two thirds
/// of the wavenumbers, and by the reference.
pub(super) fn converged(
    description: &FilmDescription,
    reference: &Reference,
    tolerance: f64,
) -> Result<(FringeSeries, f64), Error> {
    let points: Vec<_> = corners(description)
        .chain(points(description, POINTS))
        .chain(at_branches(description))
        .collect();
    let has_tables = !description.nodes_nm()?.is_empty();
    let stride = if has_tables { 1 } else { SELDOM };
    let seldom: Vec<_> = points.iter().step_by(stride).copied().collect();
    let mut truth: Option<Vec<Colors<f64>>> = None;
    let mut error_of = |found: &[Colors<f64>], before: &[Colors<f64>]| {
        let mut error = greatest(description, before, found) / FASTER;
        if error <= tolerance {
            let truth = truth.get_or_insert_with(|| {
                let exact = |&(side, c, d): &(Side, f64, f64)| {
                    Colors::from(reference.evaluate(side, c, &description.thicknesses(d)))
                };
                seldom.iter().map(exact).collect()
            });
            let same: Vec<_> = found.iter().step_by(stride).copied().collect();
            error = error.max(greatest(description, &same, truth));
        }
        error
    };
    let mut best = (
        FringeSeries::new(description, SEARCHES[0].1[0])?,
        f64::INFINITY,
    );
    for (is_graded, [least, most]) in SEARCHES {
        let series = |count| {
            let series = FringeSeries::new(description, count)?;
            Ok::<_, Error>(if is_graded { series.graded() } else { series })
        };
        // The lines of tables of measurements may be too narrow for equidistant wavenumbers, however many.
        let unresolved = |count| {
            if is_graded {
                Ok(0.0)
            } else {
                description.unresolved(count)
            }
        };
        if unresolved(most)? > tolerance {
            continue;
        }
        let mut count = least;
        let mut values = evaluated(&series(count)?, &points);
        while count < most {
            count += count / 2;
            let fine = series(count)?;
            let found = evaluated(&fine, &points);
            let mut error = error_of(&found, &values).max(unresolved(count)?);
            values = found;
            if error <= tolerance && !is_graded {
                error = error.max(behind_tunnels(description, &fine, tolerance));
            }
            if error < best.1 {
                best = (fine, error);
            }
            if error <= tolerance {
                return Ok(best);
            }
        }
    }
    Ok(best)
}

/// The greatest difference of a series and one with half as many wavenumbers again, at `count` points and
/// around those where it is greatest: resonances are ridges, and few points lie on top of one. The search
/// ends with the first difference that is not allowed.
pub(in crate::film) fn uncertainty(
    description: &FilmDescription,
    series: &FringeSeries,
    count: usize,
    allowed: f64,
) -> Result<f64, Error> {
    let unresolved = description.unresolved(series.len())?;
    if unresolved > allowed {
        return Ok(unresolved);
    }
    let fine = FringeSeries::new(description, series.len() + series.len() / 2)?;
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

fn evaluated(series: &FringeSeries, points: &[(Side, f64, f64)]) -> Vec<Colors<f64>> {
    let values = points.iter().map(|&(side, c, d)| series.at(side, c, d));
    values.collect()
}

fn greatest(description: &FilmDescription, found: &[Colors<f64>], expected: &[Colors<f64>]) -> f64 {
    let mut errors = Errors::default();
    for (found, expected) in found.iter().zip(expected) {
        errors.add(found.reflectance, expected.reflectance, true);
        if description.transmittance {
            errors.add(found.transmittance, expected.transmittance, true);
        }
    }
    errors.max
}

/// The greatest difference of a series and a graded one where light tunnels through a layer. The search ends with the
/// first difference that is not allowed.
fn behind_tunnels(description: &FilmDescription, series: &FringeSeries, allowed: f64) -> f64 {
    if description.layers.len() < 2 {
        return 0.0;
    }
    let graded = series.clone().graded();
    let [least, most] = measured_range(description);
    let mut error = 0.0f64;
    for &side in description.sides() {
        let near = description.near_and_far(side)[0].index(TUNNEL_NM).re;
        for layer in &description.layers {
            let ratio = layer.medium.index(TUNNEL_NM).re / near;
            let reach = TUNNEL_NM / (TAU * near * layer.thickness_nm[1]);
            for (i, decay) in DECAYS.into_iter().enumerate() {
                let squared = (1.0 - ratio) * (1.0 + ratio) - (decay * reach).powi(2);
                if squared <= 0.0 {
                    continue;
                }
                let thickness_nm = least + (0.569_840_291 * i as f64).fract() * (most - least);
                let point = [(side, squared.sqrt(), thickness_nm)];
                let [found, expected] = [series, &graded].map(|series| evaluated(series, &point));
                error = error.max(greatest(description, &found, &expected));
                if error > allowed {
                    return error;
                }
            }
        }
    }
    error
}

/// Points at the critical angles of `BRANCHES` wavelengths, if each has its own.
fn at_branches(description: &FilmDescription) -> Vec<(Side, f64, f64)> {
    if !description.disperses() || description.is_base_opaque() {
        return Vec::new();
    }
    let [least, greatest] = measured_range(description);
    let [first, last] = BRANCHES_NM.map(|nm| 1.0 / nm);
    let points = description.sides().iter().flat_map(|&side| {
        let [near, far] = description.near_and_far(side);
        (0..BRANCHES).filter_map(move |i| {
            let part = i as f64 / (BRANCHES - 1) as f64;
            let nm = 1.0 / (first + part * (last - first));
            let cosine = critical_cosine(near.index(nm).re, far.index(nm).re)?;
            let thickness_nm = least + (0.569_840_291 * i as f64).fract() * (greatest - least);
            Some((side, cosine, thickness_nm))
        })
    });
    points.collect()
}

/// The points of `COSINES`, `PARTS` and `SOME_NM`, from all sides.
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
