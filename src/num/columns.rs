//! Vectors of many elements, one column of numbers for each component.
//!
//! What is written is raw memory: no reference to numbers that may not be initialised is ever made.

#![allow(unsafe_code)]

use super::Lane;
use std::marker::PhantomData;

/// Three columns to read: component c of element i is `c * stride + i` numbers from the start.
///
/// A single vector is three columns of one element, so that a single call and a batch read alike.
#[derive(Clone, Copy, Debug)]
pub struct Columns<'a, T> {
    start: *const T,
    stride: isize,
    count: usize,
    lifetime: PhantomData<&'a [T]>,
}

/// Three columns to write, placed like those of [`Columns`].
#[derive(Debug)]
pub struct ColumnsMut<'a, T> {
    start: *mut T,
    stride: isize,
    count: usize,
    lifetime: PhantomData<&'a mut [T]>,
}

impl<'a, T> Columns<'a, T> {
    /// One vector.
    #[inline(always)]
    pub fn of_one(vector: &'a [T; 3]) -> Self {
        Self {
            start: vector.as_ptr(),
            stride: 1,
            count: 1,
            lifetime: PhantomData,
        }
    }

    /// `count` elements from an aligned address on.
    ///
    /// # Safety
    /// All `3 * count` numbers must be readable, and unchanged, for the lifetime.
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

    /// The vectors of `L::COUNT` elements from one on.
    ///
    /// # Panics
    /// If there are fewer.
    #[inline(always)]
    pub fn load<L: Lane<Scalar = T>>(&self, from: usize) -> [L; 3] {
        check(from, L::COUNT, self.count);
        // SAFETY: within the columns, for which the constructor vouches.
        let column = |c: isize| unsafe {
            std::slice::from_raw_parts(self.start.offset(c * self.stride).add(from), L::COUNT)
        };
        [L::load(column(0)), L::load(column(1)), L::load(column(2))]
    }
}

impl<'a, T> ColumnsMut<'a, T> {
    /// One vector.
    #[inline(always)]
    pub fn of_one(vector: &'a mut [T; 3]) -> Self {
        Self {
            start: vector.as_mut_ptr(),
            stride: 1,
            count: 1,
            lifetime: PhantomData,
        }
    }

    /// Three columns one after another.
    pub fn of_slice(numbers: &'a mut [T]) -> Self {
        let count = numbers.len() / 3;
        Self {
            start: numbers.as_mut_ptr(),
            stride: count as isize,
            count,
            lifetime: PhantomData,
        }
    }

    /// `count` elements from an aligned address on.
    ///
    /// # Safety
    /// All `3 * count` numbers must be writable, distinct, and used by nobody else for the lifetime.
    pub unsafe fn new(start: *mut T, stride: isize, count: usize) -> Self {
        Self {
            start,
            stride,
            count,
            lifetime: PhantomData,
        }
    }

    /// Writes the vectors of `L::COUNT` elements from one on.
    ///
    /// # Panics
    /// If there are fewer.
    #[inline(always)]
    pub fn store<L: Lane<Scalar = T>>(&mut self, from: usize, [x, y, z]: [L; 3]) {
        check(from, L::COUNT, self.count);
        // SAFETY: within the columns, for which the constructor vouches.
        unsafe {
            x.write(self.start.add(from));
            y.write(self.start.offset(self.stride).add(from));
            z.write(self.start.offset(2 * self.stride).add(from));
        }
    }
}

/// A column of numbers to write.
#[derive(Debug)]
pub struct ColumnMut<'a, T> {
    start: *mut T,
    count: usize,
    lifetime: PhantomData<&'a mut [T]>,
}

impl<'a, T: Copy> ColumnMut<'a, T> {
    /// The numbers of a slice.
    #[inline(always)]
    pub fn of_slice(numbers: &'a mut [T]) -> Self {
        Self {
            start: numbers.as_mut_ptr(),
            count: numbers.len(),
            lifetime: PhantomData,
        }
    }

    /// `count` numbers from an aligned address on.
    ///
    /// # Safety
    /// All must be writable and used by nobody else for the lifetime.
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
    /// If there are fewer.
    #[inline(always)]
    pub fn set(&mut self, element: usize, number: T) {
        check(element, 1, self.count);
        // SAFETY: within the column, for which the constructor vouches.
        unsafe { self.start.add(element).write(number) };
    }

    /// Writes the numbers of `L::COUNT` elements from one on.
    ///
    /// # Panics
    /// If there are fewer.
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

/// Takes no arguments: callers would have to prepare them in the fast path.
#[cold]
#[inline(never)]
fn outside() -> ! {
    panic!("elements outside columns")
}
