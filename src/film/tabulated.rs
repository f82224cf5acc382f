//! Films with media that are given by tables of measurements: where their indices bend, and what equidistant
//! wavenumbers do not see of them.

use super::description::FilmDescription;
use crate::error::Error;
use crate::num::PI;
use crate::optics::{ChannelWeights, Complex, Medium, VISIBLE_NM};

/// The greatest number of different wavelengths of a film's tables between 380 and 780 nm: ten a nanometre.
const MAX_NODES: usize = 4096;
/// A phase or an optical depth, or a change of an index at an interface, that counts as a feature. What is
/// less enters colours in proportion, so that errors show at all angles and thicknesses alike.
const FEATURE: f64 = 0.1;
/// A path beyond this shows no fringes, nm, so that what changes its phase is not seen.
const FRINGED_NM: f64 = 15e3;
/// An interface's reflectance changes by at most some 2 per unit of an index.
const INTERFACE: f64 = 2.0;

impl FilmDescription {
    /// The wavelengths of the tables of all media between 380 and 780 nm, ascending; none twice.
    ///
    /// # Errors
    /// `OutOfMemory`.
    pub fn nodes_nm(&self) -> Result<Vec<f64>, Error> {
        let count = self.media().map(|medium| medium.nodes_nm().len()).sum();
        let mut nodes = Error::reserve(count, "the wavelengths of tables of measured indices")?;
        nodes.extend(self.media().flat_map(Medium::nodes_nm));
        nodes.sort_unstable_by(f64::total_cmp);
        nodes.dedup();
        Ok(nodes)
    }

    /// Refuses more wavelengths than the reference is quick enough for.
    pub(super) fn check_tables(&self) -> Result<(), Error> {
        let count = self.nodes_nm()?.len();
        if count <= MAX_NODES {
            return Ok(());
        }
        Err(Error::out_of_range(format!(
            "the film's tables have {count} different wavelengths table_nm between 380 and 780 nm, outside [0, \
             {MAX_NODES}]: thin them out"
        )))
    }

    /// How much a channel may be off because `count` equidistant wavenumbers over the visible spectrum are too few for
    /// the features of tables: lines, edges and steps that begin and end between two of them. 0 if there are none.
    ///
    /// It is the part of the channel's light at whose wavelengths the index differs from the straight line between
    /// the wavenumbers on either side by so much that colours change by more than [`FEATURE`].
    ///
    /// # Errors
    /// `OutOfMemory`.
    pub(super) fn unresolved(&self, count: usize) -> Result<f64, Error> {
        let nodes = self.nodes_nm()?;
        if nodes.is_empty() || count == 0 {
            return Ok(0.0);
        }
        let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| 1.0 / nm);
        let step = (last - first) / count as f64;
        let sampled_nm = |k: f64| 1.0 / (first + (k + 0.5) * step);
        // The points between which all that is compared is straight.
        let mut points = Error::reserve(nodes.len() + count, "a film's tables")?;
        points.extend((0..count).map(|k| sampled_nm(k as f64)));
        points.extend(&nodes);
        points.sort_unstable_by(f64::total_cmp);
        let missed = |nm: f64| {
            let position = (1.0 / nm - first) / step - 0.5;
            let below = position.floor().clamp(0.0, count.saturating_sub(2) as f64);
            let part = (position - below).clamp(0.0, 1.0);
            let ends = [below, below + 1.0].map(sampled_nm);
            let by_medium = self.sensitivities(nm).map(|(medium, eta, k)| {
                let [a, b] = ends.map(|nm| medium.index(nm));
                let straight = a + (b - a).scaled(part);
                let difference: Complex<f64> = medium.index(nm) - straight;
                eta * difference.re.abs() + k * difference.im.abs()
            });
            by_medium.sum::<f64>().min(1.0)
        };
        let weights = ChannelWeights::new(self.white, self.color_space);
        let white = whole(&weights);
        let mut sums = [0.0; 3];
        let mut before = (VISIBLE_NM[0], 0.0f64);
        for nm in points {
            let next = (nm, missed(nm));
            if before.1.max(next.1) > FEATURE {
                let part = 0.5 * (before.1 + next.1) * (next.0 - before.0);
                let weights = weights.at(0.5 * (before.0 + next.0));
                for c in 0..3 {
                    sums[c] += part * (weights[c] / white[c]).abs();
                }
            }
            before = next;
        }
        Ok(sums.into_iter().fold(0.0, f64::max))
    }

    /// Ambient, base and layers.
    pub(super) fn media(&self) -> impl Iterator<Item = &Medium> {
        let layers = self.layers.iter().map(|layer| &layer.medium);
        [&self.ambient, &self.base].into_iter().chain(layers)
    }

    /// The media given by tables, and how much colours change per unit of eta and of k at a wavelength, nm.
    fn sensitivities(&self, nm: f64) -> impl Iterator<Item = (&Medium, f64, f64)> {
        let outer = [&self.ambient, &self.base].into_iter();
        let layers = self.layers.iter().map(|l| (&l.medium, l.thickness_nm[1]));
        let all = outer.map(|medium| (medium, 0.0)).chain(layers);
        let tables = all.filter(|(medium, _)| !medium.nodes_nm().is_empty());
        tables.map(move |(medium, thickness_nm)| {
            let [phase, depth] =
                [thickness_nm.min(FRINGED_NM), thickness_nm].map(|path| 4.0 * PI * path / nm);
            (medium, INTERFACE + phase, INTERFACE + depth)
        })
    }
}

/// The integral of each channel over the visible spectrum, by the trapezoid rule at the 5 nm of its data.
fn whole(weights: &ChannelWeights) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for i in 0..=80u8 {
        let width = if i % 80 == 0 { 2.5 } else { 5.0 };
        let at = weights.at(VISIBLE_NM[0] + 5.0 * f64::from(i));
        for c in 0..3 {
            sums[c] += width * at[c];
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line of that half width around 550.3 nm, in which k rises to `k`.
    fn line(half_width: f64, k: f64) -> Medium {
        let nm = [380.0, 550.3 - half_width, 550.3, 550.3 + half_width, 780.0];
        Medium::table(&nm, &[1.5; 5], &[0.0, 0.0, k, 0.0, 0.0]).unwrap()
    }

    fn unresolved(medium: Medium, count: usize) -> f64 {
        FilmDescription::new(medium).unresolved(count).unwrap()
    }

    /// A line counts with its width over a channel's, some 100 nm, until several wavenumbers lie within it.
    #[test]
    fn lines_narrower_than_the_wavenumbers_are_told() {
        for count in [32, 108, 400, 1600] {
            let found = unresolved(line(0.3, 20.0), count);
            assert!((2e-3..2e-2).contains(&found), "{count}: {found}");
            let narrow = unresolved(line(0.1, 20.0), count);
            assert!((5e-4..found).contains(&narrow), "{count}: {narrow}");
        }
        assert!(unresolved(line(0.3, 20.0), 100_000) < 1e-4);
        assert!(unresolved(line(30.0, 2.0), 1600) < 1e-4);
    }

    /// Faint lines are left to comparison, where a thickness does not make them strong.
    #[test]
    fn a_layer_is_the_more_sensitive_the_thicker_it_is() {
        assert_eq!(unresolved(line(0.3, 0.01), 400), 0.0);
        let base = FilmDescription::new(Medium::vacuum());
        let film = |nm| base.clone().layer(line(0.3, 0.01), [0.0, nm]);
        let of = |nm: f64| film(nm).unresolved(400).unwrap();
        assert_eq!(of(10.0), 0.0);
        assert!(of(3000.0) > 1e-3 && of(1e6) > of(3000.0));
    }

    #[test]
    fn what_is_no_line_is_resolved() {
        for name in ["Au", "BK7"] {
            let exact = Medium::named(name).unwrap();
            assert_eq!(unresolved(exact.clone(), 32), 0.0);
            let nm: Vec<f64> = (0..=400u16).map(|i| 380.0 + f64::from(i)).collect();
            let index: Vec<_> = nm.iter().map(|nm| exact.index(*nm)).collect();
            let [eta, k]: [Vec<f64>; 2] = [|i: &Complex<f64>| i.re, |i: &Complex<f64>| i.im]
                .map(|of| index.iter().map(of).collect());
            let sampled = Medium::table(&nm, &eta, &k).unwrap();
            assert_eq!(unresolved(sampled, 108), 0.0, "{name}");
        }
    }
}
