//! Single calls of a film.

use super::boundary::{elements, guard, guard_call, guard_call_status, refuse_null, require};
use super::c_types::size_t;
use super::film::{FilmHandle, handle, traps};
use super::float_control::Traps;
use super::types::{
    PELLICLE_OK, PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE, PellicleFilm, PellicleStatus,
};
use crate::error::Error;
use crate::film::Film;
use crate::optics::stack::Side;

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
    // Tested before the guard, in which the two numbers would move from their registers to memory: a tenth of
    // the call's time.
    if film.is_null() || rgb.is_null() {
        return guard_call_status(Traps::NONE, || {
            refuse_null(if film.is_null() { "film" } else { "rgb" })
        });
    }
    // SAFETY: a live handle, as the caller vouches.
    guard_call_status(
        unsafe { traps(film) },
        #[inline(always)]
        move || {
            // SAFETY: not NULL; the caller vouches for the handle and for 3 numbers.
            unsafe {
                let film = &(*film.cast::<FilmHandle>()).film;
                write(rgb, film.reflectance(cos_theta, thickness_nm));
            }
            PELLICLE_OK
        },
    )
}

/// Reflectance and transmittance of unpolarised light from either side, as fractions of its power,
/// RGB. A film created without `transmittance` has neither: UNSUPPORTED.
///
/// `side`: PELLICLE_SIDE_AMBIENT or PELLICLE_SIDE_BASE, where the light comes from and `cos_theta` is
/// measured; any other: OUT_OF_RANGE. A base that is opaque (PellicleFilmInfo::base_opaque) sends
/// no light: everything is 0 from its side. In one that absorbs but is not opaque, light from its side travels as if
/// k were 0 there, which is off by the order of k. From the ambient's side `transmittance` is what enters the base. `cos_theta` and `thickness_nm` as in pellicle_film_reflectance(). `reflectance`,
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
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(
        unsafe { traps(film) },
        #[inline(always)]
        move || {
            if transmittance.is_null() {
                require(reflectance, "reflectance (and transmittance)")?;
            }
            // SAFETY: the caller vouches for the handle and for 3 numbers each.
            unsafe {
                let colors =
                    handle(film)?
                        .film
                        .colors(known_side(side)?, cos_theta, thickness_nm)?;
                if !reflectance.is_null() {
                    write(reflectance, colors.reflectance);
                }
                if !transmittance.is_null() {
                    write(transmittance, colors.transmittance);
                }
            }
            Ok(())
        },
    )
}

/// pellicle_film_reflectance(), averaged over a spread of thickness: that of a pixel, or of a real layer.
///
/// `thickness_spread_nm`: the standard deviation of a normal distribution around `thickness_nm`, which is cut to the
/// range of the layer that varies and renormalised; the mean of the distribution is then not `thickness_nm`. 0: the
/// bits of pellicle_film_reflectance(). Negative, NaN or infinite: OUT_OF_RANGE. Above
/// PellicleFilmDesc::thickness_spread_max_nm: clamped to it; positive where that is 0 or no layer varies:
/// INVALID_ARGUMENT. Colours are averaged before they are clipped. The others as in pellicle_film_reflectance().
/// Spectra and amplitudes know no spread: average pellicle_film_spectrum() over thicknesses of your own.
///
/// # Safety
/// As for pellicle_film_reflectance().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_reflectance_spread(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    thickness_spread_nm: f32,
    rgb: *mut f32,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(unsafe { traps(film) }, move || {
        require(rgb, "rgb")?;
        // SAFETY: the caller vouches for the handle and for 3 numbers.
        unsafe {
            let film = &handle(film)?.film;
            let found = film.reflectance_spread(cos_theta, thickness_nm, thickness_spread_nm)?;
            write(rgb, found);
        }
        Ok(())
    })
}

/// pellicle_film_eval(), averaged over a spread of thickness as in pellicle_film_reflectance_spread(). The averages of
/// a film that does not absorb sum to 1 where its colours do.
///
/// # Safety
/// As for pellicle_film_eval().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_eval_spread(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    thickness_spread_nm: f32,
    side: u32,
    reflectance: *mut f32,
    transmittance: *mut f32,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(unsafe { traps(film) }, move || {
        if transmittance.is_null() {
            require(reflectance, "reflectance (and transmittance)")?;
        }
        // SAFETY: the caller vouches for the handle and for 3 numbers each.
        unsafe {
            let film = &handle(film)?.film;
            let side = known_side(side)?;
            let colors = film.colors_spread(side, cos_theta, thickness_nm, thickness_spread_nm)?;
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
            let found = handle(film)?;
            let found = found
                .film
                .reference(f64::from(cos_theta), f64::from(thickness_nm));
            write(rgb, found.map(|channel| channel as f32));
        }
        Ok(())
    })
}

/// Reflectance of unpolarised light from the ambient's side at single wavelengths, by full wave
/// optics, for spectral renderers. Allocates.
///
/// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0, or outside the range of a
/// medium's data (PellicleFilmInfo::lambda_min_nm) unless PellicleFilmDesc::extrapolate is 1: OUT_OF_RANGE.
/// `reflectance`: `count`
/// numbers; it may be the array `lambda_nm` itself, and is refused if it overlaps that otherwise.
/// `cos_theta` and `thickness_nm` as in pellicle_film_reflectance().
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
            let film = &handle(film)?.film;
            check_wavelengths(film, lambda_nm, count)?;
            if count > 0 {
                require(reflectance, "reflectance")?;
            }
            check_apart(lambda_nm, reflectance, count)?;
            let (cos_theta, thickness_nm) = (f64::from(cos_theta), f64::from(thickness_nm));
            for i in 0..count {
                let wavelength_nm = f64::from(lambda_nm.add(i).read_unaligned());
                let found = film.spectrum(cos_theta, thickness_nm, wavelength_nm)?;
                reflectance.add(i).write_unaligned(found as f32);
            }
        }
        Ok(())
    })
}

#[inline(always)]
unsafe fn write(target: *mut f32, rgb: [f32; 3]) {
    // SAFETY: the caller vouches for 3 numbers.
    unsafe { target.cast::<[f32; 3]>().write_unaligned(rgb) }
}

#[inline(always)]
pub(super) fn known_side(side: u32) -> Result<Side, Error> {
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

/// Refuses wavelengths before anything is written: outputs stay untouched if one of them is wrong.
#[inline(always)]
pub(super) unsafe fn check_wavelengths(
    film: &Film,
    lambda_nm: *const f32,
    count: usize,
) -> Result<(), Error> {
    // SAFETY: the caller vouches for `count` numbers.
    let given = unsafe { elements(lambda_nm, count, "lambda_nm")? };
    for (at, nm) in given.enumerate() {
        let name = format_args!("lambda_nm[{at}]");
        film.check_wavelength(name, f64::from(nm))?;
    }
    Ok(())
}

/// Refuses arrays that overlap without being the same: a result would replace a wavelength not read yet.
fn check_apart(lambda_nm: *const f32, reflectance: *mut f32, count: usize) -> Result<(), Error> {
    let distance = lambda_nm.addr().abs_diff(reflectance.addr());
    if distance == 0 || distance >= count * size_of::<f32>() {
        return Ok(());
    }
    Err(Error::invalid(format!(
        "reflectance overlaps lambda_nm, {distance} bytes apart with count = {count}: give the same array or \
         one apart from it"
    )))
}
