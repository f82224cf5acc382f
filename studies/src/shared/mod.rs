//! What several studies use. The library's internals are named here as far as possible, so that a change of them
//! is one edit.

pub mod batch;
pub mod bsdf;
pub mod directions;
pub mod draw;
#[path = "../../../tests/common/films.rs"]
pub mod films;
pub mod habit;
pub mod markdown;
pub mod peer;
pub mod progress;
pub mod stack;
pub mod svg;
