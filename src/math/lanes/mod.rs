//! The SIMD types; nothing outside this folder names one.

mod dispatch;
mod doubles;
#[cfg(target_arch = "x86_64")]
mod rgb_sse2;

pub use dispatch::widest;
pub use doubles::Doubles;
