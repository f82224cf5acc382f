//! The scattering models, one file (or folder) each, and the registry that lists them.
//!
//! To add a model, write its file, implement [`Model`] and [`Scattering`] in it, and add its line
//! to `registry.rs`. Everything else (creation, validation, the C interface, the laws that every
//! model is tested against, the table in the README) follows from the registry.

mod info;
mod kernel;
mod lambert;
mod layered;
mod phong;
mod power_lobe;
mod quadrature;
mod registry;
mod scattering;
mod values;

pub use info::{Exception, Flags, LobeInfo, ModelInfo, ParamInfo, ParamKind};
pub use kernel::{Direction, Kernel, Override};
pub use registry::{Entry, find, models};
pub use scattering::{MAX_LOBES, Model, PerLobe, Scattering};
pub use values::Values;
