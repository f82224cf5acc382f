//! The SIMD types; nothing outside this folder names one.

#[cfg(target_arch = "x86_64")]
mod rgb_sse2;
