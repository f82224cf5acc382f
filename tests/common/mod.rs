//! What the test programs share: directions, random numbers, and descriptions drawn from the registry.

#![allow(dead_code)] // each test program uses a part

pub mod calls;
mod drawn;
pub mod films;
pub mod parallel;
pub mod quadrature;

#[allow(unused_imports)] // each test program uses a part
pub use drawn::{Drawn, Variation, combinations, defaults};

use glam::{DVec3, Vec3};
use pellicle::Bsdf;
use pellicle::bsdf::Flags;
use pellicle::bsdf::Precision;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

pub fn rng(seed: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed)
}

/// A direction from polar angle and azimuth in degrees.
pub fn degrees(theta: f64, phi: f64) -> DVec3 {
    let (theta, phi) = (theta.to_radians(), phi.to_radians());
    DVec3::new(
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    )
}

/// A direction rounded to single precision, in both precisions: the same numbers, so that two
/// instances can be compared.
pub fn rounded(w: DVec3) -> (Vec3, DVec3) {
    let single = w.as_vec3();
    (single, single.as_dvec3())
}

/// Uniform over the upper hemisphere.
pub fn hemisphere(rng: &mut impl Rng) -> DVec3 {
    let z: f64 = 1.0 - rng.random::<f64>();
    let phi = std::f64::consts::TAU * rng.random::<f64>();
    let radius = (1.0 - z * z).sqrt();
    DVec3::new(radius * phi.cos(), radius * phi.sin(), z)
}

/// Three uniform numbers in [0, 1).
pub fn uniforms(rng: &mut impl Rng) -> [f32; 3] {
    // 24 bits: every value is representable and below 1.
    std::array::from_fn(|_| (rng.random::<u32>() >> 8) as f32 / 16_777_216.0)
}

/// A number in [min, max]: half of the time spread evenly, half by its logarithm, so that wide
/// ranges are seen at every scale, and so is what lies next to 0; now and then an end itself.
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

/// A direction on a side that the BSDF has: the upper, or either.
pub fn visible<T: Precision>(bsdf: &Bsdf<T>, rng: &mut impl Rng) -> DVec3 {
    let up = hemisphere(rng);
    if bsdf.flags().contains(Flags::TRANSMISSION) && rng.random_bool(0.5) {
        -up
    } else {
        up
    }
}

/// Whether no lobe has a density.
pub fn is_dirac<T: Precision>(bsdf: &Bsdf<T>) -> bool {
    bsdf.lobe_infos()
        .iter()
        .all(|lobe| lobe.flags.contains(Flags::DELTA))
}

/// The parameter that sets how rough a diffuse form of `metallic_roughness` is, if it has one.
pub fn roughness_of(form: &str) -> Option<&'static str> {
    match form {
        "oren_nayar" => Some("sigma_radians"),
        "disney" => Some("diffuse_roughness"),
        _ => None,
    }
}
