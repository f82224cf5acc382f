//! Complex amplitudes, and reflectance and transmittance at single wavelengths. tests/optics/vectors.rs compares
//! the amplitudes with the Python package tmm; here are the laws, the limits, and what is refused.

use crate::common::films::{bare, constant, medium};
use pellicle::Status;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::{P, Response, S, Side};
use pellicle::optics::{Amplitudes, Complex, Medium, NamedMedium};
use rand::{RngExt, SeedableRng};
use std::f64::consts::PI;

type Index = Complex<f64>;

/// A film that is not compiled.
fn film(description: FilmDescription) -> Film {
    let method = Some("reference".into());
    Film::new(&FilmDescription {
        method,
        extrapolate: true,
        ..description
    })
    .unwrap()
}

fn amplitudes(film: &Film, side: Side, c: f64, d: f64, nm: f64) -> Amplitudes<f64> {
    let mut found = [Amplitudes::default()];
    film.amplitudes(side, c, d, &[nm], &mut found).unwrap();
    found[0]
}

fn response(film: &Film, side: Side, c: f64, d: f64, nm: f64) -> Response<f64> {
    let mut found = [NOTHING];
    film.responses(side, c, d, &[nm], &mut found).unwrap();
    found[0]
}

const NOTHING: Response<f64> = Response {
    reflectance: [0.0; 2],
    transmittance: [0.0; 2],
};

fn close(a: Index, b: Index, tolerance: f64, what: &str) {
    let error = (a - b).norm_squared().sqrt();
    assert!(error <= tolerance, "{what}: {a:?}, not {b:?}");
}

/// The cosine behind a plane surface, by Snell's law: n sin is alike on both sides. Independent of the
/// library's root, which works with n cos.
fn refracted(near: Index, cos_theta: f64, far: Index) -> Index {
    let ratio = near * far.inverse();
    let sine_squared = (ratio * ratio).scaled(1.0 - cos_theta * cos_theta);
    let square = Complex::real(1.0) - sine_squared;
    let (modulus, angle) = (square.norm_squared().sqrt(), square.im.atan2(square.re));
    let root = modulus.sqrt();
    let cosine = Complex::new(root * (0.5 * angle).cos(), root * (0.5 * angle).sin());
    if (far * cosine).im < 0.0 {
        -cosine
    } else {
        cosine
    }
}

fn conjugate(a: Index) -> Index {
    Complex::new(a.re, -a.im)
}

/// Films of named media: dispersing and constant half-spaces, absorbing layers, many layers.
fn films() -> Vec<Film> {
    let coated = bare(medium("BK7")).layer(medium("MgF2"), [0.0, 400.0]);
    let mut mirror = bare(medium("BK7"));
    for _ in 0..6 {
        mirror = mirror
            .layer(medium("TiO2"), [55.0; 2])
            .layer(medium("SiO2"), [90.0; 2]);
    }
    let in_oil = FilmDescription {
        ambient: medium("oil"),
        ..bare(medium("water")).layer(medium("Fe2O3"), [0.0, 200.0])
    };
    let measured =
        Medium::table(&[400.0, 500.0, 620.0], &[1.5, 2.0, 1.8], &[0.0, 0.3, 0.1]).unwrap();
    let three = Medium::rgb([1.8, 1.85, 1.9], [0.0, 0.01, 0.02]).unwrap();
    let various = bare(Medium::rgb([1.5, 1.52, 1.54], [0.0; 3]).unwrap())
        .layer(measured, [120.0; 2])
        .layer(three, [0.0, 500.0])
        .layer(medium("Ag"), [15.0; 2]);
    let on_metal = bare(medium("Ti")).layer(medium("TiO2"), [0.0, 300.0]);
    let glass = bare(medium("BK7"));
    [coated, mirror, in_oil, various, on_metal, glass]
        .map(film)
        .into()
}

fn rays() -> impl Iterator<Item = (f64, f64, f64)> {
    let mut rng = rand_pcg::Pcg64::seed_from_u64(18);
    let special = [1.0, 1e-3, 1e-6, 0.0].map(|c| (c, 150.0, 500.0));
    let drawn: Vec<_> = (0..200)
        .map(|_| {
            let [c, d, nm] = rng.random::<[f64; 3]>();
            (c, 500.0 * d, 380.0 + 400.0 * nm)
        })
        .collect();
    special.into_iter().chain(drawn)
}

/// T by the formula of the documentation, R = |r|^2, and both the spectrum's.
#[test]
fn reflectance_and_transmittance_follow_from_amplitudes() {
    for film in films() {
        let description = film.description();
        for (c, d, nm) in rays() {
            for side in [Side::Ambient, Side::Base] {
                let what = format!("{side:?} {c} {d} {nm}: {description:?}");
                let found = amplitudes(&film, side, c, d, nm);
                let expected = response(&film, side, c, d, nm);
                if side == Side::Base && description.base.absorbs() {
                    assert_eq!(
                        (found, expected),
                        (Amplitudes::default(), NOTHING),
                        "{what}"
                    );
                    continue;
                }
                let ends = [&description.ambient, &description.base].map(|m| m.index(nm));
                let (near, far) = match side {
                    Side::Ambient => (ends[0], ends[1]),
                    Side::Base => (ends[1], ends[0]),
                };
                let c = c.max(1e-9);
                let cosine = refracted(near, c, far);
                let flux = [far * cosine, far * conjugate(cosine)];
                for pol in [S, P] {
                    let r = found.reflection[pol].norm_squared();
                    let t = found.transmission[pol].norm_squared() * flux[pol].re / (near.re * c);
                    let [r, t] = [
                        r - expected.reflectance[pol],
                        t - expected.transmittance[pol],
                    ];
                    assert!(
                        r.abs() < 1e-11 && t.abs() < 1e-9,
                        "{pol} {r:e} {t:e} {what}"
                    );
                }
            }
            // The scalar code that the reference integrates.
            let expected = film.spectrum(c.max(1e-9), d, nm).unwrap();
            let found = response(&film, Side::Ambient, c, d, nm).unpolarized_reflectance();
            assert!(
                (found - expected).abs() < 1e-9,
                "{found} {expected} {c} {d} {nm}"
            );
        }
    }
}

/// Energy: without absorption R + T = 1 from both sides, also beyond the critical angle, where T = 0.
#[test]
fn nothing_is_lost_without_absorption() {
    for film in films().into_iter().take(2) {
        for (c, d, nm) in rays() {
            for side in [Side::Ambient, Side::Base] {
                let found = response(&film, side, c, d, nm);
                for pol in [S, P] {
                    let sum = found.reflectance[pol] + found.transmittance[pol];
                    assert!((sum - 1.0).abs() < 1e-9, "{side:?} {c} {d} {nm}: {sum}");
                }
            }
        }
        let total = response(&film, Side::Base, 0.2, 100.0, 550.0);
        assert!(total.transmittance.iter().all(|t| *t == 0.0), "{total:?}");
    }
}

/// Stokes' relation for lossless stacks (1849): t t' - r r' = 1 up to the phase, hence |t t'| + |r|^2 = 1.
#[test]
fn both_directions_belong_together() {
    for film in films().into_iter().take(2) {
        for (c, d, nm) in rays().skip(4) {
            let base = film.description().base.index(nm);
            let ambient = film.description().ambient.index(nm);
            let inside = refracted(ambient, c, base).re;
            let there = amplitudes(&film, Side::Ambient, c, d, nm);
            let back = amplitudes(&film, Side::Base, inside, d, nm);
            for pol in [S, P] {
                let product = there.transmission[pol] * back.transmission[pol]
                    - there.reflection[pol] * back.reflection[pol];
                assert!((product.norm_squared() - 1.0).abs() < 1e-8, "{product:?}");
                let r = there.reflection[pol].norm_squared();
                let t = (there.transmission[pol] * back.transmission[pol]).norm_squared();
                assert!((r + t.sqrt() - 1.0).abs() < 1e-8, "{r} {t}");
            }
        }
    }
}

/// Fresnel's equations, also into a metal, where t is the field just inside.
#[test]
fn a_bare_base_has_fresnels_amplitudes() {
    let one = Complex::real(1.0);
    for name in ["BK7", "Au", "Ti", "Fe2O3"] {
        let bare_base = film(bare(medium(name)));
        // A layer of thickness 0 has no effect.
        let coated = film(bare(medium(name)).layer(medium("Ag"), [0.0, 100.0]));
        for (c, _, nm) in rays().filter(|(c, ..)| *c > 1e-5) {
            let n = medium(name).index(nm);
            let cosine = refracted(one, c, n);
            let c0 = Complex::real(c);
            let (s, p) = (c0 + n * cosine, n * c0 + cosine);
            let expected = Amplitudes {
                reflection: [
                    (c0 - n * cosine) * s.inverse(),
                    (n * c0 - cosine) * p.inverse(),
                ],
                transmission: [s, p].map(|sum| sum.inverse().scaled(2.0 * c)),
            };
            let found = amplitudes(&bare_base, Side::Ambient, c, 0.0, nm);
            assert_eq!(found, amplitudes(&coated, Side::Ambient, c, 0.0, nm));
            for pol in [S, P] {
                let what = format!("{name} {pol} {c} {nm}");
                close(
                    found.reflection[pol],
                    expected.reflection[pol],
                    1e-12,
                    &what,
                );
                close(
                    found.transmission[pol],
                    expected.transmission[pol],
                    1e-12,
                    &what,
                );
            }
        }
        let normal = amplitudes(&bare_base, Side::Ambient, 1.0, 0.0, 550.0);
        close(normal.reflection[P], -normal.reflection[S], 1e-15, name);
        close(normal.transmission[P], normal.transmission[S], 1e-15, name);
    }
}

/// A layer of the ambient's medium delays r by twice its path and t by its path once; exp(-i omega t).
#[test]
fn a_longer_path_adds_to_the_phase() {
    let oil = |description| FilmDescription {
        ambient: constant(1.5, 0.0),
        ..description
    };
    let glass = || bare(constant(2.0, 0.0));
    let (without, with) = (
        film(oil(glass())),
        film(oil(glass().layer(constant(1.5, 0.0), [0.0, 1e4]))),
    );
    for (c, d, nm) in rays().filter(|(c, ..)| *c > 1e-5) {
        let path = 2.0 * PI / nm * 1.5 * c * 20.0 * d;
        let phase = |path: f64| Complex::new(path.cos(), path.sin());
        let a = amplitudes(&without, Side::Ambient, c, 0.0, nm);
        let b = amplitudes(&with, Side::Ambient, c, 20.0 * d, nm);
        for pol in [S, P] {
            close(
                b.reflection[pol],
                a.reflection[pol] * phase(2.0 * path),
                1e-9,
                "r",
            );
            close(
                b.transmission[pol],
                a.transmission[pol] * phase(path),
                1e-9,
                "t",
            );
        }
    }
}

/// At the critical angle, in grazing light and beside absorbing media everything is finite, and in its limit.
#[test]
fn limits() {
    let prism = |base| FilmDescription {
        ambient: constant(1.5, 0.0),
        ..bare(base)
    };
    let gap = film(prism(Medium::vacuum()).layer(constant(1.38, 0.0), [0.0, 300.0]));
    let critical = (1.0f64 - 1.0 / 2.25).sqrt();
    for c in [critical, critical + 1e-16, critical - 1e-16, 0.5 * critical] {
        let found = amplitudes(&gap, Side::Ambient, c, 100.0, 500.0);
        for pol in [S, P] {
            assert!(
                (found.reflection[pol].norm_squared() - 1.0).abs() < 1e-6,
                "{found:?}"
            );
            assert!(
                found.transmission[pol].norm_squared().sqrt() > 0.01,
                "{found:?}"
            );
        }
    }
    // Both neighbours and the layer itself at their critical angle.
    let layer = film(prism(constant(1.5, 0.0)).layer(Medium::vacuum(), [0.0, 300.0]));
    let found = response(&layer, Side::Ambient, critical, 100.0, 500.0);
    let expected = layer.spectrum(critical, 100.0, 500.0).unwrap();
    assert!((found.unpolarized_reflectance() - expected).abs() < 1e-9);
    for film in films() {
        for c in [0.0, -1.0, 1e-10, 1e-30] {
            let found = amplitudes(&film, Side::Ambient, c, 0.0, 600.0);
            let least = f64::from(1e-9f32);
            let least = amplitudes(&film, Side::Ambient, least, 0.0, 600.0);
            assert_eq!(found, least);
            for pol in [S, P] {
                close(found.reflection[pol], Complex::real(-1.0), 1e-6, "grazing");
                assert!(found.transmission[pol].norm_squared() < 1e-12);
            }
        }
        assert_eq!(
            amplitudes(&film, Side::Ambient, 2.0, f64::INFINITY, 600.0),
            amplitudes(&film, Side::Ambient, 1.0, 1e9, 600.0)
        );
    }
    // Thick and absorbing: nothing arrives, and nothing overflows.
    let thick = film(bare(constant(1.5, 0.0)).layer(constant(2.0, 3.0), [1e8; 2]));
    let found = amplitudes(&thick, Side::Ambient, 0.7, 0.0, 1.0);
    assert_eq!(found.transmission, [Complex::real(0.0); 2]);
    assert!(found.reflection.iter().all(|r| r.norm_squared() < 1.0));
    // Every named medium as a layer and as a base, at wavelengths far from its data.
    for named in NamedMedium::all() {
        let coated = film(FilmDescription {
            extrapolate: true,
            ..bare(medium(named.name)).layer(medium(named.name), [0.0, 1e8])
        });
        for nm in [5e-324, 1e-45, 1e-3, 1.0, 380.0, 1e6, 3.4e38, f64::MAX] {
            for side in [Side::Ambient, Side::Base] {
                let found = amplitudes(&coated, side, 0.3, 1e8, nm);
                let all = [found.reflection, found.transmission];
                let sum: f64 = all.as_flattened().iter().map(|a| a.norm_squared()).sum();
                assert!(
                    sum.is_finite() && sum < 16.0,
                    "{} {nm}: {found:?}",
                    named.name
                );
            }
        }
    }
}

/// A call with several wavelengths finds what single ones find, bit for bit, whatever the number of lanes.
#[test]
fn wavelengths_do_not_depend_on_each_other() {
    for film in films() {
        let wavelengths: Vec<f64> = (0..17).map(|i| 390.0 + 23.0 * f64::from(i)).collect();
        for count in 0..=wavelengths.len() {
            let wavelengths = &wavelengths[..count];
            for side in [Side::Ambient, Side::Base] {
                let mut all = vec![Amplitudes::default(); count];
                film.amplitudes(side, 0.6, 90.0, wavelengths, &mut all)
                    .unwrap();
                let mut responses = vec![NOTHING; count];
                film.responses(side, 0.6, 90.0, wavelengths, &mut responses)
                    .unwrap();
                for (i, nm) in wavelengths.iter().enumerate() {
                    assert_eq!(all[i], amplitudes(&film, side, 0.6, 90.0, *nm));
                    assert_eq!(responses[i], response(&film, side, 0.6, 90.0, *nm));
                }
            }
        }
    }
}

#[test]
fn nan_gives_nothing_and_wrong_wavelengths_are_refused() {
    let coated = &films()[0];
    for (c, d) in [(f64::NAN, 100.0), (0.5, f64::NAN)] {
        for side in [Side::Ambient, Side::Base] {
            assert_eq!(amplitudes(coated, side, c, d, 500.0), Amplitudes::default());
            assert_eq!(response(coated, side, c, d, 500.0), NOTHING);
        }
    }
    let ones = Complex::real(1.0);
    let untouched = Amplitudes {
        reflection: [ones; 2],
        transmission: [ones; 2],
    };
    for bad in [0.0, -0.0, -550.0, f64::NAN, f64::INFINITY] {
        let mut found = [untouched; 3];
        let error = coated
            .amplitudes(Side::Ambient, 0.5, 0.0, &[500.0, 600.0, bad], &mut found)
            .unwrap_err();
        assert_eq!(error.status, Status::OutOfRange);
        let words = format!("lambda_nm[2] = {bad} is not finite and above 0");
        assert_eq!(error.message, words);
        assert_eq!(found, [untouched; 3]);
        let error = coated
            .responses(Side::Ambient, 0.5, 0.0, &[bad], &mut [NOTHING])
            .unwrap_err();
        assert_eq!(error.status, Status::OutOfRange);
    }
    let error = coated
        .amplitudes(Side::Ambient, 0.5, 0.0, &[500.0; 2], &mut [untouched; 3])
        .unwrap_err();
    assert_eq!(error.status, Status::InvalidArgument);
}
