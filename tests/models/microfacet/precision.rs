//! The `microfacet` model in single precision, from alpha = 1e-4 to 1, against its double-precision
//! instance; and the weights of visible-normal sampling.

use super::rough::{DISTRIBUTIONS, MASKINGS, double, masking, stretched, white};
use crate::common;
use crate::common::calls::Calls;
use crate::common::{hemisphere, rng, rounded, uniforms};
use glam::{DVec3, Vec3};
use pellicle::{Bsdf, Description};

const ALPHAS: [f32; 8] = [1e-4, 3e-4, 1e-3, 0.01, 0.1, 0.3, 0.7, 1.0];

fn single(description: &Description) -> Bsdf<f32> {
    Bsdf::new(description).unwrap()
}

/// A viewer anywhere, often close to the horizon.
fn viewer(rng: &mut impl rand::Rng) -> Vec3 {
    let mut wo = hemisphere(rng);
    if uniforms(rng)[0] < 0.3 {
        wo.z *= 10f64.powf(-4.0 * f64::from(uniforms(rng)[1]));
        wo = wo.normalize();
    }
    rounded(wo).0
}

/// Values and densities where the light is, for the same rounded directions.
#[test]
fn single_precision_follows_double_down_to_the_smoothest() {
    let mut worst = 0.0;
    for distribution in DISTRIBUTIONS {
        for alpha in ALPHAS {
            for name in MASKINGS {
                for description in stretched(distribution, &white(distribution, name, alpha)) {
                    let (single, double) = (single(&description), double(&description));
                    let mut rng = rng(1);
                    for _ in 0..100 {
                        let wo = viewer(&mut rng);
                        let sample = single.sampled(wo, Vec3::from(uniforms(&mut rng)), None);
                        if sample.pdf == 0.0 {
                            continue;
                        }
                        let (value, pdf) = single.value_pdf(wo, sample.wi, None);
                        let wi = sample.wi.as_dvec3();
                        let (true_value, true_pdf) = double.value_pdf(wo.as_dvec3(), wi, None);
                        let errors = [
                            f64::from(value[0]) / true_value[0] - 1.0,
                            f64::from(pdf) / true_pdf - 1.0,
                        ];
                        for error in errors {
                            // Numbers that single precision flushes to 0 have no digits to lose.
                            if true_value[0] > 1e-25 && true_pdf > 1e-25 {
                                worst = f64::max(worst, error.abs());
                                assert!(error.abs() < 1e-3, "{description:?} {wo} {wi}: {error:e}");
                            }
                        }
                    }
                }
            }
        }
    }
    println!("worst relative error {worst:.1e}");
}

/// weight = F G2 / G1, which no viewer sees above 1: Heitz and d'Eon 2014, eq. 19.
#[test]
fn weights_of_visible_normals_are_masking_alone() {
    for distribution in ["ggx", "beckmann"] {
        for alpha in ALPHAS {
            let smith = stretched(distribution, &white(distribution, "smith", alpha));
            let implicit = stretched(distribution, &white(distribution, "implicit", alpha));
            for (description, implicit) in smith.iter().zip(&implicit) {
                let (surface, implicit) = (double(description), double(implicit));
                let fast = single(description);
                let mut rng = rng(2);
                for _ in 0..200 {
                    let wo = viewer(&mut rng).as_dvec3();
                    let u = Vec3::from(uniforms(&mut rng));
                    let weight = fast.sampled(wo.as_vec3(), u, None).weight[0];
                    assert!(
                        (0.0..=1.000_01).contains(&weight),
                        "{description:?} {wo}: {weight}"
                    );
                    let sample = surface.sampled(wo, u.as_dvec3(), None);
                    if sample.pdf < 1e-30 {
                        continue;
                    }
                    let mirrored = DVec3::new(-wo.x, -wo.y, wo.z);
                    let g1 = 2.0 / (1.0 / masking(&surface, &implicit, wo, mirrored) + 1.0);
                    let g2 = masking(&surface, &implicit, wo, sample.wi);
                    let error = (sample.weight[0] / (g2 / g1) - 1.0).abs();
                    assert!(error < 1e-9, "{description:?} {wo}: {error:e}");
                }
            }
        }
    }
}

/// What single precision returns is what double precision returns: the mean weight over the same
/// random numbers.
#[test]
fn albedo_does_not_depend_on_the_precision() {
    for distribution in DISTRIBUTIONS {
        for alpha in ALPHAS {
            let description = white(distribution, "smith", alpha);
            let (single, double) = (single(&description), double(&description));
            for theta in [0.0, 45.0, 80.0, 89.5] {
                let (wo, true_wo) = rounded(common::degrees(theta, 20.0));
                let (found, expected) = (
                    single.directional_albedo(wo, None)[0],
                    double.directional_albedo(true_wo, None)[0],
                );
                let error = (f64::from(found) - expected).abs();
                assert!(
                    error < 1e-3,
                    "{distribution} {alpha} {theta}: {found} {expected}"
                );
            }
        }
    }
}

/// Directions as far out as numbers go.
#[test]
fn the_horizon_is_finite() {
    let heights = [f32::MIN_POSITIVE, 1e-30, 1e-20, 1e-10, 1e-6, 1e-3, 1.0];
    for distribution in DISTRIBUTIONS {
        for alpha in ALPHAS {
            for name in MASKINGS {
                for description in stretched(distribution, &white(distribution, name, alpha)) {
                    let surface = single(&description);
                    for (wo, wi) in pairs(&heights) {
                        let (value, pdf) = surface.value_pdf(wo, wi, None);
                        let sample = surface.sampled(wo, Vec3::new(0.3, 0.4, 0.6), None);
                        for number in [value[0], pdf, sample.weight[0], sample.pdf] {
                            assert!(
                                number.is_finite() && number >= 0.0,
                                "{description:?} {wo:?} {wi:?}: {value:?} {pdf} {sample:?}"
                            );
                        }
                    }
                }
            }
        }
    }
}

/// At every pair of heights: opposite, beside each other, and at a right angle.
fn pairs(heights: &[f32]) -> Vec<(Vec3, Vec3)> {
    let mut all = Vec::new();
    for &a in heights {
        for &b in heights {
            let at = |x: f32, y: f32, z: f32| {
                let radius = (1.0 - z * z).max(0.0).sqrt();
                Vec3::new(x * radius, y * radius, z)
            };
            let wo = at(1.0, 0.0, a);
            all.extend([(-1.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| (wo, at(x, y, b))));
        }
    }
    all
}
