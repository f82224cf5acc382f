//! The wavenumbers at which light from a side begins to be reflected totally: there the spectrum of a stack has a
//! square root, and everywhere else it is smooth. Layers have none, because a stack is even in each layer's own wave
//! vector (Born and Wolf, "Principles of Optics", section 1.6).

use super::spectrum::Spectrum;
use crate::optics::stack::Side;
use crate::optics::{Medium, VISIBLE_NM};

/// Halvings of the interval around a branch point: to a part in 1e9 of the distance of two wavenumbers.
const HALVINGS: usize = 30;

/// All branch points at a cosine on the side of the light, as wavenumbers per nm, ascending. The spectrum's own wavenumbers separate them: of
/// two between neighbours none is found.
pub(super) fn branches(
    media: &[Medium],
    spectrum: &Spectrum,
    side: Side,
    cos_theta: f64,
) -> Vec<f64> {
    let [near, far] = match side {
        Side::Ambient => [0, media.len() - 1],
        Side::Base => [media.len() - 1, 0],
    };
    // The square of n_far cos(angle there) over that of n_near: it is 0 at a branch point.
    let squared = |near: f64, far: f64| {
        let excess = (far - near) * (far + near) / (near * near);
        excess + cos_theta * cos_theta
    };
    let at = |sigma: f64| {
        let [near, far] = [near, far].map(|medium| media[medium].index(1.0 / sigma).re);
        squared(near, far)
    };
    let inner = (0..spectrum.count).map(|node| {
        let [near, far] = [near, far].map(|medium| spectrum.index(node, medium, media.len()).re);
        (spectrum.sigma(node), squared(near, far))
    });
    let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| (1.0 / nm, at(1.0 / nm)));
    let mut found = Vec::new();
    let mut before = first;
    for next in inner.chain(std::iter::once(last)) {
        if (before.1 < 0.0) != (next.1 < 0.0) {
            let (mut low, mut high) = (before.0, next.0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if (at(middle) < 0.0) == (before.1 < 0.0) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            found.push(0.5 * (low + high));
        }
        before = next;
    }
    found
}
