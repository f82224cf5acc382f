//! Single calls of every model with arbitrary numbers.

use super::bytes::Bytes;
use super::outcome::{Output, must_be_sample, must_be_within, succeeded};
use super::subjects::{Subject, subject};
use pellicle::capi::*;
use std::ptr::{null, null_mut};

pub fn run(data: &[u8]) {
    let bytes = &mut Bytes(data);
    let subject = subject(bytes.word() as u16);
    for _ in 0..4 {
        // SAFETY: the handle lives on.
        unsafe { call(&subject, bytes) };
    }
}

/// Every call of a BSDF that takes data, once.
///
/// # Safety
/// The handle must be alive.
pub unsafe fn call(subject: &Subject, bytes: &mut Bytes) {
    let bsdf = subject.bsdf;
    let mut varying = Vec::new();
    for (components, [min, max]) in subject.varying {
        varying.extend((0..*components).map(|_| bytes.number(*min, *max)));
    }
    let is_complete = varying.len() == subject.info.varying_floats as usize;
    let varying = if is_complete && !bytes.byte().is_multiple_of(8) {
        varying.as_ptr()
    } else {
        null()
    };
    let (wo, wi, u) = (bytes.direction(), bytes.direction(), bytes.uniforms());
    // SAFETY: the handle is alive, arrays and outputs as long as they must be.
    unsafe {
        let mut value = Output::<[f32; 3]>::new();
        let [mut pdf, mut reverse] = [(); 2].map(|()| Output::<f32>::new());
        let status = pellicle_bsdf_eval(
            bsdf,
            wo.as_ptr(),
            wi.as_ptr(),
            varying,
            null(),
            value.pointer().cast(),
            pdf.pointer(),
            reverse.pointer(),
        );
        assert_eq!(status, PELLICLE_OK);
        must_be_within(&value.get(), f32::INFINITY);
        must_be_within(&[pdf.get(), reverse.get()], f32::INFINITY);
        let mut alone = Output::<[f32; 3]>::new();
        let status = pellicle_bsdf_eval(
            bsdf,
            wo.as_ptr(),
            wi.as_ptr(),
            varying,
            null(),
            alone.pointer().cast(),
            null_mut(),
            null_mut(),
        );
        assert_eq!(status, PELLICLE_OK);
        assert_eq!(
            alone.get(),
            value.get(),
            "the value depends on whether the density is wanted"
        );

        let mut sample = Output::<PellicleSample>::new();
        let size = size_of::<PellicleSample>();
        let status = pellicle_bsdf_sample(
            bsdf,
            wo.as_ptr(),
            u.as_ptr(),
            varying,
            null(),
            sample.pointer(),
            size,
        );
        assert_eq!(status, PELLICLE_OK);
        must_be_sample(&sample.get(), &subject.info);

        // Milliseconds: seldom.
        if bytes.byte() == 1 {
            let mut albedo = Output::<[f32; 3]>::new();
            let status =
                pellicle_bsdf_albedo(bsdf, wo.as_ptr(), varying, null(), albedo.pointer().cast());
            assert_eq!(status, PELLICLE_OK);
            must_be_within(&albedo.get(), f32::INFINITY);
        }

        let mut refused = Output::<[f32; 3]>::new();
        let status = pellicle_bsdf_eval(
            bsdf,
            null(),
            wi.as_ptr(),
            varying,
            null(),
            refused.pointer().cast(),
            null_mut(),
            null_mut(),
        );
        assert!(!succeeded(status, &[PELLICLE_INVALID_ARGUMENT]));
        refused.must_be_untouched();
    }
}
