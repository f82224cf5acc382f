//! Where methods are measured.

use super::FilmDescription;
use crate::optics::stack::Side;

/// Films that vary beyond this are measured up to it, nm: thicker ones show no colours, and take the
/// reference long.
const THICK_NM: f64 = 3e5;
/// The wavelengths whose critical angles are among the angles.
const CRITICAL_NM: [f64; 3] = [430.0, 550.0, 680.0];
/// What is measured about a critical angle: steps of the cosine, and parts of the thickness.
const STEPS: [f64; 5] = [-0.004, -0.001, 0.0, 0.001, 0.004];
const PARTS: [f64; 3] = [0.07, 0.5, 1.0];
/// The same for methods that cut their sums: thinnest films too, which the light tunnels through.
const NEAR_STEPS: [f64; 4] = [-1e-6, 0.0, 1e-6, 1e-5];
const THIN_PARTS: [f64; 4] = [0.0, 0.001, 0.07, 0.5];

/// Side, cosine on that side and thickness: a third evenly, a third towards grazing angles, a third towards
/// both grazing angles and thin films, by the R2 sequence (Roberts 2018). From both sides by turns, if both
/// are asked for. And about critical angles, beyond the count.
pub(super) fn points(description: &FilmDescription, count: usize) -> Vec<(Side, f64, f64)> {
    let [least, greatest] = measured_range(description);
    let sides = description.sides();
    let mut points = Vec::new();
    for i in 0..count {
        let fraction = |step: f64| (0.5 + step * i as f64).fract();
        let (u, v) = (fraction(0.754_877_666), fraction(0.569_840_291));
        let cosine = if i % 3 == 0 { u } else { u.powi(3).max(1e-4) };
        let part = if i % 3 == 2 { v.powi(3) } else { v };
        let thickness_nm = least + part * (greatest - least);
        points.push((sides[i % sides.len()], rounded(cosine), thickness_nm));
    }
    for &side in sides {
        // Where no index disperses, nothing in the spectrum has to be resolved.
        for critical in critical_angles(description, side).dispersing {
            for step in STEPS {
                for part in PARTS {
                    let cosine = (critical + step).clamp(0.0, 1.0);
                    points.push((side, rounded(cosine), least + part * (greatest - least)));
                }
            }
        }
    }
    points
}

/// Cosine and thickness on the ambient's side, closely about the critical angles of all media: what else to measure
/// methods for one layer at.
pub(super) fn points_near_critical_angles(description: &FilmDescription) -> Vec<(f64, f64)> {
    let [least, greatest] = measured_range(description);
    let mut points = Vec::new();
    for critical in critical_angles(description, Side::Ambient).all() {
        for step in NEAR_STEPS {
            for part in THIN_PARTS {
                let cosine = (critical + step).clamp(0.0, 1.0);
                points.push((rounded(cosine), least + part * (greatest - least)));
            }
        }
    }
    points
}

/// A cosine as single precision has it: callers give no other.
fn rounded(cosine: f64) -> f64 {
    f64::from(cosine as f32)
}

/// The range of the thickness in which methods are measured, nm.
pub(super) fn measured_range(description: &FilmDescription) -> [f64; 2] {
    let [least, greatest] = description.varying_range();
    [least, greatest.min(least.max(THICK_NM))]
}

/// Cosines at which light from a side begins to go along a layer or the far half-space: a root begins there.
pub(super) struct CriticalAngles {
    /// Of media without dispersion.
    constant: Vec<f64>,
    /// At some wavelengths: others have other ones, so that there is a root in the spectrum too.
    dispersing: Vec<f64>,
}

impl CriticalAngles {
    pub(super) fn all(self) -> Vec<f64> {
        [self.constant, self.dispersing].concat()
    }
}

/// The critical angles of light from a side.
pub(super) fn critical_angles(description: &FilmDescription, side: Side) -> CriticalAngles {
    let (near, far) = match side {
        Side::Ambient => (&description.ambient, &description.base),
        Side::Base => (&description.base, &description.ambient),
    };
    let layers = description.layers.iter().map(|layer| &layer.medium);
    let [mut constant, mut dispersing] = [Vec::new(), Vec::new()];
    for medium in layers.chain(std::iter::once(far)) {
        let disperses = medium.constant().is_none() || near.constant().is_none();
        let (cosines, wavelengths) = if disperses {
            (&mut dispersing, &CRITICAL_NM[..])
        } else {
            (&mut constant, &CRITICAL_NM[..1])
        };
        for &wavelength_nm in wavelengths {
            let ratio = medium.index(wavelength_nm).re / near.index(wavelength_nm).re;
            if ratio < 1.0 {
                cosines.push((1.0 - ratio * ratio).sqrt());
            }
        }
    }
    CriticalAngles {
        constant,
        dispersing,
    }
}
