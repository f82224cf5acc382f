//! The SIMD types. Of them only [`Doubles`] is named outside this folder.

mod dispatch;
mod doubles;
#[cfg(target_arch = "x86_64")]
mod rgb_sse2;

pub use dispatch::widest;
pub use doubles::Doubles;
