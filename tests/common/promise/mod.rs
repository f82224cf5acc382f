//! The promise that a film's error stays within its tolerance, checked on random stacks at random
//! points. Shared by the test of 50 stacks (tests/film_promise.rs) and the long run of 1,000
//! (examples/promise, `./x check promise`).

#![allow(dead_code)] // each program uses a part

pub mod comparison;
pub mod draw;
pub mod points;
pub mod run;
pub mod stack;
pub mod summary;
pub mod truth;
pub mod truth_file;

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Random numbers for one purpose of one stack.
fn rng(seed: u64, stack: usize, purpose: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64((seed << 32) ^ ((stack as u64) << 4) ^ purpose)
}

fn log_uniform(rng: &mut impl Rng, min: f32, max: f32) -> f32 {
    (min * (max / min).powf(rng.random())).clamp(min, max)
}
