//! Random points of a film, corners included.

use super::kind::Kind;
use super::rng;
use super::stack::Stack;
use crate::shared::directions::log_uniform;
use rand::{Rng, RngExt};

/// The arguments of a film: cosine and thickness in nm.
pub type Point = [f32; 2];

/// The points of a stack; a smaller number gives the first of them. Half are uniform in both arguments, a quarter
/// lean towards grazing angles, a quarter lie in the corners. Of kinds other than the general a quarter of all points
/// is moved to the critical angles of the half-spaces.
pub fn points(stack: &Stack, seed: u64, number: usize, count: usize) -> Vec<Point> {
    let rng = &mut rng(seed, number, 1);
    // Where no layer varies, films ignore the thickness.
    let range = stack.varying_nm().unwrap_or([0.0, 3000.0]);
    let point = |_| match rng.random_range(0..8) {
        0..4 => [rng.random_range(0.0..=1.0), uniform(range, rng)],
        4 => [log_uniform(rng, 1e-3, 1.0), uniform(range, rng)],
        5 => [rng.random::<f32>().powi(3), uniform(range, rng)],
        _ => [cornered_cosine(rng), cornered_thickness(range, rng)],
    };
    let mut points: Vec<Point> = (0..count).map(point).collect();
    if stack.kind != Kind::General
        && let Some(interval) = stack.critical_interval()
    {
        let rng = &mut super::rng(seed, number, 3);
        for point in points.iter_mut().skip(3).step_by(4) {
            point[0] = critical_cosine(interval, rng);
        }
    }
    points
}

/// Half within the interval of critical cosines, half beside its ends, from a rounding of the cosine on.
fn critical_cosine([least, greatest]: [f64; 2], rng: &mut impl Rng) -> f32 {
    let end = if rng.random() { least } else { greatest };
    let distance = f64::from(log_uniform(rng, 1e-8, 1e-2));
    let cosine = match rng.random_range(0..4) {
        0 | 1 => rng.random_range(least..=greatest),
        2 => end - distance,
        _ => end + distance,
    };
    cosine.clamp(0.0, 1.0) as f32
}

fn cornered_cosine(rng: &mut impl Rng) -> f32 {
    match rng.random_range(0..12) {
        0 => 0.0,
        1 => log_uniform(rng, 1e-6, 1e-3),
        2 => 1e-3,
        3 => 1e-2,
        4 | 5 => 1.0,
        6 => 1.0 - log_uniform(rng, 1e-6, 1e-1),
        7..10 => log_uniform(rng, 1e-3, 1.0),
        _ => rng.random_range(0.0..=1.0),
    }
}

fn cornered_thickness([min, max]: [f32; 2], rng: &mut impl Rng) -> f32 {
    let width = max - min;
    let distance = log_uniform(rng, 1e-3_f32.min(width), width);
    match rng.random_range(0..8) {
        0 => min,
        1 => max,
        2..6 => (min + distance).min(max),
        6 => (max - distance).max(min),
        _ => uniform([min, max], rng),
    }
}

fn uniform([min, max]: [f32; 2], rng: &mut impl Rng) -> f32 {
    rng.random_range(min..=max)
}
