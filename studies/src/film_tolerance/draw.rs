//! Random stacks: 1 to 5 layers, eta 1 to 4, k 0 to 8, thickness to 3 um; named media as bases and layers; and the
//! cases where an index equals its neighbour's.

use super::kind::Kind;
use super::rng;
use super::stack::{Index, Stack};
use crate::shared::directions::log_uniform;
use pellicle::optics::{ColorSpace, White};
use rand::{Rng, RngExt};

/// The greatest thickness, nm.
const GREATEST_NM: f32 = 3000.0;
pub const ETA: [f32; 2] = [1.0, 4.0];
pub const GREATEST_K: f32 = 8.0;

/// Named bases.
const BASES: [&str; 15] = [
    "Ag", "Al", "Au", "Cr", "Cu", "Fe", "Ni", "Pt", "Ti", "W", "Si", "BK7", "SiO2", "TiO2", "H2O",
];
/// Named layers.
const COATINGS: [&str; 5] = ["Al2O3", "H2O", "MgF2", "SiO2", "TiO2"];

/// The stack of that number in the series that a seed begins, without regard to its [`Kind`].
pub fn general(seed: u64, number: usize) -> Stack {
    let rng = &mut rng(seed, number, 0);
    let ambient = if one_in(5, rng) {
        Index::constant(rng.random_range(1.0..=1.6), 0.0)
    } else {
        Index::VACUUM
    };
    let count = rng.random_range(1..=5);
    let mut layers: Vec<(Index, [f32; 2])> = Vec::new();
    for _ in 0..count {
        let above = layers.last().map_or(&ambient, |layer| &layer.0);
        let index = layer_index(above, rng);
        layers.push((index, [fixed_thickness(rng); 2]));
    }
    if !one_in(5, rng) {
        let varying = rng.random_range(0..count);
        layers[varying].1 = thickness_range(rng);
    }
    let base = base_index(&ambient, rng);
    Stack {
        kind: Kind::General,
        both_sides: !base.medium().absorbs() && one_in(4, rng),
        white: if one_in(2, rng) { White::D65 } else { White::E },
        space: match rng.random_range(0..8) {
            0 => ColorSpace::Rec2020,
            1 => ColorSpace::AcesCg,
            2 => ColorSpace::Xyz,
            _ => ColorSpace::Rec709,
        },
        ambient,
        layers,
        base,
    }
}

fn layer_index(above: &Index, rng: &mut impl Rng) -> Index {
    match rng.random_range(0..40) {
        0 => return Index::VACUUM,
        1 | 2 => return above.clone(),
        3 | 4 => return Index::Named(pick(&COATINGS, rng)),
        _ => {}
    }
    let k = if one_in(2, rng) {
        log_uniform(rng, 1e-3, GREATEST_K)
    } else {
        0.0
    };
    numbers(k, rng)
}

fn base_index(ambient: &Index, rng: &mut impl Rng) -> Index {
    match rng.random_range(0..60) {
        0..3 => return ambient.clone(), // a soap film
        3..13 => return Index::Named(pick(&BASES, rng)),
        _ => {}
    }
    let k = if one_in(2, rng) {
        rng.random_range(0.0..=GREATEST_K)
    } else {
        0.0
    };
    numbers(k, rng)
}

/// Uniform in eta; now and then dispersive.
fn numbers(k: f32, rng: &mut impl Rng) -> Index {
    let eta = rng.random_range(ETA[0]..=ETA[1]);
    if one_in(12, rng) {
        dispersive(eta, k, rng)
    } else {
        Index::constant(eta, k)
    }
}

/// An index near eta in the red, with another in green and blue.
pub fn dispersive(eta: f32, k: f32, rng: &mut impl Rng) -> Index {
    let slope = rng.random_range(-0.1..=0.3);
    let eta = [0.0, 0.6, 1.0].map(|x: f32| (eta + slope * x).clamp(ETA[0], ETA[1]));
    let k = std::array::from_fn(|_| (k * rng.random_range(0.5..=1.5)).min(GREATEST_K));
    Index::Rgb(eta, k)
}

fn fixed_thickness(rng: &mut impl Rng) -> f32 {
    if one_in(2, rng) {
        rng.random_range(0.0..=GREATEST_NM)
    } else {
        log_uniform(rng, 1.0, GREATEST_NM)
    }
}

fn thickness_range(rng: &mut impl Rng) -> [f32; 2] {
    let max = if one_in(4, rng) {
        GREATEST_NM
    } else {
        rng.random_range(10.0..=GREATEST_NM)
    };
    let min = match rng.random_range(0..8) {
        0 => max - log_uniform(rng, 0.1, 10.0), // narrow
        1..5 => 0.0,
        _ => rng.random_range(0.0..max),
    };
    [min.max(0.0), max]
}

pub fn one_in(n: u32, rng: &mut impl Rng) -> bool {
    rng.random_range(0..n) == 0
}

pub fn pick<T: Copy>(from: &[T], rng: &mut impl Rng) -> T {
    from[rng.random_range(0..from.len())]
}
