//! A table too large to allocate: one after another of a creation's large allocations fails. It gives
//! OUT_OF_MEMORY, leaves the output alone and loses no byte.

#![allow(unsafe_code)] // an allocator, and the C interface

use pellicle::capi::*;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::ffi::CStr;
use std::ptr::null_mut;
use std::sync::Arc;

/// Allocations from here on are tables. Working memory is less, for these films: that of the reference, which
/// grows with the fringes that it has to resolve, cannot fail without ending the program.
const LARGE: usize = 320 << 10;

thread_local! {
    /// How many large allocations succeed before one fails.
    static LEFT: Cell<usize> = const { Cell::new(usize::MAX) };
    static IN_USE: Cell<isize> = const { Cell::new(0) };
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
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
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
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

    for succeeding in [0, 1.min(count - 1), count / 2, count - 1] {
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
    desc.tolerance = 2e-4;
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

/// Saving and loading need memory for the block and for each table.
#[test]
fn a_block_or_a_table_without_memory_is_refused() {
    let description = FilmDescription {
        tolerance: 2e-4,
        transmittance: true,
        ..FilmDescription::new(Medium::rgb([1.5; 3], [0.0; 3]).unwrap())
    }
    .layer(Medium::rgb([2.0; 3], [0.02; 3]).unwrap(), [0.0, 3000.0]);
    let film = Film::new(&description).unwrap();
    let block = film.to_bytes().unwrap();
    let (start, size) = (block.as_ptr().cast(), block.len());
    // SAFETY: the block is alive and as long as stated.
    let load = |film: &mut _| unsafe { pellicle_film_load(start, size, film) };
    fail_some(load, pellicle_film_release);

    let film = film_handle(Arc::new(film), None).unwrap();
    let before = IN_USE.get();
    let mut needed = 7;
    // SAFETY: a live handle, and an output.
    let mut save = || unsafe { pellicle_film_save(film, null_mut(), 0, &mut needed) };
    for succeeding in [0, 1] {
        LEFT.set(succeeding);
        assert_eq!(save(), PELLICLE_OUT_OF_MEMORY);
        LEFT.set(usize::MAX);
        assert_eq!(IN_USE.get(), before);
    }
    assert_eq!(save(), PELLICLE_OK);
    assert_eq!(needed, size);
    // SAFETY: a live handle.
    unsafe { pellicle_film_release(film) };
}

/// Spectral renderers call these at every hit.
#[test]
fn amplitudes_and_spectra_allocate_nothing() {
    let mut description = FilmDescription {
        method: Some("reference".into()),
        extrapolate: true,
        ..FilmDescription::new(Medium::named("BK7").unwrap())
    };
    for name in ["SiO2", "Ag", "TiO2"] {
        description = description.layer(Medium::named(name).unwrap(), [20.0; 2]);
    }
    let measured = Medium::table(&[400.0, 600.0], &[1.5, 1.6], &[0.0, 0.1]).unwrap();
    description = description.layer(measured, [0.0, 300.0]);
    let film = film_handle(Arc::new(Film::new(&description).unwrap()), None).unwrap();
    let lambda_nm: [f32; 40] = std::array::from_fn(|i| 380.0 + 10.0 * i as f32);
    let mut numbers = [0.0f32; 8 * 40];
    let output = numbers.as_mut_ptr();
    let view = PellicleConstView {
        data: lambda_nm.as_ptr(),
        element_stride: 0,
        component_stride: 4,
    };
    let before = ALLOCATIONS.get();
    for count in [1, 4, 16, 40] {
        for side in [PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE] {
            let nm = lambda_nm.as_ptr();
            // SAFETY: a live handle, 40 wavelengths, room for 40 results.
            unsafe {
                let found = output.cast();
                let status = pellicle_film_amplitudes(film, 0.7, 90.0, side, nm, count, found);
                assert_eq!(status, PELLICLE_OK);
                let (r, t) = (output, output.add(40));
                let status = pellicle_film_spectrum_eval(film, 0.7, 90.0, side, nm, count, r, t);
                assert_eq!(status, PELLICLE_OK);
                let mut args: PellicleAmplitudesBatchArgs = std::mem::zeroed();
                (args.count, args.lambda_count, args.side) = (2, count, side);
                [args.lambda_nm, args.cos_theta, args.thickness_nm] = [view; 3];
                args.t_s = PellicleView {
                    data: output,
                    element_stride: 8 * 40,
                    component_stride: 4,
                };
                let status = pellicle_film_amplitudes_batch(film, &args, size_of_val(&args));
                assert_eq!(status, PELLICLE_OK);
            }
        }
    }
    assert_eq!(ALLOCATIONS.get(), before);
    // SAFETY: a live handle.
    unsafe { pellicle_film_release(film) };
}
