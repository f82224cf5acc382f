//! What a film's plan tells.

use super::points::points;
use crate::film::description::FilmDescription;
use crate::film::fringe_series::series::FringeSeries;
use crate::film::table::errors::Errors;
use crate::optics::stack::Side;

/// The number of points at which the light that layers absorb is looked at.
const ABSORBED_AT: usize = 120;
/// The wavelength whose index directions follow, nm: about that of the eye's greatest sensitivity.
pub const DIRECTION_NM: f64 = 550.0;

/// The chosen method of a film, and its measured errors.
#[derive(Clone, Debug)]
pub struct FilmPlan {
    /// The method's name, one of [`METHODS`](crate::film::METHODS).
    pub method: &'static str,
    /// The error that was allowed.
    pub tolerance: f64,
    /// The greatest error of a channel found, at points that the method was not made from.
    pub measured_max: f64,
    /// The root of the mean square of the errors found.
    pub measured_rms: f64,
    /// Bytes of the tables.
    pub bytes: usize,
    /// Why the method was chosen, in one sentence.
    pub reason: String,
    /// The same for each side, [`Side::Ambient`] first; `None` for a side that the film gives no light from.
    pub sides: [Option<SidePlan>; 2],
    /// The indices of ambient and base, real parts, at [`DIRECTION_NM`]: directions of refraction follow them.
    pub eta: [f64; 2],
}

/// How light from one side is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SidePlan {
    /// The method's name, one of [`METHODS`](crate::film::METHODS).
    pub method: &'static str,
    /// The greatest error of a channel found on this side.
    pub measured_max: f64,
    /// The root of the mean square of the errors found on this side.
    pub measured_rms: f64,
    /// Estimated time of one call, ns, on one core of a 2024 server that does nothing else: of [`Film::colors`] if the
    /// film keeps its transmittance, of [`Film::reflectance`] if not.
    ///
    /// [`Film::colors`]: crate::film::Film::colors
    /// [`Film::reflectance`]: crate::film::Film::reflectance
    pub cost_ns: f64,
    /// The greatest part of the light that the layers absorb, of a channel, at the points looked at; 0 if no layer
    /// absorbs. What enters a base that absorbs counts as transmitted.
    pub absorbed_max: f64,
}

impl FilmPlan {
    /// [`FilmPlan::eta`] of a film.
    pub(in crate::film) fn eta_of(description: &FilmDescription) -> [f64; 2] {
        let half_spaces = [&description.ambient, &description.base];
        half_spaces.map(|medium| medium.index(DIRECTION_NM).re)
    }
}

impl SidePlan {
    /// The plans of both sides of a film.
    pub(super) fn both(
        description: &FilmDescription,
        series: &FringeSeries,
        method: &'static str,
        errors: &[Errors; 2],
        cost_ns: [f64; 2],
    ) -> [Option<Self>; 2] {
        let absorbed_max = absorbed_max(description, series);
        [Side::Ambient, Side::Base].map(|side| {
            let i = side as usize;
            description.sides().contains(&side).then(|| Self {
                method,
                measured_max: errors[i].max,
                measured_rms: errors[i].rms(),
                cost_ns: cost_ns[i],
                absorbed_max: absorbed_max[i],
            })
        })
    }
}

/// The greatest part of the light of a channel that the layers absorb, for each side.
fn absorbed_max(description: &FilmDescription, series: &FringeSeries) -> [f64; 2] {
    let mut greatest = [0.0f64; 2];
    let mut layers = description.layers.iter();
    if !layers.any(|layer| layer.medium.absorbs()) {
        return greatest;
    }
    for (side, c, d) in points(description, ABSORBED_AT) {
        let colors = series.at(side, c, d);
        for (r, t) in colors.reflectance.into_iter().zip(colors.transmittance) {
            let absorbed = (1.0 - r - t).clamp(0.0, 1.0);
            greatest[side as usize] = greatest[side as usize].max(absorbed);
        }
    }
    greatest
}
