//! Versions, statuses, the last error.

use super::c_types::c_char;
use super::last_error;
use super::types::{PELLICLE_ABI_VERSION, PellicleStatus};

/// Gives PELLICLE_ABI_VERSION of the library that runs; compare it with the header's.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_abi_version() -> u32 {
    PELLICLE_ABI_VERSION
}

/// Gives the version of the library that runs, "major.minor.patch". It lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_version_string() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// Gives a status in words, "unknown status" for a number that is none. It lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_status_string(status: PellicleStatus) -> *const c_char {
    let text = match status {
        0 => c"ok",
        1 => c"invalid argument",
        2 => c"unknown name",
        3 => c"out of range",
        4 => c"unsupported",
        5 => c"out of memory",
        6 => c"internal error",
        _ => c"unknown status",
    };
    text.as_ptr()
}

/// Tells what was wrong in this thread's last failing call: which argument, its value, what is allowed.
/// It is never NULL, and empty before the first failure. The text is valid until this thread's next failing
/// call or its end; longer messages are cut at 1023 bytes.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_last_error() -> *const c_char {
    last_error::get()
}
