//! Any stack in double precision, all harmonics of one layer at once: what tables are filled with.

mod column;
mod terms;

pub(super) use column::Column;

use super::FilmDescription;
use super::quadrature::equidistant;
use crate::error::Error;
use crate::num::{F64x4, Rgb, widest};
use crate::optics::stack::{Incidence, S, Side};
use crate::optics::{ChannelWeights, Complex};
use column::{Block, Order, Sum};
use terms::Media;

/// The greatest ratio of a medium's group index and its index.
const MOST_GROUP: f64 = 1.7;
/// Paths up to which no harmonic is cut, and from which on all are: a layer between lossless neighbours first
/// resonates at half a wavelength, 190 nm.
const FRINGELESS_NM: [f64; 2] = [90.0, 180.0];
/// Cosines below this are taken for it: there a film either mirrors, or nothing is there.
const LEAST_COSINE: f64 = 1e-9;

/// Reflectance and transmittance per channel, not clipped.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Powers {
    pub reflectance: Rgb<f64>,
    pub transmittance: Rgb<f64>,
}

/// The spectrum at N wavenumbers, without the fringes that so few cannot tell apart.
///
/// At one wavenumber sigma the amplitude reflected by all beams in one layer is, with z = exp(i phi)
/// the phase of a round trip through it,
///
/// ```text
/// r = r_top + h z / (1 + g z)
/// R = |r_top|^2 + |h|^2 / (1 - |g|^2) + 2 Re(C Q)      Q = z / (1 + g z) = sum of (-g)^(m - 1) z^m
/// T = T0 (1 - 2 Re(g Q)) / (1 - |g|^2)                 C = conj(r_top) h - g |h|^2 / (1 - |g|^2)
/// ```
///
/// where r_top, g and h contain the layers above and below and the damping |E|. The m-th harmonic has
/// m fringes for one of the layer. N nodes a distance delta apart tell fringes apart up to a path of
/// 1 / (2 delta), and take what is finer for something coarser; but the eye's curves are so smooth that
/// what is finer should vanish. So Q is summed up to the harmonic M = 1 / (2 delta path) and no further,
/// in closed form:
///
/// ```text
/// Q = z (1 - (-g z)^M) / (1 + g z)
/// ```
///
/// with a part of the next harmonic, so that the sum is continuous in the path. It is exact to rounding
/// for any finesse and thickness of this layer once 1 / (2 delta) exceeds the longest path at which the
/// channels show fringes (some 15 micrometres at 1e-4). The other layers' fringes are sampled: their
/// paths ask for more nodes. The same decomposition as in
/// [`Harmonics`](super::Harmonics), whose transform it evaluates at all orders at once; our own.
#[derive(Clone, Debug)]
pub(super) struct Series {
    nodes: Vec<Nodes>,
    /// Indices per entry of `nodes`: ambient, layers, base.
    indices: Vec<Complex<F64x4>>,
    /// How many wavenumbers, and their distance.
    count: usize,
    spacing: f64,
    /// Least and greatest thickness of each layer.
    ranges: Vec<[f64; 2]>,
    /// The layer whose harmonics are summed.
    summed: Option<usize>,
    /// Its thickness, if that does not vary.
    fixed_nm: Option<f64>,
    /// The longest path that it can have, per nm of thickness.
    most_path: f64,
    /// Indices are the same at all nodes, and no layer but the summed one has a thickness.
    is_uniform: bool,
}

/// Some wavenumbers, and their weights in the channels; 0 for those that only fill a place.
#[derive(Clone, Copy, Debug)]
struct Nodes {
    sigma: F64x4,
    weights: [F64x4; 3],
}

impl Series {
    /// With N nodes.
    pub(super) fn new(description: &FilmDescription, count: usize) -> Result<Self, Error> {
        let weights = ChannelWeights::new(description.white, description.color_space);
        let rule = equidistant(&weights, count, 0.0);
        let layers = &description.layers;
        let ranges: Vec<_> = layers.iter().map(|l| l.thickness_nm).collect();
        let media: Vec<_> = std::iter::once(&description.ambient)
            .chain(layers.iter().map(|layer| &layer.medium))
            .chain(std::iter::once(&description.base))
            .collect();
        let parts = rule.len().div_ceil(F64x4::COUNT);
        let mut indices = Error::reserve(parts * media.len(), "a film's series")?;
        let filled = rule.chunks(F64x4::COUNT).map(|rule| {
            let at = |i: usize| rule[i.min(rule.len() - 1)];
            for medium in &media {
                let index: [_; F64x4::COUNT] = std::array::from_fn(|i| medium.index(1.0 / at(i).0));
                indices.push(Complex::new(
                    F64x4::from_fn(|i| index[i].re),
                    F64x4::from_fn(|i| index[i].im),
                ));
            }
            let weight = |c: usize, i: usize| rule.get(i).map_or(0.0, |node| node.1[c]);
            Nodes {
                sigma: F64x4::from_fn(|i| at(i).0),
                weights: std::array::from_fn(|c| F64x4::from_fn(|i| weight(c, i))),
            }
        });
        let mut nodes = Error::reserve(parts, "a film's series")?;
        nodes.extend(filled);
        let thickest = || {
            (0..ranges.len()).max_by(|&a, &b| {
                let path = |i: usize| ranges[i][1] * indices[i + 1].re.to_array()[0];
                path(a).total_cmp(&path(b))
            })
        };
        let summed = description.varying().or_else(thickest);
        let is_constant = media.iter().all(|medium| medium.constant().is_some());
        let most_index = summed.map_or(0.0, |layer| {
            let along = rule
                .iter()
                .map(|node| media[layer + 1].index(1.0 / node.0).re);
            along.fold(0.0, f64::max)
        });
        Ok(Self {
            nodes,
            count: rule.len(),
            spacing: rule[1].0 - rule[0].0,
            fixed_nm: description
                .varying()
                .is_none()
                .then(|| summed.map_or(0.0, |layer| ranges[layer][0])),
            most_path: 2.0 * MOST_GROUP * most_index,
            is_uniform: ranges.len() < 2 && is_constant,
            summed,
            indices,
            ranges,
        })
    }

    /// At one angle and thickness (of the layer that varies, ignored if none does), without allocating.
    pub(super) fn at(&self, side: Side, cos_theta: f64, thickness_nm: f64) -> Powers {
        widest(
            #[inline(always)]
            || {
                let thickness_nm = self.fixed_nm.unwrap_or(thickness_nm);
                let cos_theta = cos_theta.max(LEAST_COSINE);
                let mut block = self.block(0, side, cos_theta);
                let order = self.order(self.path(side, cos_theta, &block) * thickness_nm);
                let mut sum = Sum::default();
                for (part, nodes) in self.nodes.iter().enumerate() {
                    if part > 0 && !self.is_uniform {
                        block = self.block(part, side, cos_theta);
                    }
                    sum.add(&block, nodes, thickness_nm, order);
                }
                sum.powers()
            },
        )
    }

    /// At an angle; `cos_theta` in the half-space that the light comes from.
    pub(super) fn column(&self, side: Side, cos_theta: f64) -> Column<'_> {
        let cos_theta = cos_theta.max(LEAST_COSINE);
        let count = if self.is_uniform { 1 } else { self.nodes.len() };
        let mut blocks = Vec::with_capacity(count);
        widest(
            #[inline(always)]
            || {
                for part in 0..count {
                    blocks.push(self.block(part, side, cos_theta));
                }
            },
        );
        Column {
            series: self,
            path: self.path(side, cos_theta, &blocks[0]),
            blocks,
        }
    }

    #[inline(always)]
    fn block(&self, part: usize, side: Side, cos_theta: f64) -> Block {
        let count = self.ranges.len() + 2;
        let media = Media {
            side,
            indices: &self.indices[part * count..][..count],
            ranges: &self.ranges,
            summed: self.summed,
        };
        Block::new(media, cos_theta, self.nodes[part].sigma)
    }

    /// How fast the phase of a round trip changes with the wavenumber, in turns and per nm of thickness:
    /// the path that fringes belong to, longer than that of the phase in dispersive media. The greatest
    /// of both ends and the middle.
    #[inline(always)]
    fn path(&self, side: Side, cos_theta: f64, first: &Block) -> f64 {
        let Some(layer) = self.summed else {
            return 0.0;
        };
        if self.is_uniform {
            return first.round.re.to_array()[0].min(self.most_path);
        }
        let near = match side {
            Side::Ambient => 0,
            Side::Base => self.ranges.len() + 1,
        };
        let round = |node: usize| {
            let (part, lane) = (node / F64x4::COUNT, node % F64x4::COUNT);
            let index = |medium: usize| {
                let index = self.indices[part * (self.ranges.len() + 2) + medium];
                Complex::new(index.re.to_array()[lane], index.im.to_array()[lane])
            };
            let wave = Incidence::new(index(near).re, cos_theta).wave(index(layer + 1));
            2.0 * self.nodes[part].sigma.to_array()[lane] * wave.immittance[S].re
        };
        // Where the wave begins to travel along the layer within the spectrum, its phase has a root there
        // and no path.
        let between = |node: usize| {
            let path = (round(node + 1) - round(node)).abs() / self.spacing;
            path.min(self.most_path)
        };
        let last = self.count - 1;
        between(0).max(between(last / 2)).max(between(last - 1))
    }

    /// The last harmonic that the nodes tell apart at a path, nm, and the part of the next one that makes
    /// the sum continuous in the path; that fades within a quarter of the longest path.
    ///
    /// Layers too thin for a fringe of their own are summed whole: what is narrow there comes from the phases
    /// of g, that is from the layers around, or from waves that do not travel.
    fn order(&self, path: f64) -> Order {
        let last = self.longest_path() / path.max(1e-3);
        let whole = last.floor();
        let fading = 1.0 - 4.0 * ((whole + 1.0) / last - 1.0);
        let part = (last - whole).min(fading).max(0.0);
        let [none, all] = FRINGELESS_NM;
        let cut = ((path - none) / (all - none)).clamp(0.0, 1.0);
        Order { whole, part, cut }
    }

    /// 1 / (2 delta), nm.
    fn longest_path(&self) -> f64 {
        0.5 / self.spacing
    }

    /// Bytes of the nodes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.indices)
    }

    /// How many nodes.
    pub(super) fn len(&self) -> usize {
        self.count
    }
}

#[cfg(test)]
mod tests;
