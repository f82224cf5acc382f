//! How many nodes a [`Series`] needs.

use super::FilmDescription;
use super::fit::Errors;
use super::plan::THICK_NM;
use super::series::Series;
use crate::error::Error;
use crate::optics::Reference;
use crate::optics::stack::Side;

/// The numbers of nodes grow by half.
const LEAST_NODES: usize = 32;
const MOST_NODES: usize = 1600;
/// Where the series is compared with the reference: cosines; thicknesses as parts of the range; and
/// those, nm, between which fringes are many and not yet faded.
const COSINES: [f64; 6] = [1.0, 0.62, 0.27, 0.085, 0.021, 0.0037];
const PARTS: [f64; 4] = [1.0, 0.0, 0.37, 0.029];
const FRINGED_NM: [f64; 6] = [640.0, 1800.0, 3100.0, 4300.0, 7500.0, 12_000.0];

/// The series with the fewest nodes whose error is at most so large where films are hardest, and that
/// error; if there is none, the best there is.
pub(super) fn converged(
    description: &FilmDescription,
    reference: &Reference,
    tolerance: f64,
) -> Result<(Series, f64), Error> {
    let [least, greatest] = description
        .varying()
        .map_or([0.0; 2], |layer| description.layers[layer].thickness_nm);
    let greatest = greatest.min(least.max(THICK_NM));
    let parts = PARTS.map(|part| least + part * (greatest - least));
    let mut thicknesses: Vec<f64> = parts.into_iter().chain(FRINGED_NM).collect();
    thicknesses.retain(|d| (least..=greatest).contains(d));
    thicknesses.dedup();
    let mut sides = vec![Side::Ambient];
    if description.transmittance && !description.base.absorbs() {
        sides.push(Side::Base);
    }
    let mut points = Vec::new();
    for cos_theta in COSINES {
        for &thickness in &thicknesses {
            for &side in &sides {
                points.push((side, cos_theta, thickness));
            }
        }
    }
    let truth: Vec<_> = points
        .iter()
        .map(|&(side, c, d)| reference.evaluate(side, c, &description.thicknesses(d)))
        .collect();
    let mut best: Option<(Series, f64)> = None;
    let mut nodes = LEAST_NODES;
    loop {
        let series = Series::new(description, nodes)?;
        let mut errors = Errors::default();
        for (&(side, c, d), truth) in points.iter().zip(&truth) {
            let found = series.at(side, c, d);
            errors.add(found.reflectance, truth.reflectance, true);
            if description.transmittance {
                errors.add(found.transmittance, truth.transmittance, true);
            }
            if errors.max > tolerance && best.as_ref().is_some_and(|(_, max)| *max < errors.max) {
                break;
            }
        }
        if best.as_ref().is_none_or(|(_, max)| errors.max < *max) {
            best = Some((series, errors.max));
        }
        match best {
            Some((_, max)) if max > tolerance && nodes < MOST_NODES => nodes += nodes / 2,
            Some(best) => return Ok(best),
            None => nodes += nodes / 2,
        }
    }
}
