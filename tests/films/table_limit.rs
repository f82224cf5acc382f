//! The largest tables that a plan makes, and a film for which even those are too small.

#![allow(unsafe_code)] // batches go by addresses

use crate::common::films::{bare, constant, medium};
use pellicle::Status;
use pellicle::batch::{ConstView, FilmArgs, View, film_reflectance};
use pellicle::film::{Film, FilmDescription};
use pellicle::num::Level;

/// What src/film/plan/planner.rs allows: 2^17 values of four numbers in single precision, 2 MiB.
const MOST_BYTES: usize = 16 << 17;
const TOLERANCE: f64 = 3e-5;
const THICKNESS_NM: f32 = 1e5;

/// Glass on a metal, so thick that it has hundreds of fringes, asked for as a table.
fn description(tolerance: f64) -> FilmDescription {
    FilmDescription {
        method: Some("table".into()),
        tolerance,
        ..bare(medium("Al")).layer(constant(1.5, 0.0), [0.0, THICKNESS_NM.into()])
    }
}

#[test]
fn a_table_near_the_limit_holds_its_tolerance_up_to_its_edges() {
    let film = Film::new(&description(TOLERANCE)).unwrap();
    let bytes = film.plan().bytes;
    assert!(
        (3 * MOST_BYTES / 4..=MOST_BYTES).contains(&bytes),
        "{bytes} bytes"
    );
    let edges = [0.0, f32::MIN_POSITIVE, 1e-4, 0.3, 0.999_999_94, 1.0];
    let inputs: Vec<[f32; 2]> = edges
        .into_iter()
        .flat_map(|cosine| edges.map(|part| [cosine, part * THICKNESS_NM]))
        .chain([[2.0, 2.0 * THICKNESS_NM], [-1.0, -1.0], [f32::INFINITY; 2]])
        .collect();
    let mut found = vec![[f32::NAN; 3]; inputs.len()];
    let view = |component: usize| ConstView {
        data: &raw const inputs[0][component],
        element_stride: 8,
        component_stride: 4,
    };
    let args = FilmArgs {
        thickness_spread_nm: ConstView::NONE,
        count: inputs.len(),
        cos_theta: view(0),
        thickness_nm: view(1),
        reflectance: View {
            data: found.as_mut_ptr().cast(),
            element_stride: 12,
            component_stride: 4,
        },
    };
    // SAFETY: all views are of arrays of as many elements.
    unsafe { film_reflectance(&film, &args, Level::widest()) }.unwrap();
    for ([cosine, thickness_nm], found) in inputs.into_iter().zip(found) {
        assert_eq!(film.reflectance(cosine, thickness_nm), found);
        let truth = film.reference(f64::from(cosine).max(1e-9), thickness_nm.into());
        for (found, truth) in found.into_iter().zip(truth) {
            let error = (f64::from(found) - truth.clamp(0.0, 1.0)).abs();
            assert!(error <= TOLERANCE, "{error} at {cosine}, {thickness_nm} nm");
        }
    }
}

#[test]
fn a_film_for_which_no_table_is_large_enough_is_refused() {
    let error = Film::new(&description(1e-5)).err().unwrap();
    assert_eq!(error.status, Status::Unsupported);
    let expected = "no table that is small enough does";
    assert!(error.message.contains(expected), "{error}");
}
