//! Argument and description structures of the batch calls and of the introspection.

use super::types::{PellicleConstView, PellicleUintView, PellicleView};
use libc::{c_char, size_t};

/// Arguments of pellicle_bsdf_eval_batch(). Zero-initialise. Grows by appending; pass
/// sizeof(PellicleEvalBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleEvalBatchArgs {
    /// How many elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Directions to the viewer, 3 components.
    pub wo: PellicleConstView,
    /// Directions to the light, 3 components.
    pub wi: PellicleConstView,
    /// One view per varying parameter, in the order of PellicleBsdfDesc::varying. NULL: every
    /// varying parameter keeps its value from `params`; so does one whose data is NULL.
    pub varying: *const PellicleConstView,
    /// How many views `varying` has: PellicleBsdfInfo::varying_count, or 0 with NULL.
    pub varying_count: size_t,
    /// Receives f(wo, wi) |wi.z|, 3 components.
    pub value: PellicleView,
    /// Receives the density, 1 component.
    pub pdf: PellicleView,
}

/// Arguments of pellicle_bsdf_sample_batch(). Zero-initialise. Grows by appending; pass
/// sizeof(PellicleSampleBatchArgs). The outputs are PellicleSample's fields.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleSampleBatchArgs {
    /// How many elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Directions to the viewer, 3 components.
    pub wo: PellicleConstView,
    /// Uniform random numbers in [0, 1), 3 components.
    pub u: PellicleConstView,
    /// As in PellicleEvalBatchArgs.
    pub varying: *const PellicleConstView,
    /// As in PellicleEvalBatchArgs.
    pub varying_count: size_t,
    /// Receives the directions to the light, 3 components.
    pub wi: PellicleView,
    /// Receives the density, 1 component.
    pub pdf: PellicleView,
    /// Receives value / pdf, 3 components.
    pub weight: PellicleView,
    /// Receives the ratio of indices, 1 component.
    pub eta: PellicleView,
    /// Receives the chosen lobe's flags.
    pub flags: PellicleUintView,
    /// Receives the chosen lobe's number.
    pub lobe: PellicleUintView,
}

/// Arguments of pellicle_film_reflectance_batch(). Zero-initialise. Grows by appending; pass
/// sizeof(PellicleFilmBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmBatchArgs {
    /// How many elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Cosines of incidence in the ambient medium, 1 component.
    pub cos_theta: PellicleConstView,
    /// Thicknesses of the layer that varies, nm, 1 component; data NULL only if none does.
    pub thickness_nm: PellicleConstView,
    /// Receives the reflectance, 3 components.
    pub reflectance: PellicleView,
}

/// A model that this build offers. Its strings live as long as the library. Grows by appending;
/// pass sizeof(PellicleModelInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleModelInfo {
    /// The name to create it by.
    pub name: *const c_char,
    /// One sentence.
    pub summary: *const c_char,
    /// Where the model comes from.
    pub source: *const c_char,
    /// PELLICLE_REFLECTION and so on, of all lobes together.
    pub flags: u32,
    /// How many parameters it has.
    pub param_count: u32,
    /// How many lobes sample() chooses from.
    pub lobe_count: u32,
    /// When and why value(wo, wi) wo.z differs from value(wi, wo) wi.z; NULL: never.
    pub not_reciprocal: *const c_char,
    /// When and why the albedo exceeds 1; NULL: never.
    pub not_conserving: *const c_char,
    /// 1: with every parameter at its default it needs PellicleBsdfDesc::film; 0: it takes none then.
    pub needs_film: u32,
}

/// A parameter of a model. Its strings live as long as the library. Grows by appending; pass
/// sizeof(PellicleModelParam).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleModelParam {
    /// The parameter's name.
    pub name: *const c_char,
    /// "nm", or "" for a pure number.
    pub unit: *const c_char,
    /// One sentence.
    pub summary: *const c_char,
    /// PELLICLE_KIND_NUMBER, _DIRECTION or _CHOICE.
    pub kind: u32,
    /// 1 or 3 numbers; 0 for a CHOICE.
    pub components: u32,
    /// 1 if it may be listed in PellicleBsdfDesc::varying.
    pub can_vary: u32,
    /// Least value of each component.
    pub min: f32,
    /// Greatest value of each component.
    pub max: f32,
    /// Default of each component; unused ones are 0.
    pub default_value: [f32; 3],
    /// For a CHOICE: the default's name; NULL otherwise.
    pub default_choice: *const c_char,
    /// For a CHOICE: how many names there are; 0 otherwise.
    pub choice_count: u32,
    /// For a CHOICE: the names, then NULL.
    pub choices: [*const c_char; 16],
}
