//! BSDFs: what a model is, what exists, and a model with its parameters set, ready to be called.
//!
//! A model is one file in `models/` and one line in `registry.rs`.

mod description;
mod film_rules;
mod info;
mod instance;
mod kernel;
mod mixture;
mod model;
mod models;
mod precision;
mod quadrature;
mod registry;
mod tile;
mod tiles;
mod values;
mod varying;

pub use description::Description;
pub use info::{Choice, Exception, Flags, LobeInfo, ModelInfo, ParamInfo, ParamKind};
pub use instance::{Bsdf, Sample, Scalar};
pub use kernel::{Direction, Kernel, Override};
pub use mixture::{Mixture, Surfaces};
pub use model::{Compiled, MAX_LOBES, Model, PerLobe, Scattering};
pub use precision::Precision;
pub use registry::{RegisteredModel, find, models};
pub use tile::{
    EvalTile, LANES, SampleTile, Tiles, Varied, Vectors, VectorsMut, is_above, is_uniform, is_unit,
};
pub(crate) use tiles::{Found, Given};
pub use values::{Bounds, Values};
pub(crate) use varying::MAX_VARYING;
