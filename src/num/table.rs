//! Tables of colours: their entries, and the weighted sums that a look-up needs.

use super::Real;
use super::rgb::Triple;

/// Three channels and a filler, which must equal one of them: placed as registers take them.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(16))]
pub struct TableEntry<T>([T; 4]);

impl<T: Copy> TableEntry<T> {
    /// The filler is the last channel.
    #[inline(always)]
    pub fn new([r, g, b]: [T; 3]) -> Self {
        Self([r, g, b, b])
    }
}

/// Which entries of a table, and their weights.
#[derive(Clone, Copy, Debug)]
pub struct TableBlock<T> {
    /// Column and row of the first, whole numbers in [0, 2^22], plus [`INDEX_BIAS`].
    pub first: [T; 2],
    /// Weights of the columns.
    pub across: [T; 3],
    /// Weights of the rows.
    pub along: [T; 3],
}

/// 2^23. Adding it to a number in [0, 2^22] rounds that to a whole number, which is then in the lowest
/// bits: who rounds a position so has its index without another operation.
pub(crate) const INDEX_BIAS: f64 = 8_388_608.0;

/// The whole number in [0, 2^22] that [`INDEX_BIAS`] was added to; undefined for other arguments.
#[inline(always)]
pub(super) fn unbiased(biased: f32) -> usize {
    (biased.to_bits() & 0x007f_ffff) as usize
}

/// The sum of three, each times its weight.
#[inline(always)]
pub(super) fn weighted<C: Real>([a, b, c]: [C; 3], [u, v, w]: [C; 3]) -> C {
    a * u + b * v + c * w
}

/// Three entries from each of three rows of a table, the first at `from`, the rows `stride` entries
/// apart. For single precision on x86-64 there is another.
///
/// # Panics
/// If they are not all in the table.
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
