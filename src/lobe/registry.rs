//! The list of models. A new model adds its line here and nothing anywhere else.

use super::disney_diffuse::DisneyDiffuse;
use super::film::ThinFilm;
use super::info::{LobeInfo, ModelInfo};
use super::lambert::Lambert;
use super::layered::Layered;
use super::metallic_roughness::MetallicRoughness;
use super::microfacet::Microfacet;
use super::oren_nayar::OrenNayar;
use super::phong::Phong;
use super::scattering::{Compiled, Model};
use super::values::{Bounds, Values};
use crate::error::Error;

static MODELS: [Entry; 8] = [
    Entry::of::<Lambert>(),
    Entry::of::<OrenNayar>(),
    Entry::of::<DisneyDiffuse>(),
    Entry::of::<Phong>(),
    Entry::of::<Layered>(),
    Entry::of::<ThinFilm>(),
    Entry::of::<Microfacet>(),
    Entry::of::<MetallicRoughness>(),
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
    /// [`Model::lobes`].
    pub lobes: fn(&Values<f32>) -> &'static [LobeInfo],
    /// [`Model::check`].
    pub check: fn(&Bounds) -> Result<(), Error>,
    /// [`Model::prepare`] in single precision.
    pub prepare_f32: fn(&Values<f32>) -> Compiled<f32>,
    /// [`Model::prepare`] in double precision: the oracle.
    pub prepare_f64: fn(&Values<f64>) -> Compiled<f64>,
}

impl Entry {
    const fn of<M: Model>() -> Self {
        Self {
            info: const { &M::INFO },
            needs_film: M::needs_film,
            lobes: M::lobes,
            check: M::check,
            prepare_f32: M::prepare,
            prepare_f64: M::prepare,
        }
    }

    /// The model's name.
    pub fn name(&self) -> &'static str {
        self.info.name.to_str().unwrap_or_default()
    }
}
