//! What a call may ask for: some of the lobes, importance in place of radiance, the density of the reverse.

use crate::common::{Drawn, combinations, is_dirac, parallel, rng, uniforms, visible};
use glam::{DVec3, Vec3};
use pellicle::bsdf::{Flags, models};
use pellicle::{Bsdf, Call, Transport};
use rand_pcg::Pcg64Mcg;

/// Draws of each model at the least; more where it has more combinations of choices.
const DRAWS: u64 = 30;
/// Calls of each draw.
const CALLS: usize = 10;

/// Calls `law` with draws of every model and a direction to the viewer.
fn for_every_model(law: impl Fn(&Bsdf<f64>, DVec3, &mut Pcg64Mcg) + Sync) {
    let draws: Vec<_> = models()
        .iter()
        .flat_map(|entry| (0..DRAWS.max(combinations(entry))).map(move |seed| (entry, seed)))
        .collect();
    parallel::map(&draws, |(entry, seed)| {
        let rng = &mut rng(!seed);
        let bsdf = Drawn::new(entry, *seed).double();
        for _ in 0..CALLS {
            let wo = visible(&bsdf, rng);
            law(&bsdf, wo, rng);
        }
    });
}

fn uniform(rng: &mut Pcg64Mcg) -> DVec3 {
    Vec3::from(uniforms(rng)).as_dvec3()
}

/// A direction where the surface is bright.
fn bright(bsdf: &Bsdf<f64>, wo: DVec3, rng: &mut Pcg64Mcg) -> DVec3 {
    let sample = bsdf.sample(wo, uniform(rng), None, &Call::default());
    if sample.pdf > 0.0 {
        sample.wi
    } else {
        visible(bsdf, rng)
    }
}

/// One call for each set of flags among the lobes. No set of the registry contains another one.
fn calls(bsdf: &Bsdf<f64>) -> Vec<Call> {
    let mut sets: Vec<Flags> = Vec::new();
    for lobe in bsdf.lobe_infos() {
        if !sets.contains(&lobe.flags) {
            sets.push(lobe.flags);
        }
    }
    for a in &sets {
        assert!(sets.iter().all(|b| a == b || !a.contains(*b)), "{sets:?}");
    }
    let call = |lobes| Call {
        lobes,
        ..Call::default()
    };
    sets.into_iter().map(call).collect()
}

fn assert_near(found: f64, expected: f64, scale: f64, what: &str) {
    let error = (found - expected).abs();
    assert!(
        error <= 1e-9 * scale + 1e-12,
        "{what}: {found}, not {expected}"
    );
}

#[test]
fn the_lobes_of_calls_add_up() {
    for_every_model(|bsdf, wo, rng| {
        let wi = bright(bsdf, wo, rng);
        let whole = bsdf.evaluate(wo, wi, None, &Call::default());
        let (choices, _) = bsdf.lobes(wo, wi, None);
        let (mut value, mut pdf) = ([0.0; 3], 0.0);
        for call in calls(bsdf) {
            let part = bsdf.evaluate(wo, wi, None, &call);
            let own = |lobe: &usize| call.lobes.contains(bsdf.lobe_infos()[*lobe].flags);
            let probability: f64 = (0..bsdf.lobe_infos().len())
                .filter(own)
                .map(|lobe| choices[lobe])
                .sum();
            pdf += probability * part.pdf;
            value = std::array::from_fn(|c| value[c] + part.value[c]);
        }
        assert_near(pdf, whole.pdf, whole.pdf, "density");
        let scale = whole.value.into_iter().fold(whole.pdf, f64::max);
        for (sum, whole) in value.into_iter().zip(whole.value) {
            assert_near(sum, whole, scale, "value");
        }
    });
}

#[test]
fn samples_are_of_the_lobes_asked_for() {
    for_every_model(|bsdf, wo, rng| {
        for call in calls(bsdf) {
            let sample = bsdf.sample(wo, uniform(rng), None, &call);
            if sample.flags == Flags(0) {
                continue;
            }
            assert_eq!(sample.flags, call.lobes);
            let (value, pdf) = bsdf.eval_pdf(wo, sample.wi, None, &call);
            assert_near(sample.pdf, pdf, pdf, "density");
            for (weight, value) in sample.weight.into_iter().zip(value) {
                assert_near(weight * pdf, value, pdf + value, "weight");
            }
        }
        let nothing = Call {
            lobes: Flags(0),
            ..Call::default()
        };
        let wi = bright(bsdf, wo, rng);
        let found = bsdf.evaluate(wo, wi, None, &nothing);
        assert_eq!((found.value, found.pdf), ([0.0; 3], 0.0));
        assert_eq!(
            bsdf.sample(wo, DVec3::splat(0.5), None, &nothing).flags,
            Flags(0)
        );
        assert_eq!(bsdf.albedo(wo, None, &nothing), [0.0; 3]);
    });
}

#[test]
fn a_sample_tells_the_probability_of_its_lobe() {
    for_every_model(|bsdf, wo, rng| {
        let sample = bsdf.sample(wo, uniform(rng), None, &Call::default());
        if sample.flags != Flags(0) {
            let (choices, _) = bsdf.lobes(wo, wo, None);
            assert_near(
                sample.lobe_probability,
                choices[sample.lobe],
                1.0,
                "probability",
            );
        }
    });
}

#[test]
fn the_reverse_density_is_that_of_the_reverse() {
    for_every_model(|bsdf, wo, rng| {
        let wi = bright(bsdf, wo, rng);
        let found = bsdf.evaluate(wo, wi, None, &Call::default());
        let reverse = bsdf.evaluate(wi, wo, None, &Call::default());
        assert_eq!(found.pdf_reverse, reverse.pdf);
    });
}

/// Importance lacks the factor (eta_o / eta_i)^2 of refracted radiance: Veach 1997, section 5.2.
#[test]
fn importance_is_radiance_without_the_factor_of_refraction() {
    let mut refracted = std::sync::atomic::AtomicUsize::new(0);
    for_every_model(|bsdf, wo, rng| {
        let u = uniform(rng);
        let importance = Call {
            transport: Transport::Importance,
            ..Call::default()
        };
        let [radiance, importance] =
            [Call::default(), importance].map(|call| bsdf.sample(wo, u, None, &call));
        assert_eq!(radiance.wi, importance.wi);
        for c in 0..3 {
            let expected = radiance.weight[c] * radiance.eta.powi(2);
            assert_near(importance.weight[c], expected, expected, "importance");
        }
        if is_dirac(bsdf) && radiance.eta != 1.0 && radiance.eta != 0.0 {
            refracted.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        }
    });
    assert!(*refracted.get_mut() > 20, "hardly any refraction was tried");
}
