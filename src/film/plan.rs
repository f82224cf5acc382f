//! How a film is evaluated: the cheapest method that holds the tolerance.

use super::candidate::Candidate;
use super::compiled::{Compiled, Evaluator};
use super::converge::{converged, uncertainty};
use super::direct::{FresnelBase, OneLayerMethod, SchlickBase, SeriesMethod};
use super::fit::{Errors, Limits};
use super::points::{points, points_near_critical_angles};
use super::series::Series;
use super::sheets::{Sheet, Sheets};
use super::{FilmDescription, Kind, OneLayer};
use crate::error::Error;
use crate::num::Rgb;
use crate::optics::Reference;
use crate::optics::stack::Side;
use std::cell::OnceCell;

/// What was chosen, and what it was measured to do.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The method's name.
    pub method: &'static str,
    /// The error that was allowed.
    pub tolerance: f64,
    /// The greatest error of a channel found, at points that the method was not made from.
    pub measured_max: f64,
    /// The root of the mean square of the errors found.
    pub measured_rms: f64,
    /// Bytes of the tables.
    pub bytes: usize,
    /// One sentence.
    pub reason: String,
}

/// The most values of one table: 2 MiB.
const MOST_VALUES: usize = 1 << 17;
/// The most values times the nodes that each is a sum over: filling and measuring such a table takes some
/// 0.3 seconds, and several are tried.
const MOST_WORK: usize = 20_000_000;
/// The part of the tolerance that what tables are filled with may be off by.
const FILLING: f64 = 0.1;
/// The part of the tolerance that a method's error may have at the points where it is measured.
const MEASURED: f64 = 0.4;
/// That of the series, whose errors are narrow peaks.
const PEAKS: f64 = 0.05;
/// From so many nodes on a series is not refined: it would take as long as the reference.
const MOST_NODES: usize = 4000;
/// How many points those are, if the series is the truth for a thickness that varies, and else.
const POINTS: usize = 3000;
const SLOW_POINTS: usize = 60;
/// At how many points a series is compared with a finer one.
const MANY_POINTS: usize = 2000;
/// Tolerances from here on are always held: by the reference, if nothing else does.
const ALWAYS: f64 = 1e-4;

/// A method that was tried.
struct Attempt {
    compiled: Compiled,
    errors: Errors,
    bytes: usize,
    /// What it consists of.
    size: String,
}

/// What candidates are made of and measured with.
struct Workshop<'a> {
    description: &'a FilmDescription,
    reference: &'a Reference,
    limits: Limits,
    series: Series,
    /// Of the series, in the corners.
    series_error: f64,
    truth: OnceCell<Vec<(f64, f64, Rgb<f64>)>>,
}

/// Chooses and compiles.
pub(super) fn plan(
    description: &FilmDescription,
    reference: &Reference,
) -> Result<(Compiled, Plan), Error> {
    let tolerance = description.tolerance;
    let forced = description.method.as_deref();
    if let Some(name) = forced {
        Candidate::check(name, description)?;
    }
    let (series, series_error) = converged(description, reference, FILLING * tolerance)?;
    let workshop = Workshop {
        description,
        reference,
        limits: Limits {
            tolerance,
            unclipped: description.unclipped,
            size: MOST_VALUES.min(MOST_WORK / series.len()),
        },
        series,
        series_error,
        truth: OnceCell::new(),
    };
    let mut best: Option<(f64, String)> = None;
    for candidate in Candidate::by_cost(description, forced) {
        let Some(attempt) = workshop.attempt(candidate)? else {
            continue;
        };
        let max = attempt.errors.max;
        let allowed = match candidate {
            Candidate::Reference if tolerance >= ALWAYS => f64::INFINITY,
            Candidate::OneLayer(_) => MEASURED * tolerance,
            Candidate::Series => PEAKS * tolerance,
            _ => tolerance,
        };
        if max <= allowed {
            let plan = Plan {
                method: candidate.name(),
                tolerance,
                measured_max: max,
                measured_rms: attempt.errors.rms(),
                bytes: attempt.bytes,
                reason: reason(&attempt.size, candidate, forced.is_some()),
            };
            return Ok((attempt.compiled, plan));
        }
        if best.as_ref().is_none_or(|(least, _)| max < *least) {
            best = Some((max, attempt.size));
        }
    }
    let name = forced.unwrap_or("reference");
    let found = best.map_or(
        "no table that is small enough does".to_owned(),
        |(max, size)| format!("the best it can do is {max:.2e}, with {size}"),
    );
    Err(Error::unsupported(format!(
        "method '{name}' cannot hold tolerance = {tolerance:.2e} (errors found may have a part of it): {found}"
    )))
}

fn reason(size: &str, candidate: Candidate, forced: bool) -> String {
    let why = match candidate {
        _ if forced => "asked for by name, and it holds the tolerance",
        Candidate::Reference => "no faster method holds the tolerance",
        Candidate::Schlick => "nothing is coated, and no cheaper method exists",
        Candidate::Fresnel => "nothing is coated, and Fresnel's equations are exact",
        _ => "the cheapest method that holds the tolerance",
    };
    format!("{size}: {why}")
}

impl Workshop<'_> {
    /// Compiles and measures a candidate; none if it does not suit the film.
    fn attempt(&self, candidate: Candidate) -> Result<Option<Attempt>, Error> {
        match candidate {
            Candidate::Schlick => {
                let thicknesses = self.description.thicknesses(0.0);
                let found = self.reference.evaluate(Side::Ambient, 1.0, &thicknesses);
                let f0 = found.reflectance.map(|x| x as f32);
                Ok(Some(self.measured(
                    Box::new(SchlickBase(f0)),
                    "three numbers".into(),
                )))
            }
            Candidate::Fresnel => {
                let [ambient, base] = [&self.description.ambient, &self.description.base]
                    .map(|medium| medium.index(550.0).re);
                let eta = (base / ambient) as f32;
                let size = format!("relative index {eta}");
                Ok(Some(self.measured(Box::new(FresnelBase { eta }), size)))
            }
            Candidate::Table => self.table(),
            Candidate::OneLayer(kind) => self.one_layer(kind).map(Some),
            Candidate::Series => self.series().map(Some),
            Candidate::Reference => Ok(Some(self.reference())),
        }
    }

    fn table(&self) -> Result<Option<Attempt>, Error> {
        if self.series_error > FILLING * self.limits.tolerance {
            return Ok(None);
        }
        let fitted = Sheets::fit(self.description, &self.series, self.limits)?;
        Ok(fitted.map(|(sheets, errors)| {
            let (bytes, size) = (sheets.bytes(), sheets.size());
            let sheets = Box::new(sheets);
            let compiled = if self.description.transmittance {
                Compiled::Other(sheets)
            } else {
                match sheets.into_simple() {
                    Ok(Sheet::Table(table)) => Compiled::Table(table),
                    Ok(Sheet::Curve(curve)) => Compiled::Curve(curve),
                    Err(sheets) => Compiled::Other(sheets),
                }
            };
            Attempt {
                compiled,
                errors,
                bytes,
                size,
            }
        }))
    }

    fn one_layer(&self, kind: Kind) -> Result<Attempt, Error> {
        let description = self.description;
        let layer = OneLayer::new(
            description.ambient.clone(),
            description.layers[0].medium.clone(),
            description.base.clone(),
            description.white,
            description.color_space,
        )?;
        let method = OneLayerMethod::new(description, &layer, kind)?;
        Ok(self.measured(Box::new(method), kind.cost()))
    }

    /// With at least twice the nodes of the table's, as nothing smooths what is wrong at single points.
    fn series(&self) -> Result<Attempt, Error> {
        let description = self.description;
        let allowed = PEAKS * self.limits.tolerance;
        let mut nodes = self.series.len();
        let (series, uncertainty) = loop {
            nodes *= 2;
            let series = Series::new(description, nodes)?;
            // Narrow resonances hide between the few points at which there is time for the reference.
            let uncertainty = uncertainty(description, &series, MANY_POINTS, allowed)?;
            if uncertainty <= allowed || nodes >= MOST_NODES {
                break (series, uncertainty);
            }
        };
        let (bytes, nodes) = (series.bytes(), series.len());
        let method = SeriesMethod(series);
        let mut errors = Errors::default();
        let count = if uncertainty > allowed {
            0
        } else {
            SLOW_POINTS
        };
        for (side, c, d) in points(description, count) {
            let found = method.colors(side, c as f32, d as f32);
            let truth = self
                .reference
                .evaluate(side, c, &description.thicknesses(d));
            let unclipped = self.limits.unclipped;
            let wide = |rgb: Rgb<f32>| rgb.map(f64::from);
            errors.add(wide(found.reflectance), truth.reflectance, unclipped);
            if description.transmittance {
                errors.add(wide(found.transmittance), truth.transmittance, unclipped);
            }
        }
        errors.max = errors.max.max(uncertainty);
        Ok(Attempt {
            compiled: Compiled::Other(Box::new(method)),
            errors,
            bytes,
            size: format!("all harmonics at {nodes} wavelengths"),
        })
    }

    fn reference(&self) -> Attempt {
        let mut errors = Errors::default();
        for (side, c, d) in points(self.description, 3) {
            let thicknesses = self.description.thicknesses(d);
            let change = self.reference.evaluate(side, c, &thicknesses).change;
            errors.add([change; 3], [0.0; 3], true);
        }
        Attempt {
            compiled: Compiled::Reference,
            errors,
            bytes: 0,
            size: "converged wave optics".into(),
        }
    }

    /// An evaluator of the reflectance from the ambient's side.
    fn measured(&self, evaluator: Box<dyn Evaluator>, size: String) -> Attempt {
        let mut errors = Errors::default();
        for &(c, d, truth) in self.truth() {
            let found = evaluator.reflectance(c as f32, d as f32).map(f64::from);
            errors.add(found, truth, self.limits.unclipped);
        }
        Attempt {
            compiled: Compiled::Other(evaluator),
            errors,
            bytes: 0,
            size,
        }
    }

    /// Cosines, thicknesses and what they reflect to the ambient's side.
    fn truth(&self) -> &[(f64, f64, Rgb<f64>)] {
        self.truth.get_or_init(|| {
            let is_fast = self.series_error <= FILLING * self.limits.tolerance;
            let varies = self.description.varying().is_some();
            let count = if is_fast && varies {
                POINTS
            } else {
                SLOW_POINTS
            };
            // No transmittance is asked for where this is: all points are on the ambient's side.
            let scattered = points(self.description, count).into_iter();
            let mut all: Vec<_> = scattered.map(|(_, c, d)| (c, d)).collect();
            all.extend(points_near_critical_angles(self.description));
            let found = all.into_iter().map(|(c, d)| {
                let found = if is_fast {
                    self.series.at(Side::Ambient, c, d).reflectance
                } else {
                    let thicknesses = self.description.thicknesses(d);
                    let found = self.reference.evaluate(Side::Ambient, c, &thicknesses);
                    found.reflectance
                };
                (c, d, found)
            });
            found.collect()
        })
    }
}
