//! Intervals of wavelength within which the indices of media are smooth, and means over them.

use super::color::VISIBLE_NM;
use super::{ChannelWeights, Complex, Medium};
use crate::error::Error;
use crate::num::{PI, Rgb};

/// Intervals of the attenuation's integral: 1 nm.
const STEPS: usize = 400;
const NM_PER_MM: f64 = 1e6;

/// The wavelengths that divide 380-780 nm into `steps` equal intervals, and the wavelengths of the tables of
/// media between them: within a table's interval the index is linear, and at its ends it bends.
pub(super) fn edges<'a>(
    steps: usize,
    media: impl Iterator<Item = &'a Medium> + Clone,
) -> Result<Vec<f64>, Error> {
    let nodes = media.flat_map(Medium::nodes_nm);
    let count = steps + 1 + nodes.clone().count();
    let mut edges = Error::reserve(count, "the intervals of tables of measured indices")?;
    let [first, last] = VISIBLE_NM;
    let width = (last - first) / steps as f64;
    edges.extend((0..=steps).map(|i| first + i as f64 * width));
    edges.extend(nodes);
    edges.sort_unstable_by(f64::total_cmp);
    edges.dedup();
    Ok(edges)
}

/// Far half-spaces with a greater k have no critical angle: the root is smooth over tens of nanometres.
const ROUNDED_K: f64 = 1e-2;
/// Halvings of the interval around a branch point.
const HALVINGS: usize = 40;

/// The wavelengths (nm) at which light at a cosine in the near half-space begins to be reflected totally by the far one.
/// There the spectrum of a stack has a square root, and everywhere else it is smooth: layers have no branch points,
/// because a stack is even in each layer's own wave vector (Born and Wolf, "Principles of Optics", section 1.6).
///
/// `stored` has wavelengths in ascending or descending order with the indices of both half-spaces; what is found is in
/// the same order. Of two branch points between neighbours none is found.
pub fn branches_nm(
    media: [&Medium; 2],
    cos_theta: f64,
    stored: impl Iterator<Item = (f64, [Complex<f64>; 2])>,
) -> Vec<f64> {
    if media.iter().all(|medium| medium.constant().is_some()) {
        return Vec::new();
    }
    let is_reflected = |[near, far]: [Complex<f64>; 2]| {
        let ratio = far.re / near.re;
        (ratio - 1.0) * (ratio + 1.0) + cos_theta * cos_theta < 0.0
    };
    let mut found = Vec::new();
    let mut before: Option<(f64, bool)> = None;
    for (nm, indices) in stored {
        let reflected = is_reflected(indices);
        if let Some((nm_before, reflected_before)) = before
            && reflected_before != reflected
            && indices[1].im < ROUNDED_K
        {
            let [mut low, mut high] = [nm_before, nm];
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if is_reflected(media.map(|medium| medium.index(middle))) == reflected_before {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            found.push(0.5 * (low + high));
        }
        before = Some((nm, reflected));
    }
    found
}

/// The attenuation 4 pi k / lambda of light in a medium (Beer's law: the power falls by exp(-attenuation times
/// the path)), per millimetre: the mean of each channel under its weights, by Simpson's rule. A channel whose
/// negative weights prevail has 0.
pub fn attenuation_per_mm(medium: &Medium, weights: &ChannelWeights) -> Result<Rgb<f64>, Error> {
    if !medium.absorbs() {
        return Ok([0.0; 3]);
    }
    let edges = edges(STEPS, std::iter::once(medium))?;
    let (mut sums, mut white) = ([0.0; 3], [0.0; 3]);
    for pair in edges.windows(2) {
        let [start, end] = [pair[0], pair[1]];
        let width = end - start;
        for (nm, part) in [
            (start, 1.0 / 6.0),
            (0.5 * (start + end), 4.0 / 6.0),
            (end, 1.0 / 6.0),
        ] {
            let attenuation = 4.0 * PI * medium.index(nm).im / nm * NM_PER_MM;
            let weights = weights.at(nm);
            for c in 0..3 {
                white[c] += part * width * weights[c];
                sums[c] += part * width * weights[c] * attenuation;
            }
        }
    }
    Ok(std::array::from_fn(|c| (sums[c] / white[c]).max(0.0)))
}
