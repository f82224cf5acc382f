//! The series of fringes: a stack at N wavenumbers.

use super::angle::{ChannelSums, StackAtAngle, Truncation, Wavenumbers};
use super::terms::StackMedia;
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::wavenumbers::equidistant;
use crate::num::{F64x4, widest};
use crate::optics::stack::{Incidence, S, Side};
use crate::optics::{ChannelWeights, Complex};

/// The greatest ratio of a medium's group index and its index.
const MOST_GROUP: f64 = 1.7;
/// Up to the first path the harmonics are not truncated, from the second on they are: a layer between
/// lossless neighbours first resonates at half a wavelength, 190 nm.
const FRINGELESS_NM: [f64; 2] = [90.0, 180.0];
/// The number of stacks that a single look-up has in memory at a time.
const BLOCK: usize = 4;
/// Smaller cosines are replaced by this one: there a stack either mirrors or is no stack.
const LEAST_COSINE: f64 = 1e-9;

/// The colours of a stack from its spectrum at N wavenumbers, without the fringes that N wavenumbers
/// cannot resolve. Colours are not clipped.
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
/// m fringes for each fringe of the layer. N wavenumbers a distance delta apart resolve fringes up to a
/// path of 1 / (2 delta), and alias finer ones; but the matching functions are so smooth that finer ones
/// should vanish. So Q is summed in closed form up to the harmonic M = 1 / (2 delta path) and no
/// further:
///
/// ```text
/// Q = z (1 - (-g z)^M) / (1 + g z)
/// ```
///
/// with a part of the next harmonic, so that the sum is continuous in the path. It is exact to rounding
/// for any finesse and thickness of this layer once 1 / (2 delta) exceeds the longest path at which the
/// channels show fringes (some 15 micrometres at 1e-4). The other layers' fringes are sampled: their
/// paths need more wavenumbers. The decomposition is that of Belcour & Barla 2017 (eq. 6-10, see
/// `method/harmonics.rs`), whose transform this evaluates at all orders at once; our own.
#[derive(Clone, Debug)]
pub(in crate::film) struct FringeSeries {
    wavenumbers: Vec<Wavenumbers>,
    /// Complex indices of the ambient, the layers and the base, for each of `wavenumbers`.
    indices: Vec<Complex<F64x4>>,
    /// The number of wavenumbers.
    count: usize,
    /// Their distance, per nm.
    spacing: f64,
    /// Least and greatest thickness of each layer, nm.
    ranges: Vec<[f64; 2]>,
    /// The layer whose harmonics are summed.
    summed: Option<usize>,
    /// The thickness of the summed layer, nm, if it does not vary.
    fixed_nm: Option<f64>,
    /// The longest path that the summed layer can have, per nm of its thickness.
    most_path: f64,
    /// Whether indices are the same at all wavenumbers and there is at most one layer.
    is_uniform: bool,
}

/// A series at one angle, ready for any thickness of the summed layer.
#[derive(Debug)]
pub(in crate::film) struct SeriesAtAngle<'a> {
    series: &'a FringeSeries,
    /// One per entry of `wavenumbers`, or one for all.
    stacks: Vec<StackAtAngle>,
    /// The path per nm of thickness: [`FringeSeries::path`].
    pub(super) path: f64,
}

impl SeriesAtAngle<'_> {
    /// The colours at a thickness of the layer that varies, nm, which is ignored if none does.
    pub(in crate::film) fn at(&self, thickness_nm: f64) -> Colors<f64> {
        let thickness_nm = self.series.fixed_nm.unwrap_or(thickness_nm);
        let truncation = self.series.truncation(self.path * thickness_nm);
        let mut sums = ChannelSums::default();
        let wavenumbers = &self.series.wavenumbers;
        sums.add_all(&self.stacks, wavenumbers, thickness_nm, truncation);
        sums.colors()
    }
}

impl FringeSeries {
    /// A series with `count` wavenumbers, at least 2. It fails if there is no memory.
    pub(in crate::film) fn new(description: &FilmDescription, count: usize) -> Result<Self, Error> {
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
            Wavenumbers {
                sigma: F64x4::from_fn(|i| at(i).0),
                weights: std::array::from_fn(|c| F64x4::from_fn(|i| weight(c, i))),
            }
        });
        let mut wavenumbers = Error::reserve(parts, "a film's series")?;
        wavenumbers.extend(filled);
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
            wavenumbers,
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

    /// The colours at one angle and thickness (nm, of the layer that varies; ignored if none does), without
    /// allocation. `cos_theta` is measured in the half-space that the light comes from.
    pub(in crate::film) fn at(&self, side: Side, cos_theta: f64, thickness_nm: f64) -> Colors<f64> {
        let thickness_nm = self.fixed_nm.unwrap_or(thickness_nm);
        let cos_theta = cos_theta.max(LEAST_COSINE);
        let truncation = self.truncation(self.path(side, cos_theta) * thickness_nm);
        let mut sums = ChannelSums::default();
        if self.is_uniform {
            let mut stack = [StackAtAngle::default()];
            self.fill(&mut stack, 0, side, cos_theta);
            sums.add_all(&stack, &self.wavenumbers, thickness_nm, truncation);
            return sums.colors();
        }
        let mut stacks = [StackAtAngle::default(); BLOCK];
        for (block, wavenumbers) in self.wavenumbers.chunks(BLOCK).enumerate() {
            let stacks = &mut stacks[..wavenumbers.len()];
            self.fill(stacks, block * BLOCK, side, cos_theta);
            sums.add_all(stacks, wavenumbers, thickness_nm, truncation);
        }
        sums.colors()
    }

    /// The series at an angle, for any thickness. `cos_theta` is measured in the half-space that the light
    /// comes from.
    pub(in crate::film) fn at_angle(&self, side: Side, cos_theta: f64) -> SeriesAtAngle<'_> {
        let cos_theta = cos_theta.max(LEAST_COSINE);
        let count = if self.is_uniform {
            1
        } else {
            self.wavenumbers.len()
        };
        let mut stacks = vec![StackAtAngle::default(); count];
        self.fill(&mut stacks, 0, side, cos_theta);
        SeriesAtAngle {
            series: self,
            path: self.path(side, cos_theta),
            stacks,
        }
    }

    /// Fills in the stacks of entries of `wavenumbers` from `first` on. Its loop is compiled here alone, because
    /// it is long: 37 kB with and without AVX2, which each of its callers would hold.
    #[inline(never)]
    fn fill(&self, stacks: &mut [StackAtAngle], first: usize, side: Side, cos_theta: f64) {
        widest(
            #[inline(always)]
            || {
                for (i, stack) in stacks.iter_mut().enumerate() {
                    *stack = self.stack(first + i, side, cos_theta);
                }
            },
        );
    }

    #[inline(always)]
    fn stack(&self, part: usize, side: Side, cos_theta: f64) -> StackAtAngle {
        let count = self.ranges.len() + 2;
        let media = StackMedia {
            side,
            indices: &self.indices[part * count..][..count],
            ranges: &self.ranges,
            summed: self.summed,
        };
        StackAtAngle::new(media, cos_theta, self.wavenumbers[part].sigma)
    }

    /// The path of the fringes per nm of thickness: the derivative of the phase of a round trip, in turns,
    /// with respect to the wavenumber. In dispersive media it is longer than the path of the phase. The
    /// greatest of the values at both ends and in the middle of the spectrum.
    #[inline(always)]
    fn path(&self, side: Side, cos_theta: f64) -> f64 {
        let Some(layer) = self.summed else {
            return 0.0;
        };
        let near = match side {
            Side::Ambient => 0,
            Side::Base => self.ranges.len() + 1,
        };
        // Turns of a round trip per wavelength of thickness.
        let turns = |node: usize| {
            let (part, lane) = (node / F64x4::COUNT, node % F64x4::COUNT);
            let index = |medium: usize| {
                let index = self.indices[part * (self.ranges.len() + 2) + medium];
                Complex::new(index.re.to_array()[lane], index.im.to_array()[lane])
            };
            let wave = Incidence::new(index(near).re, cos_theta).wave(index(layer + 1));
            2.0 * wave.immittance[S].re
        };
        if self.is_uniform {
            return turns(0).min(self.most_path);
        }
        let round = |node: usize| {
            let (part, lane) = (node / F64x4::COUNT, node % F64x4::COUNT);
            self.wavenumbers[part].sigma.to_array()[lane] * turns(node)
        };
        // At a critical angle within the spectrum the phase has a square root, whose derivative is
        // infinite.
        let between = |node: usize| {
            let path = (round(node + 1) - round(node)).abs() / self.spacing;
            path.min(self.most_path)
        };
        let last = self.count - 1;
        between(0).max(between(last / 2)).max(between(last - 1))
    }

    /// The last harmonic that the wavenumbers resolve at a path, nm, and the part of the next one that
    /// makes the sum continuous in the path; that part fades within a quarter of the longest path.
    ///
    /// The harmonics of layers too thin for a fringe are all summed: narrow features there come from the
    /// phases of g, hence from the layers around, or from waves that do not travel.
    fn truncation(&self, path: f64) -> Truncation {
        let last = self.longest_path() / path.max(1e-3);
        let whole = last.floor();
        let fading = 1.0 - 4.0 * ((whole + 1.0) / last - 1.0);
        let part = (last - whole).min(fading).max(0.0);
        let [none, all] = FRINGELESS_NM;
        let cut = ((path - none) / (all - none)).clamp(0.0, 1.0);
        Truncation { whole, part, cut }
    }

    /// The longest path that the wavenumbers resolve, 1 / (2 delta), nm.
    pub(super) fn longest_path(&self) -> f64 {
        0.5 / self.spacing
    }

    /// Bytes of the wavenumbers and their indices.
    pub(in crate::film) fn bytes(&self) -> usize {
        size_of_val(&*self.wavenumbers) + size_of_val(&*self.indices)
    }

    /// The number of wavenumbers.
    pub(in crate::film) fn len(&self) -> usize {
        self.count
    }
}
