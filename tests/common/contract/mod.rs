//! The contract of the C interface, as functions of arbitrary bytes: each makes calls of them and
//! panics if one breaks what the header promises. The fuzzers (fuzz/) look for such bytes; a kept corpus
//! (tests/data/corpus) is replayed by tests/contract.rs.
//!
//! Promised are: a documented status; a message with every failure; outputs untouched by a failure;
//! results that are finite, not negative and not above their bounds; and that nothing but what was
//! named is read or written.

mod batch;
mod bytes;
mod create_bsdf;
mod create_film;
mod evaluate;
mod guarded;
mod outcome;
mod subjects;
mod texts;

/// A function of arbitrary bytes, which panics if the contract is broken.
pub type Target = fn(&[u8]);

/// What to call with arbitrary bytes, by the name of the fuzzer and of the corpus.
pub const TARGETS: [(&str, Target); 4] = [
    ("batch", batch::run),
    ("create_bsdf", create_bsdf::run),
    ("create_film", create_film::run),
    ("evaluate", evaluate::run),
];

/// Runs the target of that name.
pub fn run(target: &str, data: &[u8]) {
    let (_, run) = TARGETS.iter().find(|(name, _)| *name == target).unwrap();
    run(data);
}
