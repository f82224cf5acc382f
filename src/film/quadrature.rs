//! All beams at N wavelengths.

use super::layer::{Line, pack, pack_lines};
use super::{Method, OneLayer, check_size, held};
use crate::error::Error;
use crate::num::{Lane, PI, Real, Rgb};
use crate::optics::{ChannelWeights, VISIBLE_NM};

/// The greatest number of wavelengths.
const MAX_NODES: usize = 64;
/// Points of the integrals of the weights.
const GRID: usize = 4000;
/// On either side of the nodes' range lies this part of the channels' power over N^2. Chosen among
/// 1, 1/2, 1/4, 1/8 over N^2 and powers 1 and 3/2 by the errors at N = 8 to 64 over the stacks of
/// `tests/films/accuracy.rs`; a factor of two in it changes them by a factor of 2.5 at most.
const LEFT_OUT: f64 = 0.25;

/// The exact reflectance (Airy 1833) at N wavelengths, added up with weights per channel.
///
/// The nodes are equidistant in wavenumber, where fringes are nearly sines, over all of the visible
/// range but its faint ends. The weights w are those with the least squared error of
/// sum w exp(2 pi i sigma x) over all paths |x| <= 1 / (2 h), h the nodes' distance: on that
/// interval the nodes' waves are orthogonal, so that
///
/// ```text
/// w(k) = integral of the channel(sigma) sinc((sigma - sigma(k)) / h) d sigma
/// ```
///
/// (Shannon's interpolation, integrated), normalised to a sum of 1. A path reaches to 1 / h less the
/// extent of the channels' transforms, some 4 micrometres, before it aliases. The Gauss rule of the
/// channels' summed magnitudes was tried: at 8, 16 and 32 nodes its errors are 2 to 7 times as
/// large on metals and titania, since its nodes crowd at the ends of the range.
///
/// Cost: N / 3 evaluations with three wavelengths in lanes.
///
/// Exact for thickness 0 up to the base's dispersion. Fails for thick films: with 2 n d above
/// about N times 900 nm less 4 micrometres the colours alias. Grazing soap films, whose resonances
/// are narrow (harmonics of the path), need more nodes than their fringes suggest.
#[derive(Clone, Debug)]
pub struct Quadrature<T: Lane> {
    nodes: Box<[Nodes<T::Rgb>]>,
}

/// Three wavelengths side by side, and their weights in each channel.
#[derive(Clone, Copy, Debug)]
struct Nodes<R> {
    line: Line<R>,
    weights: [R; 3],
}

impl<T: Lane> Quadrature<T> {
    /// For a film, with 1 to 64 wavelengths.
    pub fn new(layer: &OneLayer, count: usize) -> Result<Self, Error> {
        check_size("wavelengths", count, MAX_NODES)?;
        let left_out = LEFT_OUT / (count * count) as f64;
        let weights = ChannelWeights::new(layer.white, layer.space);
        let rule = equidistant(&weights, count, left_out);
        let nodes = rule.chunks(3).map(|chunk| {
            // The last three are filled up with a wavelength of weight 0.
            let node = |i: usize| chunk.get(i).copied().unwrap_or((chunk[0].0, [0.0; 3]));
            let nodes: [(f64, Rgb<f64>); 3] = std::array::from_fn(node);
            Nodes {
                line: pack_lines::<T>(nodes.map(|(sigma, _)| Line::at(layer, 1.0 / sigma))),
                weights: std::array::from_fn(|c| pack::<T>(nodes.map(|(_, w)| w[c]))),
            }
        });
        Ok(Self {
            nodes: nodes.collect(),
        })
    }
}

impl<T: Lane> Method<T> for Quadrature<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let (cos_theta, thickness_nm) = held(cos_theta, thickness_nm);
        let mut sums = [T::Rgb::new(0.0); 3];
        for nodes in &self.nodes {
            let waves = nodes.line.waves(cos_theta);
            let reflectance = nodes.line.reflectance(&waves, thickness_nm);
            for (sum, weight) in sums.iter_mut().zip(nodes.weights) {
                *sum = *sum + reflectance * weight;
            }
        }
        totals(sums)
    }
}

/// The sum of the three lanes of each channel.
#[inline(always)]
pub(super) fn totals<T: Lane>(sums: [T::Rgb; 3]) -> Rgb<T> {
    sums.map(|sum| {
        let [a, b, c] = T::channels(sum);
        a + b + c
    })
}

/// Nodes in wavenumber (per nm), ascending, and their weights per channel, which sum to 1. This part
/// of the channels' power lies beyond either end.
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
    // The faint end on either side, per nm.
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
    // sin(pi (sigma - node) / step) differs from node to node by its sign alone.
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
