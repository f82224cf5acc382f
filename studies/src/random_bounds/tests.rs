use super::bounds::greatest_weight;
use super::{Settings, run};
use crate::shared::directions::rng;
use crate::shared::draw::{Drawn, variants};
use glam::Vec3;
use pellicle::bsdf::models;

/// Draws of each model, at least.
const DRAWS: u64 = 10;

/// 300,000 elements of some 350 models and 25 films; `./x check random_bounds` tries 1e8. Every parameter that can vary
/// does so.
#[test]
fn evaluations_stay_within_their_bounds() {
    let settings = Settings {
        seed: 1,
        evaluations: 300_000,
        batches: 1,
        elements: 400,
    };
    let tally = run(&settings);
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
    for entry in models() {
        let draws = tally.draws.get(entry.name()).copied().unwrap_or(0);
        assert!(draws >= DRAWS, "{} was drawn {draws} times", entry.name());
        for param in entry.info.params.iter().filter(|param| param.can_vary) {
            let varied = tally.varied.contains_key(&(entry.name(), param.name()));
            assert!(
                varied,
                "{} {} never varied in {draws} draws",
                entry.name(),
                param.name()
            );
        }
    }
}

#[test]
fn every_model_has_a_bound_of_its_weights() {
    for variant in variants() {
        let (drawn, _) = Drawn::new(&variant, 0.0, &mut rng(1));
        let bound = greatest_weight(&drawn, Vec3::Z, Vec3::Z, 1.0);
        assert!(
            bound.is_some(),
            "{} has none in random_bounds/bounds.rs",
            variant.name
        );
    }
}
