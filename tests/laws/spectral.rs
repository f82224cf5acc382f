//! Spectral calls against what else is known, over the whole registry: at 645, 525 and 445 nm they are the three
//! channels, their densities are those of a gray surface with the colour of one wavelength, and samples, single
//! precision and batches agree with evaluations.

#![allow(unsafe_code)] // batches go by addresses

use crate::common::calls::Calls;
use crate::common::{Drawn, Variation, combinations, hemisphere, is_dirac, number, rng, uniforms};
use glam::{DVec3, Vec3};
use pellicle::batch::{
    ConstView, EvalSpectralArgs, SampleSpectralArgs, SpectralInputs, View, eval_spectral,
    sample_spectral,
};
use pellicle::bsdf::{MAX_WAVELENGTHS, ParamKind, Precision, RegisteredModel, models};
use pellicle::{AtWavelengths, Bsdf, Call, Status};
use rand::Rng;
use rand::RngExt;

/// The wavelengths of the channels, nm: Granier and Heidrich 2002, section 1.
const CHANNELS_NM: [f64; 3] = [645.0, 525.0, 445.0];

/// Draws of each model at the least.
const DRAWS: u64 = 12;

/// A drawn surface whose colours are all given per call.
struct Case {
    drawn: Drawn,
    single: Bsdf<f32>,
    double: Bsdf<f64>,
    variations: Vec<Variation>,
}

/// The cases of a model that spectral calls take. Those that they refuse are seen to be refused for the right reason.
fn cases(entry: &'static RegisteredModel) -> Vec<Case> {
    let mut found = Vec::new();
    for seed in 0..combinations(entry).max(DRAWS) {
        let drawn = Drawn::new(entry, 700 + seed);
        let params = entry.info.params;
        let may = |param: usize| params[param].is_color() || seed % 2 == 0;
        let (description, variations) = drawn.varied(&mut rng(seed), may);
        let case = Case {
            single: Bsdf::new(&description).unwrap(),
            double: Bsdf::new(&description).unwrap(),
            drawn,
            variations,
        };
        if is_taken(&case) {
            found.push(case);
        }
    }
    found
}

/// Whether spectral calls are possible; where they are not, they say why.
fn is_taken(case: &Case) -> bool {
    let mut rng = rng(1);
    let varying = spectral_numbers(case, 1, &mut rng);
    let error = Spectral::of(&case.single, [DVec3::Z; 2], &varying, &[550.0]).err();
    let Some(error) = error else { return true };
    assert_eq!(error.status, Status::Unsupported, "{error}");
    let info = case.drawn.entry.info;
    let named = |name: &str| error.message.contains(&format!("'{name}'"));
    let is_fixed = |index: usize| !case.variations.iter().any(|v| v.param == index);
    let mut params = info.params.iter().enumerate();
    let is_color = params.any(|(index, p)| p.is_color() && is_fixed(index) && named(p.name()));
    let is_spread = info
        .film_thickness_spread
        .is_some_and(|p| named(info.params[p].name()));
    assert!(is_color || is_spread, "{error}");
    false
}

/// Numbers of what varies for a spectral call.
fn spectral_numbers(case: &Case, count: usize, rng: &mut impl Rng) -> Vec<f32> {
    let mut numbers = Vec::new();
    for variation in &case.variations {
        if case.drawn.entry.info.params[variation.param].is_color() {
            let [min, max] = variation.range;
            numbers.extend((0..count).map(|_| number(rng, min, max)));
        } else {
            numbers.extend(case.drawn.draw_within(*variation, rng));
        }
    }
    numbers
}

/// The numbers of a call in which every colour is gray and has the value of wavelength j.
fn gray_numbers(case: &Case, spectral: &[f32], count: usize, j: usize) -> Vec<f32> {
    let (mut numbers, mut rest) = (Vec::new(), spectral);
    for variation in &case.variations {
        let param = &case.drawn.entry.info.params[variation.param];
        let components = if param.is_color() {
            count
        } else {
            param.components()
        };
        let (own, after) = rest.split_at(components);
        if param.is_color() {
            numbers.extend([own[j]; 3]);
        } else {
            numbers.extend(own);
        }
        rest = after;
    }
    numbers
}

/// Values and densities of a spectral evaluation.
struct Spectral<T> {
    value: Vec<T>,
    pdf: Vec<T>,
}

impl<T: Precision> Spectral<T> {
    fn of(
        bsdf: &Bsdf<T>,
        [wo, wi]: [DVec3; 2],
        varying: &[f32],
        lambda_nm: &[f64],
    ) -> Result<Self, pellicle::Error> {
        let zeros = || vec![T::new(0.0); lambda_nm.len()];
        let mut found = Self {
            value: zeros(),
            pdf: zeros(),
        };
        bsdf.eval_spectral(
            vector::<T>(wo),
            vector::<T>(wi),
            &AtWavelengths {
                lambda_nm: &lambda_nm.iter().map(|nm| T::new(*nm)).collect::<Vec<_>>(),
                hero: 0,
                varying: Some(&in_precision(varying)),
            },
            &Call::default(),
            &mut found.value,
            &mut found.pdf,
        )?;
        Ok(found)
    }
}

fn vector<T: Precision>(w: DVec3) -> T::Vector {
    w.to_array().map(T::new).into()
}

fn in_precision<T: Precision>(numbers: &[f32]) -> Vec<T> {
    numbers
        .iter()
        .map(|number| T::new(f64::from(*number)))
        .collect()
}

fn is_close(found: f64, truth: f64, tolerance: f64) -> bool {
    (found - truth).abs() <= tolerance * (1e-3 + truth.abs())
}

/// Whether the colours of channels are averages over bands, which a single wavelength has not.
fn has_spectra(drawn: &Drawn) -> bool {
    match drawn.entry.name() {
        "film" => true,
        "microfacet" => {
            drawn.choice("fresnel") == "film"
                || drawn.choice("fresnel") == "conductor" && drawn.choice("metal") != "custom"
        }
        _ => false,
    }
}

/// The mean of F over the hemisphere of facets is another sum in spectral calls, which is closer to the integral.
fn tolerance(drawn: &Drawn) -> f64 {
    let gives_back = drawn.entry.name() == "microfacet"
        && drawn.choice("energy_compensation") == "on"
        && drawn.choice("fresnel") != "schlick";
    if gives_back { 5e-3 } else { 1e-9 }
}

#[test]
fn the_wavelengths_of_the_channels_give_the_channels() {
    for entry in models() {
        let mut compared = 0;
        for case in cases(entry).iter().filter(|case| !has_spectra(&case.drawn)) {
            let mut rng = rng(2);
            let tolerance = tolerance(&case.drawn);
            for _ in 0..20 {
                let pair = [hemisphere(&mut rng), hemisphere(&mut rng)];
                let numbers = spectral_numbers(case, 3, &mut rng);
                let found = Spectral::of(&case.double, pair, &numbers, &CHANNELS_NM).unwrap();
                let varying = in_precision(&numbers);
                let truth = case.double.value(pair[0], pair[1], Some(&varying));
                for channel in 0..3 {
                    assert!(
                        is_close(found.value[channel], truth[channel], tolerance),
                        "{:?}\n{pair:?}: {:?} instead of {truth:?}",
                        case.drawn.description,
                        found.value
                    );
                    compared += usize::from(truth[channel] > 0.0);
                }
            }
        }
        let is_smooth = entry.name() == "film";
        assert!(is_smooth || compared > 200, "{}: {compared}", entry.name());
    }
}

/// The layered model's phases differ between the channels of a gray colour, so that its RGB calls are no truth for one
/// wavelength; with indices that disperse no model's are.
fn is_gray_for_gray(drawn: &Drawn) -> bool {
    drawn.entry.name() != "layered" && !has_spectra(drawn) && {
        let fresnel = (drawn.entry.name() == "microfacet").then(|| drawn.choice("fresnel"));
        fresnel.is_none_or(|fresnel| fresnel == "schlick")
    }
}

#[test]
fn a_density_is_that_of_a_gray_surface_with_the_colour_of_its_wavelength() {
    let mut compared = 0;
    for entry in models() {
        for case in cases(entry)
            .iter()
            .filter(|case| is_gray_for_gray(&case.drawn))
        {
            let mut rng = rng(3);
            for _ in 0..10 {
                let pair = [hemisphere(&mut rng), hemisphere(&mut rng)];
                let count = rng.random_range(1..=MAX_WAVELENGTHS);
                let lambda_nm: Vec<f64> =
                    (0..count).map(|_| rng.random_range(300.0..900.0)).collect();
                let numbers = spectral_numbers(case, count, &mut rng);
                let found = Spectral::of(&case.double, pair, &numbers, &lambda_nm).unwrap();
                let hero = rng.random_range(0..count);
                let gray = in_precision(&gray_numbers(case, &numbers, count, hero));
                let ([value, ..], pdf) = case.double.value_pdf(pair[0], pair[1], Some(&gray));
                assert!(
                    is_close(found.value[hero], value, 1e-9),
                    "{:?}",
                    case.drawn.description
                );
                assert!(
                    is_close(found.pdf[hero], pdf, 1e-9),
                    "{:?}",
                    case.drawn.description
                );
                compared += usize::from(pdf > 0.0);

                let u = DVec3::from(uniforms(&mut rng).map(f64::from));
                let (sample, weight, _) =
                    sampled(&case.double, pair[0], u, &numbers, &lambda_nm, hero);
                let own = case.double.sampled(pair[0], u, Some(&gray));
                assert!(
                    sample.wi.distance(own.wi) < 1e-9,
                    "{:?}",
                    case.drawn.description
                );
                assert_eq!(sample.lobe, own.lobe);
                assert_eq!(sample.flags, own.flags);
                assert!(!sample.is_hero_only);
                assert!(is_close(
                    sample.lobe_probability,
                    own.lobe_probability,
                    1e-9
                ));
                if own.pdf > 0.0 {
                    let there =
                        Spectral::of(&case.double, [pair[0], sample.wi], &numbers, &lambda_nm);
                    let there = there.unwrap();
                    let mean = there.pdf.iter().sum::<f64>() / count as f64;
                    for (weight, value) in weight.iter().zip(&there.value) {
                        assert!(is_close(*weight, value / mean, 1e-6));
                    }
                }
            }
        }
    }
    assert!(compared > 500, "{compared}");
}

fn sampled<T: Precision>(
    bsdf: &Bsdf<T>,
    wo: DVec3,
    u: DVec3,
    varying: &[f32],
    lambda_nm: &[f64],
    hero: usize,
) -> (pellicle::SpectralSample<T>, Vec<T>, Vec<T>) {
    let mut weight = vec![T::new(0.0); lambda_nm.len()];
    let mut pdf = weight.clone();
    let lambda_nm: Vec<T> = lambda_nm.iter().map(|nm| T::new(*nm)).collect();
    let varying = in_precision(varying);
    let sample = bsdf.sample_spectral(
        vector::<T>(wo),
        vector::<T>(u),
        &AtWavelengths {
            lambda_nm: &lambda_nm,
            hero,
            varying: Some(&varying),
        },
        &Call::default(),
        &mut weight,
        &mut pdf,
    );
    (sample.unwrap(), weight, pdf)
}

#[test]
fn single_precision_follows_double() {
    for entry in models() {
        for case in &cases(entry) {
            let mut rng = rng(4);
            for _ in 0..10 {
                let pair = [hemisphere(&mut rng), hemisphere(&mut rng)];
                let pair = pair.map(|w| w.as_vec3().as_dvec3());
                let lambda_nm = [660.0, 550.0, 500.0, 430.0, 610.0];
                let numbers = spectral_numbers(case, lambda_nm.len(), &mut rng);
                let found = Spectral::of(&case.single, pair, &numbers, &lambda_nm).unwrap();
                let truth = Spectral::of(&case.double, pair, &numbers, &lambda_nm).unwrap();
                for j in 0..lambda_nm.len() {
                    for (found, truth) in [
                        (found.value[j], truth.value[j]),
                        (found.pdf[j], truth.pdf[j]),
                    ] {
                        assert!(
                            is_close(f64::from(found), truth, 1e-2),
                            "{:?}\n{pair:?}: {found} instead of {truth}",
                            case.drawn.description
                        );
                    }
                }
            }
        }
    }
}

/// Elements of a batch.
const COUNT: usize = 21;

/// Numbers that lie one element after another.
fn rows(numbers: &[f32], components: usize) -> ConstView {
    ConstView {
        data: numbers.as_ptr(),
        element_stride: 4 * components as isize,
        component_stride: 4,
    }
}

fn rows_mut<T>(numbers: &mut [T], components: usize) -> View<T> {
    View {
        data: numbers.as_mut_ptr(),
        element_stride: 4 * components as isize,
        component_stride: 4,
    }
}

#[test]
fn batches_are_the_bits_of_single_calls() {
    let (mut values, mut samples) = (0, 0);
    for entry in models() {
        for case in cases(entry).iter().step_by(3) {
            let mut rng = rng(5);
            let count = rng.random_range(1..=MAX_WAVELENGTHS);
            let hero = rng.random_range(0..count);
            let bsdf = &case.single;
            let each = |rng: &mut _| hemisphere(rng).as_vec3();
            let wo: Vec<Vec3> = (0..COUNT).map(|_| each(&mut rng)).collect();
            let wi: Vec<Vec3> = (0..COUNT).map(|_| each(&mut rng)).collect();
            let u: Vec<[f32; 3]> = (0..COUNT).map(|_| uniforms(&mut rng)).collect();
            let lambda_nm: Vec<f32> = (0..COUNT * count)
                .map(|_| rng.random_range(400.0..700.0))
                .collect();
            let numbers: Vec<Vec<f32>> = (0..COUNT)
                .map(|_| spectral_numbers(case, count, &mut rng))
                .collect();
            let floats = bsdf.spectral_varying_floats(count);
            assert_eq!(floats, numbers[0].len());
            let (flat, mut first, mut views) = (numbers.concat(), 0, Vec::new());
            for varying in bsdf.varying() {
                let view = rows(&flat[first.min(flat.len() - 1)..], floats);
                views.push(view);
                let of_color = varying.param.is_color();
                first += if of_color {
                    count
                } else {
                    varying.param.components()
                };
            }
            let inputs = SpectralInputs {
                count: COUNT,
                lambda_count: count,
                call: Call::default(),
                lambda_nm: rows(&lambda_nm, count),
                wo: rows(
                    wo.iter()
                        .flat_map(|w| w.to_array())
                        .collect::<Vec<_>>()
                        .leak(),
                    3,
                ),
                varying: &views,
            };
            let wi_flat: Vec<f32> = wi.iter().flat_map(|w| w.to_array()).collect();
            let [mut value, mut pdf, mut weight, mut density] =
                [(); 4].map(|()| vec![-1.0; COUNT * count]);
            let args = EvalSpectralArgs {
                inputs,
                wi: rows(&wi_flat, 3),
                value: rows_mut(&mut value, count),
                pdf: rows_mut(&mut pdf, count),
            };
            // SAFETY: the views are those of arrays of COUNT elements.
            unsafe { eval_spectral(bsdf, &args).unwrap() };
            let mut directions = vec![-1.0; 3 * COUNT];
            let [mut eta, mut probability] = [(); 2].map(|()| vec![-1.0; COUNT]);
            let [mut flags, mut lobe, mut hero_only] = [(); 3].map(|()| vec![9_u32; COUNT]);
            let args = SampleSpectralArgs {
                inputs,
                hero,
                u: rows(u.as_flattened(), 3),
                wi: rows_mut(&mut directions, 3),
                weight: rows_mut(&mut weight, count),
                pdf: rows_mut(&mut density, count),
                eta: rows_mut(&mut eta, 1),
                flags: rows_mut(&mut flags, 1),
                lobe: rows_mut(&mut lobe, 1),
                lobe_probability: rows_mut(&mut probability, 1),
                hero_only: rows_mut(&mut hero_only, 1),
            };
            // SAFETY: the same.
            unsafe { sample_spectral(bsdf, &args).unwrap() };
            for i in 0..COUNT {
                let own = i * count..(i + 1) * count;
                let nm: Vec<f64> = lambda_nm[own.clone()]
                    .iter()
                    .map(|nm| f64::from(*nm))
                    .collect();
                let pair = [wo[i].as_dvec3(), wi[i].as_dvec3()];
                let single = Spectral::of(bsdf, pair, &numbers[i], &nm).unwrap();
                assert_eq!(bits(&single.value), bits(&value[own.clone()]));
                assert_eq!(bits(&single.pdf), bits(&pdf[own.clone()]));
                values += single.value.iter().filter(|value| **value > 0.0).count();
                let u = Vec3::from(u[i]).as_dvec3();
                let (sample, weights, pdfs) = sampled(bsdf, pair[0], u, &numbers[i], &nm, hero);
                assert_eq!(bits(&weights), bits(&weight[own.clone()]));
                assert_eq!(bits(&pdfs), bits(&density[own.clone()]));
                let row = &directions[3 * i..3 * i + 3];
                assert_eq!(bits(&sample.wi.to_array()), bits(row));
                assert_eq!(
                    [sample.eta, sample.lobe_probability],
                    [eta[i], probability[i]]
                );
                let numbers = [
                    sample.flags.0,
                    sample.lobe as u32,
                    sample.is_hero_only.into(),
                ];
                assert_eq!(numbers, [flags[i], lobe[i], hero_only[i]]);
                samples += usize::from(sample.lobe_probability > 0.0);
            }
        }
    }
    assert!(values > 1000 && samples > 500, "{values} {samples}");
}

fn bits(numbers: &[f32]) -> Vec<u32> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

/// Dirac lobes: over the hero the mean of what is returned is the albedo at each wavelength.
#[test]
fn weights_of_dirac_lobes_sum_to_what_leaves() {
    for entry in models() {
        for case in &cases(entry) {
            let is_mirror = is_dirac(&case.double) && case.double.lobe_infos().len() == 1;
            if !is_mirror {
                continue;
            }
            let mut rng = rng(6);
            let wo = hemisphere(&mut rng);
            let lambda_nm = [640.0, 450.0];
            let numbers = spectral_numbers(case, 2, &mut rng);
            let (sample, weight, pdf) =
                sampled(&case.double, wo, DVec3::splat(0.5), &numbers, &lambda_nm, 1);
            assert_eq!(pdf, [1.0; 2]);
            assert!(sample.wi.distance(DVec3::new(-wo.x, -wo.y, wo.z)) < 1e-9);
            assert!(
                weight.iter().all(|weight| (0.0..=1.0).contains(weight)),
                "{weight:?}"
            );
        }
    }
}

#[test]
fn a_kind_that_is_a_choice_is_no_colour() {
    for entry in models() {
        for param in entry.info.params {
            let has_three = matches!(param.kind, ParamKind::Number { components: 3, .. });
            assert_eq!(
                param.is_color() || param.is_index,
                has_three,
                "{}",
                param.name()
            );
        }
    }
}
