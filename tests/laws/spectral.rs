//! Spectral calls against what else is known, over the whole registry: at 645, 525 and 445 nm they are the three
//! channels, their densities are those of a gray surface with the colour of one wavelength, and samples and single
//! precision agree with evaluations.

use crate::common::calls::Calls;
use crate::common::{Drawn, Variation, combinations, hemisphere, is_dirac, number, rng, uniforms};
use glam::DVec3;
use pellicle::bsdf::{MAX_WAVELENGTHS, Precision, RegisteredModel, models};
use pellicle::{AtWavelengths, Bsdf, Call, Status};
use rand::Rng;
use rand::RngExt;

/// The wavelengths of the channels, nm: Granier and Heidrich 2002, section 1.
const CHANNELS_NM: [f64; 3] = [645.0, 525.0, 445.0];

/// Draws of each model at the least.
const DRAWS: u64 = 12;

/// A drawn surface whose colours are all given per call.
pub struct Case {
    drawn: Drawn,
    pub single: Bsdf<f32>,
    double: Bsdf<f64>,
    variations: Vec<Variation>,
}

/// The cases of a model that spectral calls take. Those that they refuse are seen to be refused for the right reason.
pub fn cases(entry: &'static RegisteredModel) -> Vec<Case> {
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
pub fn spectral_numbers(case: &Case, count: usize, rng: &mut impl Rng) -> Vec<f32> {
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
pub struct Spectral<T> {
    pub value: Vec<T>,
    pub pdf: Vec<T>,
}

impl<T: Precision> Spectral<T> {
    pub fn of(
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

pub fn sampled<T: Precision>(
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

/// A mirror sends every wavelength the same way, with the weight of a gray mirror that has its colour.
#[test]
fn a_mirror_weighs_each_wavelength_by_its_own_reflectance() {
    let mut compared = 0;
    for entry in models() {
        let cases = cases(entry);
        let is_mirror = |case: &&Case| {
            is_dirac(&case.double)
                && case.double.lobe_infos().len() == 1
                && is_gray_for_gray(&case.drawn)
        };
        for case in cases.iter().filter(is_mirror) {
            let mut rng = rng(6);
            for _ in 0..20 {
                let wo = hemisphere(&mut rng);
                let lambda_nm = [640.0, 450.0, 530.0];
                let numbers = spectral_numbers(case, 3, &mut rng);
                let u = DVec3::splat(0.5);
                let (sample, weight, pdf) = sampled(&case.double, wo, u, &numbers, &lambda_nm, 1);
                assert_eq!(pdf, [1.0; 3]);
                assert!(sample.wi.distance(DVec3::new(-wo.x, -wo.y, wo.z)) < 1e-9);
                for (j, weight) in weight.iter().enumerate() {
                    let gray = in_precision(&gray_numbers(case, &numbers, 3, j));
                    let own = case.double.sampled(wo, u, Some(&gray));
                    assert!(
                        is_close(*weight, own.weight[0], 1e-9),
                        "{:?}",
                        case.drawn.description
                    );
                    compared += usize::from(*weight > 0.0);
                }
            }
        }
    }
    assert!(compared > 50, "{compared}");
}

/// Three numbers are colours but for these, which are indices.
#[test]
fn the_indices_of_the_registry_are_known() {
    let mut indices = Vec::new();
    for entry in models() {
        let params = entry.info.params.iter().filter(|param| param.is_index);
        indices.extend(params.map(|param| (entry.name(), param.name())));
    }
    indices.sort_unstable();
    let known = [
        ("layered", "eta"),
        ("microfacet", "eta"),
        ("microfacet", "k"),
    ];
    assert_eq!(indices, known);
}
