//! Conversion of a film's description.

use super::boundary::{check_size, optional_string, read_growing, require};
use super::film_types::{PellicleFilmDesc, PellicleLayer, PellicleMedium};
use super::medium::{medium, needed_medium};
use super::types::{PELLICLE_BASE_BY_K, PELLICLE_BASE_OPAQUE, PELLICLE_BASE_TRANSPARENT};
use crate::error::Error;
use crate::film::{BaseOpacity, DEFAULT_TOLERANCE, FilmDescription, MAX_LAYERS};
use crate::optics::{ColorSpace, Medium, White};

/// Copies a description; messages name the place of what was wrong, as in "layers\[2\].medium".
///
/// # Safety
/// Its pointers must be NULL or good for their counts and sizes, its strings NUL-terminated.
pub(super) unsafe fn film_description(desc: &PellicleFilmDesc) -> Result<FilmDescription, Error> {
    check_size::<PellicleMedium>(desc.medium_size, "desc->medium_size")?;
    // SAFETY: the caller vouches for pointers, strings, counts and sizes.
    unsafe {
        let ambient = if desc.ambient.is_null() {
            None
        } else {
            medium(&read_medium(desc, desc.ambient, "ambient")?, "ambient")?
        };
        let layers = read_layers(desc)?;
        let base = read_medium(desc, desc.base, "base")?;
        let mut description = FilmDescription::new(needed_medium(&base, "base")?);
        description.ambient = ambient.unwrap_or_else(Medium::vacuum);
        for (medium, thickness_nm) in layers {
            description = description.layer(medium, thickness_nm);
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
        description.extrapolate = switch(desc.extrapolate, "extrapolate")?;
        description.thickness_spread_max_nm = f64::from(desc.thickness_spread_max_nm);
        description.base_opacity = base_opacity(desc.base_opaque)?;
        Ok(description)
    }
}

unsafe fn read_medium(
    desc: &PellicleFilmDesc,
    medium: *const PellicleMedium,
    place: &str,
) -> Result<PellicleMedium, Error> {
    // SAFETY: NULL is refused; the caller vouches for the size. Zero is a valid PellicleMedium.
    unsafe { read_growing(medium, desc.medium_size, place) }
}

/// Media and ranges of thickness, nm. The layers are `layer_size` bytes apart.
unsafe fn read_layers(desc: &PellicleFilmDesc) -> Result<Vec<(Medium, [f64; 2])>, Error> {
    // Before the layers are read: a count that was never set may be anything.
    if desc.layer_count > MAX_LAYERS {
        return Err(Error::out_of_range(format!(
            "layer_count = {} is outside [0, {MAX_LAYERS}]",
            desc.layer_count
        )));
    }
    if desc.layer_count == 0 {
        return Ok(Vec::new());
    }
    require(desc.layers, "layers")?;
    check_size::<PellicleLayer>(desc.layer_size, "desc->layer_size")?;
    let read = |i: usize| {
        let place = format!("layers[{i}].medium");
        // SAFETY: the caller vouches for `layer_count` layers of that size. Zero is a valid PellicleLayer.
        unsafe {
            let layer = desc.layers.byte_add(i * desc.layer_size);
            let layer = read_growing(layer, desc.layer_size, &format!("layers[{i}]"))?;
            let medium = needed_medium(&read_medium(desc, layer.medium, &place)?, &place)?;
            let range = [layer.thickness_min_nm, layer.thickness_max_nm];
            Ok((medium, range.map(f64::from)))
        }
    };
    (0..desc.layer_count).map(read).collect()
}

fn base_opacity(value: u32) -> Result<BaseOpacity, Error> {
    match value {
        PELLICLE_BASE_BY_K => Ok(BaseOpacity::ByExtinction),
        PELLICLE_BASE_OPAQUE => Ok(BaseOpacity::Opaque),
        PELLICLE_BASE_TRANSPARENT => Ok(BaseOpacity::Transparent),
        _ => Err(Error::out_of_range(format!(
            "base_opaque = {value} is none of {PELLICLE_BASE_BY_K} (by k), {PELLICLE_BASE_OPAQUE} (opaque) and \
             {PELLICLE_BASE_TRANSPARENT} (transparent)"
        ))),
    }
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
