//! The arithmetic that every formula is written in: the trait [`Real`], its elementary functions,
//! three-vectors and warps of the unit square. Nothing here knows about optics.

mod elementary;
mod lanes;
mod real;
mod rgb;
mod vector;
pub mod warp;

pub use lanes::{Doubles, widest};
pub use real::{Mask, Real};
pub use rgb::Element;
pub use vector::{Rgb, Vec3};

/// The ratio of a circle's circumference to its diameter, as the formulas use it.
pub(crate) const PI: f64 = std::f64::consts::PI;
