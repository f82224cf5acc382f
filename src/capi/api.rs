//! All functions in one table, for programs that load the library at run time.
//!
//! The table is generated: build.rs reads the functions that cbindgen finds and writes the struct into the
//! header and the table into OUT_DIR. A new function is written once, in its own file.

use super::c_types::size_t;
use super::types::PELLICLE_ABI_VERSION;

// Every function of this header by its name without the prefix; build.rs writes the fields.
/// The table of all functions, which pellicle_get_api() gives.
pub struct PellicleApi {
    _private: [u8; 0],
}

/// The table's size in bytes and the addresses of the functions, in the order of the struct.
#[repr(C)]
struct Table {
    size: size_t,
    functions: [Function; FUNCTION_COUNT],
}

/// The address of a function.
#[repr(transparent)]
struct Function(*const ());

// SAFETY: functions never change.
unsafe impl Sync for Table {}

static TABLE: Table = Table {
    size: size_of::<Table>(),
    functions: FUNCTIONS,
};

include!(concat!(env!("OUT_DIR"), "/api_table.rs"));

/// Gives the table of functions: the one symbol to look up with dlsym(). Pass PELLICLE_ABI_VERSION; NULL
/// means that the library that runs has another one. The table lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_get_api(abi_version: u32) -> *const PellicleApi {
    if abi_version == PELLICLE_ABI_VERSION {
        (&raw const TABLE).cast()
    } else {
        std::ptr::null()
    }
}
