//! The wavenumbers of a series, the weights of the channels there, and the indices of the media.

use super::angle::Wavenumbers;
use crate::error::Error;
use crate::num::{F64x4, Rgb};
use crate::optics::{ChannelWeights, Complex, Medium, VISIBLE_NM};

/// What the weights of the three wavenumbers nearest to a branch point differ from 1. The midpoint rule on the half-line
/// has the errors 0, h^(3/2) zeta(-1/2, 1/2) and h^2 zeta(-1, 1/2) for 1, sqrt(x) and x (Navot 1961, "An extension of
/// the Euler-Maclaurin summation formula to functions with a branch singularity"; zeta is Hurwitz'); these weights make
/// all three 0, so that an error of order h^(5/2) is left.
const BESIDE_BRANCH: [f64; 3] = [
    0.28552181632845603,
    -0.52937696599024539,
    0.24385514966178936,
];

/// Wavenumbers, four to an entry, ascending but within cells beside a branch point. Those that only fill the last entry
/// have weight 0.
#[derive(Clone, Debug)]
pub(super) struct Spectrum {
    pub wavenumbers: Vec<Wavenumbers>,
    /// Complex indices of the ambient, the layers and the base, for each of `wavenumbers`.
    pub indices: Vec<Complex<F64x4>>,
    /// The number of wavenumbers.
    pub count: usize,
    /// The greatest distance of two that are used as neighbours of one rule, per nm.
    pub spacing: f64,
}

/// A wavenumber (per nm) and its weights.
pub(super) type Node = (f64, Rgb<f64>);

impl Spectrum {
    /// Of equidistant wavenumbers, at least 2. It fails if there is no memory.
    pub fn equidistant(media: &[Medium], nodes: &[Node]) -> Result<Self, Error> {
        let spacing = nodes[1].0 - nodes[0].0;
        Self::of_nodes(media, nodes, spacing)
    }

    /// About `count` wavenumbers, equidistant between the branch points of the spectrum, so that square roots there
    /// are integrated exactly but for terms of the order 5/2 in their distance.
    pub fn between_branches(
        media: &[Medium],
        weights: &ChannelWeights,
        branches: &[f64],
        count: usize,
    ) -> Result<Self, Error> {
        let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| 1.0 / nm);
        let step = (last - first) / count as f64;
        let ends = std::iter::once(first)
            .chain(branches.iter().copied())
            .chain(std::iter::once(last));
        let ends: Vec<f64> = ends.collect();
        let (mut nodes, mut spacing) = (Vec::with_capacity(count + ends.len()), 0.0f64);
        for (panel, pair) in ends.windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]];
            let parts = ((to - from) / step).ceil().max(1.0) as usize;
            let step = (to - from) / parts as f64;
            spacing = spacing.max(step);
            let mut factors = vec![1.0; parts];
            if parts >= BESIDE_BRANCH.len() {
                for (i, correction) in BESIDE_BRANCH.into_iter().enumerate() {
                    if panel > 0 {
                        factors[i] += correction;
                    }
                    if panel + 2 < ends.len() {
                        factors[parts - 1 - i] += correction;
                    }
                }
            }
            nodes.extend(factors.into_iter().enumerate().map(|(i, factor)| {
                let sigma = from + (i as f64 + 0.5) * step;
                // The channels per wavenumber: d lambda = lambda^2 d sigma.
                let factor = factor * step / (sigma * sigma);
                (sigma, weights.at(1.0 / sigma).map(|w| w * factor))
            }));
        }
        let white: Rgb<f64> = std::array::from_fn(|c| nodes.iter().map(|(_, w)| w[c]).sum());
        for (_, weight) in &mut nodes {
            *weight = std::array::from_fn(|c| weight[c] / white[c]);
        }
        Self::of_nodes(media, &nodes, spacing)
    }

    fn of_nodes(media: &[Medium], nodes: &[Node], spacing: f64) -> Result<Self, Error> {
        let parts = nodes.len().div_ceil(F64x4::COUNT);
        let mut indices = Error::reserve(parts * media.len(), "a film's series")?;
        let mut wavenumbers = Error::reserve(parts, "a film's series")?;
        for nodes in nodes.chunks(F64x4::COUNT) {
            let (entry, of_media) = entry(media, nodes);
            wavenumbers.push(entry);
            indices.extend(of_media);
        }
        Ok(Self {
            wavenumbers,
            indices,
            count: nodes.len(),
            spacing,
        })
    }

    /// The indices of all media at entry `part` of `wavenumbers`.
    #[inline(always)]
    pub fn indices_at(&self, part: usize, media: usize) -> &[Complex<F64x4>] {
        &self.indices[part * media..][..media]
    }

    /// Wavenumber `node`, per nm.
    pub fn sigma(&self, node: usize) -> f64 {
        self.wavenumbers[node / F64x4::COUNT].sigma.to_array()[node % F64x4::COUNT]
    }

    /// Wavenumber `node` with its weights.
    pub fn node(&self, node: usize) -> Node {
        let weights = &self.wavenumbers[node / F64x4::COUNT].weights;
        let lane = node % F64x4::COUNT;
        (
            self.sigma(node),
            std::array::from_fn(|c| weights[c].to_array()[lane]),
        )
    }

    /// The index of a medium at wavenumber `node`, of `media` media.
    pub fn index(&self, node: usize, medium: usize, media: usize) -> Complex<f64> {
        let index = self.indices_at(node / F64x4::COUNT, media)[medium];
        let lane = node % F64x4::COUNT;
        Complex::new(index.re.to_array()[lane], index.im.to_array()[lane])
    }

    /// Bytes of the wavenumbers and their indices.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.wavenumbers) + size_of_val(&*self.indices)
    }
}

/// An entry of one to four wavenumbers, and the indices of the media there.
pub(super) fn entry<'a>(
    media: &'a [Medium],
    nodes: &'a [Node],
) -> (Wavenumbers, impl Iterator<Item = Complex<F64x4>> + 'a) {
    let at = |i: usize| nodes[i.min(nodes.len() - 1)].0;
    let weight = |c: usize, i: usize| nodes.get(i).map_or(0.0, |node| node.1[c]);
    let wavenumbers = Wavenumbers {
        sigma: F64x4::from_fn(at),
        weights: std::array::from_fn(|c| F64x4::from_fn(|i| weight(c, i))),
    };
    let indices = media.iter().map(move |medium| {
        let index: [_; F64x4::COUNT] = std::array::from_fn(|i| medium.index(1.0 / at(i)));
        Complex::new(
            F64x4::from_fn(|i| index[i].re),
            F64x4::from_fn(|i| index[i].im),
        )
    });
    (wavenumbers, indices)
}
