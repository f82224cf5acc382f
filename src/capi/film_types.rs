//! The structs of a film: media and layers, its description, its plan, and the arguments of its batch.

use super::c_types::{c_char, size_t};
use super::types::{PellicleConstView, PellicleView};

/// A medium, given in one of three ways: by `name`, by `eta` and `k`, or by a table of measurements.
/// All zero means vacuum as a film's ambient and is refused elsewhere. It grows by appending; its size
/// stands in PellicleFilmDesc::medium_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleMedium {
    /// "Au", "SiO2", "water", ...; upper and lower case are alike. pellicle_medium_info() lists the names.
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
    /// Number of entries in each of the three arrays of the table.
    pub table_count: size_t,
}

/// A layer of a film. It grows by appending; its size stands in PellicleFilmDesc::layer_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleLayer {
    /// The layer's medium. Copied.
    pub medium: *const PellicleMedium,
    /// Least thickness, nm, within [0, 1e8].
    pub thickness_min_nm: f32,
    /// Greatest thickness, nm, within [0, 1e8]. Equal to the least: fixed. At most one layer of a film
    /// may vary; its thickness comes with every call.
    pub thickness_max_nm: f32,
}

/// What film to create: layers between an ambient medium and a base. Zero-initialise it, then set
/// what you need: zero means default. It grows by appending; pass sizeof(PellicleFilmDesc).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmDesc {
    /// sizeof(PellicleMedium); needed.
    pub medium_size: size_t,
    /// sizeof(PellicleLayer): the bytes from one layer to the next. Needed if there are layers.
    pub layer_size: size_t,
    /// Where the light comes from; NULL: vacuum. It must have k = 0 and eta >= 1. Copied.
    pub ambient: *const PellicleMedium,
    /// The layers, the ambient's neighbour first; NULL if `layer_count` is 0. Copied.
    pub layers: *const PellicleLayer,
    /// Number of layers, at most 64; 0: the bare base.
    pub layer_count: size_t,
    /// What the layers lie on; needed. Copied.
    pub base: *const PellicleMedium,
    /// The greatest error allowed of a channel of the clipped colours, within [1e-5, 1];
    /// 0: the default, 2e-3.
    pub tolerance: f32,
    /// 1: leave colours outside [0, 1] as they are (saturated films have such, negative ones too);
    /// 0: clip them.
    pub unclipped: u32,
    /// 1: also keep the transmittance, and the reflectance from the base's side, for
    /// pellicle_film_eval(); 0: do not.
    pub transmittance: u32,
    /// The white in which a perfect mirror is (1, 1, 1): "E" or "D65"; NULL: "E".
    pub white: *const c_char,
    /// "rec709", "rec2020", "acescg" or "xyz", linear; NULL: "rec709".
    pub color_space: *const c_char,
    /// The name of the method of evaluation, out of PELLICLE_NAMES_METHOD; NULL: the cheapest that holds the
    /// tolerance.
    pub method: *const c_char,
    /// The instructions of batches, out of PELLICLE_NAMES_SIMD_LEVEL; NULL: the widest. For tests: the
    /// results are the same.
    pub simd_level: *const c_char,
    /// PELLICLE_BASE_BY_K, PELLICLE_BASE_OPAQUE or PELLICLE_BASE_TRANSPARENT: whether light that has entered the base
    /// is followed there. It decides whether the model "film" has the flag TRANSMISSION and whether light comes from
    /// the base's side, never what is reflected and what enters from the ambient's side.
    pub base_opaque: u32,
    /// 1: pellicle_film_spectrum() also answers outside the ranges of wavelengths of the media, where their indices
    /// are taken to be constant; 0: it refuses that. A named medium has the range of its data (PellicleMediumInfo), a
    /// table that of its entries, a constant given by `eta` and `k` all wavelengths, and one that disperses 380-780 nm.
    pub extrapolate: u32,
    /// The greatest standard deviation of the thickness that varies which calls may give, nm, within [0, 1e8];
    /// 0: calls give none. Where averages of up to 64 look-ups do not suffice, tables of averages are made, which
    /// PellicleFilmPlan::bytes counts. No layer that varies: INVALID_ARGUMENT.
    pub thickness_spread_max_nm: f32,
}

/// What a film is. It grows by appending; pass sizeof(PellicleFilmInfo).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmInfo {
    /// 1: a layer's thickness varies and comes with every call; 0: none does.
    pub varies: u32,
    /// 1: pellicle_film_eval() can be called; 0: the film keeps no transmittance.
    pub transmittance: u32,
    /// Least thickness of the layer that varies, nm; 0 if none does.
    pub thickness_min_nm: f32,
    /// Greatest thickness of the layer that varies, nm; 0 if none does.
    pub thickness_max_nm: f32,
    /// 1: what enters the base is absorbed, and no light comes from it; 0: light in the base is followed. By the
    /// base's k and PellicleFilmDesc::base_opaque.
    pub base_opaque: u32,
    /// The attenuation 4 pi k / lambda of light in the base, per millimetre, RGB: the absorption coefficient of the
    /// renderer's volume there. The mean of each channel under its weights, which is exact for short paths; a channel
    /// whose negative weights prevail has 0.
    pub base_attenuation_per_mm: [f32; 3],
    /// The least wavelength that all media are known for, nm; PellicleFilmDesc::extrapolate tells their ranges. Greater
    /// than `lambda_max_nm` if there is none.
    pub lambda_min_nm: f32,
    /// The greatest wavelength that all media are known for, nm; infinite if all are constant.
    pub lambda_max_nm: f32,
    /// The greatest standard deviation of the thickness that calls may give, nm; 0: they may give none.
    pub thickness_spread_max_nm: f32,
}

/// How a film is evaluated, and how well. It grows by appending; pass sizeof(PellicleFilmPlan).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmPlan {
    /// The method's name. It lives as long as the library.
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
    /// Why this method was chosen, in a sentence. It lives as long as the film.
    pub reason: *const c_char,
    /// How light from the ambient's side is evaluated.
    pub ambient: PellicleFilmSidePlan,
    /// How light from the base's side is evaluated. All 0 if the film keeps no transmittance or its base is opaque.
    pub base: PellicleFilmSidePlan,
    /// The index of the ambient that directions of refraction follow, at `eta_lambda_nm`.
    pub eta_ambient: f32,
    /// The index of the base that directions of refraction follow, its real part, at `eta_lambda_nm`.
    pub eta_base: f32,
    /// The wavelength of these indices, nm: 550.
    pub eta_lambda_nm: f32,
}

/// How a film evaluates light from one side. Frozen.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmSidePlan {
    /// The method's name. It lives as long as the library.
    pub method: *const c_char,
    /// The greatest error of a channel that was measured on this side at creation.
    pub measured_max: f32,
    /// The root of the mean square of the errors measured on this side.
    pub measured_rms: f32,
    /// Estimated nanoseconds of one call, on one core of a 2024 server with nothing else to do: of pellicle_film_eval()
    /// if the film keeps its transmittance, of pellicle_film_reflectance() if not. Tables are estimated to a factor of
    /// two, the methods "series" and "reference" to an order of magnitude.
    pub cost_ns: f32,
    /// The greatest part of the light that the layers absorb, of a channel, at the points looked at; 0 if no layer
    /// absorbs. What enters a base that absorbs counts as transmitted.
    pub absorbed_max: f32,
}

/// Arguments of pellicle_film_reflectance_batch(). Zero-initialise them. They grow by appending; pass
/// sizeof(PellicleFilmBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleFilmBatchArgs {
    /// Number of elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Cosines of incidence in the ambient medium, 1 component.
    pub cos_theta: PellicleConstView,
    /// Thicknesses of the layer that varies, nm, 1 component; data may be NULL only if none varies.
    pub thickness_nm: PellicleConstView,
    /// Receives the reflectance, 3 components.
    pub reflectance: PellicleView,
    /// Standard deviations of the thickness, nm, 1 component, as in pellicle_film_reflectance_spread(); data NULL: 0.
    /// One that single calls refuse is refused whichever element it belongs to, and nothing is written.
    pub thickness_spread_nm: PellicleConstView,
}

/// Complex ratios of the electric fields of reflected and transmitted light to that of the incident light:
/// real part, imaginary part. pellicle_film_amplitudes() states signs and phases. Frozen.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleAmplitudes {
    /// Reflected, E parallel to the layers.
    pub r_s: [f32; 2],
    /// Reflected, H parallel to the layers.
    pub r_p: [f32; 2],
    /// Transmitted, E parallel to the layers.
    pub t_s: [f32; 2],
    /// Transmitted, H parallel to the layers.
    pub t_p: [f32; 2],
}

/// Arguments of pellicle_film_amplitudes_batch(). Zero-initialise them. They grow by appending; pass
/// sizeof(PellicleAmplitudesBatchArgs).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PellicleAmplitudesBatchArgs {
    /// Number of elements; 0 is allowed and does nothing.
    pub count: size_t,
    /// Number of wavelengths of each element; 0 is allowed and does nothing.
    pub lambda_count: size_t,
    /// Vacuum wavelengths, nm, `lambda_count` components; element_stride 0 gives all elements the same.
    pub lambda_nm: PellicleConstView,
    /// Cosines of incidence, 1 component.
    pub cos_theta: PellicleConstView,
    /// Thicknesses of the layer that varies, nm, 1 component; data may be NULL only if none varies.
    pub thickness_nm: PellicleConstView,
    /// Receives r_s, 2 `lambda_count` components: real and imaginary part at the first wavelength, then those
    /// at the next.
    pub r_s: PellicleView,
    /// Receives r_p likewise.
    pub r_p: PellicleView,
    /// Receives t_s likewise.
    pub t_s: PellicleView,
    /// Receives t_p likewise.
    pub t_p: PellicleView,
    /// Where the light comes from: PELLICLE_SIDE_AMBIENT (0) or PELLICLE_SIDE_BASE.
    pub side: u32,
}
