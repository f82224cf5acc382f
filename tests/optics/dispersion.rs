//! Media: named ones against published values, three numbers, measured tables, and what is refused.

use pellicle::Status;
use pellicle::optics::{Complex, Medium, NamedMedium};

fn eta(name: &str, nm: f64) -> f64 {
    Medium::named(name).unwrap().index(nm).re
}

#[test]
fn named_media_have_their_published_indices() {
    // Sodium d 587.56 nm, mercury e 546.07 nm, hydrogen F' 479.99 and C' 643.85 nm (cadmium).
    let published = [
        ("vacuum", 500.0, 1.0, 0.0),
        ("air", 587.56, 1.000277, 1e-6),        // Ciddor 1996
        ("water", 600.0, 1.332, 5e-4),          // Hale and Querry 1973, table
        ("silica", 587.56, 1.45846, 1e-4),      // Malitson 1965, table
        ("MgF2", 587.56, 1.37774, 1e-4),        // Dodge 1984, table
        ("sapphire", 587.56, 1.76823, 2e-4),    // Malitson and Dodge 1972
        ("BK7", 587.56, 1.51680, 1e-5),         // the data sheet's n_d
        ("BK7", 486.13, 1.52238, 1e-5),         // ... n_F
        ("acrylic", 587.56, 1.491, 1e-3),       // Sultanova et al. 2009, table
        ("oil", 546.07, 1.5180, 5e-4),          // ISO 8036: n_e = 1.5180 +- 0.0005
        ("TiO2", 589.3, 2.6124, 0.0151 + 1e-3), // DeVore 1951
        ("Au", 579.4, 0.29, 0.0456),            // Johnson and Christy 1972, 2.14 eV
        ("Si", 563.6, 4.042, 0.0454),           // Aspnes and Studna 1983, 2.2 eV
        ("a-TiO2", 587.56, 2.42869, 1e-4),      // Jolivet 2023, table, interpolated
        ("Ta2O5", 588.0, 2.1461, 1e-4),         // Gao et al. 2012, table
        ("Nb2O5", 590.0, 2.3393, 2e-4),         // Lemarchand 2013, table
        ("Si3N4", 632.8, 2.0394, 1e-4),         // Luke 2015, formula, evaluated by numpy
        ("Si3N4", 587.56, 2.0167, 0.035),       // Philipp 1973, another sample
        ("ZnS", 589.3, 2.3677, 1e-3),           // Debenham 1984, another sample
        ("ITO", 587.56, 1.82701, 1e-4),         // König 2014, table, interpolated
        ("polystyrene", 587.56, 1.592, 1e-3),   // Sultanova et al. 2009, table
        ("SF11", 587.56, 1.78472, 1e-5),        // the data sheet's n_d
        ("SF11", 486.13, 1.80645, 1e-5),        // ... n_F
        ("SF11", 656.27, 1.77599, 1e-5),        // ... n_C
    ];
    for (name, nm, expected, tolerance) in published {
        let found = eta(name, nm);
        assert!(
            (found - expected).abs() <= tolerance,
            "{name} at {nm} nm: {found}, not {expected}"
        );
    }
    let gold = Medium::named("gold").unwrap().index(579.4);
    assert!((gold.im - 2.863).abs() < 0.0357, "{gold:?}");
    // The tables of the same sources, k.
    for (name, nm, expected, tolerance) in [
        ("a-TiO2", 587.56, 0.0, 0.0),
        ("Ta2O5", 400.0, 3.27e-4, 1e-5),
        ("Nb2O5", 400.0, 1.046e-3, 3.5e-5),
        ("ZnS", 400.0, 1.92e-3, 4e-5),
        ("ITO", 587.56, 3.10e-3, 3e-5),
        ("SF11", 587.56, 0.0, 0.0),
    ] {
        let found = Medium::named(name).unwrap().index(nm).im;
        assert!(
            (found - expected).abs() <= tolerance,
            "{name} at {nm} nm: k = {found}"
        );
    }
    // ISO 8036 also wants an Abbe number v_e = 44 +- 3.
    let abbe = (eta("oil", 546.07) - 1.0) / (eta("oil", 479.99) - eta("oil", 643.85));
    assert!((abbe - 44.0).abs() < 3.0, "{abbe}");
}

#[test]
fn every_named_medium_is_sane() {
    for named in NamedMedium::all() {
        let medium = Medium::named(named.name).unwrap();
        assert!(!named.source.is_empty());
        for alias in named.aliases {
            let other = Medium::named(alias).unwrap();
            assert_eq!(medium.index(500.0), other.index(500.0), "{alias}");
        }
        let mut last = medium.index(380.0);
        for step in 0..=4000 {
            let nm = 380.0 + f64::from(step) * 0.1;
            let index = medium.index(nm);
            assert!(
                index.re > 0.01 && index.re < 8.0,
                "{} at {nm}: {index:?}",
                named.name
            );
            assert!(
                index.im >= 0.0 && index.im < 10.0,
                "{} at {nm}: {index:?}",
                named.name
            );
            assert!(
                (index.re - last.re).abs() < 0.02,
                "{} at {nm}: {index:?}",
                named.name
            );
            assert!(
                named.absorbs() || index.im == 0.0 && index.re >= 1.0,
                "{}",
                named.name
            );
            last = index;
        }
        assert_eq!(medium.index(200.0), medium.index(380.0), "{}", named.name);
        assert_eq!(medium.index(1e4), medium.index(780.0), "{}", named.name);
        assert_eq!(medium.absorbs(), named.absorbs());
        assert_eq!(
            medium.check_ambient().is_ok(),
            !named.absorbs(),
            "{}",
            named.name
        );
    }
    let everyday = [
        ("gold", "Au"),
        ("silver", "Ag"),
        ("copper", "Cu"),
        ("aluminum", "Al"),
        ("Aluminium", "Al"),
        ("water", "H2O"),
        ("silica", "SiO2"),
        ("glass", "BK7"),
        ("acrylic", "PMMA"),
        ("IRON", "Fe"),
    ];
    for (alias, name) in everyday {
        assert_eq!(NamedMedium::find(alias).unwrap().name, name);
    }
}

#[test]
fn unknown_names_list_the_known_ones() {
    let error = Medium::named("unobtainium").unwrap_err();
    assert_eq!(error.status, Status::UnknownName);
    assert!(
        error
            .message
            .starts_with("unknown medium 'unobtainium'; known: vacuum, air, Ag, silver")
    );
    for named in NamedMedium::all() {
        assert!(error.message.contains(named.name));
    }
}

#[test]
fn three_numbers() {
    let medium = Medium::rgb([1.4, 1.45, 1.6], [0.0, 0.2, 0.1]).unwrap();
    let close = |found: Complex<f64>, eta: f64, k: f64| {
        assert!(
            (found.re - eta).abs() < 1e-14 && (found.im - k).abs() < 1e-14,
            "{found:?}"
        );
    };
    close(medium.index(645.0), 1.4, 0.0);
    close(medium.index(525.0), 1.45, 0.2);
    close(medium.index(445.0), 1.6, 0.1);
    // Half way in 1 / lambda^2.
    let between = |a: f64, b: f64| (0.5 * (a.powi(-2) + b.powi(-2))).sqrt().recip();
    close(medium.index(between(645.0, 525.0)), 1.425, 0.1);
    close(medium.index(between(525.0, 445.0)), 1.525, 0.15);
    close(medium.index(700.0), 1.4, 0.0);
    close(medium.index(400.0), 1.6, 0.1);
    assert!(medium.constant().is_none() && medium.absorbs());

    let constant = Medium::rgb([1.37; 3], [0.3; 3]).unwrap();
    for nm in 300..900 {
        assert_eq!(constant.index(f64::from(nm)), Complex::new(1.37, 0.3));
    }
    assert_eq!(constant.constant(), Some(Complex::new(1.37, 0.3)));
    assert_eq!(Medium::vacuum().constant(), Some(Complex::real(1.0)));
    assert_eq!(
        Medium::named("vacuum").unwrap().constant(),
        Some(Complex::real(1.0))
    );
    assert!(Medium::named("air").unwrap().constant().is_none());
}

#[test]
fn measured_tables() {
    let medium = Medium::table(&[400.0, 500.0, 700.0], &[1.5, 1.4, 1.2], &[0.0, 0.1, 0.5]).unwrap();
    let expected = [
        (300.0, 1.5, 0.0),
        (400.0, 1.5, 0.0),
        (450.0, 1.45, 0.05),
        (500.0, 1.4, 0.1),
        (550.0, 1.35, 0.2),
        (700.0, 1.2, 0.5),
        (900.0, 1.2, 0.5),
    ];
    for (nm, eta, k) in expected {
        let found = medium.index(nm);
        assert!(
            (found.re - eta).abs() < 1e-14 && (found.im - k).abs() < 1e-14,
            "{nm}: {found:?}"
        );
    }
    let single = Medium::table(&[550.0], &[1.5], &[0.0]).unwrap();
    assert_eq!(single.index(400.0), Complex::real(1.5));
    assert_eq!(single.constant(), Some(Complex::real(1.5)));
}

#[test]
fn wrong_numbers_are_refused_by_name_and_value() {
    let refused = |medium: Result<Medium, pellicle::Error>, status, words: &str| {
        let error = medium.unwrap_err();
        assert_eq!(error.status, status, "{error}");
        assert!(
            error.message.contains(words),
            "'{error}' does not say '{words}'"
        );
    };
    let out = Status::OutOfRange;
    refused(
        Medium::rgb([1.0, -0.5, 1.0], [0.0; 3]),
        out,
        "eta[1] = -0.5 is outside [0.001, 1000]",
    );
    refused(
        Medium::rgb([1.0; 3], [0.0, 0.0, -1.0]),
        out,
        "k[2] = -1 is outside [0, 1000]",
    );
    refused(Medium::rgb([f64::NAN; 3], [0.0; 3]), out, "eta[0] = NaN");
    refused(Medium::rgb([1.0; 3], [f64::INFINITY; 3]), out, "k[0] = inf");
    refused(Medium::rgb([0.0; 3], [3.0; 3]), out, "eta[0] = 0");
    let table = |nm: &[f64], eta: &[f64], k: &[f64]| Medium::table(nm, eta, k);
    refused(
        table(&[], &[], &[]),
        Status::InvalidArgument,
        "at least 1, not 0, 0 and 0",
    );
    refused(
        table(&[500.0], &[1.0, 2.0], &[0.0]),
        Status::InvalidArgument,
        "not 1, 2 and 1",
    );
    refused(
        table(&[500.0, 500.0], &[1.0; 2], &[0.0; 2]),
        out,
        "table_nm[1] = 500 does not ascend from 500",
    );
    refused(table(&[f64::NAN], &[1.0], &[0.0]), out, "table_nm[0] = NaN");
    refused(table(&[500.0], &[2e3], &[0.0]), out, "table_eta[0] = 2000");
    refused(table(&[500.0], &[1.0], &[-0.1]), out, "table_k[0] = -0.1");
    let thin = Medium::rgb([1.5, 1.5, 0.9], [0.0; 3])
        .unwrap()
        .check_ambient()
        .unwrap_err();
    assert!(
        thin.message.contains("eta of the ambient medium[2] = 0.9"),
        "{thin}"
    );
}
