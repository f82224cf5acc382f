//! A table too large to allocate: one after another of a creation's large allocations fails. It gives
//! OUT_OF_MEMORY, leaves the output alone and loses no byte.

#![allow(unsafe_code)] // an allocator, and the C interface

use pellicle::capi::*;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ffi::CStr;
use std::ptr::null_mut;

/// Allocations from here on are tables. Working memory is less, for these films: that of the reference, which
/// grows with the fringes that it has to resolve, cannot fail without ending the program.
const LARGE: usize = 320 << 10;

thread_local! {
    /// How many large allocations succeed before one fails.
    static LEFT: Cell<usize> = const { Cell::new(usize::MAX) };
    static IN_USE: Cell<isize> = const { Cell::new(0) };
}

struct Failing;

#[global_allocator]
static ALLOCATOR: Failing = Failing;

// SAFETY: the system's allocator, or NULL, which the trait allows.
unsafe impl GlobalAlloc for Failing {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.size() >= LARGE {
            let left = LEFT.get();
            // One failure: what follows it may allocate.
            LEFT.set(left.checked_sub(1).unwrap_or(usize::MAX));
            if left == 0 {
                return null_mut();
            }
        }
        IN_USE.set(IN_USE.get() + layout.size() as isize);
        // SAFETY: as the caller vouches.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        IN_USE.set(IN_USE.get() - layout.size() as isize);
        // SAFETY: as the caller vouches.
        unsafe { System.dealloc(pointer, layout) }
    }
}

/// Counts the large allocations of a creation. Then one of them fails: one of the first, the last, or one
/// between.
fn fail_some<T>(
    create: impl Fn(&mut *mut T) -> PellicleStatus,
    release: unsafe extern "C" fn(*const T),
) -> usize {
    let untouched: *mut T = std::ptr::dangling_mut();
    let make_and_release = || {
        let mut handle = untouched;
        assert_eq!(create(&mut handle), PELLICLE_OK);
        // SAFETY: a live handle.
        unsafe { release(handle) };
    };
    // What is kept for the life of the program is made now.
    make_and_release();
    let before = IN_USE.get();
    LEFT.set(usize::MAX - 1);
    make_and_release();
    let count = usize::MAX - 1 - LEFT.get();
    assert_eq!(IN_USE.get(), before, "bytes are lost by a handle");

    for succeeding in [0, 1, count / 2, count - 1] {
        let mut handle = untouched;
        LEFT.set(succeeding);
        let status = create(&mut handle);
        LEFT.set(usize::MAX);
        // SAFETY: NUL-terminated, until this thread's next failure.
        let message = unsafe { CStr::from_ptr(pellicle_last_error()) }.to_string_lossy();
        assert_eq!(status, PELLICLE_OUT_OF_MEMORY, "{message}");
        assert!(
            message.contains("no memory for") && message.contains("bytes"),
            "{message}"
        );
        assert_eq!(handle, untouched);
        drop(message);
        assert_eq!(
            IN_USE.get(),
            before,
            "bytes are lost by failure {succeeding}"
        );
    }
    count
}

fn medium(eta: f32, k: f32) -> PellicleMedium {
    // SAFETY: 0 is valid for numbers and pointers.
    let mut medium: PellicleMedium = unsafe { std::mem::zeroed() };
    medium.eta = [eta; 3];
    medium.k = [k; 3];
    medium
}

/// A layer of 0 to 3000 nm on a base: how many tables there are, in the making and kept.
fn tables(layer: PellicleMedium, base: PellicleMedium, transmittance: u32) -> usize {
    let layer = PellicleLayer {
        medium: &layer,
        thickness_min_nm: 0.0,
        thickness_max_nm: 3000.0,
    };
    // SAFETY: 0 is valid for numbers and pointers.
    let mut desc: PellicleFilmDesc = unsafe { std::mem::zeroed() };
    desc.medium_size = size_of_val(&base);
    desc.layer_size = size_of_val(&layer);
    desc.layers = &layer;
    desc.layer_count = 1;
    desc.base = &base;
    desc.tolerance = 5e-4;
    desc.transmittance = transmittance;
    // SAFETY: a valid description.
    let create = |film: &mut _| unsafe { pellicle_film_create(&desc, size_of_val(&desc), film) };
    fail_some(create, pellicle_film_release)
}

#[test]
fn a_film_without_memory_for_its_table_is_refused() {
    let count = tables(medium(1.5, 0.0), medium(1.1, 6.0), 0);
    // Values, control points along one coordinate, control points.
    assert!(count >= 3, "{count} large allocations");
}

#[test]
fn so_is_one_without_memory_for_any_of_its_tables() {
    let count = tables(medium(2.0, 0.02), medium(1.5, 0.0), 1);
    assert!(count >= 6, "{count} large allocations");
}
