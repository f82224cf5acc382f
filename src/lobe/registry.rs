//! The list of models. A new model adds its line here and nothing anywhere else.

use super::film::ThinFilm;
use super::info::ModelInfo;
use super::kernel::Kernel;
use super::lambert::Lambert;
use super::layered::Layered;
use super::phong::Phong;
use super::scattering::Model;
use super::values::Values;
use crate::error::Error;

static MODELS: [Entry; 4] = [
    Entry::of::<Lambert>(),
    Entry::of::<Phong>(),
    Entry::of::<Layered>(),
    Entry::of::<ThinFilm>(),
];

/// All models.
pub fn models() -> &'static [Entry] {
    &MODELS
}

/// The model of that name.
pub fn find(name: &str) -> Result<&'static Entry, Error> {
    let found = MODELS.iter().find(|entry| entry.name() == name);
    found.ok_or_else(|| Error::unknown("model", name, MODELS.iter().map(Entry::name)))
}

/// A registered model: its description and its compiler in either precision.
pub struct Entry {
    /// What the model says about itself.
    pub info: &'static ModelInfo,
    /// [`Model::needs_film`].
    pub needs_film: fn(&Values<f32>) -> bool,
    /// [`Model::lobe_count`].
    pub lobe_count: fn(&Values<f32>) -> usize,
    /// [`Model::check`].
    pub check: fn(&Values<f32>) -> Result<(), Error>,
    /// [`Model::prepare`] in single precision.
    pub prepare_f32: fn(&Values<f32>) -> Box<dyn Kernel<f32>>,
    /// [`Model::prepare`] in double precision: the oracle.
    pub prepare_f64: fn(&Values<f64>) -> Box<dyn Kernel<f64>>,
}

impl Entry {
    const fn of<M: Model>() -> Self {
        Self {
            info: const { &M::INFO },
            needs_film: M::needs_film,
            lobe_count: M::lobe_count,
            check: M::check,
            prepare_f32: |values| Box::new(M::prepare(values)),
            prepare_f64: |values| Box::new(M::prepare(values)),
        }
    }

    /// The model's name.
    pub fn name(&self) -> &'static str {
        self.info.name.to_str().unwrap_or_default()
    }
}
