//! Reflectance of a film.

use super::view::{ConstView, View};
use crate::error::Error;
use crate::film::Film;

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

/// Reflectance of every element from the ambient's side; equal to the single calls bit for bit.
///
/// # Errors
/// `InvalidArgument`, before anything is read or written, if a needed view is null or an offset
/// overflows the address space.
///
/// # Safety
/// As [`eval`](super::eval).
pub unsafe fn film_reflectance(film: &Film, args: &FilmArgs) -> Result<(), Error> {
    let count = args.count;
    if args.reflectance.data.is_null() {
        return Err(Error::invalid(
            "reflectance.data is NULL: nothing to compute",
        ));
    }
    args.cos_theta.check("cos_theta", 1, count)?;
    let thickness_nm = thickness(film, args)?;
    args.reflectance.check("reflectance", 3, count)?;
    for i in 0..count {
        // SAFETY: the caller vouches for every address of every view.
        unsafe {
            let (cos_theta, thickness_nm) = (args.cos_theta.at(i, 0), thickness_nm.at(i, 0));
            let rgb = film.reflectance(cos_theta, thickness_nm);
            args.reflectance.store(i, rgb);
        }
    }
    Ok(())
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
