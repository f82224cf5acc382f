//! The arithmetic of all formulas: the traits [`Real`] and [`Lane`], elementary functions, SIMD lanes,
//! vectors, table look-ups and warps of the unit square. Nothing here depends on optics.

// On processors without lanes of ours, WebAssembly's, what serves the lanes alone has no use.
#![cfg_attr(
    not(any(target_arch = "x86_64", target_arch = "aarch64")),
    allow(unused)
)]

mod arctangent;
pub(crate) mod bytes;
mod columns;
mod elementary;
mod error_function;
mod lane;
mod lanes;
mod real;
mod rgb;
mod scalar;
pub(crate) mod spline;
mod table;
mod vec3;
pub mod warp;

pub(crate) use arctangent::angle_turns;
pub use columns::{ColumnMut, Columns, ColumnsMut};
pub(crate) use error_function::{erfcx, erfinv};
pub use lane::Lane;
pub use lanes::{F32x4, F64x4, Level, Work, widest};
pub use real::{Mask, Real};
pub(crate) use rgb::each;
pub(crate) use table::INDEX_BIAS;
pub use table::{TableBlock, TableEntry};
pub use vec3::{Rgb, Vec3};

/// pi.
pub(crate) const PI: f64 = std::f64::consts::PI;
