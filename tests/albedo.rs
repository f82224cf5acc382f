//! The albedo that the library gives against adaptive integration of its double-precision value.

mod common;
#[path = "common/quadrature.rs"]
mod quadrature;

use common::degrees;
use glam::DVec3;
use pellicle::{Bsdf, Description};
use quadrature::Patch;

/// Difference in the worst channel, relative to the greatest channel.
fn error(description: &Description, theta: f64) -> f64 {
    let wo = degrees(theta, 25.0);
    let double: Bsdf<f64> = Bsdf::new(description).unwrap();
    let truth = over_hemisphere(&|wi| double.eval(wo, wi, None), 1e-5);
    let single: Bsdf<f32> = Bsdf::new(description).unwrap();
    let found = single.albedo(wo.as_vec3(), None);
    let scale = truth.into_iter().fold(0.0, f64::max);
    let differences = (0..3).map(|c| (f64::from(found[c]) - truth[c]).abs() / scale);
    differences.fold(0.0, f64::max)
}

fn assert_worst(descriptions: &[Description], bound: f64) {
    let mut worst = 0.0;
    for description in descriptions {
        for theta in [0.0, 30.0, 60.0, 80.0, 89.0] {
            let error = error(description, theta);
            println!("{error:.2e} at {theta} degrees: {description:?}");
            worst = f64::max(worst, error);
        }
    }
    println!("worst {worst:.2e}, stated {bound:.0e}");
    assert!(worst <= bound, "{worst}");
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
            let oren_nayar = Description::new("oren_nayar").set("sigma", &[sigma]);
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
            descriptions.push(
                Description::new("metallic_roughness")
                    .set("roughness", &[roughness])
                    .set("metallic", &[metallic])
                    .choose("diffuse", diffuse)
                    .set("diffuse_roughness", &[0.6]),
            );
        }
    }
    assert_worst(&descriptions, 2e-3);
}

/// The integral over the hemisphere, begun on a 16 x 32 grid so that no narrow lobe is overlooked.
fn over_hemisphere<const N: usize>(f: &impl Fn(DVec3) -> [f64; N], tolerance: f64) -> [f64; N] {
    const ROWS: usize = 16;
    const COLUMNS: usize = 32;
    let mut sum = [0.0; N];
    for (i, j) in (0..ROWS * COLUMNS).map(|n| (n / COLUMNS, n % COLUMNS)) {
        let cell = Patch::cell(i, j, ROWS, COLUMNS);
        let part = cell.integrate(f, tolerance / (ROWS * COLUMNS) as f64, 8);
        for c in 0..N {
            sum[c] += part[c];
        }
    }
    sum
}
