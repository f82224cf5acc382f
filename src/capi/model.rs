//! What exists: models and their parameters.

use super::args::{PellicleModelInfo, PellicleModelParam};
use super::boundary::{check_output, guard, write_growing};
use super::text::text;
use super::types::{
    PELLICLE_KIND_CHOICE, PELLICLE_KIND_DIRECTION, PELLICLE_KIND_NUMBER, PellicleStatus,
};
use crate::bsdf::{Exception, ParamInfo, ParamKind, RegisteredModel, Values, models};
use crate::error::Error;
use libc::size_t;
use std::ptr::null;

/// How many models this build offers.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_model_count() -> size_t {
    models().len()
}

/// Describes the model with number `model`, below pellicle_model_count(); else OUT_OF_RANGE.
///
/// # Safety
/// `info` must be NULL (refused) or good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_model_info(
    model: size_t,
    info: *mut PellicleModelInfo,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        let entry = numbered_model(model)?;
        let described = entry.info;
        let reason = |exception: &Option<Exception>| {
            exception
                .as_ref()
                .map_or(null(), |exception| text(exception.reason))
        };
        let filled = PellicleModelInfo {
            name: text(described.name),
            summary: text(described.summary),
            source: text(described.source),
            flags: described.flags().0,
            param_count: described.params.len() as u32,
            lobe_count: described.lobes.len() as u32,
            not_reciprocal: reason(&described.not_reciprocal),
            not_conserving: reason(&described.not_conserving),
            needs_film: u32::from((entry.needs_film)(&Values::defaults(described))),
        };
        // SAFETY: not NULL, and the caller vouches for `info_size` bytes.
        unsafe { write_growing(info, info_size, &filled) };
        Ok(())
    })
}

/// Describes parameter number `param`, below PellicleModelInfo::param_count, of model number
/// `model`; else OUT_OF_RANGE.
///
/// # Safety
/// `info` must be NULL (refused) or good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_model_param(
    model: size_t,
    param: size_t,
    info: *mut PellicleModelParam,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        let params = numbered_model(model)?.info.params;
        let described = params.get(param).ok_or_else(|| {
            Error::out_of_range(format!(
                "param = {param} is outside [0, {}]",
                params.len() - 1
            ))
        })?;
        let filled = fill(described);
        // SAFETY: not NULL, and the caller vouches for `info_size` bytes.
        unsafe { write_growing(info, info_size, &filled) };
        Ok(())
    })
}

fn numbered_model(model: usize) -> Result<&'static RegisteredModel, Error> {
    models().get(model).ok_or_else(|| {
        Error::out_of_range(format!(
            "model = {model} is outside [0, {}]",
            models().len() - 1
        ))
    })
}

fn fill(param: &ParamInfo) -> PellicleModelParam {
    let mut filled = PellicleModelParam {
        name: text(param.name),
        unit: text(param.unit),
        summary: text(param.summary),
        kind: PELLICLE_KIND_NUMBER,
        components: param.components() as u32,
        can_vary: u32::from(param.can_vary),
        min: 0.0,
        max: 0.0,
        default_value: [0.0; 3],
        default_choice: null(),
        choice_count: 0,
        choices: [null(); 16],
    };
    match param.kind {
        ParamKind::Number {
            components,
            min,
            max,
            default,
        } => {
            (filled.min, filled.max) = (min, max);
            filled.default_value[..components].fill(default);
        }
        ParamKind::Direction { min_z } => {
            filled.kind = PELLICLE_KIND_DIRECTION;
            (filled.min, filled.max) = (min_z, 1.0);
            filled.default_value = [0.0, 0.0, 1.0];
        }
        ParamKind::Choice { choices } => {
            filled.kind = PELLICLE_KIND_CHOICE;
            filled.default_choice = text(choices[0]);
            filled.choice_count = choices.len() as u32;
            for (target, choice) in filled.choices.iter_mut().zip(choices) {
                *target = text(choice);
            }
        }
    }
    filled
}
