//! The description of a BSDF.

use crate::error::Error;
use crate::film::Film;
use crate::num::Level;
use std::fmt;
use std::sync::Arc;

/// The description of a BSDF: the name of its model, the parameters that differ from their defaults, those
/// that vary per call, and the film for models that take one. Nothing is checked before
/// [`Bsdf::new`](super::Bsdf::new).
#[derive(Clone, Default)]
pub struct Description {
    model: String,
    pub(super) params: Vec<(String, ParamValue)>,
    pub(super) varying: Vec<(String, f32, f32)>,
    pub(super) film: Option<Arc<Film>>,
    simd_level: Option<String>,
}

impl fmt::Debug for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Description")
            .field("model", &self.model)
            .field("params", &self.params)
            .field("varying", &self.varying)
            .field("film", &self.film.as_deref().map(Film::description))
            .finish()
    }
}

/// The value of a parameter as the caller gave it.
#[derive(Clone, Debug)]
pub(super) enum ParamValue {
    Numbers(Vec<f32>),
    Choice(String),
}

impl Description {
    /// A model with every parameter at its default. [`model_infos`](crate::model_infos) lists the models.
    pub fn new(model: &str) -> Self {
        Self {
            model: model.to_owned(),
            ..Self::default()
        }
    }

    /// The model's name.
    pub fn model(&self) -> &str {
        &self.model
    }

    /// Sets a parameter to 1 or 3 numbers. A single number sets all three components of a parameter that
    /// has three, except for directions.
    #[must_use]
    pub fn set(mut self, param: &str, numbers: &[f32]) -> Self {
        self.params
            .push((param.to_owned(), ParamValue::Numbers(numbers.to_vec())));
        self
    }

    /// Sets a parameter to one of its choices, by name.
    #[must_use]
    pub fn choose(mut self, param: &str, choice: &str) -> Self {
        self.params
            .push((param.to_owned(), ParamValue::Choice(choice.to_owned())));
        self
    }

    /// Declares that calls give the parameter, and the range [min, max] of each component. Calls clamp
    /// finite values to this range. For a direction give 0 and 0.
    #[must_use]
    pub fn vary(mut self, param: &str, min: f32, max: f32) -> Self {
        self.varying.push((param.to_owned(), min, max));
        self
    }

    /// Sets the film, for models that take one. Several BSDFs may share a film.
    #[must_use]
    pub fn film(mut self, film: Arc<Film>) -> Self {
        self.film = Some(film);
        self
    }

    /// Sets the instructions of batches, for tests: "scalar", "sse2", "avx2", "avx512" or "neon", if this
    /// processor has them. The default is the widest; all levels return the same bits.
    #[must_use]
    pub fn simd_level(mut self, name: &str) -> Self {
        self.simd_level = Some(name.to_owned());
        self
    }

    pub(super) fn level(&self) -> Result<Level, Error> {
        self.simd_level
            .as_deref()
            .map_or_else(|| Ok(Level::widest()), Level::named)
    }
}
