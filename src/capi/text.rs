//! NUL-terminated copies of the library's fixed texts, made by the compiler.
//!
//! The core keeps its texts as `&str`. A C caller needs a terminator and an address that lives as long as
//! the library, without an allocation that would outlive dlclose(): so every text is copied into one array
//! at compile time, and [`text`] and [`list`] find it there.

use super::c_types::c_char;
use crate::bsdf::{Exception, ModelInfo, ParamInfo, ParamKind, models};
use crate::film::METHODS;
use crate::optics::{ColorSpace, NamedMedium, White};
use std::ffi::CStr;
use std::ptr::null;

/// Every name of a level, on any processor.
const LEVELS: [&str; 5] = ["scalar", "sse2", "avx2", "avx512", "neon"];

/// The copy of a text of the library.
///
/// # Panics
/// If the text is none of those that this file copies: a defect, reported as INTERNAL.
pub(super) fn text(text: &'static str) -> *const c_char {
    let wanted = text.as_bytes();
    // A NUL stands before and after every text.
    let is_here = |window: &[u8]| {
        let [0, found @ .., 0] = window else {
            return false;
        };
        found == wanted
    };
    match TEXTS.windows(wanted.len() + 2).position(is_here) {
        Some(nul) => TEXTS[nul + 1..].as_ptr().cast(),
        None => panic!("the text '{text}' has no C copy"),
    }
}

/// The copy of a list of texts of the library: pointers, the last of which is NULL.
///
/// # Panics
/// As [`text`].
pub(super) fn list(texts: &'static [&'static str]) -> *const *const c_char {
    let is_here = |window: &[Pointer]| {
        let (last, found) = window.split_last().expect("a window is never empty");
        let same = |(found, wanted): (&Pointer, &&str)| {
            // SAFETY: what is not NULL points to a NUL-terminated text.
            !found.0.is_null() && unsafe { CStr::from_ptr(found.0) }.to_bytes() == wanted.as_bytes()
        };
        last.0.is_null() && found.iter().zip(texts).all(same)
    };
    match POINTERS.windows(texts.len() + 1).position(is_here) {
        Some(at) => POINTERS[at..].as_ptr().cast(),
        None => panic!("the list {texts:?} has no C copy"),
    }
}

/// The numbers of bytes and pointers.
const COUNTED: Writer<0, 0> = Writer::all();
const WRITTEN: Writer<{ COUNTED.byte_count }, { COUNTED.pointer_count }> = Writer::all();

/// All texts, each between two NUL bytes.
static TEXTS: [u8; COUNTED.byte_count] = WRITTEN.bytes;

/// All lists, each ended by NULL.
static POINTERS: [Pointer; COUNTED.pointer_count] = {
    let mut pointers = [Pointer(null()); COUNTED.pointer_count];
    let mut i = 0;
    while i < pointers.len() {
        if WRITTEN.places[i] != END {
            // SAFETY: the place of a text lies within the texts.
            pointers[i] = Pointer(unsafe { TEXTS.as_ptr().add(WRITTEN.places[i]) }.cast());
        }
        i += 1;
    }
    pointers
};

/// A pointer into [`TEXTS`], or NULL.
#[derive(Clone, Copy)]
#[repr(transparent)]
struct Pointer(*const c_char);

// SAFETY: texts never change.
unsafe impl Sync for Pointer {}

/// The mark of the end of a list.
const END: usize = usize::MAX;

/// Appends texts to an array of B bytes, and the places of listed texts to an array of P places. With B = 0
/// and P = 0 it only counts.
struct Writer<const B: usize, const P: usize> {
    bytes: [u8; B],
    byte_count: usize,
    places: [usize; P],
    pointer_count: usize,
}

impl<const B: usize, const P: usize> Writer<B, P> {
    const fn all() -> Self {
        // The first text is the empty one, between two NUL.
        let mut writer = Self {
            bytes: [0; B],
            byte_count: 2,
            places: [END; P],
            pointer_count: 0,
        };
        writer.texts(&METHODS);
        writer.texts(&LEVELS);
        let mut i = 0;
        while i < ColorSpace::NAMES.len() {
            writer.text(ColorSpace::NAMES[i].0);
            i += 1;
        }
        let mut i = 0;
        while i < White::NAMES.len() {
            writer.text(White::NAMES[i].0);
            i += 1;
        }
        let mut i = 0;
        while i < NamedMedium::all().len() {
            let medium = &NamedMedium::all()[i];
            writer.texts(&[medium.name, medium.source]);
            writer.list(medium.aliases);
            i += 1;
        }
        let mut i = 0;
        while i < models().len() {
            writer.model(models()[i].info);
            i += 1;
        }
        writer
    }

    const fn model(&mut self, info: &ModelInfo) {
        self.texts(&[info.name, info.summary, info.source]);
        self.exception(&info.not_reciprocal);
        self.exception(&info.not_conserving);
        let mut i = 0;
        while i < info.params.len() {
            self.param(&info.params[i]);
            i += 1;
        }
        let mut i = 0;
        while i < info.lobes.len() {
            self.text(info.lobes[i].name);
            i += 1;
        }
    }

    const fn param(&mut self, param: &ParamInfo) {
        self.texts(&[param.name, param.unit, param.summary]);
        if let ParamKind::Choice { choices } = param.kind {
            self.list(choices);
        }
    }

    const fn exception(&mut self, exception: &Option<Exception>) {
        if let Some(exception) = exception {
            self.text(exception.reason);
        }
    }

    const fn list(&mut self, texts: &[&str]) {
        let mut i = 0;
        while i < texts.len() {
            if P > 0 {
                self.places[self.pointer_count] = self.byte_count;
            }
            self.pointer_count += 1;
            self.text(texts[i]);
            i += 1;
        }
        self.pointer_count += 1; // the place is END from the start
    }

    const fn texts(&mut self, texts: &[&str]) {
        let mut i = 0;
        while i < texts.len() {
            self.text(texts[i]);
            i += 1;
        }
    }

    const fn text(&mut self, text: &str) {
        let bytes = text.as_bytes();
        let mut i = 0;
        while i < bytes.len() {
            assert!(bytes[i] != 0, "a text contains NUL");
            if B > 0 {
                self.bytes[self.byte_count + i] = bytes[i];
            }
            i += 1;
        }
        self.byte_count += bytes.len() + 1;
    }
}
