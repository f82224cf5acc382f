//! Numbers, handles and views that cross the C boundary. Everything here is `repr(C)`; there is no logic.

use super::c_types::{ptrdiff_t, size_t};

/// The result of a call: PELLICLE_OK (0) or one of the failures below. After a failure every output is as
/// it was before the call, and pellicle_last_error() says in words what was wrong.
pub type PellicleStatus = i32;

/// The call succeeded.
pub const PELLICLE_OK: i32 = 0;
/// A pointer is NULL, a count or size is wrong, or arguments overlap or contradict each other.
pub const PELLICLE_INVALID_ARGUMENT: i32 = 1;
/// Nothing of that name exists. The message lists the names that do.
pub const PELLICLE_UNKNOWN_NAME: i32 = 2;
/// A number is outside its range, or NaN or infinite. The message gives the value and the range.
pub const PELLICLE_OUT_OF_RANGE: i32 = 3;
/// This build or this processor does not offer what was asked for, such as a field of a later version.
pub const PELLICLE_UNSUPPORTED: i32 = 4;
/// An allocation failed.
pub const PELLICLE_OUT_OF_MEMORY: i32 = 5;
/// Pellicle itself has a defect: a panic was caught at the boundary. Handles stay usable.
pub const PELLICLE_INTERNAL: i32 = 6;

/// The number of the binary interface that this header describes, and of the SONAME. 0 means that the
/// interface may still change between versions: rebuild programs with every new version. From 1 on it
/// changes only when programs must be rebuilt.
pub const PELLICLE_ABI_VERSION: u32 = 0;

/// Flag of a lobe, and of models and BSDFs that have one: light leaves on the side of the viewer.
pub const PELLICLE_REFLECTION: u32 = 1;
/// Light leaves on the other side. A model without this flag is one-sided: it is 0 at and below the horizon.
pub const PELLICLE_TRANSMISSION: u32 = 2;
/// The lobe is broad and has no preferred direction.
pub const PELLICLE_DIFFUSE: u32 = 4;
/// The lobe lies around a preferred direction.
pub const PELLICLE_GLOSSY: u32 = 8;
/// The lobe is perfectly specular: eval() returns 0 for it, and only sample() finds it.
pub const PELLICLE_DELTA: u32 = 16;

/// Transport of radiance, from lights along camera paths: refraction carries (eta_o / eta_i)^2.
pub const PELLICLE_TRANSPORT_RADIANCE: u32 = 0;
/// Transport of importance, along light paths and photons: that factor is left out.
pub const PELLICLE_TRANSPORT_IMPORTANCE: u32 = 1;

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

/// PellicleFilmDesc::base_opaque: light that has entered the base is followed there if the base's k is at most
/// 1e-3 at 550 nm, so that 1 / e of the power is left after 44 um or more.
pub const PELLICLE_BASE_BY_K: u32 = 0;
/// PellicleFilmDesc::base_opaque: what enters the base is absorbed, whatever its k is.
pub const PELLICLE_BASE_OPAQUE: u32 = 1;
/// PellicleFilmDesc::base_opaque: light in the base is followed, whatever its k is.
pub const PELLICLE_BASE_TRANSPARENT: u32 = 2;

/// List for pellicle_name(): the methods of evaluating a film.
pub const PELLICLE_NAMES_METHOD: u32 = 0;
/// List for pellicle_name(): the colour spaces, the default first.
pub const PELLICLE_NAMES_COLOR_SPACE: u32 = 1;
/// List for pellicle_name(): the whites, the default first.
pub const PELLICLE_NAMES_WHITE: u32 = 2;
/// List for pellicle_name(): the SIMD levels of this processor, the narrowest first; the last one is the
/// default.
pub const PELLICLE_NAMES_SIMD_LEVEL: u32 = 3;

/// A compiled film. It is opaque, immutable and reference-counted, and every thread may use it at once.
pub struct PellicleFilm {
    _private: [u8; 0],
}

/// A compiled BSDF. It is opaque, immutable and reference-counted, and every thread may use it at once.
pub struct PellicleBsdf {
    _private: [u8; 0],
}

/// How to evaluate, sample or integrate in one call. NULL instead of a pointer to it, or zeros, mean
/// radiance and every lobe. It begins with its own size and grows by appending.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleCall {
    /// sizeof(PellicleCall).
    pub size: size_t,
    /// PELLICLE_TRANSPORT_RADIANCE or PELLICLE_TRANSPORT_IMPORTANCE.
    pub transport: u32,
    /// A mask of lobe flags: a lobe belongs to the call if all its flags are in the mask. Values, densities,
    /// selection and samples are those of these lobes alone. 0: every lobe.
    pub lobes: u32,
}

/// A strided array to read: component c of element i is at
/// `(const char*)data + i * element_stride + c * component_stride`. Strides are in bytes and may be
/// negative; element_stride 0 broadcasts one element. Any alignment. Frozen.
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

/// A strided array to write, addressed like PellicleConstView. data NULL means that it is not wanted. Its
/// elements and components must not overlap one another. Any alignment. Frozen.
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

/// A strided array of whole numbers to write, one per element. data NULL means that it is not wanted. Any
/// alignment. Frozen.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleUintView {
    /// Element 0.
    pub data: *mut u32,
    /// Bytes from one element to the next.
    pub element_stride: ptrdiff_t,
}
