//! The choice of a method.

use super::film_plan::{FilmPlan, SidePlan};
use super::planner::{Candidate, Planner};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::film::evaluator::Evaluator;
use crate::film::method::info::MethodInfo;
use crate::film::method::registry::{ALL, METHODS};
use crate::optics::Reference;
use crate::optics::stack::Side;

/// Chooses and compiles the cheapest method whose measured error is allowed, or the cheapest size of the
/// method that the description forces.
pub(in crate::film) fn plan(
    description: &FilmDescription,
    reference: &Reference,
) -> Result<(Evaluator, FilmPlan), Error> {
    let tolerance = description.tolerance;
    let forced = description.method.as_deref();
    if let Some(name) = forced {
        check_forced(name, description)?;
    }
    let planner = Planner::new(description, reference)?;
    let mut best: Option<Candidate> = None;
    for (method, size) in by_cost(description, forced) {
        let Some(candidate) = method.compile(&planner, size)? else {
            continue;
        };
        let max = candidate.max();
        if max <= (method.allowed_error)(tolerance) {
            let cost_ns = [Side::Ambient, Side::Base].map(|side| {
                let of_tables = candidate.evaluator.cost_ns(side, description.transmittance);
                of_tables.unwrap_or_else(|| (method.cost_ns)(size))
            });
            let (series, errors) = (&planner.series, &candidate.errors);
            let plan = FilmPlan {
                method: method.name,
                tolerance,
                measured_max: max,
                measured_rms: candidate.rms(),
                bytes: candidate.bytes,
                reason: reason(&candidate.size, method, forced.is_some()),
                sides: SidePlan::both(description, series, method.name, errors, cost_ns),
                eta: FilmPlan::eta_of(description),
            };
            return Ok((candidate.evaluator, plan));
        }
        if best.as_ref().is_none_or(|best| max < best.max()) {
            best = Some(candidate);
        }
    }
    let name = forced.unwrap_or("reference");
    let found = best.map_or("no table that is small enough does".to_owned(), |best| {
        let (max, size) = (best.max(), best.size);
        format!("the best it can do is {max:.2e}, with {size}")
    });
    Err(Error::unsupported(format!(
        "method '{name}' cannot hold tolerance = {tolerance:.2e} (errors found may have a part of it): {found}"
    )))
}

/// The methods that take a film, or only the forced one, in their sizes, the cheapest first.
fn by_cost(
    description: &FilmDescription,
    forced: Option<&str>,
) -> Vec<(&'static MethodInfo, usize)> {
    let is_candidate = |method: &&MethodInfo| {
        (method.takes)(description)
            && forced.map_or(method.is_automatic, |name| method.name == name)
    };
    let mut candidates: Vec<_> = ALL
        .into_iter()
        .filter(is_candidate)
        .flat_map(|method| method.sizes.iter().map(move |size| (method, *size)))
        .collect();
    candidates.sort_by(|a, b| (a.0.cost_ns)(a.1).total_cmp(&(b.0.cost_ns)(b.1)));
    candidates
}

/// Refuses a name that does not exist, and a method that does not take the film.
fn check_forced(name: &str, description: &FilmDescription) -> Result<(), Error> {
    let Some(method) = ALL.iter().find(|method| method.name == name) else {
        return Err(Error::unknown("method", name, METHODS.into_iter()));
    };
    if (method.takes)(description) {
        return Ok(());
    }
    let takes = method.takes_words;
    Err(Error::unsupported(format!("method '{name}' takes {takes}")))
}

fn reason(size: &str, method: &MethodInfo, is_forced: bool) -> String {
    let why = if is_forced {
        "asked for by name, and it holds the tolerance"
    } else {
        method.reason
    };
    format!("{size}: {why}")
}
