//! Media that several layers of a film have.

use super::description::FilmLayer;

/// The number of media of several layers in which waves are kept from one layer to the next.
pub(super) const KEPT: usize = 4;

/// For each layer the number of its medium among those of several layers; [`KEPT`] if its waves are not kept.
pub(super) fn repeated_media(layers: &[FilmLayer]) -> Box<[usize]> {
    let is_like = |i: usize, j: usize| layers[i].medium.is_like(&layers[j].medium);
    let mut numbers = vec![KEPT; layers.len()];
    let mut count = 0;
    for i in 0..layers.len() {
        let others = i + 1..layers.len();
        if numbers[i] < KEPT || count == KEPT || !others.clone().any(|j| is_like(i, j)) {
            continue;
        }
        numbers[i] = count;
        for j in others.filter(|j| is_like(i, *j)) {
            numbers[j] = count;
        }
        count += 1;
    }
    numbers.into()
}
