//! Evaluation and sampling of a BSDF.

use super::view::{ConstView, View, check_reach};
use crate::bsdf::{Bsdf, MAX_VARYING};
use crate::error::Error;

/// The most numbers that varying parameters may have together.
const MAX_FLOATS: usize = 3 * MAX_VARYING;

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

/// Value and density of every element; equal to the single calls bit for bit.
///
/// # Errors
/// `InvalidArgument`, before anything is read or written, if a needed view is null, no output is
/// wanted, the number of varying views is wrong, or an offset overflows the address space.
///
/// # Safety
/// Every address that the views stand for must be readable, or writable. An output may coincide
/// with an input element for element (same address and stride), not otherwise overlap one.
pub unsafe fn eval(bsdf: &Bsdf, args: &EvalArgs) -> Result<(), Error> {
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
        let mut numbers = [0.0; MAX_FLOATS];
        for i in 0..count {
            let varying = varying.load(i, &mut numbers);
            let (wo, wi) = (args.wo.load(i).into(), args.wi.load(i).into());
            if args.pdf.data.is_null() {
                args.value.store(i, bsdf.eval(wo, wi, varying));
            } else {
                let (value, pdf) = bsdf.eval_pdf(wo, wi, varying);
                args.value.store(i, value);
                args.pdf.store(i, [pdf]);
            }
        }
    }
    Ok(())
}

/// A sampled direction for every element; equal to the single calls bit for bit.
///
/// # Errors
/// As [`eval`].
///
/// # Safety
/// As [`eval`].
pub unsafe fn sample(bsdf: &Bsdf, args: &SampleArgs) -> Result<(), Error> {
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
        let mut numbers = [0.0; MAX_FLOATS];
        for i in 0..count {
            let varying = varying.load(i, &mut numbers);
            let sample = bsdf.sample(args.wo.load(i).into(), args.u.load(i).into(), varying);
            args.wi.store(i, sample.wi.to_array());
            args.pdf.store(i, [sample.pdf]);
            args.weight.store(i, sample.weight);
            args.eta.store(i, [sample.eta]);
            args.flags.store(i, [sample.flags.0]);
            args.lobe.store(i, [sample.lobe as u32]);
        }
    }
    Ok(())
}

/// The varying parameters of all elements.
struct VaryingViews<'a> {
    bsdf: &'a Bsdf,
    views: &'a [ConstView],
}

impl<'a> VaryingViews<'a> {
    fn new(bsdf: &'a Bsdf, views: &'a [ConstView], count: usize) -> Result<Self, Error> {
        if !views.is_empty() && views.len() != bsdf.varying_count() {
            return Err(Error::invalid(format!(
                "varying_count = {} but the BSDF has {} varying parameters",
                views.len(),
                bsdf.varying_count()
            )));
        }
        for (view, components) in views.iter().zip(bsdf.varying_components()) {
            check_reach(
                "varying",
                components,
                count,
                view.element_stride,
                view.component_stride,
            )?;
        }
        Ok(Self { bsdf, views })
    }

    /// The numbers of element i, one parameter after another.
    unsafe fn load<'b>(&self, i: usize, numbers: &'b mut [f32; MAX_FLOATS]) -> Option<&'b [f32]> {
        if self.views.is_empty() {
            return None;
        }
        let floats = self.bsdf.varying_floats();
        numbers[..floats].copy_from_slice(self.bsdf.varying_defaults());
        let mut first = 0;
        for (view, components) in self.views.iter().zip(self.bsdf.varying_components()) {
            if !view.data.is_null() {
                for c in 0..components {
                    // SAFETY: the caller of the batch vouches for this address.
                    numbers[first + c] = unsafe { view.at(i, c) };
                }
            }
            first += components;
        }
        Some(&numbers[..floats])
    }
}
