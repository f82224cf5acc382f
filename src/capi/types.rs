//! The types that cross the C boundary. Everything here is `repr(C)`; no logic.

use libc::{c_char, ptrdiff_t, size_t};

/// What a call returned: PELLICLE_OK (0) or one of the failures below. After a failure every output
/// is as it was before the call, and pellicle_last_error() says in words what was wrong.
pub type PellicleStatus = i32;

/// Success.
pub const PELLICLE_OK: i32 = 0;
/// A NULL pointer, a wrong count, overlapping or contradictory arguments.
pub const PELLICLE_INVALID_ARGUMENT: i32 = 1;
/// A model, parameter, choice or medium of that name does not exist; the message lists those that do.
pub const PELLICLE_UNKNOWN_NAME: i32 = 2;
/// A number is outside its range, or NaN or infinite; the message gives the value and the range.
pub const PELLICLE_OUT_OF_RANGE: i32 = 3;
/// This build does not offer what was asked for (for instance a field of a later version).
pub const PELLICLE_UNSUPPORTED: i32 = 4;
/// An allocation failed.
pub const PELLICLE_OUT_OF_MEMORY: i32 = 5;
/// A defect of pellicle itself: a panic was caught at the boundary. Handles stay usable.
pub const PELLICLE_INTERNAL: i32 = 6;

/// The binary interface described by this header. It changes only when programs must be rebuilt.
pub const PELLICLE_ABI_VERSION: u32 = 1;

/// Flag of a model, a BSDF or a sampled lobe: light leaves on the side of the viewer.
pub const PELLICLE_REFLECTION: u32 = 1;
/// Light leaves on the other side. Without this flag the model is one-sided: 0 at and below the horizon.
pub const PELLICLE_TRANSMISSION: u32 = 2;
/// A broad lobe without a preferred direction.
pub const PELLICLE_DIFFUSE: u32 = 4;
/// A lobe around a preferred direction.
pub const PELLICLE_GLOSSY: u32 = 8;
/// A perfectly specular lobe: eval() returns 0 for it, only sample() finds it.
pub const PELLICLE_DELTA: u32 = 16;

/// Kind of a parameter: `components` numbers, each within [min, max].
pub const PELLICLE_KIND_NUMBER: u32 = 0;
/// Kind of a parameter: a direction in the shading frame. Any length but 0 is accepted and normalised;
/// after that its z must lie within [min, max].
pub const PELLICLE_KIND_DIRECTION: u32 = 1;
/// Kind of a parameter: one name out of a list, given in PellicleParam::choice.
pub const PELLICLE_KIND_CHOICE: u32 = 2;

/// Side of a film that the light comes from: the ambient medium.
pub const PELLICLE_SIDE_AMBIENT: u32 = 0;
/// Side of a film that the light comes from: the base.
pub const PELLICLE_SIDE_BASE: u32 = 1;

/// A compiled film: opaque, immutable, reference-counted, usable from every thread at once.
pub struct PellicleFilm {
    _private: [u8; 0],
}

/// A compiled BSDF: opaque, immutable, reference-counted, usable from every thread at once.
pub struct PellicleBsdf {
    _private: [u8; 0],
}

/// One parameter of a model, by name: either numbers (`values`, `count`) or a `choice`, never both.
/// Frozen for this ABI version.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleParam {
    /// The parameter's name, NUL-terminated; pellicle_model_param() lists them.
    pub name: *const c_char,
    /// `count` numbers. One number for a parameter with three components stands for all three
    /// (directions excepted).
    pub values: *const f32,
    /// How many numbers `values` holds.
    pub count: size_t,
    /// The chosen name for a parameter of kind CHOICE; NULL for the others.
    pub choice: *const c_char,
}

/// A parameter that the caller supplies with every call, from a texture for example.
/// Frozen for this ABI version.
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

/// A medium, given in one of three ways: by `name`, by `eta` and `k`, or by a table of measurements.
/// All zero: vacuum as a film's ambient, refused elsewhere. Frozen for this ABI version.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleMedium {
    /// "Au", "SiO2", "water", ...; upper and lower case are alike. The message for an unknown name
    /// lists the known ones.
    pub name: *const c_char,
    /// Refractive index at 645, 525 and 445 nm, each within [0.001, 1000]: linear in 1 / lambda^2
    /// between them, constant outside. Three equal values are a constant.
    pub eta: [f32; 3],
    /// Extinction, the index's imaginary part, at the same wavelengths, each within [0, 1000].
    /// 0: transparent.
    pub k: [f32; 3],
    /// `table_count` vacuum wavelengths in nm, ascending, within [1, 1e6]: the index is linear between
    /// them and constant outside. Copied.
    pub table_nm: *const f32,
    /// `table_count` refractive indices, in the range of `eta`. Copied.
    pub table_eta: *const f32,
    /// `table_count` extinctions, in the range of `k`. Copied.
    pub table_k: *const f32,
    /// How many numbers each part of the table has.
    pub table_count: size_t,
}

/// A layer of a film. Frozen for this ABI version.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleLayer {
    /// What it consists of.
    pub medium: PellicleMedium,
    /// Least thickness, nm, within [0, 1e8].
    pub thickness_min_nm: f32,
    /// Greatest thickness, nm, within [0, 1e8]. Equal to the least: fixed. At most one layer of a film
    /// may vary; its thickness comes with every call.
    pub thickness_max_nm: f32,
}

/// What film to create: layers between an ambient medium and a base. Zero-initialise it, then set
/// what you need: zero means default. Grows by appending; pass sizeof(PellicleFilmDesc).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmDesc {
    /// Where the light comes from; all zero: vacuum. It must have k = 0 and eta >= 1.
    pub ambient: PellicleMedium,
    /// The layers, the ambient's neighbour first; NULL if `layer_count` is 0. Copied.
    pub layers: *const PellicleLayer,
    /// How many layers there are, at most 64; 0: the bare base.
    pub layer_count: size_t,
    /// What the layers lie on; needed.
    pub base: PellicleMedium,
    /// The greatest error allowed of a channel of the clipped colours, within [1e-5, 1];
    /// 0: the default, 2e-3.
    pub tolerance: f32,
    /// The white in which a perfect mirror is (1, 1, 1): "E" or "D65"; NULL: "E".
    pub white: *const c_char,
    /// "rec709", "rec2020", "acescg" or "xyz", linear; NULL: "rec709".
    pub color_space: *const c_char,
    /// The name of the method of evaluation; NULL: the cheapest that holds the tolerance. The message
    /// for an unknown name lists the known ones.
    pub method: *const c_char,
    /// 1: leave colours outside [0, 1] as they are (saturated films have such, negative ones too);
    /// 0: clip them.
    pub unclipped: u32,
    /// 1: also keep the transmittance, and the reflectance from the base's side, for
    /// pellicle_film_eval(); 0: do not.
    pub transmittance: u32,
}

/// How a film is evaluated, and how well. Grows by appending; pass sizeof(PellicleFilmPlan).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmPlan {
    /// The method's name; lives as long as the film.
    pub method: *const c_char,
    /// The error that was allowed.
    pub tolerance: f32,
    /// The greatest error of a channel that was measured at creation, of the clipped colours against
    /// full wave optics.
    pub measured_max: f32,
    /// The root of the mean square of the errors measured.
    pub measured_rms: f32,
    /// Bytes of the film's tables.
    pub bytes: size_t,
    /// Why this method, in a sentence; lives as long as the film.
    pub reason: *const c_char,
}

/// What to create. Zero-initialise it, then set what you need: zero means default.
/// Grows by appending; pass sizeof(PellicleBsdfDesc).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleBsdfDesc {
    /// The model's name: "lambert", "phong", "layered", ...; pellicle_model_info() lists them.
    pub model: *const c_char,
    /// Parameters that differ from their defaults; NULL if `param_count` is 0. Copied.
    pub params: *const PellicleParam,
    /// How many entries `params` has.
    pub param_count: size_t,
    /// Parameters given per call, in the order in which their components are passed; NULL if
    /// `varying_count` is 0. Copied.
    pub varying: *const PellicleRange,
    /// How many entries `varying` has.
    pub varying_count: size_t,
    /// The film, for models that take one; retained, so release yours when you like. Given where
    /// unused or missing where needed: INVALID_ARGUMENT. If a layer of it varies, the parameter
    /// thickness_nm is needed, fixed or varying within the layer's range; if none does, it is refused.
    pub film: *const PellicleFilm,
}

/// What a BSDF is. Grows by appending; pass sizeof(PellicleBsdfInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleBsdfInfo {
    /// The model's name; lives as long as the library.
    pub model: *const c_char,
    /// PELLICLE_REFLECTION and so on, of all lobes together.
    pub flags: u32,
    /// How many parameters vary per call.
    pub varying_count: u32,
    /// How many numbers they have together: the length of `varying` in the single calls.
    pub varying_floats: u32,
    /// How many lobes sample() chooses from.
    pub lobe_count: u32,
    /// What the BSDF was specialised to, in words: terms that its values leave out, formulas that are shorter
    /// for them, and the instructions that batches run with. Lives as long as the BSDF.
    pub plan: *const c_char,
}

/// A sampled direction. Grows by appending; pass sizeof(PellicleSample).
/// No valid sample, or a random number outside [0, 1): all zero, with status PELLICLE_OK.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct PellicleSample {
    /// To the light, unit, in the shading frame.
    pub wi: [f32; 3],
    /// Density of wi per solid angle, of all lobes together; 0 for a DELTA lobe.
    pub pdf: f32,
    /// value / pdf, RGB; for a DELTA lobe the throughput over the probability of choosing it.
    pub weight: [f32; 3],
    /// Refractive index on wi's side over that on wo's side; 1 for a reflection.
    pub eta: f32,
    /// Flags of the chosen lobe: PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    pub flags: u32,
    /// Number of the chosen lobe, below PellicleBsdfInfo::lobe_count.
    pub lobe: u32,
}

/// A strided array to read: component c of element i is at
/// `(const char*)data + i * element_stride + c * component_stride`. Strides are in bytes and may be
/// negative; element_stride 0 broadcasts one element. Any alignment. Frozen for this ABI version.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleConstView {
    /// Component 0 of element 0.
    pub data: *const f32,
    /// Bytes from one element to the next.
    pub element_stride: ptrdiff_t,
    /// Bytes from one component to the next.
    pub component_stride: ptrdiff_t,
}

/// A strided array to write, addressed like PellicleConstView; data NULL = not wanted. Its elements
/// and components must not overlap one another. Frozen for this ABI version.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleView {
    /// Component 0 of element 0.
    pub data: *mut f32,
    /// Bytes from one element to the next.
    pub element_stride: ptrdiff_t,
    /// Bytes from one component to the next.
    pub component_stride: ptrdiff_t,
}

/// A strided array of whole numbers to write, one per element; data NULL = not wanted.
/// Frozen for this ABI version.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleUintView {
    /// Element 0.
    pub data: *mut u32,
    /// Bytes from one element to the next.
    pub element_stride: ptrdiff_t,
}
