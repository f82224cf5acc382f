//! STAND-IN for what the core will offer: delete each item when the core has it.
//!
//! The core ignores transport and lobes so far; densities of the reverse direction, probabilities of lobes
//! and levels of instructions are found from outside.

use crate::batch::{ConstView, View};
use crate::bsdf::{self, Bsdf, Flags};
use crate::error::Error;
use crate::num::Level;

/// STAND-IN for `bsdf::Transport`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Transport {
    Radiance,
    Importance,
}

/// STAND-IN for `bsdf::Call`. The core evaluates as if it were the default.
#[derive(Clone, Copy, Debug)]
#[allow(dead_code)] // the core does not read it yet
pub(super) struct Call {
    pub transport: Transport,
    pub lobes: Flags,
}

impl Default for Call {
    fn default() -> Self {
        Self {
            transport: Transport::Radiance,
            lobes: Flags(u32::MAX),
        }
    }
}

/// STAND-IN for `Bsdf::evaluate`: the density of wo for a sample from wi.
pub(super) fn pdf_reverse(
    bsdf: &Bsdf,
    wo: glam::Vec3,
    wi: glam::Vec3,
    varying: Option<&[f32]>,
) -> f32 {
    bsdf.eval_pdf(wi, wo, varying).1
}

/// STAND-IN for `Sample::lobe_probability`.
pub(super) fn lobe_probability(
    bsdf: &Bsdf,
    wo: glam::Vec3,
    sample: &bsdf::Sample,
    varying: Option<&[f32]>,
) -> f32 {
    if sample.flags == Flags(0) {
        return 0.0;
    }
    bsdf.lobes(wo, sample.wi, varying).0[sample.lobe]
}

/// Every name of a level, on any processor.
pub(super) const LEVELS: [&str; 5] = ["scalar", "sse2", "avx2", "avx512", "neon"];

/// STAND-IN for `Description::simd_level` and `FilmDescription::simd_level`.
pub(super) fn level(name: Option<&str>) -> Result<Level, Error> {
    let all = Level::all();
    let Some(name) = name else {
        return Ok(all[all.len() - 1]);
    };
    let here = all.iter().map(|level| level.name());
    if !LEVELS.contains(&name) {
        return Err(Error::unknown("simd_level", name, here));
    }
    let found = all.iter().find(|level| level.name() == name);
    found.copied().ok_or_else(|| {
        let here = here.collect::<Vec<_>>().join(", ");
        Error::unsupported(format!(
            "simd_level '{name}' is not one of this processor, which has: {here}"
        ))
    })
}

/// STAND-IN for `Bsdf::plan`, which names the widest level.
pub(super) fn plan(bsdf: &Bsdf, level: Level) -> String {
    match bsdf.plan().rsplit_once("; batches by ") {
        Some((terms, batches)) if batches != "single calls" => {
            format!("{terms}; batches by {}", level.name())
        }
        _ => bsdf.plan().to_owned(),
    }
}

/// STAND-IN for `batch::EvalArgs::pdf_reverse` and `batch::SampleArgs::lobe_probability`: what `number` finds
/// for wo, the other vector and the varying values of every element.
///
/// # Safety
/// Every address that the views stand for must be readable.
pub(super) unsafe fn for_each(
    bsdf: &Bsdf,
    count: usize,
    [wo, other]: [&ConstView; 2],
    varying: &[ConstView],
    number: impl Fn(glam::Vec3, glam::Vec3, Option<&[f32]>) -> f32,
) -> Vec<f32> {
    // SAFETY: the caller vouches for every address.
    let read = |view: &ConstView, i: usize, c: usize| unsafe {
        let offset = i as isize * view.element_stride + c as isize * view.component_stride;
        view.data.byte_offset(offset).read_unaligned()
    };
    let vector = |view: &ConstView, i| glam::Vec3::from_array([0, 1, 2].map(|c| read(view, i, c)));
    let one = |i| {
        let mut values = bsdf.varying_defaults().to_vec();
        let mut first = 0;
        for (view, components) in varying.iter().zip(bsdf.varying_components()) {
            if !view.data.is_null() {
                (0..components).for_each(|c| values[first + c] = read(view, i, c));
            }
            first += components;
        }
        let values = (!varying.is_empty()).then_some(&values[..]);
        number(vector(wo, i), vector(other, i), values)
    };
    (0..count).map(one).collect()
}

/// STAND-IN, see [`for_each`]: refuses views of varying parameters that leave the address space.
pub(super) fn check_varying(bsdf: &Bsdf, varying: &[ConstView], count: usize) -> Result<(), Error> {
    for (view, components) in varying.iter().zip(bsdf.varying_components()) {
        let view = View {
            data: view.data.cast_mut(),
            element_stride: view.element_stride,
            component_stride: view.component_stride,
        };
        view.check("varying", components, count)?;
    }
    Ok(())
}

/// STAND-IN, see [`for_each`].
///
/// # Safety
/// Every address that the view stands for must be writable.
pub(super) unsafe fn store(output: &View, numbers: &[f32]) {
    for (i, number) in numbers.iter().enumerate() {
        // SAFETY: the caller vouches for every address.
        unsafe {
            let target = output.data.byte_offset(i as isize * output.element_stride);
            target.write_unaligned(*number);
        }
    }
}
