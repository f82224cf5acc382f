//! SIMD types. Formulas are generic over [`Lane`](super::Lane); only [`F64x4`] is named outside this
//! folder.

mod dispatch;
mod f32_lanes;
mod f64x4;
mod instructions;
mod level;
mod look_up;
mod quad;
#[cfg(target_arch = "aarch64")]
mod register_neon;
#[cfg(target_arch = "x86_64")]
mod register_sse2;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
mod rgb_lanes;

pub use dispatch::widest;
pub use f64x4::F64x4;
pub use level::{Level, Work};
pub use quad::F32x4;
