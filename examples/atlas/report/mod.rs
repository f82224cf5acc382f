//! The results as pictures and pages.

mod accuracy;
mod atlas;
mod pictures;
mod words;

pub use accuracy::accuracy;
pub use atlas::atlas;
pub use pictures::pictures;
