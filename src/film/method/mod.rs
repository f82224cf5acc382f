//! The methods that a film is evaluated by: one file each, with the method's name, sizes, cost and how
//! it is compiled. `registry.rs` lists them.

mod airy_rgb;
mod bands;
pub(super) mod compiled_method;
mod fresnel;
mod harmonics;
pub(super) mod info;
mod media;
pub(super) mod one_layer;
mod quadrature;
mod reference;
pub(super) mod registry;
mod schlick;
mod series;
mod table;
mod two_beam;
