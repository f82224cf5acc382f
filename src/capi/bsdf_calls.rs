//! Single calls of a BSDF.

use super::boundary::{check_output, floats, guard, guard_call, numbers, require, write_growing};
use super::bsdf::{handle, traps};
use super::bsdf_types::PellicleSample;
use super::c_types::size_t;
use super::call::call_options;
use super::types::{PellicleBsdf, PellicleCall, PellicleStatus};
use crate::bsdf::{Bsdf, MAX_FLOATS};
use std::mem::MaybeUninit;

/// Evaluates f(wo, wi) |wi.z|, the density with which pellicle_bsdf_sample() finds wi from wo, and the
/// density with which it finds wo from wi.
///
/// `wo`, `wi`: 3 numbers each. `varying`: PellicleBsdfInfo::varying_floats numbers, the components of the
/// varying parameters one after another in declared order; NULL gives each its default (see
/// PellicleVaryingInfo). `call`: transport and lobes; NULL means radiance and every lobe. `value`: 3 numbers;
/// `pdf` and `pdf_reverse`: one each, per solid angle. Each output may be NULL if it is not wanted, but not
/// all of them.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_eval(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    wi: *const f32,
    varying: *const f32,
    call: *const PellicleCall,
    value: *mut f32,
    pdf: *mut f32,
    pdf_reverse: *mut f32,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(
        unsafe { traps(bsdf) },
        #[inline(always)]
        move || {
            // SAFETY: the caller vouches for the handle and the lengths of the arrays.
            unsafe {
                let bsdf = &handle(bsdf)?.bsdf;
                let wo = numbers::<3>(wo, "wo")?.into();
                let wi = numbers::<3>(wi, "wi")?.into();
                let mut room = MaybeUninit::uninit();
                let varying = varying_numbers(bsdf, varying, &mut room);
                let call = call_options(call)?;
                // Each set of outputs has a path of its own, on which results stay in registers.
                if pdf_reverse.is_null() && pdf.is_null() {
                    require(value, "value (and pdf and pdf_reverse)")?;
                    write_rgb(value, bsdf.eval(wo, wi, varying, &call));
                    return Ok(());
                }
                if pdf_reverse.is_null() {
                    let (rgb, density) = bsdf.eval_pdf(wo, wi, varying, &call);
                    if !value.is_null() {
                        write_rgb(value, rgb);
                    }
                    pdf.write_unaligned(density);
                    return Ok(());
                }
                let found = bsdf.evaluate(wo, wi, varying, &call);
                if !value.is_null() {
                    write_rgb(value, found.value);
                }
                if !pdf.is_null() {
                    pdf.write_unaligned(found.pdf);
                }
                pdf_reverse.write_unaligned(found.pdf_reverse);
            }
            Ok(())
        },
    )
}

/// Samples a direction to the light. `u`: 3 uniform random numbers in [0, 1); the first chooses the
/// lobe. `varying` and `call` as in pellicle_bsdf_eval(). Without a valid sample everything in `sample` is 0.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size,
/// `sample` good for `sample_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_sample(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    u: *const f32,
    varying: *const f32,
    call: *const PellicleCall,
    sample: *mut PellicleSample,
    sample_size: size_t,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(
        unsafe { traps(bsdf) },
        #[inline(always)]
        move || {
            check_output(sample, sample_size, "sample")?;
            // SAFETY: the caller vouches for the handle, the lengths of the arrays and `sample_size`.
            unsafe {
                let bsdf = &handle(bsdf)?.bsdf;
                let wo = numbers::<3>(wo, "wo")?.into();
                let u = numbers::<3>(u, "u")?.into();
                let mut room = MaybeUninit::uninit();
                let varying = varying_numbers(bsdf, varying, &mut room);
                let call = call_options(call)?;
                let sampled = bsdf.sample(wo, u, varying, &call);
                let filled = PellicleSample {
                    wi: sampled.wi.to_array(),
                    pdf: sampled.pdf,
                    weight: sampled.weight,
                    eta: sampled.eta,
                    flags: sampled.flags.0,
                    lobe: sampled.lobe as u32,
                    lobe_probability: sampled.lobe_probability,
                };
                write_growing(sample, sample_size, &filled);
            }
            Ok(())
        },
    )
}

/// Integrates the value over wi, Dirac lobes included: the directional albedo, RGB, into `albedo` (3
/// numbers). `varying` and `call` as in pellicle_bsdf_eval(). Call it when preparing, not when shading: it is
/// a quadrature of some milliseconds, unless the model has a closed form. As radiance, transmitted light
/// carries (eta_o / eta_i)^2: seen from within a dense base the albedo exceeds 1.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_albedo(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    varying: *const f32,
    call: *const PellicleCall,
    albedo: *mut f32,
) -> PellicleStatus {
    guard(|| {
        require(albedo, "albedo")?;
        // SAFETY: the caller vouches for the handle and the lengths of the arrays.
        unsafe {
            let bsdf = &handle(bsdf)?.bsdf;
            let wo = numbers::<3>(wo, "wo")?.into();
            let mut room = MaybeUninit::uninit();
            let varying = varying_numbers(bsdf, varying, &mut room);
            let call = call_options(call)?;
            write_rgb(albedo, bsdf.albedo(wo, varying, &call));
        }
        Ok(())
    })
}

#[inline(always)]
unsafe fn write_rgb(target: *mut f32, rgb: [f32; 3]) {
    // SAFETY: the caller vouches for 3 numbers.
    unsafe { target.cast::<[f32; 3]>().write_unaligned(rgb) }
}

/// The caller's varying values.
#[inline(always)]
unsafe fn varying_numbers<'a>(
    bsdf: &Bsdf,
    varying: *const f32,
    room: &'a mut MaybeUninit<[f32; MAX_FLOATS]>,
) -> Option<&'a [f32]> {
    if varying.is_null() {
        return None;
    }
    // SAFETY: the caller vouches that a varying array holds all the BSDF's varying numbers.
    Some(unsafe { floats(varying, bsdf.varying_floats(), room) })
}
