//! The points at which methods are measured.

use crate::film::description::FilmDescription;
use crate::optics::stack::Side;

/// The greatest thickness that is measured, nm: thicker films show no colours, and the reference takes
/// long for them.
const THICK_NM: f64 = 3e5;
/// The wavelengths at which the critical angles of dispersing media are taken, nm.
const CRITICAL_NM: [f64; 3] = [430.0, 550.0, 680.0];
/// The points around a critical angle: steps of the cosine, and thicknesses as parts of the range.
const STEPS: [f64; 5] = [-0.004, -0.001, 0.0, 0.001, 0.004];
const PARTS: [f64; 3] = [0.07, 0.5, 1.0];
/// The same for methods for one layer. The thinnest films are included, which the light tunnels through.
const NEAR_STEPS: [f64; 4] = [-1e-6, 0.0, 1e-6, 1e-5];
const THIN_PARTS: [f64; 4] = [0.0, 0.001, 0.07, 0.5];

/// Points (side, cosine on that side, thickness in nm): `count` by the R2 sequence (Roberts 2018), a third
/// of them evenly, a third towards grazing angles, a third towards both grazing angles and thin films;
/// then some around critical angles. If both sides are asked for, they take turns.
pub(in crate::film) fn points(
    description: &FilmDescription,
    count: usize,
) -> Vec<(Side, f64, f64)> {
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
        // Critical angles without dispersion are the same for all wavelengths, so that the spectrum is
        // smooth.
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

/// Cosines on the ambient's side and thicknesses (nm) close to the critical angles of all media, at which
/// methods for one layer are measured too.
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

/// A cosine rounded to single precision, as callers give it.
fn rounded(cosine: f64) -> f64 {
    f64::from(cosine as f32)
}

/// The range of the thickness in which methods are measured, nm.
pub(super) fn measured_range(description: &FilmDescription) -> [f64; 2] {
    let [least, greatest] = description.varying_range();
    [least, greatest.min(least.max(THICK_NM))]
}

/// Cosines at which light from a side begins to travel along a layer or the far half-space: colours have
/// the singularity of a square root there.
pub(in crate::film) struct CriticalAngles {
    /// The cosines of media without dispersion.
    constant: Vec<f64>,
    /// The cosines of dispersing media, at some wavelengths: each wavelength has its own, so that the
    /// spectrum has the singularity too.
    dispersing: Vec<f64>,
}

impl CriticalAngles {
    /// All cosines.
    pub(in crate::film) fn all(self) -> Vec<f64> {
        [self.constant, self.dispersing].concat()
    }
}

/// The critical angles of light from a side.
pub(in crate::film) fn critical_angles(
    description: &FilmDescription,
    side: Side,
) -> CriticalAngles {
    let [near, far] = description.near_and_far(side);
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
