//! The two traits that a model implements.

use super::info::{Choice, LobeInfo, ModelInfo};
use super::kernel::Kernel;
use super::precision::Precision;
use super::quadrature;
use super::values::{Bounds, Values};
use crate::error::Error;
use crate::num::{Lane, Real, Rgb, Vec3};

/// The most lobes a model may have.
pub const MAX_LOBES: usize = 5;

/// One number per lobe; those beyond the model's own lobes are 0.
pub type PerLobe<T> = [T; MAX_LOBES];

/// A model behind a pointer, or what kept it from being compiled.
pub type Compiled<T> = Result<Box<dyn Kernel<T>>, Error>;

/// A model as the registry knows it: its description, and how to compile it.
pub trait Model: 'static {
    /// Name, parameters, lobes, broken laws.
    const INFO: ModelInfo;

    /// Whether the model with these values uses a film; without one it cannot be compiled then.
    fn needs_film(values: &Values<f32>) -> bool {
        let is_made = |choice: Choice| values.choice(choice.param) == choice.choice;
        Self::INFO.film_thickness.is_some() && Self::INFO.film_choice.is_none_or(is_made)
    }

    /// Those of the lobes that there are with these values.
    fn lobes(_values: &Values<f32>) -> &'static [LobeInfo] {
        Self::INFO.lobes
    }

    /// Refuses combinations of values that are each within their own range.
    fn check(_bounds: &Bounds) -> Result<(), Error> {
        Ok(())
    }

    /// Compiles validated values to what evaluation needs and nothing else. Fails only for want of memory
    /// for tables.
    fn prepare<T: Precision>(values: &Values<T>) -> Compiled<T>;
}

/// A surface whose lobes all reflect and have a density, or as many as there are lanes;
/// [`Mixture`](super::Mixture) makes a kernel of those that have [`Surfaces`](super::Surfaces).
///
/// Every direction passed in is valid and has z > 0; the caller has seen to it. Directions returned
/// may have z <= 0 or be null: then there is no sample.
pub trait Scattering<T: Lane> {
    /// Replaces the value of a parameter that varies per call. A scalar is in all three places; a
    /// direction is unit.
    fn vary(&mut self, param: usize, value: [T; 3]);

    /// To be called before evaluation, after the last of the values: what follows from several of them.
    fn settle(&mut self) {}

    /// f(wo, wi) |wi.z|.
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T>;

    /// [`Scattering::eval`] together with the density of each lobe at wi, per solid angle.
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>);

    /// The probability of each lobe, in proportion to its estimated share of the reflected light.
    /// They sum to 1, or are all 0 where nothing is reflected.
    fn selection(&self, wo: Vec3<T>) -> PerLobe<T>;

    /// A direction distributed as the density of `lobe`, from two uniform numbers in [0, 1).
    fn sample(&self, lobe: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T>;

    /// Directional albedo if it has a closed form.
    fn closed_albedo(&self) -> Option<Rgb<T>> {
        None
    }

    /// Directional albedo: the integral of [`Scattering::eval`] over wi.
    fn albedo(&self, wo: Vec3<T>) -> Rgb<T>
    where
        Self: Sized,
    {
        self.closed_albedo()
            .unwrap_or_else(|| quadrature::albedo(self, wo))
    }
}

/// Shares of the reflected light as probabilities: divided by their sum, or all 0 with it. Each is
/// divided, as the sum may be so small that its inverse is infinite.
#[inline(always)]
pub(super) fn normalized<T: Real>(shares: PerLobe<T>) -> PerLobe<T> {
    let zero = T::new(0.0);
    let mut sum = zero;
    for share in shares {
        sum = sum + share;
    }
    let is_dark = sum.le(zero);
    let divisor = T::select(is_dark, T::new(1.0), sum);
    let mut probabilities = shares;
    for probability in &mut probabilities {
        *probability = T::select(is_dark, zero, *probability / divisor);
    }
    probabilities
}
