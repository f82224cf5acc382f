use super::bounds::{Between, find, of_variant};
use super::row::{Quantity, Row};
use super::tally::{FLOOR, Tally, relative};
use super::{Settings, run};
use crate::shared::draw::variants;
use pellicle::bsdf::{ParamKind, models};

/// A million elements; `./x check` tries a hundred million.
#[test]
fn single_precision_stays_within_its_bounds() {
    let settings = Settings {
        seed: 7,
        evaluations: 1_000_000,
        // Many surfaces of each variant with few elements each.
        surface_elements: 251,
    };
    let rows = run(&settings);
    let evaluations: u64 = rows.iter().map(|row| row.evaluations).sum();
    assert!(evaluations >= settings.evaluations, "{evaluations}");
    let failures: Vec<String> = rows.iter().flat_map(Row::failures).collect();
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn every_choice_of_every_model_has_a_row_and_bounds() {
    let variants = variants();
    for entry in models() {
        let own: Vec<_> = variants
            .iter()
            .filter(|variant| variant.entry.name() == entry.name())
            .collect();
        assert!(!own.is_empty(), "{}", entry.name());
        for (index, param) in entry.info.params.iter().enumerate() {
            if let ParamKind::Choice { choices } = param.kind {
                for choice in 0..choices.len() {
                    let has_it = own.iter().any(|v| v.choices[index] == Some(choice));
                    assert!(has_it, "{} {} {choice}", entry.name(), param.name());
                }
            }
        }
    }
    let missing = variants.iter().filter(|v| find(&v.name).is_none());
    let missing: Vec<&str> = missing.map(|v| v.name.as_str()).collect();
    assert!(
        missing.is_empty(),
        "no bounds in f32_vs_f64/bounds.rs: {missing:?}"
    );
    let mut names: Vec<&str> = variants.iter().map(|v| v.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), variants.len(), "two rows of one name");
}

fn row() -> Row {
    Row::new("phong", of_variant("phong"))
}

#[test]
fn an_error_beyond_its_bound_is_a_failure() {
    for quantity in [
        Quantity::Value,
        Quantity::Pdf,
        Quantity::Weight,
        Quantity::Horizon,
    ] {
        let bound = row().bounds.of(quantity);
        for (error, failures) in [(0.99 * bound, 0), (1.01 * bound, 1), (f64::NAN, 1)] {
            let mut row = row();
            row.add(quantity, error, || "here".into());
            assert_eq!(row.failures().len(), failures, "{quantity:?} {error}");
        }
    }
}

/// Inputs whose last digits explain an error excuse it, others do not.
#[test]
fn only_the_last_digit_excuses() {
    for (spread, failures) in [(1e-3, 1), (3e-3, 0)] {
        let mut row = row();
        row.add_or_excuse(Quantity::Value, 2e-3, || spread, || "here".into());
        assert_eq!(row.failures().len(), failures);
        assert_eq!(row.excused.count, 1 - failures as u64);
    }
}

#[test]
fn levels_are_held_to_their_bits_or_to_a_bound() {
    let cases = [
        (Between::SameBits, 0.0, 1),
        (Between::Within(1e-5), 0.9e-5, 0),
        (Between::Within(1e-5), 1.1e-5, 1),
    ];
    for (between, difference, failures) in cases {
        let mut row = row();
        row.bounds.between = between;
        assert!(row.failures().is_empty());
        row.add_difference(difference, || "here".into());
        assert_eq!(row.failures().len(), failures, "{between:?} {difference}");
    }
}

#[test]
fn too_many_other_lobes_are_a_failure() {
    let mut row = row();
    row.samples = 100_000;
    row.add_switched(|| "here".into());
    assert!(row.failures().is_empty());
    (0..1000).for_each(|_| row.add_switched(|| "there".into()));
    assert_eq!(row.failures().len(), 1);
}

/// An error is relative to the brightest channel and to the floor; of what is not finite it is infinite.
#[test]
fn errors_are_relative_to_what_is_seen() {
    assert_eq!(relative([1.0, 0.5], [1.0, 0.5]), 0.0);
    let dark = relative([100.0, 0.5], [100.0, 0.0]);
    assert!((dark - 0.5 / (100.0 + FLOOR)).abs() < 1e-12);
    assert!((relative([0.0], [1e-6]) - 1e-3).abs() < 1e-5);
    assert_eq!(relative([f32::NAN, 0.0], [0.0, 0.0]), f64::INFINITY);
    assert_eq!(relative([f32::INFINITY], [1e30]), f64::INFINITY);
}

#[test]
fn tallies_count_and_remember() {
    let mut tally = Tally::default();
    for i in 1..=9999 {
        tally.add(1e-6 * f64::from(i) / 9999.0, || format!("{i}"));
    }
    let mut other = Tally::default();
    other.add(1.0, || "worst".into());
    tally.merge(other);
    assert_eq!((tally.count, tally.greatest()), (10_000, 1.0));
    assert_eq!(tally.worst.as_ref().unwrap().place, "worst");
    let most = tally.quantile(0.9999);
    assert!((1e-6..1.1e-6).contains(&most), "{most:e}");
    let half = tally.quantile(0.5);
    assert!((0.5e-6..0.55e-6).contains(&half), "{half:e}");
    assert_eq!(tally.quantile(1.0), 1.0);
}
