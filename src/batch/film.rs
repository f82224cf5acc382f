//! Batches of a film.

use super::chunk::{CHUNK, Chunks, Column};
use super::view::{ConstView, View, is_apart};
use crate::error::Error;
use crate::film::Film;
use crate::num::Level;

/// Arguments of [`film_reflectance`].
#[derive(Clone, Copy, Debug)]
pub struct FilmArgs {
    /// The number of elements.
    pub count: usize,
    /// Cosines of incidence in the ambient medium, clamped as in [`Film`].
    pub cos_theta: ConstView,
    /// Thicknesses of the layer that varies, nm; data may be null if no layer varies.
    pub thickness_nm: ConstView,
    /// Receives the reflectance, linear RGB.
    pub reflectance: View,
    /// Standard deviations of the thickness, nm, as in [`Film::reflectance_spread`]; null data: 0.
    pub thickness_spread_nm: ConstView,
}

/// Evaluates the reflectance from the ambient's side for every element. The results are the bits of single
/// calls at every level.
///
/// # Errors
/// `InvalidArgument` if a needed view is null or an offset overflows the address space, and what
/// [`Film::check_spread`] refuses, for any element; nothing is then written.
///
/// # Safety
/// As for [`eval`](super::eval).
pub unsafe fn film_reflectance(film: &Film, args: &FilmArgs, level: Level) -> Result<(), Error> {
    let count = args.count;
    if args.reflectance.data.is_null() {
        return Err(Error::invalid(
            "reflectance.data is NULL: nothing to compute",
        ));
    }
    args.cos_theta.check("cos_theta", 1, count)?;
    let thickness_nm = thickness(film, args.thickness_nm, count)?;
    args.reflectance.check("reflectance", 3, count)?;
    let spreads = args.thickness_spread_nm;
    let has_spread = !spreads.data.is_null();
    if has_spread {
        spreads.check("thickness_spread_nm", 1, count)?;
        for i in 0..count {
            // SAFETY: the caller vouches for every address of every view.
            film.check_spread(unsafe { spreads.address(i, 0).read_unaligned() })?;
        }
    }
    let inputs = [
        args.cos_theta.span(1, count),
        thickness_nm.span(1, count),
        spreads.span(1, count),
    ];
    let outputs = [args.reflectance.target(3, count)];
    let chunks = Chunks::new(count, CHUNK, is_apart(&inputs, &outputs), level);
    let [mut cosines, mut thicknesses, mut deviations] = [Column::<f32, CHUNK>::EMPTY; 3];
    let mut room = [Column::<f32, CHUNK>::EMPTY; 3];
    for chunk in chunks.iter() {
        // SAFETY: the caller vouches for every address of every view; slices do not overlap, or are copies.
        unsafe {
            let cosines = chunk.read(&args.cos_theta, &mut cosines.0);
            let thicknesses = chunk.read(&thickness_nm, &mut thicknesses.0);
            let mut reflectance = chunk.columns_mut(&args.reflectance, &mut room);
            if has_spread {
                let deviations = chunk.read(&spreads, &mut deviations.0);
                for i in 0..cosines.len() {
                    let found = film.spread_or_plain(cosines[i], thicknesses[i], deviations[i]);
                    reflectance.store(i, found);
                }
            } else {
                film.reflectance_tile(chunks.level, cosines, thicknesses, &mut reflectance);
            }
            chunk.write(&args.reflectance, &room);
        }
    }
    Ok(())
}

/// The view of the thicknesses. For a film without a varying layer, null data is replaced by one arbitrary
/// number for all elements.
pub(super) fn thickness(
    film: &Film,
    thickness_nm: ConstView,
    count: usize,
) -> Result<ConstView, Error> {
    if thickness_nm.data.is_null() && film.varying_thickness_nm().is_none() {
        return Ok(ConstView {
            data: &0.0,
            element_stride: 0,
            component_stride: 0,
        });
    }
    thickness_nm.check("thickness_nm", 1, count)?;
    Ok(thickness_nm)
}
