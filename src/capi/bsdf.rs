//! BSDF handles and single calls.

use super::boundary::{
    check_output, guard, numbers, quiet_panics, read_growing, reference, require, slice, string,
    write_growing,
};
use super::film;
use super::text::text;
use super::types::{
    PellicleBsdf, PellicleBsdfDesc, PellicleBsdfInfo, PellicleParam, PellicleSample, PellicleStatus,
};
use crate::bsdf::{Bsdf, Call, Description};
use crate::error::Error;
use libc::size_t;
use std::ffi::CString;
use std::sync::Arc;

/// What a handle points to: the BSDF and the texts of its own that C callers are given.
pub(super) struct BsdfHandle {
    bsdf: Bsdf,
    plan: CString,
}

/// A handle with one reference, for tests that make a BSDF in Rust and call it as C does.
#[doc(hidden)]
pub fn bsdf_handle(bsdf: Bsdf) -> *mut PellicleBsdf {
    let plan = CString::new(bsdf.plan()).unwrap_or_default();
    let handle = Arc::new(BsdfHandle { bsdf, plan });
    Arc::into_raw(handle).cast_mut().cast()
}

/// Creates a BSDF: validates the description, compiles it, and stores a handle with one reference in
/// `*bsdf`.
///
/// Fails with UNKNOWN_NAME (model, parameter, choice), OUT_OF_RANGE (numbers, ranges, sums),
/// INVALID_ARGUMENT (NULL, wrong count, something given twice, a film too many or too few) or
/// UNSUPPORTED (a parameter that cannot vary, fields of a later version); `*bsdf` is then untouched.
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
    quiet_panics();
    guard(|| {
        require(bsdf, "bsdf")?;
        // SAFETY: checked for NULL by the callees; the caller vouches for sizes and counts. Zero is
        // a valid PellicleBsdfDesc.
        let description = unsafe { description(&read_growing(desc, desc_size, "desc")?)? };
        let handle = bsdf_handle(Bsdf::new(&description)?);
        // SAFETY: not NULL, and the caller vouches that it is writable.
        unsafe { bsdf.write_unaligned(handle) };
        Ok(())
    })
}

/// Adds a reference to a BSDF: one more pellicle_bsdf_release() is then due.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a handle that has not been released.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_retain(bsdf: *mut PellicleBsdf) -> PellicleStatus {
    guard(|| {
        require(bsdf, "bsdf")?;
        // SAFETY: a live handle came from Arc::into_raw.
        unsafe { Arc::increment_strong_count(bsdf.cast_const().cast::<BsdfHandle>()) };
        Ok(())
    })
}

/// Gives up a reference to a BSDF; the last one frees it. NULL does nothing.
///
/// # Safety
/// `bsdf` must be NULL or a handle of which a reference is owned.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_release(bsdf: *mut PellicleBsdf) {
    if !bsdf.is_null() {
        guard(|| {
            // SAFETY: a live handle came from Arc::into_raw.
            unsafe { Arc::decrement_strong_count(bsdf.cast_const().cast::<BsdfHandle>()) };
            Ok(())
        });
    }
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
            let BsdfHandle { bsdf, plan } = reference(bsdf.cast::<BsdfHandle>(), "bsdf")?;
            let filled = PellicleBsdfInfo {
                model: text(bsdf.info().name),
                flags: bsdf.flags().0,
                varying_count: bsdf.varying_count() as u32,
                varying_floats: bsdf.varying_floats() as u32,
                lobe_count: bsdf.lobe_infos().len() as u32,
                plan: plan.as_ptr(),
            };
            write_growing(info, info_size, &filled);
        }
        Ok(())
    })
}

/// Evaluates f(wo, wi) |wi.z| and the density with which pellicle_bsdf_sample() finds wi.
///
/// `wo`, `wi`: 3 numbers each. `varying`: PellicleBsdfInfo::varying_floats numbers, the components
/// of the varying parameters one after another in declared order; NULL takes the values from the
/// description. `value`: 3 numbers; `pdf`: one; either may be NULL if not wanted, not both.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_eval(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    wi: *const f32,
    varying: *const f32,
    value: *mut f32,
    pdf: *mut f32,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for the handle and the lengths of the arrays.
        unsafe {
            let bsdf = handle(bsdf)?;
            let wo = numbers::<3>(wo, "wo")?.into();
            let wi = numbers::<3>(wi, "wi")?.into();
            let varying = varying_numbers(bsdf, varying);
            if pdf.is_null() {
                require(value, "value (and pdf)")?;
                value.cast::<[f32; 3]>().write_unaligned(bsdf.eval(
                    wo,
                    wi,
                    varying,
                    &Call::default(),
                ));
                return Ok(());
            }
            let (rgb, density) = bsdf.eval_pdf(wo, wi, varying, &Call::default());
            if !value.is_null() {
                value.cast::<[f32; 3]>().write_unaligned(rgb);
            }
            pdf.write_unaligned(density);
        }
        Ok(())
    })
}

/// Samples a direction to the light. `u`: 3 uniform random numbers in [0, 1); the first chooses the
/// lobe. `varying` as in pellicle_bsdf_eval(). Without a valid sample everything in `sample` is 0.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `sample` good for
/// `sample_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_sample(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    u: *const f32,
    varying: *const f32,
    sample: *mut PellicleSample,
    sample_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(sample, sample_size, "sample")?;
        // SAFETY: the caller vouches for the handle, the lengths of the arrays and `sample_size`.
        unsafe {
            let bsdf = handle(bsdf)?;
            let wo = numbers::<3>(wo, "wo")?.into();
            let u = numbers::<3>(u, "u")?.into();
            let sampled = bsdf.sample(wo, u, varying_numbers(bsdf, varying), &Call::default());
            let filled = PellicleSample {
                wi: sampled.wi.to_array(),
                pdf: sampled.pdf,
                weight: sampled.weight,
                eta: sampled.eta,
                flags: sampled.flags.0,
                lobe: sampled.lobe as u32,
            };
            write_growing(sample, sample_size, &filled);
        }
        Ok(())
    })
}

/// Directional albedo: the integral of the value over wi, Dirac lobes included, RGB, into `albedo` (3
/// numbers). `varying` as in pellicle_bsdf_eval(). By quadrature, which takes some milliseconds, unless the model has
/// a closed form; call it when preparing, not when shading. Transmitted light counts as radiance: seen
/// from within a dense base the albedo exceeds 1.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_albedo(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    varying: *const f32,
    albedo: *mut f32,
) -> PellicleStatus {
    guard(|| {
        require(albedo, "albedo")?;
        // SAFETY: the caller vouches for the handle and the lengths of the arrays.
        unsafe {
            let bsdf = handle(bsdf)?;
            let wo = numbers::<3>(wo, "wo")?.into();
            let rgb = bsdf.albedo(wo, varying_numbers(bsdf, varying), &Call::default());
            albedo.cast::<[f32; 3]>().write_unaligned(rgb);
        }
        Ok(())
    })
}

/// The BSDF behind a handle.
#[inline(always)]
pub(super) unsafe fn handle<'a>(bsdf: *const PellicleBsdf) -> Result<&'a Bsdf, Error> {
    // SAFETY: NULL is refused; a live handle came from Arc::into_raw of an Arc<BsdfHandle>.
    unsafe { reference(bsdf.cast::<BsdfHandle>(), "bsdf") }.map(|handle| &handle.bsdf)
}

#[inline(always)]
unsafe fn varying_numbers<'a>(bsdf: &Bsdf, varying: *const f32) -> Option<&'a [f32]> {
    // SAFETY: the caller vouches that a varying array holds all the BSDF's varying numbers.
    (!varying.is_null())
        .then(|| unsafe { std::slice::from_raw_parts(varying, bsdf.varying_floats()) })
}

/// Copies a description out of the caller's memory.
unsafe fn description(desc: &PellicleBsdfDesc) -> Result<Description, Error> {
    // SAFETY: the caller vouches for strings and counts.
    unsafe {
        let mut description = Description::new(&string(desc.model, "desc->model")?);
        for param in slice(desc.params, desc.param_count, "desc->params")? {
            description = with_param(description, param)?;
        }
        for range in slice(desc.varying, desc.varying_count, "desc->varying")? {
            let name = string(range.name, "desc->varying[].name")?;
            description = description.vary(&name, range.min, range.max);
        }
        if let Some(film) = film::share(desc.film) {
            description = description.film(film);
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
            if param.values.is_null() && param.count > 0 {
                return Err(Error::invalid(format!(
                    "parameter '{name}' has values = NULL and count = {}",
                    param.count
                )));
            }
            let values = slice(param.values, param.count, "values")?;
            return Ok(description.set(&name, values));
        }
        if !param.values.is_null() || param.count != 0 {
            return Err(Error::invalid(format!(
                "parameter '{name}' is given both numbers and a choice"
            )));
        }
        Ok(description.choose(&name, &string(param.choice, "desc->params[].choice")?))
    }
}
