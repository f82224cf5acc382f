//! A panic injected in each entry point: it becomes INTERNAL, and leaves outputs, the process and every
//! handle as they were.
//!
//! The injection is compiled for unit tests alone, so that no library that is shipped holds it.

use super::*;
use crate::bsdf::{Bsdf, Description};
use crate::film::{Film, FilmDescription};
use crate::optics::Medium;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::ffi::CStr;
use std::ptr::{null, null_mut};
use std::sync::Arc;

thread_local! {
    static IS_ARMED: Cell<bool> = const { Cell::new(false) };
}

/// The body of an entry point as `guard` runs it in unit tests: it panics first if a test has asked for that.
pub(super) fn injected<R>(body: impl FnOnce() -> R) -> impl FnOnce() -> R {
    || {
        assert!(!IS_ARMED.take(), "injected panic");
        body()
    }
}

/// Runs a call whose entry point panics.
fn with_panic<R>(call: impl FnOnce() -> R) -> R {
    IS_ARMED.set(true);
    let result = call();
    assert!(!IS_ARMED.take(), "the call passed no guard");
    result
}

/// Functions that pass no guard: they return constants.
const INFALLIBLE: [&str; 7] = [
    "pellicle_abi_version",
    "pellicle_version_string",
    "pellicle_status_string",
    "pellicle_last_error",
    "pellicle_model_count",
    "pellicle_medium_count",
    "pellicle_get_api",
];

const PATTERN: f32 = -77.0;
const UP: [f32; 3] = [0.0, 0.0, 1.0];

/// What the calls are made with.
struct Handles {
    bsdf: *mut PellicleBsdf,
    film: *mut PellicleFilm,
    /// The film as it is saved.
    block: Vec<u8>,
}

impl Handles {
    fn new() -> Self {
        let glass = Medium::rgb([1.5; 3], [0.0; 3]).unwrap();
        let description = FilmDescription {
            transmittance: true,
            ..FilmDescription::new(glass)
        };
        let film = Arc::new(Film::new(&description).unwrap());
        let varying = Description::new("lambert").vary("reflectance", 0.0, 1.0);
        Self {
            block: film.to_bytes().unwrap(),
            bsdf: bsdf_handle(Bsdf::new(&varying).unwrap()),
            film: film_handle(film, None).unwrap(),
        }
    }
}

/// Every number that a call may write, with a pattern that none does.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Outputs {
    numbers: [f32; 16],
    bsdf: *mut PellicleBsdf,
    film: *mut PellicleFilm,
    /// Room for the greatest struct.
    bytes: [u8; 256],
}

impl Outputs {
    fn new() -> Self {
        Self {
            numbers: [PATTERN; 16],
            bsdf: null_mut(),
            film: null_mut(),
            bytes: [0x5A; 256],
        }
    }
}

/// A valid call of one entry point.
type Call = fn(&Handles, &mut Outputs) -> PellicleStatus;

fn const_view(data: &[f32]) -> PellicleConstView {
    PellicleConstView {
        data: data.as_ptr(),
        element_stride: 0,
        component_stride: 4,
    }
}

fn view(data: *mut f32) -> PellicleView {
    PellicleView {
        data,
        element_stride: 12,
        component_stride: 4,
    }
}

/// The calls, by name.
fn calls() -> Vec<(&'static str, Call)> {
    // SAFETY, of all: live handles; outputs and arrays as long as stated; 0 is valid for what is zeroed.
    vec![
        ("pellicle_model_info", |_, out| unsafe {
            pellicle_model_info(
                0,
                out.bytes.as_mut_ptr().cast(),
                size_of::<PellicleModelInfo>(),
            )
        }),
        ("pellicle_model_param", |_, out| unsafe {
            pellicle_model_param(
                0,
                0,
                out.bytes.as_mut_ptr().cast(),
                size_of::<PellicleModelParam>(),
            )
        }),
        ("pellicle_medium_info", |_, out| unsafe {
            let info = out.bytes.as_mut_ptr().cast();
            pellicle_medium_info(0, info, size_of::<PellicleMediumInfo>())
        }),
        ("pellicle_bsdf_create", |_, out| unsafe {
            let mut desc: PellicleBsdfDesc = std::mem::zeroed();
            desc.model = c"phong".as_ptr();
            pellicle_bsdf_create(&desc, size_of_val(&desc), &mut out.bsdf)
        }),
        ("pellicle_bsdf_info", |handles, out| unsafe {
            let info = out.bytes.as_mut_ptr().cast();
            pellicle_bsdf_info(handles.bsdf, info, size_of::<PellicleBsdfInfo>())
        }),
        ("pellicle_bsdf_varying", |handles, out| unsafe {
            let info = out.bytes.as_mut_ptr().cast();
            pellicle_bsdf_varying(handles.bsdf, 0, info, size_of::<PellicleVaryingInfo>())
        }),
        ("pellicle_bsdf_lobe", |handles, out| unsafe {
            let info = out.bytes.as_mut_ptr().cast();
            pellicle_bsdf_lobe(handles.bsdf, 0, info, size_of::<PellicleLobeInfo>())
        }),
        ("pellicle_bsdf_eval", |handles, out| unsafe {
            let [value, pdf, reverse] = [0, 3, 4].map(|at| out.numbers.as_mut_ptr().add(at));
            let up = UP.as_ptr();
            pellicle_bsdf_eval(handles.bsdf, up, up, null(), null(), value, pdf, reverse)
        }),
        ("pellicle_bsdf_sample", |handles, out| unsafe {
            let sample = out.numbers.as_mut_ptr().cast();
            let size = size_of::<PellicleSample>();
            pellicle_bsdf_sample(
                handles.bsdf,
                UP.as_ptr(),
                [0.5; 3].as_ptr(),
                null(),
                null(),
                sample,
                size,
            )
        }),
        ("pellicle_bsdf_albedo", |handles, out| unsafe {
            let albedo = out.numbers.as_mut_ptr();
            pellicle_bsdf_albedo(handles.bsdf, UP.as_ptr(), null(), null(), albedo)
        }),
        ("pellicle_bsdf_eval_batch", |handles, out| unsafe {
            let mut args: PellicleEvalBatchArgs = std::mem::zeroed();
            args.count = 5;
            [args.wo, args.wi] = [const_view(&UP); 2];
            args.value = view(out.numbers.as_mut_ptr());
            pellicle_bsdf_eval_batch(handles.bsdf, &args, size_of_val(&args))
        }),
        ("pellicle_bsdf_sample_batch", |handles, out| unsafe {
            let mut args: PellicleSampleBatchArgs = std::mem::zeroed();
            args.count = 5;
            args.wo = const_view(&UP);
            args.u = const_view(&[0.5; 3]);
            args.weight = view(out.numbers.as_mut_ptr());
            pellicle_bsdf_sample_batch(handles.bsdf, &args, size_of_val(&args))
        }),
        ("pellicle_bsdf_eval_spectral", |handles, out| unsafe {
            let [value, pdf] = [0, 1].map(|at| out.numbers.as_mut_ptr().add(at));
            let up = UP.as_ptr();
            let nm = [550.0].as_ptr();
            pellicle_bsdf_eval_spectral(handles.bsdf, up, up, null(), null(), nm, 1, value, pdf)
        }),
        ("pellicle_bsdf_sample_spectral", |handles, out| unsafe {
            let [weight, pdf] = [0, 1].map(|at| out.numbers.as_mut_ptr().add(at));
            pellicle_bsdf_sample_spectral(
                handles.bsdf,
                UP.as_ptr(),
                [0.5; 3].as_ptr(),
                null(),
                null(),
                [550.0].as_ptr(),
                1,
                0,
                weight,
                pdf,
                out.bytes.as_mut_ptr().cast(),
                size_of::<PellicleSpectralSample>(),
            )
        }),
        ("pellicle_bsdf_eval_spectral_batch", |handles, out| unsafe {
            let mut args: PellicleEvalSpectralBatchArgs = std::mem::zeroed();
            [args.count, args.lambda_count] = [5, 1];
            [args.wo, args.wi] = [const_view(&UP); 2];
            args.lambda_nm = const_view(&[550.0; 3]);
            args.value = view(out.numbers.as_mut_ptr());
            pellicle_bsdf_eval_spectral_batch(handles.bsdf, &args, size_of_val(&args))
        }),
        (
            "pellicle_bsdf_sample_spectral_batch",
            |handles, out| unsafe {
                let mut args: PellicleSampleSpectralBatchArgs = std::mem::zeroed();
                [args.count, args.lambda_count] = [5, 1];
                args.wo = const_view(&UP);
                args.u = const_view(&[0.5; 3]);
                args.lambda_nm = const_view(&[550.0; 3]);
                args.weight = view(out.numbers.as_mut_ptr());
                pellicle_bsdf_sample_spectral_batch(handles.bsdf, &args, size_of_val(&args))
            },
        ),
        ("pellicle_film_create", |_, out| unsafe {
            let mut desc: PellicleFilmDesc = std::mem::zeroed();
            let mut glass: PellicleMedium = std::mem::zeroed();
            glass.eta = [1.5; 3];
            desc.medium_size = size_of_val(&glass);
            desc.base = &glass;
            pellicle_film_create(&desc, size_of_val(&desc), &mut out.film)
        }),
        ("pellicle_film_save", |handles, out| unsafe {
            pellicle_film_save(handles.film, null_mut(), 0, out.bytes.as_mut_ptr().cast())
        }),
        ("pellicle_film_load", |handles, out| unsafe {
            let block = &handles.block;
            pellicle_film_load(block.as_ptr().cast(), block.len(), &mut out.film)
        }),
        ("pellicle_film_info", |handles, out| unsafe {
            let info = out.bytes.as_mut_ptr().cast();
            pellicle_film_info(handles.film, info, size_of::<PellicleFilmInfo>())
        }),
        ("pellicle_film_plan", |handles, out| unsafe {
            let plan = out.bytes.as_mut_ptr().cast();
            pellicle_film_plan(handles.film, plan, size_of::<PellicleFilmPlan>())
        }),
        ("pellicle_film_reflectance", |handles, out| unsafe {
            pellicle_film_reflectance(handles.film, 0.5, 0.0, out.numbers.as_mut_ptr())
        }),
        ("pellicle_film_eval", |handles, out| unsafe {
            let [one, other] = [0, 3].map(|at| out.numbers.as_mut_ptr().add(at));
            pellicle_film_eval(handles.film, 0.5, 0.0, PELLICLE_SIDE_BASE, one, other)
        }),
        ("pellicle_film_reflectance_spread", |handles, out| unsafe {
            let rgb = out.numbers.as_mut_ptr();
            pellicle_film_reflectance_spread(handles.film, 0.5, 0.0, 0.0, rgb)
        }),
        ("pellicle_film_eval_spread", |handles, out| unsafe {
            let [one, other] = [0, 3].map(|at| out.numbers.as_mut_ptr().add(at));
            let (film, side) = (handles.film, PELLICLE_SIDE_BASE);
            pellicle_film_eval_spread(film, 0.5, 0.0, 0.0, side, one, other)
        }),
        ("pellicle_film_reflectance_batch", |handles, out| unsafe {
            let mut args: PellicleFilmBatchArgs = std::mem::zeroed();
            args.count = 5;
            args.cos_theta = const_view(&[0.5]);
            args.reflectance = view(out.numbers.as_mut_ptr());
            pellicle_film_reflectance_batch(handles.film, &args, size_of_val(&args))
        }),
        ("pellicle_film_reference", |handles, out| unsafe {
            pellicle_film_reference(handles.film, 0.5, 0.0, out.numbers.as_mut_ptr())
        }),
        ("pellicle_film_spectrum", |handles, out| unsafe {
            let wavelength_nm = 550.0;
            pellicle_film_spectrum(
                handles.film,
                0.5,
                0.0,
                &wavelength_nm,
                1,
                out.numbers.as_mut_ptr(),
            )
        }),
        ("pellicle_film_spectrum_eval", |handles, out| unsafe {
            let [one, other] = [0, 1].map(|at| out.numbers.as_mut_ptr().add(at));
            let (film, nm, side) = (handles.film, 550.0, PELLICLE_SIDE_BASE);
            pellicle_film_spectrum_eval(film, 0.5, 0.0, side, &nm, 1, one, other)
        }),
        ("pellicle_film_amplitudes", |handles, out| unsafe {
            let (film, nm, side) = (handles.film, 550.0, PELLICLE_SIDE_BASE);
            let amplitudes = out.numbers.as_mut_ptr().cast();
            pellicle_film_amplitudes(film, 0.5, 0.0, side, &nm, 1, amplitudes)
        }),
        ("pellicle_film_amplitudes_batch", |handles, out| unsafe {
            let mut args: PellicleAmplitudesBatchArgs = std::mem::zeroed();
            (args.count, args.lambda_count) = (5, 1);
            args.lambda_nm = const_view(&[550.0]);
            args.cos_theta = const_view(&[0.5]);
            args.r_s = view(out.numbers.as_mut_ptr());
            pellicle_film_amplitudes_batch(handles.film, &args, size_of_val(&args))
        }),
    ]
}

/// The functions that the header declares.
fn declared() -> BTreeSet<&'static str> {
    let header = include_str!("../../include/pellicle.h");
    let code = header
        .lines()
        .filter(|line| !line.starts_with([' ', '/', '#']));
    let named = code.filter_map(|line| {
        let (before, _) = line.split_once('(')?;
        let name = before.rsplit([' ', '*']).next()?;
        name.starts_with("pellicle_").then_some(name)
    });
    named.collect()
}

fn message() -> String {
    // SAFETY: NUL-terminated, until this thread's next failure.
    let message = unsafe { CStr::from_ptr(pellicle_last_error()) };
    message.to_str().unwrap().to_owned()
}

#[test]
fn a_panic_in_any_entry_point_is_reported_and_harms_nothing() {
    let handles = Handles::new();
    for (name, call) in calls() {
        let mut expected = Outputs::new();
        assert_eq!(
            call(&handles, &mut expected),
            PELLICLE_OK,
            "{name}: {}",
            message()
        );
        let mut outputs = Outputs::new();
        let status = with_panic(|| call(&handles, &mut outputs));
        assert_eq!(status, PELLICLE_INTERNAL, "{name}");
        assert!(
            message().contains("injected panic"),
            "{name}: {}",
            message()
        );
        assert_eq!(outputs, Outputs::new(), "{name}");
        // Every call still does what it did, on the handles that were there.
        for (other, call) in calls() {
            assert_eq!(
                call(&handles, &mut Outputs::new()),
                PELLICLE_OK,
                "{other} after {name}"
            );
        }
        assert_eq!(call(&handles, &mut outputs), PELLICLE_OK, "{name}");
        assert_eq!(outputs.numbers, expected.numbers, "{name}");
    }
}

/// A panic under another rounding than the default leaves that rounding as it was.
#[cfg(all(target_arch = "x86_64", not(miri)))]
#[test]
fn a_panic_leaves_the_floating_point_state() {
    let handles = Handles::new();
    for (name, call) in calls() {
        let mut outputs = Outputs::new();
        let mut status = PELLICLE_OK;
        IS_ARMED.set(true);
        let is_kept = super::float_control::is_kept_by(|| status = call(&handles, &mut outputs));
        assert_eq!(status, PELLICLE_INTERNAL, "{name}");
        assert!(is_kept, "{name}");
    }
}

/// Functions that return no status: a panic in them ends there.
#[test]
fn a_panic_without_a_status_ends_in_the_call() {
    let handles = Handles::new();
    // SAFETY: live handles: the panic comes before a reference is added or given up.
    unsafe {
        with_panic(|| pellicle_bsdf_retain(handles.bsdf));
        with_panic(|| pellicle_film_retain(handles.film));
        with_panic(|| pellicle_bsdf_release(handles.bsdf));
        with_panic(|| pellicle_film_release(handles.film));
        assert!(with_panic(|| pellicle_name(PELLICLE_NAMES_WHITE, 0)).is_null());
    }
    for (name, call) in calls() {
        assert_eq!(call(&handles, &mut Outputs::new()), PELLICLE_OK, "{name}");
    }
}

/// Guards the list above: an entry point that is added must be tried.
#[test]
fn every_function_of_the_header_is_tried() {
    let without_status = [
        "pellicle_bsdf_retain",
        "pellicle_bsdf_release",
        "pellicle_film_retain",
        "pellicle_film_release",
        "pellicle_name",
    ];
    let tried = calls().into_iter().map(|(name, _)| name);
    let known: BTreeSet<_> = tried.chain(without_status).chain(INFALLIBLE).collect();
    assert_eq!(known, declared());
}
