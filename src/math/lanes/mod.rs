//! The SIMD types. Of them only [`Doubles`] is named outside this folder.

mod dispatch;
mod doubles;
mod level;
mod look_up;
mod quads;
#[cfg(target_arch = "x86_64")]
mod rgb_sse2;
mod singles;

pub use dispatch::widest;
pub use doubles::Doubles;
pub use level::{Level, Work};
#[cfg(target_arch = "x86_64")]
pub use rgb_sse2::load_block;
