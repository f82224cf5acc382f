//! A spectrum in cells, which resolve the resonances of fixed layers and the lines of tables of measurements.

use super::angle::Wavenumbers;
use super::spectrum::{Node, Spectrum, entry};
use crate::num::{F64x4, Real};
use crate::optics::{ChannelWeights, Complex, Medium, VISIBLE_NM};

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

/// Cells of four wavenumbers each, by Gauss and Legendre's rule, halved until `is_used` says yes, which also learns
/// whether a cell is too small to be halved. At branch points the rule is over the root of the distance, and where
/// an index bends cells end. Before the halving there are `count` / 2 cells.
pub(super) fn spectrum(
    media: &[Medium],
    weights: &ChannelWeights,
    [branches, bends]: [&[f64]; 2],
    count: usize,
    mut is_used: impl FnMut(&Wavenumbers, &[Complex<F64x4>], bool) -> bool,
) -> Spectrum {
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
    let mut spectrum = Spectrum {
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
            let (wavenumbers, indices) = entry(media, &nodes);
            let indices: Vec<_> = indices.collect();
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
