//! A parameter that is given per call means the same as one that is fixed, over the whole registry:
//! a BSDF created with the value fixed is compared with one created with another value and called with
//! this one. Values within ranges that creation accepts; directions and thicknesses too.

use crate::common::calls::Calls;
use crate::common::{
    Drawn, Variation, combinations, hemisphere, is_dirac, parallel, rng, uniforms,
};
use glam::{DVec3, Vec3};
use pellicle::bsdf::Precision;
use pellicle::bsdf::{RegisteredModel, models};
use pellicle::{Bsdf, Sample};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

/// Draws of each model at the least; more where it has more combinations of choices.
const DRAWS: u64 = 40;
/// Comparisons that each parameter that can vary must have been part of.
const LEAST_COMPARISONS: usize = 10;
/// Pairs of directions, and samples, of each comparison.
const CALLS: usize = 12;

/// In double precision both ways use the same formulas; what is left are roundings of powers with exponents
/// up to 1e5 and of phases of films.
const TOLERANCE: f64 = 1e-8;
/// Where light that masking takes away is given back, a roughness that varies is looked up in another table of
/// the albedo E than a fixed one. Both tables are within 1e-3 of E, and the light given back has two factors
/// 1 - E over the mean of another, so that its error is some times as large.
const TABLE_TOLERANCE: f64 = 1e-2;
/// In single precision a fixed value may have formulas of its own: the error that
/// `registry::single_precision_follows_double` allows, on either side.
const SINGLE_TOLERANCE: f64 = 1e-2;

fn tolerance(drawn: &Drawn) -> f64 {
    let gives_back = match drawn.entry.name() {
        "microfacet" => drawn.choice("energy_compensation") == "on",
        name => name == "metallic_roughness",
    };
    if gives_back {
        TABLE_TOLERANCE
    } else {
        TOLERANCE
    }
}

/// What was compared of one parameter.
#[derive(Clone, Copy, Default)]
struct Tally {
    comparisons: usize,
    /// Those in which another value gave another result: a parameter without any is ignored.
    effects: usize,
}

/// A direction pair, and the numbers of a sample.
struct Call {
    wo: DVec3,
    wi: DVec3,
    u: DVec3,
}

/// Everything that a call returns. A sample counts only where its lobe is chosen for sure in either
/// rounding: `u` is kept away from the edges between lobes by being compared with its neighbours.
struct Results {
    value: [f64; 3],
    pdf: f64,
    sample: Option<([f64; 3], [f64; 3], f64, usize)>,
}

fn call<T: Precision>(bsdf: &Bsdf<T>, call: &Call, varying: Option<&[f32]>) -> Results
where
    f64: From<T>,
{
    let vector = |w: DVec3| T::Vector::from(w.to_array().map(T::new));
    let numbers: Option<Vec<T>> =
        varying.map(|numbers| numbers.iter().map(|n| T::new(*n as f64)).collect());
    let varying = numbers.as_deref();
    let (value, pdf) = bsdf.value_pdf(vector(call.wo), vector(call.wi), varying);
    let sampled = |u: DVec3| bsdf.sampled(vector(call.wo), vector(u), varying);
    let neighbours =
        [-1e-5, 1e-5].map(|step| sampled(DVec3::new(call.u.x + step, call.u.y, call.u.z)));
    let sample: Sample<T> = sampled(call.u);
    let is_sure = neighbours.iter().all(|other| {
        other.lobe == sample.lobe && (f64::from(other.pdf) == 0.0) == (f64::from(sample.pdf) == 0.0)
    });
    let wi: [T; 3] = sample.wi.into();
    Results {
        value: value.map(f64::from),
        pdf: f64::from(pdf),
        sample: is_sure.then(|| {
            let weight = sample.weight.map(f64::from);
            (
                wi.map(f64::from),
                weight,
                f64::from(sample.pdf),
                sample.lobe,
            )
        }),
    }
}

impl Results {
    /// The greatest difference: of values and densities relative to their size, of directions absolute.
    fn difference(&self, other: &Self) -> f64 {
        let scale = self.pdf.max(1e-3) + self.value.into_iter().fold(0.0, f64::max);
        let mut worst = (self.pdf - other.pdf).abs() / scale;
        for c in 0..3 {
            worst = worst.max((self.value[c] - other.value[c]).abs() / scale);
        }
        if let (Some(own), Some(others)) = (&self.sample, &other.sample) {
            if own.3 != others.3 {
                return f64::INFINITY;
            }
            for c in 0..3 {
                worst = worst.max((own.0[c] - others.0[c]).abs());
                let scale = own.1.into_iter().fold(1e-3, f64::max);
                worst = worst.max((own.1[c] - others.1[c]).abs() / scale);
            }
            worst = worst.max((own.2 - others.2).abs() / own.2.max(1e-3));
        }
        worst
    }
}

/// Directions anywhere, and samples of the surface where its light is.
fn calls(bsdf: &Bsdf<f64>, rng: &mut Pcg64Mcg) -> Vec<Call> {
    let mut draw = |i: usize| {
        let wo = if is_dirac(bsdf) {
            crate::common::visible(bsdf, rng)
        } else {
            hemisphere(rng)
        };
        let u = Vec3::from(uniforms(rng))
            .as_dvec3()
            .clamp(DVec3::splat(1e-3), DVec3::splat(0.999));
        let mut wi = hemisphere(rng);
        if i.is_multiple_of(2) {
            let sample = bsdf.sampled(wo, u, None);
            if sample.pdf > 0.0 {
                wi = sample.wi;
            }
        }
        let [wo, wi] = [wo, wi].map(|w| w.as_vec3().as_dvec3());
        Call { wo, wi, u }
    };
    (0..CALLS).map(&mut draw).collect()
}

/// Compares one draw in which the parameters that `may` chooses vary; adds to the tally of each.
fn compare(drawn: &Drawn, rng: &mut Pcg64Mcg, may: impl Fn(usize) -> bool, tally: &mut [Tally]) {
    let (varied, variations) = drawn.varied(rng, may);
    if variations.is_empty() {
        return;
    }
    let values: Vec<(usize, Vec<f32>)> = variations
        .iter()
        .map(|variation| (variation.param, drawn.draw_within(*variation, rng)))
        .collect();
    let numbers: Vec<f32> = values
        .iter()
        .flat_map(|(_, numbers)| numbers.clone())
        .collect();
    let fixed = drawn.with(&values);
    let double = Bsdf::<f64>::new(&varied).unwrap();
    let single = Bsdf::<f32>::new(&varied).unwrap();
    // Creation accepts every value of a range that it accepts.
    let fixed_double =
        Bsdf::<f64>::new(&fixed).unwrap_or_else(|error| panic!("{varied:?}: {error}"));
    let fixed_single = Bsdf::<f32>::new(&fixed).unwrap();
    let mut has_effect = false;
    for given in calls(&fixed_double, rng) {
        let expected = call(&fixed_double, &given, None);
        let found = call(&double, &given, Some(&numbers));
        let what = || {
            format!(
                "{varied:?}\ngiven {numbers:?}, wo {} wi {} u {}",
                given.wo, given.wi, given.u
            )
        };
        let difference = expected.difference(&found);
        assert!(
            difference <= tolerance(drawn),
            "{difference:e} in double precision: {}",
            what()
        );
        let expected = call(&fixed_single, &given, None);
        let difference = expected.difference(&call(&single, &given, Some(&numbers)));
        assert!(
            difference <= SINGLE_TOLERANCE,
            "{difference:e} in single precision: {}",
            what()
        );
        has_effect |= call(&double, &given, None).difference(&found) > 2.0 * tolerance(drawn);
    }
    for variation in &variations {
        let tally = &mut tally[variation.param];
        tally.comparisons += 1;
        tally.effects += usize::from(has_effect && variations.len() == 1);
    }
}

/// Each draw with all parameters varying that may, and with one of them.
fn compare_model(entry: &'static RegisteredModel) -> Vec<Tally> {
    let can_vary: Vec<usize> = (0..entry.info.params.len())
        .filter(|param| entry.info.params[*param].can_vary)
        .collect();
    let mut tally = vec![Tally::default(); entry.info.params.len()];
    for seed in 0..DRAWS.max(combinations(entry)) * can_vary.len().max(1) as u64 / 4 {
        let drawn = Drawn::new(entry, seed);
        let rng = &mut rng(!seed);
        compare(&drawn, rng, |_| true, &mut tally);
        if !can_vary.is_empty() {
            // Drawn, because a cycle would be in step with that of the choices.
            let one = can_vary[rng.random_range(0..can_vary.len())];
            compare(&drawn, rng, |param| param == one, &mut tally);
        }
    }
    tally
}

#[test]
fn a_value_given_per_call_is_that_value_fixed() {
    let entries: Vec<&RegisteredModel> = models().iter().collect();
    let tallies = parallel::map(&entries, |entry| compare_model(entry));
    let mut missing = Vec::new();
    for (entry, tally) in entries.iter().zip(tallies) {
        for (param, tally) in entry.info.params.iter().zip(tally) {
            println!(
                "{} {}: {} compared, {} with an effect",
                entry.name(),
                param.name(),
                tally.comparisons,
                tally.effects
            );
            if param.can_vary && (tally.comparisons < LEAST_COMPARISONS || tally.effects == 0) {
                missing.push(format!(
                    "{} {}: {} comparisons, {} with an effect",
                    entry.name(),
                    param.name(),
                    tally.comparisons,
                    tally.effects
                ));
            }
        }
    }
    assert!(
        missing.is_empty(),
        "parameters that never varied or are ignored: {missing:#?}"
    );
}

/// A number beyond the declared range is the end of the range, bit for bit.
#[test]
fn numbers_beyond_their_range_are_its_ends() {
    for entry in models() {
        let mut compared = vec![0; entry.info.params.len()];
        for seed in 0..DRAWS.max(combinations(entry)) {
            let drawn = Drawn::new(entry, seed);
            let rng = &mut rng(seed);
            let (description, variations) = drawn.varied(rng, |_| true);
            let bsdf = Bsdf::<f32>::new(&description).unwrap();
            let double = Bsdf::<f64>::new(&description).unwrap();
            for beyond in [-1.0, 1.0] {
                let [outside, inside] = [true, false].map(|is_outside| {
                    let of = |variation: &Variation| ends(&drawn, variation, beyond, is_outside);
                    variations.iter().flat_map(of).collect::<Vec<f32>>()
                });
                for given in calls(&double, rng) {
                    let [found, expected] =
                        [&outside, &inside].map(|numbers| call(&bsdf, &given, Some(numbers)));
                    assert_eq!(
                        found.difference(&expected),
                        0.0,
                        "{description:?} {outside:?}"
                    );
                    let [found, expected] =
                        [&outside, &inside].map(|numbers| call(&double, &given, Some(numbers)));
                    assert_eq!(
                        found.difference(&expected),
                        0.0,
                        "{description:?} {outside:?}"
                    );
                }
            }
            for variation in variations {
                compared[variation.param] += 1;
            }
        }
        for (param, count) in entry.info.params.iter().zip(compared) {
            assert!(
                !param.can_vary || count >= LEAST_COMPARISONS,
                "{} {}: {count}",
                entry.name(),
                param.name()
            );
        }
    }
}

/// A number beyond the lower or upper end of a range, or that end; of a direction the same upward one.
fn ends(drawn: &Drawn, variation: &Variation, beyond: f32, is_outside: bool) -> Vec<f32> {
    let components = drawn.entry.info.params[variation.param].components();
    let [min, max] = variation.range;
    if min == max {
        return vec![0.1, 0.2, 0.9];
    }
    let end = if beyond < 0.0 { min } else { max };
    let number = if is_outside {
        end + beyond * (1.0 + end.abs())
    } else {
        end
    };
    vec![number; components]
}
