//! Layers and colours against numbers made by other people's code: `tests/data/tmm_vectors.csv`,
//! written by `tests/data/tmm_vectors.py` (the Python package tmm 0.2.0; how to run it is there).

use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::{Layer, P, S, Side, Stack};
use pellicle::optics::{Amplitudes, ColorSpace, Complex, Medium, Reference, White};

type Index = Complex<f64>;

fn index(eta: f64, k: f64) -> Index {
    Index::new(eta, k)
}

fn film(eta: f64, k: f64, thickness_nm: f64) -> Layer<f64> {
    Layer {
        index: index(eta, k),
        thickness_nm,
    }
}

fn quarter_wave(pairs: usize) -> Vec<Layer<f64>> {
    let pair = [2.35, 1.46].map(|eta| film(eta, 0.0, 525.0 / 4.0 / eta));
    pair.repeat(pairs)
}

/// The stacks of the script, written down a second time.
fn stack(name: &str) -> (f64, Vec<Layer<f64>>, Index) {
    match name {
        "glass" => (1.0, vec![], index(1.5, 0.0)),
        "soap" => (1.0, vec![film(1.33, 0.0, 300.0)], index(1.0, 0.0)),
        "coating" => (1.0, vec![film(1.38, 0.0, 99.6)], index(1.52, 0.0)),
        "titania on titanium" => (1.0, vec![film(2.4, 0.0, 60.0)], index(2.9, 3.1)),
        "absorbing film" => (1.0, vec![film(2.5, 0.8, 80.0)], index(1.5, 0.0)),
        "thin gold" => (1.0, vec![film(0.3, 2.5, 20.0)], index(1.5, 0.0)),
        "thick gold" => (1.0, vec![film(0.3, 2.5, 5000.0)], index(1.5, 0.0)),
        "perfect metal" => (1.0, vec![film(1.5, 0.0, 200.0)], index(1.0, 1000.0)),
        "dense ambient" => (1.5, vec![film(1.0, 0.0, 250.0)], index(1.5, 0.0)),
        "dense ambient on metal" => (1.5, vec![film(1.33, 0.0, 150.0)], index(0.05, 3.7)),
        "surface plasmon" => (1.515, vec![film(0.06, 3.6, 48.0)], index(1.0, 0.0)),
        "mirror" => (1.0, quarter_wave(8), index(1.52, 0.0)),
        "cavity" => {
            let half = quarter_wave(4);
            let spacer = film(1.46, 0.0, 525.0 / 2.0 / 1.46);
            let layers = half
                .iter()
                .copied()
                .chain([spacer])
                .chain(half.iter().rev().copied());
            (1.0, layers.collect(), index(1.52, 0.0))
        }
        "lossy mix" => {
            let layers = [
                film(1.45, 0.0, 100.0),
                film(0.2, 3.3, 15.0),
                film(2.1, 0.01, 200.0),
            ];
            (1.0, layers.to_vec(), index(4.1, 0.05))
        }
        "64 layers" => {
            let layer = |i: usize| {
                let k = if i.is_multiple_of(5) { 0.002 } else { 0.0 };
                film(1.4 + 0.01 * (i % 7) as f64, k, 40.0 + 3.0 * (i % 11) as f64)
            };
            (1.0, (0..64).map(layer).collect(), index(1.7, 0.0))
        }
        "thick soap" => (1.0, vec![film(1.33, 0.0, 1e5)], index(1.0, 0.0)),
        _ => panic!("no stack '{name}'"),
    }
}

/// A stack of media, by name: layers, base, thicknesses.
fn media(name: &str) -> (Vec<Medium>, Medium, Vec<f64>) {
    let named = |name| Medium::named(name).unwrap();
    let constant = |eta| Medium::rgb([eta; 3], [0.0; 3]).unwrap();
    match name {
        "bare gold" => (vec![], named("gold"), vec![]),
        "soap" | "soap at a grazing angle" => (vec![constant(1.33)], constant(1.0), vec![400.0]),
        "silica on silicon" => (vec![named("silica")], named("silicon"), vec![250.0]),
        "titania on titanium" => (vec![named("TiO2")], named("Ti"), vec![80.0]),
        "thick lacquer on aluminium" => (vec![constant(1.5)], named("aluminium"), vec![3000.0]),
        _ => panic!("no stack '{name}'"),
    }
}

/// The lines of one section of the file, in fields.
fn lines(section: &str) -> impl Iterator<Item = Vec<&'static str>> {
    let text = include_str!("../data/tmm_vectors.csv");
    let from = text.find(section).expect("the section");
    let body = text[from..].lines().skip(1);
    body.take_while(|line| !line.starts_with('#'))
        .map(|line| line.split(',').collect())
}

fn number(field: &str) -> f64 {
    field.parse().unwrap()
}

#[test]
fn reflectance_and_transmittance_agree_with_tmm() {
    let mut worst = (0.0, String::new());
    let mut count = 0;
    for fields in lines("# stack, side") {
        let (ambient, layers, base) = stack(fields[0]);
        let side = if fields[1] == "base" {
            Side::Base
        } else {
            Side::Ambient
        };
        let stack = Stack {
            ambient,
            layers: &layers,
            base,
        };
        let found = stack.respond(side, number(fields[3]), number(fields[2]));
        let all = [found.reflectance, found.transmittance];
        for (found, expected) in all.as_flattened().iter().zip(&fields[4..]) {
            let error = (found - number(expected)).abs();
            assert!(!error.is_nan(), "{fields:?}");
            if error > worst.0 {
                worst = (error, format!("{fields:?}"));
            }
            count += 1;
        }
    }
    println!(
        "greatest error of {count} numbers: {:.2e} at {}",
        worst.0, worst.1
    );
    assert!(count > 700, "only {count} numbers were compared");
    assert!(worst.0 < 2e-12, "{worst:?}");
}

/// The film of a stack, which the reference evaluates: nothing is compiled.
fn film_of(name: &str) -> Film {
    let (ambient, layers, base) = stack(name);
    let constant = |index: Index| Medium::rgb([index.re; 3], [index.im; 3]).unwrap();
    let mut description = FilmDescription {
        ambient: constant(index(ambient, 0.0)),
        method: Some("reference".into()),
        ..FilmDescription::new(constant(base))
    };
    for layer in layers {
        description = description.layer(constant(layer.index), [layer.thickness_nm; 2]);
    }
    Film::new(&description).unwrap()
}

/// Signs, phases and the time convention are tmm's. The error is that of the lanes' sine and cosine, 1e-11,
/// which resonances magnify.
#[test]
fn amplitudes_agree_with_tmm() {
    let mut worst = (0.0, String::new());
    let mut film = (String::new(), None);
    let mut count = 0;
    for fields in lines("# amplitudes") {
        if film.0 != fields[0] {
            film = (fields[0].to_owned(), Some(film_of(fields[0])));
        }
        let side = if fields[1] == "base" {
            Side::Base
        } else {
            Side::Ambient
        };
        let mut found = [Amplitudes::default(); 3];
        let nm = number(fields[2]);
        let wavelengths = [nm + 1.0, nm, nm - 2.0];
        let film = film.1.as_ref().unwrap();
        film.amplitudes(side, number(fields[3]), 0.0, &wavelengths, &mut found)
            .unwrap();
        let Amplitudes {
            reflection: [r_s, r_p],
            transmission: [t_s, t_p],
        } = found[1];
        let parts = [r_s, r_p, t_s, t_p].map(|value| [value.re, value.im]);
        for (found, expected) in parts.as_flattened().iter().zip(&fields[4..]) {
            let error = (found - number(expected)).abs();
            assert!(!error.is_nan(), "{fields:?}");
            if error > worst.0 {
                worst = (error, format!("{fields:?}"));
            }
            count += 1;
        }
    }
    println!(
        "greatest error of {count} numbers: {:.2e} at {}",
        worst.0, worst.1
    );
    assert!(count > 800, "only {count} numbers were compared");
    assert!(worst.0 < 1e-9, "{worst:?}");
}

#[test]
fn colors_agree_with_an_independent_integration() {
    let mut worst: f64 = 0.0;
    for fields in lines("# stack, white") {
        let (layers, base, thickness_nm) = media(fields[0]);
        let white = White::named(fields[1]).unwrap();
        let reference =
            Reference::new(Medium::vacuum(), layers, base, white, ColorSpace::Rec709).unwrap();
        let found = reference.evaluate(Side::Ambient, number(fields[2]), &thickness_nm);
        for (found, expected) in found.reflectance.iter().zip(&fields[3..]) {
            let error = (found - number(expected)).abs();
            println!("{} {}: {found:.7}, error {error:.1e}", fields[0], fields[1]);
            worst = worst.max(error);
        }
    }
    println!("greatest error {worst:.2e}");
    assert!(worst < 3e-5, "{worst}");
}

#[test]
fn single_precision_follows() {
    // The same formulas in f32: what they lose is their rounding, and the digits of the phase.
    let mut worst: f32 = 0.0;
    for fields in lines("# stack, side").filter(|fields| fields[0] != "thick soap") {
        let (ambient, layers, base) = stack(fields[0]);
        let single = |index: Index| Complex::new(index.re as f32, index.im as f32);
        let layers: Vec<_> = layers
            .iter()
            .map(|layer| Layer {
                index: single(layer.index),
                thickness_nm: layer.thickness_nm as f32,
            })
            .collect();
        let stack = Stack {
            ambient: ambient as f32,
            layers: &layers,
            base: single(base),
        };
        let side = if fields[1] == "base" {
            Side::Base
        } else {
            Side::Ambient
        };
        let found = stack.respond(side, number(fields[3]) as f32, number(fields[2]) as f32);
        for (pol, field) in [(S, 4), (P, 5)] {
            let error = (found.reflectance[pol] - number(fields[field]) as f32).abs();
            assert!(!error.is_nan(), "{fields:?}");
            worst = worst.max(error);
        }
    }
    println!("greatest error in single precision: {worst:.1e}");
    assert!(worst < 2e-5, "{worst}");
}
