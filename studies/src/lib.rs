//! Studies of the library: how exact and how fast it is, where it fails, and whether it keeps its promises. The
//! programs `chart`, `atlas` and `check` run them; the tests run a small dose of each.

pub mod atlas;
pub mod chart;
pub mod error_maps;
pub mod f32_vs_f64;
pub mod ffi_fuzz;
pub mod film_cliffs;
pub mod film_tolerance;
pub mod random_bounds;
pub mod shared;

#[cfg(test)]
mod batch_long;
