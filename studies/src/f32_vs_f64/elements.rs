//! Random elements and all edge cases: from normal incidence to the last number above the horizon, mirror images and
//! directions close to them, the viewer's own direction, the ends of the uniform numbers.

use crate::shared::directions::{self, BELOW_ONE, hemisphere};
use glam::{DVec3, Vec3};
use rand::{Rng, RngExt};
use std::f64::consts::TAU;

/// A number whose logarithm is uniform.
fn magnitude(rng: &mut impl Rng, min: f64, max: f64) -> f64 {
    min * (max / min).powf(rng.random())
}

/// A direction at that height above the surface. Every fourth is in the plane of the tangent.
fn at_height(rng: &mut impl Rng, z: f64) -> DVec3 {
    let phi = match rng.random_range(0..8) {
        0 => 0.0,
        1 => TAU / 2.0,
        _ => TAU * rng.random::<f64>(),
    };
    directions::direction(z, phi)
}

/// A grazing direction, down to the least number above 0.
fn grazing(rng: &mut impl Rng) -> DVec3 {
    let least = [1e-4, 1e-10, 1e-45][rng.random_range(0..3)];
    let z = magnitude(rng, least, 1.0).max(f64::from(f32::from_bits(1)));
    at_height(rng, z)
}

/// A direction to the viewer, with z > 0.
pub fn viewer(rng: &mut impl Rng) -> Vec3 {
    let w = match rng.random_range(0..16) {
        0 => DVec3::Z,
        1 => {
            let sine = magnitude(rng, 1e-8, 1.0);
            at_height(rng, (1.0 - sine * sine).sqrt())
        }
        2..=4 => grazing(rng),
        _ => hemisphere(rng),
    };
    above(w)
}

/// A direction to the light, given the viewer's and the one that was sampled, if any.
pub fn light(rng: &mut impl Rng, wo: Vec3, sampled: Option<Vec3>) -> Vec3 {
    let mirrored = Vec3::new(-wo.x, -wo.y, wo.z);
    match (rng.random_range(0..16), sampled) {
        (0, _) => mirrored,
        (1..=3, _) => {
            let offset = (hemisphere(rng) * 2.0 - DVec3::Z).normalize() * magnitude(rng, 1e-8, 1.0);
            above((mirrored.as_dvec3() + offset).normalize())
        }
        (4, _) => wo,
        (5, _) => above(grazing(rng)),
        (6..=11, Some(wi)) => wi,
        _ => above(hemisphere(rng)),
    }
}

/// In single precision, on the upper side.
fn above(w: DVec3) -> Vec3 {
    let w = w.as_vec3();
    Vec3::new(w.x, w.y, w.z.abs().max(f32::from_bits(1)))
}

/// Three uniform numbers. In one of eight triples a number is an end or next to 0, perhaps no multiple of 2^-24.
pub fn uniform(rng: &mut impl Rng) -> Vec3 {
    let mut u = directions::uniforms(rng);
    let which = rng.random_range(0..3);
    match rng.random_range(0..24) {
        0 => u[which] = 0.0,
        1 => u[which] = BELOW_ONE,
        2 => u[which] = magnitude(rng, 1e-12, 1.0) as f32,
        _ => {}
    }
    u.min(Vec3::splat(BELOW_ONE))
}
