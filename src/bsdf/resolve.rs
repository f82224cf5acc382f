//! The checks that turn a description into validated values.

use super::description::{Description, ParamValue};
use super::film_rules::check_film;
use super::info::{ModelInfo, ParamInfo, ParamKind};
use super::precision::Precision;
use super::registry::RegisteredModel;
use super::values::{Bounds, Values};
use super::varying::{VaryingRange, upward};
use crate::error::Error;

/// Validates names, values, ranges and the film.
pub(super) fn resolve(
    description: &Description,
    entry: &RegisteredModel,
) -> Result<Resolved, Error> {
    let info = entry.info;
    let mut resolved = Resolved {
        values: Values::defaults(info),
        varying: Vec::new(),
    };
    let mut is_set = vec![false; info.params.len()];
    for (name, value) in &description.params {
        let index = index_of(info, name)?;
        if std::mem::replace(&mut is_set[index], true) {
            return Err(Error::invalid(format!("parameter '{name}' is given twice")));
        }
        set(&mut resolved.values, index, &info.params[index], value)?;
    }
    for (name, min, max) in &description.varying {
        let param = index_of(info, name)?;
        if resolved.varying.iter().any(|range| range.param == param) {
            return Err(Error::invalid(format!(
                "varying parameter '{name}' is given twice"
            )));
        }
        let range = VaryingRange {
            param,
            min: *min,
            max: *max,
        };
        check_range(info, &range)?;
        resolved.values.set_varying(param);
        resolved.varying.push(range);
    }
    let has_value =
        |param: usize| is_set[param] || resolved.varying.iter().any(|range| range.param == param);
    for param in (0..info.params.len()).filter(|&param| has_value(param)) {
        check_use(info, param, &resolved.values)?;
    }
    check_film(
        entry,
        description.film.as_deref(),
        &resolved.values,
        &is_set,
        &resolved.varying,
    )?;
    resolved.values.set_film(description.film.clone());
    for range in &resolved.varying {
        // A varying parameter without a value of its own takes the model's default, clamped to its
        // range.
        if let ParamKind::Number { default, .. } = info.params[range.param].kind
            && !is_set[range.param]
        {
            let default = default.clamp(range.min, range.max);
            resolved.values.set_numbers(range.param, [default; 3]);
        }
    }
    (entry.check)(&resolved.bounds(info))?;
    Ok(resolved)
}

/// The validated values and ranges of a description.
pub(super) struct Resolved {
    pub values: Values<f32>,
    pub varying: Vec<VaryingRange>,
}

impl Resolved {
    /// The values in the precision of the BSDF, with directions normalised in that precision.
    pub fn values_in<T: Precision>(&self, info: &ModelInfo) -> Values<T> {
        let mut values = Values::defaults(info);
        for (index, param) in info.params.iter().enumerate() {
            let numbers = self
                .values
                .rgb(index)
                .map(|number| T::new(f64::from(number)));
            let numbers = match param.kind {
                ParamKind::Direction { .. } => upward(numbers).unwrap_or(numbers),
                _ => numbers,
            };
            values.set_numbers(index, numbers);
            values.set_choice(index, self.values.choice(index));
        }
        for range in &self.varying {
            values.set_varying(range.param);
        }
        values.set_film(self.values.film().cloned());
        values
    }

    /// The least and the greatest value of each parameter.
    fn bounds(&self, info: &ModelInfo) -> Bounds {
        let mut bounds = Bounds {
            least: self.values.clone(),
            greatest: self.values.clone(),
        };
        for range in &self.varying {
            if matches!(info.params[range.param].kind, ParamKind::Number { .. }) {
                let own = self.values.rgb(range.param);
                let least = own.map(|own| own.min(range.min));
                let greatest = own.map(|own| own.max(range.max));
                bounds.least.set_numbers(range.param, least);
                bounds.greatest.set_numbers(range.param, greatest);
            }
        }
        bounds
    }
}

fn index_of(info: &ModelInfo, name: &str) -> Result<usize, Error> {
    info.param(name).ok_or_else(|| {
        let kind = format!("parameter of model {}", info.name);
        Error::unknown(&kind, name, info.params.iter().map(ParamInfo::name))
    })
}

/// Refuses a parameter that has no effect under the choices made.
fn check_use(info: &ModelInfo, index: usize, values: &Values<f32>) -> Result<(), Error> {
    let param = &info.params[index];
    if param.is_used(|choice| values.choice(choice)) {
        return Ok(());
    }
    let name_of = |param: usize, choice: usize| match info.params[param].kind {
        ParamKind::Choice { choices } => {
            format!("{} = {}", info.params[param].name, choices[choice])
        }
        _ => info.params[param].name.to_owned(),
    };
    let cases = param.used_with.iter().map(|case| {
        let choices = case.iter().map(|made| name_of(made.param, made.choice));
        choices.collect::<Vec<_>>().join(" and ")
    });
    let needed = cases.collect::<Vec<_>>().join(", or with ");
    // The choices that decide about it, each listed once.
    let mut deciding: Vec<usize> = Vec::new();
    for made in param.used_with.iter().copied().flatten() {
        if !deciding.contains(&made.param) {
            deciding.push(made.param);
        }
    }
    let made = deciding
        .iter()
        .map(|&param| name_of(param, values.choice(param)));
    let made = made.collect::<Vec<_>>().join(" and ");
    Err(Error::invalid(format!(
        "parameter '{}' has no effect with {made}; it is used with {needed}",
        param.name
    )))
}

fn set(
    values: &mut Values<f32>,
    index: usize,
    param: &ParamInfo,
    value: &ParamValue,
) -> Result<(), Error> {
    let name = param.name();
    match (&param.kind, value) {
        (
            ParamKind::Number {
                components,
                min,
                max,
                ..
            },
            ParamValue::Numbers(numbers),
        ) => {
            let numbers = spread(name, *components, numbers)?;
            for (c, number) in numbers.into_iter().enumerate().take(*components) {
                check_number(&component_name(name, *components, c), number, *min, *max)?;
            }
            values.set_numbers(index, numbers);
        }
        (ParamKind::Direction { min_z }, ParamValue::Numbers(numbers)) => {
            values.set_numbers(index, direction(name, numbers, *min_z)?);
        }
        (ParamKind::Choice { choices }, ParamValue::Choice(choice)) => {
            let names = || choices.iter().copied();
            let found = names().position(|name| name == choice);
            let kind = format!("choice for '{name}'");
            values.set_choice(
                index,
                found.ok_or_else(|| Error::unknown(&kind, choice, names()))?,
            );
        }
        (ParamKind::Choice { .. }, ParamValue::Numbers(_)) => {
            return Err(Error::invalid(format!(
                "parameter '{name}' takes the name of a choice, not numbers"
            )));
        }
        (_, ParamValue::Choice(_)) => {
            return Err(Error::invalid(format!(
                "parameter '{name}' takes numbers, not the name of a choice"
            )));
        }
    }
    Ok(())
}

/// Three components from one number per component or one for all.
fn spread(name: &str, components: usize, numbers: &[f32]) -> Result<[f32; 3], Error> {
    match *numbers {
        [all] => Ok([all; 3]),
        [x, y, z] if components == 3 => Ok([x, y, z]),
        _ => {
            let allowed = if components == 3 { "1 or 3" } else { "1" };
            let count = numbers.len();
            Err(Error::invalid(format!(
                "parameter '{name}' takes {allowed} numbers, not {count}"
            )))
        }
    }
}

fn direction(name: &str, numbers: &[f32], min_z: f32) -> Result<[f32; 3], Error> {
    let &[x, y, z] = numbers else {
        let count = numbers.len();
        return Err(Error::invalid(format!(
            "parameter '{name}' takes 3 numbers, not {count}"
        )));
    };
    for (c, number) in [x, y, z].into_iter().enumerate() {
        check_number(&component_name(name, 3, c), number, f32::MIN, f32::MAX)?;
    }
    match upward([f64::from(x), f64::from(y), f64::from(z)]) {
        Some(unit) if unit[2] >= f64::from(min_z) => Ok([x, y, z]),
        unit => {
            let found = unit.map_or("z <= 0".to_owned(), |unit| format!("z = {}", unit[2]));
            Err(Error::out_of_range(format!(
                "parameter '{name}' = ({x}, {y}, {z}) has {found} after normalisation; \
                 allowed is z in [{min_z}, 1]"
            )))
        }
    }
}

fn component_name(name: &str, components: usize, c: usize) -> String {
    if components == 1 {
        name.to_owned()
    } else {
        format!("{name}[{c}]")
    }
}

fn check_number(name: &str, number: f32, min: f32, max: f32) -> Result<(), Error> {
    if number >= min && number <= max {
        return Ok(());
    }
    Err(Error::out_of_range(format!(
        "parameter '{name}' = {number} is outside [{min}, {max}]"
    )))
}

/// Refuses a declared range that is not within the range of the parameter.
fn check_range(info: &ModelInfo, range: &VaryingRange) -> Result<(), Error> {
    let param = &info.params[range.param];
    let name = param.name();
    if !param.can_vary {
        let vary = info
            .params
            .iter()
            .filter(|param| param.can_vary)
            .map(ParamInfo::name);
        let vary = vary.collect::<Vec<_>>().join(", ");
        return Err(Error::unsupported(format!(
            "parameter '{name}' cannot vary; can: {vary}"
        )));
    }
    match param.kind {
        ParamKind::Number { min, max, .. } => {
            check_number(
                &format!("{name} (least varying value)"),
                range.min,
                min,
                max,
            )?;
            check_number(
                &format!("{name} (greatest varying value)"),
                range.max,
                min,
                max,
            )?;
            if range.min > range.max {
                return Err(Error::out_of_range(format!(
                    "varying parameter '{name}' has its range reversed: [{}, {}]",
                    range.min, range.max
                )));
            }
        }
        ParamKind::Direction { .. } => {
            if range.min != 0.0 || range.max != 0.0 {
                return Err(Error::invalid(format!(
                    "varying parameter '{name}' is a direction: give 0 and 0, not {} and {}",
                    range.min, range.max
                )));
            }
        }
        ParamKind::Choice { .. } => {
            return Err(Error::unsupported(format!(
                "parameter '{name}' is a choice"
            )));
        }
    }
    Ok(())
}
