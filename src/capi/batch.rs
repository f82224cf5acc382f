//! Batch calls.

use super::args::{PellicleEvalBatchArgs, PellicleFilmBatchArgs, PellicleSampleBatchArgs};
use super::boundary::{guard, read_growing, slice};
use super::types::{
    PellicleBsdf, PellicleConstView, PellicleFilm, PellicleStatus, PellicleUintView, PellicleView,
};
use super::{bsdf, film};
use crate::batch::{self, ConstView, EvalArgs, FilmArgs, SampleArgs, View};
use crate::bsdf::{Call, MAX_VARYING};
use crate::error::Error;
use crate::num::Level;
use libc::size_t;

/// pellicle_bsdf_eval() for every element of strided arrays, equal to it bit for bit. `value` or
/// `pdf` may have data NULL if not wanted, not both. An output may be an input's own memory with
/// the same strides, otherwise outputs must not overlap inputs or each other.
///
/// # Safety
/// `bsdf` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, and every
/// address that its views stand for readable or writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_bsdf_eval_batch(
    bsdf: *const PellicleBsdf,
    args: *const PellicleEvalBatchArgs,
    args_size: size_t,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for handle, size and views. Zero is a valid value of the args.
        unsafe {
            let bsdf = bsdf::handle(bsdf)?;
            let args = read_growing(args, args_size, "args")?;
            let args = EvalArgs {
                count: args.count,
                call: Call::default(),
                wo: args.wo.into(),
                wi: args.wi.into(),
                varying: varying_views(args.varying, args.varying_count)?,
                value: args.value.into(),
                pdf: args.pdf.into(),
                pdf_reverse: NO_VIEW,
            };
            batch::eval(bsdf, &args, bsdf.level())
        }
    })
}

/// pellicle_bsdf_sample() for every element of strided arrays, equal to it bit for bit. Outputs with
/// data NULL are not wanted; at least one must be. Overlap as in pellicle_bsdf_eval_batch().
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
            let bsdf = bsdf::handle(bsdf)?;
            let args = read_growing(args, args_size, "args")?;
            let args = SampleArgs {
                count: args.count,
                call: Call::default(),
                wo: args.wo.into(),
                u: args.u.into(),
                varying: varying_views(args.varying, args.varying_count)?,
                wi: args.wi.into(),
                pdf: args.pdf.into(),
                weight: args.weight.into(),
                eta: args.eta.into(),
                flags: args.flags.into(),
                lobe: args.lobe.into(),
                lobe_probability: NO_VIEW,
            };
            batch::sample(bsdf, &args, bsdf.level())
        }
    })
}

/// pellicle_film_reflectance() for every element of strided arrays, equal to it bit for bit. Overlap
/// as in pellicle_bsdf_eval_batch().
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
            let film = film::handle(film)?;
            let args = read_growing(args, args_size, "args")?;
            let args = FilmArgs {
                count: args.count,
                cos_theta: args.cos_theta.into(),
                thickness_nm: args.thickness_nm.into(),
                reflectance: args.reflectance.into(),
            };
            batch::film_reflectance(film, &args, Level::widest())
        }
    })
}

const NO_VIEW: View = View {
    data: std::ptr::null_mut(),
    element_stride: 0,
    component_stride: 0,
};

unsafe fn varying_views<'a>(
    varying: *const PellicleConstView,
    count: usize,
) -> Result<&'a [ConstView], Error> {
    if count > MAX_VARYING {
        return Err(Error::invalid(format!(
            "args->varying_count = {count} exceeds {MAX_VARYING}"
        )));
    }
    // Both views are `repr(C)` and have the same fields.
    const _: () = assert!(size_of::<PellicleConstView>() == size_of::<ConstView>());
    // SAFETY: the caller vouches for `count` views.
    unsafe { slice(varying.cast(), count, "args->varying") }
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
