//! Batch calls.

use super::boundary::{elements, guard, read_growing};
use super::bsdf_types::{PellicleEvalBatchArgs, PellicleSampleBatchArgs};
use super::call::call_options;
use super::film_types::PellicleFilmBatchArgs;
use super::types::{
    PellicleBsdf, PellicleConstView, PellicleFilm, PellicleStatus, PellicleUintView, PellicleView,
};
use super::{bsdf, film, stand_in};
use crate::batch::{self, ConstView, EvalArgs, FilmArgs, SampleArgs, View};
use crate::bsdf::MAX_VARYING;
use crate::error::Error;
use libc::size_t;

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
            let handle = bsdf::handle(bsdf)?;
            let args = read_growing(args, args_size, "args")?;
            call_options(args.call)?;
            let mut room = [NO_VIEW; MAX_VARYING];
            let core = EvalArgs {
                count: args.count,
                wo: args.wo.into(),
                wi: args.wi.into(),
                varying: varying_views(args.varying, args.varying_count, &mut room)?,
                value: args.value.into(),
                pdf: args.pdf.into(),
            };
            // STAND-IN for `EvalArgs::pdf_reverse`.
            let pdf_reverse = View::from(args.pdf_reverse);
            if pdf_reverse.data.is_null() {
                return batch::eval(&handle.bsdf, &core, handle.level);
            }
            pdf_reverse.check("pdf_reverse", 1, args.count)?;
            let mut none = [0.0_f32; 3];
            let mut with_output = core;
            if core.value.data.is_null() && core.pdf.data.is_null() {
                with_output.value.data = none.as_mut_ptr();
                (
                    with_output.value.element_stride,
                    with_output.value.component_stride,
                ) = (0, 4);
            }
            batch::eval(
                &handle.bsdf,
                &EvalArgs {
                    count: 0,
                    ..with_output
                },
                handle.level,
            )?;
            core.wo.check("wo", 3, args.count)?;
            core.wi.check("wi", 3, args.count)?;
            core.value.check("value", 3, args.count)?;
            core.pdf.check("pdf", 1, args.count)?;
            stand_in::check_varying(&handle.bsdf, core.varying, args.count)?;
            let inputs = [&core.wo, &core.wi];
            let found = stand_in::for_each(
                &handle.bsdf,
                args.count,
                inputs,
                core.varying,
                |wo, wi, varying| stand_in::pdf_reverse(&handle.bsdf, wo, wi, varying),
            );
            batch::eval(&handle.bsdf, &with_output, handle.level)?;
            stand_in::store(&pdf_reverse, &found);
            Ok(())
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
            let handle = bsdf::handle(bsdf)?;
            let args = read_growing(args, args_size, "args")?;
            call_options(args.call)?;
            let mut room = [NO_VIEW; MAX_VARYING];
            let core = SampleArgs {
                count: args.count,
                wo: args.wo.into(),
                u: args.u.into(),
                varying: varying_views(args.varying, args.varying_count, &mut room)?,
                wi: args.wi.into(),
                pdf: args.pdf.into(),
                weight: args.weight.into(),
                eta: args.eta.into(),
                flags: args.flags.into(),
                lobe: args.lobe.into(),
            };
            // STAND-IN for `SampleArgs::lobe_probability`.
            let lobe_probability = View::from(args.lobe_probability);
            if lobe_probability.data.is_null() {
                return batch::sample(&handle.bsdf, &core, handle.level);
            }
            lobe_probability.check("lobe_probability", 1, args.count)?;
            core.wo.check("wo", 3, args.count)?;
            core.u.check("u", 3, args.count)?;
            core.wi.check("wi", 3, args.count)?;
            core.weight.check("weight", 3, args.count)?;
            for (view, name) in [(core.pdf, "pdf"), (core.eta, "eta")] {
                view.check(name, 1, args.count)?;
            }
            for (view, name) in [(core.flags, "flags"), (core.lobe, "lobe")] {
                view.check(name, 1, args.count)?;
            }
            stand_in::check_varying(&handle.bsdf, core.varying, args.count)?;
            let outputs = [core.wi, core.pdf, core.weight, core.eta];
            let is_alone = outputs.iter().all(|view| view.data.is_null())
                && core.flags.data.is_null()
                && core.lobe.data.is_null();
            if !is_alone {
                batch::sample(&handle.bsdf, &SampleArgs { count: 0, ..core }, handle.level)?;
            }
            let found = stand_in::for_each(
                &handle.bsdf,
                args.count,
                [&core.wo, &core.u],
                core.varying,
                |wo, u, varying| {
                    let sample = handle.bsdf.sample(wo, u, varying);
                    stand_in::lobe_probability(&handle.bsdf, wo, &sample, varying)
                },
            );
            if !is_alone {
                batch::sample(&handle.bsdf, &core, handle.level)?;
            }
            stand_in::store(&lobe_probability, &found);
            Ok(())
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
            };
            batch::film_reflectance(&handle.film, &args, handle.level)
        }
    })
}

const NO_VIEW: ConstView = ConstView {
    data: std::ptr::null(),
    element_stride: 0,
    component_stride: 0,
};

/// Copies the views of varying parameters, which may lie at any alignment.
unsafe fn varying_views(
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
