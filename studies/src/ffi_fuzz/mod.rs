//! The contract of the C interface, as functions of arbitrary bytes: each makes calls of them and panics if one breaks
//! what the header promises. The fuzzers (fuzz/) search for such bytes; a test replays a kept corpus
//! (studies/corpus).
//!
//! The header promises a documented status; a message with every failure; outputs that a failure leaves untouched;
//! results that are finite, not negative and not above their bounds; and that only what the caller names is read or
//! written.

#![allow(unsafe_code)] // the C interface is all pointers

mod batch;
mod bytes;
mod create_bsdf;
mod create_film;
mod evaluate;
mod guarded;
mod load_film;
mod outcome;
mod subjects;
#[cfg(test)]
mod tests;
mod texts;

/// A function of arbitrary bytes, which panics if the contract is broken.
pub type Target = fn(&[u8]);

/// The functions, by the name of the fuzzer and of the corpus.
pub const TARGETS: [(&str, Target); 5] = [
    ("batch", batch::run),
    ("create_bsdf", create_bsdf::run),
    ("create_film", create_film::run),
    ("evaluate", evaluate::run),
    ("load_film", load_film::run),
];

/// Runs the target of that name.
pub fn run(target: &str, data: &[u8]) {
    let (_, run) = TARGETS.iter().find(|(name, _)| *name == target).unwrap();
    run(data);
}
