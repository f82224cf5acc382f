//! Directions and numbers, good and bad.

use crate::shared::directions::{BELOW_ONE, hemisphere, uniforms};
use glam::Vec3;
use rand::{Rng, RngExt};

/// Any number, NaN and infinities among them.
pub fn any_bits(rng: &mut impl Rng) -> f32 {
    f32::from_bits(rng.random())
}

/// A number from 0 to 1 whose logarithm is uniform, down to the least positive number.
fn tiny(rng: &mut impl Rng) -> f32 {
    (-149.0 * rng.random::<f32>()).exp2()
}

fn normalized(w: Vec3) -> Vec3 {
    w.as_dvec3().normalize_or_zero().as_vec3()
}

/// A direction to the viewer: most often one above the surface, at any height; one in 16 is no direction.
pub fn direction(rng: &mut impl Rng) -> Vec3 {
    let w = hemisphere(rng).as_vec3();
    match rng.random_range(0..32) {
        0 => Vec3::from_array(std::array::from_fn(|_| any_bits(rng))),
        1 => Vec3::new(w.x, w.y, any_bits(rng)),
        2..5 => normalized(Vec3::new(w.x, w.y, tiny(rng))),
        5..7 => normalized(Vec3::new(w.x * tiny(rng), w.y * tiny(rng), 1.0)),
        7..11 => -w,
        11 => Vec3::Z,
        12 => w * rng.random_range(0.998_5..1.001_5),
        _ => w,
    }
}

/// A direction to the light: often where narrow lobes are.
pub fn beside(wo: Vec3, rng: &mut impl Rng) -> Vec3 {
    let mirror = Vec3::new(-wo.x, -wo.y, wo.z);
    match rng.random_range(0..8) {
        0 => mirror,
        1 => wo,
        2 => -wo,
        3..5 => {
            let step = hemisphere(rng).as_vec3() * tiny(rng).powf(0.1);
            normalized(mirror + step)
        }
        _ => direction(rng),
    }
}

/// Three numbers of [0, 1); in one of 16 triples a number is outside.
pub fn uniform(rng: &mut impl Rng) -> Vec3 {
    let mut u = uniforms(rng);
    let which = rng.random_range(0..3);
    match rng.random_range(0..16) {
        0 => u[which] = any_bits(rng),
        1 => u[which] = tiny(rng).min(BELOW_ONE),
        2 => u[which] = BELOW_ONE,
        3 => u[which] = 0.0,
        _ => {}
    }
    u
}

/// A number of a parameter that varies within [min, max]; one in 16 is any number.
pub fn varying(rng: &mut impl Rng, [min, max]: [f32; 2]) -> f32 {
    match rng.random_range(0..16) {
        0 => any_bits(rng),
        1 => min,
        2 => max,
        3 => min + (max - min) * tiny(rng),
        _ => min + (max - min) * rng.random::<f32>(),
    }
}
