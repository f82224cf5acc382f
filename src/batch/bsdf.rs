//! Evaluation and sampling of a BSDF.

use super::column::{Chunk, Column, Span, is_apart};
use super::varying::{MAX_FLOATS, VaryingViews, with_room};
use super::view::{ConstView, View};
use crate::bsdf::{Bsdf, Found, Given};
use crate::error::Error;
use crate::num::Level;
use std::mem::MaybeUninit;

/// Fewer elements are faster one by one.
pub(super) const LEAST_TILE: usize = 8;

/// Arguments of [`eval`].
#[derive(Clone, Copy, Debug)]
pub struct EvalArgs<'a> {
    /// How many elements.
    pub count: usize,
    /// Directions to the viewer.
    pub wo: ConstView,
    /// Directions to the light.
    pub wi: ConstView,
    /// One view per varying parameter, or none at all; null data = the parameter's own value.
    pub varying: &'a [ConstView],
    /// Receives f |wi.z|.
    pub value: View,
    /// Receives the density.
    pub pdf: View,
}

/// Arguments of [`sample`].
#[derive(Clone, Copy, Debug)]
pub struct SampleArgs<'a> {
    /// How many elements.
    pub count: usize,
    /// Directions to the viewer.
    pub wo: ConstView,
    /// Uniform numbers in [0, 1).
    pub u: ConstView,
    /// As in [`EvalArgs`].
    pub varying: &'a [ConstView],
    /// Receives the directions to the light.
    pub wi: View,
    /// Receives the density.
    pub pdf: View,
    /// Receives value / pdf.
    pub weight: View,
    /// Receives the ratio of indices.
    pub eta: View,
    /// Receives the chosen lobe's flags.
    pub flags: View<u32>,
    /// Receives the chosen lobe's number.
    pub lobe: View<u32>,
}

/// Value and density of every element; equal to the single calls bit for bit, at every level.
///
/// # Errors
/// `InvalidArgument`, before anything is read or written, if a needed view is null, no output is
/// wanted, the number of varying views is wrong, or an offset overflows the address space.
///
/// # Safety
/// Every address that the views stand for must be readable, or writable. An output may coincide
/// with an input element for element (same address and stride), not otherwise overlap one.
pub unsafe fn eval(bsdf: &Bsdf, args: &EvalArgs, level: Level) -> Result<(), Error> {
    let count = args.count;
    if args.value.data.is_null() && args.pdf.data.is_null() {
        return Err(Error::invalid(
            "value and pdf are both NULL: nothing to compute",
        ));
    }
    args.wo.check("wo", 3, count)?;
    args.wi.check("wi", 3, count)?;
    args.value.check("value", 3, count)?;
    args.pdf.check("pdf", 1, count)?;
    let varying = VaryingViews::new(bsdf, args.varying, count)?;
    // SAFETY: the caller vouches for every address of every view.
    unsafe {
        if count < LEAST_TILE {
            eval_one_by_one(bsdf, args, &varying);
        } else {
            let inputs = [args.wo.span(3, count), args.wi.span(3, count)];
            let outputs = [args.value.target(3, count), args.pdf.target(1, count)];
            let is_direct = are_apart(&inputs, &varying, &outputs, count);
            eval_by_tiles(bsdf, args, &varying, is_direct, level);
        }
    }
    Ok(())
}

/// Whether all that can be written where it lies is apart from all else.
fn are_apart(
    inputs: &[Span],
    varying: &VaryingViews,
    outputs: &[(Span, bool)],
    count: usize,
) -> bool {
    is_apart(inputs, outputs) && varying.spans(count).all(|span| is_apart(&[span], outputs))
}

unsafe fn eval_one_by_one(bsdf: &Bsdf, args: &EvalArgs, varying: &VaryingViews) {
    for i in 0..args.count {
        // SAFETY: as in `eval`.
        unsafe {
            let mut numbers = MaybeUninit::uninit();
            let varying = varying.one(i, &mut numbers);
            let (wo, wi) = (args.wo.vector(i).into(), args.wi.vector(i).into());
            if args.pdf.data.is_null() {
                args.value.store_one(i, bsdf.eval(wo, wi, varying));
            } else {
                let (value, pdf) = bsdf.eval_pdf(wo, wi, varying);
                args.value.store_one(i, value);
                args.pdf.store_one(i, [pdf]);
            }
        }
    }
}

#[inline(never)] // the room that it needs is not to be set up for a few elements
unsafe fn eval_by_tiles(
    bsdf: &Bsdf,
    args: &EvalArgs,
    varying: &VaryingViews,
    is_direct: bool,
    level: Level,
) {
    let (mut wo, mut wi) = ([Column::EMPTY; 3], [Column::EMPTY; 3]);
    let (mut value, mut pdf) = ([Column::EMPTY; 3], [Column::EMPTY]);
    with_room(varying.floats(), |numbers| {
        for chunk in Chunk::all(args.count, is_direct) {
            // SAFETY: as in `eval`; the slices are apart, or copies.
            unsafe {
                let mut slices = [&[][..]; MAX_FLOATS];
                let given = Given {
                    wo: chunk.read(&args.wo, &mut wo),
                    other: chunk.read(&args.wi, &mut wi),
                    varying: varying.read(&chunk, numbers, &mut slices),
                };
                let [densities] = chunk.target(&args.pdf, &mut pdf);
                let densities = (!args.pdf.data.is_null()).then_some(densities);
                let values = chunk.target(&args.value, &mut value);
                bsdf.eval_tile(level, given, values, densities);
                chunk.write(&args.value, &value);
                chunk.write(&args.pdf, &pdf);
            }
        }
    });
}

/// A sampled direction for every element; equal to the single calls bit for bit, at every level.
///
/// # Errors
/// As [`eval`].
///
/// # Safety
/// As [`eval`].
pub unsafe fn sample(bsdf: &Bsdf, args: &SampleArgs, level: Level) -> Result<(), Error> {
    let count = args.count;
    let floats = [args.wi, args.pdf, args.weight, args.eta];
    let wanted = floats.iter().any(|view| !view.data.is_null())
        || [args.flags, args.lobe]
            .iter()
            .any(|view| !view.data.is_null());
    if !wanted {
        return Err(Error::invalid("every output is NULL: nothing to compute"));
    }
    args.wo.check("wo", 3, count)?;
    args.u.check("u", 3, count)?;
    args.wi.check("wi", 3, count)?;
    args.pdf.check("pdf", 1, count)?;
    args.weight.check("weight", 3, count)?;
    args.eta.check("eta", 1, count)?;
    args.flags.check("flags", 1, count)?;
    args.lobe.check("lobe", 1, count)?;
    let varying = VaryingViews::new(bsdf, args.varying, count)?;
    // SAFETY: the caller vouches for every address of every view.
    unsafe {
        if count < LEAST_TILE {
            sample_one_by_one(bsdf, args, &varying);
        } else {
            let inputs = [args.wo.span(3, count), args.u.span(3, count)];
            let outputs = [
                args.wi.target(3, count),
                args.pdf.target(1, count),
                args.weight.target(3, count),
                args.eta.target(1, count),
                args.flags.target(1, count),
                args.lobe.target(1, count),
            ];
            let is_direct = are_apart(&inputs, &varying, &outputs, count);
            sample_by_tiles(bsdf, args, &varying, is_direct, level);
        }
    }
    Ok(())
}

unsafe fn sample_one_by_one(bsdf: &Bsdf, args: &SampleArgs, varying: &VaryingViews) {
    for i in 0..args.count {
        // SAFETY: as in `sample`.
        unsafe {
            let mut numbers = MaybeUninit::uninit();
            let varying = varying.one(i, &mut numbers);
            let (wo, u) = (args.wo.vector(i).into(), args.u.vector(i).into());
            let sample = bsdf.sample(wo, u, varying);
            args.wi.store_one(i, sample.wi.to_array());
            args.pdf.store_one(i, [sample.pdf]);
            args.weight.store_one(i, sample.weight);
            args.eta.store_one(i, [sample.eta]);
            args.flags.store_one(i, [sample.flags.0]);
            args.lobe.store_one(i, [sample.lobe as u32]);
        }
    }
}

#[inline(never)] // as for `eval_by_tiles`
unsafe fn sample_by_tiles(
    bsdf: &Bsdf,
    args: &SampleArgs,
    varying: &VaryingViews,
    is_direct: bool,
    level: Level,
) {
    let (mut wo, mut u) = ([Column::EMPTY; 3], [Column::EMPTY; 3]);
    let (mut wi, mut weight) = ([Column::EMPTY; 3], [Column::EMPTY; 3]);
    let (mut pdf, mut eta) = ([Column::EMPTY], [Column::EMPTY]);
    let (mut flags, mut lobe) = ([Column::EMPTY], [Column::EMPTY]);
    with_room(varying.floats(), |numbers| {
        for chunk in Chunk::all(args.count, is_direct) {
            // SAFETY: as in `sample`; the slices are apart, or copies.
            unsafe {
                let mut slices = [&[][..]; MAX_FLOATS];
                let given = Given {
                    wo: chunk.read(&args.wo, &mut wo),
                    other: chunk.read(&args.u, &mut u),
                    varying: varying.read(&chunk, numbers, &mut slices),
                };
                let [pdf_slice] = chunk.target(&args.pdf, &mut pdf);
                let [eta_slice] = chunk.target(&args.eta, &mut eta);
                let [flags_slice] = chunk.target(&args.flags, &mut flags);
                let [lobe_slice] = chunk.target(&args.lobe, &mut lobe);
                let found = Found {
                    wi: chunk.target(&args.wi, &mut wi),
                    pdf: pdf_slice,
                    weight: chunk.target(&args.weight, &mut weight),
                    eta: eta_slice,
                    flags: flags_slice,
                    lobe: lobe_slice,
                };
                bsdf.sample_tile(level, given, found);
                chunk.write(&args.wi, &wi);
                chunk.write(&args.pdf, &pdf);
                chunk.write(&args.weight, &weight);
                chunk.write(&args.eta, &eta);
                chunk.write(&args.flags, &flags);
                chunk.write(&args.lobe, &lobe);
            }
        }
    });
}
