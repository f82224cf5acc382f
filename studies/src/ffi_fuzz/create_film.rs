//! Films of any description, and calls of those that can be made. Thicknesses, layers and tolerances that
//! would be valid are kept small, so that a film takes milliseconds.

use super::bytes::Bytes;
use super::outcome::{Output, must_be_within, succeeded};
use super::texts::Texts;
use pellicle::capi::*;
use pellicle::film::METHODS;
use std::ffi::CStr;
use std::ptr::null;

const MEDIA: [&str; 8] = ["air", "SiO2", "TiO2", "Au", "bk7", "H2O", "Si", "Al"];
const WHITES: [&str; 2] = ["E", "D65"];
const SPACES: [&str; 4] = ["rec709", "rec2020", "acescg", "xyz"];

const MOST_LAYERS: usize = 3;
const MOST_THICKNESS_NM: f32 = 800.0;
const LEAST_TOLERANCE: f32 = 5e-3;

/// Every documented failure of creation.
const FAILURES: [PellicleStatus; 5] = [
    PELLICLE_INVALID_ARGUMENT,
    PELLICLE_UNKNOWN_NAME,
    PELLICLE_OUT_OF_RANGE,
    PELLICLE_UNSUPPORTED,
    PELLICLE_OUT_OF_MEMORY,
];

/// What a description points to.
#[derive(Default)]
struct Memory {
    texts: Texts,
    tables: Vec<[Vec<f32>; 3]>,
    /// Boxes, because descriptions point to them while the vector grows.
    #[expect(clippy::vec_box)]
    media: Vec<Box<PellicleMedium>>,
}

pub fn run(data: &[u8]) {
    let bytes = &mut Bytes(data);
    let memory = &mut Memory::default();
    let layers: Vec<PellicleLayer> = (0..bytes.index(MOST_LAYERS + 1))
        .map(|_| layer(bytes, memory))
        .collect();
    // Some counts are beyond what is allowed, whatever lies there.
    let layer_count = match bytes.byte() {
        255 => bytes.word() as usize | 65,
        _ => layers.len(),
    };
    let mut desc = PellicleFilmDesc {
        medium_size: element_size::<PellicleMedium>(bytes),
        layer_size: element_size::<PellicleLayer>(bytes),
        ambient: if bytes.byte() % 2 == 0 {
            null()
        } else {
            medium(bytes, memory)
        },
        layers: if bytes.byte() == 255 {
            null()
        } else {
            layers.as_ptr()
        },
        layer_count,
        base: medium(bytes, memory),
        tolerance: tolerance(bytes),
        white: memory.texts.optional_name(bytes, &WHITES),
        color_space: memory.texts.optional_name(bytes, &SPACES),
        method: memory.texts.optional_name(bytes, &METHODS),
        simd_level: null(),
        unclipped: u32::from(bytes.byte() / 64),
        transmittance: 0,
        base_opaque: 0,
        extrapolate: 0,
        thickness_spread_max_nm: 0.0,
    };
    let switches = bytes.byte();
    desc.transmittance = u32::from(switches / 64);
    desc.base_opaque = u32::from(switches % 16 / 5);
    desc.extrapolate = u32::from(switches % 64 / 31);
    // Levels of spread take long to make.
    if bytes.byte() > 250 {
        desc.thickness_spread_max_nm = bytes.number(0.0, 200.0);
    }
    let mut handle = Output::<*mut PellicleFilm>::new();
    // SAFETY: all that the description names is alive; counts beyond the layers are refused.
    let status = unsafe { create(&desc, bytes, handle.pointer()) };
    if !succeeded(status, &FAILURES) {
        return handle.must_be_untouched();
    }
    let film = handle.get();
    let greatest = if desc.unclipped == 1 {
        f32::INFINITY
    } else {
        1.0
    };
    // SAFETY: a live handle, until it is released.
    unsafe {
        look_at_plan(film);
        for _ in 0..4 {
            call(film, bytes, desc.unclipped == 1, greatest);
        }
        pellicle_film_release(film);
    }
}

const NO_MEDIUM: PellicleMedium = PellicleMedium {
    name: null(),
    eta: [0.0; 3],
    k: [0.0; 3],
    table_nm: null(),
    table_eta: null(),
    table_k: null(),
    table_count: 0,
};

/// Today's size most of the time, or 0, which no version has. Others would cut pointers apart.
fn element_size<T>(bytes: &mut Bytes) -> usize {
    match bytes.byte() {
        255 => 0,
        _ => size_of::<T>(),
    }
}

fn medium(bytes: &mut Bytes, memory: &mut Memory) -> *const PellicleMedium {
    let mut medium = NO_MEDIUM;
    let kind = bytes.byte();
    if kind % 8 < 3 || kind > 240 {
        medium.name = memory.texts.name(bytes, &MEDIA);
    }
    if (3..6).contains(&(kind % 8)) {
        let (eta, k) = (bytes.number(1.0, 4.0), bytes.number(0.0, 8.0));
        let differs = bytes.byte() > 200;
        medium.eta = std::array::from_fn(|_| if differs { bytes.number(1.0, 4.0) } else { eta });
        medium.k = if kind.is_multiple_of(2) {
            [0.0; 3]
        } else {
            [k; 3]
        };
    }
    if kind % 8 == 6 || kind > 250 {
        let count = bytes.index(5);
        let mut column = |min, max| {
            (0..count)
                .map(|_| bytes.number(min, max))
                .collect::<Vec<_>>()
        };
        let mut table = [column(300.0, 900.0), column(1.0, 4.0), column(0.0, 2.0)];
        if kind % 16 < 8 {
            table[0].sort_by(f32::total_cmp);
        }
        [medium.table_nm, medium.table_eta, medium.table_k] = [0, 1, 2].map(|i| table[i].as_ptr());
        medium.table_count = count;
        memory.tables.push(table);
    }
    memory.media.push(Box::new(medium));
    &*memory.media[memory.media.len() - 1]
}

fn layer(bytes: &mut Bytes, memory: &mut Memory) -> PellicleLayer {
    let medium = medium(bytes, memory);
    let mut bound = || {
        let number = bytes.number(0.0, MOST_THICKNESS_NM);
        // Beyond the range that is allowed it may be anything.
        if (MOST_THICKNESS_NM..=1e8).contains(&number) {
            MOST_THICKNESS_NM
        } else {
            number
        }
    };
    let (a, b) = (bound(), bound());
    let [min, max] = match bytes.byte() {
        0..128 => [a, a],
        128..250 => [a.min(b), a.max(b)],
        _ => [a, b],
    };
    PellicleLayer {
        medium,
        thickness_min_nm: min,
        thickness_max_nm: max,
    }
}

fn tolerance(bytes: &mut Bytes) -> f32 {
    let number = bytes.number(LEAST_TOLERANCE, 0.1);
    if (0.0..LEAST_TOLERANCE).contains(&number) {
        LEAST_TOLERANCE
    } else {
        number
    }
}

/// With the size of today's struct, of an older one, or of a newer one whose tail is 0 or not.
unsafe fn create(
    desc: &PellicleFilmDesc,
    bytes: &mut Bytes,
    film: *mut *mut PellicleFilm,
) -> PellicleStatus {
    let size = size_of::<PellicleFilmDesc>();
    let mut copy = vec![0u8; size + 64];
    // SAFETY: the description's bytes.
    unsafe {
        copy.as_mut_ptr()
            .copy_from_nonoverlapping(std::ptr::from_ref(desc).cast(), size)
    };
    let given = match bytes.byte() {
        0..240 => size,
        240..245 => bytes.index(size + 1),
        245..250 => size + bytes.index(65),
        _ => {
            copy[size + 7] = 1;
            size + 8
        }
    };
    // A struct that ends before its tolerance has the default's, which takes longer but not long.
    // SAFETY: readable for all sizes; the caller vouches for what it points to.
    unsafe { pellicle_film_create(copy.as_ptr().cast(), given, film) }
}

unsafe fn look_at_plan(film: *const PellicleFilm) {
    let mut plan = Output::<PellicleFilmPlan>::new();
    // SAFETY: the caller vouches for the handle; its texts live as long.
    unsafe {
        let status = pellicle_film_plan(film, plan.pointer(), size_of::<PellicleFilmPlan>());
        assert_eq!(status, PELLICLE_OK);
        let plan = plan.get();
        assert!(!CStr::from_ptr(plan.method).is_empty() && !CStr::from_ptr(plan.reason).is_empty());
        let errors = [plan.measured_max, plan.measured_rms];
        must_be_within(&errors, f32::INFINITY);
        // 2 MiB for each side and quantity.
        assert!(plan.bytes <= 8 << 20, "{} bytes", plan.bytes);
    }
}

unsafe fn call(film: *const PellicleFilm, bytes: &mut Bytes, is_unclipped: bool, greatest: f32) {
    let (cos_theta, thickness_nm) = (bytes.number(0.0, 1.0), bytes.number(0.0, MOST_THICKNESS_NM));
    let look = |rgb: [f32; 3]| {
        if is_unclipped {
            assert!(rgb.into_iter().all(f32::is_finite), "{rgb:?}");
        } else {
            must_be_within(&rgb, greatest);
        }
    };
    // SAFETY: the caller vouches for the handle; outputs are as large as they must be.
    unsafe {
        let (mut first, mut second) = (Output::<[f32; 3]>::new(), Output::<[f32; 3]>::new());
        let status =
            pellicle_film_reflectance(film, cos_theta, thickness_nm, first.pointer().cast());
        assert_eq!(status, PELLICLE_OK);
        look(first.get());

        let side = u32::from(bytes.byte() / 100);
        let (mut reflectance, mut transmittance) =
            (Output::<[f32; 3]>::new(), Output::<[f32; 3]>::new());
        let outputs = [reflectance.pointer().cast(), transmittance.pointer().cast()];
        let status =
            pellicle_film_eval(film, cos_theta, thickness_nm, side, outputs[0], outputs[1]);
        if succeeded(status, &[PELLICLE_OUT_OF_RANGE, PELLICLE_UNSUPPORTED]) {
            look(reflectance.get());
            look(transmittance.get());
        } else {
            reflectance.must_be_untouched();
            transmittance.must_be_untouched();
        }

        let status =
            pellicle_film_reference(film, cos_theta, thickness_nm, second.pointer().cast());
        assert_eq!(status, PELLICLE_OK);
        assert!(
            second.get().into_iter().all(f32::is_finite),
            "{:?}",
            second.get()
        );

        let wavelengths = [bytes.number(380.0, 780.0), bytes.number(380.0, 780.0)];
        let mut spectrum = Output::<[f32; 2]>::new();
        let status = pellicle_film_spectrum(
            film,
            cos_theta,
            thickness_nm,
            wavelengths.as_ptr(),
            wavelengths.len(),
            spectrum.pointer().cast(),
        );
        if succeeded(status, &[PELLICLE_OUT_OF_RANGE]) {
            // Rounding of a sum of all that returns.
            must_be_within(&spectrum.get(), 1.000_001);
        } else {
            let mut info = Output::<PellicleFilmInfo>::new();
            let size = size_of::<PellicleFilmInfo>();
            assert_eq!(pellicle_film_info(film, info.pointer(), size), PELLICLE_OK);
            let PellicleFilmInfo {
                lambda_min_nm: min,
                lambda_max_nm: max,
                ..
            } = info.get();
            let is_known = |nm: &f32| nm.is_finite() && *nm > 0.0 && (min..=max).contains(nm);
            assert!(!wavelengths.iter().all(is_known));
            spectrum.must_be_untouched();
        }
    }
}
