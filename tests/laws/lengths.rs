//! Directions whose length is 1 to within 1e-3 are normalised: results are those of the unit directions, samples have
//! unit length, and evaluations agree with them. That batches give the same bits is tried in `batch`.

use crate::common::calls::Calls;
use crate::common::parallel;
use crate::common::{Drawn, combinations, degrees, hemisphere, is_dirac, rng, uniforms, visible};
use glam::{DVec3, Vec3};
use pellicle::bsdf::{Flags, Precision, models};
use pellicle::{Bsdf, Description, Sample};
use rand::{Rng, RngExt};

/// The greatest length that is accepted, and a little less, in single precision.
const LONGEST: f64 = 1.0 + 0.9999e-3;

/// A length within 1e-3 of 1; now and then a bound.
fn length(rng: &mut impl Rng) -> f64 {
    match rng.random_range(0..8) {
        0 => LONGEST,
        1 => 2.0 - LONGEST,
        2 => 1.0 + rng.random_range(-3e-6..3e-6),
        _ => rng.random_range(2.0 - LONGEST..LONGEST),
    }
}

/// Calls `law` with draws of every model.
fn for_draws(law: impl Fn(&Drawn, u64) + Sync) {
    let draws: Vec<_> = models()
        .iter()
        .flat_map(|entry| (0..combinations(entry).max(20)).map(move |seed| (entry, seed)))
        .collect();
    parallel::map(&draws, |(entry, seed)| {
        law(&Drawn::new(entry, *seed), *seed)
    });
}

fn length_error<T: Precision>(wi: T::Vector) -> f64 {
    let wi: [T; 3] = wi.into();
    let [x, y, z]: [f64; 3] = wi.map(Into::into);
    (DVec3::new(x, y, z).length() - 1.0).abs()
}

/// Tries the samples of one BSDF in one precision. `vector` converts a direction to it.
fn samples_agree<T: Precision>(
    bsdf: &Bsdf<T>,
    vector: impl Fn(DVec3) -> T::Vector,
    drawn: &Drawn,
    seed: u64,
) {
    let rng = &mut rng(!seed);
    for _ in 0..60 {
        let wo = vector(visible(bsdf, rng) * length(rng));
        let u = uniforms(rng).map(f64::from);
        let sample: Sample<T> = bsdf.sampled(wo, vector(DVec3::from_array(u)), None);
        if sample.flags == Flags(0) {
            continue;
        }
        let error = length_error::<T>(sample.wi);
        assert!(error <= 1e-6, "length off by {error}");
        if sample.flags.contains(Flags::DELTA) {
            continue;
        }
        let (value, pdf) = bsdf.value_pdf(wo, sample.wi, None);
        assert!(pdf > T::new(0.0), "a sample's own density is 0");
        assert!(
            pdf == sample.pdf,
            "{pdf:?} is not {:?}: {:?} {:?}",
            sample.pdf,
            Into::<[T; 3]>::into(wo),
            drawn.description
        );
        for (value, weight) in value.into_iter().zip(sample.weight) {
            let (value, weighted): (f64, f64) = (value.into(), (weight * pdf).into());
            assert!((value - weighted).abs() <= 1e-6 * value + 1e-37);
        }
    }
}

#[test]
fn samples_have_unit_length_and_evaluate_to_themselves() {
    for_draws(|drawn, seed| {
        samples_agree(&drawn.single(), |w| w.as_vec3(), drawn, seed);
        samples_agree(&drawn.double(), |w| w, drawn, seed);
    });
}

#[test]
fn results_are_those_of_the_unit_directions() {
    for_draws(|drawn, seed| {
        let rng = &mut rng(seed);
        let (single, double) = (drawn.single(), drawn.double());
        if is_dirac(&single) {
            return;
        }
        for _ in 0..60 {
            let wo = hemisphere(rng);
            let u = Vec3::from(uniforms(rng)).as_dvec3();
            let wi = double.sampled(wo, u, None).wi;
            if wi.z <= 0.0 {
                continue;
            }
            let long = [wo, wi].map(|w| (w * length(rng)).as_vec3());
            let [wo, wi] = long.map(|w| w.as_dvec3().normalize());
            let truth = numbers(double.value_pdf(wo, wi, None));
            // What single precision changes in a direction; sharp lobes turn it into much more.
            let mut spread = [0.0_f64; 4];
            for axis in DVec3::AXES {
                for change in [axis * 1.2e-7, axis * -1.2e-7] {
                    for (wo, wi) in [(wo + change, wi), (wo, wi + change)] {
                        let near = numbers(double.value_pdf(wo, wi, None));
                        for i in 0..4 {
                            spread[i] = spread[i].max((near[i] - truth[i]).abs());
                        }
                    }
                }
            }
            let found = numbers(single.value_pdf(long[0], long[1], None));
            for i in 0..4 {
                // Besides, as `single_precision_follows_double`.
                let allowed = 4.0 * spread[i] + 5e-3 * (truth[i] + truth[3]) + 3e-7;
                assert!(
                    (found[i] - truth[i]).abs() <= allowed,
                    "{:?} {long:?}: {found:?} instead of {truth:?}",
                    drawn.description
                );
            }
        }
    });
}

/// Value and density.
fn numbers<T: Precision>((value, pdf): ([T; 3], T)) -> [f64; 4] {
    [value[0], value[1], value[2], pdf].map(Into::into)
}

/// Half a thousandth of length moved the half vector by a multiple of the highlight's width.
#[test]
fn a_sharp_highlight_at_grazing_angles_stays() {
    let bsdf: Bsdf = Bsdf::new(&Description::new("microfacet").set("alpha", &[1e-3])).unwrap();
    let wo = degrees(80.0, 30.0);
    let wi = DVec3::new(-wo.x, -wo.y, wo.z).as_vec3();
    let [truth, ..] = bsdf.value(wo.as_vec3(), wi, None);
    for scale in [0.999, 0.9995, 1.0005, 1.001] {
        for (wo, wi) in [
            ((wo * scale).as_vec3(), wi),
            (wo.as_vec3(), (wi.as_dvec3() * scale).as_vec3()),
        ] {
            let [found, ..] = bsdf.value(wo, wi, None);
            assert!(
                (found - truth).abs() <= 0.01 * truth,
                "{scale}: {found} of {truth}"
            );
        }
    }
}

#[test]
fn lengths_within_a_thousandth_are_accepted_and_others_give_zero() {
    let bsdf: Bsdf = Bsdf::new(&Description::new("lambert")).unwrap();
    for seed in 0..1000 {
        let w = hemisphere(&mut rng(seed));
        for (length, is_accepted) in [
            (0.999, true),
            (1.001, true),
            (0.9989, false),
            (1.0011, false),
        ] {
            let w = (w * length).as_vec3();
            let up = Vec3::Z;
            for [value, ..] in [bsdf.value(w, up, None), bsdf.value(up, w, None)] {
                assert_eq!(value > 0.0, is_accepted, "{length}: {w}");
            }
        }
    }
}
