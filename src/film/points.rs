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
pub(super) fn points(
    description: &FilmDescription,
    count: usize,
) -> impl Iterator<Item = (Side, f64, f64)> {
    let [least, greatest] = measured_range(description);
    let sides = description.sides();
    let scattered = (0..count).map(move |i| {
        let fraction = |step: f64| (0.5 + step * i as f64).fract();
        let (u, v) = (fraction(0.754_877_666), fraction(0.569_840_291));
        let cos_theta = if i % 3 == 0 { u } else { u.powi(3).max(1e-4) };
        let part = if i % 3 == 2 { v.powi(3) } else { v };
        let side = sides[i % sides.len()];
        (side, cos_theta, least + part * (greatest - least))
    });
    let critical = sides.iter().flat_map(move |&side| {
        // Where no index disperses, nothing in the spectrum has to be resolved.
        let all = critical_angles(description, side).into_iter();
        let dispersing = all.filter(|angle| angle.disperses);
        dispersing.flat_map(move |CriticalAngle { cosine, .. }| {
            STEPS.into_iter().flat_map(move |step| {
                let cosine = (cosine + step).clamp(0.0, 1.0);
                PARTS.map(|part| (side, cosine, least + part * (greatest - least)))
            })
        })
    });
    let all = scattered.chain(critical);
    all.map(|(side, cosine, thickness)| (side, f64::from(cosine as f32), thickness))
}

/// Cosine and thickness on the ambient's side, closely about the critical angles of all media: what else to measure
/// methods for one layer at. Cosines are those of single precision.
pub(super) fn points_near_critical_angles(
    description: &FilmDescription,
) -> impl Iterator<Item = (f64, f64)> {
    let [least, greatest] = measured_range(description);
    let all = critical_angles(description, Side::Ambient).into_iter();
    all.flat_map(move |CriticalAngle { cosine, .. }| {
        NEAR_STEPS.into_iter().flat_map(move |step| {
            let cosine = f64::from((cosine + step).clamp(0.0, 1.0) as f32);
            THIN_PARTS.map(|part| (cosine, least + part * (greatest - least)))
        })
    })
}

/// The range of the thickness in which methods are measured, nm.
pub(super) fn measured_range(description: &FilmDescription) -> [f64; 2] {
    let [least, greatest] = description.varying_range();
    [least, greatest.min(least.max(THICK_NM))]
}

/// Where light begins to go along a layer or the far half-space: a root begins there.
#[derive(Clone, Copy)]
pub(super) struct CriticalAngle {
    cosine: f64,
    /// Whether it is another one at another wavelength, so that there is a root in the spectrum too.
    disperses: bool,
}

/// The critical angles of light from a side, at some wavelengths if an index disperses.
pub(super) fn critical_angles(description: &FilmDescription, side: Side) -> Vec<CriticalAngle> {
    let (near, far) = match side {
        Side::Ambient => (&description.ambient, &description.base),
        Side::Base => (&description.base, &description.ambient),
    };
    let layers = description.layers.iter().map(|layer| &layer.medium);
    let mut angles = Vec::new();
    for medium in layers.chain(std::iter::once(far)) {
        let disperses = medium.constant().is_none() || near.constant().is_none();
        let wavelengths = if disperses { CRITICAL_NM.len() } else { 1 };
        for &wavelength_nm in &CRITICAL_NM[..wavelengths] {
            let ratio = medium.index(wavelength_nm).re / near.index(wavelength_nm).re;
            if ratio < 1.0 {
                let cosine = (1.0 - ratio * ratio).sqrt();
                angles.push(CriticalAngle { cosine, disperses });
            }
        }
    }
    angles
}
