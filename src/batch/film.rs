//! Reflectance of a film.

use super::bsdf::LEAST_TILE;
use super::column::{Chunk, Column, is_apart};
use super::view::{ConstView, View};
use crate::error::Error;
use crate::film::Film;
use crate::num::Level;

/// Arguments of [`film_reflectance`].
#[derive(Clone, Copy, Debug)]
pub struct FilmArgs {
    /// How many elements.
    pub count: usize,
    /// Cosines of incidence in the ambient medium.
    pub cos_theta: ConstView,
    /// Thicknesses of the layer that varies, nm; null data if none does.
    pub thickness_nm: ConstView,
    /// Receives the reflectance.
    pub reflectance: View,
}

/// Reflectance of every element from the ambient's side; equal to the single calls bit for bit, at every
/// level.
///
/// # Errors
/// `InvalidArgument`, before anything is read or written, if a needed view is null or an offset
/// overflows the address space.
///
/// # Safety
/// As [`eval`](super::eval).
pub unsafe fn film_reflectance(film: &Film, args: &FilmArgs, level: Level) -> Result<(), Error> {
    let count = args.count;
    if args.reflectance.data.is_null() {
        return Err(Error::invalid(
            "reflectance.data is NULL: nothing to compute",
        ));
    }
    args.cos_theta.check("cos_theta", 1, count)?;
    let thickness_nm = thickness(film, args)?;
    args.reflectance.check("reflectance", 3, count)?;
    // SAFETY: the caller vouches for every address of every view.
    unsafe {
        if count < LEAST_TILE {
            for i in 0..count {
                let (cos_theta, thickness_nm) = (args.cos_theta.at(i, 0), thickness_nm.at(i, 0));
                let rgb = film.reflectance(cos_theta, thickness_nm);
                args.reflectance.store_one(i, rgb);
            }
        } else {
            by_tiles(film, args, &thickness_nm, level);
        }
    }
    Ok(())
}

unsafe fn by_tiles(film: &Film, args: &FilmArgs, thickness_nm: &ConstView, level: Level) {
    let count = args.count;
    let inputs = [args.cos_theta.span(1, count), thickness_nm.span(1, count)];
    let outputs = [args.reflectance.target(3, count)];
    let [mut cosines, mut thicknesses] = [[Column::EMPTY]; 2];
    let mut room = [Column::EMPTY; 3];
    for chunk in Chunk::all(count, is_apart(&inputs, &outputs)) {
        // SAFETY: as in `film_reflectance`; the slices are apart, or copies.
        unsafe {
            let [cosines] = chunk.read(&args.cos_theta, &mut cosines);
            let [thicknesses] = chunk.read(thickness_nm, &mut thicknesses);
            let reflectance = chunk.target(&args.reflectance, &mut room);
            film.reflectance_tile(level, cosines, thicknesses, reflectance);
            chunk.write(&args.reflectance, &room);
        }
    }
}

/// The view of the thicknesses: any number will do for a film of which none varies.
fn thickness(film: &Film, args: &FilmArgs) -> Result<ConstView, Error> {
    if args.thickness_nm.data.is_null() && film.varying_thickness_nm().is_none() {
        return Ok(ConstView {
            data: &0.0,
            element_stride: 0,
            component_stride: 0,
        });
    }
    args.thickness_nm.check("thickness_nm", 1, args.count)?;
    Ok(args.thickness_nm)
}
