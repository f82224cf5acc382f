//! sample() against pdf(): Pearson's chi-square test, per lobe and for the mixture.
//!
//! The single-precision samples are counted on a grid of cells of equal solid angle; what each cell
//! should hold is integrated from the double-precision density. Samples that are no direction form
//! a cell of their own, whose share is what the density lacks from 1. Cells that expect fewer than 5
//! are pooled; the level is Sidak-corrected for the number of tests.

use crate::common;
use crate::common::calls::Calls;
use crate::common::quadrature::Patch;
use crate::common::{Drawn, defaults, degrees, is_dirac, parallel, rng, uniforms, visible};
use glam::{DVec3, Vec3};
use pellicle::bsdf::{Flags, LobeInfo, MAX_LOBES, RegisteredModel, models};
use pellicle::{Bsdf, Description};
use rand::RngExt;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::collections::BTreeSet;

const ROWS: usize = 24;
const COLUMNS: usize = 48;
const SAMPLES: usize = 100_000;
/// Probability that the whole file fails although nothing is wrong.
const LEVEL: f64 = 1e-3;
const INCIDENCES: [f64; 5] = [0.0, 30.0, 60.0, 80.0, 89.0];

/// Counts or expectations per lobe and cell; the last cell is for no direction.
type Histogram = Vec<[f64; MAX_LOBES]>;

/// Samples: their counts, and where they lie in each cell, as (z, phi).
struct Observed {
    counts: Histogram,
    places: Vec<Vec<[f64; 2]>>,
}

fn observed(bsdf: &Bsdf, wo: DVec3, seed: u64) -> Observed {
    let mut counts = vec![[0.0; MAX_LOBES]; ROWS * COLUMNS + 1];
    let mut places = vec![vec![]; ROWS * COLUMNS];
    let mut rng = rng(seed);
    for _ in 0..SAMPLES {
        let sample = bsdf.sampled(wo.as_vec3(), Vec3::from(uniforms(&mut rng)), None);
        if sample.pdf == 0.0 {
            // A sample without a direction does not say which lobe was chosen.
            counts[ROWS * COLUMNS][0] += 1.0;
            continue;
        }
        let wi = sample.wi.as_dvec3();
        let turn = wi.y.atan2(wi.x) / std::f64::consts::TAU;
        let row = ((wi.z * ROWS as f64) as usize).min(ROWS - 1);
        let turn = (turn + 1.0) % 1.0;
        let column = (turn * COLUMNS as f64) as usize % COLUMNS;
        let cell = row * COLUMNS + column;
        counts[cell][sample.lobe] += 1.0;
        places[cell].push([wi.z, turn * std::f64::consts::TAU]);
    }
    Observed { counts, places }
}

/// The error of a cell's probability: less than half a sample, where cells that are compared expect 5 and more.
const CELL_ERROR: f64 = 4e-6;

/// Integrals of probability times density of each lobe. The places of samples tell where to look closely.
fn expected(bsdf: &Bsdf<f64>, wo: DVec3, places: &[Vec<[f64; 2]>]) -> Histogram {
    let density = |wi: DVec3| {
        let (selection, densities) = bsdf.lobe_densities(wo, wi, None);
        std::array::from_fn::<f64, MAX_LOBES, _>(|k| selection[k] * densities[k])
    };
    let mut cells = Vec::new();
    let mut missing = 1.0;
    for (i, j) in (0..ROWS * COLUMNS).map(|n| (n / COLUMNS, n % COLUMNS)) {
        let cell = Patch::cell(i, j, ROWS, COLUMNS);
        let share = cell.integrate_about(&density, CELL_ERROR, 9, &places[i * COLUMNS + j]);
        missing -= share.iter().sum::<f64>();
        cells.push(share.map(|share| share * SAMPLES as f64));
    }
    assert!(
        missing > -1e-4,
        "the density integrates to {}",
        1.0 - missing
    );
    let mut none = [0.0; MAX_LOBES];
    none[0] = missing.max(0.0) * SAMPLES as f64;
    cells.push(none);
    cells
}

/// The probability of a statistic at least this bad if both come from one distribution.
fn p_value(observed: &[f64], expected: &[f64]) -> f64 {
    let (mut statistic, mut cells) = (0.0, 0);
    let (mut pooled_observed, mut pooled_expected) = (0.0, 0.0);
    for (found, expected) in observed.iter().zip(expected) {
        if *expected < 5.0 {
            pooled_observed += found;
            pooled_expected += expected;
        } else {
            statistic += (found - expected).powi(2) / expected;
            cells += 1;
        }
    }
    if pooled_expected >= 5.0 {
        statistic += (pooled_observed - pooled_expected).powi(2) / pooled_expected;
        cells += 1;
    } else if pooled_observed > 25.0 + pooled_expected {
        return 0.0; // samples where there should be none
    }
    if cells < 2 {
        return 1.0;
    }
    ChiSquared::new(f64::from(cells - 1)).unwrap().sf(statistic)
}

fn column(histogram: &Histogram, lobe: usize) -> Vec<f64> {
    // The cell for no direction belongs to the mixture alone.
    histogram[..ROWS * COLUMNS]
        .iter()
        .map(|cell| cell[lobe])
        .collect()
}

fn mixture(histogram: &Histogram) -> Vec<f64> {
    histogram.iter().map(|cell| cell.iter().sum()).collect()
}

/// The p-value of the mixture and of each lobe that is ever chosen.
fn p_values(samples: &Histogram, density: &Histogram) -> Vec<f64> {
    let mut values = vec![p_value(&mixture(samples), &mixture(density))];
    for lobe in 0..MAX_LOBES {
        let expected = column(density, lobe);
        let total: f64 = expected.iter().sum();
        if total > LEAST_SAMPLES {
            // The number of a lobe's samples is compared here, to six standard deviations. After that only
            // their distribution is.
            let found = column(samples, lobe);
            let scale = found.iter().sum::<f64>() / total;
            if (scale - 1.0).abs() > 6.0 / total.sqrt() {
                values.push(0.0);
            }
            let expected: Vec<f64> = expected.iter().map(|expected| expected * scale).collect();
            values.push(p_value(&found, &expected));
        }
    }
    values
}

/// A description, and the polar angle of incidence in degrees.
type Case = (Description, f64);

/// Compares samples of each case with its density; tells the expected number of samples of each lobe.
fn assert_agreement(cases: &[Case]) -> Vec<[f64; MAX_LOBES]> {
    let numbered: Vec<_> = cases.iter().enumerate().collect();
    let results = parallel::map(&numbered, |(seed, (description, theta))| {
        let wo = degrees(*theta, 40.0).as_vec3().as_dvec3();
        let samples = observed(&Bsdf::new(description).unwrap(), wo, *seed as u64);
        let density = expected(&Bsdf::new(description).unwrap(), wo, &samples.places);
        let sum = |lobe: usize| density.iter().map(|cell| cell[lobe]).sum();
        (
            p_values(&samples.counts, &density),
            std::array::from_fn(sum),
        )
    });
    let tests: usize = results.iter().map(|(values, _)| values.len()).sum();
    let threshold = 1.0 - (1.0 - LEVEL).powf(1.0 / tests as f64);
    let mut failures = Vec::new();
    for ((description, theta), (values, _)) in cases.iter().zip(&results) {
        for (test, p) in values.iter().enumerate().filter(|(_, p)| **p <= threshold) {
            failures.push(format!(
                "p = {p:.3e}, test {test} at {theta} degrees: {description:?}"
            ));
        }
    }
    let least = results
        .iter()
        .flat_map(|(values, _)| values)
        .fold(1.0, |a: f64, b| a.min(*b));
    println!("{tests} tests, least p {least:.2e}, threshold {threshold:.2e}");
    assert!(failures.is_empty(), "below {threshold:.3e}: {failures:#?}");
    results.into_iter().map(|(_, counts)| counts).collect()
}

/// Each description at every angle.
fn assert_all_angles(descriptions: &[Description]) {
    let of = |description: &Description| INCIDENCES.map(|theta| (description.clone(), theta));
    let cases: Vec<Case> = descriptions.iter().flat_map(of).collect();
    assert_agreement(&cases);
}

#[test]
fn lambert_and_phong_sample_their_density() {
    let mut descriptions = vec![Description::new("lambert")];
    for exponent in [0.0, 1.0, 30.0, 1000.0] {
        descriptions.push(Description::new("phong").set("exponent", &[exponent]));
    }
    assert_all_angles(&descriptions);
}

/// Draws of each model that have a density.
const DRAWS: usize = 10;
/// A lobe with fewer samples is not tested by itself.
const LEAST_SAMPLES: f64 = 100.0;

/// Every model, and every lobe of it that has a density, with random parameters and at random angles.
#[test]
fn every_lobe_samples_its_density_at_drawn_parameters() {
    let mut cases = Vec::new();
    let mut owners = Vec::new();
    for entry in models() {
        let mut rng = rng(7);
        // Strides through the combinations of choices, so that a few draws meet all of each.
        let draws = (0..).map(|i| Drawn::new(entry, 37 * i)).take(4 * DRAWS);
        let dense = draws.filter(|drawn| !is_dirac(&drawn.single()));
        for drawn in dense.take(DRAWS) {
            let theta = INCIDENCES[rng.random_range(0..INCIDENCES.len())];
            cases.push((drawn.description.clone(), theta));
            owners.push(drawn);
        }
    }
    let counts = assert_agreement(&cases);
    let mut tested = BTreeSet::new();
    for (drawn, counts) in owners.iter().zip(counts) {
        for (lobe, count) in drawn.single().lobe_infos().iter().zip(counts) {
            if count > LEAST_SAMPLES {
                tested.insert((drawn.entry.name(), lobe.name));
            }
        }
    }
    let dense = |lobe: &&LobeInfo| !lobe.flags.contains(Flags::DELTA);
    let lobes_of = |entry: &'static RegisteredModel| {
        let lobes = entry.info.lobes.iter().filter(dense);
        lobes.map(|lobe| (entry.name(), lobe.name))
    };
    let all = models().iter().flat_map(lobes_of);
    let missing: Vec<_> = all.filter(|lobe| !tested.contains(lobe)).collect();
    assert!(missing.is_empty(), "lobes that no draw tested: {missing:?}");
}

/// No model is forgotten at its defaults. A model with Dirac lobes alone must give
/// no value and no density.
#[test]
fn every_model_samples_its_density() {
    let mut dense = Vec::new();
    for entry in models() {
        let description = defaults(entry);
        let bsdf: Bsdf = Bsdf::new(&description).unwrap();
        if !is_dirac(&bsdf) {
            dense.push(description);
            continue;
        }
        let mut rng = rng(0);
        for _ in 0..1000 {
            let wo = visible(&bsdf, &mut rng).as_vec3();
            let wi = bsdf.sampled(wo, Vec3::from(uniforms(&mut rng)), None).wi;
            for wi in [wi, visible(&bsdf, &mut rng).as_vec3()] {
                assert_eq!(bsdf.value_pdf(wo, wi, None), ([0.0; 3], 0.0));
                assert_eq!(bsdf.lobe_densities(wo, wi, None).1, [0.0; MAX_LOBES]);
            }
        }
    }
    assert_all_angles(&dense);
}

fn layered(eta: &[f32], ambient_eta: f32, exponents: [f32; 2], deviation: f64) -> Description {
    Description::new("layered")
        .set("eta", eta)
        .set("ambient_eta", &[ambient_eta])
        .set("exponent_reflection", &exponents[..1])
        .set("exponent_transmission", &exponents[1..])
        .set(
            "base_normal",
            &degrees(deviation, 200.0).as_vec3().to_array(),
        )
        .set("specular_weight", &[0.8])
        .set("diffuse_weight", &[0.2])
}

const EXPONENTS: [[f32; 2]; 4] = [[0.0, 0.0], [2.0, 9.0], [90.0, 170.0], [1000.0, 1000.0]];

#[test]
fn layered_samples_its_density() {
    let mut descriptions = Vec::new();
    for exponents in EXPONENTS {
        for deviation in [0.0, 10.0, 70.0] {
            descriptions.push(layered(&[1.4, 1.6, 1.8], 1.0, exponents, deviation));
        }
        let paper = layered(&[1.5; 3], 1.0, exponents, 14.0).choose("variant", "paper");
        descriptions.push(paper);
    }
    assert_all_angles(&descriptions);
}

/// A layer of lower index than the ambient: total reflection beyond the critical angle.
#[test]
fn layered_samples_its_density_under_total_reflection() {
    let descriptions = EXPONENTS.map(|exponents| layered(&[1.2, 1.3, 1.4], 1.5, exponents, 10.0));
    assert_all_angles(&descriptions);
}

fn microfacet(distribution: &str, alpha: f32) -> Description {
    Description::new("microfacet")
        .choose("distribution", distribution)
        .set("alpha", &[alpha])
}

/// Every distribution, stretched where it can be. Masking and Fresnel factor do not change where samples
/// go: that the density is the same with all of them is checked alone.
#[test]
fn microfacet_samples_its_density() {
    let mut descriptions = Vec::new();
    for distribution in ["ggx", "beckmann", "blinn_phong", "abc", "sgd"] {
        descriptions.extend([0.03, 0.3, 1.0].map(|alpha| microfacet(distribution, alpha)));
    }
    for distribution in ["ggx", "beckmann"] {
        let stretched = microfacet(distribution, 0.3).set("anisotropy", &[0.9]);
        descriptions.push(stretched.set("rotation_turns", &[0.4]));
    }
    assert_all_angles(&descriptions);
}

#[test]
fn microfacet_density_is_that_of_the_distribution() {
    let mut rng = rng(1);
    for distribution in ["ggx", "beckmann", "blinn_phong", "abc", "sgd"] {
        let reference: Bsdf = Bsdf::new(&microfacet(distribution, 0.2)).unwrap();
        let pairs: Vec<[Vec3; 2]> = (0..100)
            .map(|_| [(); 2].map(|()| visible(&reference, &mut rng).as_vec3()))
            .collect();
        for masking in ["smith", "schlick", "kelemen", "cook_torrance", "implicit"] {
            for fresnel in ["schlick", "dielectric", "conductor", "film"] {
                let mut description = microfacet(distribution, 0.2)
                    .choose("masking", masking)
                    .choose("fresnel", fresnel);
                if fresnel == "film" {
                    let film = common::films::Kind::Metal.film();
                    description = description.film(film);
                }
                let bsdf: Bsdf = Bsdf::new(&description).unwrap();
                for [wo, wi] in &pairs {
                    assert_eq!(
                        bsdf.value_pdf(*wo, *wi, None).1,
                        reference.value_pdf(*wo, *wi, None).1
                    );
                }
            }
        }
    }
}

/// From a mirror-like highlight over a diffuse part to a rough metal.
#[test]
fn metallic_roughness_samples_its_density() {
    let mut descriptions = Vec::new();
    for roughness in [0.15, 0.5, 1.0] {
        for metallic in [0.0, 0.5, 1.0] {
            descriptions.push(
                Description::new("metallic_roughness")
                    .set("roughness", &[roughness])
                    .set("metallic", &[metallic]),
            );
        }
    }
    assert_all_angles(&descriptions);
}

/// The test itself must be able to fail: a density that is a little wrong is found out.
#[test]
fn a_wrong_density_is_found_out() {
    let wo = degrees(30.0, 40.0).as_vec3().as_dvec3();
    let right = layered(&[1.5; 3], 1.0, [50.0, 50.0], 10.0);
    let samples = observed(&Bsdf::new(&right).unwrap(), wo, 0);
    let wrong = [
        layered(&[1.5; 3], 1.0, [65.0, 50.0], 10.0),
        layered(&[1.5; 3], 1.0, [50.0, 60.0], 10.0),
        layered(&[1.5; 3], 1.0, [50.0, 50.0], 10.5),
        layered(&[1.51, 1.5, 1.49], 1.0, [50.0, 50.0], 11.0),
    ];
    for wrong in wrong {
        let density = expected(&Bsdf::new(&wrong).unwrap(), wo, &samples.places);
        let values = p_values(&samples.counts, &density);
        let least = values.into_iter().fold(1.0, f64::min);
        assert!(least < 1e-9, "p = {least} for {wrong:?}");
    }
}
