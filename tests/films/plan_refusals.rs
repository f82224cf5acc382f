//! What a film's plan refuses, and what it says.

use super::plan_cases::*;
use crate::common::films::{bare, constant, medium, soap};
use pellicle::Status;
use pellicle::film::{FilmDescription, LEAST_TOLERANCE};

/// A method asked for by name that cannot hold the tolerance is refused, with a message that helps.
#[test]
fn a_forced_method_that_cannot_hold_the_tolerance_is_refused() {
    let glass = bare(constant(1.5, 0.0));
    let cases = [
        ("schlick", 2e-3, &glass),
        ("two_beam", 2e-2, &soap()),
        ("airy_rgb", 2e-2, &soap()),
        ("quadrature", 1e-4, &soap()),
        ("harmonics", 2e-3, &soap()),
        ("bands", 1e-5, &soap()),
    ];
    for (name, tolerance, description) in cases {
        let (status, message) = refusal(&with(name, tolerance, description));
        assert_eq!(status, Status::Unsupported);
        assert!(message.contains(&format!("'{name}'")), "{message}");
        assert!(message.contains(&format!("{tolerance:.2e}")), "{message}");
        let (_, best) = message.split_once("best it can do is ").expect(&message);
        let best: f64 = best.split([',', ' ']).next().unwrap().parse().unwrap();
        let allowed = if name == "schlick" { 1.0 } else { 0.5 };
        assert!(
            best >= 0.99 * allowed * tolerance && best < 1.0,
            "{message}"
        );
    }
}

/// A method refuses layers, absorption or a second side that it does not take, instead of ignoring them.
#[test]
fn a_method_that_does_not_take_the_film_is_refused() {
    let lens = lens();
    let two_layers = lens.clone().layer(constant(2.0, 0.0), [50.0; 2]);
    let two_sided = FilmDescription {
        transmittance: true,
        ..lens.clone()
    };
    let (gold, dispersive) = (bare(medium("Au")), bare(medium("BK7")));
    let one_layer = ONE_LAYER
        .iter()
        .flat_map(|name| [&two_layers, &two_sided, &gold].map(|description| (*name, description)));
    let bare = [
        ("schlick", &lens),
        ("schlick", &two_sided),
        ("fresnel", &lens),
        ("fresnel", &gold),
        ("fresnel", &dispersive),
    ];
    for (name, description) in one_layer.chain(bare) {
        let (status, message) = refusal(&with(name, 1.0, description));
        assert_eq!(status, Status::Unsupported, "{message}");
        assert!(message.contains(&format!("'{name}' takes")), "{message}");
    }
}

#[test]
fn an_unknown_method_is_answered_with_the_names() {
    for name in ["magic", "", "Table", "table "] {
        let (status, message) = refusal(&with(name, 2e-3, &lens()));
        assert_eq!(status, Status::UnknownName);
        assert!(message.contains(&format!("'{name}'")), "{message}");
        assert!(METHODS.iter().all(|known| message.contains(known)));
    }
}

#[test]
fn tolerances_have_a_range() {
    let at = |tolerance: f64| FilmDescription {
        tolerance,
        ..bare(constant(1.5, 0.0))
    };
    for tolerance in [LEAST_TOLERANCE, f64::from(1e-5f32), 1.0] {
        film(&at(tolerance));
    }
    for tolerance in [0.9e-5, 0.0, -1e-3, 1.01, f64::INFINITY, f64::NAN] {
        let (status, message) = refusal(&at(tolerance));
        assert_eq!(status, Status::OutOfRange);
        assert!(
            message.contains(&format!("tolerance = {tolerance}")),
            "{message}"
        );
    }
}
