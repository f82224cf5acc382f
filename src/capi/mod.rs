//! The C interface: validation, conversion, the panic guard, and nothing else.
//!
//! The documentation of every function is written for the C header, which is generated from here.

#![allow(unsafe_code)]

mod api;
mod args;
mod batch;
mod boundary;
mod bsdf;
#[cfg(test)]
mod faults;
mod film;
mod film_description;
mod last_error;
mod medium;
mod model;
mod text;
mod types;
mod version;

pub use api::*;
pub use args::*;
pub use batch::*;
pub use bsdf::*;
pub use film::*;
pub use model::*;
pub use types::*;
pub use version::*;
