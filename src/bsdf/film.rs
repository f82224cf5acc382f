//! The rules about the film that a model takes, and about the thickness of its varying layer.

use super::varying::Range;
use crate::error::Error;
use crate::film::Film;
use crate::lobe::{Entry, Values};

/// Refuses a film that is not used, the lack of one that is, and a thickness that does not fit it.
/// `given` tells which parameters have a value of their own.
pub(super) fn check_film(
    entry: &Entry,
    film: Option<&Film>,
    values: &Values<f32>,
    given: &[bool],
    varying: &[Range],
) -> Result<(), Error> {
    let model = entry.name();
    let film = match ((entry.needs_film)(values), film) {
        (false, None) => None,
        (true, Some(film)) => Some(film),
        (false, Some(_)) => {
            return Err(Error::invalid(format!(
                "model '{model}' uses no film, but one is given"
            )));
        }
        (true, None) => {
            return Err(Error::invalid(format!(
                "model '{model}' needs a film, but none is given"
            )));
        }
    };
    let Some(param) = entry.info.film_thickness else {
        return Ok(());
    };
    let name = entry.info.params[param].name();
    let mut thicknesses = Vec::new();
    if given[param] {
        thicknesses.push(("", values.number(param)));
    }
    for range in varying.iter().filter(|range| range.param == param) {
        thicknesses.push((" (least varying value)", range.min));
        thicknesses.push((" (greatest varying value)", range.max));
    }
    match film.and_then(Film::varying_thickness_nm) {
        None if thicknesses.is_empty() => Ok(()),
        None => {
            let reason = film.map_or("it uses no film", |_| "no layer of its film varies");
            Err(Error::invalid(format!(
                "model '{model}' takes no '{name}' here: {reason}"
            )))
        }
        Some([min, max]) if thicknesses.is_empty() => Err(Error::invalid(format!(
            "model '{model}' needs '{name}', fixed or varying within [{min}, {max}], \
             as a layer of its film varies"
        ))),
        Some(range) => {
            // Thicknesses are in single precision: an end of the range is rounded like them.
            let [min, max] = range.map(|nm| nm as f32);
            let outside = |(_, number): &&(&str, f32)| !(min..=max).contains(number);
            let Some((which, number)) = thicknesses.iter().find(outside) else {
                return Ok(());
            };
            Err(Error::out_of_range(format!(
                "parameter '{name}{which}' = {number} of model '{model}' is outside \
                 [{min}, {max}], the range of the film's layer"
            )))
        }
    }
}
