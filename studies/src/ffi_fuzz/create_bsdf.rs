//! BSDFs of any description, and calls of those that can be made.

use super::bytes::Bytes;
use super::evaluate::call;
use super::outcome::{Output, succeeded};
use super::subjects::{Subject, film};
use super::texts::Texts;
use pellicle::bsdf::{ModelInfo, ParamKind, models};
use pellicle::capi::*;
use std::ptr::null;

/// Every documented failure of creation.
const FAILURES: [PellicleStatus; 5] = [
    PELLICLE_INVALID_ARGUMENT,
    PELLICLE_UNKNOWN_NAME,
    PELLICLE_OUT_OF_RANGE,
    PELLICLE_UNSUPPORTED,
    PELLICLE_OUT_OF_MEMORY,
];

const MOST_PARAMS: usize = 8;
const MOST_VARYING: usize = 4;
/// Not every processor has all.
const LEVELS: [&str; 5] = ["scalar", "sse2", "avx2", "avx512", "neon"];

pub fn run(data: &[u8]) {
    let bytes = &mut Bytes(data);
    let texts = &mut Texts::default();
    let info = models()[bytes.index(models().len())].info;
    // Descriptions point into it: it never grows.
    let mut numbers = Vec::with_capacity(MOST_PARAMS);
    let params: Vec<PellicleParam> = (0..bytes.index(MOST_PARAMS + 1))
        .map(|_| param(bytes, texts, info, &mut numbers))
        .collect();
    let varying: Vec<(usize, PellicleRange)> = (0..bytes.index(MOST_VARYING + 1))
        .map(|_| range(bytes, texts, info))
        .collect();
    let ranges: Vec<PellicleRange> = varying.iter().map(|(_, range)| *range).collect();
    let desc = PellicleBsdfDesc {
        model: texts.name(bytes, &[info.name]),
        params: if bytes.byte() == 255 {
            null()
        } else {
            params.as_ptr()
        },
        param_count: if bytes.byte() == 255 {
            usize::MAX - 7
        } else {
            params.len()
        },
        varying: if bytes.byte() == 255 {
            null()
        } else {
            ranges.as_ptr()
        },
        varying_count: ranges.len(),
        film: match bytes.byte() % 4 {
            0 => film(bytes.index(256)),
            _ if info.name == "film" => film(bytes.index(256)),
            _ => null(),
        },
        simd_level: texts.optional_name(bytes, &LEVELS),
    };
    let mut handle = Output::<*mut PellicleBsdf>::new();
    let size = match bytes.byte() {
        0..250 => size_of::<PellicleBsdfDesc>(),
        _ => bytes.index(size_of::<PellicleBsdfDesc>() + 1),
    };
    // SAFETY: all that the description names is alive; a count that no memory holds is refused.
    let status = unsafe { pellicle_bsdf_create(&desc, size, handle.pointer()) };
    if !succeeded(status, &FAILURES) {
        return handle.must_be_untouched();
    }
    let bsdf = handle.get();
    // SAFETY: a live handle, until it is released; 0 is valid for numbers and pointers.
    unsafe {
        let mut info = std::mem::zeroed::<PellicleBsdfInfo>();
        let status = pellicle_bsdf_info(bsdf, &mut info, size_of::<PellicleBsdfInfo>());
        assert_eq!(status, PELLICLE_OK);
        let is_given = info.varying_count as usize == varying.len();
        let components: Vec<(usize, [f32; 2])> = varying
            .iter()
            .filter(|_| is_given)
            .map(|(components, range)| (*components, [range.min, range.max]))
            .collect();
        let subject = Subject {
            bsdf,
            info,
            varying: &components,
        };
        for _ in 0..4 {
            call(&subject, bytes);
        }
        pellicle_bsdf_release(bsdf);
    }
}

fn names(info: &'static ModelInfo) -> Vec<&'static str> {
    info.params.iter().map(|param| param.name).collect()
}

/// A parameter of the model with numbers or a choice that suit it, most of the time.
fn param(
    bytes: &mut Bytes,
    texts: &mut Texts,
    info: &'static ModelInfo,
    numbers: &mut Vec<[f32; 4]>,
) -> PellicleParam {
    let known = &info.params[bytes.index(info.params.len())];
    let name = match bytes.byte() {
        0..240 => texts.keep(known.name),
        _ => texts.name(bytes, &names(info)),
    };
    let (mut values, mut count, mut choice) = ([0.0; 4], known.components(), null());
    match &known.kind {
        ParamKind::Number { min, max, .. } => {
            values = std::array::from_fn(|_| bytes.number(*min, *max))
        }
        ParamKind::Direction { .. } => values = std::array::from_fn(|_| bytes.number(-1.0, 1.0)),
        ParamKind::Choice { choices } => choice = texts.name(bytes, choices),
    }
    match bytes.byte() {
        0..200 => {}
        200..230 => count = 1,
        230..250 => count = bytes.index(5),
        250..253 => count = bytes.word() as usize | 4,
        _ => choice = texts.name(bytes, &["ggx", "film", "paper"]),
    }
    numbers.push(values);
    PellicleParam {
        name,
        values: if count == 0 {
            null()
        } else {
            numbers[numbers.len() - 1].as_ptr()
        },
        count,
        choice,
    }
}

/// How many components, and the range.
fn range(bytes: &mut Bytes, texts: &mut Texts, info: &'static ModelInfo) -> (usize, PellicleRange) {
    let known = &info.params[bytes.index(info.params.len())];
    let [min, max] = match known.kind {
        ParamKind::Number { min, max, .. } => [min, max],
        _ => [0.0; 2],
    };
    let [a, b] = match bytes.byte() {
        0..128 => [min, max],
        _ => [bytes.number(min, max), bytes.number(min, max)],
    };
    let name = match bytes.byte() {
        0..250 => texts.keep(known.name),
        _ => texts.name(bytes, &names(info)),
    };
    let range = PellicleRange {
        name,
        min: if a < b { a } else { b },
        max: if a < b { b } else { a },
    };
    (known.components(), range)
}
