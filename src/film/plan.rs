//! How a film is evaluated: the cheapest method that holds the tolerance.

use super::candidate::Candidate;
use super::compiled::{Compiled, Evaluator};
use super::converge::{converged, critical_cosines};
use super::direct::{FresnelBase, OneLayerMethod, SchlickBase, SeriesMethod};
use super::fit::{Errors, Limits};
use super::series::Series;
use super::sheets::{Sheet, Sheets};
use super::{FilmDescription, Kind, OneLayer};
use crate::error::Error;
use crate::math::Rgb;
use crate::optics::Reference;
use crate::optics::stack::Side;
use std::cell::OnceCell;
use std::ffi::{CStr, CString};

/// What was chosen, and what it was measured to do.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The method's name.
    pub method: &'static CStr,
    /// The error that was allowed.
    pub tolerance: f64,
    /// The greatest error of a channel found, at points that the method was not made from.
    pub measured_max: f64,
    /// The root of the mean square of the errors found.
    pub measured_rms: f64,
    /// Bytes of the tables.
    pub bytes: usize,
    /// One sentence.
    pub reason: CString,
}

/// The most values of one table: 2 MiB.
const MOST_VALUES: usize = 1 << 17;
/// The part of the tolerance that what tables are filled with may be off by.
const FILLING: f64 = 0.1;
/// The part of the tolerance that a method's error may have at the points where it is measured.
const MEASURED: f64 = 0.4;
/// How many points those are, if the series is the truth for a thickness that varies, and else.
const POINTS: usize = 500;
const SLOW_POINTS: usize = 120;
/// Tolerances from here on are always held: by the reference, if nothing else does.
const ALWAYS: f64 = 1e-4;

/// Films that vary beyond this are measured up to it, nm: thicker ones show no colours, and take the
/// reference long.
pub(super) const THICK_NM: f64 = 3e5;

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
            size: MOST_VALUES,
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
            Candidate::OneLayer(_) | Candidate::Series => MEASURED * tolerance,
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
    let found = best.map_or("no table of 2 MiB does".to_owned(), |(max, size)| {
        format!("the best it can do is {max:.2e}, with {size}")
    });
    Err(Error::unsupported(format!(
        "method '{name}' cannot hold tolerance = {tolerance:.2e} (errors found may have a part of it): {found}"
    )))
}

fn reason(size: &str, candidate: Candidate, forced: bool) -> CString {
    let why = match candidate {
        _ if forced => "asked for by name, and it holds the tolerance",
        Candidate::Reference => "no faster method holds the tolerance",
        Candidate::Schlick => "nothing is coated, and no cheaper method exists",
        Candidate::Fresnel => "nothing is coated, and Fresnel's equations are exact",
        _ => "the cheapest method that holds the tolerance",
    };
    CString::new(format!("{size}: {why}")).unwrap_or_default()
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
            let simple = sheets.simple().filter(|_| !self.description.transmittance);
            let compiled = match simple {
                Some(Sheet::Table(table)) => Compiled::Table(table.clone()),
                Some(Sheet::Curve(curve)) => Compiled::Curve(curve.clone()),
                None => Compiled::Other(Box::new(sheets)),
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

    /// With twice the nodes, as nothing smooths what is wrong at single points.
    fn series(&self) -> Result<Attempt, Error> {
        let series = Series::new(self.description, 2 * self.series.len())?;
        let (bytes, nodes) = (series.bytes(), series.len());
        let method = SeriesMethod(series);
        // Against the reference, or it would be measured with itself.
        let mut errors = Errors::default();
        for (side, c, d) in self.points(SLOW_POINTS) {
            let found = method.colors(side, c as f32, d as f32);
            let truth = self
                .reference
                .evaluate(side, c, &self.description.thicknesses(d));
            let unclipped = self.limits.unclipped;
            errors.add(
                found.reflectance.map(f64::from),
                truth.reflectance,
                unclipped,
            );
            if self.description.transmittance {
                errors.add(
                    found.transmittance.map(f64::from),
                    truth.transmittance,
                    unclipped,
                );
            }
        }
        // What is off in the corners is so at worse points too.
        errors.max = errors.max.max(2.0 * self.series_error);
        Ok(Attempt {
            compiled: Compiled::Other(Box::new(method)),
            errors,
            bytes,
            size: format!("all harmonics at {nodes} wavelengths"),
        })
    }

    fn reference(&self) -> Attempt {
        let mut errors = Errors::default();
        for (side, c, d) in self.points(6) {
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
            let points = self.points(count).map(|(_, c, d)| {
                let found = if is_fast {
                    self.series.at(Side::Ambient, c, d).reflectance
                } else {
                    let thicknesses = self.description.thicknesses(d);
                    let found = self.reference.evaluate(Side::Ambient, c, &thicknesses);
                    found.reflectance
                };
                (c, d, found)
            });
            points.collect()
        })
    }

    /// Points over cosine and thickness: a third evenly, a third towards grazing angles, a third towards
    /// both grazing angles and thin films, by the R2 sequence (Roberts 2018). From both sides by turns,
    /// if both are asked for. And about critical angles.
    fn points(&self, count: usize) -> impl Iterator<Item = (Side, f64, f64)> {
        let [least, greatest] = self.description.varying_range();
        let greatest = greatest.min(least.max(THICK_NM));
        let sides = self.description.sides();
        let critical = critical_points(self.description, least, greatest);
        (0..count)
            .map(move |i| {
                let fraction = |step: f64| (0.5 + step * i as f64).fract();
                let (u, v) = (fraction(0.754_877_666), fraction(0.569_840_291));
                let cos_theta = if i % 3 == 0 { u } else { u.powi(3).max(1e-4) };
                let part = if i % 3 == 2 { v.powi(3) } else { v };
                let side = sides[i % sides.len()];
                (side, cos_theta, least + part * (greatest - least))
            })
            .chain(critical)
    }
}

/// Points about the cosines where the spectrum has a root in it.
fn critical_points(
    description: &FilmDescription,
    least: f64,
    greatest: f64,
) -> Vec<(Side, f64, f64)> {
    let mut points = Vec::new();
    for &side in description.sides() {
        for cosine in critical_cosines(description, side) {
            for step in [-0.004, -0.001, 0.0, 0.001, 0.004] {
                for part in [0.07, 0.5, 1.0] {
                    let thickness = least + part * (greatest - least);
                    points.push((side, (cosine + step).clamp(0.0, 1.0), thickness));
                }
            }
        }
    }
    points
}
