//! The plan respects the atlas: over its scenes, swept coarsely, it never chooses a method where the map shows an
//! error beyond the tolerance asked for.

use super::axis::ANGLE;
use super::map::Map;
use super::scene::{self, Across, Scene, Truth};
use crate::shared::peer::{Compiled, FORCED, Peer, harmonics, method_of, uses};
use crate::shared::stack::{Stack, clipped_error};
use pellicle::film::OneLayerMethod as Kind;
use rayon::prelude::*;

/// Cells on either side of a map; the atlas has 28.
const CELLS: usize = 10;
/// What is asked for.
const TOLERANCES: [f64; 2] = [1e-2, 2e-3];

/// Every method for one film, in sizes that a plan tries.
fn kinds() -> Vec<Kind> {
    let mut kinds = vec![Kind::TwoBeam, Kind::AiryRgb];
    kinds.extend([4, 8, 16, 32, 64].map(Kind::Quadrature));
    kinds.extend([8, 16, 32, 64, 128, 256].map(Kind::Bands));
    kinds.extend([2, 3, 16].map(harmonics));
    kinds
}

/// The greatest error of a film over a scene that it was compiled for once.
fn greatest_error(peer: Peer, scene: &Scene, truth: &Truth) -> f64 {
    let map = Map::new(peer, scene, truth);
    assert_eq!(map.not_finite, 0, "{} {}", scene.name, peer.title());
    map.worst.value
}

/// Scenes with the thickness across: one film each. The very thick ones are left to `./x atlas`: their
/// plans alone take as long as all the rest.
fn films() -> Vec<Scene> {
    let scenes = [scene::thicknesses(), scene::corners()].concat();
    let is_thin = |scene: &Scene| scene.across == Across::Thickness && scene.x.last <= 1e3;
    scenes.into_iter().filter(is_thin).collect()
}

/// Whether plans hold their tolerance over one scene and choose no method that fails there; how often one fails.
fn cross(scene: &Scene) -> usize {
    let truth = scene.truth(CELLS).unwrap();
    let error = |kind: &Kind| greatest_error(Peer::Method(*kind), scene, &truth);
    let errors: Vec<(Kind, f64)> = kinds().iter().map(|kind| (*kind, error(kind))).collect();
    let mut failing = 0;
    for tolerance in TOLERANCES {
        let compiled = scene.compile(Peer::Planned(tolerance), scene.x.first);
        let Compiled::Film(film) = compiled else {
            panic!("{}: no plan holds {tolerance}", scene.name);
        };
        for (kind, error) in &errors {
            let is_failing = *error > tolerance;
            failing += usize::from(is_failing);
            assert!(
                !(is_failing && uses(&film, *kind)),
                "{}: {kind:?} is off by {error:.1e} and chosen for {tolerance:e}: {:?}",
                scene.name,
                film.plan()
            );
        }
        let error = greatest_error(Peer::Planned(tolerance), scene, &truth);
        assert!(
            error <= tolerance,
            "{}: {error:.1e} {:?}",
            scene.name,
            film.plan()
        );
    }
    failing
}

#[test]
fn plans_choose_no_method_where_the_atlas_shows_it_fail() {
    let failing: usize = films().par_iter().map(cross).sum();
    // Else nothing was tried: most methods fail on most films.
    assert!(failing >= 100, "{failing}");
}

/// Over indices and extinctions, where a film has one thickness.
#[test]
fn plans_hold_their_tolerance_at_every_index() {
    scene::indices().par_iter().for_each(|scene| {
        let truth = scene.truth(CELLS).unwrap();
        for tolerance in TOLERANCES {
            let error = greatest_error(Peer::Planned(tolerance), scene, &truth);
            assert!(
                error <= tolerance,
                "{}: {error:.1e} for {tolerance:e}",
                scene.name
            );
        }
    });
}

/// A method asked for by name is refused wherever its map passes the tolerance.
#[test]
fn forced_methods_are_refused_where_the_atlas_shows_them_fail() {
    const TOLERANCE: f64 = 2e-3;
    let scenes: Vec<Scene> = films()
        .into_iter()
        .filter(|scene| scene.y == ANGLE)
        .collect();
    let truths: Vec<Truth> = scenes
        .iter()
        .map(|scene| scene.truth(CELLS).unwrap())
        .collect();
    let jobs: Vec<(&str, usize)> = FORCED
        .iter()
        .flat_map(|method| (0..scenes.len()).map(move |i| (*method, i)))
        .collect();
    let refused = jobs.par_iter().map(|(method, i)| {
        let map = Map::new(Peer::Forced(method, TOLERANCE), &scenes[*i], &truths[*i]);
        let error = map.worst.value;
        assert!(
            error <= TOLERANCE,
            "{method} {}: {error:.1e}",
            scenes[*i].name
        );
        map.refusal.is_some()
    });
    let refused: Vec<bool> = refused.collect();
    let of = |method: &str| {
        let own = jobs.iter().zip(&refused).filter(|(job, _)| job.0 == method);
        own.filter(|(_, is_refused)| **is_refused).count()
    };
    let counts = FORCED.map(of);
    assert_eq!(counts[..2], [scenes.len(); 2], "{counts:?}");
    assert!((1..scenes.len()).contains(&counts[2]), "{counts:?}");
    assert_eq!(counts[5], 0, "{counts:?}");
}

/// At a critical angle the wave beyond is the root of a difference of squares that cancels: bands in single
/// precision were off by 3.7e-4 for the first film, which the plan allowed 2e-4, and by 5.2e-3 for the second.
/// The cosines are single precision's neighbours of the critical one.
#[test]
fn critical_angles_hold_the_tolerance() {
    let cases = [
        ([1.5, 1.2, 1.3], Peer::Planned(2e-4)),
        ([1.5, 4.0, 1.0], Peer::Forced("bands", 2e-3)),
        ([1.5, 1.38, 1.0], Peer::Forced("bands", 2e-4)),
    ];
    for ([ambient, film, base], peer) in cases {
        let mut scene = scene::thicknesses().remove(0);
        scene.stack = Stack::constant([[ambient, 0.0], [film, 0.0], [base, 0.0]]);
        let Compiled::Film(compiled) = scene.compile(peer, scene.x.first) else {
            panic!("{ambient} {film} {base}: refused");
        };
        if let Peer::Forced(name, _) = peer {
            assert_eq!(method_of(&compiled), name);
        }
        let mut greatest = 0.0f64;
        for index in [film, base].into_iter().filter(|index| *index < ambient) {
            let critical = (1.0 - (index / ambient).powi(2)).sqrt() as f32;
            for bits in critical.to_bits() - 40..=critical.to_bits() + 40 {
                let cos_theta = f32::from_bits(bits);
                for thickness_nm in [0.01, 0.434, 5.0, 50.0, 200.0, 1000.0] {
                    let found = compiled.reflectance(cos_theta, thickness_nm);
                    let truth = compiled.reference(f64::from(cos_theta), f64::from(thickness_nm));
                    greatest = greatest.max(clipped_error(found, truth));
                }
            }
        }
        let tolerance = compiled.plan().tolerance;
        assert!(
            greatest <= tolerance,
            "{ambient} {film} {base}: {greatest:.1e} {tolerance:e}"
        );
    }
}

/// Light in glass before a gap of hardly any air goes through; three harmonics reflect all of it at the critical
/// angle alone, where scattered points miss it: they were found to hold 0.3, and were off by 0.94.
#[test]
fn methods_are_measured_at_critical_angles() {
    let mut scene = scene::thicknesses().remove(0);
    scene.stack = Stack::constant([[1.5, 0.0], [1.0, 0.0], [1.5, 0.0]]);
    let compiled = scene.compile(Peer::Forced("harmonics", 0.3), scene.x.first);
    assert!(matches!(compiled, Compiled::Refused(_)));
}
