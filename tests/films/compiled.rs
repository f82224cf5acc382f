//! A compiled film when it is called: arguments of any kind, limits and smoothness.

use crate::common::films::{
    bare, constant, difference, medium, prism, range, soap, tinted, two_sided,
};
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::Side;
use std::sync::OnceLock;

/// What films are compiled to; several films of a kind.
struct Subject {
    name: &'static str,
    film: Film,
}

/// One for each way in which a film can be compiled, made once.
fn subjects() -> &'static [Subject] {
    static SUBJECTS: OnceLock<Vec<Subject>> = OnceLock::new();
    SUBJECTS.get_or_init(|| {
        let forced = |method: &str, tolerance: f64, description: FilmDescription| FilmDescription {
            method: Some(method.into()),
            tolerance,
            ..description
        };
        let glass = || bare(constant(1.5, 0.0));
        let coated = || glass().layer(constant(1.38, 0.0), [50.0, 700.0]);
        let subjects = [
            ("fresnel", glass()),
            ("schlick", forced("schlick", 0.2, glass())),
            (
                "curve",
                bare(medium("Au")).layer(medium("SiO2"), [300.0; 2]),
            ),
            ("soap", soap()),
            ("coated", coated()),
            (
                "unclipped",
                FilmDescription {
                    unclipped: true,
                    ..soap()
                },
            ),
            (
                "metal",
                bare(medium("Ti")).layer(medium("TiO2"), [0.0, 300.0]),
            ),
            ("prism", prism()),
            ("both sides", two_sided(tinted())),
            ("two_beam", forced("two_beam", 0.5, coated())),
            ("airy_rgb", forced("airy_rgb", 0.5, coated())),
            ("quadrature", forced("quadrature", 2e-2, coated())),
            ("harmonics", forced("harmonics", 2e-2, coated())),
            ("bands", forced("bands", 2e-2, coated())),
            ("series", forced("series", 1e-2, coated())),
            ("reference", forced("reference", 1e-2, coated())),
        ];
        let compile = |(name, description): (&'static str, FilmDescription)| Subject {
            name,
            film: Film::new(&description).unwrap(),
        };
        subjects.into_iter().map(compile).collect()
    })
}

const COSINES: [f32; 10] = [
    0.0,
    1e-40,
    1e-20,
    1e-6,
    1e-3,
    0.03,
    0.3,
    0.7,
    0.999_999_9,
    1.0,
];
const BELOW: [f32; 4] = [-1e-40, -0.0, -2.0, f32::NEG_INFINITY];
const ABOVE: [f32; 3] = [1.000_000_1, 2.0, f32::INFINITY];
/// Thicker than any range.
const THICKER: [f32; 4] = [1001.0, 1e8, f32::MAX, f32::INFINITY];

/// Arguments are clamped to their ranges, so that nothing is read beside a table.
#[test]
fn arguments_outside_their_ranges_are_those_at_the_ends() {
    for Subject { name, film } in subjects() {
        let [least, greatest] = range(film);
        for c in COSINES {
            let at = |d: f32| film.reflectance(c, d);
            for d in BELOW.into_iter().chain([0.5 * least, least.next_down()]) {
                assert_eq!(at(d), at(least), "{name} {c} {d}");
            }
            for d in THICKER.into_iter().chain([greatest.next_up()]) {
                assert_eq!(at(d), at(greatest), "{name} {c} {d}");
            }
        }
        for part in [0.0, 0.3, 1.0] {
            let d = least + part * (greatest - least);
            let at = |c: f32| film.reflectance(c, d);
            for c in BELOW {
                assert_eq!(at(c), at(0.0), "{name} {c} {d}");
            }
            for c in ABOVE {
                assert_eq!(at(c), at(1.0), "{name} {c} {d}");
            }
            // The ends continue the values inside.
            assert!(
                difference(at(1.0), at(1.0f32.next_down())) < 1e-5,
                "{name} {d}"
            );
            assert!(difference(at(0.0), at(1e-40)) < 1e-5, "{name} {d}");
        }
    }
}

#[test]
fn nan_gives_zero() {
    for Subject { name, film } in subjects() {
        let zero = [0.0; 3];
        for x in [0.0, 0.5, 1.0, 300.0, f32::INFINITY, f32::NAN] {
            assert_eq!(film.reflectance(f32::NAN, x), zero, "{name} {x}");
            assert_eq!(film.reflectance(x, f32::NAN), zero, "{name} {x}");
        }
        for side in [Side::Ambient, Side::Base] {
            for (c, d) in [(f32::NAN, 100.0), (0.5, f32::NAN)] {
                if let Ok(colors) = film.colors(side, c, d) {
                    assert_eq!((colors.reflectance, colors.transmittance), (zero, zero));
                }
            }
        }
    }
}

/// Every value is finite, and within \[0, 1\] unless it may be outside, at extreme arguments too.
#[test]
fn every_value_is_finite() {
    let tiny = f32::MIN_POSITIVE;
    let extremes = [
        tiny,
        -tiny,
        tiny / 8.0,
        f32::MAX,
        f32::MIN,
        f32::EPSILON,
        1e-3,
        0.1,
        6.0,
    ];
    for Subject { name, film } in subjects() {
        let [least, greatest] = range(film);
        let steps = (0..=20u8).map(|i| f32::from(i) / 20.0);
        let inside = steps.map(|part| least + part * (greatest - least));
        let thicknesses: Vec<f32> = inside.chain(BELOW).chain(THICKER).chain(extremes).collect();
        let cosines = COSINES
            .into_iter()
            .chain(BELOW)
            .chain(ABOVE)
            .chain(extremes);
        let allowed = if film.description().unclipped {
            -0.5..=1.5
        } else {
            0.0..=1.0
        };
        for c in cosines {
            for &d in &thicknesses {
                let found = film.reflectance(c, d);
                assert!(
                    found.iter().all(|x| allowed.contains(x)),
                    "{name} {c} {d} {found:?}"
                );
                for side in [Side::Ambient, Side::Base] {
                    let Ok(colors) = film.colors(side, c, d) else {
                        continue;
                    };
                    let both = [colors.reflectance, colors.transmittance];
                    assert!(
                        both.iter().flatten().all(|x| allowed.contains(x)),
                        "{name} {c} {d}"
                    );
                }
            }
        }
    }
}

/// A film that thins out becomes the bare base: no fading, no switch, no jump at the last nanometre.
#[test]
fn a_vanishing_film_is_the_bare_base() {
    let films = [
        soap(),
        prism(),
        tinted(),
        bare(medium("Ti")).layer(medium("TiO2"), [0.0, 300.0]),
        bare(constant(1.5, 3.0)).layer(constant(1.5, 0.0), [0.0, 1000.0]),
    ];
    for description in films {
        let coated = Film::new(&description).unwrap();
        let bare = Film::new(&FilmDescription {
            layers: Vec::new(),
            ..description
        })
        .unwrap();
        assert_eq!(coated.plan().method, "table");
        let tolerance = coated.plan().tolerance;
        for i in 0..=300u16 {
            // Not along the surface: what is there grows with thickness over cosine.
            let c = (0.05 + 0.95 * f32::from(i) / 300.0).min(1.0);
            let at = |d: f32| coated.reflectance(c, d);
            let error = difference(at(0.0), bare.reflectance(c, 0.0));
            assert!(
                error <= 2.0 * tolerance,
                "{:?} {c}: {error:e}",
                bare.description().base
            );
            assert!(difference(at(0.0), at(1e-3)) < 1e-4, "{c}");
        }
    }
}

/// Small steps make small differences: there are no seams between the cells of a table.
#[test]
fn neighbours_are_alike() {
    for Subject { name, film } in subjects() {
        let [least, greatest] = range(film);
        // Steep places are left out: grazing angles, and the critical angle of the prism.
        let critical = (1.0f32 - 1.0 / 2.25).sqrt();
        let is_steep = |c: f32| c < 0.05 || (*name == "prism" && (c - critical).abs() < 0.02);
        // The reference and the series are slow, and their steps are tested with them.
        let count = if ["series", "reference"].contains(name) {
            100u16
        } else {
            10_000
        };
        for part in [0.0, 0.013, 0.37, 0.81, 1.0] {
            let d = least + part * (greatest - least);
            for i in 0..count {
                let c = f32::from(i) / f32::from(count);
                if !is_steep(c) {
                    let [a, b] = [c, c + 1e-4].map(|c| film.reflectance(c, d));
                    let change = difference(a, b);
                    assert!(change < 2.5e-3, "{name} {c} {d}: {change:e}");
                }
            }
        }
        for c in [1.0, 0.4, 0.06] {
            for i in 0..count {
                let d = least + f32::from(i) / f32::from(count) * (greatest - least);
                let [a, b] = [d, d + 0.05].map(|d| film.reflectance(c, d));
                let change = difference(a, b);
                assert!(change < 2.5e-3, "{name} {c} {d}: {change:e}");
            }
        }
    }
}
