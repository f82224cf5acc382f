//! Blocks of any bytes, loaded as films, and calls of those that can be loaded. The first byte chooses: the others are
//! the block as it is, or the contents of a block whose header and checksum are right, or changes of a film's contents
//! that has tables of every kind.

use super::bytes::Bytes;
use super::guarded::Guarded;
use super::outcome::{Output, must_be_within, succeeded};
#[cfg(test)]
use crate::shared::films;
use crate::shared::films::Kind;
use pellicle::capi::*;
use pellicle::film::{Film, resealed};
#[cfg(test)]
use pellicle::{FilmDescription, Medium};
use std::ffi::CStr;
use std::sync::OnceLock;

/// Bytes of a header.
const HEADER: usize = 48;
/// Every documented failure of loading.
const FAILURES: [PellicleStatus; 4] = [
    PELLICLE_INVALID_ARGUMENT,
    PELLICLE_OUT_OF_RANGE,
    PELLICLE_UNSUPPORTED,
    PELLICLE_OUT_OF_MEMORY,
];
/// The reference takes too long for thicker layers.
const MOST_THICKNESS_NM: f64 = 2e3;

pub fn run(data: &[u8]) {
    let block = block(data);
    let mut guarded = Guarded::new(block.len(), data.len() % 4 < 3, 0);
    guarded.bytes_mut().copy_from_slice(&block);
    let mut handle = Output::<*mut PellicleFilm>::new();
    // SAFETY: the block is alive and as long as stated.
    let status = unsafe {
        let block = guarded.pointer().cast_const().cast();
        pellicle_film_load(block, guarded.bytes().len(), handle.pointer())
    };
    if !succeeded(status, &FAILURES) {
        return handle.must_be_untouched();
    }
    let film = handle.get();
    // What it is known by in Rust, for its thickness.
    let known = Film::from_bytes(&block).expect("C has loaded it");
    // SAFETY: a live handle, until it is released.
    unsafe {
        must_be_saved_alike(film, &block);
        call(film, &known, &mut Bytes(data));
        pellicle_film_release(film);
    }
}

/// The block of an input.
pub fn block(data: &[u8]) -> Vec<u8> {
    match data.split_first() {
        Some((first, rest)) => match first % 8 {
            7 => rest.to_vec(),
            6 => changed(&mut Bytes(rest)),
            _ => resealed([&[0; HEADER], rest].concat()),
        },
        None => Vec::new(),
    }
}

/// A large block with some bytes changed, most of them before its first colours.
fn changed(bytes: &mut Bytes) -> Vec<u8> {
    static LARGE: OnceLock<Vec<u8>> = OnceLock::new();
    let large = LARGE.get_or_init(|| Kind::Sunglasses.film().to_bytes().expect("memory"));
    let mut block = large.clone();
    for _ in 0..bytes.index(8) {
        let within = if bytes.byte() < 160 { 600 } else { block.len() };
        let at = HEADER + bytes.word() as usize % (within - HEADER);
        block[at] = bytes.byte();
    }
    resealed(block)
}

/// The input that is loaded as the film of a description.
#[cfg(test)]
pub fn input_of(description: &FilmDescription) -> Vec<u8> {
    let block = films::compiled(description).to_bytes().expect("memory");
    [&[0], &block[HEADER..]].concat()
}

/// A film of each kind whose block is small.
#[cfg(test)]
pub fn seeds() -> Vec<(&'static str, FilmDescription)> {
    let constant = |eta| films::constant(eta, 0.0);
    let with = |method: &str, description: FilmDescription| FilmDescription {
        method: Some(method.into()),
        tolerance: 0.3,
        ..description
    };
    let coated = || films::bare(constant(1.5)).layer(constant(1.38), [0.0, 200.0]);
    let measured = Medium::table(&[400.0, 500.0, 600.0], &[1.5, 1.6, 1.4], &[0.0, 0.1, 0.0]);
    let measured = measured.expect("a valid table");
    let coarse = |description| FilmDescription {
        tolerance: 0.3,
        ..description
    };
    let prism = FilmDescription {
        ambient: films::medium("BK7"),
        ..films::two_sided(films::bare(Medium::vacuum()))
    };
    vec![
        ("fresnel", films::bare(constant(1.5))),
        ("schlick", with("schlick", films::bare(films::medium("Au")))),
        ("curve", films::bare(films::medium("Si"))),
        ("table", coarse(coated())),
        (
            "measured",
            with(
                "reference",
                films::bare(measured.clone()).layer(measured, [0.0, 50.0]),
            ),
        ),
        ("critical", coarse(prism)),
        ("bands", with("bands", coated())),
        ("airy_rgb", with("airy_rgb", coated())),
        ("series", with("series", films::bare(films::medium("Au")))),
    ]
}

/// A film that was loaded is saved as the block that it was loaded from.
unsafe fn must_be_saved_alike(film: *const PellicleFilm, block: &[u8]) {
    let mut size = 0;
    let mut again = vec![0u8; block.len()];
    // SAFETY: the caller vouches for the handle; outputs are as large as they must be.
    unsafe {
        let asked = pellicle_film_save(film, std::ptr::null_mut(), 0, &mut size);
        assert_eq!((asked, size), (PELLICLE_OK, block.len()));
        let status = pellicle_film_save(film, again.as_mut_ptr().cast(), size, &mut size);
        assert_eq!(status, PELLICLE_OK);
    }
    assert!(again == block, "saved differently");
}

unsafe fn call(film: *const PellicleFilm, known: &Film, bytes: &mut Bytes) {
    let description = known.description();
    let thickest = description.layers.iter().map(|layer| layer.thickness_nm[1]);
    let is_quick = thickest.sum::<f64>() <= MOST_THICKNESS_NM;
    let greatest = if description.unclipped {
        f32::INFINITY
    } else {
        1.0
    };
    let look = |rgb: [f32; 3]| {
        if description.unclipped {
            assert!(rgb.into_iter().all(f32::is_finite), "{rgb:?}");
        } else {
            must_be_within(&rgb, greatest);
        }
    };
    // SAFETY: the caller vouches for the handle; outputs are as large as they must be.
    unsafe {
        let mut plan = Output::<PellicleFilmPlan>::new();
        let size = size_of::<PellicleFilmPlan>();
        assert_eq!(pellicle_film_plan(film, plan.pointer(), size), PELLICLE_OK);
        let reason = CStr::from_ptr(plan.get().reason);
        assert_eq!(reason.to_bytes(), known.plan().reason.as_bytes());

        let is_slow = ["series", "reference"].contains(&known.plan().method);
        if is_slow && !is_quick {
            return;
        }
        let [least, greatest_nm] = known.varying_thickness_nm().unwrap_or_default();
        for i in 0..if is_slow { 2 } else { 16 } {
            // The corners, where positions in tables are closest to their ends, and any number.
            let corner = [0.0, 1.0][i % 2];
            let (cos_theta, thickness_nm) = match i {
                0..2 => (corner, least as f32),
                2..4 => (corner, greatest_nm as f32),
                _ => (
                    bytes.number(0.0, 1.0),
                    bytes.number(least as f32, greatest_nm as f32),
                ),
            };
            let mut rgb = Output::<[f32; 3]>::new();
            let output = rgb.pointer().cast();
            let status = pellicle_film_reflectance(film, cos_theta, thickness_nm, output);
            assert_eq!(status, PELLICLE_OK);
            look(rgb.get());
            for side in [PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE] {
                let [mut r, mut t] = [(); 2].map(|()| Output::<[f32; 3]>::new());
                let outputs = [&mut r, &mut t].map(|output| output.pointer().cast());
                let [to_r, to_t] = outputs;
                let status = pellicle_film_eval(film, cos_theta, thickness_nm, side, to_r, to_t);
                if succeeded(status, &[PELLICLE_UNSUPPORTED]) {
                    look(r.get());
                    look(t.get());
                }
            }
        }
        if is_quick {
            let mut rgb = Output::<[f32; 3]>::new();
            let output = rgb.pointer().cast();
            let status = pellicle_film_reference(film, 0.5, least as f32, output);
            assert_eq!(status, PELLICLE_OK);
        }
    }
}
