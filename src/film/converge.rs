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
/// some, nm, where thin metals resonate and where fringes are many and not yet faded.
const COSINES: [f64; 7] = [1.0, 0.62, 0.27, 0.085, 0.021, 0.0037, 0.0008];
const PARTS: [f64; 4] = [1.0, 0.0, 0.37, 0.029];
/// And the wavelengths whose critical angles are among the angles.
const CRITICAL_NM: [f64; 3] = [430.0, 550.0, 680.0];
const SOME_NM: [f64; 9] = [
    5.3, 24.0, 110.0, 640.0, 1800.0, 3100.0, 4300.0, 7500.0, 12_000.0,
];

/// The series with half as many nodes again as bring the error below this where films are hardest, and
/// that error; if none does, the best there is.
pub(super) fn converged(
    description: &FilmDescription,
    reference: &Reference,
    tolerance: f64,
) -> Result<(Series, f64), Error> {
    let [least, greatest] = description.varying_range();
    let greatest = greatest.min(least.max(THICK_NM));
    let parts = PARTS.map(|part| least + part * (greatest - least));
    let mut thicknesses: Vec<f64> = parts.into_iter().chain(SOME_NM).collect();
    thicknesses.retain(|d| (least..=greatest).contains(d));
    thicknesses.dedup();
    let mut points = Vec::new();
    for &side in description.sides() {
        let cosines = COSINES
            .into_iter()
            .chain(critical_cosines(description, side));
        for cos_theta in cosines {
            points.extend(thicknesses.iter().map(|&d| (side, cos_theta, d)));
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
            Some((series, max)) => {
                let nodes = series.len() + series.len() / 2;
                return Ok((Series::new(description, nodes)?, max));
            }
            None => nodes += nodes / 2,
        }
    }
}

/// The cosines at which light from a side begins to go along a layer or the far half-space whose index
/// disperses, at some wavelengths: there the spectrum has a root in it.
pub(super) fn critical_cosines(description: &FilmDescription, side: Side) -> Vec<f64> {
    let (near, far) = match side {
        Side::Ambient => (&description.ambient, &description.base),
        Side::Base => (&description.base, &description.ambient),
    };
    let layers = description.layers.iter().map(|layer| &layer.medium);
    let mut cosines = Vec::new();
    for medium in layers.chain(std::iter::once(far)) {
        if medium.constant().is_some() && near.constant().is_some() {
            continue;
        }
        for wavelength_nm in CRITICAL_NM {
            let ratio = medium.index(wavelength_nm).re / near.index(wavelength_nm).re;
            if ratio < 1.0 {
                cosines.push((1.0 - ratio * ratio).sqrt());
            }
        }
    }
    cosines
}
