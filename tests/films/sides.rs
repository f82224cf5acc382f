//! A compiled film from both sides: power, reversion, critical angles, and where cosine and thickness vanish.

use crate::common::films::{
    bare, constant, difference, medium, prism, range, rounded, soap, tinted, two_sided,
};
use crate::common::rng;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};
use rand::RngExt;

/// Between equal media a film of no thickness reflects nothing, at grazing angles too, from both sides. Any
/// other film mirrors along the surface, even the thinnest one that absorbs.
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

/// Cosine on the far side of half-spaces whose indices have that ratio, near over far; beyond the
/// critical angle none.
fn refracted(c: f32, ratio: f64) -> Option<f32> {
    let square = 1.0 - ratio * ratio * (1.0 - f64::from(c).powi(2));
    (square > 0.0).then(|| square.sqrt() as f32)
}

/// If nothing absorbs, R + T = 1 from both sides, clipped or not.
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

/// Beyond the critical angle all light returns that no layer absorbs.
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

/// The greatest error of a film with both sides at some points (cosine, thickness), and where it is.
fn worst_of(film: &Film, points: &[(f32, f32)]) -> (f64, String) {
    let description = film.description();
    let layers = description.layers.iter().map(|layer| layer.medium.clone());
    let (ambient, base) = (description.ambient.clone(), description.base.clone());
    let (white, space) = (White::E, ColorSpace::Rec709);
    let reference = Reference::new(ambient, layers.collect(), base, white, space).unwrap();
    let mut worst = (0.0, String::new());
    for &(c, d) in points {
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

/// The greatest error at points scattered over a film.
fn worst(description: FilmDescription) -> (f64, String) {
    let film = Film::new(&two_sided(description)).unwrap();
    let greatest = range(&film)[1];
    let mut rng = rng(18);
    let points = (0..200u8).map(|i| {
        // A quarter each close to the critical angles of glass and of magnesium fluoride on it.
        let mut c: f32 = rng.random();
        match i % 4 {
            0 => c = 0.752 + 0.02 * (c - 0.5),
            1 => c = 0.418 + 0.02 * (c - 0.5),
            _ => (),
        }
        (c, greatest * rng.random::<f32>())
    });
    worst_of(&film, &points.collect::<Vec<_>>())
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

/// Where light begins to go along a layer or the far side, a root begins: tables have a seam there. Both sides,
/// from a single rounding of the cosine away to where the table is smooth; thinnest films too, which light tunnels
/// through.
#[test]
fn tables_hold_the_tolerance_at_critical_angles() {
    let lens = bare(constant(1.52, 0.0)).layer(constant(1.38, 0.0), [0.0, 1000.0]);
    let lens_of_one = bare(constant(1.52, 0.0)).layer(constant(1.38, 0.0), [100.0; 2]);
    let oil = bare(constant(1.33, 0.0)).layer(constant(1.47, 0.0), [0.0, 1000.0]);
    let three = bare(constant(1.52, 0.0))
        .layer(constant(1.38, 0.0), [0.0, 300.0])
        .layer(constant(2.1, 0.0), [120.0; 2])
        .layer(constant(1.62, 0.0), [80.0; 2]);
    let steps = [1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3];
    for description in [prism(), lens, lens_of_one, oil, three, tinted()] {
        let film = Film::new(&two_sided(description)).unwrap();
        assert_eq!(film.plan().method, "table");
        let description = film.description();
        let layers = description.layers.iter().map(|layer| &layer.medium);
        let media = layers.chain([&description.ambient, &description.base]);
        let indices: Vec<f64> = media.map(|medium| medium.index(550.0).re).collect();
        let [_, greatest] = range(&film);
        let mut points = Vec::new();
        for near in film.half_spaces().map(|medium| medium.index(550.0).re) {
            for index in indices.iter().filter(|index| **index < near) {
                let critical = (1.0 - (index / near).powi(2)).sqrt();
                let around = steps.into_iter().flat_map(|step| [-step, 0.0, step]);
                points.extend(around.flat_map(|step| {
                    [0.0, 0.001, 0.07, 0.5, 1.0]
                        .map(|part| ((critical + step) as f32, part * greatest))
                }));
            }
        }
        assert!(!points.is_empty());
        let (error, place) = worst_of(&film, &points);
        assert!(error <= film.plan().tolerance, "{error:e} {place}");
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

/// Tables of glass that disperses hold the tolerance where total reflection begins for one wavelength after another:
/// from the back of bare and coated glass, and from within glass towards water. The points are within the interval of
/// critical cosines over 380-780 nm, at its ends, and from a rounding to a hundredth beside them.
#[test]
fn tables_of_dispersing_half_spaces_hold_the_tolerance_at_critical_angles() {
    let bk7 = || bare(medium("BK7"));
    let into_water = FilmDescription {
        ambient: medium("BK7"),
        ..bare(medium("H2O"))
    };
    let films = [
        ("bare glass", bk7(), medium("vacuum")),
        (
            "lens",
            bk7().layer(medium("MgF2"), [99.6; 2]),
            medium("vacuum"),
        ),
        (
            "lens of any thickness",
            bk7().layer(medium("MgF2"), [0.0, 300.0]),
            medium("vacuum"),
        ),
        ("glass in water", into_water, medium("H2O")),
    ];
    for (name, description, rarer) in films {
        let glass = medium("BK7");
        let critical = |nm| (1.0 - (rarer.index(nm).re / glass.index(nm).re).powi(2)).sqrt();
        let [first, last] = [critical(780.0), critical(380.0)];
        assert!((0.001..0.03).contains(&(last - first)), "{first} {last}");
        let mut cosines: Vec<f64> = (0..=40u8)
            .map(|i| first + (last - first) * f64::from(i) / 40.0)
            .collect();
        for end in [first, last] {
            cosines.extend((2..=7).flat_map(|digits| {
                let step = 0.1_f64.powi(digits);
                [end - step, end + step]
            }));
        }
        for tolerance in [2e-3, 2e-4] {
            let description = FilmDescription {
                tolerance,
                ..two_sided(description.clone())
            };
            let film = Film::new(&description).unwrap();
            assert_eq!(film.plan().method, "table", "{name} {:?}", film.plan());
            let [_, greatest] = range(&film);
            let parts = if greatest > 0.0 {
                &[0.0, 0.02, 0.33, 1.0][..]
            } else {
                &[0.0]
            };
            let points = cosines.iter().flat_map(|c| {
                let at = |part: &f32| (*c as f32, part * greatest);
                parts.iter().map(at).collect::<Vec<_>>()
            });
            let (error, place) = worst_of(&film, &points.collect::<Vec<_>>());
            assert!(error <= tolerance, "{name} {error:e} {place}");
        }
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
