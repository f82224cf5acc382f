//! Ten million elements at once. All of them have the bits of batches of pieces, and those at the boundaries of what
//! batches are cut into, with some others, the bits of single calls.

use crate::shared::batch::{Varying, reflectances, samples, values};
use crate::shared::bsdf::{sample, value_pdf};
use crate::shared::directions::rng;
use crate::shared::films::{bare, compiled, constant};
use glam::Vec3;
use pellicle::num::Level;
use pellicle::{Bsdf, Description};
use rand::RngExt;
use rayon::prelude::*;
use std::fmt::Debug;
use std::ops::Range;

const COUNT: usize = 10_000_000;
/// The length of a piece, no multiple of [`CHUNK`].
const PIECE: usize = 100_003;
/// What batches are cut into.
const CHUNK: usize = 256;
/// Elements compared with single calls beside those at boundaries.
const SINGLES: usize = 10_000;

/// A number in [0, 1) for element i: multiples of an irrational number fill it evenly.
fn number(i: usize, which: usize) -> f32 {
    const STEPS: [f64; 5] = [
        0.618_033_988_7,
        0.414_213_562_4,
        0.732_050_807_6,
        0.236_067_977_5,
        0.645_751_311_1,
    ];
    ((i as f64 * STEPS[which]).fract() as f32).min(1.0 - f32::EPSILON)
}

/// A direction for element i; every seventh is below the surface.
fn direction(i: usize, which: usize) -> Vec3 {
    let square = Vec3::new(number(i, which) - 0.5, number(i, which + 1) - 0.5, 0.35);
    let w = square.normalize();
    if i % 7 == 3 { -w } else { w }
}

/// Compares the results of one batch of all elements with those of pieces, in their bits, and with those of single
/// calls.
fn compare<T: Debug + Send + Sync>(
    batch: impl Fn(Range<usize>) -> Vec<T> + Sync,
    single: impl Fn(usize) -> T + Sync,
    is_same: impl Fn(&T, &T) -> bool + Sync,
) {
    let all = batch(0..COUNT);
    assert_eq!(all.len(), COUNT);
    (0..COUNT.div_ceil(PIECE))
        .into_par_iter()
        .for_each(|piece| {
            let first = piece * PIECE;
            let found = batch(first..COUNT.min(first + PIECE));
            let mut pairs = all[first..].iter().zip(&found);
            assert!(pairs.all(|(a, b)| is_same(a, b)), "from {first} on");
        });
    let boundaries = (0..COUNT).step_by(CHUNK).flat_map(|i| [i, i + CHUNK - 1]);
    let mut rng = rng(5);
    let others = (0..SINGLES).map(move |_| rng.random_range(0..COUNT));
    for i in boundaries
        .chain(others)
        .chain([COUNT - 1])
        .filter(|i| *i < COUNT)
    {
        let single = single(i);
        assert!(
            is_same(&all[i], &single),
            "{i}: {:?}, not {single:?}",
            all[i]
        );
    }
}

#[test]
fn ten_million_values() {
    let bsdf = Bsdf::<f32>::new(&Description::new("microfacet")).unwrap();
    let batch = |range: Range<usize>| {
        let [wo, wi] = [0, 3].map(|which| {
            range
                .clone()
                .map(|i| direction(i, which))
                .collect::<Vec<_>>()
        });
        values(&bsdf, Level::widest(), &wo, &wi, &Varying::default()).unwrap()
    };
    let single = |i| value_pdf(&bsdf, direction(i, 0), direction(i, 3), None);
    let bits = |(value, pdf): &([f32; 3], f32)| (value.map(f32::to_bits), pdf.to_bits());
    compare(batch, single, |a, b| bits(a) == bits(b));
}

#[test]
fn ten_million_samples() {
    let description = Description::new("disney_diffuse").vary("reflectance", 0.0, 1.0);
    let bsdf = Bsdf::<f32>::new(&description).unwrap();
    let uniform = |i| Vec3::from_array([2, 3, 4].map(|which| number(i, which)));
    let reflectance = |i| [1, 2, 3].map(|which| number(i, which));
    let batch = |range: Range<usize>| {
        let wo: Vec<Vec3> = range.clone().map(|i| direction(i, 0)).collect();
        let u: Vec<Vec3> = range.clone().map(uniform).collect();
        let varying = Varying {
            numbers: range.flat_map(reflectance).collect(),
            components: vec![3],
        };
        samples(&bsdf, Level::widest(), &wo, &u, &varying).unwrap()
    };
    let single = |i| sample(&bsdf, direction(i, 0), uniform(i), Some(&reflectance(i)));
    compare(batch, single, |a, b| {
        [a.wi.to_array(), a.weight].map(|v| v.map(f32::to_bits))
            == [b.wi.to_array(), b.weight].map(|v| v.map(f32::to_bits))
            && (a.pdf.to_bits(), a.flags, a.lobe) == (b.pdf.to_bits(), b.flags, b.lobe)
    });
}

#[test]
fn ten_million_reflectances() {
    let film = compiled(&bare(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [0.0, 600.0]));
    let point = |i| [number(i, 0), 600.0 * number(i, 1)];
    let batch = |range: Range<usize>| {
        let points: Vec<[f32; 2]> = range.map(point).collect();
        reflectances(&film, Level::widest(), &points).unwrap()
    };
    let single = |i| film.reflectance(point(i)[0], point(i)[1]);
    compare(batch, single, |a, b| {
        a.map(f32::to_bits) == b.map(f32::to_bits)
    });
}
