//! Ranges of thickness that are narrower than single precision, or than an atom by many orders.

use crate::common::films::constant;
use pellicle::film::{Film, FilmDescription};

/// Such a range is accepted, and every thickness in and beside it has the colours of the film that is fixed there.
#[test]
fn narrow_ranges_are_like_fixed_thicknesses() {
    let ranges = [
        [0.0, 1.2e-41],
        [0.0, 1e-9],
        [784.35, 784.350_1],
        [1_000.000_02, 1_000.000_04],
        [3e5, 3e5 + 0.04],
    ];
    for range in ranges {
        let film = |range| {
            let description = FilmDescription::new(constant(1.5, 0.0));
            Film::new(&description.layer(constant(2.2, 0.0), range)).unwrap()
        };
        let (varying, fixed) = (film(range), film([range[0]; 2]));
        for cos_theta in [1.0, 0.4, 0.01] {
            let expected = fixed.reflectance(cos_theta, 0.0);
            for thickness_nm in [0.0, range[0] as f32, range[1] as f32, 1e8] {
                let found = varying.reflectance(cos_theta, thickness_nm);
                for (found, expected) in found.into_iter().zip(expected) {
                    let at = format!("{range:?} {cos_theta} {thickness_nm}");
                    assert!((found - expected).abs() < 4e-3, "{at}: {found} {expected}");
                }
            }
        }
    }
}
