//! What the tests of layers share.

#![allow(dead_code)] // each test program uses a part

use pellicle::optics::Complex;
use pellicle::optics::stack::{Layer, P, Response, S, Side, Stack};
use rand::{Rng, RngExt};

pub type Index = Complex<f64>;

pub fn index(eta: f64, k: f64) -> Index {
    Complex::new(eta, k)
}

pub fn film(index: Index, thickness_nm: f64) -> Layer<f64> {
    Layer {
        index,
        thickness_nm,
    }
}

pub fn outside(
    ambient: f64,
    layers: &[Layer<f64>],
    base: Index,
    cos_theta: f64,
    nm: f64,
) -> Response<f64> {
    Stack {
        ambient,
        layers,
        base,
    }
    .respond(Side::Ambient, cos_theta, nm)
}

pub fn assert_close(found: [f64; 2], expected: [f64; 2], tolerance: f64, what: &str) {
    for pol in [S, P] {
        let error = (found[pol] - expected[pol]).abs();
        assert!(error <= tolerance, "{what}: {found:?}, not {expected:?}");
    }
}

/// Log-uniform.
pub fn magnitude(rng: &mut impl Rng, min: f64, max: f64) -> f64 {
    min * (max / min).powf(rng.random::<f64>())
}

pub fn draw_index(rng: &mut impl Rng) -> Index {
    match rng.random_range(0..4) {
        0 => index(magnitude(rng, 0.02, 5.0), magnitude(rng, 1e-6, 1e3)),
        1 => index(1.0, 0.0),
        _ => index(magnitude(rng, 1.0, 4.0), 0.0),
    }
}
