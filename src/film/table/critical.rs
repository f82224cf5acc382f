//! Cosines at which the colours change within narrow intervals: around the critical angles.

use crate::film::description::FilmDescription;

use crate::optics::{Medium, VISIBLE_NM, critical_cosine};

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
pub(super) const MOST_CENTRES: usize = 4;
/// The wavelength whose indices decide where total reflection begins and how fringes bend, nm: near the
/// eye's greatest sensitivity.
pub(super) const MIDDLE_NM: f64 = 550.0;

/// A critical cosine, and the width of the change there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Centre {
    pub cosine: f64,
    pub width: f64,
}

impl Centre {
    /// Grazing incidence, where films thinner than a wavelength have narrow features.
    pub const GRAZING: Self = Self {
        cosine: 0.0,
        width: 1e-4,
    };
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
        let near_index = near.index(MIDDLE_NM).re;
        let Some(cosine) = critical_cosine(near_index, index.re) else {
            continue;
        };
        if index.im > ABSORBING || thickness_nm == 0.0 {
            continue;
        }
        // A layer begins to transmit where q d is about lambda / (2 pi).
        let decay = MIDDLE_NM / (std::f64::consts::TAU * thickness_nm * near_index);
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
        critical_cosine(near.index(nm).re, medium.index(nm).re)
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
