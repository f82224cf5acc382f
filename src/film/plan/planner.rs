//! The film that methods are compiled for, and the exact colours that they are measured against.

use super::converge::converged;
use super::points::{points, points_near_critical_angles};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::film::evaluator::{Evaluator, MethodEvaluator};
use crate::film::fringe_series::series::FringeSeries;
use crate::film::table::errors::Errors;
use crate::film::table::task::FitLimits;
use crate::num::Rgb;
use crate::optics::Reference;
use crate::optics::stack::Side;
use std::cell::OnceCell;

/// The greatest number of values of one table: 2 MiB.
const MOST_VALUES: usize = 1 << 17;
/// The greatest product of a table's values and the wavenumbers that each is a sum over: filling and
/// measuring such a table takes some 0.3 seconds, and several are tried.
const MOST_WORK: usize = 20_000_000;
/// The part of the tolerance that the series may be off by where tables are filled with it.
const FILLING: f64 = 0.15;
/// The number of points at which a method is measured against the series, and against the reference.
const POINTS: usize = 3000;
pub(in crate::film) const SLOW_POINTS: usize = 60;

/// The description of a film, and the series and the reference that methods are filled from and compared
/// with.
pub(in crate::film) struct Planner<'a> {
    pub description: &'a FilmDescription,
    pub reference: &'a Reference,
    pub limits: FitLimits,
    pub series: FringeSeries,
    /// The error of the series where films are hardest.
    series_error: f64,
    /// Cosines, thicknesses and exact reflectances on the ambient's side.
    truth: OnceCell<Vec<(f64, f64, Rgb<f64>)>>,
}

/// A method compiled and measured.
pub(in crate::film) struct Candidate {
    pub evaluator: Evaluator,
    /// On the ambient's side and on the base's.
    pub errors: [Errors; 2],
    /// Bytes of the tables.
    pub bytes: usize,
    /// The size of the method, in words.
    pub size: String,
}

impl Candidate {
    /// The greatest error.
    pub(in crate::film) fn max(&self) -> f64 {
        self.errors[0].max.max(self.errors[1].max)
    }

    /// The root of the mean square of all errors.
    pub(in crate::film) fn rms(&self) -> f64 {
        let mut all = self.errors[0];
        all.merge(&self.errors[1]);
        all.rms()
    }
}

impl<'a> Planner<'a> {
    /// Fails if there is no memory.
    pub(super) fn new(
        description: &'a FilmDescription,
        reference: &'a Reference,
    ) -> Result<Self, Error> {
        let tolerance = description.tolerance;
        let (series, series_error) = converged(description, reference, FILLING * tolerance)?;
        Ok(Self {
            description,
            reference,
            limits: FitLimits {
                tolerance,
                unclipped: description.unclipped,
                size: MOST_VALUES.min(MOST_WORK / series.len()),
            },
            series,
            series_error,
            truth: OnceCell::new(),
        })
    }

    /// Whether the series is exact enough to fill tables with.
    pub(in crate::film) fn is_series_exact(&self) -> bool {
        self.series_error <= FILLING * self.limits.tolerance
    }

    /// Measures a method against the reflectance from the ambient's side.
    pub(in crate::film) fn measured(&self, method: MethodEvaluator, size: String) -> Candidate {
        let mut errors = Errors::default();
        for &(c, d, truth) in self.truth() {
            let found = method
                .compiled
                .reflectance(c as f32, d as f32)
                .map(f64::from);
            errors.add(found, truth, self.limits.unclipped);
        }
        Candidate {
            evaluator: Evaluator::Method(method),
            errors: [errors, Errors::default()],
            bytes: 0,
            size,
        }
    }

    fn truth(&self) -> &[(f64, f64, Rgb<f64>)] {
        self.truth.get_or_init(|| {
            let is_fast = self.is_series_exact();
            let varies = self.description.varying().is_some();
            let count = if is_fast && varies {
                POINTS
            } else {
                SLOW_POINTS
            };
            // Methods that are measured here take no film with transmittance, so that all points are on
            // the ambient's side.
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
