//! A model as the registry knows it.

use super::info::{Choice, LobeInfo, ModelInfo};
use super::kernel::Kernel;
use super::precision::Precision;
use super::values::{Bounds, Values};
use crate::error::Error;

/// A compiled model, or the reason why it could not be compiled.
pub type KernelResult<T> = Result<Box<dyn Kernel<T>>, Error>;

/// The description of a model, and how it is compiled.
pub trait Model: 'static {
    /// Name, parameters, lobes, exceptions from the laws.
    const INFO: ModelInfo;

    /// Whether the model with these values uses a film; without one it cannot be compiled then.
    fn needs_film(values: &Values<f32>) -> bool {
        let is_made = |choice: Choice| values.choice(choice.param) == choice.choice;
        Self::INFO.film_thickness.is_some() && Self::INFO.film_choice.is_none_or(is_made)
    }

    /// The lobes that the model has with these values.
    fn lobes(_values: &Values<f32>) -> &'static [LobeInfo] {
        Self::INFO.lobes
    }

    /// Refuses combinations of values that are each within their own range.
    fn check(_bounds: &Bounds) -> Result<(), Error> {
        Ok(())
    }

    /// Compiles validated values. Fails only if there is no memory for tables.
    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T>;
}
