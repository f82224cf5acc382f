//! Film handles: creation, reference counts and queries.

use super::boundary::{
    check_output, guard, optional_string, read_growing, reference, require, write_growing,
};
use super::c_types::size_t;
use super::film_description::film_description;
use super::film_types::{
    PellicleFilmDesc, PellicleFilmInfo, PellicleFilmPlan, PellicleFilmSidePlan,
};
use super::float_control::Traps;
use super::text::text;
use super::types::{PellicleFilm, PellicleStatus};
use crate::error::Error;
use crate::film::{DIRECTION_NM, Film, SidePlan};
use crate::num::Level;
use crate::optics::stack::Side;
use std::ffi::CString;
use std::ptr::null;
use std::sync::Arc;

/// The object behind a handle: the film, which BSDFs share, and its texts for C callers.
pub(super) struct FilmHandle {
    pub film: Arc<Film>,
    pub level: Level,
    traps: Traps,
    reason: CString,
}

/// A handle with one reference. Hidden: for tests that make a film in Rust and call it as C does.
///
/// # Errors
/// `UnknownName` for a `simd_level` that this processor does not have.
#[doc(hidden)]
pub fn film_handle(film: Arc<Film>, simd_level: Option<&str>) -> Result<*mut PellicleFilm, Error> {
    handle_under(Traps::NONE, film, simd_level)
}

/// A handle with one reference, which calls use under the traps of its maker.
pub(super) fn handle_under(
    traps: Traps,
    film: Arc<Film>,
    simd_level: Option<&str>,
) -> Result<*mut PellicleFilm, Error> {
    let handle = Arc::new(FilmHandle {
        traps,
        level: simd_level.map_or_else(|| Ok(Level::widest()), Level::named)?,
        reason: CString::new(film.plan().reason.as_str()).unwrap_or_default(),
        film,
    });
    Ok(Arc::into_raw(handle).cast_mut().cast())
}

/// Creates a film: validates the description, chooses and compiles the method that evaluates it, and
/// stores a handle with one reference in `*film`. Call it when loading, not when shading: it takes 10
/// milliseconds to 10 seconds for one layer, and up to two minutes for 64 layers of which one varies.
///
/// Fails with UNKNOWN_NAME (medium, white, color_space, method, level), OUT_OF_RANGE (numbers, the number of
/// layers), INVALID_ARGUMENT (NULL, a wrong size, a medium missing or given in two ways, two layers that
/// vary), UNSUPPORTED (a method that does not take such a film, fields of a later version) or OUT_OF_MEMORY; `*film` is then untouched.
///
/// # Safety
/// `desc` must be good for `desc_size` bytes, its pointers for their counts and sizes, `film` for one pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_create(
    desc: *const PellicleFilmDesc,
    desc_size: size_t,
    film: *mut *mut PellicleFilm,
) -> PellicleStatus {
    let traps = Traps::of_caller();
    guard(|| {
        require(film, "film")?;
        // SAFETY: checked for NULL by the callees; the caller vouches for sizes and counts. Zero is a valid
        // PellicleFilmDesc.
        unsafe {
            let desc = read_growing(desc, desc_size, "desc")?;
            let description = film_description(&desc)?;
            let simd_level = optional_string(desc.simd_level, "simd_level")?;
            // Before the film is compiled, which takes time.
            simd_level.as_deref().map(Level::named).transpose()?;
            let compiled = Arc::new(Film::new(&description)?);
            film.write_unaligned(handle_under(traps, compiled, simd_level.as_deref())?);
        }
        Ok(())
    })
}

/// Adds a reference to a film: one more pellicle_film_release() is then due. NULL does nothing.
///
/// # Safety
/// `film` must be NULL or a live handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_retain(film: *const PellicleFilm) {
    guard(|| {
        if !film.is_null() {
            // SAFETY: a live handle came from Arc::into_raw.
            unsafe { Arc::increment_strong_count(film.cast::<FilmHandle>()) };
        }
        Ok(())
    });
}

/// Gives up a reference to a film; the last one frees it. NULL does nothing. A BSDF made with the
/// film holds a reference of its own.
///
/// # Safety
/// `film` must be NULL or a handle of which the caller owns a reference.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_release(film: *const PellicleFilm) {
    guard(|| {
        if !film.is_null() {
            // SAFETY: a live handle came from Arc::into_raw.
            unsafe { Arc::decrement_strong_count(film.cast::<FilmHandle>()) };
        }
        Ok(())
    });
}

/// Tells what a film is.
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_info(
    film: *const PellicleFilm,
    info: *mut PellicleFilmInfo,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        // SAFETY: the caller vouches for the handle and for `info_size` bytes.
        unsafe {
            let film = &handle(film)?.film;
            let range = film.varying_thickness_nm();
            let [min, max] = range.unwrap_or_default();
            let [lambda_min_nm, lambda_max_nm] = film.description().range_nm().map(|x| x as f32);
            let filled = PellicleFilmInfo {
                varies: u32::from(range.is_some()),
                transmittance: u32::from(film.description().transmittance),
                thickness_min_nm: min as f32,
                thickness_max_nm: max as f32,
                base_opaque: u32::from(film.is_base_opaque()),
                lambda_min_nm,
                lambda_max_nm,
                thickness_spread_max_nm: film.thickness_spread_max_nm(),
                base_attenuation_per_mm: film.base_attenuation_per_mm().map(|x| x as f32),
            };
            write_growing(info, info_size, &filled);
        }
        Ok(())
    })
}

/// Tells how a film is evaluated, and how well.
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, `plan` good for `plan_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_plan(
    film: *const PellicleFilm,
    plan: *mut PellicleFilmPlan,
    plan_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(plan, plan_size, "plan")?;
        // SAFETY: the caller vouches for the handle and for `plan_size` bytes.
        unsafe {
            let FilmHandle { film, reason, .. } = handle(film)?;
            let found = film.plan();
            let side_plan = |side: Side| {
                let plan = found.sides[side as usize];
                let number = |of: fn(&SidePlan) -> f64| plan.as_ref().map_or(0.0, of) as f32;
                PellicleFilmSidePlan {
                    method: plan.map_or(null(), |plan| text(plan.method)),
                    measured_max: number(|plan| plan.measured_max),
                    measured_rms: number(|plan| plan.measured_rms),
                    cost_ns: number(|plan| plan.cost_ns),
                    absorbed_max: number(|plan| plan.absorbed_max),
                }
            };
            let filled = PellicleFilmPlan {
                method: text(found.method),
                tolerance: found.tolerance as f32,
                measured_max: found.measured_max as f32,
                measured_rms: found.measured_rms as f32,
                bytes: found.bytes,
                reason: reason.as_ptr(),
                ambient: side_plan(Side::Ambient),
                base: side_plan(Side::Base),
                eta_ambient: found.eta[0] as f32,
                eta_base: found.eta[1] as f32,
                eta_lambda_nm: DIRECTION_NM as f32,
            };
            write_growing(plan, plan_size, &filled);
        }
        Ok(())
    })
}

/// The traps that were unmasked where a handle was made; none for NULL.
///
/// # Safety
/// `film` must be NULL or a live handle.
#[inline(always)]
pub(super) unsafe fn traps(film: *const PellicleFilm) -> Traps {
    // SAFETY: a live handle came from Arc::into_raw of an Arc<FilmHandle>.
    let handle = unsafe { film.cast::<FilmHandle>().as_ref() };
    handle.map_or(Traps::NONE, |handle| handle.traps)
}

/// The object behind a handle.
#[inline(always)]
pub(super) unsafe fn handle<'a>(film: *const PellicleFilm) -> Result<&'a FilmHandle, Error> {
    // SAFETY: NULL is refused; a live handle came from Arc::into_raw of an Arc<FilmHandle>.
    unsafe { reference(film.cast::<FilmHandle>(), "film") }
}

/// A reference of our own to the film behind a handle; none for NULL.
pub(super) unsafe fn share(film: *const PellicleFilm) -> Option<Arc<Film>> {
    // SAFETY: a live handle came from Arc::into_raw of an Arc<FilmHandle>.
    let handle = unsafe { film.cast::<FilmHandle>().as_ref() };
    handle.map(|handle| Arc::clone(&handle.film))
}
