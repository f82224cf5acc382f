//! Random numbers and directions.

use glam::{DVec3, Vec3};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::TAU;

pub fn rng(seed: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed)
}

/// A number whose logarithm is uniform.
pub fn log_uniform(rng: &mut impl Rng, min: f32, max: f32) -> f32 {
    (min * (max / min).powf(rng.random())).clamp(min, max)
}

/// A number in [min, max]: about half of them uniform, half with a uniform logarithm, so that wide ranges and what
/// lies next to 0 occur at every scale; one in eight is an end.
pub fn number(rng: &mut impl Rng, min: f32, max: f32) -> f32 {
    match rng.random_range(0..16) {
        0 => min,
        1 => max,
        2..=8 => min + (max - min) * rng.random::<f32>(),
        9..=10 if min == 0.0 => max * (-4.0 * rng.random::<f32>()).exp2().powf(3.3),
        _ => min + ((max - min + 1.0).ln() * rng.random::<f32>()).exp_m1(),
    }
    .clamp(min, max)
}

/// A direction at that height above the surface and that azimuth.
pub fn direction(z: f64, phi: f64) -> DVec3 {
    let radius = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(radius * phi.cos(), radius * phi.sin(), z)
}

/// Uniform over the upper hemisphere.
pub fn hemisphere(rng: &mut impl Rng) -> DVec3 {
    direction(1.0 - rng.random::<f64>(), TAU * rng.random::<f64>())
}

/// The greatest number below 1.
pub const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// Three uniform numbers in [0, 1): multiples of 2^-24, as most renderers have them.
pub fn uniforms(rng: &mut impl Rng) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| {
        (rng.random::<u32>() >> 8) as f32 / 16_777_216.0
    }))
}
