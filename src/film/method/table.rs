//! Tables: splines over cosine and thickness, filled with the series.

use super::info::{Compile, MethodInfo};
use crate::film::evaluator::Evaluator;
use crate::film::plan::planner::Candidate;
use crate::film::table::two_sided::TwoSidedTables;

/// Splines over cosine and thickness.
pub(super) const INFO: MethodInfo = MethodInfo {
    name: "table",
    sizes: &[1],
    cost_ns: |_| 13.0,
    is_automatic: true,
    takes: |_| true,
    takes_words: "any film",
    allowed_error: |tolerance| tolerance,
    reason: "the cheapest method that holds the tolerance",
    compile: Compile::Film(|planner| {
        if !planner.is_series_exact() {
            return Ok(None);
        }
        let fitted = TwoSidedTables::fit(planner.description, &planner.series, planner.limits)?;
        Ok(fitted.map(|(tables, errors)| Candidate {
            errors,
            bytes: tables.bytes(),
            size: tables.size(),
            evaluator: Evaluator::Tables(tables),
        }))
    }),
};
