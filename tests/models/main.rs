//! Each model against the formulas that define it, other people's numbers, and its own promises.

#[path = "../common/mod.rs"]
mod common;
mod diffuse;
mod metallic_roughness;
mod microfacet;
mod white_furnace;
