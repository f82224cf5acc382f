//! NUL-terminated copies of the library's fixed texts, made by the compiler.
//!
//! The core keeps its texts as `&str`. A C caller needs a terminator and an address that lives as long as
//! the library, without an allocation that would outlive dlclose(): so every text is copied into one array
//! at compile time, and [`text`] finds it there.

use crate::bsdf::{Exception, ModelInfo, ParamInfo, ParamKind, models};
use crate::film::METHODS;
use libc::c_char;

/// All texts, each between two NUL bytes.
static TEXTS: [u8; LENGTH] = Writer::<LENGTH>::all().bytes;

const LENGTH: usize = Writer::<0>::all().length;

/// The copy of a text of the library.
///
/// # Panics
/// If the text is none of those that this file copies: a defect, reported as INTERNAL.
pub(super) fn text(text: &'static str) -> *const c_char {
    let at = find(text).unwrap_or_else(|| panic!("the text '{text}' has no C copy"));
    TEXTS[at..].as_ptr().cast()
}

fn find(text: &str) -> Option<usize> {
    let wanted = text.as_bytes();
    TEXTS
        .windows(wanted.len() + 2)
        .position(|window| {
            window[0] == 0 && window[wanted.len() + 1] == 0 && &window[1..=wanted.len()] == wanted
        })
        .map(|nul| nul + 1)
}

/// Appends texts to an array of N bytes; with N = 0 it only counts their bytes.
struct Writer<const N: usize> {
    bytes: [u8; N],
    length: usize,
}

impl<const N: usize> Writer<N> {
    const fn all() -> Self {
        // A NUL stands before every text; the second one ends the empty text.
        let mut writer = Self {
            bytes: [0; N],
            length: 2,
        };
        writer.texts(&METHODS);
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
            self.texts(choices);
        }
    }

    const fn exception(&mut self, exception: &Option<Exception>) {
        if let Some(exception) = exception {
            self.text(exception.reason);
        }
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
            if N > 0 {
                self.bytes[self.length + i] = bytes[i];
            }
            i += 1;
        }
        self.length += bytes.len() + 1;
    }
}
