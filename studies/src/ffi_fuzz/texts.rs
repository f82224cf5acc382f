//! C strings that live as long as a description.

use super::bytes::Bytes;
use std::ffi::{CString, c_char};

/// Strings made of bytes.
#[derive(Default)]
pub struct Texts(Vec<CString>);

impl Texts {
    /// A known name most of the time, else NULL or a few bytes of any kind.
    pub fn name(&mut self, bytes: &mut Bytes, known: &[&str]) -> *const c_char {
        match bytes.byte() {
            255 => std::ptr::null(),
            240..=254 => {
                let text: Vec<u8> = (0..6)
                    .map(|_| bytes.byte())
                    .take_while(|byte| *byte != 0)
                    .collect();
                self.keep(text)
            }
            choice => self.keep(known[usize::from(choice) % known.len()]),
        }
    }

    /// The same, but most often NULL.
    pub fn optional_name(&mut self, bytes: &mut Bytes, known: &[&str]) -> *const c_char {
        if bytes.byte() % 4 < 3 {
            std::ptr::null()
        } else {
            self.name(bytes, known)
        }
    }

    /// A copy of a text without NUL.
    pub fn keep(&mut self, text: impl Into<Vec<u8>>) -> *const c_char {
        self.0.push(CString::new(text).unwrap());
        self.0[self.0.len() - 1].as_ptr()
    }
}
