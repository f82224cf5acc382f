//! Spectral calls of coated surfaces: summed over the visible spectrum they are the RGB calls, their samples find what
//! leaves at each wavelength, and refraction follows the hero.

use crate::common::calls::Calls;
use crate::common::films::{Kind, bare, compiled, constant, medium, two_sided};
use crate::common::{degrees, hemisphere, number, rng};
use glam::{DVec3, Vec3};
use pellicle::bsdf::Flags;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::{ChannelWeights, ColorSpace, White};
use pellicle::{
    AtWavelengths, Bsdf, Call, Description, Medium, Precision, SpectralSample, Status, Transport,
};
use std::sync::Arc;

/// The visible wavelengths in steps of 1 nm, with their share in each channel of a perfect mirror.
fn visible() -> Vec<(f64, [f64; 3])> {
    let weights = ChannelWeights::new(White::E, ColorSpace::Rec709);
    let all: Vec<_> = (380..=780)
        .map(|nm| (f64::from(nm), weights.at(f64::from(nm))))
        .collect();
    let sum: [f64; 3] = std::array::from_fn(|c| all.iter().map(|(_, weight)| weight[c]).sum());
    let share = |weight: [f64; 3]| std::array::from_fn(|c| weight[c] / sum[c]);
    all.into_iter()
        .map(|(nm, weight)| (nm, share(weight)))
        .collect()
}

fn at<'a, T: Precision>(
    lambda_nm: &'a [T],
    hero: usize,
    varying: Option<&'a [T]>,
) -> AtWavelengths<'a, T> {
    AtWavelengths {
        lambda_nm,
        hero,
        varying,
    }
}

/// The colour of the values at all visible wavelengths.
fn in_rgb(bsdf: &Bsdf<f64>, wo: DVec3, wi: DVec3, varying: Option<&[f64]>) -> [f64; 3] {
    let mut rgb = [0.0; 3];
    for group in visible().chunks(16) {
        let nm: Vec<f64> = group.iter().map(|(nm, _)| *nm).collect();
        let (mut value, mut pdf) = (vec![0.0; nm.len()], vec![0.0; nm.len()]);
        let call = Call::default();
        bsdf.eval_spectral(wo, wi, &at(&nm, 0, varying), &call, &mut value, &mut pdf)
            .unwrap();
        for ((_, weight), value) in group.iter().zip(value) {
            for channel in 0..3 {
                rgb[channel] += weight[channel] * value;
            }
        }
    }
    rgb
}

/// A rough surface whose Fresnel factor is 1: its value is what reflectances are multiplied by.
fn white(alpha: f32) -> Bsdf<f64> {
    let description = Description::new("microfacet").set("alpha", &[alpha]);
    Bsdf::new(&description.set("f0", &[1.0])).unwrap()
}

/// Oxide on titanium to a micrometre, soap, and metals: the colours are clipped in RGB calls alone, so that surfaces are
/// compared whose colours need no clipping, and the rest from one side.
#[test]
fn summed_over_the_spectrum_they_are_the_rgb_calls() {
    let oxide = bare(medium("Ti")).layer(medium("TiO2"), [0.0, 1000.0]);
    let soap = bare(Medium::vacuum()).layer(medium("water"), [100.0, 1000.0]);
    let films = [oxide, soap].map(|description| {
        compiled(&FilmDescription {
            unclipped: true,
            ..description
        })
    });
    let mut cases: Vec<(Description, [f64; 2])> = films
        .iter()
        .map(|film| {
            let rough = Description::new("microfacet").choose("fresnel", "film");
            (rough.film(Arc::clone(film)), [100.0, 1000.0])
        })
        .collect();
    for metal in ["Au", "Cu", "Ti"] {
        let bare = Description::new("microfacet").choose("fresnel", "conductor");
        cases.push((bare.choose("metal", metal), [0.0, 0.0]));
    }
    let mut rng = rng(11);
    let mut compared = 0;
    for (description, range) in cases {
        let has_thickness = range[1] > 0.0;
        let described = description.set("alpha", &[0.4]);
        let described = if has_thickness {
            described.vary("thickness_nm", range[0] as f32, range[1] as f32)
        } else {
            described
        };
        let bsdf: Bsdf<f64> = Bsdf::new(&described).unwrap();
        let white = white(0.4);
        for _ in 0..40 {
            let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
            let [scale, ..] = white.value(wo, wi, None);
            let thickness = [f64::from(number(
                &mut rng,
                range[0] as f32,
                range[1] as f32,
            ))];
            let varying = has_thickness.then_some(&thickness[..]);
            let rgb = bsdf.value(wo, wi, varying);
            let sum = in_rgb(&bsdf, wo, wi, varying);
            for channel in 0..3 {
                // The film's own tolerance, and what RGB calls of a rough surface clip.
                let clipped = (sum[channel] / scale).clamp(0.0, 1.0);
                let found = rgb[channel] / scale;
                assert!(
                    (found - clipped).abs() <= 2e-3,
                    "{described:?} {wo} {wi}: {found} {clipped}"
                );
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 5 * 40 * 3);
}

fn sample(
    bsdf: &Bsdf<f64>,
    wo: DVec3,
    u: DVec3,
    lambda_nm: &[f64],
    hero: usize,
    call: &Call,
) -> (SpectralSample<f64>, Vec<f64>) {
    let (mut weight, mut pdf) = (vec![0.0; lambda_nm.len()], vec![0.0; lambda_nm.len()]);
    let sample = bsdf
        .sample_spectral(
            wo,
            u,
            &at(lambda_nm, hero, None),
            call,
            &mut weight,
            &mut pdf,
        )
        .unwrap();
    (sample, weight)
}

fn film_bsdf(film: &Arc<Film>) -> Bsdf<f64> {
    let description = Description::new("film").film(Arc::clone(film));
    let description = match film.varying_thickness_nm() {
        Some(_) => description.set("thickness_nm", &[250.0]),
        None => description,
    };
    Bsdf::new(&description).unwrap()
}

/// Over the hero and the number that chooses the lobe, weights average to the power that leaves at every wavelength, if
/// the media do not disperse; importance leaves out what refraction compresses.
#[test]
fn samples_of_a_smooth_film_average_to_its_power_at_every_wavelength() {
    let lambda_nm = [420.0, 530.0, 560.0, 690.0];
    let call = Call {
        transport: Transport::Importance,
        ..Call::default()
    };
    let pane =
        compiled(&two_sided(bare(constant(1.5, 0.0))).layer(constant(2.3, 0.0), [0.0, 600.0]));
    for film in [Kind::Lens.film(), pane] {
        let bsdf = film_bsdf(&film);
        for wo in [
            degrees(10.0, 0.0),
            degrees(70.0, 40.0),
            -degrees(20.0, 0.0),
            -degrees(60.0, 0.0),
        ] {
            const STEPS: u32 = 4000;
            let mut mean = [0.0; 4];
            for hero in 0..lambda_nm.len() {
                for i in 0..STEPS {
                    let u = DVec3::new((f64::from(i) + 0.5) / f64::from(STEPS), 0.5, 0.5);
                    let (sample, weight) = sample(&bsdf, wo, u, &lambda_nm, hero, &call);
                    assert!(!sample.is_hero_only);
                    for j in 0..4 {
                        mean[j] += weight[j] / f64::from(STEPS * 4);
                    }
                }
            }
            // Nothing absorbs.
            for j in 0..4 {
                assert!((mean[j] - 1.0).abs() < 2e-3, "{wo}: {mean:?}");
            }
        }
    }
}

/// The inner face of a prism: Snell's law with the index of the hero, by the formula of Sellmeier with Schott's
/// coefficients of N-BK7; beyond the critical angle of a wavelength that one is reflected whole.
#[test]
fn a_prism_sends_each_hero_its_own_way() {
    let index = |nm: f64| {
        let x = (nm * 1e-3).powi(2);
        let b = [1.039_612_12, 0.231_792_344, 1.010_469_45];
        let c = [0.006_000_698_67, 0.020_017_914_4, 103.560_653];
        (1.0 + (0..3).map(|i| b[i] * x / (x - c[i])).sum::<f64>()).sqrt()
    };
    let bsdf = film_bsdf(&compiled(&FilmDescription {
        ambient: medium("BK7"),
        ..two_sided(bare(Medium::vacuum()))
    }));
    let lambda_nm = [430.0, 500.0, 580.0, 660.0];
    for theta in [0.3_f64, 0.6, 0.7] {
        let wo = DVec3::new(theta.sin(), 0.0, theta.cos());
        for hero in 0..4 {
            let (found, weight) = sample(
                &bsdf,
                wo,
                DVec3::splat(0.999),
                &lambda_nm,
                hero,
                &Call::default(),
            );
            let n = index(lambda_nm[hero]);
            assert_eq!(found.flags, Flags::TRANSMISSION.with(Flags::DELTA));
            assert!(found.is_hero_only);
            assert!(
                (found.wi.x + n * theta.sin()).abs() < 2e-5,
                "{} {}",
                found.wi,
                n * theta.sin()
            );
            assert!((found.eta * n - 1.0).abs() < 2e-5);
            for j in 0..4 {
                // Radiance grows by the square of the index, T over its probability is 1, and the hero counts for all.
                let expected = if j == hero { 4.0 * n * n } else { 0.0 };
                assert!((weight[j] - expected).abs() < 4e-4, "{weight:?}");
            }
        }
    }
    // Between the critical angles of violet and red: 1 / n of each.
    let between = 0.5 * ((1.0 / index(430.0)).asin() + (1.0 / index(660.0)).asin());
    let wo = DVec3::new(between.sin(), 0.0, between.cos());
    let (violet, _) = sample(
        &bsdf,
        wo,
        DVec3::splat(0.999),
        &lambda_nm,
        0,
        &Call::default(),
    );
    assert_eq!(violet.flags, Flags::REFLECTION.with(Flags::DELTA));
    let (red, _) = sample(
        &bsdf,
        wo,
        DVec3::splat(0.999),
        &lambda_nm,
        3,
        &Call::default(),
    );
    assert_eq!(red.flags, Flags::TRANSMISSION.with(Flags::DELTA));
}

#[test]
fn what_has_no_spectrum_is_refused() {
    let film = Kind::Bubble.film();
    let (mut value, mut pdf) = ([-1.0_f32], [-1.0_f32]);
    let mut status = |description: Description, nm: f32| {
        let bsdf: Bsdf = Bsdf::new(&description).unwrap();
        let call = Call::default();
        let result = bsdf.eval_spectral(
            Vec3::Z,
            Vec3::Z,
            &at(&[nm], 0, None),
            &call,
            &mut value,
            &mut pdf,
        );
        result.err().map(|error| (error.status, error.message))
    };
    let rough = || {
        let rough = Description::new("microfacet")
            .choose("fresnel", "film")
            .film(Arc::clone(&film));
        rough.set("thickness_nm", &[300.0])
    };
    let spread = status(rough().set("thickness_spread_nm", &[20.0]), 550.0).unwrap();
    assert_eq!(spread.0, Status::Unsupported);
    assert!(spread.1.contains("thickness_spread_nm"), "{}", spread.1);
    let beyond = status(rough(), 1e5).unwrap();
    assert_eq!(beyond.0, Status::OutOfRange);
    assert!(beyond.1.contains("lambda_nm[0]"), "{}", beyond.1);
    assert_eq!(status(rough(), 550.0), None);
    assert!(value[0] > 0.0 && pdf[0] > 0.0);
}

/// The mean of F over the hemisphere of facets, which energy compensation needs, is found per wavelength: a white metal
/// whose index is the same at every wavelength returns as much in spectral calls as in RGB calls.
#[test]
fn energy_is_compensated_at_each_wavelength() {
    let metal = Description::new("microfacet")
        .choose("fresnel", "conductor")
        .set("eta", &[0.2])
        .set("k", &[4.0])
        .set("alpha", &[0.8])
        .choose("energy_compensation", "on");
    let bsdf: Bsdf<f64> = Bsdf::new(&metal).unwrap();
    let mut rng = rng(12);
    for _ in 0..100 {
        let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
        let [rgb, ..] = bsdf.value(wo, wi, None);
        let (mut value, mut pdf) = ([0.0; 2], [0.0; 2]);
        let nm = [450.0, 650.0];
        bsdf.eval_spectral(
            wo,
            wi,
            &at(&nm, 0, None),
            &Call::default(),
            &mut value,
            &mut pdf,
        )
        .unwrap();
        assert!((value[0] / rgb - 1.0).abs() < 2e-3, "{value:?} {rgb}");
        assert!((value[1] / rgb - 1.0).abs() < 2e-3);
    }
}
