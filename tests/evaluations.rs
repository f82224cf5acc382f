//! No evaluation gives NaN, an infinity, a negative number or one above its bound: half a million here;
//! `./x check evaluations` makes 1e8, or as many as asked for.

#![allow(unsafe_code)] // batches go by addresses

mod common;
#[path = "common/evaluations/mod.rs"]
mod evaluations;
#[path = "common/promise/mod.rs"]
mod promise;

use evaluations::{Settings, run};

#[test]
fn evaluations_stay_within_their_bounds() {
    let settings = Settings {
        seed: 1,
        evaluations: 500_000,
        batches: 1,
    };
    let tally = run(&settings, |_| {});
    assert!(tally.failures.is_empty(), "{:#?}", tally.failures);
    assert!(tally.total() >= settings.evaluations);
    for call in [
        "bsdf_eval",
        "bsdf_sample",
        "bsdf_albedo",
        "film_eval",
        "film_reflectance",
    ] {
        assert!(tally.evaluated.contains_key(call), "{call} was not called");
    }
}
