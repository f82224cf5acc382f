//! Vectors of many elements, one column of numbers for each component.

#![allow(unsafe_code)]

use super::Lane;
use std::marker::PhantomData;

/// Vectors to read, as three columns: component c of element i stands `c * stride + i` numbers after the
/// start.
///
/// A single vector is three columns of one element, so that single calls and batches read it by the same
/// code.
#[derive(Clone, Copy, Debug)]
pub struct Columns<'a, T> {
    start: *const T,
    stride: isize,
    count: usize,
    lifetime: PhantomData<&'a [T]>,
}

/// Vectors to write, laid out as those of [`Columns`].
#[derive(Debug)]
pub struct ColumnsMut<'a, T> {
    start: *mut T,
    stride: isize,
    count: usize,
    lifetime: PhantomData<&'a mut [T]>,
}

impl<'a, T> Columns<'a, T> {
    /// Columns of one element.
    #[inline(always)]
    pub fn of_one(vector: &'a [T; 3]) -> Self {
        Self {
            start: vector.as_ptr(),
            stride: 1,
            count: 1,
            lifetime: PhantomData,
        }
    }

    /// Columns of `count` elements, with the start aligned and the stride counted in numbers.
    ///
    /// # Safety
    /// All `3 * count` numbers must be readable and stay unchanged during the lifetime.
    pub unsafe fn new(start: *const T, stride: isize, count: usize) -> Self {
        Self {
            start,
            stride,
            count,
            lifetime: PhantomData,
        }
    }

    /// The number of elements.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Loads the vectors of the `L::COUNT` elements that begin at element `from`.
    ///
    /// # Panics
    /// If the columns end before that.
    #[inline(always)]
    pub fn load<L: Lane<Scalar = T>>(&self, from: usize) -> [L; 3] {
        check(from, L::COUNT, self.count);
        // SAFETY: the elements are within the columns, which the caller of the constructor vouched for.
        let column = |c: isize| unsafe {
            std::slice::from_raw_parts(self.start.offset(c * self.stride).add(from), L::COUNT)
        };
        [L::load(column(0)), L::load(column(1)), L::load(column(2))]
    }
}

impl<'a, T> ColumnsMut<'a, T> {
    /// Columns of one element.
    #[inline(always)]
    pub fn of_one(vector: &'a mut [T; 3]) -> Self {
        Self {
            start: vector.as_mut_ptr(),
            stride: 1,
            count: 1,
            lifetime: PhantomData,
        }
    }

    /// Columns of `count` elements, with the start aligned and the stride counted in numbers.
    ///
    /// # Safety
    /// All `3 * count` numbers must be writable and distinct, and nobody else may use them during the lifetime.
    pub unsafe fn new(start: *mut T, stride: isize, count: usize) -> Self {
        Self {
            start,
            stride,
            count,
            lifetime: PhantomData,
        }
    }

    /// Stores the vectors of the `L::COUNT` elements that begin at element `from`.
    ///
    /// # Panics
    /// If the columns end before that.
    #[inline(always)]
    pub fn store<L: Lane<Scalar = T>>(&mut self, from: usize, [x, y, z]: [L; 3]) {
        check(from, L::COUNT, self.count);
        // SAFETY: as in `load`; one column is borrowed at a time.
        let column = |c: isize| unsafe {
            std::slice::from_raw_parts_mut(self.start.offset(c * self.stride).add(from), L::COUNT)
        };
        x.store(column(0));
        y.store(column(1));
        z.store(column(2));
    }
}

#[inline(always)]
fn check(from: usize, width: usize, count: usize) {
    if from >= count || width > count - from {
        outside();
    }
}

/// It takes no arguments, because callers would prepare them in the fast path too.
#[cold]
#[inline(never)]
fn outside() -> ! {
    panic!("elements outside columns")
}
