//! A compiled film when it is called: arguments of any kind, limits, smoothness, and both sides.

mod common;

use common::films::{constant, medium};
use common::rng;
use pellicle::film::{Film, FilmDescription};
use pellicle::math::Rgb;
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};
use rand::RngExt;
use std::sync::OnceLock;

/// What films are compiled to; several films of a kind.
struct Subject {
    name: &'static str,
    film: Film,
}

fn bare(base: Medium) -> FilmDescription {
    FilmDescription::new(base)
}

fn soap() -> FilmDescription {
    bare(constant(1.0, 0.0)).layer(constant(1.33, 0.0), [0.0, 1000.0])
}

/// The inner face of a prism.
fn prism() -> FilmDescription {
    FilmDescription {
        ambient: constant(1.5, 0.0),
        ..bare(Medium::vacuum()).layer(constant(1.38, 0.0), [0.0, 400.0])
    }
}

/// Absorbing glass on glass: the sides differ.
fn tinted() -> FilmDescription {
    let base = bare(constant(1.5, 0.0));
    base.layer(constant(1.8, 0.1), [0.0, 500.0])
}

fn two_sided(description: FilmDescription) -> FilmDescription {
    FilmDescription {
        transmittance: true,
        ..description
    }
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

fn range(film: &Film) -> [f32; 2] {
    film.varying_thickness_nm()
        .unwrap_or([0.0; 2])
        .map(|d| d as f32)
}

fn difference(a: Rgb<f32>, b: Rgb<f32>) -> f64 {
    let pairs = a.into_iter().zip(b);
    pairs
        .map(|(a, b)| (f64::from(a) - f64::from(b)).abs())
        .fold(0.0, f64::max)
}

fn rounded(rgb: Rgb<f64>) -> Rgb<f32> {
    rgb.map(|x| x.clamp(0.0, 1.0) as f32)
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

/// Against reading beside a table: arguments are held in their ranges, where values are those at the ends.
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
            // And the ends continue what is inside.
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

/// Between like media a film of no thickness is nothing, along the surface too, where every film mirrors,
/// the thinnest one that absorbs as well; from both sides.
#[test]
fn between_like_media_films_mirror_along_the_surface_and_no_film_is_nothing() {
    let glass = constant(1.8216633, 0.0);
    let between = FilmDescription {
        ambient: constant(1.2629267, 0.0),
        ..bare(constant(1.2629267, 0.0)).layer(glass, [0.0, 3000.0])
    };
    let two_sided = FilmDescription {
        transmittance: true,
        ..between.clone()
    };
    let absorbing = bare(constant(1.0, 0.0)).layer(constant(2.2242265, 0.6072897), [0.0, 248.6]);
    let exact = FilmDescription {
        tolerance: 2e-4,
        ..absorbing.clone()
    };
    for description in [between, two_sided, absorbing, exact, soap()] {
        let film = Film::new(&description).unwrap();
        let sides = if description.transmittance { 2 } else { 1 };
        for side in [Side::Ambient, Side::Base].into_iter().take(sides) {
            for c in [0.0, 1e-6, 1e-3, 0.1, 1.0] {
                let expected = |thickness| film.reference(c, thickness)[1];
                for (thickness, expected) in [
                    (0.0, 0.0),
                    (0.0016, expected(f64::from(0.0016f32))),
                    (100.0, expected(100.0)),
                ] {
                    let found = match description.transmittance {
                        true => film.colors(side, c as f32, thickness).unwrap().reflectance,
                        false => film.reflectance(c as f32, thickness),
                    };
                    let error = (f64::from(found[1]) - expected).abs();
                    assert!(error <= film.plan().tolerance, "{c} {thickness}: {found:?}");
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
        assert_eq!(coated.plan().method, c"table");
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

/// Against seams between the pieces of a spline, and between values that are read and weighted: small
/// steps make small differences.
#[test]
fn neighbours_are_alike() {
    for Subject { name, film } in subjects() {
        let [least, greatest] = range(film);
        // What is truly steep: grazing angles, and the critical angle of the prism.
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

/// Cosine on the far side of half-spaces whose indices have that ratio, near over far; beyond the
/// critical angle none.
fn refracted(c: f32, ratio: f64) -> Option<f32> {
    let square = 1.0 - ratio * ratio * (1.0 - f64::from(c).powi(2));
    (square > 0.0).then(|| square.sqrt() as f32)
}

/// What is not reflected is transmitted if nothing absorbs, from both sides, clipped or not.
#[test]
fn lossless_films_conserve_power() {
    let dispersive = bare(medium("BK7")).layer(medium("MgF2"), [0.0, 600.0]);
    for description in [soap(), prism(), dispersive] {
        for unclipped in [false, true] {
            let description = FilmDescription {
                unclipped,
                ..description.clone()
            };
            let film = Film::new(&two_sided(description)).unwrap();
            let mut rng = rng(17);
            for _ in 0..500 {
                let (c, d) = (rng.random(), 700.0 * rng.random::<f32>());
                for side in [Side::Ambient, Side::Base] {
                    let colors = film.colors(side, c, d).unwrap();
                    for (r, t) in colors.reflectance.into_iter().zip(colors.transmittance) {
                        assert!((r + t - 1.0).abs() < 1e-6, "{side:?} {c} {d}: {r} {t}");
                        assert!(unclipped || (0.0..=1.0).contains(&r) && (0.0..=1.0).contains(&t));
                    }
                }
            }
        }
    }
}

/// Stokes' reversion of light: as much passes either way at angles that belong together, whether or not
/// the film absorbs.
#[test]
fn transmittance_is_the_same_from_both_sides() {
    for (description, ratio) in [(tinted(), 1.0 / 1.5), (prism(), 1.5), (soap(), 1.0)] {
        let film = Film::new(&two_sided(description)).unwrap();
        let tolerance = film.plan().tolerance;
        for i in 1..=100u16 {
            let c = f32::from(i) / 100.0;
            let Some(beyond) = refracted(c, ratio) else {
                continue;
            };
            for d in [0.0, 30.0, 200.0, 400.0] {
                let there = film.colors(Side::Ambient, c, d).unwrap().transmittance;
                let back = film.colors(Side::Base, beyond, d).unwrap().transmittance;
                let change = difference(there, back);
                assert!(change <= 2.0 * tolerance, "{ratio} {c} {d}: {change:e}");
            }
        }
    }
}

/// Beyond the critical angle all light returns, but for what an absorbing layer takes.
#[test]
fn total_reflection_is_total_only_without_absorption() {
    let clear = bare(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [0.0, 500.0]);
    for (description, side) in [
        (clear, Side::Base),
        (prism(), Side::Ambient),
        (tinted(), Side::Base),
    ] {
        let absorbs = description.layers[0].medium.absorbs();
        let film = Film::new(&two_sided(description)).unwrap();
        let critical = (1.0f32 - 1.0 / 2.25).sqrt();
        for part in [0.0, 0.1, 0.4, 0.8, 0.99] {
            for d in [20.0, 200.0, 400.0] {
                let colors = film.colors(side, part * critical, d).unwrap();
                assert_eq!(colors.transmittance, [0.0; 3]);
                if !absorbs {
                    assert_eq!(colors.reflectance, [1.0; 3], "{part} {d}");
                } else if part > 0.0 {
                    assert!(colors.reflectance.iter().all(|r| *r < 0.99), "{part} {d}");
                }
            }
        }
    }
}

/// The worst point of a film that keeps both sides: the error, and where it is.
fn worst(description: FilmDescription) -> (f64, String) {
    let description = two_sided(description);
    let layers = description.layers.iter().map(|layer| layer.medium.clone());
    let (ambient, base) = (description.ambient.clone(), description.base.clone());
    let (white, space) = (White::E, ColorSpace::Rec709);
    let reference = Reference::new(ambient, layers.collect(), base, white, space).unwrap();
    let film = Film::new(&description).unwrap();
    let greatest = range(&film)[1];
    let mut rng = rng(18);
    let mut worst = (0.0, String::new());
    for i in 0..200u8 {
        // A quarter each close to the critical angles of glass and of magnesium fluoride on it.
        let mut c: f32 = rng.random();
        match i % 4 {
            0 => c = 0.752 + 0.02 * (c - 0.5),
            1 => c = 0.418 + 0.02 * (c - 0.5),
            _ => (),
        }
        let d = greatest * rng.random::<f32>();
        let layers = description.layers.iter().map(|layer| layer.thickness_nm);
        let held = layers.map(|[min, max]| f64::from(d).clamp(min, max));
        let thicknesses: Vec<_> = held.collect();
        for side in [Side::Ambient, Side::Base] {
            let truth = reference.evaluate(side, f64::from(c), &thicknesses);
            let found = film.colors(side, c, d).unwrap();
            let [r, t] = [
                (found.reflectance, truth.reflectance),
                (found.transmittance, truth.transmittance),
            ]
            .map(|(found, truth)| difference(found, rounded(truth)));
            if r.max(t) > worst.0 {
                let place = format!("R {r:.1e} T {t:.1e} {side:?} {c} {d} {:?}", film.plan());
                worst = (r.max(t), place);
            }
        }
    }
    worst
}

/// From the base's side, too, the tolerance holds: below and beyond the critical angle, with absorption
/// and with indices that depend on the wavelength.
#[test]
fn both_sides_hold_the_tolerance() {
    let sunglasses = bare(medium("BK7"))
        .layer(medium("TiO2"), [0.0, 300.0])
        .layer(medium("Au"), [10.0; 2]);
    let lens = bare(medium("BK7")).layer(medium("MgF2"), [0.0, 600.0]);
    for description in [tinted(), prism(), sunglasses, lens] {
        let (error, place) = worst(description);
        assert!(error <= 2e-3, "{error:e} {place}");
    }
}

/// In glass that disperses each colour has critical angles of its own: between them the spectrum has an
/// edge, which few wavelengths miss.
#[test]
fn a_dispersive_ambient_holds_the_tolerance_near_critical_angles() {
    let prism = FilmDescription {
        ambient: medium("BK7"),
        ..bare(Medium::vacuum())
    };
    for description in [prism.clone(), prism.layer(medium("MgF2"), [0.0, 300.0])] {
        let (error, place) = worst(description);
        assert!(error <= 2e-3, "{error:e} {place}");
    }
}

/// Where light in a layer whose index depends on the wavelength begins to go along it, its wave number
/// passes through 0 within the spectrum.
#[test]
fn a_dispersive_layer_holds_the_tolerance_at_its_critical_angle() {
    let description = FilmDescription {
        ambient: constant(1.5, 0.0),
        ..bare(medium("SiO2")).layer(medium("MgF2"), [0.0, 300.0])
    };
    let film = Film::new(&description).unwrap();
    let mut failures = Vec::new();
    for i in 0..=24u8 {
        let c = 0.388 + 0.000_5 * f32::from(i);
        for d in [20.0, 150.0, 300.0] {
            let truth = rounded(film.reference(f64::from(c), f64::from(d)));
            let error = difference(film.reflectance(c, d), truth);
            if error > film.plan().tolerance {
                failures.push(format!("cos {c} {d} nm: {error:.1e}"));
            }
        }
    }
    assert!(failures.is_empty(), "{:?}: {failures:#?}", film.plan());
}
