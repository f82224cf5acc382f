//! The compiled form of a film.

use super::fringe_series::series::FringeSeries;
use super::method::compiled_method::{CompiledMethod, Ingredients};
use super::table::two_sided::TwoSidedTables;
use crate::optics::stack::Side;

/// Times of a call without its look-ups, ns: of the reflectance, and of reflectance and transmittance.
const REFLECTANCE_NS: f64 = 3.0;
const BOTH_NS: f64 = 13.0;

/// The compiled form of a film, by the chosen method.
pub(super) enum Evaluator {
    /// Tables, which most films have. They are looked up without a virtual call, and in lanes.
    Tables(TwoSidedTables),
    /// A method that knows the reflectance from the ambient's side alone.
    Method(MethodEvaluator),
    /// The series is summed at every call.
    Series(FringeSeries),
    /// The reference is evaluated at every call.
    Reference,
}

impl Evaluator {
    /// Estimated time of a call from a side, ns, where it depends on what has been fitted; `has_both`: of reflectance and
    /// transmittance.
    pub(super) fn cost_ns(&self, side: Side, has_both: bool) -> Option<f64> {
        match self {
            Self::Tables(tables) => {
                let call = if has_both { BOTH_NS } else { REFLECTANCE_NS };
                Some(call + tables.cost_ns(side))
            }
            Self::Series(series) => Some(series.cost_ns()),
            Self::Method(_) | Self::Reference => None,
        }
    }
}

/// A method, and what it was made from.
pub(super) struct MethodEvaluator {
    pub compiled: Box<dyn CompiledMethod<f32>>,
    pub ingredients: Ingredients,
}
