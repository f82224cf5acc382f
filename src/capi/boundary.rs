//! The common work of all entry points: stopping panics, reporting failures, checking pointers, and reading
//! and writing structs that may be shorter or longer than those of this build.

use super::c_types::c_char;
use super::float_control::{Traps, under_default};
use super::last_error;
use super::types::{PELLICLE_INTERNAL, PELLICLE_OK, PellicleStatus};
use crate::error::Error;
#[cfg(test)]
use crate::error::Status;
use std::any::Any;
use std::ffi::CStr;
use std::mem::MaybeUninit;
use std::panic::{self, AssertUnwindSafe};

/// Runs an entry point under the default floating-point state. A failure is reported by status and message; so is
/// a panic, which ends here.
#[inline(always)]
pub(super) fn guard(body: impl FnOnce() -> Result<(), Error>) -> PellicleStatus {
    let mut body = Some(body);
    guarded(&mut || {
        body.take()
            .map_or(PELLICLE_INTERNAL, |body| reported(body()))
    })
}

/// As [`guard`], for a single call, which takes a few nanoseconds. `traps` comes from the call's handle.
#[inline(always)]
pub(super) fn guard_call(traps: Traps, body: impl FnOnce() -> Result<(), Error>) -> PellicleStatus {
    guard_call_status(
        traps,
        #[inline(always)]
        move || reported(body()),
    )
}

/// As [`guard_call`], for a body that reports its failures itself: without an [`Error`] to make and to drop,
/// numbers stay in their registers (1 of 13 ns of a film's reflectance).
///
/// Bodies are `move` closures and always inlined: else their numbers would lie in memory (3 of 13 ns).
#[inline(always)]
pub(super) fn guard_call_status(
    traps: Traps,
    body: impl FnOnce() -> PellicleStatus,
) -> PellicleStatus {
    if traps.look_default() {
        return caught(body);
    }
    let mut body = Some(body);
    guarded(&mut move || body.take().map_or(PELLICLE_INTERNAL, |body| body()))
}

#[inline(never)]
fn guarded(body: &mut dyn FnMut() -> PellicleStatus) -> PellicleStatus {
    under_default(&mut || caught(&mut *body))
}

#[inline(always)]
fn reported(result: Result<(), Error>) -> PellicleStatus {
    match result {
        Ok(()) => PELLICLE_OK,
        Err(error) => report(&error),
    }
}

#[inline(always)]
fn caught(body: impl FnOnce() -> PellicleStatus) -> PellicleStatus {
    #[cfg(test)]
    let body = super::faults::injected(body);
    // Nothing shared is left half-changed by a panic: handles are immutable, and outputs are
    // written after everything that can fail.
    match panic::catch_unwind(AssertUnwindSafe(body)) {
        Ok(status) => status,
        Err(payload) => report_panic(&*payload),
    }
}

#[cold]
#[inline(never)]
fn report(error: &Error) -> PellicleStatus {
    last_error::set(&error.message);
    error.status as PellicleStatus
}

#[cold]
#[inline(never)]
fn report_panic(payload: &(dyn Any + Send)) -> PellicleStatus {
    let text = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("panic");
    last_error::set(&format!("internal error, please report it: {text}"));
    PELLICLE_INTERNAL
}

/// The object behind a handle, or NULL refused.
#[inline(always)]
pub(super) unsafe fn reference<'a, T>(
    pointer: *const T,
    name: &'static str,
) -> Result<&'a T, Error> {
    // SAFETY: not NULL; the caller vouches for the rest, as C callers must.
    unsafe { pointer.as_ref() }.ok_or_else(|| null(name))
}

/// N numbers behind a pointer to read.
#[inline(always)]
pub(super) unsafe fn numbers<const N: usize>(
    pointer: *const f32,
    name: &'static str,
) -> Result<[f32; N], Error> {
    if pointer.is_null() {
        return Err(null(name));
    }
    // SAFETY: not NULL, and the caller vouches for N numbers.
    Ok(unsafe { pointer.cast::<[f32; N]>().read_unaligned() })
}

/// `count` numbers behind a pointer that is not NULL, where they lie or, if they are not aligned, as a copy in `room`.
#[inline(always)]
pub(super) unsafe fn floats<const N: usize>(
    pointer: *const f32,
    count: usize,
    room: &mut MaybeUninit<[f32; N]>,
) -> &[f32] {
    // SAFETY: the caller vouches for `count` numbers.
    unsafe {
        if pointer.is_aligned() {
            std::slice::from_raw_parts(pointer, count)
        } else {
            copied(pointer, count, room.write([0.0; N]))
        }
    }
}

#[cold]
#[inline(never)]
unsafe fn copied(pointer: *const f32, count: usize, room: &mut [f32]) -> &[f32] {
    for (i, number) in room[..count].iter_mut().enumerate() {
        // SAFETY: the caller vouches for `count` numbers.
        *number = unsafe { pointer.add(i).read_unaligned() };
    }
    &room[..count]
}

/// Refuses NULL for an output.
#[inline(always)]
pub(super) fn require<T>(pointer: *const T, name: &str) -> Result<(), Error> {
    if pointer.is_null() {
        Err(null(name))
    } else {
        Ok(())
    }
}

/// Reports an argument that is NULL.
#[cold]
#[inline(never)]
pub(super) fn refuse_null(name: &str) -> PellicleStatus {
    report(&null(name))
}

#[cold]
#[inline(never)]
fn null(name: &str) -> Error {
    Error::invalid(format!("{name} is NULL"))
}

/// Elements given by pointer and count, at any alignment; NULL is allowed for a count of 0.
///
/// # Safety
/// `pointer` must be NULL or good for `count` elements, for as long as the iterator is used.
pub(super) unsafe fn elements<T: Copy>(
    pointer: *const T,
    count: usize,
    name: &str,
) -> Result<impl ExactSizeIterator<Item = T> + Clone, Error> {
    if count > 0 && pointer.is_null() {
        return Err(Error::invalid(format!(
            "{name} is NULL but its count is {count}"
        )));
    }
    if count > isize::MAX as usize / size_of::<T>() {
        return Err(Error::invalid(format!(
            "{name} has an impossible count: {count}"
        )));
    }
    // SAFETY: not NULL, no overflow; the caller vouches for `count` elements.
    Ok((0..count).map(move |i| unsafe { pointer.add(i).read_unaligned() }))
}

/// A NUL-terminated string that must be UTF-8.
///
/// # Safety
/// `pointer` must be NULL (refused) or NUL-terminated.
pub(super) unsafe fn string(pointer: *const c_char, name: &str) -> Result<String, Error> {
    if pointer.is_null() {
        return Err(Error::invalid(format!("{name} is NULL")));
    }
    // SAFETY: not NULL; the caller vouches for the terminator.
    let text = unsafe { CStr::from_ptr(pointer) };
    let text = text.to_str();
    text.map(str::to_owned)
        .map_err(|_| Error::invalid(format!("{name} is not valid UTF-8")))
}

/// The text of a string that may be NULL.
///
/// # Safety
/// As for [`string`].
pub(super) unsafe fn optional_string(
    pointer: *const c_char,
    name: &str,
) -> Result<Option<String>, Error> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL; the caller vouches for the terminator.
    unsafe { string(pointer, name) }.map(Some)
}

/// Reads a struct that grows: a shorter one is filled up with zeros, the tail of a longer one must
/// be zero.
///
/// # Safety
/// Zero must be a valid value of every field of T, and `pointer` be NULL or good for `size` bytes.
pub(super) unsafe fn read_growing<T: Copy>(
    pointer: *const T,
    size: usize,
    name: &str,
) -> Result<T, Error> {
    require(pointer, name)?;
    check_size::<T>(size, name)?;
    if size == size_of::<T>() {
        // SAFETY: `size` bytes are readable.
        return Ok(unsafe { pointer.read_unaligned() });
    }
    let known = size.min(size_of::<T>());
    let mut value = MaybeUninit::<T>::zeroed();
    // SAFETY: `known` bytes are readable and fit into T; zero is valid for what is left.
    let value = unsafe {
        value
            .as_mut_ptr()
            .cast::<u8>()
            .copy_from_nonoverlapping(pointer.cast(), known);
        value.assume_init()
    };
    for offset in known..size {
        // SAFETY: the caller vouches for `size` bytes.
        if unsafe { pointer.cast::<u8>().add(offset).read() } != 0 {
            return Err(Error::unsupported(format!(
                "{name} of {size} bytes uses fields beyond the {} that this version ({}) knows",
                size_of::<T>(),
                env!("CARGO_PKG_VERSION")
            )));
        }
    }
    Ok(value)
}

/// Writes a struct that grows, up to the size that the caller knows.
///
/// # Safety
/// `pointer` must be good for `size` bytes; both were checked by [`check_output`].
#[inline(always)]
pub(super) unsafe fn write_growing<T: Copy>(pointer: *mut T, size: usize, value: &T) {
    let known = size.min(size_of::<T>());
    // SAFETY: `known` bytes are readable in `value` and, as the caller vouches, writable there.
    unsafe {
        pointer
            .cast::<u8>()
            .copy_from_nonoverlapping(std::ptr::from_ref(value).cast(), known);
    }
}

/// Refuses NULL and impossible sizes for an output that grows.
#[inline(always)]
pub(super) fn check_output<T>(
    pointer: *mut T,
    size: usize,
    name: &'static str,
) -> Result<(), Error> {
    require(pointer, name)?;
    check_size::<T>(size, name)
}

/// Refuses a size that no version of a struct has: no bytes, far too many (an uninitialised size or a swapped
/// argument), or a number that is no multiple of its alignment, which would cut a pointer in two.
#[inline(always)]
pub(super) fn check_size<T>(size: usize, name: &str) -> Result<(), Error> {
    const GREATEST: usize = 1 << 16;
    if size == 0 || size > GREATEST || !size.is_multiple_of(align_of::<T>()) {
        return Err(wrong_size(size, name));
    }
    Ok(())
}

#[cold]
#[inline(never)]
fn wrong_size(size: usize, name: &str) -> Error {
    Error::invalid(format!(
        "{name} has a size of {size} bytes: give its sizeof"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::pellicle_last_error;

    /// Guards the boundary: a panic inside must come out as a status, with its text as the message.
    #[test]
    fn a_panic_becomes_internal() {
        let status = guard(|| panic!("deliberate {}", 42));
        assert_eq!(status, Status::Internal as PellicleStatus);
        // SAFETY: the message is NUL-terminated and lives until this thread's next failure.
        let message = unsafe { CStr::from_ptr(pellicle_last_error()) };
        assert!(
            message.to_string_lossy().contains("deliberate 42"),
            "{message:?}"
        );
    }
}
