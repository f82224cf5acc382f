//! The wavenumbers of a series, the weights of the channels there, and the indices of the media.

use super::angle::Wavenumbers;
use crate::error::Error;
use crate::film::wavenumbers::equidistant;
use crate::num::{F64x4, Real, Rgb};
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
type Node = (f64, Rgb<f64>);

/// Gauss and Legendre's rule with four nodes on [0, 1].
const GAUSS: [[f64; 2]; 4] = [
    [0.069_431_844_202_973_71, 0.173_927_422_568_726_93],
    [0.330_009_478_207_571_87, 0.326_072_577_431_273_07],
    [0.669_990_521_792_428_1, 0.326_072_577_431_273_07],
    [0.930_568_155_797_026_3, 0.173_927_422_568_726_93],
];
/// A cell resolves fringes whose path is at most 0.8 of the inverse of its width: the error is below 1e-4 there.
const CELL: f64 = 1.6;
/// Cells are not halved beyond this part of the spectrum.
const LEAST_CELL: f64 = 1e-5;

/// An interval of the spectrum.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// One end, and the distance to the other one, per nm; the branch point is at the first end if there is one.
    from: f64,
    width: f64,
    is_at_branch: bool,
}

impl Cell {
    fn plain(from: f64, width: f64) -> Self {
        Self {
            from,
            width,
            is_at_branch: false,
        }
    }

    fn at_branch(from: f64, width: f64) -> Self {
        Self {
            from,
            width,
            is_at_branch: true,
        }
    }

    fn nodes(&self, weights: &ChannelWeights) -> [Node; 4] {
        GAUSS.map(|[x, weight]| {
            let (part, slope) = if self.is_at_branch {
                (x * x, 2.0 * x)
            } else {
                (x, 1.0)
            };
            let sigma = self.from + part * self.width;
            // The channels per wavenumber: d lambda = lambda^2 d sigma.
            let factor = weight * slope * self.width.abs() / (sigma * sigma);
            (sigma, weights.at(1.0 / sigma).map(|w| w * factor))
        })
    }

    fn halves(&self) -> [Self; 2] {
        let half = 0.5 * self.width;
        [
            Self::plain(self.from + half, half),
            Self {
                width: half,
                ..*self
            },
        ]
    }
}

impl Spectrum {
    /// `count` equidistant wavenumbers, at least 2. It fails if there is no memory.
    pub fn equidistant(
        media: &[Medium],
        weights: &ChannelWeights,
        count: usize,
    ) -> Result<Self, Error> {
        let nodes = equidistant(weights, count, 0.0);
        let spacing = nodes[1].0 - nodes[0].0;
        Self::of_nodes(media, &nodes, spacing)
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

    /// Cells of four wavenumbers each, by Gauss and Legendre's rule, halved until `is_used` says yes, which also learns
    /// whether a cell is too small to be halved. At branch points the rule is over the root of the distance, and where
    /// an index bends cells end. Before the halving there are `count` / 2 cells.
    pub fn in_cells(
        media: &[Medium],
        weights: &ChannelWeights,
        [branches, bends]: [&[f64]; 2],
        count: usize,
        mut is_used: impl FnMut(&Wavenumbers, &[Complex<F64x4>], bool) -> bool,
    ) -> Self {
        let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| 1.0 / nm);
        let width = 2.0 * (last - first) / count as f64;
        let mut ends: Vec<(f64, bool)> = [first, last]
            .iter()
            .chain(bends)
            .map(|&sigma| (sigma, false))
            .chain(branches.iter().map(|&sigma| (sigma, true)))
            .collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        ends.dedup_by(|a, b| {
            b.1 |= a.1 && a.0 == b.0;
            a.0 == b.0
        });
        let mut spectrum = Self {
            wavenumbers: Vec::new(),
            indices: Vec::new(),
            count: 0,
            spacing: width / CELL,
        };
        let mut white = [0.0; 3];
        for pair in ends.windows(2) {
            let [(from, is_branch_before), (to, is_branch_after)] = [pair[0], pair[1]];
            let parts = ((to - from) / width).ceil().max(1.0) as usize;
            let width = (to - from) / parts as f64;
            // The cells still to do, the next one last.
            let cell = |i: usize| {
                let begins = i == 0 && is_branch_before;
                let ends_here = i + 1 == parts && is_branch_after;
                let start = from + i as f64 * width;
                match (begins, ends_here) {
                    (false, false) => vec![Cell::plain(start, width)],
                    (true, false) => vec![Cell::at_branch(start, width)],
                    (false, true) => vec![Cell::at_branch(start + width, -width)],
                    (true, true) => vec![
                        Cell::at_branch(start + width, -0.5 * width),
                        Cell::at_branch(start, 0.5 * width),
                    ],
                }
            };
            let mut waiting: Vec<Cell> = (0..parts).rev().flat_map(cell).collect();
            while let Some(cell) = waiting.pop() {
                let nodes = cell.nodes(weights);
                let sigma = F64x4::from_fn(|i| nodes[i].0);
                let wavenumbers = Wavenumbers {
                    sigma,
                    weights: std::array::from_fn(|c| F64x4::from_fn(|i| nodes[i].1[c])),
                };
                let indices: Vec<_> = media
                    .iter()
                    .map(|medium| {
                        let index = nodes.map(|node| medium.index(1.0 / node.0));
                        Complex::new(
                            F64x4::from_fn(|i| index[i].re),
                            F64x4::from_fn(|i| index[i].im),
                        )
                    })
                    .collect();
                let is_least = cell.width.abs() <= LEAST_CELL * (last - first);
                if !is_used(&wavenumbers, &indices, is_least) {
                    waiting.extend(cell.halves());
                    continue;
                }
                for (white, weights) in white.iter_mut().zip(wavenumbers.weights) {
                    *white += weights.sum();
                }
                spectrum.wavenumbers.push(wavenumbers);
                spectrum.indices.extend(indices);
                spectrum.count += F64x4::COUNT;
            }
        }
        for wavenumbers in &mut spectrum.wavenumbers {
            for (weights, white) in wavenumbers.weights.iter_mut().zip(white) {
                *weights = *weights / F64x4::new(white);
            }
        }
        spectrum
    }

    fn of_nodes(media: &[Medium], nodes: &[Node], spacing: f64) -> Result<Self, Error> {
        let parts = nodes.len().div_ceil(F64x4::COUNT);
        let mut indices = Error::reserve(parts * media.len(), "a film's series")?;
        let mut wavenumbers = Error::reserve(parts, "a film's series")?;
        for nodes in nodes.chunks(F64x4::COUNT) {
            let at = |i: usize| nodes[i.min(nodes.len() - 1)].0;
            for medium in media {
                let index: [_; F64x4::COUNT] = std::array::from_fn(|i| medium.index(1.0 / at(i)));
                indices.push(Complex::new(
                    F64x4::from_fn(|i| index[i].re),
                    F64x4::from_fn(|i| index[i].im),
                ));
            }
            let weight = |c: usize, i: usize| nodes.get(i).map_or(0.0, |node| node.1[c]);
            wavenumbers.push(Wavenumbers {
                sigma: F64x4::from_fn(at),
                weights: std::array::from_fn(|c| F64x4::from_fn(|i| weight(c, i))),
            });
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
