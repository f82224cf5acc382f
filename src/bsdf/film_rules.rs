//! The rules for the film of a model and for the thickness of its varying layer.

use super::info::ParamKind;
use super::registry::RegisteredModel;
use super::values::Values;
use super::varying::VaryingRange;
use crate::error::Error;
use crate::film::Film;

/// Refuses a film that the model does not use, a missing film that it needs, and a thickness that is
/// outside the range of the film. `given` tells for each parameter whether the description gives a value.
pub(super) fn check_film(
    entry: &RegisteredModel,
    film: Option<&Film>,
    values: &Values<f32>,
    given: &[bool],
    varying: &[VaryingRange],
) -> Result<(), Error> {
    let model = entry.name();
    let film = match ((entry.needs_film)(values), film) {
        (false, None) => None,
        (true, Some(film)) => Some(film),
        (false, Some(_)) => {
            let why = under_choice(entry, values).map_or(String::new(), |(_, other)| other);
            return Err(Error::invalid(format!(
                "model '{model}' uses no film{why}, but one is given"
            )));
        }
        (true, None) => {
            let why = under_choice(entry, values).map_or(String::new(), |(its, _)| its);
            return Err(Error::invalid(format!(
                "model '{model}' needs a film{why}, but none is given"
            )));
        }
    };
    check_spread(entry, film, values, given, varying)?;
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
            // Thicknesses are in single precision, so the ends of the range are rounded to it too.
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

/// Refuses a spread of thickness where no layer varies, and one that the film has no averages for.
fn check_spread(
    entry: &RegisteredModel,
    film: Option<&Film>,
    values: &Values<f32>,
    given: &[bool],
    varying: &[VaryingRange],
) -> Result<(), Error> {
    let Some(param) = entry.info.film_thickness_spread else {
        return Ok(());
    };
    let (model, name) = (entry.name(), entry.info.params[param].name());
    let range = varying.iter().find(|range| range.param == param);
    if !given[param] && range.is_none() {
        return Ok(());
    }
    let Some(film) = film.filter(|film| film.varying_thickness_nm().is_some()) else {
        let reason = film.map_or("it uses no film", |_| "no layer of its film varies");
        return Err(Error::invalid(format!(
            "model '{model}' takes no '{name}' here: {reason}"
        )));
    };
    let own = if given[param] {
        values.number(param)
    } else {
        0.0
    };
    let greatest = range.map_or(own, |range| range.max.max(own));
    let most = film.thickness_spread_max_nm();
    if greatest > most {
        return Err(Error::out_of_range(format!(
            "parameter '{name}' = {greatest} of model '{model}' is outside [0, {most}]: thickness_spread_max_nm in the \
             film's description is its greatest value"
        )));
    }
    Ok(())
}

/// For a model that takes a film only under one choice: the parts of the messages for a film that is
/// missing and for one that is not used.
fn under_choice(entry: &RegisteredModel, values: &Values<f32>) -> Option<(String, String)> {
    let needed = entry.info.film_choice?;
    let param = &entry.info.params[needed.param];
    let ParamKind::Choice { choices } = param.kind else {
        return None;
    };
    let names = choices;
    let (name, film) = (param.name(), names[needed.choice]);
    let made = names[values.choice(needed.param)];
    let known = names.join(", ");
    Some((
        format!(" with '{name}' = {film} (choices: {known})"),
        format!(" with '{name}' = {made}, only with {film} (choices: {known})"),
    ))
}
