//! BSDFs: the models, their registry, descriptions with their checks, and compiled BSDFs with their calls.
//!
//! A model is one file in `models/` and one line in `registry.rs`.

mod call;
mod compiled;
mod description;
mod film_rules;
mod info;
mod instance;
mod job;
mod kernel;
mod lobes;
mod model;
mod models;
mod precision;
mod quadrature;
mod registry;
mod resolve;
mod spectral;
mod surface;
mod values;
mod varying;
mod wavelengths;

pub use call::{Call, Transport};
pub use description::Description;
pub use info::{Choice, Exception, Flags, LobeInfo, ModelInfo, ParamInfo, ParamKind};
pub use instance::{Bsdf, Evaluation, Sample, Varying};
pub(crate) use job::{EvalJob, SampleJob};
pub use lobes::{MAX_LOBES, PerLobe};
pub use precision::Precision;
pub use registry::{RegisteredModel, find, model_infos, models};
pub use spectral::{AtWavelengths, SpectralSample};
pub use values::{Bounds, Values};
pub(crate) use varying::{MAX_FLOATS, MAX_VARYING};
pub(crate) use wavelengths::MAX_SPECTRAL_FLOATS;
pub use wavelengths::MAX_WAVELENGTHS;
