//! The C interface under an interpreter, what the documents say of the registry, and the rules that
//! the sources themselves follow.

mod house;
mod imports;
mod interpreted;
mod layering;
mod models_page;
mod sources;
