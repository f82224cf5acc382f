//! Descriptions of the `microfacet` model, and what its factors are.

#![allow(dead_code)] // each test program uses a part

use crate::common::calls::Calls;
use glam::DVec3;
use pellicle::{Bsdf, Description};

pub const DISTRIBUTIONS: [&str; 5] = ["ggx", "beckmann", "blinn_phong", "abc", "sgd"];
pub const MASKINGS: [&str; 5] = ["smith", "schlick", "kelemen", "cook_torrance", "implicit"];

/// With F = 1.
pub fn white(distribution: &str, masking: &str, alpha: f32) -> Description {
    Description::new("microfacet")
        .choose("distribution", distribution)
        .choose("masking", masking)
        .set("alpha", &[alpha])
        .set("f0", &[1.0])
}

/// Alone, stretched, and stretched in another direction, where the distribution can be.
pub fn stretched(distribution: &str, description: &Description) -> Vec<Description> {
    let mut all = vec![description.clone()];
    if ["ggx", "beckmann"].contains(&distribution) {
        all.push(description.clone().set("anisotropy", &[0.6]));
        let turned = description.clone().set("rotation_turns", &[0.15]);
        all.push(turned.set("anisotropy", &[1.0]));
    }
    all
}

pub fn double(description: &Description) -> Bsdf<f64> {
    Bsdf::new(description).unwrap()
}

/// D(h) of a white surface with masking `implicit`, G = (n.l)(n.v), from f = D F G / (4 (n.l)(n.v)) in
/// the mirror configuration.
pub fn density(implicit: &Bsdf<f64>, h: DVec3) -> f64 {
    4.0 * implicit.value(h, h, None)[0] / h.z
}

/// G of a white surface, from its value and that of the same surface with masking `implicit`.
pub fn masking(surface: &Bsdf<f64>, implicit: &Bsdf<f64>, wo: DVec3, wi: DVec3) -> f64 {
    surface.value(wo, wi, None)[0] / implicit.value(wo, wi, None)[0] * wo.z * wi.z
}

/// The integral of f over the hemisphere of normals: equal steps in the logarithm of the tangent, by
/// the trapezoidal rule, from `alpha` / 1e5 to 1e5, and in azimuth. What is left out is below 1e-9 of
/// the area for tails no longer than those of GGX.
pub fn over_normals(alpha: f64, azimuths: usize, f: impl Fn(DVec3) -> f64) -> f64 {
    const STEP: f64 = 0.05;
    let [from, to] = [(alpha * 1e-5).ln(), 1e5f64.ln()];
    let count = ((to - from) / STEP) as usize;
    let turn = std::f64::consts::TAU / azimuths as f64;
    let mut sum = 0.0;
    for i in 0..=count {
        let tangent = (from + STEP * i as f64).exp();
        let z = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sine = tangent * z;
        for j in 0..azimuths {
            let phi = turn * (j as f64 + 0.5);
            // sin dtheta, with dtheta = tan / (1 + tan^2) d(ln tan).
            let area = sine * tangent * z * z;
            sum += area * f(DVec3::new(sine * phi.cos(), sine * phi.sin(), z));
        }
    }
    sum * STEP * turn
}
