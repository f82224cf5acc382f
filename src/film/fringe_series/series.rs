//! The series of fringes: a stack at N wavenumbers.

use super::angle::{ChannelSums, StackAtAngle, Truncation, Wavenumbers};
use super::cells;
use super::spectrum::{Node, Spectrum};
use super::terms::StackMedia;
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::wavenumbers::equidistant;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
use crate::num::{F64x4, widest};
use crate::optics::stack::{Incidence, S, Side};
use crate::optics::{ChannelWeights, Complex, Medium, VISIBLE_NM, branches_nm};
use std::borrow::Cow;

/// The greatest ratio of a medium's group index and its index.
const MOST_GROUP: f64 = 1.7;
/// Up to the first path the harmonics are not truncated, from the second on they are: a layer between
/// lossless neighbours first resonates at half a wavelength, 190 nm.
const FRINGELESS_NM: [f64; 2] = [90.0, 180.0];
/// Times of four wavenumbers, ns: of the sum over the beams in one layer, and of each layer.
const BEAMS_NS: f64 = 120.0;
const LAYER_NS: f64 = 60.0;
/// The number of parts of the spectrum over which the path of the fringes is taken.
const PATH_PARTS: usize = 6;
/// The greatest number of wavenumbers of a series that is loaded.
const MOST_LOADED: usize = 1 << 14;
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
///
/// Where a half-space disperses, each wavelength has its own critical angle, and the spectrum at a cosine between them
/// has a branch point. There the wavenumbers are chosen anew for the cosine ([`Spectrum::between_branches`]).
#[derive(Clone, Debug)]
pub(in crate::film) struct FringeSeries {
    spectrum: Spectrum,
    /// The ambient, the layers and the base.
    media: Vec<Medium>,
    weights: ChannelWeights,
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
    /// Whether nothing absorbs.
    is_lossless: bool,
    /// Whether the relative index of the half-spaces depends on the wavelength.
    has_branches: bool,
    /// Whether wavenumbers are chosen for every angle so that they resolve the resonances of the other layers and the
    /// lines of tables of measurements.
    is_graded: bool,
    /// The wavelengths of tables of measurements as wavenumbers, per nm, ascending: there the index bends.
    bends: Vec<f64>,
}

/// A series at one angle, ready for any thickness of the summed layer.
#[derive(Debug)]
pub(in crate::film) struct SeriesAtAngle<'a> {
    series: &'a FringeSeries,
    spectrum: Cow<'a, Spectrum>,
    /// One per entry of the wavenumbers, or one for all.
    stacks: Vec<StackAtAngle>,
    /// The path per nm of thickness: [`FringeSeries::path`].
    pub(super) path: f64,
}

impl SeriesAtAngle<'_> {
    /// The colours at a thickness of the layer that varies, nm, which is ignored if none does.
    pub(in crate::film) fn at(&self, thickness_nm: f64) -> Colors<f64> {
        let thickness_nm = self.series.fixed_nm.unwrap_or(thickness_nm);
        let truncation = truncation(&self.spectrum, self.path * thickness_nm);
        let mut sums = ChannelSums::default();
        let wavenumbers = &self.spectrum.wavenumbers;
        sums.add_all(&self.stacks, wavenumbers, thickness_nm, truncation);
        self.series.colors(&sums)
    }
}

impl FringeSeries {
    /// A series with `count` wavenumbers, at least 2. It fails if there is no memory.
    pub(in crate::film) fn new(description: &FilmDescription, count: usize) -> Result<Self, Error> {
        let weights = ChannelWeights::new(description.white, description.color_space);
        Self::of_nodes(description, &equidistant(&weights, count, 0.0))
    }

    fn of_nodes(description: &FilmDescription, nodes: &[Node]) -> Result<Self, Error> {
        let weights = ChannelWeights::new(description.white, description.color_space);
        let layers = &description.layers;
        let ranges: Vec<_> = layers.iter().map(|l| l.thickness_nm).collect();
        let media: Vec<_> = std::iter::once(&description.ambient)
            .chain(layers.iter().map(|layer| &layer.medium))
            .chain(std::iter::once(&description.base))
            .cloned()
            .collect();
        let spectrum = Spectrum::equidistant(&media, nodes)?;
        let thickest = || {
            (0..ranges.len()).max_by(|&a, &b| {
                let path = |i: usize| ranges[i][1] * spectrum.index(0, i + 1, media.len()).re;
                path(a).total_cmp(&path(b))
            })
        };
        let summed = description.varying().or_else(thickest);
        let is_constant = media.iter().all(|medium| medium.constant().is_some());
        let most_index = summed.map_or(0.0, |layer| {
            let along = (0..spectrum.count).map(|i| spectrum.index(i, layer + 1, media.len()).re);
            along.fold(0.0, f64::max)
        });
        Ok(Self {
            fixed_nm: description
                .varying()
                .is_none()
                .then(|| summed.map_or(0.0, |layer| ranges[layer][0])),
            most_path: 2.0 * MOST_GROUP * most_index,
            is_uniform: ranges.len() < 2 && is_constant,
            is_lossless: media.iter().all(|medium| !medium.absorbs()),
            has_branches: description.disperses() && !description.is_base_opaque(),
            spectrum,
            media,
            weights,
            summed,
            ranges,
            is_graded: false,
            bends: description
                .nodes_nm()?
                .iter()
                .rev()
                .map(|nm| 1.0 / nm)
                .collect(),
        })
    }

    /// Writes the wavenumbers and their weights, which take longer to find than all else that a series has.
    pub(in crate::film) fn save(&self, block: &mut ByteWriter) {
        block.flag(self.is_graded);
        block.count(self.len());
        for node in 0..self.len() {
            let (sigma, [r, g, b]) = self.spectrum.node(node);
            block.numbers(&[sigma, r, g, b]);
        }
    }

    /// Reads the series of a film.
    pub(in crate::film) fn load(
        block: &mut ByteReader<'_>,
        description: &FilmDescription,
    ) -> Result<Self, Error> {
        let is_graded = block.flag()?;
        let count = block.count(size_of::<[f64; 4]>(), MOST_LOADED)?;
        let mut nodes: Vec<Node> = Error::reserve(count, "a film's series")?;
        let mut least = 1.0 / VISIBLE_NM[1];
        for _ in 0..count {
            let sigma = block.number_within("a wavenumber", [least, 1.0 / VISIBLE_NM[0]])?;
            let weights = [(); 3].map(|()| block.number_within("a weight", [-1e3, 1e3]));
            let [r, g, b] = weights;
            nodes.push((sigma, [r?, g?, b?]));
            least = sigma.next_up();
        }
        if count < 2 {
            return Err(unusable("a series has fewer than 2 wavenumbers"));
        }
        let series = Self::of_nodes(description, &nodes)?;
        Ok(if is_graded { series.graded() } else { series })
    }

    /// The same series with wavenumbers that resolve the resonances of all layers but the summed one, at every angle.
    pub(in crate::film) fn graded(self) -> Self {
        Self {
            is_graded: true,
            ..self
        }
    }

    /// The colours at one angle and thickness (nm, of the layer that varies; ignored if none does). `cos_theta` is
    /// measured in the half-space that the light comes from. It allocates at branch points alone.
    pub(in crate::film) fn at(&self, side: Side, cos_theta: f64, thickness_nm: f64) -> Colors<f64> {
        let cos_theta = cos_theta.max(LEAST_COSINE);
        if let Some(at_angle) = self.with_own_spectrum(side, cos_theta) {
            return at_angle.at(thickness_nm);
        }
        let thickness_nm = self.fixed_nm.unwrap_or(thickness_nm);
        let spectrum = &self.spectrum;
        let truncation = truncation(
            spectrum,
            self.path(spectrum, side, cos_theta) * thickness_nm,
        );
        let mut sums = ChannelSums::default();
        if self.is_uniform {
            let mut stack = [StackAtAngle::default()];
            let (wavenumbers, indices) = (&spectrum.wavenumbers, &spectrum.indices);
            self.fill(&mut stack, wavenumbers, indices, side, cos_theta);
            sums.add_all(&stack, &spectrum.wavenumbers, thickness_nm, truncation);
            return self.colors(&sums);
        }
        let mut stacks = [StackAtAngle::default(); BLOCK];
        let blocks = spectrum.indices.chunks(BLOCK * self.media.len());
        for (wavenumbers, indices) in spectrum.wavenumbers.chunks(BLOCK).zip(blocks) {
            let stacks = &mut stacks[..wavenumbers.len()];
            self.fill(stacks, wavenumbers, indices, side, cos_theta);
            sums.add_all(stacks, wavenumbers, thickness_nm, truncation);
        }
        self.colors(&sums)
    }

    /// The colours of sums. Where nothing absorbs and little goes through, R is 1 - T: that is exact at resonances
    /// behind total reflection, which are narrower than any distance of wavenumbers.
    #[inline(always)]
    fn colors(&self, sums: &ChannelSums) -> Colors<f64> {
        let mut colors = sums.colors();
        if self.is_lossless {
            for (r, t) in colors.reflectance.iter_mut().zip(colors.transmittance) {
                if t < 0.5 {
                    *r = 1.0 - t;
                }
            }
        }
        colors
    }

    /// The series at an angle, for any thickness. `cos_theta` is measured in the half-space that the light
    /// comes from.
    pub(in crate::film) fn at_angle(&self, side: Side, cos_theta: f64) -> SeriesAtAngle<'_> {
        let cos_theta = cos_theta.max(LEAST_COSINE);
        if let Some(at_angle) = self.with_own_spectrum(side, cos_theta) {
            return at_angle;
        }
        let spectrum = &self.spectrum;
        let count = if self.is_uniform {
            1
        } else {
            spectrum.wavenumbers.len()
        };
        let mut stacks = vec![StackAtAngle::default(); count];
        let (wavenumbers, indices) = (&spectrum.wavenumbers, &spectrum.indices);
        self.fill(&mut stacks, wavenumbers, indices, side, cos_theta);
        SeriesAtAngle {
            series: self,
            path: self.path(spectrum, side, cos_theta),
            spectrum: Cow::Borrowed(spectrum),
            stacks,
        }
    }

    /// The series with wavenumbers chosen for an angle; `None` if those of all angles do, or if there is no memory.
    fn with_own_spectrum(&self, side: Side, cos_theta: f64) -> Option<SeriesAtAngle<'_>> {
        let branches = self.branches(side, cos_theta);
        let mut stacks = Vec::new();
        let spectrum = if self.is_graded {
            cells::spectrum(
                &self.media,
                &self.weights,
                [&branches, &self.bends],
                self.spectrum.count,
                |wavenumbers, indices, is_least| {
                    let mut stack = [StackAtAngle::default()];
                    let wavenumbers = std::slice::from_ref(wavenumbers);
                    self.fill(&mut stack, wavenumbers, indices, side, cos_theta);
                    let is_used = is_least || stack[0].is_resolved();
                    if is_used {
                        stacks.extend(stack);
                    }
                    is_used
                },
            )
        } else if branches.is_empty() {
            return None;
        } else {
            let (media, weights) = (&self.media, &self.weights);
            let count = self.spectrum.count;
            let spectrum = Spectrum::between_branches(media, weights, &branches, count).ok()?;
            stacks.resize(spectrum.wavenumbers.len(), StackAtAngle::default());
            let (wavenumbers, indices) = (&spectrum.wavenumbers, &spectrum.indices);
            self.fill(&mut stacks, wavenumbers, indices, side, cos_theta);
            spectrum
        };
        Some(SeriesAtAngle {
            series: self,
            path: self.path(&spectrum, side, cos_theta),
            spectrum: Cow::Owned(spectrum),
            stacks,
        })
    }

    /// The branch points of the spectrum, as wavenumbers per nm, ascending.
    fn branches(&self, side: Side, cos_theta: f64) -> Vec<f64> {
        if !self.has_branches {
            return Vec::new();
        }
        let last = self.media.len() - 1;
        let half_spaces = match side {
            Side::Ambient => [0, last],
            Side::Base => [last, 0],
        };
        let indices = |sigma: f64| half_spaces.map(|at| self.media[at].index(1.0 / sigma));
        let [first, end] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| (nm, indices(1.0 / nm)));
        let nodes = (0..self.spectrum.count).map(|node| {
            let index = |at| self.spectrum.index(node, at, self.media.len());
            (1.0 / self.spectrum.sigma(node), half_spaces.map(index))
        });
        let stored = std::iter::once(first).chain(nodes).chain([end]);
        let half_spaces = half_spaces.map(|at| &self.media[at]);
        let mut found = branches_nm(half_spaces, cos_theta, stored);
        for branch in &mut found {
            *branch = 1.0 / *branch;
        }
        found
    }

    /// Fills in the stacks at entries of a spectrum. Its loop is compiled here alone, because it is long: 37 kB with
    /// and without AVX2, which each of its callers would hold.
    #[inline(never)]
    fn fill(
        &self,
        stacks: &mut [StackAtAngle],
        wavenumbers: &[Wavenumbers],
        indices: &[Complex<F64x4>],
        side: Side,
        cos_theta: f64,
    ) {
        let entries = wavenumbers.iter().zip(indices.chunks(self.media.len()));
        widest(
            #[inline(always)]
            || {
                for (stack, (wavenumbers, indices)) in stacks.iter_mut().zip(entries) {
                    let media = StackMedia {
                        side,
                        indices,
                        ranges: &self.ranges,
                        summed: self.summed,
                    };
                    *stack = StackAtAngle::new(media, cos_theta, wavenumbers.sigma);
                }
            },
        );
    }

    /// The path of the fringes per nm of thickness: the derivative of the phase of a round trip, in turns,
    /// with respect to the wavenumber. In dispersive media it is longer than the path of the phase. The
    /// greatest of the mean values over parts of the spectrum: at a layer's critical angle within the spectrum the phase
    /// has a square root, whose derivative is infinite, while the sum of all harmonics is smooth there.
    #[inline(always)]
    fn path(&self, spectrum: &Spectrum, side: Side, cos_theta: f64) -> f64 {
        let Some(layer) = self.summed else {
            return 0.0;
        };
        let near = match side {
            Side::Ambient => 0,
            Side::Base => self.ranges.len() + 1,
        };
        // Turns of a round trip per wavelength of thickness.
        let turns = |node: usize| {
            let index = |medium: usize| spectrum.index(node, medium, self.media.len());
            let wave = Incidence::new(index(near).re, cos_theta).wave(index(layer + 1));
            2.0 * wave.immittance[S].re
        };
        if self.is_uniform {
            return turns(0).min(self.most_path);
        }
        let last = spectrum.count - 1;
        let phase = |node: usize| {
            let sigma = spectrum.sigma(node);
            (sigma, sigma * turns(node))
        };
        let mut before = phase(0);
        let mut greatest = 0.0f64;
        for part in 1..=PATH_PARTS {
            let next = phase(last * part / PATH_PARTS);
            if next.0 != before.0 {
                greatest = greatest.max(((next.1 - before.1) / (next.0 - before.0)).abs());
            }
            before = next;
        }
        greatest.min(self.most_path)
    }

    /// The longest path that the wavenumbers resolve, nm.
    #[cfg(test)]
    pub(super) fn longest_path(&self) -> f64 {
        longest_path(&self.spectrum)
    }

    /// Estimated time of a call, ns, on one core of a 2024 server; more at branch points.
    pub(in crate::film) fn cost_ns(&self) -> f64 {
        let layers = self.ranges.len() as f64;
        self.spectrum.wavenumbers.len() as f64 * (BEAMS_NS + LAYER_NS * layers)
    }

    /// Bytes of the wavenumbers and their indices.
    pub(in crate::film) fn bytes(&self) -> usize {
        self.spectrum.bytes()
    }

    /// The number of wavenumbers.
    pub(in crate::film) fn len(&self) -> usize {
        self.spectrum.count
    }
}

/// The last harmonic that the wavenumbers resolve at a path, nm, and the part of the next one that
/// makes the sum continuous in the path; that part fades within a quarter of the longest path.
///
/// The harmonics of layers too thin for a fringe are all summed: narrow features there come from the
/// phases of g, hence from the layers around, or from waves that do not travel.
fn truncation(spectrum: &Spectrum, path: f64) -> Truncation {
    let last = longest_path(spectrum) / path.max(1e-3);
    let whole = last.floor();
    let fading = 1.0 - 4.0 * ((whole + 1.0) / last - 1.0);
    let part = (last - whole).min(fading).max(0.0);
    let [none, all] = FRINGELESS_NM;
    let cut = ((path - none) / (all - none)).clamp(0.0, 1.0);
    Truncation { whole, part, cut }
}

/// The longest path that the wavenumbers resolve, 1 / (2 delta), nm.
fn longest_path(spectrum: &Spectrum) -> f64 {
    0.5 / spectrum.spacing
}
