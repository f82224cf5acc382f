//! A coordinate for cosines at which the colours change within narrow intervals: around the critical angles.

use crate::film::description::FilmDescription;
use crate::optics::{Medium, VISIBLE_NM};

/// Wavenumbers at which the critical cosines are looked at.
const SAMPLES: usize = 64;
/// The channels are smooth over the visible spectrum, and so are their colours over the interval of critical cosines.
/// The colours change within about this part of it.
const PART: f64 = 0.125;
/// At least this number of samples within this part of the interval at one of its ends count as a critical angle of
/// their own, because the index is almost constant there.
const SAME: usize = 6;
const SAME_WITHIN: f64 = 0.03;
/// The least width of the change: cosines in single precision are not closer.
const LEAST_WIDTH: f64 = 1e-7;
/// Changes that are wider need no coordinate of their own.
const WIDE: f64 = 0.02;
/// Layers that absorb more have no critical angle.
const ABSORBING: f64 = 0.05;
/// The greatest number of critical angles that are told apart.
const MOST_CENTRES: usize = 4;
/// The least cosine in a layer by which fringes are made upright.
const LEAST_UPRIGHT: f64 = 0.2;
const HALVINGS: usize = 60;
/// The wavelength whose indices decide where total reflection begins and how fringes bend, nm: near the
/// eye's greatest sensitivity.
pub(super) const MIDDLE_NM: f64 = 550.0;

/// A critical cosine, and the width of the change there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Centre {
    cosine: f64,
    width: f64,
}

impl Centre {
    /// Grazing incidence, where films thinner than a wavelength have narrow features.
    pub const GRAZING: Self = Self {
        cosine: 0.0,
        width: 1e-4,
    };
}

/// Maps cosines in [0, 1] to [0, 1]. Around a critical cosine c0 of width w the colours are smooth functions of
///
/// ```text
/// p = v / (v^2 + w^2)^(1/4)     v = c - c0
/// ```
///
/// which is the root of v far from it, as Fresnel's amplitudes are, and v / sqrt(w) close to it. The coordinate is
/// the sum of asinh(p / sqrt(w)) over all critical cosines: its steps are in proportion to p, from sqrt(w) on.
#[derive(Clone, Debug)]
pub(super) struct CriticalAxis {
    centres: Box<[Centre]>,
    /// The sum at the cosine 0, and 1 over the difference from that at the cosine 1.
    first: f64,
    scale: f64,
    /// The square of the ratio of the near half-space's index and the varying layer's.
    tilt: f64,
}

impl CriticalAxis {
    pub fn new(centres: &[Centre], tilt: f64) -> Self {
        let mut axis = Self {
            centres: centres.into(),
            first: 0.0,
            scale: 1.0,
            tilt,
        };
        axis.first = axis.coordinate(0.0);
        axis.scale = 1.0 / axis.coordinate(1.0);
        axis
    }

    /// The coordinate of a cosine.
    #[inline(always)]
    pub fn coordinate(&self, cos_theta: f64) -> f64 {
        let of = |centre: &Centre| {
            let v = cos_theta - centre.cosine;
            let root = (v * v + centre.width * centre.width).sqrt();
            // p / sqrt(w), and asinh of it.
            let p = v.abs() / (root * centre.width).sqrt();
            (p + (p * p + 1.0).sqrt()).ln().copysign(v)
        };
        let sum: f64 = self.centres.iter().map(of).sum();
        (sum - self.first) * self.scale
    }

    /// The cosine of a coordinate.
    pub fn cosine(&self, x: f64) -> f64 {
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.coordinate(middle) < x {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The cosine in the layer that varies, at least [`LEAST_UPRIGHT`]: fringes lie along constant products of it and
    /// the thickness.
    #[inline(always)]
    pub fn upright(&self, cos_theta: f64) -> f64 {
        let squared = 1.0 - self.tilt * (1.0 - cos_theta * cos_theta);
        squared.max(LEAST_UPRIGHT * LEAST_UPRIGHT).sqrt()
    }
}

/// The critical cosines for light in a medium: those of the other half-space `far`, if there is one and it has any,
/// and those of layers at which the change is narrow.
pub(super) fn centres(
    description: &FilmDescription,
    near: &Medium,
    far: Option<&Medium>,
) -> Vec<Centre> {
    let mut found = Vec::new();
    if let Some(far) = far {
        add(&mut found, near, far, LEAST_WIDTH);
    }
    for layer in &description.layers {
        let index = layer.medium.index(MIDDLE_NM);
        let thickness_nm = layer.thickness_nm[1];
        let ratio = index.re / near.index(MIDDLE_NM).re;
        if index.im > ABSORBING || ratio >= 1.0 || thickness_nm == 0.0 {
            continue;
        }
        // A layer begins to transmit where q d is about lambda / (2 pi).
        let cosine = (1.0 - ratio * ratio).sqrt();
        let decay = MIDDLE_NM / (std::f64::consts::TAU * thickness_nm * near.index(MIDDLE_NM).re);
        let width = decay * decay / (2.0 * cosine);
        if width < WIDE {
            add(&mut found, near, &layer.medium, width.max(LEAST_WIDTH));
        }
    }
    found.truncate(MOST_CENTRES);
    found
}

/// Adds the critical cosines of one medium, unless a centre is there already.
fn add(found: &mut Vec<Centre>, near: &Medium, medium: &Medium, least_width: f64) {
    let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| 1.0 / nm);
    let step = (last - first) / (SAMPLES - 1) as f64;
    let cosines = (0..SAMPLES).filter_map(|i| {
        let nm = 1.0 / (first + i as f64 * step);
        let ratio = medium.index(nm).re / near.index(nm).re;
        let squared = (1.0 - ratio) * (1.0 + ratio);
        (squared > 0.0).then(|| squared.sqrt())
    });
    let mut cosines: Vec<f64> = cosines.collect();
    cosines.sort_by(f64::total_cmp);
    let (Some(&least), Some(&greatest)) = (cosines.first(), cosines.last()) else {
        return;
    };
    let width = (PART * (greatest - least)).max(least_width);
    let mut all = vec![Centre {
        cosine: cosines[cosines.len() / 2],
        width,
    }];
    for end in [least, greatest] {
        let mut distances: Vec<f64> = cosines.iter().map(|c| (c - end).abs()).collect();
        distances.sort_by(f64::total_cmp);
        let Some(&spread) = distances.get(SAME - 1) else {
            continue;
        };
        if spread <= SAME_WITHIN * (greatest - least) && width > least_width {
            all.push(Centre {
                cosine: end,
                width: (PART * spread).max(least_width),
            });
        }
    }
    for centre in all {
        let is_there = |other: &Centre| {
            (other.cosine - centre.cosine).abs() < other.width.max(LEAST_WIDTH)
                && other.width <= centre.width
        };
        if !found.iter().any(is_there) {
            found.push(centre);
        }
    }
}
