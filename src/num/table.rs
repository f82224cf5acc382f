//! Tables of colours: their entries, and weighted sums of entries.

use super::Real;
use super::rgb::Triple;

/// Three channels and a filler, aligned so that one load fills a register. The filler repeats the last
/// channel.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(16))]
pub struct TableEntry<T>([T; 4]);

impl<T: Copy> TableEntry<T> {
    /// The entry of a colour.
    #[inline(always)]
    pub fn new([r, g, b]: [T; 3]) -> Self {
        Self([r, g, b, b])
    }

    /// The colour.
    #[inline(always)]
    pub(crate) fn channels(&self) -> [T; 3] {
        let [r, g, b, _] = self.0;
        [r, g, b]
    }

    /// The entry with another type of number.
    pub fn cast<U: Copy>(&self, to: impl Fn(T) -> U) -> TableEntry<U> {
        let [r, g, b, _] = self.0;
        TableEntry::new([to(r), to(g), to(b)])
    }
}

/// A block of 3 x 3 entries of a table, and the weights of its rows and columns.
#[derive(Clone, Copy, Debug)]
pub struct TableBlock<T> {
    /// Column and row of the first entry, whole numbers in [0, 2^22], each plus `INDEX_BIAS`.
    pub first: [T; 2],
    /// Weights of the three columns.
    pub across: [T; 3],
    /// Weights of the three rows.
    pub along: [T; 3],
}

/// 2^23. Adding it to a number in [0, 2^22] rounds the number to a whole one, whose integer is then in the
/// lowest bits of the sum: rounding a position also gives its index.
pub(crate) const INDEX_BIAS: f64 = 8_388_608.0;

/// The whole number in [0, 2^22] that [`INDEX_BIAS`] was added to; unspecified for other arguments.
#[inline(always)]
pub(super) fn unbiased(biased: f32) -> usize {
    (biased.to_bits() & 0x007f_ffff) as usize
}

/// The weighted sum of three colours.
#[inline(always)]
pub(super) fn weighted<C: Real>([a, b, c]: [C; 3], [u, v, w]: [C; 3]) -> C {
    a * u + b * v + c * w
}

/// Loads three entries from each of three rows of a table. The first entry is at `from`, and rows are
/// `stride` entries apart. `rgb_lanes.rs` has its own for single precision on x86-64
/// and 64-bit ARM.
///
/// # Panics
/// If an entry is outside the table.
#[inline(always)]
pub(super) fn load_block<T: Copy>(
    table: &[TableEntry<T>],
    from: usize,
    stride: usize,
) -> [[Triple<T>; 3]; 3] {
    std::array::from_fn(|row| {
        std::array::from_fn(|entry| {
            let [r, g, b, _] = table[from + row * stride + entry].0;
            Triple([r, g, b])
        })
    })
}
