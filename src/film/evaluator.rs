//! The compiled form of a film.

use super::fringe_series::series::FringeSeries;
use super::method::compiled_method::{CompiledMethod, Ingredients};
use super::table::two_sided::TwoSidedTables;

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

/// A method, and what it was made from.
pub(super) struct MethodEvaluator {
    pub compiled: Box<dyn CompiledMethod<f32>>,
    pub ingredients: Ingredients,
}
