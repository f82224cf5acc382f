//! Films with media given by tables of measurements: lines narrower than any number of equidistant wavelengths, and
//! the range of wavelengths that a table speaks of.

use crate::common::films::{bare, constant, difference, medium, rounded};
use pellicle::Status;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};

/// An index that is `top` at `centers` and `around` from `half_width` on beside them, all nm.
fn lines(centers: &[f64], half_width: f64, around: [f64; 2], top: [f64; 2]) -> Medium {
    let mut rows = vec![(380.0, around), (780.0, around)];
    for center in centers {
        let [before, after] = [center - half_width, center + half_width];
        rows.extend([(before, around), (*center, top), (after, around)]);
    }
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    table(&rows)
}

fn table(rows: &[(f64, [f64; 2])]) -> Medium {
    let nm: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let [eta, k] = [0, 1].map(|part| rows.iter().map(|row| row.1[part]).collect::<Vec<_>>());
    Medium::table(&nm, &eta, &k).unwrap()
}

fn one_line(around: [f64; 2], top: [f64; 2]) -> Medium {
    lines(&[550.3], 0.3, around, top)
}

fn comb(around: [f64; 2], top: [f64; 2]) -> Medium {
    let centers: Vec<f64> = (0..39u8).map(|i| 391.37 + 9.87 * f64::from(i)).collect();
    lines(&centers, 0.1, around, top)
}

fn reference(description: &FilmDescription) -> Reference {
    let layers = description.layers.iter().map(|layer| layer.medium.clone());
    let (ambient, base) = (description.ambient.clone(), description.base.clone());
    Reference::new(
        ambient,
        layers.collect(),
        base,
        White::E,
        ColorSpace::Rec709,
    )
    .unwrap()
}

/// The reference agrees with a million wavelengths (`tests/optics/tables.rs`); films are held to it.
fn assert_tolerance(name: &str, description: &FilmDescription) -> Film {
    let film = Film::new(description).unwrap();
    let exact = reference(description);
    let plan = film.plan();
    assert!(
        plan.measured_max <= description.tolerance,
        "{name} {plan:?}"
    );
    let [least, greatest] = film.varying_thickness_nm().unwrap_or([0.0; 2]);
    for i in 0..60u8 {
        let fraction = |step: f64| (0.5 + step * f64::from(i)).fract();
        let c = (fraction(0.754_877_666) as f32).max(0.01);
        let d = (least + fraction(0.569_840_291) * (greatest - least)) as f32;
        let thicknesses: Vec<f64> = description
            .layers
            .iter()
            .map(|layer| f64::from(d).clamp(layer.thickness_nm[0], layer.thickness_nm[1]))
            .collect();
        let truth = exact.evaluate(Side::Ambient, f64::from(c), &thicknesses);
        let mut error = difference(film.reflectance(c, d), rounded(truth.reflectance));
        if description.transmittance {
            let found = film.colors(Side::Ambient, c, d).unwrap();
            error = error.max(difference(
                found.transmittance,
                rounded(truth.transmittance),
            ));
        }
        assert!(
            error <= description.tolerance,
            "{name} {c} {d}: {error:e} {plan:?}"
        );
    }
    film
}

/// Lines of a base and of a layer, of k and of eta, strong and faint: .013 before the reference knew of them.
#[test]
fn lines_hold_the_tolerance() {
    let sharp: [(&str, Medium); 6] = [
        ("one line", one_line([1.5, 0.0], [1.5, 20.0])),
        ("39 lines", comb([1.5, 0.0], [1.5, 20.0])),
        ("39 lines of eta", comb([1.5, 0.0], [2.6, 0.0])),
        ("faint lines", comb([1.5, 0.0], [1.5, 0.02])),
        (
            "a step",
            table(&[
                (380.0, [1.5, 0.0]),
                (549.99, [1.5, 0.0]),
                (550.0, [2.2, 0.0]),
                (780.0, [2.2, 0.0]),
            ]),
        ),
        (
            "two ends",
            table(&[
                (390.0, [1.5, 0.0]),
                (390.001, [1.5, 5.0]),
                (390.2, [1.5, 0.0]),
                (700.0, [1.5, 0.0]),
            ]),
        ),
    ];
    for (name, medium) in sharp {
        let base = bare(medium.clone());
        let glass = bare(constant(1.52, 0.0));
        let coated = base.clone().layer(constant(1.38, 0.0), [100.0; 2]);
        let layer = glass.clone().layer(medium.clone(), [0.0, 800.0]);
        let fixed = glass
            .layer(medium.clone(), [3000.0; 2])
            .layer(constant(2.1, 0.0), [90.0; 2]);
        for (description, tolerance, transmittance) in [
            (base, 2e-3, true),
            (coated, 2e-4, false),
            (layer.clone(), 1e-2, true),
            (layer, 2e-3, false),
            (fixed, 2e-3, true),
        ] {
            let description = FilmDescription {
                tolerance,
                transmittance,
                ..description
            };
            assert_tolerance(name, &description);
        }
    }
}

/// A method that is asked for by name is refused where it would claim more than it holds.
#[test]
fn equidistant_wavelengths_are_refused_lines() {
    let description = FilmDescription {
        method: Some("series".to_owned()),
        ..bare(constant(1.52, 0.0)).layer(comb([1.5, 0.0], [1.5, 20.0]), [0.0, 800.0])
    };
    let error = Film::new(&description).err().expect("series");
    assert_eq!(error.status, Status::Unsupported, "{error}");
    assert!(error.to_string().contains("tolerance"), "{error}");
}

/// Tables of smooth curves, as they are measured, cost what formulas cost.
#[test]
fn smooth_tables_become_tables_of_colors() {
    let sampled = |name: &str, step: f64| {
        let exact = medium(name);
        let rows = (0..=(420.0 / step) as u16).map(|i| {
            let nm = 370.3 + step * f64::from(i);
            let index = exact.index(nm);
            (nm, [index.re, index.im])
        });
        table(&rows.collect::<Vec<_>>())
    };
    for step in [20.0, 5.0, 1.0] {
        for description in [
            bare(sampled("Au", step)),
            bare(sampled("Ti", step)).layer(sampled("TiO2", step), [0.0, 400.0]),
            bare(sampled("BK7", step)).layer(sampled("MgF2", step), [0.0, 300.0]),
        ] {
            let film = assert_tolerance("smooth", &description);
            assert!(
                ["table", "schlick"].contains(&film.plan().method),
                "{step} {:?}",
                film.plan()
            );
        }
    }
}

#[test]
fn too_many_wavelengths_are_refused() {
    let dense = |count: u16, first: f64| {
        let rows = (0..count).map(|i| (first + f64::from(i) * 0.09, [1.5, 0.0]));
        table(&rows.collect::<Vec<_>>())
    };
    let base = bare(constant(1.5, 0.0));
    let at = |count, first| base.clone().layer(dense(count, first), [100.0; 2]);
    let error = Film::new(&at(4097, 390.0)).err().unwrap();
    assert_eq!(error.status, Status::OutOfRange);
    for part in ["table_nm", "4097", "[0, 4096]"] {
        assert!(error.to_string().contains(part), "{error}");
    }
    // What is outside the visible spectrum does not count.
    assert!(Film::new(&at(4096, 390.0)).is_ok());
    assert!(Film::new(&at(5000, 700.0)).is_ok());
    assert_eq!(at(4096, 390.0).nodes_nm().unwrap().len(), 4096);
    // Those of several media count together, and each once.
    let two = at(2050, 390.0).layer(dense(2050, 390.0), [10.0; 2]);
    assert_eq!(two.nodes_nm().unwrap().len(), 2050);
    let two = at(2050, 390.0).layer(dense(2050, 390.045), [10.0; 2]);
    assert_eq!(Film::new(&two).err().unwrap().status, Status::OutOfRange);
}

/// The right answer at 1,550 nm is .306; the data that the library has end at 780 nm, where silicon reflects .332.
#[test]
fn silicon_at_1550_nm_is_refused_unless_allowed() {
    let silicon = bare(medium("Si"));
    let film = Film::new(&silicon).unwrap();
    let error = film.spectrum(1.0, 0.0, 1550.0).unwrap_err();
    assert_eq!(error.status, Status::OutOfRange);
    for part in ["1550", "[380, 780]", "base", "extrapolate"] {
        assert!(error.to_string().contains(part), "{error}");
    }
    let allowed = Film::new(&FilmDescription {
        extrapolate: true,
        ..silicon
    });
    let found = allowed.unwrap().spectrum(1.0, 0.0, 1550.0).unwrap();
    assert!((found - 0.332).abs() < 1e-3, "{found}");
    // Measured data that reach there answer rightly: n = 3.478 (Li 1980).
    let measured = table(&[
        (380.0, [6.0, 0.5]),
        (780.0, [3.7, 0.0]),
        (1550.0, [3.478, 0.0]),
        (1600.0, [3.474, 0.0]),
    ]);
    let film = Film::new(&bare(measured)).unwrap();
    let found = film.spectrum(1.0, 0.0, 1550.0).unwrap();
    assert!((found - 0.306).abs() < 1e-3, "{found}");
    assert!(film.spectrum(1.0, 0.0, 1601.0).is_err());
}

/// Each kind of medium has its range, the film that of all; ends are included.
#[test]
fn ranges_of_wavelengths() {
    let measured = table(&[(400.0, [1.5, 0.0]), (700.0, [1.4, 0.0])]);
    let disperses = Medium::rgb([1.5, 1.51, 1.52], [0.0; 3]).unwrap();
    for (medium, range) in [
        (Medium::vacuum(), [0.0, f64::INFINITY]),
        (Medium::named("vacuum").unwrap(), [0.0, f64::INFINITY]),
        (constant(1.5, 0.2), [0.0, f64::INFINITY]),
        (disperses.clone(), [380.0, 780.0]),
        (medium("Au"), [380.0, 780.0]),
        (measured.clone(), [400.0, 700.0]),
        (table(&[(550.0, [1.5, 0.0])]), [550.0; 2]),
    ] {
        assert_eq!(medium.range_nm(), range);
        assert_eq!(bare(medium).range_nm(), range);
    }
    let mixed = FilmDescription {
        ambient: disperses,
        ..bare(medium("SiO2")).layer(measured, [100.0; 2])
    };
    assert_eq!(mixed.range_nm(), [400.0, 700.0]);
    let film = Film::new(&mixed).unwrap();
    for (nm, place) in [
        (399.9, Some("layers[0]")),
        (400.0, None),
        (700.0, None),
        (700.1, Some("layers[0]")),
        (379.0, Some("ambient")),
        (0.0, Some("above 0")),
        (-5.0, Some("above 0")),
        (f64::NAN, Some("finite")),
        (f64::INFINITY, Some("finite")),
    ] {
        match (film.spectrum(0.8, 0.0, nm), place) {
            (Ok(found), None) => assert!((0.0..0.2).contains(&found)),
            (Err(error), Some(place)) => {
                assert_eq!(error.status, Status::OutOfRange);
                assert!(error.to_string().contains(place), "{error}");
            }
            (found, _) => panic!("{nm}: {found:?}"),
        }
    }
    let wide = Film::new(&FilmDescription {
        extrapolate: true,
        ..mixed
    });
    let wide = wide.unwrap();
    assert!(wide.spectrum(0.8, 0.0, 2e4).is_ok());
    assert!(wide.spectrum(0.8, 0.0, -2e4).is_err());
}
