//! What a film is compiled to.

use super::fringe_series::series::FringeSeries;
use super::method::compiled_method::CompiledMethod;
use super::table::two_sided::TwoSidedTables;

/// What the chosen method compiles to.
pub(super) enum Evaluator {
    /// Most films; looked up without a virtual call, and in lanes.
    Tables(TwoSidedTables),
    /// A method that knows the reflectance from the ambient's side alone.
    Method(Box<dyn CompiledMethod<f32>>),
    /// The series at every call.
    Series(FringeSeries),
    /// The film's own reference at every call.
    Reference,
}
