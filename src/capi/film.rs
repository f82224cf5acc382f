//! Film handles and single calls.

use super::boundary::{
    check_output, guard, quiet_panics, read_growing, reference, refuse_null, require, slice,
    write_growing,
};
use super::film_description::film_description;
use super::text::text;
use super::types::{
    PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE, PellicleFilm, PellicleFilmDesc, PellicleFilmPlan,
    PellicleStatus,
};
use crate::error::Error;
use crate::film::Film;
use crate::optics::stack::Side;
use libc::size_t;
use std::ffi::CString;
use std::sync::Arc;

/// What a handle points to: the film, which BSDFs share, and the text of its own that C callers are given.
pub(super) struct FilmHandle {
    film: Arc<Film>,
    reason: CString,
}

/// A handle with one reference, for tests that make a film in Rust and call it as C does.
#[doc(hidden)]
pub fn film_handle(film: Arc<Film>) -> *mut PellicleFilm {
    let reason = CString::new(film.plan().reason.as_str()).unwrap_or_default();
    let handle = Arc::new(FilmHandle { film, reason });
    Arc::into_raw(handle).cast_mut().cast()
}

/// Creates a film: validates the description, chooses and compiles the method that evaluates it, and
/// stores a handle with one reference in `*film`. Meant for loading, not for shading.
///
/// Fails with UNKNOWN_NAME (medium, white, color_space, method), OUT_OF_RANGE (numbers, the number of
/// layers), INVALID_ARGUMENT (NULL, a medium missing or given in two ways, two layers that vary),
/// UNSUPPORTED (a method that does not take such a film, fields of a later version) or OUT_OF_MEMORY;
/// `*film` is then untouched.
///
/// # Safety
/// `desc` must be good for `desc_size` bytes, its pointers for their counts, `film` for one pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_create(
    desc: *const PellicleFilmDesc,
    desc_size: size_t,
    film: *mut *mut PellicleFilm,
) -> PellicleStatus {
    quiet_panics();
    guard(|| {
        require(film, "film")?;
        // SAFETY: checked for NULL by the callees; the caller vouches for sizes and counts. Zero is
        // a valid PellicleFilmDesc.
        let description = unsafe { film_description(&read_growing(desc, desc_size, "desc")?)? };
        let handle = film_handle(Arc::new(Film::new(&description)?));
        // SAFETY: not NULL, and the caller vouches that it is writable.
        unsafe { film.write_unaligned(handle) };
        Ok(())
    })
}

/// Adds a reference to a film: one more pellicle_film_release() is then due.
///
/// # Safety
/// `film` must be NULL (refused) or a handle that has not been released.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_retain(film: *mut PellicleFilm) -> PellicleStatus {
    guard(|| {
        require(film, "film")?;
        // SAFETY: a live handle came from Arc::into_raw.
        unsafe { Arc::increment_strong_count(film.cast_const().cast::<FilmHandle>()) };
        Ok(())
    })
}

/// Gives up a reference to a film; the last one frees it. NULL does nothing. A BSDF made with the
/// film holds a reference of its own.
///
/// # Safety
/// `film` must be NULL or a handle of which a reference is owned.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_release(film: *mut PellicleFilm) {
    if !film.is_null() {
        guard(|| {
            // SAFETY: a live handle came from Arc::into_raw.
            unsafe { Arc::decrement_strong_count(film.cast_const().cast::<FilmHandle>()) };
            Ok(())
        });
    }
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
            let FilmHandle { film, reason } = reference(film.cast::<FilmHandle>(), "film")?;
            let found = film.plan();
            let filled = PellicleFilmPlan {
                method: text(found.method),
                tolerance: found.tolerance as f32,
                measured_max: found.measured_max as f32,
                measured_rms: found.measured_rms as f32,
                bytes: found.bytes,
                reason: reason.as_ptr(),
            };
            write_growing(plan, plan_size, &filled);
        }
        Ok(())
    })
}

/// Reflectance of unpolarised light from the ambient's side, RGB, into `rgb` (3 numbers).
///
/// `cos_theta`: cosine of incidence in the ambient medium, clamped to [1e-9, 1]. `thickness_nm`: of the
/// layer that varies, clamped to its range, infinities too; if none varies, any number. NaN in either
/// gives 0.
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, `rgb` NULL (refused) or good for 3 numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_reflectance(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    rgb: *mut f32,
) -> PellicleStatus {
    // Refused apart, so that the numbers stay in their registers.
    if film.is_null() || rgb.is_null() {
        return refuse_null(if rgb.is_null() { "rgb" } else { "film" });
    }
    guard(|| {
        // SAFETY: the caller vouches for the handle and for 3 numbers.
        unsafe {
            write(
                rgb,
                (*film.cast::<FilmHandle>())
                    .film
                    .reflectance(cos_theta, thickness_nm),
            )
        };
        Ok(())
    })
}

/// Reflectance and transmittance of unpolarised light from either side, as fractions of its power,
/// RGB. A film created without `transmittance` has neither: UNSUPPORTED.
///
/// `side`: PELLICLE_SIDE_AMBIENT or PELLICLE_SIDE_BASE, where the light comes from and `cos_theta` is
/// measured; any other: OUT_OF_RANGE. A base that absorbs sends no light: everything is 0 from its
/// side. `cos_theta` and `thickness_nm` as in pellicle_film_reflectance(). `reflectance`,
/// `transmittance`: 3 numbers each; either may be NULL if not wanted, not both.
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, the outputs NULL or good for 3 numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_eval(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    side: u32,
    reflectance: *mut f32,
    transmittance: *mut f32,
) -> PellicleStatus {
    guard(|| {
        if transmittance.is_null() {
            require(reflectance, "reflectance (and transmittance)")?;
        }
        // SAFETY: the caller vouches for the handle and for 3 numbers each.
        unsafe {
            let colors = handle(film)?.colors(known_side(side)?, cos_theta, thickness_nm)?;
            if !reflectance.is_null() {
                write(reflectance, colors.reflectance);
            }
            if !transmittance.is_null() {
                write(transmittance, colors.transmittance);
            }
        }
        Ok(())
    })
}

/// What pellicle_film_reflectance() approximates: the reflectance by full wave optics, converged and
/// never clipped. Slow (25 microseconds and up); it allocates. Call it to check, not to shade.
///
/// # Safety
/// As for pellicle_film_reflectance().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_reference(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    rgb: *mut f32,
) -> PellicleStatus {
    guard(|| {
        require(rgb, "rgb")?;
        // SAFETY: the caller vouches for the handle and for 3 numbers.
        unsafe {
            let found = handle(film)?.reference(f64::from(cos_theta), f64::from(thickness_nm));
            write(rgb, found.map(|channel| channel as f32));
        }
        Ok(())
    })
}

/// Reflectance of unpolarised light from the ambient's side at single wavelengths, by full wave
/// optics, for spectral renderers. Allocates.
///
/// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0: OUT_OF_RANGE.
/// Named media are constant outside 380-780 nm. `reflectance`: `count` numbers; may be `lambda_nm`'s
/// own memory, not otherwise overlap it. `cos_theta` and `thickness_nm` as in
/// pellicle_film_reflectance().
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, the arrays NULL (refused, unless `count` is 0) or
/// good for `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_spectrum(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    lambda_nm: *const f32,
    count: size_t,
    reflectance: *mut f32,
) -> PellicleStatus {
    guard(|| {
        // SAFETY: the caller vouches for the handle and for `count` numbers each.
        unsafe {
            let film = handle(film)?;
            check_wavelengths(lambda_nm, count)?;
            if count > 0 {
                require(reflectance, "reflectance")?;
            }
            let (cos_theta, thickness_nm) = (f64::from(cos_theta), f64::from(thickness_nm));
            for i in 0..count {
                let wavelength_nm = f64::from(lambda_nm.add(i).read());
                let found = film.spectrum(cos_theta, thickness_nm, wavelength_nm);
                reflectance.add(i).write(found as f32);
            }
        }
        Ok(())
    })
}

/// The film behind a handle.
#[inline(always)]
pub(super) unsafe fn handle<'a>(film: *const PellicleFilm) -> Result<&'a Film, Error> {
    // SAFETY: NULL is refused; a live handle came from Arc::into_raw of an Arc<FilmHandle>.
    unsafe { reference(film.cast::<FilmHandle>(), "film") }.map(|handle| &*handle.film)
}

/// A reference of our own to the film behind a handle; none for NULL.
pub(super) unsafe fn share(film: *const PellicleFilm) -> Option<Arc<Film>> {
    // SAFETY: a live handle came from Arc::into_raw of an Arc<FilmHandle>.
    let handle = unsafe { film.cast::<FilmHandle>().as_ref() };
    handle.map(|handle| Arc::clone(&handle.film))
}

#[inline(always)]
unsafe fn write(target: *mut f32, rgb: [f32; 3]) {
    // SAFETY: the caller vouches for 3 numbers.
    unsafe { target.cast::<[f32; 3]>().write_unaligned(rgb) }
}

#[inline(always)]
fn known_side(side: u32) -> Result<Side, Error> {
    match side {
        PELLICLE_SIDE_AMBIENT => Ok(Side::Ambient),
        PELLICLE_SIDE_BASE => Ok(Side::Base),
        _ => Err(wrong_side(side)),
    }
}

#[cold]
fn wrong_side(side: u32) -> Error {
    Error::out_of_range(format!(
        "side = {side} is neither {PELLICLE_SIDE_AMBIENT} (ambient) nor {PELLICLE_SIDE_BASE} (base)"
    ))
}

/// Before anything is written: outputs stay untouched if one wavelength is wrong.
unsafe fn check_wavelengths(lambda_nm: *const f32, count: usize) -> Result<(), Error> {
    // SAFETY: the caller vouches for `count` numbers.
    let given = unsafe { slice(lambda_nm, count, "lambda_nm")? };
    match given.iter().position(|nm| !(nm.is_finite() && *nm > 0.0)) {
        Some(at) => Err(Error::out_of_range(format!(
            "lambda_nm[{at}] = {} is not finite and above 0",
            given[at]
        ))),
        None => Ok(()),
    }
}
