//! What a run says about the promise that films keep their tolerance.

use super::comparison::{FALLBACK, Outcome, REFUSED};
use super::kind::Kind;

/// A tolerance, and the greatest share of films that may fall back to the reference at it.
#[derive(Clone, Copy, Debug)]
pub struct Promise {
    pub tolerance: f64,
    pub greatest_fallback: f64,
}

pub const PROMISES: [Promise; 3] = [
    Promise::new(1e-2, 0.02),
    Promise::new(2e-3, 0.10),
    Promise::new(2e-4, 0.30),
];

impl Promise {
    pub const fn new(tolerance: f64, greatest_fallback: f64) -> Self {
        Self {
            tolerance,
            greatest_fallback,
        }
    }
}

/// The films of one tolerance.
pub struct Summary<'a> {
    pub promise: Promise,
    pub films: Vec<&'a Outcome>,
}

impl<'a> Summary<'a> {
    pub fn new(promise: Promise, outcomes: impl Iterator<Item = &'a Outcome>) -> Self {
        let films = outcomes.filter(|outcome| outcome.tolerance == promise.tolerance);
        Self {
            promise,
            films: films.collect(),
        }
    }

    pub fn points(&self) -> usize {
        self.films.iter().map(|film| film.points).sum()
    }

    pub fn exceptions(&self) -> usize {
        self.films.iter().map(|film| film.exceptions).sum()
    }

    pub fn broken_films(&self) -> usize {
        self.films.iter().filter(|film| film.exceptions > 0).count()
    }

    /// The share of films that the reference evaluates or that are refused.
    pub fn fallback_share(&self) -> f64 {
        let is_fallback = |film: &&&Outcome| [FALLBACK, REFUSED].contains(&film.method.as_str());
        let fallbacks = self.films.iter().filter(is_fallback);
        fallbacks.count() as f64 / self.films.len().max(1) as f64
    }

    /// The number of films of each method among those of a kind, checked from both sides or not.
    pub fn methods(&self, kind: Kind, both_sides: bool) -> Vec<(&'a str, usize)> {
        let mut counts: Vec<(&str, usize)> = Vec::new();
        for film in self.of(kind, both_sides) {
            match counts.iter_mut().find(|(method, _)| *method == film.method) {
                Some((_, count)) => *count += 1,
                None => counts.push((&film.method, 1)),
            }
        }
        counts.sort_by_key(|(method, count)| (std::cmp::Reverse(*count), *method));
        counts
    }

    fn of(&self, kind: Kind, both_sides: bool) -> impl Iterator<Item = &&'a Outcome> {
        let films = self.films.iter();
        films.filter(move |film| film.kind == kind && film.both_sides == both_sides)
    }

    /// A number of each film, ascending.
    pub fn sorted(&self, of: impl Fn(&Outcome) -> f64) -> Vec<f64> {
        let mut numbers: Vec<f64> = self.films.iter().map(|film| of(film)).collect();
        numbers.sort_by(f64::total_cmp);
        numbers
    }

    /// The films that came closest to their tolerance or went beyond, the worst first.
    pub fn worst(&self) -> Vec<&'a Outcome> {
        let mut films = self.films.clone();
        films.sort_by(|a, b| b.ratio().total_cmp(&a.ratio()));
        films
    }

    /// A sentence for each part of the promise that is broken.
    pub fn failures(&self) -> Vec<String> {
        let mut failures = Vec::new();
        let Promise {
            tolerance,
            greatest_fallback,
        } = self.promise;
        if self.exceptions() > 0 {
            failures.push(format!(
                "tolerance {tolerance:e}: {} of {} films exceed it, at {} points",
                self.broken_films(),
                self.films.len(),
                self.exceptions()
            ));
        }
        let share = self.fallback_share();
        if share > greatest_fallback {
            failures.push(format!(
                "tolerance {tolerance:e}: {:.1} % of the films fall back to {FALLBACK} or are refused, more than \
                 {:.0} %",
                100.0 * share,
                100.0 * greatest_fallback
            ));
        }
        failures
    }
}

/// The number below which that part of ascending numbers lies; 0 if there are none.
pub fn quantile(ascending: &[f64], part: f64) -> f64 {
    let last = ascending.len().saturating_sub(1);
    let at = (part * last as f64).round() as usize;
    ascending.get(at).copied().unwrap_or(0.0)
}
