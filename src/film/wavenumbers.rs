//! A quadrature rule over the visible spectrum, for reflectances whose fringes are nearly sines.

use crate::num::{PI, Rgb};
use crate::optics::{ChannelWeights, VISIBLE_NM};

/// Points of the integrals of the weights.
const GRID: usize = 4000;

/// Nodes in wavenumber (per nm), ascending, and their weights per channel, which sum to 1. The part
/// `left_out` of the channels' power lies beyond either end.
pub(super) fn equidistant(
    weights: &ChannelWeights,
    count: usize,
    left_out: f64,
) -> Vec<(f64, Rgb<f64>)> {
    let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| 1.0 / nm);
    let fine = (last - first) / GRID as f64;
    let sigma = |i: usize| first + (i as f64 + 0.5) * fine;
    // The channels per wavenumber: d lambda = lambda^2 d sigma.
    let channels: Vec<Rgb<f64>> = (0..GRID)
        .map(|i| weights.at(1.0 / sigma(i)).map(|w| w / sigma(i).powi(2)))
        .collect();
    let white: Rgb<f64> = std::array::from_fn(|c| channels.iter().map(|w| w[c]).sum());
    let power = |w: &Rgb<f64>| (0..3).map(|c| (w[c] / white[c]).abs()).sum::<f64>();
    let whole: f64 = channels.iter().map(power).sum();
    let left_out = whole * left_out;
    // The width of the faint end on either side, per nm.
    let cut = |from_first: bool| {
        let mut sum = 0.0;
        let beyond = |i: &usize| {
            let i = if from_first { *i } else { GRID - 1 - *i };
            sum += power(&channels[i]);
            sum <= left_out
        };
        (0..GRID).take_while(beyond).count() as f64 * fine
    };
    let (first, last) = (first + cut(true), last - cut(false));
    let step = (last - first) / count as f64;
    // sin(pi (sigma - node) / step) differs between nodes only in its sign.
    let waves = (0..GRID).map(|i| {
        let x = PI * (sigma(i) - first) / step;
        (x, -x.cos())
    });
    let waves: Vec<(f64, f64)> = waves.collect();
    let mut nodes: Vec<(f64, Rgb<f64>)> = (0..count)
        .map(|k| {
            let node = k as f64 + 0.5;
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let mut sums = [0.0; 3];
            for ((x, sine), w) in waves.iter().zip(&channels) {
                let x = x - PI * node;
                let sinc = if x.abs() < 1e-6 { 1.0 } else { sign * sine / x };
                for c in 0..3 {
                    sums[c] += w[c] * sinc;
                }
            }
            (first + node * step, sums)
        })
        .collect();
    let sum: Rgb<f64> = std::array::from_fn(|c| nodes.iter().map(|(_, w)| w[c]).sum());
    for (_, w) in &mut nodes {
        *w = std::array::from_fn(|c| w[c] / sum[c]);
    }
    nodes
}
