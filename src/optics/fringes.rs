//! The number of fringes that a stack shows between two wavelengths.

use super::Complex;
use super::stack::{Incidence, S, Side};
use crate::num::PI;

/// A layer that less than this fraction of the light crosses shows no fringes.
const OPAQUE: f64 = 1e-7;

/// The sum over the layers of the change of the phase 2 q d / lambda, in turns, between two wavelengths, nm, dispersion
/// included. `thicknesses_nm`: of the layers, the ambient's neighbour first. `index`: at the first or second wavelength,
/// of a medium counted from the ambient.
pub(super) fn fringes(
    side: Side,
    cos_theta: f64,
    thicknesses_nm: impl DoubleEndedIterator<Item = f64> + ExactSizeIterator,
    nm: [f64; 2],
    index: impl Fn(usize, usize) -> Complex<f64>,
) -> f64 {
    let count = thicknesses_nm.len();
    let near = if side == Side::Ambient { 0 } else { count + 1 };
    let incidences = [0, 1].map(|end| Incidence::new(index(end, near).re, cos_theta));
    let mut state = (0.0, 1.0);
    // Whether light reaches the layer below.
    let mut cross = |medium: usize, thickness_nm: f64| {
        let (turns, light) = &mut state;
        let [a, b] = [0, 1].map(|end| {
            let wave = incidences[end].wave(index(end, medium));
            wave.immittance[S].scaled(1.0 / nm[end])
        });
        // Thickness that no light reaches adds no fringes.
        let extinction = 4.0 * PI * a.im.min(b.im);
        let depth_nm = (*light / OPAQUE).ln() / extinction.max(f64::MIN_POSITIVE);
        let reached_nm = thickness_nm.min(depth_nm);
        *turns += 2.0 * reached_nm * (a.re - b.re).abs();
        *light *= (-extinction * reached_nm).exp();
        reached_nm < depth_nm
    };
    let mut layers = (1..count + 1).zip(thicknesses_nm);
    match side {
        Side::Ambient => layers.all(|(medium, nm)| cross(medium, nm)),
        Side::Base => layers.rev().all(|(medium, nm)| cross(medium, nm)),
    };
    state.0
}
