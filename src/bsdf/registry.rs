//! The list of models. A new model adds one line here.

use super::info::{LobeInfo, ModelInfo};
use super::model::Model;
use super::precision::Prepare;
use super::values::{Bounds, Values};
use crate::error::Error;

/// Lists the models. The compilers in double precision are in a list of their own, so that the linker
/// leaves them out of programs that never use them.
macro_rules! registry {
    ($($model:ty),* $(,)?) => {
        #[cfg(not(test))]
        lists![$($model),*];
        // Unit tests type-check every model and compile the two that they call, which takes a third of the time.
        #[cfg(test)]
        lists![super::models::lambert::Lambert, super::models::phong::Phong];
        #[cfg(test)]
        #[allow(dead_code)]
        fn all() -> [RegisteredModel; [$(stringify!($model)),*].len()] {
            $(let _: Prepare<f64> = <$model>::prepare::<f64>;)*
            [$(RegisteredModel::of::<$model>()),*]
        }
    };
}

macro_rules! lists {
    ($($model:ty),*) => {
        static MODELS: [RegisteredModel; [$(stringify!($model)),*].len()] =
            [$(RegisteredModel::of::<$model>()),*];
        static ORACLES: [Prepare<f64>; MODELS.len()] = [$(<$model>::prepare::<f64>),*];
    };
}

registry![
    super::models::lambert::Lambert,
    super::models::oren_nayar::OrenNayar,
    super::models::disney_diffuse::DisneyDiffuse,
    super::models::phong::Phong,
    super::models::layered::Layered,
    super::models::film::ThinFilm,
    super::models::microfacet::Microfacet,
    super::models::metallic_roughness::MetallicRoughness,
];

/// All models.
pub const fn models() -> &'static [RegisteredModel] {
    &MODELS
}

/// The descriptions of all models: parameters with ranges and defaults, lobes, sources.
pub fn model_infos() -> impl ExactSizeIterator<Item = &'static ModelInfo> {
    MODELS.iter().map(|entry| entry.info)
}

/// The model with that name.
pub fn find(name: &str) -> Result<&'static RegisteredModel, Error> {
    let found = MODELS.iter().find(|entry| entry.name() == name);
    found.ok_or_else(|| Error::unknown("model", name, MODELS.iter().map(RegisteredModel::name)))
}

/// A registered model: its description and its compilers.
pub struct RegisteredModel {
    /// `Model::INFO`.
    pub info: &'static ModelInfo,
    /// `Model::needs_film`.
    pub needs_film: fn(&Values<f32>) -> bool,
    /// `Model::lobes`.
    pub lobes: fn(&Values<f32>) -> &'static [LobeInfo],
    /// `Model::check`.
    pub check: fn(&Bounds) -> Result<(), Error>,
    /// `Model::prepare` in single precision.
    pub prepare: Prepare<f32>,
}

impl RegisteredModel {
    const fn of<M: Model>() -> Self {
        Self {
            info: const { &M::INFO },
            needs_film: M::needs_film,
            lobes: M::lobes,
            check: M::check,
            prepare: M::prepare,
        }
    }

    /// `Model::prepare` in double precision.
    pub fn oracle(&self) -> Prepare<f64> {
        let is_self = |model: &RegisteredModel| std::ptr::eq(model, self);
        let index = MODELS.iter().position(is_self);
        ORACLES[index.expect("all models are in the list")]
    }

    /// The name of the model.
    pub fn name(&self) -> &'static str {
        self.info.name
    }
}
