//! Batches of a BSDF: evaluation and sampling for the elements of strided arrays.

use super::chunk::{CHUNK, Chunks, Column, SAMPLE_CHUNK};
use super::varying::{Room, VaryingViews};
use super::view::{ConstView, Span, View, is_apart};
use crate::bsdf::{Bsdf, Call, EvalJob, MAX_FLOATS, SampleJob};
use crate::error::Error;
use crate::num::Level;

/// Arguments of [`eval`].
#[derive(Clone, Copy, Debug)]
pub struct EvalArgs<'a> {
    /// The number of elements.
    pub count: usize,
    /// Options for all elements.
    pub call: Call,
    /// Directions to the viewer.
    pub wo: ConstView,
    /// Directions to the light.
    pub wi: ConstView,
    /// One view per varying parameter, or no views. A parameter whose data is null, and every parameter
    /// without views, has its default.
    pub varying: &'a [ConstView],
    /// Receives f |wi.z|.
    pub value: View,
    /// Receives the density of wi for a sample from wo.
    pub pdf: View,
    /// Receives the density of wo for a sample from wi.
    pub pdf_reverse: View,
}

/// Arguments of [`sample`].
#[derive(Clone, Copy, Debug)]
pub struct SampleArgs<'a> {
    /// The number of elements.
    pub count: usize,
    /// Options for all elements.
    pub call: Call,
    /// Directions to the viewer.
    pub wo: ConstView,
    /// Uniform numbers in [0, 1).
    pub u: ConstView,
    /// The varying parameters, as in [`EvalArgs`].
    pub varying: &'a [ConstView],
    /// Receives the directions to the light.
    pub wi: View,
    /// Receives the density of wi over all lobes; 0 for a DELTA lobe.
    pub pdf: View,
    /// Receives value / pdf; for a DELTA lobe the throughput over the probability of choosing it.
    pub weight: View,
    /// Receives the refractive index on wi's side over that on wo's side.
    pub eta: View,
    /// Receives the chosen lobe's flags.
    pub flags: View<u32>,
    /// Receives the chosen lobe's number.
    pub lobe: View<u32>,
    /// Receives the probability with which the lobe was chosen.
    pub lobe_probability: View,
}

/// Evaluates value and densities for every element. The results are the bits of single calls at every
/// level.
///
/// # Errors
/// `InvalidArgument` if a needed view is null, no output is wanted, the number of varying views is wrong,
/// or an offset overflows the address space; nothing is then written.
///
/// # Safety
/// Every address that the views stand for must be readable or, for outputs, writable. An output may be the
/// same array as an input, with the same address and strides; it must not overlap an input otherwise, nor
/// another output.
pub unsafe fn eval(bsdf: &Bsdf, args: &EvalArgs, level: Level) -> Result<(), Error> {
    let count = args.count;
    let scalars = [args.pdf, args.pdf_reverse];
    if args.value.data.is_null() && scalars.iter().all(|view| view.data.is_null()) {
        return Err(Error::invalid(
            "value, pdf and pdf_reverse are all NULL: nothing to compute",
        ));
    }
    args.wo.check("wo", 3, count)?;
    args.wi.check("wi", 3, count)?;
    args.value.check("value", 3, count)?;
    args.pdf.check("pdf", 1, count)?;
    args.pdf_reverse.check("pdf_reverse", 1, count)?;
    let varying = VaryingViews::new(bsdf, args.varying, count)?;
    let inputs = [args.wo.span(3, count), args.wi.span(3, count)];
    let outputs = [
        args.value.target(3, count),
        args.pdf.target(1, count),
        args.pdf_reverse.target(1, count),
    ];
    let is_direct = are_apart(&inputs, &varying, &outputs, count);
    let longest = varying.longest_chunk(CHUNK);
    let chunks = Chunks::new(count, longest, is_direct, level);
    let lobes = bsdf.wanted_lobes(&args.call);
    let [mut wo, mut wi, mut value] = [[Column::<f32, CHUNK>::EMPTY; 3]; 3];
    let [mut pdf, mut pdf_reverse] = [[Column::<f32, CHUNK>::EMPTY]; 2];
    let mut numbers = Room::EMPTY;
    for chunk in chunks.iter() {
        // SAFETY: the caller vouches for every address of every view; an array that is used in place
        // overlaps no other.
        unsafe {
            let mut slices = [&[][..]; MAX_FLOATS];
            let (wo, wi) = (
                chunk.columns(&args.wo, &mut wo),
                chunk.columns(&args.wi, &mut wi),
            );
            let varying = bsdf.varying_columns(varying.read(&chunk, &mut numbers, &mut slices));
            if !args.pdf_reverse.data.is_null() {
                let density = chunk.column_mut(&args.pdf_reverse, &mut pdf_reverse);
                let mut job = EvalJob {
                    wo: wi,
                    wi: wo,
                    varying,
                    lobes,
                    value: None,
                    pdf: Some(density),
                };
                bsdf.eval_job(chunks.level, &mut job);
            }
            let is_value_wanted = !args.value.data.is_null();
            let is_pdf_wanted = !args.pdf.data.is_null();
            let density = chunk.column_mut(&args.pdf, &mut pdf);
            let mut job = EvalJob {
                wo,
                wi,
                varying,
                lobes,
                value: is_value_wanted.then(|| chunk.columns_mut(&args.value, &mut value)),
                pdf: is_pdf_wanted.then_some(density),
            };
            if is_value_wanted || is_pdf_wanted {
                bsdf.eval_job(chunks.level, &mut job);
            }
            chunk.write(&args.value, &value);
            chunk.write(&args.pdf, &pdf);
            chunk.write(&args.pdf_reverse, &pdf_reverse);
        }
    }
    Ok(())
}

/// Samples a direction for every element. The results are the bits of single calls at every level.
///
/// # Errors
/// As for [`eval`].
///
/// # Safety
/// As for [`eval`].
pub unsafe fn sample(bsdf: &Bsdf, args: &SampleArgs, level: Level) -> Result<(), Error> {
    let count = args.count;
    let floats = [
        args.wi,
        args.pdf,
        args.weight,
        args.eta,
        args.lobe_probability,
    ];
    let is_wanted = floats.iter().any(|view| !view.data.is_null())
        || [args.flags, args.lobe]
            .iter()
            .any(|view| !view.data.is_null());
    if !is_wanted {
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
    args.lobe_probability.check("lobe_probability", 1, count)?;
    let varying = VaryingViews::new(bsdf, args.varying, count)?;
    let inputs = [args.wo.span(3, count), args.u.span(3, count)];
    let outputs = [
        args.wi.target(3, count),
        args.pdf.target(1, count),
        args.weight.target(3, count),
        args.eta.target(1, count),
        args.flags.target(1, count),
        args.lobe.target(1, count),
        args.lobe_probability.target(1, count),
    ];
    let is_direct = are_apart(&inputs, &varying, &outputs, count);
    let longest = varying.longest_chunk(SAMPLE_CHUNK);
    let chunks = Chunks::new(count, longest, is_direct, level);
    let lobes = bsdf.wanted_lobes(&args.call);
    let [mut wo, mut u, mut wi, mut weight] = [[Column::<f32, SAMPLE_CHUNK>::EMPTY; 3]; 4];
    let [mut pdf, mut eta, mut lobe, mut probability] = [[Column::<f32, SAMPLE_CHUNK>::EMPTY]; 4];
    let [mut flags, mut numbers_of_lobes] = [[Column::<u32, SAMPLE_CHUNK>::EMPTY]; 2];
    let mut numbers = Room::EMPTY;
    for chunk in chunks.iter() {
        // SAFETY: as in `eval`.
        unsafe {
            let mut slices = [&[][..]; MAX_FLOATS];
            let mut job = SampleJob {
                wo: chunk.columns(&args.wo, &mut wo),
                u: chunk.columns(&args.u, &mut u),
                varying: bsdf.varying_columns(varying.read(&chunk, &mut numbers, &mut slices)),
                lobes,
                transport: args.call.transport,
                wi: chunk.columns_mut(&args.wi, &mut wi),
                weight: chunk.columns_mut(&args.weight, &mut weight),
                pdf: chunk.column_mut(&args.pdf, &mut pdf),
                eta: chunk.column_mut(&args.eta, &mut eta),
                lobe: chunk.scratch(&mut lobe),
                lobe_probability: chunk.scratch(&mut probability),
            };
            bsdf.sample_job(chunks.level, &mut job);
            if !(args.flags.data.is_null() && args.lobe.data.is_null()) {
                let mut flags_column = chunk.column_mut(&args.flags, &mut flags);
                let mut number_column = chunk.column_mut(&args.lobe, &mut numbers_of_lobes);
                let found = chunk.numbers(&lobe).iter().zip(chunk.numbers(&probability));
                for (i, (lobe, probability)) in found.enumerate() {
                    number_column.set(i, *lobe as u32);
                    let flags = bsdf.sampled_flags(*lobe as usize, *probability > 0.0);
                    flags_column.set(i, flags.0);
                }
                chunk.write(&args.flags, &flags);
                chunk.write(&args.lobe, &numbers_of_lobes);
            }
            chunk.copy_out(&args.lobe_probability, &probability);
            chunk.write(&args.wi, &wi);
            chunk.write(&args.weight, &weight);
            chunk.write(&args.pdf, &pdf);
            chunk.write(&args.eta, &eta);
        }
    }
    Ok(())
}

/// Whether no output that can be written in place overlaps another view.
fn are_apart(
    inputs: &[Span],
    varying: &VaryingViews,
    outputs: &[(Span, bool)],
    count: usize,
) -> bool {
    is_apart(inputs, outputs) && varying.spans(count).all(|span| is_apart(&[span], outputs))
}
