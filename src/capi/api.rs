//! All functions in one table, for programs that load the library at run time.

use super::args::{
    PellicleEvalBatchArgs, PellicleFilmBatchArgs, PellicleModelInfo, PellicleModelParam,
    PellicleSampleBatchArgs,
};
use super::types::{
    PELLICLE_ABI_VERSION, PellicleBsdf, PellicleBsdfDesc, PellicleBsdfInfo, PellicleFilm,
    PellicleFilmDesc, PellicleFilmPlan, PellicleSample, PellicleStatus,
};
use super::{batch, bsdf, film, model, version};
use libc::{c_char, size_t};

/// Every function of this header, by its name without the prefix. Grows by appending: before using
/// a member that was added later, check that it lies within `size`.
#[repr(C)]
pub struct PellicleApi {
    /// Bytes in this table.
    pub size: size_t,
    /// pellicle_abi_version()
    pub abi_version: extern "C" fn() -> u32,
    /// pellicle_version_string()
    pub version_string: extern "C" fn() -> *const c_char,
    /// pellicle_status_string()
    pub status_string: extern "C" fn(status: PellicleStatus) -> *const c_char,
    /// pellicle_last_error()
    pub last_error: extern "C" fn() -> *const c_char,
    /// pellicle_model_count()
    pub model_count: extern "C" fn() -> size_t,
    /// pellicle_model_info()
    pub model_info: unsafe extern "C" fn(
        model: size_t,
        info: *mut PellicleModelInfo,
        info_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_model_param()
    pub model_param: unsafe extern "C" fn(
        model: size_t,
        param: size_t,
        info: *mut PellicleModelParam,
        info_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_bsdf_create()
    pub bsdf_create: unsafe extern "C" fn(
        desc: *const PellicleBsdfDesc,
        desc_size: size_t,
        bsdf: *mut *mut PellicleBsdf,
    ) -> PellicleStatus,
    /// pellicle_bsdf_retain()
    pub bsdf_retain: unsafe extern "C" fn(bsdf: *mut PellicleBsdf) -> PellicleStatus,
    /// pellicle_bsdf_release()
    pub bsdf_release: unsafe extern "C" fn(bsdf: *mut PellicleBsdf),
    /// pellicle_bsdf_info()
    pub bsdf_info: unsafe extern "C" fn(
        bsdf: *const PellicleBsdf,
        info: *mut PellicleBsdfInfo,
        info_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_bsdf_eval()
    pub bsdf_eval: unsafe extern "C" fn(
        bsdf: *const PellicleBsdf,
        wo: *const f32,
        wi: *const f32,
        varying: *const f32,
        value: *mut f32,
        pdf: *mut f32,
    ) -> PellicleStatus,
    /// pellicle_bsdf_sample()
    pub bsdf_sample: unsafe extern "C" fn(
        bsdf: *const PellicleBsdf,
        wo: *const f32,
        u: *const f32,
        varying: *const f32,
        sample: *mut PellicleSample,
        sample_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_bsdf_albedo()
    pub bsdf_albedo: unsafe extern "C" fn(
        bsdf: *const PellicleBsdf,
        wo: *const f32,
        varying: *const f32,
        albedo: *mut f32,
    ) -> PellicleStatus,
    /// pellicle_bsdf_eval_batch()
    pub bsdf_eval_batch: unsafe extern "C" fn(
        bsdf: *const PellicleBsdf,
        args: *const PellicleEvalBatchArgs,
        args_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_bsdf_sample_batch()
    pub bsdf_sample_batch: unsafe extern "C" fn(
        bsdf: *const PellicleBsdf,
        args: *const PellicleSampleBatchArgs,
        args_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_film_create()
    pub film_create: unsafe extern "C" fn(
        desc: *const PellicleFilmDesc,
        desc_size: size_t,
        film: *mut *mut PellicleFilm,
    ) -> PellicleStatus,
    /// pellicle_film_retain()
    pub film_retain: unsafe extern "C" fn(film: *mut PellicleFilm) -> PellicleStatus,
    /// pellicle_film_release()
    pub film_release: unsafe extern "C" fn(film: *mut PellicleFilm),
    /// pellicle_film_plan()
    pub film_plan: unsafe extern "C" fn(
        film: *const PellicleFilm,
        plan: *mut PellicleFilmPlan,
        plan_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_film_reflectance()
    pub film_reflectance: unsafe extern "C" fn(
        film: *const PellicleFilm,
        cos_theta: f32,
        thickness_nm: f32,
        rgb: *mut f32,
    ) -> PellicleStatus,
    /// pellicle_film_eval()
    pub film_eval: unsafe extern "C" fn(
        film: *const PellicleFilm,
        cos_theta: f32,
        thickness_nm: f32,
        side: u32,
        reflectance: *mut f32,
        transmittance: *mut f32,
    ) -> PellicleStatus,
    /// pellicle_film_reflectance_batch()
    pub film_reflectance_batch: unsafe extern "C" fn(
        film: *const PellicleFilm,
        args: *const PellicleFilmBatchArgs,
        args_size: size_t,
    ) -> PellicleStatus,
    /// pellicle_film_reference()
    pub film_reference: unsafe extern "C" fn(
        film: *const PellicleFilm,
        cos_theta: f32,
        thickness_nm: f32,
        rgb: *mut f32,
    ) -> PellicleStatus,
    /// pellicle_film_spectrum()
    pub film_spectrum: unsafe extern "C" fn(
        film: *const PellicleFilm,
        cos_theta: f32,
        thickness_nm: f32,
        lambda_nm: *const f32,
        count: size_t,
        reflectance: *mut f32,
    ) -> PellicleStatus,
}

static API: PellicleApi = PellicleApi {
    size: size_of::<PellicleApi>(),
    abi_version: version::pellicle_abi_version,
    version_string: version::pellicle_version_string,
    status_string: version::pellicle_status_string,
    last_error: version::pellicle_last_error,
    model_count: model::pellicle_model_count,
    model_info: model::pellicle_model_info,
    model_param: model::pellicle_model_param,
    bsdf_create: bsdf::pellicle_bsdf_create,
    bsdf_retain: bsdf::pellicle_bsdf_retain,
    bsdf_release: bsdf::pellicle_bsdf_release,
    bsdf_info: bsdf::pellicle_bsdf_info,
    bsdf_eval: bsdf::pellicle_bsdf_eval,
    bsdf_sample: bsdf::pellicle_bsdf_sample,
    bsdf_albedo: bsdf::pellicle_bsdf_albedo,
    bsdf_eval_batch: batch::pellicle_bsdf_eval_batch,
    bsdf_sample_batch: batch::pellicle_bsdf_sample_batch,
    film_create: film::pellicle_film_create,
    film_retain: film::pellicle_film_retain,
    film_release: film::pellicle_film_release,
    film_plan: film::pellicle_film_plan,
    film_reflectance: film::pellicle_film_reflectance,
    film_eval: film::pellicle_film_eval,
    film_reflectance_batch: batch::pellicle_film_reflectance_batch,
    film_reference: film::pellicle_film_reference,
    film_spectrum: film::pellicle_film_spectrum,
};

/// The table of functions, for dlsym(): the one symbol to look up. Pass PELLICLE_ABI_VERSION; NULL
/// if the library that runs has another one. The table lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn pellicle_get_api(abi_version: u32) -> *const PellicleApi {
    if abi_version == PELLICLE_ABI_VERSION {
        &API
    } else {
        std::ptr::null()
    }
}
