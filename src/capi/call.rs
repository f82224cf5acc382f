//! Conversion of a call's options.

use super::boundary::read_growing;
use super::types::{PELLICLE_TRANSPORT_IMPORTANCE, PELLICLE_TRANSPORT_RADIANCE, PellicleCall};
use crate::bsdf::{Call, Flags, Transport};
use crate::error::Error;

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
    // SAFETY: the caller vouches for `size` bytes, the field `size` included.
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
    let lobes = match Flags(given.lobes) {
        Flags(0) => Flags::ALL,
        some => some,
    };
    if !Flags::ALL.contains(lobes) {
        return Err(Error::out_of_range(format!(
            "call->lobes = {:#x} has flags outside {:#x}, which are all flags of lobes",
            lobes.0,
            Flags::ALL.0
        )));
    }
    Ok(Call { transport, lobes })
}
