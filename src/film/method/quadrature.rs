//! All beams at N wavelengths.

use super::compiled_method::CompiledMethod;
use super::info::{MethodInfo, OneLayerCompile};
use super::media::{MediaAtWavelength, pack, pack_media, totals};
use super::one_layer::{OneLayer, check_size, clamped};
use crate::error::Error;
use crate::film::wavenumbers::equidistant;
use crate::num::{Lane, Real, Rgb};
use crate::optics::ChannelWeights;

pub(super) const INFO: MethodInfo = MethodInfo {
    sizes: &[4, 8, 16, 32, 64],
    cost_ns: |count| 40.0 + 13.0 * count as f64,
    ..MethodInfo::one_layer(
        "quadrature",
        OneLayerCompile {
            single: compile,
            double: compile,
            work: |count| format!("all reflected beams at {count} wavelengths"),
        },
    )
};

/// The greatest number of wavelengths.
const MAX_NODES: usize = 64;
/// This part of the channels' power, over N^2, lies beyond either end of the nodes' range. Chosen among
/// 1, 1/2, 1/4, 1/8 over N^2 and powers 1 and 3/2 of N by the errors at N = 8 to 64 over the stacks of
/// `tests/films/accuracy.rs`; a factor of two in it changes them by a factor of 2.5 at most.
const LEFT_OUT: f64 = 0.25;

/// The exact reflectance (Airy 1833) at N wavelengths, added up with weights per channel.
///
/// The nodes are equidistant in wavenumber, where fringes are nearly sines, over the visible range
/// without its faint ends. The weights w are those with the least squared error of
/// sum w exp(2 pi i sigma x) over all paths |x| <= 1 / (2 h), h the nodes' distance: on that
/// interval the nodes' waves are orthogonal, so that
///
/// ```text
/// w(k) = integral of the channel(sigma) sinc((sigma - sigma(k)) / h) d sigma
/// ```
///
/// (Shannon's interpolation, integrated), normalised to a sum of 1. Paths up to 1 / h less the extent
/// of the channels' transforms, some 4 micrometres, do not alias. The Gauss rule of the channels' summed
/// magnitudes was tried: at 8, 16 and 32 nodes its errors are 2 to 7 times as large on metals and
/// titania, because its nodes crowd at the ends of the range.
///
/// Cost: N / 3 evaluations with three wavelengths in lanes.
///
/// Exact for thickness 0 up to the base's dispersion. Fails for thick films: with 2 n d above
/// about N times 900 nm less 4 micrometres the colours alias. Grazing soap films, whose resonances
/// are narrow (harmonics of the path), need more nodes than their fringes suggest.
struct Quadrature<T: Lane> {
    nodes: Box<[QuadratureNodes<T::Rgb>]>,
}

/// Three wavelengths side by side, and their weights in each channel.
#[derive(Clone, Copy, Debug)]
struct QuadratureNodes<R> {
    media: MediaAtWavelength<R>,
    weights: [R; 3],
}

/// The method with 1 to 64 wavelengths.
fn compile<T: Lane>(layer: &OneLayer, count: usize) -> Result<Box<dyn CompiledMethod<T>>, Error> {
    check_size("wavelengths", count, MAX_NODES)?;
    let left_out = LEFT_OUT / (count * count) as f64;
    let weights = ChannelWeights::new(layer.white, layer.space);
    let rule = equidistant(&weights, count, left_out);
    let nodes = rule.chunks(3).map(|chunk| {
        // Wavelengths of weight 0 fill up the last three.
        let node = |i: usize| chunk.get(i).copied().unwrap_or((chunk[0].0, [0.0; 3]));
        let nodes: [(f64, Rgb<f64>); 3] = std::array::from_fn(node);
        let media = nodes.map(|(sigma, _)| MediaAtWavelength::at(layer, 1.0 / sigma));
        QuadratureNodes {
            media: pack_media::<T>(media),
            weights: std::array::from_fn(|c| pack::<T>(nodes.map(|(_, w)| w[c]))),
        }
    });
    Ok(Box::new(Quadrature::<T> {
        nodes: nodes.collect(),
    }))
}

impl<T: Lane> CompiledMethod<T> for Quadrature<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let [cos_theta, thickness_nm] = clamped(cos_theta, thickness_nm);
        let mut sums = [T::Rgb::new(0.0); 3];
        for nodes in &self.nodes {
            let waves = nodes.media.waves(cos_theta);
            let reflectance = nodes.media.reflectance(&waves, thickness_nm);
            for (sum, weight) in sums.iter_mut().zip(nodes.weights) {
                *sum = *sum + reflectance * weight;
            }
        }
        totals(sums)
    }
}
