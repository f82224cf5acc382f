//! From a call's options in the caller's memory to our own.

use super::boundary::read_growing;
use super::stand_in::{Call, Transport};
use super::types::{
    PELLICLE_DELTA, PELLICLE_DIFFUSE, PELLICLE_GLOSSY, PELLICLE_REFLECTION, PELLICLE_TRANSMISSION,
    PELLICLE_TRANSPORT_IMPORTANCE, PELLICLE_TRANSPORT_RADIANCE, PellicleCall,
};
use crate::bsdf::Flags;
use crate::error::Error;

/// Every flag that a lobe can have.
const ALL_FLAGS: u32 = PELLICLE_REFLECTION
    | PELLICLE_TRANSMISSION
    | PELLICLE_DIFFUSE
    | PELLICLE_GLOSSY
    | PELLICLE_DELTA;

/// The options behind a pointer that may be NULL.
///
/// # Safety
/// `call` must be NULL or good for the number of bytes that its first field states.
#[inline(always)]
pub(super) unsafe fn call_options(call: *const PellicleCall) -> Result<Call, Error> {
    if call.is_null() {
        return Ok(Call::default());
    }
    // SAFETY: not NULL; the caller vouches for its size.
    unsafe { given_options(call) }
}

#[inline(never)] // most calls give none
unsafe fn given_options(call: *const PellicleCall) -> Result<Call, Error> {
    // SAFETY: the caller vouches for as many bytes as the size says, the size itself included.
    let given = unsafe {
        let size = (&raw const (*call).size).read_unaligned();
        read_growing(call, size, "call")?
    };
    let transport = match given.transport {
        PELLICLE_TRANSPORT_RADIANCE => Transport::Radiance,
        PELLICLE_TRANSPORT_IMPORTANCE => Transport::Importance,
        other => {
            return Err(Error::out_of_range(format!(
                "call->transport = {other} is neither {PELLICLE_TRANSPORT_RADIANCE} (radiance) nor \
                 {PELLICLE_TRANSPORT_IMPORTANCE} (importance)"
            )));
        }
    };
    if given.lobes & !ALL_FLAGS != 0 {
        return Err(Error::out_of_range(format!(
            "call->lobes = {:#x} has flags outside {ALL_FLAGS:#x}, which are those of a lobe",
            given.lobes
        )));
    }
    let lobes = match given.lobes {
        0 => ALL_FLAGS,
        some => some,
    };
    Ok(Call {
        transport,
        lobes: Flags(lobes),
    })
}
