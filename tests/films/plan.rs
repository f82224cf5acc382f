//! What a film's plan chooses, and what it promises of that.

use super::plan_cases::*;
use crate::common::films::{bare, constant, medium, soap};
use pellicle::film::{Film, FilmDescription};
use pellicle::num::Rgb;
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};

/// A plan does not depend on time, threads or chance.
#[test]
fn a_plan_is_the_same_when_made_twice() {
    let forced = with("bands", 1e-2, &lens());
    for description in [soap(), forced, bare(medium("Au")), bare(constant(1.5, 0.0))] {
        let [a, b] = [(); 2].map(|()| film(&description));
        let plan = |film: &Film| format!("{:?}", film.plan());
        assert_eq!(plan(&a), plan(&b));
        for (c, d) in points(&a, 50) {
            assert_eq!(a.reflectance(c, d), b.reflectance(c, d));
        }
    }
}

/// A bare dielectric is planned as a closed form with the right ratio of indices, not as a table.
#[test]
fn a_bare_dielectric_is_fresnel() {
    for (ambient, base) in [(1.0, 1.5), (1.33, 1.5), (1.5, 1.33), (1.0, 1.0), (1.0, 4.0)] {
        let description = FilmDescription {
            ambient: constant(ambient, 0.0),
            ..bare(constant(base, 0.0))
        };
        let film = film(&description);
        assert_eq!((method(&film), film.plan().bytes), ("fresnel", 0));
        for i in 0..=200u16 {
            let c = f32::from(i) / 200.0;
            let truth = film.reference(f64::from(c), 0.0);
            let error = difference(film.reflectance(c, 0.0).map(f64::from), truth);
            // Close to the critical angle the rounding of the ratio of indices is magnified.
            let critical = (1.0f32 - (base / ambient).powi(2) as f32).max(0.0).sqrt();
            let is_critical = ambient > base && (c - critical).abs() < 0.02;
            let allowed = if is_critical { 1e-5 } else { 1e-6 };
            assert!(error <= allowed, "{ambient} {base} {c}: {error:e}");
        }
    }
}

/// Schlick's approximation is cheaper than Fresnel's equations, and must hold what was asked for.
#[test]
fn schlick_is_chosen_only_within_tolerance() {
    for eta in [1.2, 1.5, 2.4] {
        let mut chosen = Vec::new();
        for tolerance in [0.5, 0.1, 0.05, 0.02, 2e-3] {
            let description = FilmDescription {
                tolerance,
                ..bare(constant(eta, 0.0))
            };
            let film = film(&description);
            assert!(errors(&film, 400).0 <= tolerance, "{eta} {tolerance}");
            chosen.push(method(&film));
        }
        assert_eq!((chosen[0], chosen[4]), ("schlick", "fresnel"), "{eta}");
        assert!(chosen.is_sorted_by(|a, b| a == b || *b == "fresnel"));
    }
}

/// A film that depends on the cosine alone is a small table without a dimension for the thickness: bare gold,
/// and films of one thickness.
#[test]
fn what_has_one_thickness_is_a_small_table() {
    let fixed = STACKS.map(|media| stack(media, [320.0; 2]));
    for description in [bare(medium("Au"))].into_iter().chain(fixed) {
        let film = film(&description);
        let plan = film.plan();
        assert_eq!(method(&film), "table");
        assert!((1..8192).contains(&plan.bytes), "{plan:?}");
        let (max, _) = errors(&film, 300);
        assert!(max <= plan.tolerance, "{max:e} {plan:?}");
    }
}

/// A layer like its neighbour, or of no thickness, changes nothing. The plan leaves it out, unless its index
/// depends on the wavelength.
#[test]
fn a_layer_that_is_not_there_changes_nothing() {
    let (range, glass) = ([0.0, 1000.0], constant(1.5, 0.0));
    let vanishing = |base: &Medium| {
        [
            bare(base.clone()).layer(base.clone(), range),
            bare(base.clone()).layer(Medium::vacuum(), range),
            bare(base.clone()).layer(constant(1.0, 0.0), [400.0; 2]),
            bare(base.clone()).layer(medium("TiO2"), [0.0; 2]),
        ]
    };
    for base in [glass, medium("Au"), constant(1.5, 3.0)] {
        let alone = film(&bare(base.clone()));
        let tolerance = alone.plan().tolerance;
        for (i, description) in vanishing(&base).iter().enumerate() {
            let film = film(description);
            assert!(!base.absorbs() || method(&film) == "table");
            assert!(base.absorbs() || method(&film) == "fresnel");
            for (c, d) in points(&film, 300) {
                let [a, b] = [&film, &alone].map(|film| film.reflectance(c, d).map(f64::from));
                assert!(difference(a, b) <= tolerance, "{i} {c} {d}: {a:?} {b:?}");
            }
        }
    }
}

/// The films that most users make are small tables, with half the error that is allowed.
#[test]
fn common_films_are_tables_within_their_tolerance() {
    for media in STACKS {
        let film = film(&stack(media, [0.0, 1000.0]));
        let plan = film.plan();
        assert_eq!(method(&film), "table", "{media:?}: {plan:?}");
        assert!(plan.bytes <= 256 << 10, "{media:?}: {plan:?}");
        assert!(plan.measured_max <= plan.tolerance / 2.0, "{plan:?}");
        assert!(plan.measured_rms <= plan.measured_max, "{plan:?}");
        let (max, rms) = errors(&film, 300);
        println!("{media:?}: {max:.2e} {rms:.2e} {plan:?}");
        assert!(max <= plan.tolerance, "{media:?}: {max:e} {plan:?}");
        assert!(rms <= 5e-4, "{media:?}: {rms:e} {plan:?}");
    }
}

/// A plan tells each side's part: nothing of a side that no light comes from, the errors whose greatest is the plan's,
/// and the light that layers absorb, as the reference finds it.
#[test]
fn a_plan_tells_of_both_sides() {
    let named = |name| Medium::named(name).unwrap();
    let two_sided = |description: FilmDescription| FilmDescription {
        transmittance: true,
        ..description
    };
    let coated = || bare(named("BK7")).layer(named("MgF2"), [99.6; 2]);
    assert!(film(&coated()).plan().sides[1].is_none());
    let on_metal = bare(named("Au")).layer(named("MgF2"), [99.6; 2]);
    assert!(film(&two_sided(on_metal)).plan().sides[1].is_none());

    let lens = film(&two_sided(coated()));
    let [front, back] = lens.plan().sides.map(Option::unwrap);
    assert_eq!([front.method, back.method], ["table"; 2]);
    assert_eq!([front.absorbed_max, back.absorbed_max], [0.0; 2]);
    assert!(front.measured_max > 0.0 && back.measured_max > 0.0);
    // The base disperses: its critical angles need a coordinate of their own.
    assert!(0.0 < front.cost_ns && front.cost_ns < back.cost_ns);
    assert_eq!(
        lens.plan().measured_max,
        front.measured_max.max(back.measured_max)
    );
    assert_eq!(lens.plan().eta, [1.0, named("BK7").index(550.0).re]);

    for layer in [constant(1.5, 0.02), named("Au")] {
        let tinted = two_sided(bare(constant(1.5, 0.0)).layer(layer, [30.0; 2]));
        let tinted = film(&tinted);
        let reference = Reference::new(
            tinted.description().ambient.clone(),
            vec![tinted.description().layers[0].medium.clone()],
            tinted.description().base.clone(),
            tinted.description().white,
            tinted.description().color_space,
        );
        let reference = reference.unwrap();
        for side in [Side::Ambient, Side::Base] {
            let told = tinted.plan().sides[side as usize].unwrap().absorbed_max;
            let found = (1..=200).map(|i| {
                let found = reference.evaluate(side, f64::from(i) / 200.0, &[30.0]);
                let parts = found.reflectance.into_iter().zip(found.transmittance);
                parts.map(|(r, t)| 1.0 - r - t).fold(0.0, f64::max)
            });
            let greatest = found.fold(0.0, f64::max);
            assert!(told <= greatest + 2e-3, "{side:?}: {told} of {greatest}");
            assert!(told >= 0.9 * greatest, "{side:?}: {told} of {greatest}");
        }
    }
}

/// Soap along the surface: no film reflects nothing, the thinnest film everything. Both are 0 / 0 where a
/// table has no value; from a thousandth of a nanometre on, or a cosine of 1e-4, the tolerance holds.
#[test]
fn soap_holds_the_tolerance_where_cosine_and_thickness_vanish() {
    let film = film(&soap());
    let tolerance = film.plan().tolerance;
    let mut failures = Vec::new();
    for c in [0.0, 1e-40, 1e-20, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3] {
        for d in [0.0, 1e-5, 1e-4, 1e-3, 1e-2, 0.1] {
            let truth = film.reference(f64::from(c), f64::from(d));
            let found = film.reflectance(c, d).map(f64::from);
            assert!(found.iter().all(|r| (0.0..=1.0).contains(r)));
            if (d < 1e-3 && c < 1e-4) || difference(found, truth) <= tolerance {
                continue;
            }
            {
                failures.push(format!("cos {c:e}, {d:e} nm: {found:?} for {truth:?}"));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// Each method is used when asked for by name, says so, and holds the tolerance then, too.
#[test]
fn methods_are_forced_by_name() {
    let weak = stack(STACKS[1], [0.0, 1000.0]);
    let glass = bare(constant(1.5, 0.0));
    let two_sided = FilmDescription {
        transmittance: true,
        ..lens()
    };
    let cases = [
        ("schlick", 0.1, &glass),
        ("schlick", 0.5, &bare(medium("Au"))),
        ("fresnel", 1e-4, &glass),
        ("table", 1e-2, &weak),
        ("table", 2e-3, &glass),
        ("two_beam", 0.2, &weak),
        ("airy_rgb", 0.2, &weak),
        ("quadrature", 1e-2, &weak),
        ("harmonics", 2e-2, &weak),
        ("bands", 1e-2, &weak),
        ("bands", 1e-2, &soap()),
        ("series", 2e-3, &two_sided),
        ("reference", 2e-3, &two_sided),
    ];
    for (name, tolerance, description) in cases {
        let film = film(&with(name, tolerance, description));
        let plan = film.plan();
        assert_eq!((method(&film), plan.tolerance), (name, tolerance));
        let reason = plan.reason.as_str();
        assert!(reason.contains("asked for by name"), "{reason}");
        let (max, _) = errors(&film, 100);
        assert!(max <= tolerance, "{name} {tolerance}: {max:e} {plan:?}");
    }
    let named: Vec<_> = cases.iter().map(|case| case.0).collect();
    assert!(METHODS.iter().all(|name| named.contains(name)));
}

/// A better film may cost more, never less.
#[test]
fn bytes_grow_as_the_tolerance_shrinks() {
    let mut bytes = 0;
    for tolerance in [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4] {
        let film = film(&FilmDescription {
            tolerance,
            ..lens()
        });
        let plan = film.plan();
        assert_eq!(method(&film), "table");
        assert!(plan.bytes >= bytes, "{bytes} {plan:?}");
        assert!(plan.measured_max <= 0.5 * tolerance, "{plan:?}");
        bytes = plan.bytes;
    }
}

/// Colours outside \[0, 1\] come out where they are asked for, as good as inside, and only there. Soap
/// and gold have some.
#[test]
fn only_unclipped_films_leave_the_unit_range() {
    for description in [soap(), bare(medium("Au"))] {
        for unclipped in [false, true] {
            let film = film(&FilmDescription {
                unclipped,
                ..description.clone()
            });
            let found = |(c, d)| film.reflectance(c, d);
            let colors: Vec<_> = points(&film, 2000).into_iter().map(found).collect();
            let is_outside = |x: &f32| !(0.0..=1.0).contains(x);
            assert_eq!(colors.iter().flatten().any(is_outside), unclipped);
            if !unclipped {
                continue;
            }
            for (c, d) in points(&film, 200) {
                let truth = film.reference(f64::from(c), f64::from(d));
                let error = (0..3).map(|i| (f64::from(found((c, d))[i]) - truth[i]).abs());
                let error = error.fold(0.0, f64::max);
                assert!(error <= film.plan().tolerance, "{c} {d}: {error:e}");
            }
        }
    }
}

/// Whites and spaces are normalised alike: a mirror is white in all, and what has no colour is grey.
#[test]
fn mirrors_are_white_in_every_space_and_white() {
    use ColorSpace::{AcesCg, Rec709, Rec2020, Xyz};
    for white in [White::E, White::D65] {
        for color_space in [Rec709, Rec2020, AcesCg, Xyz] {
            let normal = |base: Medium| {
                let film = film(&FilmDescription {
                    white,
                    color_space,
                    unclipped: true,
                    ..bare(base)
                });
                film.reflectance(1.0, 0.0)
            };
            let is_near = |rgb: Rgb<f32>, x: f32, by: f32| rgb.iter().all(|c| (c - x).abs() <= by);
            assert!(is_near(normal(constant(1e-3, 100.0)), 1.0, 1e-3));
            assert!(is_near(normal(medium("Ag")), 0.95, 0.05));
            assert!(is_near(normal(constant(3.0, 0.0)), 0.25, 1e-3));
            assert!(!is_near(normal(medium("Au")), 0.95, 0.05));
        }
    }
}

/// Films up to a millimetre have no colours left, and take no more time than thin ones.
#[test]
fn thick_films_end_incoherent() {
    let media = [constant(1.0, 0.0), constant(1.5, 0.0), constant(1.33, 0.0)];
    let [ambient, layer, base] = media;
    let started = std::time::Instant::now();
    let film = film(&bare(base.clone()).layer(layer.clone(), [0.0, 1e6]));
    let seconds = started.elapsed().as_secs_f64();
    assert!(seconds < 10.0, "{seconds} s for {:?}", film.plan());
    let tolerance = film.plan().tolerance;
    // A boundary's powers by the reference, which has tests of its own, s and p.
    let boundary = |a: &Medium, b: &Medium, c: f64| {
        let (a, b) = (a.clone(), b.clone());
        let bare = Reference::new(a, Vec::new(), b, White::E, ColorSpace::Rec709).unwrap();
        bare.spectrum(Side::Ambient, c, &[], 550.0).reflectance
    };
    for c in [1.0f32, 0.7, 0.4, 0.15, 0.05, 0.01] {
        let inside = (1.0 - (1.0 - f64::from(c).powi(2)) / (1.5 * 1.5)).sqrt();
        let above = boundary(&ambient, &layer, f64::from(c));
        let below = boundary(&layer, &base, inside);
        let r: f64 = [0, 1]
            .map(|pol| {
                let (a, b) = (above[pol], below[pol]);
                0.5 * (a + (1.0 - a).powi(2) * b / (1.0 - a * b))
            })
            .iter()
            .sum();
        let found = film.reflectance(c, 1e6).map(f64::from);
        assert!(difference(found, [r; 3]) <= tolerance, "{c}: {found:?} {r}");
    }
    let (max, _) = errors(&film, 40);
    assert!(max <= tolerance, "{max:e} {:?}", film.plan());
}
