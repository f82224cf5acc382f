//! Batches and single calls of the C interface, small enough for an interpreter that watches every access
//! to memory (Miri, `./x check miri`): arrays are separate allocations that end with the last number, so
//! that a byte too much is an error, and what is read must have been written.

#![allow(unsafe_code)] // the C interface is all pointers

use pellicle::capi::*;
use std::ffi::CStr;
use std::ptr::{null, null_mut};

/// Whole lanes of every width and a rest.
const COUNT: usize = 21;

/// Numbers of [0, 1) that look random.
fn number(seed: usize) -> f32 {
    let bits = (seed as u32).wrapping_mul(2_654_435_761).rotate_left(13);
    (bits.wrapping_mul(2_246_822_519) >> 8) as f32 / 16_777_216.0
}

fn direction(seed: usize) -> [f32; 3] {
    let (z, phi) = (0.05 + 0.95 * number(seed), 6.0 * number(seed + 1));
    let radius = (1.0 - z * z).max(0.0).sqrt();
    [radius * phi.cos(), radius * phi.sin(), z]
}

fn uniforms(seed: usize) -> [f32; 3] {
    [number(seed), number(seed + 1), number(seed + 2)]
}

/// Where component c of element i lies, all in bytes: offset, strides of elements and components, and the size
/// of the array.
#[derive(Clone, Copy)]
struct Layout {
    begin: usize,
    element: isize,
    component: isize,
    bytes: usize,
}

/// Layouts of elements of `components` numbers: packed, planes, backwards, unaligned.
fn layouts(components: usize) -> [Layout; 4] {
    let packed = 4 * components;
    let layout = |begin, element: usize, component: usize, bytes| Layout {
        begin,
        element: element as isize,
        component: component as isize,
        bytes,
    };
    let forwards = layout(0, packed, 4, packed * COUNT);
    [
        forwards,
        layout(0, 4, 4 * COUNT, packed * COUNT),
        Layout {
            begin: packed * (COUNT - 1),
            element: -(packed as isize),
            ..forwards
        },
        layout(1, packed + 1, 4, (packed + 1) * COUNT),
    ]
}

/// An array; what is never written stays uninitialised, so that reading it is an error.
struct Array {
    bytes: Vec<u8>,
    layout: Layout,
}

impl Array {
    fn new(layout: Layout) -> Self {
        Self {
            bytes: Vec::with_capacity(layout.bytes),
            layout,
        }
    }

    fn filled<const N: usize>(kind: usize, element: impl Fn(usize) -> [f32; N]) -> Self {
        let mut array = Self::new(layouts(N)[kind]);
        for i in 0..COUNT {
            for (c, number) in element(i).into_iter().enumerate() {
                // SAFETY: within the capacity.
                unsafe { array.at(i, c).write_unaligned(number) };
            }
        }
        array
    }

    fn at(&mut self, i: usize, c: usize) -> *mut f32 {
        let Layout {
            element, component, ..
        } = self.layout;
        let offset = i as isize * element + c as isize * component;
        // SAFETY: within the capacity.
        unsafe { self.data().byte_offset(offset) }
    }

    fn data(&mut self) -> *mut f32 {
        // SAFETY: within the capacity.
        unsafe { self.bytes.as_mut_ptr().add(self.layout.begin).cast() }
    }

    fn get<const N: usize>(&mut self, i: usize) -> [u32; N] {
        // SAFETY: written by the call that was made.
        std::array::from_fn(|c| unsafe { self.at(i, c).cast::<u32>().read_unaligned() })
    }

    fn view(&mut self) -> PellicleView {
        PellicleView {
            data: self.data(),
            element_stride: self.layout.element,
            component_stride: self.layout.component,
        }
    }

    fn const_view(&mut self) -> PellicleConstView {
        PellicleConstView {
            data: self.data(),
            element_stride: self.layout.element,
            component_stride: self.layout.component,
        }
    }

    fn uint_view(&mut self) -> PellicleUintView {
        PellicleUintView {
            data: self.data().cast(),
            element_stride: self.layout.element,
        }
    }
}

fn create(model: &CStr, varying: Option<(&CStr, [f32; 2])>) -> *mut PellicleBsdf {
    let range = varying.map(|(name, [min, max])| PellicleRange {
        name: name.as_ptr(),
        min,
        max,
    });
    let desc = PellicleBsdfDesc {
        model: model.as_ptr(),
        params: null(),
        param_count: 0,
        varying: range.as_ref().map_or(null(), |range| range),
        varying_count: usize::from(range.is_some()),
        film: null(),
        simd_level: null(),
    };
    let mut bsdf = null_mut();
    // SAFETY: a valid description.
    let status = unsafe { pellicle_bsdf_create(&desc, size_of_val(&desc), &mut bsdf) };
    assert_eq!(status, PELLICLE_OK);
    bsdf
}

fn bits<const N: usize>(numbers: [f32; N]) -> [u32; N] {
    numbers.map(f32::to_bits)
}

/// A batch of values and one of samples in a pair of layouts, against single calls.
fn check(bsdf: *const PellicleBsdf, varies: bool, [read, written]: [usize; 2]) {
    let mut wo = Array::filled(read, |i| direction(10 * i));
    let mut wi = Array::filled(read, |i| direction(10 * i + 4));
    let mut u = Array::filled(read, |i| uniforms(10 * i + 7));
    let mut varied = Array::filled(read, |i| [100.0 + 300.0 * number(i)]);
    let view = varied.const_view();
    let (varying, varying_count) = if varies {
        (&raw const view, 1)
    } else {
        (null(), 0)
    };
    let output = |components: usize| Array::new(layouts(components)[written]);
    let [mut value, mut pdf, mut weight, mut flags] = [output(3), output(1), output(3), output(1)];
    // SAFETY: a live handle, and views of arrays of COUNT elements; 0 is valid for what is zeroed.
    unsafe {
        let mut args: PellicleEvalBatchArgs = std::mem::zeroed();
        args.count = COUNT;
        args.wo = wo.const_view();
        args.wi = wi.const_view();
        args.varying = varying;
        args.varying_count = varying_count;
        args.value = value.view();
        args.pdf = pdf.view();
        assert_eq!(
            pellicle_bsdf_eval_batch(bsdf, &args, size_of_val(&args)),
            PELLICLE_OK
        );
        let mut args: PellicleSampleBatchArgs = std::mem::zeroed();
        args.count = COUNT;
        args.wo = wo.const_view();
        args.u = u.const_view();
        args.varying = varying;
        args.varying_count = varying_count;
        args.weight = weight.view();
        args.flags = flags.uint_view();
        assert_eq!(
            pellicle_bsdf_sample_batch(bsdf, &args, size_of_val(&args)),
            PELLICLE_OK
        );
    }
    for i in 0..COUNT {
        let thickness = [f32::from_bits(varied.get::<1>(i)[0])];
        let varying = if varies { thickness.as_ptr() } else { null() };
        let [wo, wi, u] =
            [&mut wo, &mut wi, &mut u].map(|array| array.get::<3>(i).map(f32::from_bits));
        let (mut single, mut density, mut sample) = ([0.0; 3], 0.0, PellicleSample::default());
        // SAFETY: a live handle, arrays and outputs as long as they must be.
        unsafe {
            let (wo, size) = (wo.as_ptr(), size_of::<PellicleSample>());
            pellicle_bsdf_eval(
                bsdf,
                wo,
                wi.as_ptr(),
                varying,
                null(),
                single.as_mut_ptr(),
                &mut density,
                null_mut(),
            );
            pellicle_bsdf_sample(bsdf, wo, u.as_ptr(), varying, null(), &mut sample, size);
        }
        assert_eq!(value.get(i), bits(single));
        assert_eq!(pdf.get(i), bits([density]));
        assert_eq!(weight.get(i), bits(sample.weight));
        assert_eq!(flags.get(i), [sample.flags]);
    }
}

#[test]
fn batches_touch_what_they_may_and_nothing_else() {
    for (model, varying) in [
        (c"lambert", None),
        (c"phong", None),
        (c"layered", Some((c"thickness_nm", [0.0, 500.0]))),
    ] {
        let bsdf = create(model, varying);
        for layouts in [[0, 1], [1, 2], [2, 3], [3, 0], [1, 1]] {
            check(bsdf, varying.is_some(), layouts);
        }
        // SAFETY: a live handle.
        unsafe { pellicle_bsdf_release(bsdf) };
    }
}

/// Views that are used where they lie beside one that is an input's own memory.
#[test]
fn outputs_may_be_an_inputs_memory() {
    let bsdf = create(c"lambert", None);
    for kind in 0..4 {
        let mut wo = Array::filled(kind, |i| direction(10 * i));
        let mut wi = Array::filled(kind, |i| direction(10 * i + 4));
        let mut expected = Array::filled(kind, |i| direction(10 * i + 4));
        // SAFETY: a live handle, and views of arrays of COUNT elements; 0 is valid for what is zeroed.
        unsafe {
            let mut args: PellicleEvalBatchArgs = std::mem::zeroed();
            args.count = COUNT;
            args.wo = wo.const_view();
            args.wi = wi.const_view();
            args.value = wi.view();
            assert_eq!(
                pellicle_bsdf_eval_batch(bsdf, &args, size_of_val(&args)),
                PELLICLE_OK
            );
        }
        for i in 0..COUNT {
            let (from, to) = (
                wo.get::<3>(i).map(f32::from_bits),
                expected.get::<3>(i).map(f32::from_bits),
            );
            let mut single = [0.0; 3];
            let output = single.as_mut_ptr();
            // SAFETY: a live handle, arrays and outputs as long as they must be.
            unsafe {
                let (wo, wi, no) = (from.as_ptr(), to.as_ptr(), null_mut());
                pellicle_bsdf_eval(bsdf, wo, wi, null(), null(), output, no, no)
            };
            assert_eq!(wi.get(i), bits(single));
        }
    }
    // SAFETY: a live handle.
    unsafe { pellicle_bsdf_release(bsdf) };
}

#[test]
fn structs_are_read_and_written_up_to_the_size_given() {
    let bsdf = create(c"lambert", None);
    for size in 1..=size_of::<PellicleSample>() {
        // A separate allocation of that size, at any address.
        let mut sample = vec![0u8; size];
        let (wo, u) = (direction(0), uniforms(0));
        let pointer = sample.as_mut_ptr().cast();
        // SAFETY: a live handle, and `size` bytes.
        let status = unsafe {
            let (wo, u) = (wo.as_ptr(), u.as_ptr());
            pellicle_bsdf_sample(bsdf, wo, u, null(), null(), pointer, size)
        };
        // No version of a struct ends within a number.
        let is_whole = size.is_multiple_of(align_of::<PellicleSample>());
        let expected = if is_whole {
            PELLICLE_OK
        } else {
            PELLICLE_INVALID_ARGUMENT
        };
        assert_eq!(status, expected, "{size}");
    }
    let mut model = vec![0u8; size_of::<*const i8>()];
    // SAFETY: a live handle, and as many bytes as are told.
    unsafe {
        let status = pellicle_bsdf_info(bsdf, model.as_mut_ptr().cast(), model.len());
        assert_eq!(status, PELLICLE_OK);
        pellicle_bsdf_release(bsdf);
    }
}

#[test]
fn failures_are_told_and_write_nothing() {
    let name = c"no such model";
    // SAFETY: valid but for the name; 0 is valid for what is zeroed.
    unsafe {
        let mut desc: PellicleBsdfDesc = std::mem::zeroed();
        desc.model = name.as_ptr();
        let mut bsdf: *mut PellicleBsdf = std::ptr::dangling_mut();
        let untouched = bsdf;
        let status = pellicle_bsdf_create(&desc, size_of_val(&desc), &mut bsdf);
        assert_eq!((status, bsdf), (PELLICLE_UNKNOWN_NAME, untouched));
        let message = CStr::from_ptr(pellicle_last_error()).to_str().unwrap();
        assert!(message.contains("no such model") && message.contains("lambert"));
        // An older struct ends after its first field.
        desc.model = c"lambert".as_ptr();
        let status = pellicle_bsdf_create(&desc, size_of::<*const i8>(), &mut bsdf);
        assert_eq!(status, PELLICLE_OK);
        pellicle_bsdf_release(bsdf);
    }
}

/// References are counted without a race, and the last owner frees, whichever thread it is.
#[test]
fn handles_end_with_their_last_owner() {
    struct Shared(*mut PellicleBsdf);
    // SAFETY: handles are shared freely between threads.
    unsafe impl Send for Shared {}

    let bsdf = create(c"phong", None);
    let owners: Vec<_> = (0..3)
        .map(|seed| {
            // SAFETY: a live handle.
            unsafe { pellicle_bsdf_retain(bsdf) };
            let shared = Shared(bsdf);
            std::thread::spawn(move || {
                let Shared(bsdf) = { shared };
                let (wo, wi) = (direction(seed), direction(seed + 2));
                let mut value = [0.0; 3];
                let output = value.as_mut_ptr();
                // SAFETY: a handle of which a reference is owned.
                unsafe {
                    let status = pellicle_bsdf_eval(
                        bsdf,
                        wo.as_ptr(),
                        wi.as_ptr(),
                        null(),
                        null(),
                        output,
                        null_mut(),
                        null_mut(),
                    );
                    assert_eq!(status, PELLICLE_OK);
                    pellicle_bsdf_release(bsdf);
                }
                assert!(value[0] > 0.0);
            })
        })
        .collect();
    // SAFETY: a handle of which a reference is owned.
    unsafe { pellicle_bsdf_release(bsdf) };
    for owner in owners {
        owner.join().unwrap();
    }
}
