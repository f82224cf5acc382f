//! Batch calls.

use super::boundary::{elements, guard, read_growing};
use super::bsdf_types::{PellicleEvalBatchArgs, PellicleSampleBatchArgs};
use super::c_types::size_t;
use super::call::call_options;
use super::film_calls::known_side;
use super::film_types::{PellicleAmplitudesBatchArgs, PellicleFilmBatchArgs};
use super::types::{
    PellicleBsdf, PellicleConstView, PellicleFilm, PellicleStatus, PellicleUintView, PellicleView,
};
use super::{bsdf, film};
use crate::batch::{self, AmplitudeArgs, ConstView, EvalArgs, FilmArgs, SampleArgs, View};
use crate::bsdf::MAX_VARYING;
use crate::error::Error;

/// Calls pellicle_bsdf_eval() for every element of strided arrays; the results are those of single calls, bit
/// for bit. An output with data NULL is not wanted; at least one must be.
///
/// An output may be an input's own memory with the same strides. Any other overlap of an output with an
/// input or another output is undefined behaviour.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, `args->call` good for
/// its size, and every address that the views stand for readable or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_eval_batch(
    bsdf: *const PellicleBsdf,
    args: *const PellicleEvalBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let bsdf = &bsdf::handle(bsdf)?.bsdf;
            let args = read_growing(args, args_size, "args")?;
            let mut room = [ConstView::NONE; MAX_VARYING];
            let args = EvalArgs {
                count: args.count,
                call: call_options(args.call)?,
                wo: args.wo.into(),
                wi: args.wi.into(),
                varying: varying_views(args.varying, args.varying_count, &mut room)?,
                value: args.value.into(),
                pdf: args.pdf.into(),
                pdf_reverse: args.pdf_reverse.into(),
            };
            batch::eval(bsdf, &args, bsdf.level())
        }
    })
}

/// Calls pellicle_bsdf_sample() for every element of strided arrays; the results are those of single calls,
/// bit for bit. An output with data NULL is not wanted; at least one must be. Overlap is as for
/// pellicle_bsdf_eval_batch().
///
/// # Safety
/// As for pellicle_bsdf_eval_batch().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_sample_batch(
    bsdf: *const PellicleBsdf,
    args: *const PellicleSampleBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let bsdf = &bsdf::handle(bsdf)?.bsdf;
            let args = read_growing(args, args_size, "args")?;
            let mut room = [ConstView::NONE; MAX_VARYING];
            let args = SampleArgs {
                count: args.count,
                call: call_options(args.call)?,
                wo: args.wo.into(),
                u: args.u.into(),
                varying: varying_views(args.varying, args.varying_count, &mut room)?,
                wi: args.wi.into(),
                pdf: args.pdf.into(),
                weight: args.weight.into(),
                eta: args.eta.into(),
                flags: args.flags.into(),
                lobe: args.lobe.into(),
                lobe_probability: args.lobe_probability.into(),
            };
            batch::sample(bsdf, &args, bsdf.level())
        }
    })
}

/// Calls pellicle_film_reflectance() for every element of strided arrays; the results are those of single
/// calls, bit for bit. Overlap is as for pellicle_bsdf_eval_batch().
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, and every
/// address that its views stand for readable or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_reflectance_batch(
    film: *const PellicleFilm,
    args: *const PellicleFilmBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let handle = film::handle(film)?;
            let args = read_growing(args, args_size, "args")?;
            let args = FilmArgs {
                count: args.count,
                cos_theta: args.cos_theta.into(),
                thickness_nm: args.thickness_nm.into(),
                reflectance: args.reflectance.into(),
                thickness_spread_nm: args.thickness_spread_nm.into(),
            };
            batch::film_reflectance(&handle.film, &args, handle.level)
        }
    })
}

/// Calls pellicle_film_amplitudes() for every element of strided arrays, each with wavelengths of its own or all
/// with the same; the results are those of single calls, bit for bit. An output with data NULL is not wanted; at
/// least one must be. An output that overlaps an input or another output is undefined behaviour.
///
/// A wavelength that pellicle_film_amplitudes() refuses is OUT_OF_RANGE, whichever element it belongs to, and
/// nothing is written.
///
/// # Safety
/// As for pellicle_film_reflectance_batch().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_amplitudes_batch(
    film: *const PellicleFilm,
    args: *const PellicleAmplitudesBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let handle = film::handle(film)?;
            let args = read_growing(args, args_size, "args")?;
            let args = AmplitudeArgs {
                count: args.count,
                lambda_count: args.lambda_count,
                side: known_side(args.side)?,
                lambda_nm: args.lambda_nm.into(),
                cos_theta: args.cos_theta.into(),
                thickness_nm: args.thickness_nm.into(),
                outputs: [args.r_s, args.r_p, args.t_s, args.t_p].map(View::from),
            };
            batch::film_amplitudes(&handle.film, &args)
        }
    })
}

/// Copies the views of varying parameters, which may lie at any alignment.
pub(super) unsafe fn varying_views(
    varying: *const PellicleConstView,
    count: usize,
    room: &mut [ConstView; MAX_VARYING],
) -> Result<&[ConstView], Error> {
    if count > MAX_VARYING {
        return Err(Error::invalid(format!(
            "args->varying_count = {count} exceeds {MAX_VARYING}"
        )));
    }
    // SAFETY: the caller vouches for `count` views.
    let views = unsafe { elements(varying, count, "args->varying")? };
    for (target, view) in room.iter_mut().zip(views) {
        *target = view.into();
    }
    Ok(&room[..count])
}

impl From<PellicleConstView> for ConstView {
    fn from(view: PellicleConstView) -> Self {
        Self {
            data: view.data,
            element_stride: view.element_stride,
            component_stride: view.component_stride,
        }
    }
}

impl From<PellicleView> for View {
    fn from(view: PellicleView) -> Self {
        Self {
            data: view.data,
            element_stride: view.element_stride,
            component_stride: view.component_stride,
        }
    }
}

impl From<PellicleUintView> for View<u32> {
    fn from(view: PellicleUintView) -> Self {
        Self {
            data: view.data,
            element_stride: view.element_stride,
            component_stride: 0,
        }
    }
}
