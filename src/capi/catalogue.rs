//! Lists of models with their parameters, of media, and of the names of methods, spaces, whites and levels.

use super::boundary::{check_output, guard, write_growing};
use super::c_types::{c_char, size_t};
use super::text::{list, text};
use super::types::{
    PELLICLE_KIND_CHOICE, PELLICLE_KIND_DIRECTION, PELLICLE_KIND_NUMBER,
    PELLICLE_NAMES_COLOR_SPACE, PELLICLE_NAMES_METHOD, PELLICLE_NAMES_SIMD_LEVEL,
    PELLICLE_NAMES_WHITE, PellicleStatus,
};
use crate::bsdf::{Exception, ParamInfo, ParamKind, RegisteredModel, Values, models};
use crate::error::Error;
use crate::film::METHODS;
use crate::num::Level;
use crate::optics::{ColorSpace, NamedMedium, White};
use std::ptr::null;

/// A model that this build offers. Its texts live as long as the library. It grows by appending;
/// pass sizeof(PellicleModelInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleModelInfo {
    /// The name to create it by.
    pub name: *const c_char,
    /// What the model is, in one sentence.
    pub summary: *const c_char,
    /// Where the model comes from.
    pub source: *const c_char,
    /// PELLICLE_REFLECTION and so on, of all lobes together.
    pub flags: u32,
    /// Number of parameters; pellicle_model_param() describes them.
    pub param_count: u32,
    /// Number of lobes that sample() chooses from, with the parameters that give the most of them.
    pub lobe_count: u32,
    /// When and why value(wo, wi) wo.z differs from value(wi, wo) wi.z; NULL: never.
    pub not_reciprocal: *const c_char,
    /// When and why the albedo exceeds 1; NULL: never.
    pub not_conserving: *const c_char,
    /// 1: with every parameter at its default it needs PellicleBsdfDesc::film; 0: it takes none then.
    pub needs_film: u32,
}

/// A parameter of a model. Its texts live as long as the library. It grows by appending; pass
/// sizeof(PellicleModelParam).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleModelParam {
    /// The parameter's name.
    pub name: *const c_char,
    /// "nm", "radians", "turns", or "" for a pure number.
    pub unit: *const c_char,
    /// What the parameter means, in one sentence.
    pub summary: *const c_char,
    /// PELLICLE_KIND_NUMBER, _DIRECTION or _CHOICE.
    pub kind: u32,
    /// Number of components: 1 or 3; 0 for a CHOICE.
    pub components: u32,
    /// 1 if it may be listed in PellicleBsdfDesc::varying.
    pub can_vary: u32,
    /// Least value of each component.
    pub min: f32,
    /// Greatest value of each component.
    pub max: f32,
    /// Default of each component; unused ones are 0.
    pub default_value: [f32; 3],
    /// The names of a CHOICE, then NULL; the first is the default. NULL for other kinds.
    pub choices: *const *const c_char,
    /// Number of names of a CHOICE; 0 for other kinds.
    pub choice_count: u32,
}

/// A medium that is known by name. Its texts live as long as the library. It grows by appending; pass
/// sizeof(PellicleMediumInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleMediumInfo {
    /// The chemical formula, or the usual name.
    pub name: *const c_char,
    /// Other names for it, then NULL.
    pub also: *const *const c_char,
    /// Who measured it.
    pub source: *const c_char,
    /// The least wavelength of its data, nm; the index is constant below. 0 for vacuum.
    pub lambda_min_nm: f32,
    /// The greatest wavelength of its data, nm; the index is constant above. Infinite for vacuum.
    pub lambda_max_nm: f32,
    /// 1: it absorbs somewhere in that range; 0: it is transparent.
    pub absorbs: u32,
}

/// Tells how many models this build offers.
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
        let entry = numbered(models(), model, "model")?;
        // SAFETY: not NULL, and the caller vouches for `info_size` bytes.
        unsafe { write_growing(info, info_size, &model_info(entry)) };
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
        let entry = numbered(models(), model, "model")?;
        let filled = param_info(numbered(entry.info.params, param, "param")?);
        // SAFETY: not NULL, and the caller vouches for `info_size` bytes.
        unsafe { write_growing(info, info_size, &filled) };
        Ok(())
    })
}

/// Tells how many media are known by name.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_medium_count() -> size_t {
    NamedMedium::all().len()
}

/// Describes the medium with number `medium`, below pellicle_medium_count(); else OUT_OF_RANGE.
///
/// # Safety
/// `info` must be NULL (refused) or good for `info_size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn pellicle_medium_info(
    medium: size_t,
    info: *mut PellicleMediumInfo,
    info_size: size_t,
) -> PellicleStatus {
    guard(|| {
        check_output(info, info_size, "info")?;
        let described = numbered(NamedMedium::all(), medium, "medium")?;
        let [min, max] = described.range_nm();
        let filled = PellicleMediumInfo {
            name: text(described.name),
            also: list(described.aliases),
            source: text(described.source),
            lambda_min_nm: min as f32,
            lambda_max_nm: max as f32,
            absorbs: u32::from(described.absorbs()),
        };
        // SAFETY: not NULL, and the caller vouches for `info_size` bytes.
        unsafe { write_growing(info, info_size, &filled) };
        Ok(())
    })
}

/// Gives the name with number `index` of a list, PELLICLE_NAMES_METHOD and so on: NULL beyond the last one,
/// and for a list that does not exist. The name lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_name(list: u32, index: size_t) -> *const c_char {
    let mut found = null();
    guard(|| {
        let name = match list {
            PELLICLE_NAMES_METHOD => METHODS.get(index).copied(),
            PELLICLE_NAMES_COLOR_SPACE => ColorSpace::NAMES.get(index).map(|(name, _)| *name),
            PELLICLE_NAMES_WHITE => White::NAMES.get(index).map(|(name, _)| *name),
            PELLICLE_NAMES_SIMD_LEVEL => level_names().get(index).copied(),
            _ => None,
        };
        found = name.map_or(null(), text);
        Ok(())
    });
    found
}

/// The levels of this processor, the narrowest first.
fn level_names() -> Vec<&'static str> {
    let all = std::iter::once(Level::SCALAR).chain(Level::all());
    let mut names: Vec<_> = all.map(Level::name).collect();
    names.dedup();
    names
}

/// The entry with that number, or a message with the numbers that exist.
fn numbered<'a, T>(all: &'a [T], number: usize, what: &str) -> Result<&'a T, Error> {
    all.get(number).ok_or_else(|| {
        Error::out_of_range(format!(
            "{what} = {number} is outside [0, {}]",
            all.len() - 1
        ))
    })
}

fn model_info(entry: &RegisteredModel) -> PellicleModelInfo {
    let described = entry.info;
    let reason = |exception: &Option<Exception>| match exception {
        Some(exception) => text(exception.reason),
        None => null(),
    };
    PellicleModelInfo {
        name: text(described.name),
        summary: text(described.summary),
        source: text(described.source),
        flags: described.flags().0,
        param_count: described.params.len() as u32,
        lobe_count: described.lobes.len() as u32,
        not_reciprocal: reason(&described.not_reciprocal),
        not_conserving: reason(&described.not_conserving),
        needs_film: u32::from((entry.needs_film)(&Values::defaults(described))),
    }
}

fn param_info(param: &ParamInfo) -> PellicleModelParam {
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
        choices: null(),
        choice_count: 0,
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
            filled.choices = list(choices);
            filled.choice_count = choices.len() as u32;
        }
    }
    filled
}
