//! The albedo that the library gives against adaptive integration of its double-precision value.

use crate::common::calls::Calls;
use crate::common::quadrature::Patch;
use crate::common::{Drawn, defaults, degrees, is_dirac, parallel, rng, roughness_of, uniforms};
use glam::{DVec3, Vec3};
use pellicle::bsdf::{RegisteredModel, models};
use pellicle::{Bsdf, Description};
use rand::RngExt;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Samples that tell where a surface is bright.
const SAMPLES: usize = 20_000;

/// Difference in the worst channel, relative to the greatest channel.
fn error(description: &Description, theta: f64) -> f64 {
    let wo = degrees(theta, 25.0);
    let double: Bsdf<f64> = Bsdf::new(description).unwrap();
    let single: Bsdf<f32> = Bsdf::new(description).unwrap();
    let mut rng = rng(1);
    let samples =
        (0..SAMPLES).map(|_| single.sampled(wo.as_vec3(), Vec3::from(uniforms(&mut rng)), None));
    let places: Vec<[f64; 2]> = samples
        .filter(|sample| sample.pdf > 0.0)
        .map(|sample| {
            let wi = sample.wi.as_dvec3();
            [wi.z, wi.y.atan2(wi.x).rem_euclid(TAU)]
        })
        .collect();
    let found = single.directional_albedo(wo.as_vec3(), None);
    // The truth to a twentieth of the least bound. The library's own albedo only says how large it is.
    let size = found.into_iter().fold(1e-3, f32::max);
    let tolerance = 1e-4 * f64::from(size);
    let truth = over_hemisphere(&|wi| double.value(wo, wi, None), tolerance, &places);
    let scale = truth.into_iter().fold(0.0, f64::max);
    let differences = (0..3).map(|c| (f64::from(found[c]) - truth[c]).abs() / scale);
    differences.fold(0.0, f64::max)
}

fn assert_worst(descriptions: &[Description], bound: f64) {
    let cases: Vec<_> = descriptions
        .iter()
        .flat_map(|description| [0.0, 30.0, 60.0, 80.0, 89.0].map(|theta| (description, theta)))
        .collect();
    let errors = parallel::map(&cases, |(description, theta)| error(description, *theta));
    let mut failures = Vec::new();
    for ((description, theta), error) in cases.iter().zip(&errors) {
        println!("{error:.2e} at {theta} degrees: {description:?}");
        if error.is_nan() || *error > bound {
            failures.push(format!("{error:.2e} at {theta} degrees: {description:?}"));
        }
    }
    assert!(failures.is_empty(), "beyond {bound:.0e}: {failures:#?}");
}

/// Draws of each model.
const DRAWS: u64 = 10;

/// The bound that src/bsdf/quadrature.rs states for all models, and the wider ones of microfacets whose samples are
/// not those of visible normals.
fn stated_bound(drawn: &Drawn) -> f64 {
    if drawn.entry.name() == "microfacet" {
        1.5e-2
    } else {
        3e-3
    }
}

/// Every model at random parameters. A surface without a density has an albedo
/// that is a sum over its lobes; `registry::weights_add_up_to_the_albedo` tries it.
#[test]
fn every_model_is_within_its_bound_at_drawn_parameters() {
    let mut draws = Vec::new();
    for entry in models() {
        let mut rng = rng(5);
        // Strides through the combinations of choices, so that a few draws meet all of each.
        for i in 0..DRAWS {
            let theta = [0.0, 30.0, 60.0, 80.0][rng.random_range(0..4)];
            draws.push((Drawn::new(entry, 37 * i), theta));
        }
    }
    let errors = parallel::map(&draws, |(drawn, theta)| {
        (!is_dirac(&drawn.single())).then(|| error(&drawn.description, *theta))
    });
    let mut failures = Vec::new();
    let mut tested = BTreeMap::new();
    for ((drawn, theta), error) in draws.iter().zip(&errors) {
        let bound = stated_bound(drawn);
        *tested.entry(drawn.entry.name()).or_insert(0) += usize::from(error.is_some());
        if error.is_some_and(|error| error.is_nan() || error > bound) {
            failures.push(format!(
                "{error:.2?} at {theta} degrees: {:?}",
                drawn.description
            ));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
    let dense = |entry: &&RegisteredModel| !is_dirac(&Bsdf::<f32>::new(&defaults(entry)).unwrap());
    for entry in models().iter().filter(dense) {
        assert!(
            tested[entry.name()] >= 5,
            "{} is hardly tested",
            entry.name()
        );
    }
}

#[test]
fn lambert_is_exact() {
    assert_worst(
        &[Description::new("lambert").set("reflectance", &[0.1, 0.5, 1.0])],
        1e-6,
    );
}

#[test]
fn phong_is_within_its_bound() {
    let descriptions = [0.0, 1.0, 50.0, 1000.0].map(|exponent| {
        Description::new("phong")
            .set("exponent", &[exponent])
            .set("specular", &[0.1, 0.3, 0.5])
    });
    assert_worst(&descriptions, 2e-3);
}

/// Both variants, broad and narrow lobes, parallel and deviated boundaries.
#[test]
fn layered_is_within_its_bound() {
    let mut descriptions = Vec::new();
    for (variant, weights) in [("paper", [1.0, 0.5]), ("energy", [0.7, 0.3])] {
        for exponents in [[0.0, 0.0], [3.0, 10.0], [90.0, 170.0], [1000.0, 1000.0]] {
            for (deviation, thickness) in [(0.0, 70.0), (10.0, 300.0), (30.0, 3000.0)] {
                descriptions.push(
                    Description::new("layered")
                        .set("eta", &[1.4, 1.5, 1.7])
                        .set("exponent_reflection", &exponents[..1])
                        .set("exponent_transmission", &exponents[1..])
                        .set("thickness_nm", &[thickness])
                        .set(
                            "base_normal",
                            &degrees(deviation, 70.0).as_vec3().to_array(),
                        )
                        .set("specular_weight", &weights[..1])
                        .set("diffuse_weight", &weights[1..])
                        .choose("variant", variant),
                );
            }
        }
    }
    assert_worst(&descriptions, 2e-3);
}

/// Every distribution and masking. Where samples are not those of visible normals, or masking is not
/// the distribution's own, weights at 89 degrees reach 1 / cos, and the lattice is worse there.
#[test]
fn microfacet_is_within_its_bound() {
    for (distribution, bound) in [
        ("ggx", 2e-3),
        ("beckmann", 5e-3),
        ("blinn_phong", 2e-3),
        ("abc", 1.5e-2),
        ("sgd", 3e-3),
    ] {
        let mut descriptions = Vec::new();
        for masking in ["smith", "schlick", "kelemen", "cook_torrance", "implicit"] {
            for alpha in [0.1, 0.4, 1.0] {
                let description = Description::new("microfacet")
                    .choose("distribution", distribution)
                    .choose("masking", masking)
                    .set("f0", &[0.1, 0.5, 1.0])
                    .set("alpha", &[alpha]);
                descriptions.push(description);
            }
        }
        assert_worst(&descriptions, bound);
    }
}

/// The cosine's samples leave `oren_nayar` weights that reach sin / cos at 89 degrees, near the horizon on
/// the viewer's side, where a step of the lattice is as wide as their peak.
#[test]
fn oren_nayar_is_within_its_bound() {
    let mut descriptions = Vec::new();
    for sigma in [0.1, 0.35, 1.5] {
        for form in ["full", "qualitative"] {
            let oren_nayar = Description::new("oren_nayar").set("sigma_radians", &[sigma]);
            descriptions.push(oren_nayar.choose("form", form));
        }
    }
    assert_worst(&descriptions, 3e-3);
}

#[test]
fn disney_diffuse_is_within_its_bound() {
    let descriptions = [0.0, 0.5, 1.0]
        .map(|roughness| Description::new("disney_diffuse").set("roughness", &[roughness]));
    assert_worst(&descriptions, 2e-3);
}

#[test]
fn metallic_roughness_is_within_its_bound() {
    let mut descriptions = Vec::new();
    for roughness in [0.2, 0.5, 1.0] {
        for (metallic, diffuse) in [
            (0.0, "lambert"),
            (0.5, "oren_nayar"),
            (0.0, "disney"),
            (1.0, "lambert"),
        ] {
            let description = Description::new("metallic_roughness")
                .set("roughness", &[roughness])
                .set("metallic", &[metallic])
                .choose("diffuse_form", diffuse);
            descriptions.push(match roughness_of(diffuse) {
                Some(param) => description.set(param, &[0.6]),
                None => description,
            });
        }
    }
    assert_worst(&descriptions, 2e-3);
}

/// The integral over the hemisphere, begun on a 16 x 32 grid and quartered where samples are, so that no narrow
/// lobe is overlooked.
fn over_hemisphere<const N: usize>(
    f: &impl Fn(DVec3) -> [f64; N],
    tolerance: f64,
    places: &[[f64; 2]],
) -> [f64; N] {
    const ROWS: usize = 16;
    const COLUMNS: usize = 32;
    let mut inside = vec![vec![]; ROWS * COLUMNS];
    for place in places {
        let row = ((place[0] * ROWS as f64) as usize).min(ROWS - 1);
        let column = ((place[1] / TAU * COLUMNS as f64) as usize).min(COLUMNS - 1);
        inside[row * COLUMNS + column].push(*place);
    }
    let mut sum = [0.0; N];
    for (n, inside) in inside.iter().enumerate() {
        let cell = Patch::cell(n / COLUMNS, n % COLUMNS, ROWS, COLUMNS);
        let part = cell.integrate_about(f, tolerance / (ROWS * COLUMNS) as f64, 8, inside);
        for c in 0..N {
            sum[c] += part[c];
        }
    }
    sum
}
