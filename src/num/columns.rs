//! Vectors of many elements, one column of numbers for each component.
//!
//! Columns to write are raw memory: no reference to numbers that may be uninitialised is ever made.

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

    /// Three columns one after another in a slice, each a third of its length.
    pub fn of_slice(numbers: &'a mut [T]) -> Self {
        let count = numbers.len() / 3;
        Self {
            start: numbers.as_mut_ptr(),
            stride: count as isize,
            count,
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
        // SAFETY: the elements are within the columns, which the caller of the constructor vouched for.
        unsafe {
            x.write(self.start.add(from));
            y.write(self.start.offset(self.stride).add(from));
            z.write(self.start.offset(2 * self.stride).add(from));
        }
    }
}

/// Numbers to write, as one column.
#[derive(Debug)]
pub struct ColumnMut<'a, T> {
    start: *mut T,
    count: usize,
    lifetime: PhantomData<&'a mut [T]>,
}

impl<'a, T: Copy> ColumnMut<'a, T> {
    /// A column whose numbers are those of a slice.
    #[inline(always)]
    pub fn of_slice(numbers: &'a mut [T]) -> Self {
        Self {
            start: numbers.as_mut_ptr(),
            count: numbers.len(),
            lifetime: PhantomData,
        }
    }

    /// A column of `count` numbers, with the start aligned.
    ///
    /// # Safety
    /// All numbers must be writable, and nobody else may use them during the lifetime.
    pub unsafe fn new(start: *mut T, count: usize) -> Self {
        Self {
            start,
            count,
            lifetime: PhantomData,
        }
    }

    /// Writes one number.
    ///
    /// # Panics
    /// If the column ends before that.
    #[inline(always)]
    pub fn set(&mut self, element: usize, number: T) {
        check(element, 1, self.count);
        // SAFETY: the element is within the column, which the caller of the constructor vouched for.
        unsafe { self.start.add(element).write(number) };
    }

    /// Stores the numbers of the `L::COUNT` elements that begin at element `from`.
    ///
    /// # Panics
    /// If the column ends before that.
    #[inline(always)]
    pub fn store<L: Lane<Scalar = T>>(&mut self, from: usize, numbers: L) {
        check(from, L::COUNT, self.count);
        // SAFETY: within the column, for which the constructor vouches.
        unsafe { numbers.write(self.start.add(from)) };
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
