//! Colours of a table at many thicknesses and one cosine.

use super::critical_axis::Cosine;
use super::film_table::FilmTable;
use super::lane_table::Line;
use crate::film::spread::average::AT_ONCE;
use crate::num::{Lane, Level, Rgb, Work};

/// The greatest number of thicknesses at once, a multiple of every number of lanes.
pub(super) const MOST: usize = AT_ONCE;
/// Fewer thicknesses than this are looked up one after another: lanes would be empty.
const FEW: usize = 10;

/// The colours at up to [`MOST`] thicknesses within the range of a table, nm: the bits of [`FilmTable::at`], whatever
/// instructions the processor has.
pub(super) fn colors(
    table: &FilmTable,
    cosine: Cosine<f32>,
    thickness_nm: &[f32],
    found: &mut [Rgb<f32>; MOST],
) {
    let level = Level::widest();
    let lanes = table.in_lanes().filter(|_| !level.is_scalar());
    match (lanes, thickness_nm.last()) {
        (Some(table), Some(last)) if thickness_nm.len() >= FEW => {
            let mut filled = [*last; MOST];
            filled[..thickness_nm.len()].copy_from_slice(thickness_nm);
            level.run(NodeLookUp {
                line: table.line(cosine),
                thickness_nm: &filled,
                count: thickness_nm.len(),
                found,
            });
        }
        _ => {
            for (found, d) in found.iter_mut().zip(thickness_nm) {
                *found = table.at(cosine, *d);
            }
        }
    }
}

struct NodeLookUp<'a> {
    line: Line<'a>,
    thickness_nm: &'a [f32; MOST],
    count: usize,
    found: &'a mut [Rgb<f32>; MOST],
}

impl Work<f32> for NodeLookUp<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) {
        let thicknesses = self.thickness_nm.chunks_exact(L::COUNT);
        let found = self.found.chunks_exact_mut(L::COUNT);
        let chunks = self.count.div_ceil(L::COUNT);
        let mut channels = [[0.0; 16]; 3];
        for (d, found) in thicknesses.zip(found).take(chunks) {
            let rgb = L::channels(self.line.at(L::load(d)));
            for c in 0..3 {
                rgb[c].store(&mut channels[c][..L::COUNT]);
            }
            for (lane, found) in found.iter_mut().enumerate() {
                *found = [channels[0][lane], channels[1][lane], channels[2][lane]];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Film;
    use crate::film::description::FilmDescription;
    use crate::film::evaluator::Evaluator;
    use crate::optics::Medium;

    /// Against lanes that differ from single look-ups: on a plain table and on one over critical angles, for numbers of
    /// nodes that fill no register.
    #[test]
    fn nodes_are_single_look_ups() {
        let medium = |name: &str| Medium::named(name).unwrap();
        let glass = FilmDescription::new(medium("BK7"));
        let bubble = FilmDescription::new(Medium::vacuum());
        let from_glass = FilmDescription {
            ambient: medium("BK7"),
            ..FilmDescription::new(Medium::vacuum())
        };
        for (description, is_warped) in [(glass, false), (bubble, false), (from_glass, true)] {
            let film = Film::new(&description.layer(medium("MgF2"), [20.0, 400.0])).unwrap();
            let Evaluator::Tables(tables) = &film.evaluator else {
                panic!("it has no table");
            };
            let table: &FilmTable = tables.front().base();
            assert_eq!(table.over_cosine().is_none(), is_warped);
            for i in 0..200u8 {
                let cosine = Cosine::from(f32::from(i) / 199.0);
                let count = 1 + usize::from(i) % MOST;
                let d: Vec<f32> = (0..count)
                    .map(|j| 20.0 + 380.0 * (j as f32 * 0.618_034).fract())
                    .collect();
                let mut found = [[-1.0; 3]; MOST];
                colors(table, cosine, &d, &mut found);
                for (found, d) in found.iter().zip(&d) {
                    let single = table.at(cosine, *d);
                    assert_eq!(found.map(f32::to_bits), single.map(f32::to_bits));
                }
            }
        }
    }
}
