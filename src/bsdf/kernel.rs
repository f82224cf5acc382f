//! A compiled model behind a pointer: the one virtual call.

use super::job::{EvalJob, SampleJob};
use super::lobes::{LobeSet, PerLobe};
use super::varying::VaryingValues;
use crate::num::{Level, Rgb, Vec3};

/// A compiled model, callable without knowing which.
///
/// `wo` and `wi` outside of jobs are valid: unit, with z > 0 or, for a BSDF with TRANSMISSION, z != 0.
pub trait Kernel<T>: Send + Sync {
    /// Values and densities; 0 unless a lobe has a density. Every level returns the same bits.
    fn evaluate(&self, level: Level, job: &mut EvalJob<T>);

    /// Sampled directions. Every level returns the same bits.
    fn sample(&self, level: Level, job: &mut SampleJob<T>);

    /// Directional albedo of the lobes in the set: the integral of the value over wi, what Dirac lobes
    /// reflect and transmit included.
    fn albedo(&self, wo: Vec3<T>, varying: &VaryingValues<T>, lobes: LobeSet) -> Option<Rgb<T>>;

    /// The probability of each lobe, and each lobe's own density at wi.
    fn lobes(
        &self,
        wo: Vec3<T>,
        wi: Vec3<T>,
        varying: &VaryingValues<T>,
    ) -> Option<(PerLobe<T>, PerLobe<T>)>;

    /// The terms that are left out and the formulas that are shorter for these parameters, in words.
    fn plan(&self) -> Vec<&'static str>;
}
