//! Table look-ups in lanes: entries, and weighted sums of entries.
//!
//! Each lane forms the same products as a single look-up and adds them in the same order, so that the bits
//! are the same.

#![allow(unsafe_code)]

use super::super::lane::triple_methods;
use super::super::rgb::{Triple, each};
use super::super::table::{INDEX_BIAS, TableBlock, TableEntry, unbiased, weighted};
use super::super::{Lane, Real};
use super::f32_lanes::F32Lanes;
use super::instructions::{Instructions, MAX_LANES};
use fearless_simd::prelude::*;

/// The table entry of each lane, one register for each of its four numbers.
type Numbers<S> = [F32Lanes<S>; 4];

/// [`unbiased`] of each lane.
#[inline(always)]
fn unbiased_lanes<S: Instructions>(biased: F32Lanes<S>) -> S::u32s {
    let bits: S::u32s = biased.0.bitcast();
    bits & 0x007f_ffff
}

/// The indices as an array, after a check that at least `after` entries follow each of them in a table of
/// `length` entries.
///
/// # Panics
/// If fewer entries follow an index.
#[inline(always)]
fn within<S: Instructions>(index: S::u32s, after: usize, length: usize) -> [u32; MAX_LANES] {
    let Some(last) = length.checked_sub(after + 1) else {
        outside()
    };
    let last = u32::try_from(last).unwrap_or(u32::MAX);
    if index.simd_gt(last).any_true() {
        outside();
    }
    let mut indices = [0; MAX_LANES];
    index.store_slice(&mut indices[..S::u32s::LEN]);
    indices
}

/// It takes no arguments, because callers would prepare them in the fast path too.
#[cold]
#[inline(never)]
fn outside() -> ! {
    panic!("entries outside a table")
}

impl<S: Instructions> Lane for F32Lanes<S> {
    type Rgb = Triple<Self>;
    type Scalar = f32;
    const COUNT: usize = S::f32s::LEN;

    #[inline(always)]
    fn splat(number: f32) -> Self {
        Self(S::f32s::simd_from(S::TOKEN, number))
    }
    #[inline(always)]
    fn outlined<R>(work: impl FnOnce() -> R) -> R {
        S::TOKEN.vectorize(work)
    }
    #[inline(always)]
    fn load(numbers: &[f32]) -> Self {
        Self(S::f32s::from_slice(S::TOKEN, numbers))
    }
    #[inline(always)]
    fn store(self, numbers: &mut [f32]) {
        self.0.store_slice(numbers);
    }
    #[inline(always)]
    unsafe fn write(self, target: *mut f32) {
        let numbers = self.0.as_slice();
        // SAFETY: the caller vouches for the target.
        unsafe { target.copy_from_nonoverlapping(numbers.as_ptr(), numbers.len()) };
    }
    triple_methods!();

    #[inline(always)]
    fn load_entry<const N: usize>(table: &[[f32; N]], index: Self) -> [Self; N] {
        let last = Self::new((table.len() - 1) as f64);
        let index = index.max(Self::new(0.0)).min(last);
        let mut found = [index; N];
        if let Some(table) = fours(table) {
            for (number, of_entry) in found.iter_mut().zip(entries(table, index)) {
                *number = of_entry;
            }
            return found;
        }
        let mut numbers = [[0.0; MAX_LANES]; N];
        for (place, index) in index.0.as_slice().iter().enumerate() {
            for (numbers, number) in numbers
                .iter_mut()
                .zip(table[unbiased(*index + INDEX_BIAS as f32)])
            {
                numbers[place] = number;
            }
        }
        for (number, numbers) in found.iter_mut().zip(&numbers) {
            *number = Self::load(&numbers[..Self::COUNT]);
        }
        found
    }
    #[inline(always)]
    fn weighted_row(table: &[TableEntry<f32>], first: Self, weights: [Self; 3]) -> Triple<Self> {
        weighted_row(table, first, weights)
    }
    #[inline(always)]
    fn weighted_block(
        table: &[TableEntry<f32>],
        stride: usize,
        block: TableBlock<Self>,
    ) -> Triple<Self> {
        weighted_block(table, stride, block)
    }
}

/// The same table, if its entries have four numbers.
#[inline(always)]
fn fours<const N: usize>(table: &[[f32; N]]) -> Option<&[[f32; 4]]> {
    let (entries, rest) = table.as_flattened().as_chunks();
    (N == 4 && rest.is_empty()).then_some(entries)
}

/// [`Lane::weighted_row`](super::super::Lane::weighted_row)
#[inline(always)]
pub(super) fn weighted_row<S: Instructions>(
    table: &[TableEntry<f32>],
    first: F32Lanes<S>,
    weights: [F32Lanes<S>; 3],
) -> Triple<F32Lanes<S>> {
    let index = within::<S>(unbiased_lanes(first), 2, table.len());
    let weights = each!(weights, |weight| S::TOKEN.spread(weight.0));
    let start = table.as_ptr().cast();
    // SAFETY: `within` has found them all in the table.
    let sums = unsafe {
        [
            row_sum::<S>(start, &index, 0, &weights),
            row_sum::<S>(start, &index, 1, &weights),
            row_sum::<S>(start, &index, 2, &weights),
            row_sum::<S>(start, &index, 3, &weights),
        ]
    };
    let [r, g, b, _] = transposed(sums);
    Triple([r, g, b])
}

/// [`Lane::weighted_block`](super::super::Lane::weighted_block)
#[inline(always)]
pub(super) fn weighted_block<S: Instructions>(
    table: &[TableEntry<f32>],
    stride: usize,
    block: TableBlock<F32Lanes<S>>,
) -> Triple<F32Lanes<S>> {
    // No sum below overflows if the stride is less than the length, because a slice has at most isize::MAX
    // bytes.
    if stride >= table.len() {
        outside();
    }
    let [column, row] = [
        unbiased_lanes(block.first[0]),
        unbiased_lanes(block.first[1]),
    ];
    // A product that wraps gives another index, which `within` checks too.
    let index = within::<S>(row * stride as u32 + column, 2 * stride + 2, table.len());
    let across = each!(block.across, |weight| S::TOKEN.spread(weight.0));
    let along = each!(block.along, |weight| S::TOKEN.spread(weight.0));
    let start = table.as_ptr().cast();
    // SAFETY: `within` has found them all in the table.
    let sums = unsafe {
        [
            block_sum::<S>(start, stride, &index, 0, &across, &along),
            block_sum::<S>(start, stride, &index, 1, &across, &along),
            block_sum::<S>(start, stride, &index, 2, &across, &along),
            block_sum::<S>(start, stride, &index, 3, &across, &along),
        ]
    };
    let [r, g, b, _] = transposed(sums);
    Triple([r, g, b])
}

/// The weighted sum of three entries, for lanes n of all quads.
///
/// # Safety
/// For each index the entry and the two after it must be in the table that begins at `start`.
#[inline(always)]
unsafe fn row_sum<S: Instructions>(
    start: *const [f32; 4],
    index: &[u32; MAX_LANES],
    n: usize,
    weights: &[[S::f32s; 4]; 3],
) -> F32Lanes<S> {
    // SAFETY: the caller's promise.
    let entries = unsafe { S::TOKEN.three(start, index, n) };
    weighted(
        each!(entries, |entry| F32Lanes::<S>(entry)),
        each!(weights, |weight| F32Lanes::<S>(weight[n])),
    )
}

/// The weighted sum of [`row_sum`] over three rows.
///
/// # Safety
/// All entries must be in the table that begins at `start`.
#[inline(always)]
unsafe fn block_sum<S: Instructions>(
    start: *const [f32; 4],
    stride: usize,
    index: &[u32; MAX_LANES],
    n: usize,
    across: &[[S::f32s; 4]; 3],
    along: &[[S::f32s; 4]; 3],
) -> F32Lanes<S> {
    // SAFETY: the caller's promise.
    let rows = unsafe {
        [
            row_sum::<S>(start, index, n, across),
            row_sum::<S>(start.add(stride), index, n, across),
            row_sum::<S>(start.add(2 * stride), index, n, across),
        ]
    };
    weighted(rows, each!(along, |weight| F32Lanes::<S>(weight[n])))
}

/// The four numbers of each lane's entry.
#[inline(always)]
pub(super) fn entries<S: Instructions>(table: &[[f32; 4]], index: F32Lanes<S>) -> Numbers<S> {
    let index = within::<S>(
        unbiased_lanes(index + F32Lanes::new(INDEX_BIAS)),
        0,
        table.len(),
    );
    let start = table.as_ptr();
    // SAFETY: `within` has found them all in the table.
    let found = unsafe {
        [
            F32Lanes::<S>(S::TOKEN.entries(start, &index, 0)),
            F32Lanes::<S>(S::TOKEN.entries(start, &index, 1)),
            F32Lanes::<S>(S::TOKEN.entries(start, &index, 2)),
            F32Lanes::<S>(S::TOKEN.entries(start, &index, 3)),
        ]
    };
    transposed(found)
}

#[inline(always)]
fn transposed<S: Instructions>([a, b, c, d]: Numbers<S>) -> Numbers<S> {
    let [a, b, c, d] = S::TOKEN.transposed([a.0, b.0, c.0, d.0]);
    [F32Lanes(a), F32Lanes(b), F32Lanes(c), F32Lanes(d)]
}

#[cfg(test)]
mod tests;
