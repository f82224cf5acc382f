//! Elements of strided arrays by component: where they lie, if they lie side by side, else in copies.

use super::view::{ConstView, View};
use crate::bsdf::LANES;
use std::mem::MaybeUninit;

/// The most elements that are worked on at once: their numbers stay in the nearest cache.
pub(super) const CHUNK: usize = 256;

/// Room for the copies of one component. Setting it up costs nothing: a batch of a few elements uses little
/// of it, or none.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct Column<T: Number>(MaybeUninit<[T; CHUNK]>);

/// Numbers of which all bits may be 0.
pub(super) trait Number: Copy {}
impl Number for f32 {}
impl Number for u32 {}

impl<T: Number> Column<T> {
    pub const EMPTY: Self = Self(MaybeUninit::uninit());

    /// The first so many numbers, all 0.
    fn zeros(&mut self, count: usize) -> &mut [T] {
        assert!(count <= CHUNK, "{count} of {CHUNK}");
        let first = self.0.as_mut_ptr().cast::<T>();
        // SAFETY: there are so many, and 0 is a number.
        unsafe {
            first.write_bytes(0, count);
            std::slice::from_raw_parts_mut(first, count)
        }
    }

    /// The first so many numbers.
    ///
    /// # Safety
    /// They must have been written since [`Column::EMPTY`].
    unsafe fn numbers(&self, count: usize) -> &[T] {
        // SAFETY: the caller vouches for it.
        unsafe { std::slice::from_raw_parts(self.0.as_ptr().cast::<T>(), count) }
    }
}

/// Elements of a batch: `count` of them from `first` on, and whether views may be used where they lie.
#[derive(Clone, Copy)]
pub(super) struct Chunk {
    pub first: usize,
    pub count: usize,
    is_direct: bool,
}

impl Chunk {
    /// The chunks of a batch. With `is_direct` all but the last are whole lanes, so that nothing is read or
    /// written beyond the end.
    pub fn all(count: usize, is_direct: bool) -> impl Iterator<Item = Self> {
        let mut first = 0;
        std::iter::from_fn(move || {
            let left = count - first;
            let whole = left - left % LANES;
            let count = if is_direct && whole > 0 {
                whole.min(CHUNK)
            } else {
                left.min(CHUNK)
            };
            let chunk = Self {
                first,
                count,
                is_direct: is_direct && count % LANES == 0,
            };
            first += count;
            (count > 0).then_some(chunk)
        })
    }

    /// How many numbers slices have: those that are too many are 0.
    fn padded(&self) -> usize {
        self.count.next_multiple_of(LANES)
    }

    /// The components of a view's elements.
    ///
    /// # Safety
    /// All must be readable, and nothing may write to them while the slices live if [`is_apart`] said that
    /// the chunks are direct.
    pub unsafe fn read<'a, const N: usize>(
        &self,
        view: &ConstView,
        room: &'a mut [Column<f32>; N],
    ) -> [&'a [f32]; N] {
        // SAFETY: side by side and aligned; the caller vouches for the rest.
        unsafe {
            if self.is_direct && view.is_contiguous(N) {
                return std::array::from_fn(|c| {
                    std::slice::from_raw_parts(view.address(self.first, c), self.count)
                });
            }
            let mut numbers = room.each_mut().map(|column| column.zeros(self.padded()));
            view.load(self.first, self.count, &mut numbers);
            numbers.map(|numbers| &*numbers)
        }
    }

    /// Slices to write a view's elements to; [`Chunk::write`] brings them there.
    ///
    /// # Safety
    /// All must be writable, and apart from all else if [`is_apart`] said so.
    pub unsafe fn target<'a, T: Number, const N: usize>(
        &self,
        view: &View<T>,
        room: &'a mut [Column<T>; N],
    ) -> [&'a mut [T]; N] {
        if self.is_direct && view.is_contiguous(N) {
            // SAFETY: side by side and aligned; the caller vouches for the rest.
            return std::array::from_fn(|c| unsafe {
                std::slice::from_raw_parts_mut(view.address(self.first, c), self.count)
            });
        }
        room.each_mut().map(|column| column.zeros(self.padded()))
    }

    /// Writes what [`Chunk::target`] had to copy.
    ///
    /// # Safety
    /// All must be writable, and [`Chunk::target`] must have been called.
    pub unsafe fn write<T: Number, const N: usize>(&self, view: &View<T>, room: &[Column<T>; N]) {
        if view.data.is_null() || self.is_direct && view.is_contiguous(N) {
            return;
        }
        // SAFETY: the caller vouches for it; the target was set to 0.
        unsafe {
            view.store(
                self.first,
                room.each_ref().map(|column| column.numbers(self.count)),
            )
        }
    }
}

/// First and last address.
pub(super) type Span = Option<[usize; 2]>;

/// Whether no output that could be written where it lies touches any other view.
pub(super) fn is_apart(inputs: &[Span], outputs: &[(Span, bool)]) -> bool {
    let touch = |a: &Span, b: &Span| match (a, b) {
        (Some([a, b]), Some([c, d])) => a <= d && c <= b,
        _ => false,
    };
    outputs.iter().enumerate().all(|(i, (own, is_contiguous))| {
        let others = outputs.iter().enumerate().filter(|(j, _)| *j != i);
        let mut all = inputs.iter().chain(others.map(|(_, (span, _))| span));
        !is_contiguous || !all.any(|other| touch(own, other))
    })
}
