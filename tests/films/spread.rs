//! Spreads of thickness against quadrature over the reference, and laws of their averages.
#![allow(unsafe_code)] // addresses of batches

use crate::common::films::constant;
use crate::common::rng;
use pellicle::batch::{ConstView, FilmArgs, View, film_reflectance};
use pellicle::bsdf::{Call, Flags};
use pellicle::film::{Film, FilmDescription};
use pellicle::num::Level;
use pellicle::optics::stack::Side;
use pellicle::optics::{Medium, Reference};
use pellicle::{Bsdf, Description, Error, Status};
use rand::{Rng, RngExt};
use std::sync::Arc;

/// Reflectance and transmittance.
type Found = [[f64; 3]; 2];

/// Gauss's rule of three nodes in panels that resolve the distribution and the fringes, over converged colours.
fn truth(
    description: &FilmDescription,
    reference: &Reference,
    side: Side,
    [c, d, deviation]: [f64; 3],
) -> Found {
    const GAUSS: [(f64, f64); 3] = [
        (-0.774_596_669_241_483_4, 5.0 / 9.0),
        (0.0, 8.0 / 9.0),
        (0.774_596_669_241_483_4, 5.0 / 9.0),
    ];
    let varying = description.varying().unwrap();
    let [least, greatest] = description.layers[varying].thickness_nm;
    let from = least.max(d - 6.0 * deviation);
    let to = greatest.min(d + 6.0 * deviation);
    let index = description.layers[varying].medium.index(550.0);
    let panel = (0.5 * deviation).min(20.0 / index.re.hypot(index.im).max(1.0));
    let panels = ((to - from) / panel).ceil();
    let width = (to - from) / panels;
    let (mut sums, mut total) = ([[0.0; 3]; 2], 0.0);
    for i in 0..panels as usize {
        for (x, weight) in GAUSS {
            let t = from + (i as f64 + 0.5 * (1.0 + x)) * width;
            let weight = weight * (-0.5 * ((t - d) / deviation).powi(2)).exp();
            let mut thicknesses: Vec<f64> = description
                .layers
                .iter()
                .map(|layer| layer.thickness_nm[0])
                .collect();
            thicknesses[varying] = t;
            let found = reference.evaluate(side, c, &thicknesses);
            for (sum, rgb) in sums
                .iter_mut()
                .zip([found.reflectance, found.transmittance])
            {
                for channel in 0..3 {
                    sum[channel] += weight * rgb[channel];
                }
            }
            total += weight;
        }
    }
    sums.map(|sum| sum.map(|x| x / total))
}

fn reference(description: &FilmDescription) -> Reference {
    let layers = description.layers.iter().map(|layer| layer.medium.clone());
    Reference::new(
        description.ambient.clone(),
        layers.collect(),
        description.base.clone(),
        description.white,
        description.color_space,
    )
    .unwrap()
}

fn named(name: &str) -> Medium {
    Medium::named(name).unwrap()
}

/// One layer of many kinds, stacks, dispersing glass, a base that absorbs; drawn ranges of thickness.
fn films(rng: &mut impl Rng) -> Vec<(&'static str, FilmDescription)> {
    let soap = FilmDescription::new(named("vacuum")).layer(named("water"), [0.0, 1000.0]);
    let on_glass = FilmDescription::new(named("BK7")).layer(constant(1.38, 0.0), [50.0, 600.0]);
    let titania = FilmDescription::new(named("Ti")).layer(named("TiO2"), [0.0, 300.0]);
    let stack = FilmDescription::new(constant(1.52, 0.0))
        .layer(constant(2.3, 0.0), [57.0; 2])
        .layer(constant(1.45, 0.0), [20.0, 500.0])
        .layer(constant(2.3, 0.0), [57.0; 2]);
    let gold = FilmDescription::new(constant(1.5, 0.0)).layer(named("Au"), [0.0, 60.0]);
    let narrow = FilmDescription::new(constant(1.5, 3.0)).layer(constant(1.5, 0.0), [300.0, 340.0]);
    let thick = FilmDescription::new(constant(1.5, 0.0)).layer(constant(1.33, 0.0), [0.0, 2e4]);
    let both = |description: FilmDescription| FilmDescription {
        transmittance: true,
        ..description
    };
    let mut films = vec![
        ("soap", both(soap.clone())),
        ("soap, R only", soap),
        ("on BK7", both(on_glass.clone())),
        ("on BK7, R only", on_glass),
        ("titania on titanium", titania),
        ("cavity", both(stack)),
        ("gold on glass", both(gold)),
        ("narrow range", narrow),
        ("thick", thick),
    ];
    for _ in 0..4 {
        let eta = rng.random_range(1.3..2.5);
        let base = constant(
            rng.random_range(1.0..3.0),
            [0.0, 2.0][rng.random_range(0..2)],
        );
        let least = rng.random_range(0.0..300.0);
        let greatest = least + rng.random_range(50.0..900.0);
        let film = FilmDescription::new(base).layer(constant(eta, 0.0), [least, greatest]);
        films.push(("random", film));
    }
    for (_, film) in &mut films {
        let [least, greatest] = film.layers[film.varying().unwrap()].thickness_nm;
        film.thickness_spread_max_nm = greatest - least;
    }
    films
}

fn spreads(film: &FilmDescription) -> Vec<f64> {
    let most = film.thickness_spread_max_nm;
    let all = [0.1, 1.0, 4.0, 10.0, 18.0, 30.0, 45.0, 70.0, 110.0, 200.0];
    let mut spreads: Vec<f64> = all.into_iter().filter(|nm| *nm < most).collect();
    spreads.push(most);
    spreads
}

#[test]
fn averages_are_within_the_tolerance() {
    let mut rng = rng(7);
    for (name, description) in films(&mut rng) {
        let started = std::time::Instant::now();
        let film = Film::new(&description).unwrap();
        let created = started.elapsed().as_secs_f64();
        let plain = FilmDescription {
            thickness_spread_max_nm: 0.0,
            ..description.clone()
        };
        let started = std::time::Instant::now();
        let plain = Film::new(&plain).unwrap();
        let created_plain = started.elapsed().as_secs_f64();
        let reference = reference(&description);
        let [least, greatest] = film.varying_thickness_nm().unwrap();
        let (mut worst, mut place) = (0.0, String::new());
        for deviation in spreads(&description) {
            for part in [0.0, 0.02, 0.3, 0.71, 0.97, 1.0] {
                let d = f64::from((least + part * (greatest - least)) as f32);
                let c = f64::from(rng.random_range(0.02..1.0f32));
                let deviation = f64::from(deviation as f32);
                let sides: &[Side] = match description.transmittance {
                    true => &[Side::Ambient, Side::Base],
                    false => &[Side::Ambient],
                };
                for side in sides {
                    let truth = truth(&description, &reference, *side, [c, d, deviation]);
                    let [c, d, deviation] = [c, d, deviation].map(|x| x as f32);
                    let found = if description.transmittance {
                        let found = film.colors_spread(*side, c, d, deviation).unwrap();
                        [found.reflectance, found.transmittance].to_vec()
                    } else {
                        vec![film.reflectance_spread(c, d, deviation).unwrap()]
                    };
                    for (which, (found, truth)) in found.iter().zip(truth).enumerate() {
                        for channel in 0..3 {
                            let truth = truth[channel].clamp(0.0, 1.0);
                            let error = (f64::from(found[channel]) - truth).abs();
                            if error > worst {
                                worst = error;
                                place = format!(
                                    "{} {side:?} at {c}, {d} +- {deviation} nm",
                                    ["R", "T"][which]
                                );
                            }
                        }
                    }
                }
            }
        }
        println!(
            "{name}: {worst:.2e} ({place}), {} bytes for {}, create {:.0} ms for {:.0}: {}",
            film.plan().bytes,
            plain.plan().bytes,
            1e3 * created,
            1e3 * created_plain,
            film.plan().reason
        );
        assert!(
            worst <= description.tolerance,
            "{name}: {worst:.2e}, {place}"
        );
    }
}

/// Films of one range for each way of compilation, with their spread; forced methods have no tables.
fn compiled() -> Vec<(&'static str, Film)> {
    let soap = FilmDescription {
        transmittance: true,
        thickness_spread_max_nm: 400.0,
        ..FilmDescription::new(named("vacuum")).layer(named("water"), [0.0, 600.0])
    };
    let tinted = FilmDescription {
        transmittance: true,
        thickness_spread_max_nm: 400.0,
        ..FilmDescription::new(named("BK7")).layer(constant(1.8, 0.05), [100.0, 700.0])
    };
    let forced = |method: &str| FilmDescription {
        method: Some(method.into()),
        tolerance: 1e-2,
        transmittance: method == "series",
        ..soap.clone()
    };
    [
        ("soap", soap.clone()),
        ("tinted", tinted),
        ("series", forced("series")),
        (
            "bands",
            FilmDescription {
                tolerance: 5e-2,
                ..forced("bands")
            },
        ),
    ]
    .into_iter()
    .map(|(name, description)| (name, Film::new(&description).unwrap()))
    .collect()
}

/// A spread of 0 gives the bits of calls without; it is a limit, too; and no step shows where rules and levels change.
#[test]
fn averages_are_continuous_in_the_spread() {
    for (name, film) in compiled() {
        let tolerance = film.plan().tolerance as f32;
        for c in [0.05, 0.4, 1.0] {
            for d in [100.0, 137.0, 300.0, 600.0] {
                let plain = film.reflectance(c, d);
                let none = film.reflectance_spread(c, d, 0.0).unwrap();
                assert_eq!(plain.map(f32::to_bits), none.map(f32::to_bits), "{name}");
                let difference = |a: [f32; 3], b: [f32; 3]| {
                    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f32::max)
                };
                let tiny = film.reflectance_spread(c, d, 1e-3).unwrap();
                assert!(difference(plain, tiny) < 0.05 * tolerance, "{name} {c} {d}");
                // A thousandth of the spread changes the average by less than a thousandth of the colours' extent:
                // what is more is a step.
                let (mut deviation, mut before) = (0.05, plain);
                if name == "series" || name == "bands" {
                    deviation = 300.0;
                    before = film.reflectance_spread(c, d, deviation).unwrap();
                }
                while deviation < 420.0 {
                    let found = film.reflectance_spread(c, d, deviation).unwrap();
                    let step = difference(found, before);
                    let is_first = deviation == 0.05;
                    assert!(
                        is_first || step < 0.4 * tolerance + 5e-4,
                        "{name}: a step of {step} at {deviation} nm, {c}, {d}"
                    );
                    before = found;
                    deviation *= 1.001;
                }
            }
        }
    }
}

/// What does not absorb sends back all light, and averages stay between the least and the greatest colour.
#[test]
fn averages_conserve_power_and_stay_within_the_colours() {
    let description = FilmDescription {
        transmittance: true,
        thickness_spread_max_nm: 600.0,
        ..FilmDescription::new(constant(1.5, 0.0)).layer(constant(2.0, 0.0), [0.0, 600.0])
    };
    let film = Film::new(&description).unwrap();
    let tolerance = description.tolerance as f32;
    for c in [0.1, 0.5, 0.9] {
        let all: Vec<_> = (0..=600).map(|d| film.reflectance(c, d as f32)).collect();
        for deviation in [0.5, 3.0, 12.0, 40.0, 90.0, 250.0, 600.0] {
            for d in [0.0, 10.0, 200.0, 590.0] {
                let found = film.colors_spread(Side::Ambient, c, d, deviation).unwrap();
                for channel in 0..3 {
                    let (r, t) = (found.reflectance[channel], found.transmittance[channel]);
                    assert!((r + t - 1.0).abs() < 1e-6, "{r} {t}");
                    let colors = all.iter().map(|rgb| rgb[channel]);
                    let least = colors.clone().fold(1.0, f32::min) - tolerance;
                    let greatest = colors.fold(0.0, f32::max) + tolerance;
                    assert!((least..=greatest).contains(&r), "{r} {least} {greatest}");
                }
            }
        }
    }
}

/// Batches give the bits of single calls, at all sets of instructions, through a BSDF and without; each element has a
/// spread of its own.
#[test]
fn batches_equal_single_calls() {
    for (name, film) in compiled().into_iter().take(2) {
        let count = 300;
        let mut rng = rng(3);
        let inputs: Vec<[f32; 3]> = (0..count)
            .map(|i| {
                let deviation = [0.0, 0.5, 8.0, 33.0, 120.0, 390.0, 500.0][i % 7];
                let c = rng.random_range(0.0..1.0);
                let d = [rng.random_range(0.0..700.0), f32::NAN][usize::from(i % 50 == 49)];
                [c, d, deviation]
            })
            .collect();
        let view = |component: usize| ConstView {
            data: inputs.as_flattened()[component..].as_ptr(),
            element_stride: 12,
            component_stride: 4,
        };
        for level in Level::all() {
            let mut found = vec![[-1.0f32; 3]; count];
            let args = FilmArgs {
                count,
                cos_theta: view(0),
                thickness_nm: view(1),
                reflectance: View {
                    data: found.as_mut_ptr().cast(),
                    element_stride: 12,
                    component_stride: 4,
                },
                thickness_spread_nm: view(2),
            };
            // SAFETY: all views are of arrays of `count` elements.
            unsafe { film_reflectance(&film, &args, level) }.unwrap();
            for (found, [c, d, deviation]) in found.iter().zip(&inputs) {
                let single = film.reflectance_spread(*c, *d, *deviation).unwrap();
                assert_eq!(
                    found.map(f32::to_bits),
                    single.map(f32::to_bits),
                    "{name}, {}: {c}, {d} +- {deviation}",
                    level.name()
                );
            }
        }
    }
}

/// Bad spreads are refused with a message; a greater one than declared is clamped to it.
#[test]
fn bad_spreads_are_refused() {
    let film = |max: f64| {
        let description = FilmDescription {
            thickness_spread_max_nm: max,
            ..FilmDescription::new(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [0.0, 400.0])
        };
        Film::new(&description)
    };
    let refused = |error: Error, status: Status, words: &str| {
        assert!(
            error.status == status && error.message.contains(words),
            "{error}"
        );
    };
    let spread = film(50.0).unwrap();
    for bad in [-1.0, f32::NAN, f32::INFINITY, -f32::MIN_POSITIVE] {
        let error = spread.reflectance_spread(0.5, 100.0, bad).unwrap_err();
        refused(error, Status::OutOfRange, "thickness_spread_nm = ");
    }
    assert_eq!(
        spread.reflectance_spread(0.5, 100.0, 80.0).unwrap(),
        spread.reflectance_spread(0.5, 100.0, 50.0).unwrap()
    );
    let none = film(0.0).unwrap();
    let error = none.reflectance_spread(0.5, 100.0, 1.0).unwrap_err();
    refused(error, Status::InvalidArgument, "thickness_spread_max_nm");
    let fixed = Film::new(&FilmDescription::new(constant(1.5, 0.0))).unwrap();
    let error = fixed.reflectance_spread(0.5, 100.0, 1.0).unwrap_err();
    refused(
        error,
        Status::InvalidArgument,
        "no layer of the film varies",
    );
    assert!(fixed.reflectance_spread(0.5, 100.0, 0.0).is_ok());
    for bad in [-1.0, f64::NAN, f64::INFINITY, 1e9] {
        let error = film(bad).err().unwrap();
        refused(error, Status::OutOfRange, "thickness_spread_max_nm");
    }
    let description = FilmDescription {
        thickness_spread_max_nm: 1.0,
        ..FilmDescription::new(constant(1.5, 0.0))
    };
    let error = Film::new(&description).err().unwrap();
    refused(
        error,
        Status::InvalidArgument,
        "no layer's thickness varies",
    );
    for (film, value, status) in [
        (Arc::new(spread), 51.0, Status::OutOfRange),
        (Arc::new(none), 1.0, Status::OutOfRange),
    ] {
        let description = Description::new("film")
            .film(film)
            .set("thickness_nm", &[100.0])
            .set("thickness_spread_nm", &[value]);
        let error = Bsdf::<f32>::new(&description).err().unwrap();
        refused(error, status, "thickness_spread_nm");
    }
    let description = Description::new("film")
        .film(Arc::new(fixed))
        .set("thickness_spread_nm", &[0.0]);
    let error = Bsdf::<f32>::new(&description).err().unwrap();
    refused(
        error,
        Status::InvalidArgument,
        "no layer of its film varies",
    );
}

/// Smooth and rough BSDFs average their Fresnel factor, and the parameter may vary.
#[test]
fn bsdfs_average() {
    let (_, film) = compiled().swap_remove(0);
    let film = Arc::new(film);
    let wo = glam::Vec3::new(0.6, 0.0, 0.8);
    let at = |model: &str, spread: f32| {
        let description = Description::new(model)
            .film(Arc::clone(&film))
            .set("thickness_nm", &[300.0]);
        let description = match model {
            "microfacet" => description.choose("fresnel", "film").set("alpha", &[0.0]),
            _ => description,
        };
        let fixed = description.clone().set("thickness_spread_nm", &[spread]);
        let varying = description.vary("thickness_spread_nm", 0.0, 400.0);
        let u = glam::Vec3::splat(0.0);
        let call = Call {
            lobes: Flags::REFLECTION.with(Flags::DELTA),
            ..Call::default()
        };
        let fixed = Bsdf::<f32>::new(&fixed).unwrap().sample(wo, u, None, &call);
        let varying = Bsdf::<f32>::new(&varying).unwrap();
        let varying = varying.sample(wo, u, Some(&[spread]), &call);
        assert_eq!(fixed.weight, varying.weight, "{model} {spread}");
        fixed.weight
    };
    for spread in [0.0, 5.0, 60.0, 300.0] {
        let expected = film.reflectance_spread(0.8, 300.0, spread).unwrap();
        for model in ["film", "microfacet"] {
            let found = at(model, spread);
            for channel in 0..3 {
                let difference = (found[channel] - expected[channel]).abs();
                assert!(
                    difference < 1e-5,
                    "{model} {spread}: {found:?} {expected:?}"
                );
            }
        }
    }
}
