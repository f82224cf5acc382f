//! The scattering models, one file (or folder) each, and the registry that lists them.
//!
//! To add a model, write its file, implement [`Model`], [`Surfaces`] and [`Scattering`] in it ([`Diffuse`],
//! if it is one diffuse lobe; [`Kernel`] alone, if a lobe has no density), and add its line to `registry.rs`. Everything else
//! (creation, validation, the C interface, the laws that every model is tested against, the table in the
//! README) follows from the registry.

mod cosine_lobe;
mod disney_diffuse;
mod film;
mod info;
mod kernel;
mod lambert;
mod layered;
mod metallic_roughness;
mod microfacet;
mod mixture;
mod oren_nayar;
mod phong;
mod power_lobe;
mod precision;
mod quadrature;
mod registry;
mod scattering;
mod tile;
mod values;

pub use cosine_lobe::{CosineLobe, Diffuse};
pub use info::{Choice, Exception, Flags, LobeInfo, ModelInfo, ParamInfo, ParamKind};
pub use kernel::{Direction, Kernel, Override};
pub use mixture::{Mixture, Surfaces};
pub use precision::Precision;
pub use registry::{Entry, find, models};
pub use scattering::{Compiled, MAX_LOBES, Model, PerLobe, Scattering};
pub use tile::{
    EvalTile, LANES, SampleTile, Tiles, Varied, Vectors, VectorsMut, is_above, is_uniform, is_unit,
};
pub use values::{Bounds, Values};
