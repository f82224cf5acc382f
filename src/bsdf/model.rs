//! The trait that every model implements.

use super::info::{Choice, LobeInfo, ModelInfo};
use super::kernel::Kernel;
use super::precision::Precision;
use super::values::{Bounds, Values};
use crate::error::Error;

/// A compiled model, or the error that compiling it met.
pub type KernelResult<T> = Result<Box<dyn Kernel<T>>, Error>;

/// A model: its description, its checks and its compiler.
pub trait Model: 'static {
    /// Name, parameters, lobes and exceptions from the laws.
    const INFO: ModelInfo;

    /// Whether the model needs a film with these values.
    fn needs_film(values: &Values<f32>) -> bool {
        let is_made = |choice: Choice| values.choice(choice.param) == choice.choice;
        Self::INFO.film_thickness.is_some() && Self::INFO.film_choice.is_none_or(is_made)
    }

    /// The lobes of the model with these values.
    fn lobes(_values: &Values<f32>) -> &'static [LobeInfo] {
        Self::INFO.lobes
    }

    /// Refuses combinations of values that are each within their own range.
    fn check(_bounds: &Bounds) -> Result<(), Error> {
        Ok(())
    }

    /// Compiles the model for validated values. It fails only if there is no memory for tables.
    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T>;
}
