//! Single calls as most tests make them. Whatever else a call may ask for is at its default here and has
//! tests of its own.

use pellicle::bsdf::{PerLobe, Precision};
use pellicle::num::Rgb;
use pellicle::{Bsdf, Call, Sample};

/// Calls at their defaults. `varying` is what varies per call, as [`Bsdf`] takes it.
pub trait Calls<T: Precision> {
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

impl<T: Precision> Calls<T> for Bsdf<T> {
    fn value(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> Rgb<T> {
        self.eval(wo, wi, varying, &Call::default())
    }

    fn value_pdf(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> (Rgb<T>, T) {
        self.eval_pdf(wo, wi, varying, &Call::default())
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
        self.sample(wo, u, varying, &Call::default())
    }

    fn directional_albedo(&self, wo: T::Vector, varying: Option<&[T]>) -> Rgb<T> {
        self.albedo(wo, varying, &Call::default())
    }
}
