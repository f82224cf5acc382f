//! BSDF handles: creation, reference counts and queries.

use super::boundary::{
    check_output, elements, guard, optional_string, read_growing, reference, require, string,
    write_growing,
};
use super::bsdf_types::{
    PellicleBsdfDesc, PellicleBsdfInfo, PellicleLobeInfo, PellicleParam, PellicleVaryingInfo,
};
use super::c_types::size_t;
use super::film;
use super::float_control::Traps;
use super::text::text;
use super::types::{PELLICLE_KIND_DIRECTION, PELLICLE_KIND_NUMBER, PellicleBsdf, PellicleStatus};
use crate::bsdf::{Bsdf, Description, ParamKind};
use crate::error::Error;
use std::ffi::CString;
use std::sync::Arc;

/// The object behind a handle: the BSDF, and its texts for C callers.
pub(super) struct BsdfHandle {
    pub bsdf: Bsdf,
    traps: Traps,
    plan: CString,
}

/// A handle with one reference. Hidden: for tests that make a BSDF in Rust and call it as C does.
#[doc(hidden)]
pub fn bsdf_handle(bsdf: Bsdf) -> *mut PellicleBsdf {
    handle_under(Traps::NONE, bsdf)
}

fn handle_under(traps: Traps, bsdf: Bsdf) -> *mut PellicleBsdf {
    let plan = CString::new(bsdf.plan()).unwrap_or_default();
    let handle = Arc::new(BsdfHandle { bsdf, traps, plan });
    Arc::into_raw(handle).cast_mut().cast()
}

/// Creates a BSDF: validates the description, compiles it, and stores a handle with one reference in
/// `*bsdf`. Call it when loading, not when shading: it takes milliseconds, at
/// most a tenth of a second.
///
/// Fails with UNKNOWN_NAME (model, parameter, choice, level), OUT_OF_RANGE (numbers, ranges, sums),
/// INVALID_ARGUMENT (NULL, a wrong count or size, something given twice, a film that is missing or not used)
/// or UNSUPPORTED (a parameter that cannot vary, fields of a later version); `*bsdf` is then untouched.
///
/// # Safety
/// `desc` must be good for `desc_size` bytes, its pointers for their counts, its film NULL or a live
/// handle, `bsdf` good for one pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_create(
    desc: *const PellicleBsdfDesc,
    desc_size: size_t,
    bsdf: *mut *mut PellicleBsdf,
) -> PellicleStatus {
    let traps = Traps::of_caller();
    guard(|| {
        require(bsdf, "bsdf")?;
        // SAFETY: checked for NULL by the callees; the caller vouches for sizes and counts. Zero is a valid
        // PellicleBsdfDesc.
        unsafe {
            let desc = read_growing(desc, desc_size, "desc")?;
            let handle = handle_under(traps, Bsdf::new(&description(&desc)?)?);
            bsdf.write_unaligned(handle);
        }
        Ok(())
    })
}

/// Adds a reference to a BSDF: one more pellicle_bsdf_release() is then due. NULL does nothing.
///
/// # Safety
/// `bsdf` must be NULL or a live handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_retain(bsdf: *const PellicleBsdf) {
    guard(|| {
        if !bsdf.is_null() {
            // SAFETY: a live handle came from Arc::into_raw.
            unsafe { Arc::increment_strong_count(bsdf.cast::<BsdfHandle>()) };
        }
        Ok(())
    });
}

/// Gives up a reference to a BSDF; the last one frees it. NULL does nothing.
///
/// # Safety
/// `bsdf` must be NULL or a handle of which the caller owns a reference.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_release(bsdf: *const PellicleBsdf) {
    guard(|| {
        if !bsdf.is_null() {
            // SAFETY: a live handle came from Arc::into_raw.
            unsafe { Arc::decrement_strong_count(bsdf.cast::<BsdfHandle>()) };
        }
        Ok(())
    });
}

/// Tells what a BSDF is.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_info(
    bsdf: *const PellicleBsdf,
    info: *mut PellicleBsdfInfo,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        // SAFETY: the caller vouches for the handle and for `info_size` bytes.
        unsafe {
            let handle = handle(bsdf)?;
            let bsdf = &handle.bsdf;
            let filled = PellicleBsdfInfo {
                model: text(bsdf.info().name),
                flags: bsdf.flags().0,
                varying_count: bsdf.varying_count() as u32,
                varying_floats: bsdf.varying_floats() as u32,
                lobe_count: bsdf.lobe_infos().len() as u32,
                plan: handle.plan.as_ptr(),
            };
            write_growing(info, info_size, &filled);
        }
        Ok(())
    })
}

/// Describes the varying parameter with number `varying`, in declared order, below
/// PellicleBsdfInfo::varying_count; else OUT_OF_RANGE.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_varying(
    bsdf: *const PellicleBsdf,
    varying: size_t,
    info: *mut PellicleVaryingInfo,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        // SAFETY: the caller vouches for the handle and for `info_size` bytes.
        unsafe {
            let bsdf = &handle(bsdf)?.bsdf;
            if varying >= bsdf.varying_count() {
                return Err(Error::out_of_range(format!(
                    "varying = {varying}, but the BSDF has {} varying parameters, counted from 0",
                    bsdf.varying_count()
                )));
            }
            write_growing(info, info_size, &varying_info(bsdf, varying));
        }
        Ok(())
    })
}

/// Describes the lobe with number `lobe`, below PellicleBsdfInfo::lobe_count; else OUT_OF_RANGE.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_lobe(
    bsdf: *const PellicleBsdf,
    lobe: size_t,
    info: *mut PellicleLobeInfo,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        // SAFETY: the caller vouches for the handle and for `info_size` bytes.
        unsafe {
            let all = handle(bsdf)?.bsdf.lobe_infos();
            let described = all.get(lobe).ok_or_else(|| {
                Error::out_of_range(format!(
                    "lobe = {lobe}, but the BSDF has {} lobes, counted from 0",
                    all.len()
                ))
            })?;
            let filled = PellicleLobeInfo {
                name: text(described.name),
                flags: described.flags.0,
            };
            write_growing(info, info_size, &filled);
        }
        Ok(())
    })
}

/// The traps that were unmasked where a handle was made; none for NULL.
///
/// # Safety
/// `bsdf` must be NULL or a live handle.
#[inline(always)]
pub(super) unsafe fn traps(bsdf: *const PellicleBsdf) -> Traps {
    // SAFETY: a live handle came from Arc::into_raw of an Arc<BsdfHandle>.
    let handle = unsafe { bsdf.cast::<BsdfHandle>().as_ref() };
    handle.map_or(Traps::NONE, |handle| handle.traps)
}

/// The object behind a handle.
#[inline(always)]
pub(super) unsafe fn handle<'a>(bsdf: *const PellicleBsdf) -> Result<&'a BsdfHandle, Error> {
    // SAFETY: NULL is refused; a live handle came from Arc::into_raw of an Arc<BsdfHandle>.
    unsafe { reference(bsdf.cast::<BsdfHandle>(), "bsdf") }
}

/// The varying parameter with that number, which must exist.
fn varying_info(bsdf: &Bsdf, place: usize) -> PellicleVaryingInfo {
    let mut offset = 0;
    for before in bsdf.varying().take(place) {
        offset += before.param.components();
    }
    let varying = bsdf.varying().nth(place).expect("the place was checked");
    let mut default_value = [0.0; 3];
    default_value[..varying.defaults.len()].copy_from_slice(varying.defaults);
    PellicleVaryingInfo {
        name: text(varying.param.name),
        unit: text(varying.param.unit),
        kind: match varying.param.kind {
            ParamKind::Direction { .. } => PELLICLE_KIND_DIRECTION,
            _ => PELLICLE_KIND_NUMBER,
        },
        components: varying.param.components() as u32,
        offset: offset as u32,
        min: varying.min,
        max: varying.max,
        default_value,
    }
}

/// Copies a description out of the caller's memory.
unsafe fn description(desc: &PellicleBsdfDesc) -> Result<Description, Error> {
    // SAFETY: the caller vouches for strings and counts.
    unsafe {
        let mut description = Description::new(&string(desc.model, "desc->model")?);
        for param in elements(desc.params, desc.param_count, "desc->params")? {
            description = with_param(description, &param)?;
        }
        for range in elements(desc.varying, desc.varying_count, "desc->varying")? {
            let name = string(range.name, "desc->varying[].name")?;
            description = description.vary(&name, range.min, range.max);
        }
        if let Some(film) = film::share(desc.film) {
            description = description.film(film);
        }
        if let Some(level) = optional_string(desc.simd_level, "desc->simd_level")? {
            description = description.simd_level(&level);
        }
        Ok(description)
    }
}

unsafe fn with_param(
    description: Description,
    param: &PellicleParam,
) -> Result<Description, Error> {
    // SAFETY: the caller vouches for strings and counts.
    unsafe {
        let name = string(param.name, "desc->params[].name")?;
        if param.choice.is_null() {
            if param.count > 3 {
                let count = param.count;
                return Err(Error::invalid(format!(
                    "parameter '{name}' has count = {count}; no parameter takes more than 3 numbers"
                )));
            }
            let place = format!("the array of values of parameter '{name}'");
            let values: Vec<f32> = elements(param.values, param.count, &place)?.collect();
            return Ok(description.set(&name, &values));
        }
        if !param.values.is_null() || param.count != 0 {
            return Err(Error::invalid(format!(
                "parameter '{name}' is given both numbers and a choice"
            )));
        }
        Ok(description.choose(&name, &string(param.choice, "desc->params[].choice")?))
    }
}
