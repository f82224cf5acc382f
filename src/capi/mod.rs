//! The C interface: validation, conversion, the panic guard, and nothing else.
//!
//! The documentation of every function is written for the C header, which build.rs generates from here.

#![allow(unsafe_code)]

mod api;
mod batch;
mod boundary;
mod bsdf;
mod bsdf_calls;
mod bsdf_spectral;
mod bsdf_types;
mod c_types;
mod call;
mod catalogue;
#[cfg(test)]
mod faults;
mod film;
mod film_calls;
mod film_description;
mod film_saving;
mod film_spectra;
mod film_types;
mod float_control;
mod last_error;
mod medium;
mod text;
mod types;
mod version;

pub use api::*;
pub use batch::*;
pub use bsdf::*;
pub use bsdf_calls::*;
pub use bsdf_spectral::*;
pub use bsdf_types::*;
pub use catalogue::*;
pub use film::*;
pub use film_calls::*;
pub use film_saving::*;
pub use film_spectra::*;
pub use film_types::*;
pub use types::*;
pub use version::*;
