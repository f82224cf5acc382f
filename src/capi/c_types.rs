//! The C types of the target. The crate libc has none for WebAssembly.

#[cfg(not(target_family = "wasm"))]
pub(super) use libc::{c_char, c_void, ptrdiff_t, size_t};

#[cfg(target_family = "wasm")]
mod wasm {
    #![allow(non_camel_case_types)]
    pub use core::ffi::{c_char, c_void};
    pub type size_t = usize;
    pub type ptrdiff_t = isize;
}
#[cfg(target_family = "wasm")]
pub(super) use wasm::{c_char, c_void, ptrdiff_t, size_t};
