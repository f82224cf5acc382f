//! The laws that every model obeys, tried over the whole registry: a new model is tried by all of
//! them as soon as the registry names it.

mod albedo;
mod batch;
mod batch_inputs;
mod batch_overlaps;
mod batch_views;
mod call_options;
mod chi_square;
#[path = "../common/mod.rs"]
mod common;
mod lengths;
mod registry;
mod specialised;
mod spectral;
mod spectral_batch;
mod strided;
mod varying;
