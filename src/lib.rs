//! pellicle: layered and thin-film reflectance and the classic shading models, as eval / sample /
//! pdf, for renderers. The C interface is [`capi`] and `include/pellicle.h`; this page is about the
//! Rust side, which is the same library without the pointers.
//!
//! ```
//! use pellicle::{Bsdf, Description};
//!
//! let description = Description::new("layered")
//!     .set("eta", &[1.4, 1.45, 1.6])
//!     .set("exponent_reflection", &[90.0])
//!     .vary("thickness_nm", 66.0, 76.0);
//! let bsdf: Bsdf = Bsdf::new(&description)?;
//!
//! let wo = glam::Vec3::new(0.0, 0.6, 0.8);
//! let wi = glam::Vec3::new(0.0, -0.6, 0.8);
//! let [r, g, b] = bsdf.eval(wo, wi, Some(&[70.0])); // f(wo, wi) |wi.z| at 70 nm
//! assert!(r > g && g > b);
//! # Ok::<(), pellicle::Error>(())
//! ```
//!
//! # Conventions
//!
//! Directions are unit, point away from the surface and live in the local shading frame: +Z is the
//! shading normal, +X the tangent; `wo` goes to the viewer, `wi` to the light. `value` is
//! f(wo, wi) |wi.z|, `weight` is value / pdf, `pdf` is per solid angle of wi. Lengths are
//! nanometres, colours linear Rec.709. Directions within 1e-3 of unit length are accepted as they
//! are; any other, and NaN and infinity, give 0.
//!
//! # Layers
//!
//! A module uses only those to its left (a test keeps it so):
//! `num -> optics -> film -> bsdf -> batch -> capi`. A formula is written once, generic
//! over [`num::Real`]: the `f64` instance is the oracle that tests compare the `f32` instance with.

pub mod batch;
pub mod bsdf;
pub mod capi;
mod error;
pub mod film;
pub mod num;
pub mod optics;

pub use bsdf::{Bsdf, Call, Description, Evaluation, Sample, Transport};
pub use error::{Error, Status};
