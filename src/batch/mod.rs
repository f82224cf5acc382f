//! Batches: the single call over strided arrays. The one place outside `capi` that touches memory
//! by address.

#![allow(unsafe_code)]

mod bsdf;
mod column;
mod film;
mod varying;
mod view;

pub use bsdf::{EvalArgs, SampleArgs, eval, sample};
pub use film::{FilmArgs, film_reflectance};
pub use view::{ConstView, View};
