//! Single calls as most tests make them. Whatever else a call may ask for is at its default here and has
//! tests of its own.

use pellicle::bsdf::PerLobe;
use pellicle::num::Rgb;
use pellicle::{Bsdf, Sample, Scalar};

/// Calls at their defaults. `varying` is what varies per call, as [`Bsdf`] takes it.
pub trait Calls<T: Scalar> {
    /// f(wo, wi) |wi.z|.
    fn value(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> Rgb<T>;
    /// The value, and the density of `wi`.
    fn value_pdf(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> (Rgb<T>, T);
    /// The probability of each lobe, and its own density at `wi`.
    fn lobe_densities(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
    ) -> (PerLobe<T>, PerLobe<T>);
    /// A direction for three uniform numbers in [0, 1).
    fn sampled(&self, wo: T::Vector, u: T::Vector, varying: Option<&[T]>) -> Sample<T>;
    /// The integral of the value over wi.
    fn directional_albedo(&self, wo: T::Vector, varying: Option<&[T]>) -> Rgb<T>;
}

impl<T: Scalar> Calls<T> for Bsdf<T> {
    fn value(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> Rgb<T> {
        self.eval(wo, wi, varying)
    }

    fn value_pdf(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> (Rgb<T>, T) {
        self.eval_pdf(wo, wi, varying)
    }

    fn lobe_densities(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        self.lobes(wo, wi, varying)
    }

    fn sampled(&self, wo: T::Vector, u: T::Vector, varying: Option<&[T]>) -> Sample<T> {
        self.sample(wo, u, varying)
    }

    fn directional_albedo(&self, wo: T::Vector, varying: Option<&[T]>) -> Rgb<T> {
        self.albedo(wo, varying)
    }
}
