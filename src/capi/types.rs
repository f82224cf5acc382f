//! The types that cross the C boundary. Everything here is `repr(C)`; no logic.

use libc::{c_char, ptrdiff_t, size_t};

/// What a call returned: PELLICLE_OK (0) or one of the failures below. After a failure every output
/// is as it was before the call, and pellicle_last_error() says in words what was wrong.
pub type PellicleStatus = i32;

/// Success.
pub const PELLICLE_OK: i32 = 0;
/// A NULL pointer, a wrong count, overlapping or contradictory arguments.
pub const PELLICLE_INVALID_ARGUMENT: i32 = 1;
/// A model, parameter or choice of that name does not exist; the message lists those that do.
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
    /// to it: the only clamp there is. NaN or infinity there gives 0 for that element.
    pub max: f32,
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
