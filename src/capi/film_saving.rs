//! Compiled films as blocks of memory.

use super::boundary::{guard, require};
use super::c_types::{c_void, size_t};
use super::film::{handle, handle_under};
use super::float_control::Traps;
use super::types::{PellicleFilm, PellicleStatus};
use crate::error::Error;
use crate::film::Film;
use std::sync::Arc;

/// Writes a compiled film to a block of memory, from which pellicle_film_load() makes it again without fitting or
/// measuring. Call it twice: with `block` NULL it only stores the block's bytes in `*size`, some hundred to some
/// million, for a film always the same number; then with that many.
///
/// `block_size` below that number: OUT_OF_RANGE. Also OUT_OF_MEMORY. A block holds no pointers and may be written to a
/// file as it is.
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, `block` NULL or good for `block_size` bytes, `size` NULL (refused) or
/// good for one number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_save(
    film: *const PellicleFilm,
    block: *mut c_void,
    block_size: size_t,
    size: *mut size_t,
) -> PellicleStatus {
    guard(|| {
        require(size, "size")?;
        // SAFETY: the caller vouches for the handle.
        let bytes = unsafe { handle(film)? }.film.to_bytes()?;
        let needed = bytes.len();
        if !block.is_null() && block_size < needed {
            return Err(Error::out_of_range(format!(
                "block_size = {block_size} is less than the {needed} bytes that the film takes"
            )));
        }
        // SAFETY: the caller vouches for both outputs; the block is large enough.
        unsafe {
            if !block.is_null() {
                block
                    .cast::<u8>()
                    .copy_from_nonoverlapping(bytes.as_ptr(), needed);
            }
            size.write_unaligned(needed);
        }
        Ok(())
    })
}

/// Makes a film of a block that pellicle_film_save() has written, and stores a handle with one reference in `*film`. It
/// gives the same bits as the film that was saved, in every call. Most films take 25 to 110 microseconds. The block is
/// copied. Batches use the widest instructions there are (PellicleFilmDesc::simd_level NULL).
///
/// A block belongs to the build of the library that wrote it, since another one may evaluate the same numbers to other
/// bits. Refused are, with the reason in pellicle_last_error(): bytes that are no saved film, cut short, too long or
/// damaged (INVALID_ARGUMENT); another format and another build (UNSUPPORTED). Also OUT_OF_RANGE for contents that no
/// film has behind a checksum that is right, and OUT_OF_MEMORY. `*film` is then untouched.
///
/// So a cache on disk needs no checks of its own: read the file, load it, and after any failure create the film and
/// write the file anew (docs/films.md has an example). But a block does not tell which film was wanted: name the file by
/// all that went into PellicleFilmDesc, tables of media too. No block makes a call read or write outside its memory, or
/// fail to return; what colours a forged one gives is not checked.
///
/// # Safety
/// `block` must be NULL (refused) or good for `size` bytes, `film` for one pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_load(
    block: *const c_void,
    size: size_t,
    film: *mut *mut PellicleFilm,
) -> PellicleStatus {
    let traps = Traps::of_caller();
    guard(|| {
        require(film, "film")?;
        require(block, "block")?;
        if size > isize::MAX as usize {
            return Err(Error::invalid(format!("size = {size} is impossible")));
        }
        // SAFETY: not NULL; the caller vouches for `size` bytes, and for the output.
        unsafe {
            let bytes = std::slice::from_raw_parts(block.cast::<u8>(), size);
            let loaded = Arc::new(Film::from_bytes(bytes)?);
            film.write_unaligned(handle_under(traps, loaded, None)?);
        }
        Ok(())
    })
}
