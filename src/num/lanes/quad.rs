//! The lanes that need no choice of instructions at run time.

#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use super::f32_lanes::F32Lanes;

/// Four lanes of single precision, with instructions that every processor of the target has.
#[cfg(target_arch = "x86_64")]
pub type F32x4 = F32Lanes<fearless_simd::Sse2>;
/// Four lanes of single precision, with instructions that every processor of the target has.
#[cfg(target_arch = "aarch64")]
pub type F32x4 = F32Lanes<fearless_simd::Neon>;
/// One lane, on processors without lanes of ours.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
pub type F32x4 = f32;
