//! The message of the calling thread's last failure, in a fixed buffer.

use super::c_types::c_char;
use std::cell::UnsafeCell;

const CAPACITY: usize = 1024;

thread_local! {
    static MESSAGE: UnsafeCell<[u8; CAPACITY]> = const { UnsafeCell::new([0; CAPACITY]) };
}

/// Keeps as much of the message as fits, whole UTF-8 characters only, NUL-terminated.
pub(super) fn set(message: &str) {
    let mut length = message.len().min(CAPACITY - 1);
    while !message.is_char_boundary(length) {
        length -= 1;
    }
    MESSAGE.with(|buffer| {
        // SAFETY: the buffer belongs to this thread, and no reference to it outlives this closure.
        let buffer = unsafe { &mut *buffer.get() };
        buffer[..length].copy_from_slice(&message.as_bytes()[..length]);
        buffer[length] = 0;
    });
}

/// NUL-terminated; empty if this thread has seen no failure.
pub(super) fn get() -> *const c_char {
    MESSAGE.with(|buffer| buffer.get().cast())
}
