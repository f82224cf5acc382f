//! Chunks of a batch: elements of strided arrays as columns of numbers, in place or copied.

use super::view::{ConstView, View};
use crate::num::{ColumnMut, Columns, ColumnsMut, Level};
use std::mem::MaybeUninit;

/// The greatest number of elements of a chunk. Their numbers fit in the first-level cache.
pub(super) const CHUNK: usize = 256;
/// That of a batch of samples. They have twice as many columns, and callers may have small stacks.
pub(super) const SAMPLE_CHUNK: usize = 128;
/// The lengths of columns are multiples of this number, which the number of lanes of every level divides.
pub(super) const LANES: usize = 16;
/// Batches with fewer elements are evaluated one by one, because filling lanes would take longer.
const FEWEST_FOR_LANES: usize = 8;

/// A buffer for the copy of one component of at most N elements. It is not initialised before it is used.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct Column<T: Copy, const N: usize>(pub(super) [MaybeUninit<T>; N]);

impl<T: Copy + Default, const N: usize> Column<T, N> {
    pub const EMPTY: Self = Self([MaybeUninit::uninit(); N]);

    /// The first `count` numbers, all 0.
    fn zeros(&mut self, count: usize) -> &mut [T] {
        zeros(&mut self.0, count)
    }

    /// The first `count` numbers.
    ///
    /// # Safety
    /// They must have been written since [`Column::EMPTY`].
    unsafe fn numbers(&self, count: usize) -> &[T] {
        // SAFETY: the caller vouches for it.
        unsafe { std::slice::from_raw_parts(self.0.as_ptr().cast::<T>(), count) }
    }
}

/// The first `count` numbers of a buffer, all 0.
fn zeros<T: Copy + Default>(room: &mut [MaybeUninit<T>], count: usize) -> &mut [T] {
    let room = &mut room[..count];
    room.fill(MaybeUninit::new(T::default()));
    // SAFETY: these numbers have just been written.
    unsafe { std::slice::from_raw_parts_mut(room.as_mut_ptr().cast(), count) }
}

/// The `count` elements of a batch that begin at element `first`.
#[derive(Clone, Copy)]
pub(super) struct Chunk {
    pub first: usize,
    pub count: usize,
    /// Whether contiguous views may be used in place.
    is_direct: bool,
    lanes: usize,
}

/// The chunks of a batch.
pub(super) struct Chunks {
    count: usize,
    /// The greatest number of elements of a chunk.
    longest: usize,
    is_direct: bool,
    lanes: usize,
    /// The level at which the chunks are evaluated.
    pub level: Level,
}

impl Chunks {
    /// `longest` is the greatest number of elements of a chunk, a multiple of [`LANES`]. `is_direct` tells that
    /// contiguous views may be used in place. Then all chunks but the last have
    /// whole lanes, so that nothing is read or written beyond the end of a view.
    pub fn new(count: usize, longest: usize, is_direct: bool, level: Level) -> Self {
        let is_short = count < FEWEST_FOR_LANES;
        Self {
            count,
            longest,
            is_direct,
            lanes: if is_short { 1 } else { LANES },
            level: if is_short { Level::SCALAR } else { level },
        }
    }

    pub fn iter(&self) -> impl Iterator<Item = Chunk> {
        let Self {
            count: all,
            longest,
            is_direct,
            lanes,
            ..
        } = *self;
        let mut first = 0;
        std::iter::from_fn(move || {
            let left = all - first;
            let whole = left - left % lanes;
            let count = if is_direct && whole > 0 {
                whole.min(longest)
            } else {
                left.min(longest)
            };
            let chunk = Chunk {
                first,
                count,
                is_direct: is_direct && count % lanes == 0,
                lanes,
            };
            first += count;
            (count > 0).then_some(chunk)
        })
    }
}

impl Chunk {
    /// The length of the columns of copies: `count` rounded up to whole lanes. The numbers beyond `count`
    /// are 0.
    pub fn padded(&self) -> usize {
        self.count.next_multiple_of(self.lanes)
    }

    fn is_in_place<T: Copy>(&self, view: &View<T>, components: usize) -> bool {
        self.is_direct && view.is_contiguous(components)
    }

    /// Columns of the three components of a view's elements.
    ///
    /// # Safety
    /// All elements must be readable. If the chunks are direct, nothing may write to them during the
    /// lifetime of the columns.
    pub unsafe fn columns<'a, const N: usize>(
        &self,
        view: &ConstView,
        room: &'a mut [Column<f32, N>; 3],
    ) -> Columns<'a, f32> {
        // SAFETY: the view is contiguous and aligned, or its elements are copied; the caller vouches for the rest.
        unsafe {
            if self.is_in_place(&view.as_view(), 3) {
                return Columns::new(
                    view.address(self.first, 0),
                    view.column_stride(),
                    self.count,
                );
            }
            let mut numbers = room.each_mut().map(|column| column.zeros(self.padded()));
            view.load(self.first, self.count, &mut numbers);
            Columns::new(room.as_ptr().cast(), N as isize, self.padded())
        }
    }

    /// Columns that receive the three components of a view's elements. [`Chunk::write`] copies them to the
    /// view.
    ///
    /// # Safety
    /// All elements must be writable. If the chunks are direct, nothing else may use them during the
    /// lifetime of the columns.
    pub unsafe fn columns_mut<'a, const N: usize>(
        &self,
        view: &View,
        room: &'a mut [Column<f32, N>; 3],
    ) -> ColumnsMut<'a, f32> {
        // SAFETY: the view is contiguous and aligned, or its elements are copied; the caller vouches for the rest.
        unsafe {
            if self.is_in_place(view, 3) {
                let start = view.address(self.first, 0);
                return ColumnsMut::new(start, view.column_stride(), self.count);
            }
            for column in room.iter_mut() {
                column.zeros(self.padded());
            }
            ColumnsMut::new(room.as_mut_ptr().cast(), N as isize, self.padded())
        }
    }

    /// The numbers of a view's first component.
    ///
    /// # Safety
    /// As for [`Chunk::columns`].
    pub unsafe fn read<'a>(&self, view: &ConstView, room: &'a mut [MaybeUninit<f32>]) -> &'a [f32] {
        // SAFETY: as in `columns`.
        unsafe {
            if self.is_in_place(&view.as_view(), 1) {
                return std::slice::from_raw_parts(view.address(self.first, 0), self.count);
            }
            let numbers = zeros(room, self.padded());
            view.load(self.first, self.count, &mut [&mut *numbers]);
            numbers
        }
    }

    /// A column that receives the numbers of a view with one component. [`Chunk::write`] copies it to the
    /// view.
    ///
    /// # Safety
    /// As for [`Chunk::columns_mut`].
    pub unsafe fn column_mut<'a, T: Copy + Default, const N: usize>(
        &self,
        view: &View<T>,
        room: &'a mut [Column<T, N>; 1],
    ) -> ColumnMut<'a, T> {
        if self.is_in_place(view, 1) {
            // SAFETY: the view is contiguous and aligned; the caller vouches for the rest.
            return unsafe { ColumnMut::new(view.address(self.first, 0), self.count) };
        }
        ColumnMut::of_slice(room[0].zeros(self.padded()))
    }

    /// A column in the buffer, never in place, so that it can be read afterwards.
    pub fn scratch<'a, const N: usize>(
        &self,
        room: &'a mut [Column<f32, N>; 1],
    ) -> ColumnMut<'a, f32> {
        ColumnMut::of_slice(room[0].zeros(self.padded()))
    }

    /// The numbers of a buffer that [`Chunk::scratch`] prepared.
    ///
    /// # Safety
    /// [`Chunk::scratch`] must have prepared the buffer for this chunk.
    pub unsafe fn numbers<'a, const N: usize>(&self, room: &'a [Column<f32, N>; 1]) -> &'a [f32] {
        // SAFETY: the caller vouches for it.
        unsafe { room[0].numbers(self.count) }
    }

    /// Copies the results to the view, unless they were written in place.
    ///
    /// # Safety
    /// All elements must be writable, and [`Chunk::columns_mut`] or [`Chunk::column_mut`] must have
    /// prepared the buffers.
    pub unsafe fn write<T: Copy + Default, const N: usize, const C: usize>(
        &self,
        view: &View<T>,
        room: &[Column<T, N>; C],
    ) {
        if !self.is_in_place(view, C) {
            // SAFETY: the caller's promise.
            unsafe { self.copy_out(view, room) };
        }
    }

    /// Copies the buffers to the view, if it is wanted.
    ///
    /// # Safety
    /// As for [`Chunk::write`].
    pub unsafe fn copy_out<T: Copy + Default, const N: usize, const C: usize>(
        &self,
        view: &View<T>,
        room: &[Column<T, N>; C],
    ) {
        if view.data.is_null() {
            return;
        }
        // SAFETY: the caller vouches for the view; the buffers were initialised with 0.
        unsafe {
            view.store(
                self.first,
                room.each_ref().map(|column| column.numbers(self.count)),
            )
        }
    }
}
