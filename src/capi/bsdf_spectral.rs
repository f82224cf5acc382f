//! Spectral calls of a BSDF: up to 16 wavelengths at once.

use super::batch::varying_views;
use super::boundary::{
    check_output, floats, guard, guard_call, numbers, read_growing, require, write_growing,
};
use super::bsdf::{handle, traps};
use super::bsdf_types::{
    PellicleEvalSpectralBatchArgs, PellicleSampleSpectralBatchArgs, PellicleSpectralSample,
};
use super::c_types::size_t;
use super::call::call_options;
use super::types::{PellicleBsdf, PellicleCall, PellicleStatus};
use crate::batch::{self, ConstView, EvalSpectralArgs, SampleSpectralArgs, SpectralInputs};
use crate::bsdf::{AtWavelengths, Bsdf, MAX_SPECTRAL_FLOATS, MAX_VARYING, MAX_WAVELENGTHS};
use crate::error::Error;
use std::mem::MaybeUninit;

/// Evaluates f(wo, wi) |wi.z| at `lambda_count` vacuum wavelengths, nm, and for each the density with which
/// pellicle_bsdf_sample_spectral() finds wi if that wavelength is the hero.
///
/// Films and media are evaluated by wave optics at each wavelength, without clipping; indices given at 645, 525 and
/// 445 nm are interpolated. `varying`: as in pellicle_bsdf_eval(), but each colour (an RGB parameter that is no index)
/// has `lambda_count` numbers instead of 3, one per wavelength; NULL: every varying parameter has its default, which for
/// a colour must be gray. `lambda_nm`: 1 to 16 numbers, else OUT_OF_RANGE; a wavelength that is not finite and above 0
/// or, without `extrapolate` in the film's description, outside the range of a medium's data: OUT_OF_RANGE. `value` and
/// `pdf`: `lambda_count` numbers each; either may be NULL if it is not wanted, not both. `wo`, `wi` and `call` as in
/// pellicle_bsdf_eval().
///
/// UNSUPPORTED: a colour with three different numbers that does not vary, or a `thickness_spread_nm` that varies or is
/// above 0.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_eval_spectral(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    wi: *const f32,
    varying: *const f32,
    call: *const PellicleCall,
    lambda_nm: *const f32,
    lambda_count: size_t,
    value: *mut f32,
    pdf: *mut f32,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(unsafe { traps(bsdf) }, move || {
        // SAFETY: the caller vouches for the handle and the lengths of the arrays.
        unsafe {
            let bsdf = &handle(bsdf)?.bsdf;
            let wo = numbers::<3>(wo, "wo")?.into();
            let wi = numbers::<3>(wi, "wi")?.into();
            let mut room = SpectralArrays::EMPTY;
            let at = at_wavelengths(bsdf, varying, lambda_nm, lambda_count, 0, &mut room)?;
            if pdf.is_null() {
                require(value, "value (and pdf)")?;
            }
            let call = call_options(call)?;
            let [mut values, mut densities] = [[0.0; MAX_WAVELENGTHS]; 2];
            let (values, densities) = (&mut values[..lambda_count], &mut densities[..lambda_count]);
            bsdf.eval_spectral(wo, wi, &at, &call, values, densities)?;
            write(value, values);
            write(pdf, densities);
        }
        Ok(())
    })
}

/// Samples a direction to the light for wavelength number `hero`, and finds for every wavelength the weight and the
/// density that it would have as the hero.
///
/// `pdf`: `lambda_count` numbers, the densities; for a DELTA lobe the probabilities of choosing it. `weight`:
/// `lambda_count` numbers, value / mean of `pdf`; for a DELTA lobe throughput / mean of `pdf`. Either may be NULL if it
/// is not wanted. The weights suit a renderer that draws the hero anew for every call, each wavelength as often as any
/// other. One that keeps the hero along a path multiplies the values, weight times mean of `pdf`, and the densities along
/// it, and divides by the mean of the products. `sample` as in pellicle_bsdf_sample(); the rest as in
/// pellicle_bsdf_eval_spectral().
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size,
/// `sample` good for `sample_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_sample_spectral(
    bsdf: *const PellicleBsdf,
    wo: *const f32,
    u: *const f32,
    varying: *const f32,
    call: *const PellicleCall,
    lambda_nm: *const f32,
    lambda_count: size_t,
    hero: size_t,
    weight: *mut f32,
    pdf: *mut f32,
    sample: *mut PellicleSpectralSample,
    sample_size: size_t,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(unsafe { traps(bsdf) }, move || {
        check_output(sample, sample_size, "sample")?;
        // SAFETY: the caller vouches for the handle, the lengths of the arrays and `sample_size`.
        unsafe {
            let bsdf = &handle(bsdf)?.bsdf;
            let wo = numbers::<3>(wo, "wo")?.into();
            let u = numbers::<3>(u, "u")?.into();
            let mut room = SpectralArrays::EMPTY;
            let at = at_wavelengths(bsdf, varying, lambda_nm, lambda_count, hero, &mut room)?;
            let call = call_options(call)?;
            let [mut weights, mut densities] = [[0.0; MAX_WAVELENGTHS]; 2];
            let (weights, densities) =
                (&mut weights[..lambda_count], &mut densities[..lambda_count]);
            let drawn = bsdf.sample_spectral(wo, u, &at, &call, weights, densities)?;
            write(weight, weights);
            write(pdf, densities);
            let filled = PellicleSpectralSample {
                wi: drawn.wi.to_array(),
                eta: drawn.eta,
                flags: drawn.flags.0,
                lobe: drawn.lobe as u32,
                lobe_probability: drawn.lobe_probability,
                hero_only: drawn.is_hero_only.into(),
            };
            write_growing(sample, sample_size, &filled);
        }
        Ok(())
    })
}

/// Calls pellicle_bsdf_eval_spectral() for every element of strided arrays, each with wavelengths of its own or all with
/// the same; the results are those of single calls, bit for bit. An output with data NULL is not wanted; at least one
/// must be. An output that overlaps an input or another output is undefined behaviour. A wavelength that the single call
/// refuses is refused whichever element it belongs to, and nothing is written.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, `args->call` good for
/// its size, and every address that the views stand for readable or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_eval_spectral_batch(
    bsdf: *const PellicleBsdf,
    args: *const PellicleEvalSpectralBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let bsdf = &handle(bsdf)?.bsdf;
            let args = read_growing(args, args_size, "args")?;
            let mut room = [ConstView::NONE; MAX_VARYING];
            let args = EvalSpectralArgs {
                inputs: SpectralInputs {
                    count: args.count,
                    lambda_count: args.lambda_count,
                    call: call_options(args.call)?,
                    lambda_nm: args.lambda_nm.into(),
                    wo: args.wo.into(),
                    varying: varying_views(args.varying, args.varying_count, &mut room)?,
                },
                wi: args.wi.into(),
                value: args.value.into(),
                pdf: args.pdf.into(),
            };
            batch::eval_spectral(bsdf, &args)
        }
    })
}

/// Calls pellicle_bsdf_sample_spectral() for every element of strided arrays, as pellicle_bsdf_eval_spectral_batch() does
/// for evaluations.
///
/// # Safety
/// As for pellicle_bsdf_eval_spectral_batch().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_sample_spectral_batch(
    bsdf: *const PellicleBsdf,
    args: *const PellicleSampleSpectralBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let bsdf = &handle(bsdf)?.bsdf;
            let args = read_growing(args, args_size, "args")?;
            let mut room = [ConstView::NONE; MAX_VARYING];
            let args = SampleSpectralArgs {
                inputs: SpectralInputs {
                    count: args.count,
                    lambda_count: args.lambda_count,
                    call: call_options(args.call)?,
                    lambda_nm: args.lambda_nm.into(),
                    wo: args.wo.into(),
                    varying: varying_views(args.varying, args.varying_count, &mut room)?,
                },
                hero: args.hero,
                u: args.u.into(),
                wi: args.wi.into(),
                weight: args.weight.into(),
                pdf: args.pdf.into(),
                eta: args.eta.into(),
                flags: args.flags.into(),
                lobe: args.lobe.into(),
                lobe_probability: args.lobe_probability.into(),
                hero_only: args.hero_only.into(),
            };
            batch::sample_spectral(bsdf, &args)
        }
    })
}

/// The arrays of a call, where they lie or, if they are not aligned, as copies in `room`.
///
/// # Safety
/// They must be NULL or as long as the call states.
unsafe fn at_wavelengths<'a>(
    bsdf: &Bsdf,
    varying: *const f32,
    lambda_nm: *const f32,
    lambda_count: usize,
    hero: usize,
    room: &'a mut SpectralArrays,
) -> Result<AtWavelengths<'a>, Error> {
    require(lambda_nm, "lambda_nm")?;
    bsdf.check_wavelength_count(lambda_count, hero)?;
    // SAFETY: the caller vouches for `lambda_count` wavelengths and for all the values of what varies.
    unsafe {
        Ok(AtWavelengths {
            lambda_nm: floats(lambda_nm, lambda_count, &mut room.lambda_nm),
            hero,
            varying: if varying.is_null() {
                None
            } else {
                let count = bsdf.spectral_varying_floats(lambda_count);
                Some(floats(varying, count, &mut room.varying))
            },
        })
    }
}

/// Memory for copies of arrays, used for those that are not aligned.
struct SpectralArrays {
    lambda_nm: MaybeUninit<[f32; MAX_WAVELENGTHS]>,
    varying: MaybeUninit<[f32; MAX_SPECTRAL_FLOATS]>,
}

impl SpectralArrays {
    const EMPTY: Self = Self {
        lambda_nm: MaybeUninit::uninit(),
        varying: MaybeUninit::uninit(),
    };
}

/// Writes an output, if it is wanted.
unsafe fn write(target: *mut f32, source: &[f32]) {
    if target.is_null() {
        return;
    }
    for (i, number) in source.iter().enumerate() {
        // SAFETY: the caller vouches for as many numbers.
        unsafe { target.add(i).write_unaligned(*number) };
    }
}
