//! A film at single wavelengths: amplitudes, reflectance and transmittance.

use super::boundary::{guard_call, require};
use super::c_types::size_t;
use super::film::{handle, traps};
use super::film_calls::{check_wavelengths, known_side};
use super::film_types::PellicleAmplitudes;
use super::types::{PellicleFilm, PellicleStatus};
use crate::error::Error;
use crate::film::Ray;

/// Reflectance and transmittance of unpolarised light from either side at single wavelengths, by full wave
/// optics, for spectral renderers. Needs no PellicleFilmDesc::transmittance, and allocates nothing.
///
/// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0 or, without `extrapolate` in the
/// film's description, outside the range of a medium's data: OUT_OF_RANGE. `reflectance`, `transmittance`: `count` numbers each,
/// not clipped; either may be NULL if not wanted, not both; one that overlaps `lambda_nm` is INVALID_ARGUMENT.
/// `cos_theta`, `thickness_nm` and `side` as in pellicle_film_eval().
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, the arrays NULL (`lambda_nm`: refused, unless `count` is 0)
/// or good for `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_spectrum_eval(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    side: u32,
    lambda_nm: *const f32,
    count: size_t,
    reflectance: *mut f32,
    transmittance: *mut f32,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(
        unsafe { traps(film) },
        #[inline(always)]
        move || {
            // SAFETY: the caller vouches for the handle and for `count` numbers in each array.
            unsafe {
                let film = &handle(film)?.film;
                let side = known_side(side)?;
                check_wavelengths(film, lambda_nm, count)?;
                if transmittance.is_null() && count > 0 {
                    require(reflectance, "reflectance (and transmittance)")?;
                }
                check_apart("reflectance", reflectance, lambda_nm, count)?;
                check_apart("transmittance", transmittance, lambda_nm, count)?;
                let ray = rays(cos_theta, thickness_nm, lambda_nm);
                film.each_response(
                    side,
                    count,
                    ray,
                    #[inline(always)]
                    |i, found| {
                        if !reflectance.is_null() {
                            let value = found.unpolarized_reflectance() as f32;
                            reflectance.add(i).write_unaligned(value);
                        }
                        if !transmittance.is_null() {
                            let value = found.unpolarized_transmittance() as f32;
                            transmittance.add(i).write_unaligned(value);
                        }
                    },
                );
            }
            Ok(())
        },
    )
}

/// Complex amplitudes r_s, r_p, t_s and t_p from either side at single wavelengths, by full wave optics: for
/// renderers that track polarisation, and for ellipsometry. Needs no PellicleFilmDesc::transmittance, and
/// allocates nothing.
///
/// Waves are exp(i (k x - omega t)), so that an index eta + i k with k > 0 absorbs and a longer path adds to
/// the phase. At normal incidence r_p = -r_s. These are the signs of Byrnes (arXiv:1603.02720) and his Python
/// package tmm. r compares the fields on the near side of the film's first surface, t the field just behind
/// its last surface with the incident one at the first. |r|^2 is the reflectance. With the complex indices n
/// and cosines c on the two sides (n sin alike on both, Im(n c) >= 0), the transmittance is
/// |t_s|^2 Re(n_far c_far) / (n_near c_near) for s and |t_p|^2 Re(n_far conj(c_far)) / (n_near c_near) for p.
///
/// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0 or, without `extrapolate` in the
/// film's description, outside the range of a medium's data (PellicleFilmInfo): OUT_OF_RANGE. `amplitudes`: `count`
/// structs; INVALID_ARGUMENT if they overlap `lambda_nm`. `cos_theta`, `thickness_nm` and `side` as in
/// pellicle_film_eval(): everything is 0 from an opaque base.
///
/// # Safety
/// `film` must be NULL (refused) or a live handle, the arrays NULL (refused, unless `count` is 0) or good for
/// `count` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_film_amplitudes(
    film: *const PellicleFilm,
    cos_theta: f32,
    thickness_nm: f32,
    side: u32,
    lambda_nm: *const f32,
    count: size_t,
    amplitudes: *mut PellicleAmplitudes,
) -> PellicleStatus {
    // SAFETY: NULL or a live handle, as the caller vouches.
    guard_call(
        unsafe { traps(film) },
        #[inline(always)]
        move || {
            // SAFETY: the caller vouches for the handle and for `count` elements in each array.
            unsafe {
                let film = &handle(film)?.film;
                let side = known_side(side)?;
                check_wavelengths(film, lambda_nm, count)?;
                if count > 0 {
                    require(amplitudes, "amplitudes")?;
                }
                check_apart("amplitudes", amplitudes, lambda_nm, count)?;
                let ray = rays(cos_theta, thickness_nm, lambda_nm);
                film.each_amplitudes(
                    side,
                    count,
                    ray,
                    |x| x as f32,
                    |i, found| {
                        let ([r_s, r_p], [t_s, t_p]) = (found.reflection, found.transmission);
                        let value = PellicleAmplitudes {
                            r_s: [r_s.re, r_s.im],
                            r_p: [r_p.re, r_p.im],
                            t_s: [t_s.re, t_s.im],
                            t_p: [t_p.re, t_p.im],
                        };
                        amplitudes.add(i).write_unaligned(value);
                    },
                );
            }
            Ok(())
        },
    )
}

/// The rays of a call's wavelengths.
///
/// # Safety
/// Whoever asks for a ray vouches for its wavelength.
#[inline(always)]
unsafe fn rays(cos_theta: f32, thickness_nm: f32, lambda_nm: *const f32) -> impl Fn(usize) -> Ray {
    #[inline(always)]
    move |i| Ray {
        cos_theta: f64::from(cos_theta),
        thickness_nm: f64::from(thickness_nm),
        // SAFETY: the caller vouches for the wavelength.
        wavelength_nm: f64::from(unsafe { lambda_nm.add(i).read_unaligned() }),
    }
}

/// Refuses an output that overlaps the wavelengths: a result would replace one that is not read yet.
#[inline(always)]
fn check_apart<T>(
    name: &str,
    output: *mut T,
    lambda_nm: *const f32,
    count: usize,
) -> Result<(), Error> {
    let ends =
        |start: usize, size: usize| (start, start.saturating_add(count.saturating_mul(size)));
    let (from, to) = ends(output.addr(), size_of::<T>());
    let (first, end) = ends(lambda_nm.addr(), size_of::<f32>());
    if output.is_null() || to <= first || end <= from {
        return Ok(());
    }
    Err(overlap(name, count))
}

#[cold]
fn overlap(name: &str, count: usize) -> Error {
    Error::invalid(format!(
        "{name} overlaps lambda_nm, with count = {count}: give arrays apart from each other"
    ))
}
