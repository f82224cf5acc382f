//! Look-ups in lanes against the plain definition, one lane at a time.

use super::super::{Level, Work};
use super::*;
use std::panic::catch_unwind;

const STRIDE: usize = 7;

/// Colours without a pattern, exact in single precision.
fn colors() -> Vec<[f32; 3]> {
    let number = |i: usize| (i * 2_654_435_761 % 10_007) as f32 / 8192.0 - 0.5;
    (0..STRIDE * 5)
        .map(|i| [number(3 * i), number(3 * i + 1), number(3 * i + 2)])
        .collect()
}

fn table() -> Vec<TableEntry<f32>> {
    colors().into_iter().map(TableEntry::new).collect()
}

/// Sixteen look-ups by all methods, in the lanes of a level.
struct Sixteen<'a> {
    table: &'a [TableEntry<f32>],
    fours: &'a [[f32; 4]],
    threes: &'a [[f32; 3]],
    /// Column, row and index for the plain entries.
    first: [[f32; MAX_LANES]; 3],
    weights: [[f32; MAX_LANES]; 6],
}

/// The numbers found, by method and lane: sums of a row, sums of a block, and entries of four and three
/// numbers.
type Found = [[f32; MAX_LANES]; 13];

impl Work<f32> for Sixteen<'_> {
    type Output = Found;

    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) -> Found {
        let mut found = [[0.0; MAX_LANES]; 13];
        for from in (0..MAX_LANES).step_by(L::COUNT) {
            let places = from..from + L::COUNT;
            let load = |numbers: &[f32; MAX_LANES]| L::load(&numbers[places.clone()]);
            let [column, row, index] = self.first.each_ref().map(load);
            let [column, row] = [column, row].map(|number| number + L::new(INDEX_BIAS));
            let [a, b, c, d, e, f] = self.weights.each_ref().map(load);
            let block = TableBlock {
                first: [column, row],
                across: [a, b, c],
                along: [d, e, f],
            };
            let along_row = L::channels(L::weighted_row(self.table, column, [a, b, c]));
            let in_block = L::channels(L::weighted_block(self.table, STRIDE, block));
            let four = L::load_entry(self.fours, index);
            let three = L::load_entry(self.threes, index);
            let all = along_row
                .into_iter()
                .chain(in_block)
                .chain(four)
                .chain(three);
            for (found, numbers) in found.iter_mut().zip(all) {
                numbers.store(&mut found[places.clone()]);
            }
        }
        found
    }
}

/// Every lane finds what the plain definition finds, at all levels. Indices of plain entries are
/// clamped to the table; NaN finds the first entry.
#[test]
fn places_are_independent() {
    let (colors, table) = (colors(), table());
    let fours: Vec<[f32; 4]> = (0..5)
        .map(|i| [0, 1, 2, 3].map(|c| (10 * i + c) as f32))
        .collect();
    let threes: Vec<[f32; 3]> = (0..5)
        .map(|i| [5, 6, 7].map(|c| (10 * i + c) as f32))
        .collect();
    let numbers = [
        0.0,
        4.0,
        3.0,
        f32::NAN,
        -3.0,
        1e9,
        f32::INFINITY,
        f32::NEG_INFINITY,
    ];
    let entry = [0, 4, 3, 0, 0, 4, 4, 0];
    let first = [
        std::array::from_fn(|i| (i * 3 % (STRIDE - 2)) as f32),
        std::array::from_fn(|i| (i * 2 % 3) as f32),
        std::array::from_fn(|i| numbers[i % 8]),
    ];
    let weights: [[f32; MAX_LANES]; 6] =
        [0, 1, 2, 3, 4, 5].map(|w| std::array::from_fn(|i| ((i * 7 + w * 5) % 23) as f32 / 19.0));
    for level in Level::all() {
        let found = level.run(Sixteen {
            table: &table,
            fours: &fours,
            threes: &threes,
            first,
            weights,
        });
        for i in 0..MAX_LANES {
            let name = level.name();
            let [column, row] = [first[0][i] as usize, first[1][i] as usize];
            let sum = |from: usize, c: usize| {
                colors[from][c] * weights[0][i]
                    + colors[from + 1][c] * weights[1][i]
                    + colors[from + 2][c] * weights[2][i]
            };
            for c in 0..3 {
                assert_eq!(found[c][i], sum(column, c), "row, {name}, place {i}");
                let rows = [0, 1, 2].map(|k| sum((row + k) * STRIDE + column, c));
                let all =
                    rows[0] * weights[3][i] + rows[1] * weights[4][i] + rows[2] * weights[5][i];
                assert_eq!(found[3 + c][i], all, "block, {name}, place {i}");
                assert_eq!(
                    found[10 + c][i],
                    threes[entry[i % 8]][c],
                    "three, {name}, place {i}"
                );
            }
            for c in 0..4 {
                assert_eq!(
                    found[6 + c][i],
                    fours[entry[i % 8]][c],
                    "four, {name}, place {i}"
                );
            }
        }
    }
}

/// An entry outside the table is never read, in any lane.
#[test]
fn outside_panics() {
    let table = table();
    for level in Level::all() {
        for place in 0..MAX_LANES {
            // The third column from the end of the last row, and the column after it.
            for (column, is_inside) in [(STRIDE - 3, true), (STRIDE - 2, false)] {
                let mut first = [[0.0; MAX_LANES]; 3];
                first[0][place] = column as f32;
                first[1][place] = 2.0;
                let work = Sixteen {
                    table: &table,
                    fours: &[[0.0; 4]],
                    threes: &[[0.0; 3]],
                    first,
                    weights: [[0.5; MAX_LANES]; 6],
                };
                let outcome = catch_unwind(|| level.run(work));
                assert_eq!(
                    outcome.is_ok(),
                    is_inside,
                    "{}, place {place}",
                    level.name()
                );
            }
        }
    }
}
