//! A compiled model behind a pointer: what is the same for all models and needs one virtual call.

use super::model::PerLobe;
use super::precision::Precision;
use super::tile::Tiles;
use crate::num::{Rgb, Vec3};

/// A parameter's value for one call, in place of the one it was compiled with.
#[derive(Clone, Copy, Debug)]
pub struct Override<T> {
    /// Index of the parameter.
    pub param: usize,
    /// Its value; a scalar is in all three places, a direction is unit.
    pub value: [T; 3],
}

/// A sampled direction.
#[derive(Clone, Copy, Debug)]
pub struct Direction<T> {
    /// To the light.
    pub wi: Vec3<T>,
    /// Density of wi over all lobes; 0 for a Dirac lobe.
    pub pdf: T,
    /// value / pdf; for a Dirac lobe what it passes on over the probability of choosing it.
    pub weight: Rgb<T>,
    /// Index on wi's side over the index on wo's side.
    pub eta: T,
    /// Which lobe was chosen.
    pub lobe: usize,
}

/// A compiled model, callable without knowing which.
///
/// Every direction passed in is valid and has z > 0, or for a BSDF with TRANSMISSION z != 0; the
/// caller has seen to it.
pub trait Kernel<T: Precision>: Send + Sync {
    /// f(wo, wi) |wi.z|; 0 unless a lobe has a density.
    fn eval(&self, _overrides: &[Override<T>], _wo: Vec3<T>, _wi: Vec3<T>) -> Rgb<T> {
        [T::new(0.0); 3]
    }
    /// Value and density; 0 unless a lobe has a density.
    fn eval_pdf(&self, _overrides: &[Override<T>], _wo: Vec3<T>, _wi: Vec3<T>) -> (Rgb<T>, T) {
        ([T::new(0.0); 3], T::new(0.0))
    }
    /// Probability and density of each lobe.
    fn lobes(
        &self,
        overrides: &[Override<T>],
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>);
    /// A direction, from three uniform numbers in [0, 1): the first chooses the lobe.
    fn sample(&self, overrides: &[Override<T>], wo: Vec3<T>, u: [T; 3]) -> Option<Direction<T>>;
    /// Directional albedo.
    fn albedo(&self, overrides: &[Override<T>], wo: Vec3<T>) -> Rgb<T>;
    /// What of the model's terms is left out or found by shorter formulas, in words.
    fn plan(&self) -> Vec<&'static str> {
        Vec::new()
    }
    /// The same, many at once; none: one by one.
    fn tiles(&self) -> Option<&dyn Tiles> {
        None
    }
}
