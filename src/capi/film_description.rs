//! From a film's description in the caller's memory to one of our own.

use super::boundary::{slice, string};
use super::medium::{medium, needed_medium};
use super::types::PellicleFilmDesc;
use crate::error::Error;
use crate::film::{DEFAULT_TOLERANCE, FilmDescription, MAX_LAYERS};
use crate::optics::{ColorSpace, Medium, White};
use libc::c_char;

/// Copies a description; messages name the place of what was wrong, as in "layers\[2\].medium".
///
/// # Safety
/// Its pointers must be NULL or good for their counts, its strings NUL-terminated.
pub(super) unsafe fn film_description(desc: &PellicleFilmDesc) -> Result<FilmDescription, Error> {
    // SAFETY: the caller vouches for strings and counts.
    unsafe {
        let ambient = medium(&desc.ambient, "ambient")?.unwrap_or_else(Medium::vacuum);
        // Before the layers are read: a count that was never set may be anything.
        if desc.layer_count > MAX_LAYERS {
            return Err(Error::out_of_range(format!(
                "layer_count = {} is outside [0, {MAX_LAYERS}]",
                desc.layer_count
            )));
        }
        let layers = slice(desc.layers, desc.layer_count, "layers")?;
        let mut media = Vec::with_capacity(layers.len());
        for (i, layer) in layers.iter().enumerate() {
            media.push(needed_medium(
                &layer.medium,
                &format!("layers[{i}].medium"),
            )?);
        }
        let mut description = FilmDescription::new(needed_medium(&desc.base, "base")?);
        description.ambient = ambient;
        for (layer, medium) in layers.iter().zip(media) {
            let range = [layer.thickness_min_nm, layer.thickness_max_nm];
            description = description.layer(medium, range.map(f64::from));
        }
        description.tolerance = if desc.tolerance == 0.0 {
            DEFAULT_TOLERANCE
        } else {
            f64::from(desc.tolerance)
        };
        if let Some(name) = optional_string(desc.white, "white")? {
            description.white = White::named(&name)?;
        }
        if let Some(name) = optional_string(desc.color_space, "color_space")? {
            description.color_space = ColorSpace::named(&name)?;
        }
        description.method = optional_string(desc.method, "method")?;
        description.unclipped = switch(desc.unclipped, "unclipped")?;
        description.transmittance = switch(desc.transmittance, "transmittance")?;
        Ok(description)
    }
}

/// The text of a string that may be NULL.
unsafe fn optional_string(pointer: *const c_char, name: &str) -> Result<Option<String>, Error> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL; the caller vouches for the terminator.
    unsafe { string(pointer, name) }.map(Some)
}

fn switch(value: u32, name: &str) -> Result<bool, Error> {
    match value {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(Error::out_of_range(format!(
            "{name} = {value} is neither 0 nor 1"
        ))),
    }
}
