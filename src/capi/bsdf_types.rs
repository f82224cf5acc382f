//! The structs of a BSDF: its description, what can be asked of it, samples and the arguments of batches.

use super::c_types::{c_char, size_t};
use super::types::{PellicleCall, PellicleConstView, PellicleFilm, PellicleUintView, PellicleView};

/// One parameter of a model, by name: either numbers (`values`, `count`) or a `choice`, never both. Frozen.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleParam {
    /// The parameter's name; pellicle_model_param() lists them.
    pub name: *const c_char,
    /// `count` numbers. One number for a parameter with three components stands for all three
    /// (directions excepted). Copied.
    pub values: *const f32,
    /// Number of entries in `values`.
    pub count: size_t,
    /// The chosen name for a parameter of kind CHOICE; NULL for the others. Copied.
    pub choice: *const c_char,
}

/// A parameter that the caller supplies with every call, from a texture for example. Frozen.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleRange {
    /// The parameter's name; pellicle_model_param() tells which may vary.
    pub name: *const c_char,
    /// Least value of each component. For a direction give 0 and 0: any vector with z > 0 is
    /// accepted at call time and normalised.
    pub min: f32,
    /// Greatest value of each component. Finite values outside [min, max] at call time are clamped
    /// to it. NaN or infinity there gives 0 for that element.
    pub max: f32,
}

/// What BSDF to create. Zero-initialise it, then set what you need: zero means default. It grows by
/// appending; pass sizeof(PellicleBsdfDesc).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleBsdfDesc {
    /// The model's name: "lambert", "phong", "layered", ...; pellicle_model_info() lists them.
    pub model: *const c_char,
    /// Parameters that differ from their defaults; NULL if `param_count` is 0. Copied.
    pub params: *const PellicleParam,
    /// Number of entries in `params`.
    pub param_count: size_t,
    /// Parameters given per call, in the order in which their components are passed; NULL if
    /// `varying_count` is 0. Copied.
    pub varying: *const PellicleRange,
    /// Number of entries in `varying`.
    pub varying_count: size_t,
    /// The film, for models that take one. It is retained, so release yours when you like. A film that is
    /// not used, and none where one is needed, are INVALID_ARGUMENT. If a layer of it varies, the parameter
    /// thickness_nm is needed, fixed or varying within the layer's range; if none does, it is refused.
    pub film: *const PellicleFilm,
    /// The instructions of batches, out of PELLICLE_NAMES_SIMD_LEVEL; NULL: the widest. For tests: the
    /// results are the same.
    pub simd_level: *const c_char,
}

/// What a BSDF is. It grows by appending; pass sizeof(PellicleBsdfInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleBsdfInfo {
    /// The model's name. It lives as long as the library.
    pub model: *const c_char,
    /// PELLICLE_REFLECTION and so on, of all lobes together.
    pub flags: u32,
    /// Number of parameters that vary per call; pellicle_bsdf_varying() describes them.
    pub varying_count: u32,
    /// Number of components that they have together: the length of `varying` in the single calls.
    pub varying_floats: u32,
    /// Number of lobes that sample() chooses from; pellicle_bsdf_lobe() describes them.
    pub lobe_count: u32,
    /// What the BSDF was specialised to, in words: terms that its values leave out, formulas that are
    /// shorter for them, and the instructions of batches. It lives as long as the BSDF.
    pub plan: *const c_char,
}

/// A parameter that varies in a BSDF. It grows by appending; pass sizeof(PellicleVaryingInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleVaryingInfo {
    /// The parameter's name. It lives as long as the library.
    pub name: *const c_char,
    /// "nm", "radians", "turns", or "" for a pure number. It lives as long as the library.
    pub unit: *const c_char,
    /// PELLICLE_KIND_NUMBER or PELLICLE_KIND_DIRECTION.
    pub kind: u32,
    /// Number of components: 1 or 3.
    pub components: u32,
    /// Place of its first component in the `varying` of the single calls.
    pub offset: u32,
    /// Least value of each component; 0 for a direction.
    pub min: f32,
    /// Greatest value of each component; 0 for a direction.
    pub max: f32,
    /// The values that it has where a call does not give it; unused components are 0.
    pub default_value: [f32; 3],
}

/// A lobe of a BSDF. It grows by appending; pass sizeof(PellicleLobeInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleLobeInfo {
    /// The lobe's name, for people. It lives as long as the library.
    pub name: *const c_char,
    /// PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    pub flags: u32,
}

/// A sampled direction. It grows by appending; pass sizeof(PellicleSample).
/// Without a valid sample, and for a random number outside [0, 1), it is all zero, with status PELLICLE_OK.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct PellicleSample {
    /// Direction to the light, unit, in the shading frame.
    pub wi: [f32; 3],
    /// Density of wi per solid angle, of all lobes of the call together; 0 for a DELTA lobe.
    pub pdf: f32,
    /// value / pdf, RGB; for a DELTA lobe the throughput over the probability of choosing it.
    pub weight: [f32; 3],
    /// Refractive index on wi's side over that on wo's side; 1 for a reflection.
    pub eta: f32,
    /// Flags of the chosen lobe: PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    pub flags: u32,
    /// Number of the chosen lobe, below PellicleBsdfInfo::lobe_count.
    pub lobe: u32,
    /// Probability with which that lobe was chosen among the lobes of the call.
    pub lobe_probability: f32,
}

/// A direction sampled for one wavelength, the hero. It grows by appending; pass sizeof(PellicleSpectralSample).
/// Without a valid sample, and for a random number outside [0, 1), it is all zero, with status PELLICLE_OK.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct PellicleSpectralSample {
    /// Direction to the light, unit, in the shading frame.
    pub wi: [f32; 3],
    /// Refractive index on wi's side over that on wo's side, for the hero; 1 for a reflection.
    pub eta: f32,
    /// Flags of the chosen lobe: PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    pub flags: u32,
    /// Number of the chosen lobe, below PellicleBsdfInfo::lobe_count.
    pub lobe: u32,
    /// Probability with which the hero chose that lobe among the lobes of the call.
    pub lobe_probability: f32,
    /// 1 if the hero alone goes in this direction, because a medium disperses and the ray was refracted; else 0. The
    /// other wavelengths have weight and density 0, and the hero's weight counts for all of them: it is divided by the
    /// mean of the densities like any other. A path goes on with that wavelength alone.
    pub hero_only: u32,
}

/// Arguments of pellicle_bsdf_eval_batch(). Zero-initialise them. They grow by appending; pass
/// sizeof(PellicleEvalBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleEvalBatchArgs {
    /// Number of elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Directions to the viewer, 3 components.
    pub wo: PellicleConstView,
    /// Directions to the light, 3 components.
    pub wi: PellicleConstView,
    /// One view per varying parameter, in the order of PellicleBsdfDesc::varying. NULL: every varying
    /// parameter has its default (PellicleVaryingInfo); so does one whose data is NULL.
    pub varying: *const PellicleConstView,
    /// Number of views in `varying`: PellicleBsdfInfo::varying_count, or 0 with NULL.
    pub varying_count: size_t,
    /// Transport and lobes of all elements; NULL: radiance and every lobe.
    pub call: *const PellicleCall,
    /// Receives f(wo, wi) |wi.z|, 3 components.
    pub value: PellicleView,
    /// Receives the density of wi, 1 component.
    pub pdf: PellicleView,
    /// Receives the density of wo for a sample from wi, 1 component.
    pub pdf_reverse: PellicleView,
}

/// Arguments of pellicle_bsdf_sample_batch(). Zero-initialise them. They grow by appending; pass
/// sizeof(PellicleSampleBatchArgs). The outputs are PellicleSample's fields.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleSampleBatchArgs {
    /// Number of elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Directions to the viewer, 3 components.
    pub wo: PellicleConstView,
    /// Uniform random numbers in [0, 1), 3 components.
    pub u: PellicleConstView,
    /// As in PellicleEvalBatchArgs.
    pub varying: *const PellicleConstView,
    /// As in PellicleEvalBatchArgs.
    pub varying_count: size_t,
    /// As in PellicleEvalBatchArgs.
    pub call: *const PellicleCall,
    /// Receives the directions to the light, 3 components.
    pub wi: PellicleView,
    /// Receives the density of wi, 1 component.
    pub pdf: PellicleView,
    /// Receives value / pdf, 3 components.
    pub weight: PellicleView,
    /// Receives the ratio of indices, 1 component.
    pub eta: PellicleView,
    /// Receives the chosen lobe's flags.
    pub flags: PellicleUintView,
    /// Receives the chosen lobe's number.
    pub lobe: PellicleUintView,
    /// Receives the probability of choosing that lobe, 1 component.
    pub lobe_probability: PellicleView,
}

/// Arguments of pellicle_bsdf_eval_spectral_batch(). Zero-initialise them. They grow by appending; pass
/// sizeof(PellicleEvalSpectralBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleEvalSpectralBatchArgs {
    /// Number of elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Number of wavelengths of each element, 1 to 16.
    pub lambda_count: size_t,
    /// Vacuum wavelengths, nm, lambda_count components; element_stride 0 gives all elements the same.
    pub lambda_nm: PellicleConstView,
    /// Directions to the viewer, 3 components.
    pub wo: PellicleConstView,
    /// Directions to the light, 3 components.
    pub wi: PellicleConstView,
    /// As in PellicleEvalBatchArgs, but colours have lambda_count components.
    pub varying: *const PellicleConstView,
    /// As in PellicleEvalBatchArgs.
    pub varying_count: size_t,
    /// As in PellicleEvalBatchArgs.
    pub call: *const PellicleCall,
    /// Receives f(wo, wi) |wi.z|, lambda_count components.
    pub value: PellicleView,
    /// Receives the densities of wi as if each wavelength had been the hero, lambda_count components.
    pub pdf: PellicleView,
}

/// Arguments of pellicle_bsdf_sample_spectral_batch(). Zero-initialise them. They grow by appending; pass
/// sizeof(PellicleSampleSpectralBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleSampleSpectralBatchArgs {
    /// Number of elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Number of wavelengths of each element, 1 to 16.
    pub lambda_count: size_t,
    /// Number of the wavelength that directions are sampled for, below lambda_count.
    pub hero: size_t,
    /// As in PellicleEvalSpectralBatchArgs.
    pub lambda_nm: PellicleConstView,
    /// Directions to the viewer, 3 components.
    pub wo: PellicleConstView,
    /// Uniform random numbers in [0, 1), 3 components.
    pub u: PellicleConstView,
    /// As in PellicleEvalSpectralBatchArgs.
    pub varying: *const PellicleConstView,
    /// As in PellicleEvalBatchArgs.
    pub varying_count: size_t,
    /// As in PellicleEvalBatchArgs.
    pub call: *const PellicleCall,
    /// Receives the directions to the light, 3 components.
    pub wi: PellicleView,
    /// Receives the weights, lambda_count components.
    pub weight: PellicleView,
    /// Receives the densities as if each wavelength had been the hero, lambda_count components.
    pub pdf: PellicleView,
    /// Receives the ratio of indices, 1 component.
    pub eta: PellicleView,
    /// Receives the chosen lobe's flags.
    pub flags: PellicleUintView,
    /// Receives the chosen lobe's number.
    pub lobe: PellicleUintView,
    /// Receives the probability with which the hero chose that lobe, 1 component.
    pub lobe_probability: PellicleView,
    /// Receives 1 where the hero alone goes in that direction, else 0.
    pub hero_only: PellicleUintView,
}
