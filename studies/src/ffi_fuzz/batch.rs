//! Batches with arbitrary counts and strides, in memory that ends where the views end.
//!
//! What is written must be what single calls give, and nothing else may be. Strides that leave the
//! address space must be refused before any access: there the pointers lead nowhere.

use super::bytes::Bytes;
use super::guarded::Guarded;
use super::outcome::succeeded;
use super::subjects::{Subject, subject};
use pellicle::capi::*;
use std::ptr::{null, null_mut};

const MOST_ELEMENTS: usize = 300;
/// The most that a view may span; wider strides are narrowed.
const MOST_BYTES: usize = 1 << 16;
const PATTERN: u8 = 0x5A;
const WORD: isize = 4;

/// An array and its strides.
struct Array {
    memory: Guarded,
    /// Where component 0 of element 0 is.
    origin: usize,
    strides: [isize; 2],
    components: usize,
}

impl Array {
    /// Of any layout that fits; an output's numbers lie apart from each other.
    fn new(bytes: &mut Bytes, count: usize, components: usize, is_output: bool) -> Self {
        let steps = [count.saturating_sub(1), components - 1];
        let mut strides = [stride(bytes), stride(bytes)];
        let packed = [WORD * components as isize, WORD];
        let planar = [WORD, WORD * count as isize];
        strides = match bytes.byte() % 8 {
            0 => packed,
            1 => planar,
            2 => [-packed[0], WORD],
            3 => [packed[0], -WORD],
            _ => strides,
        };
        let room = MOST_BYTES as isize / 2;
        for (stride, steps) in strides.iter_mut().zip(steps) {
            let most = room / (steps as isize).max(1);
            *stride = (*stride).clamp(-most, most);
        }
        if is_output && overlaps(strides, [count, components]) {
            strides = packed;
        }
        // What lies before component 0 of element 0, and after it.
        let reach = |sign: isize| -> usize {
            let farthest = strides
                .iter()
                .zip(steps)
                .map(|(s, n)| (s * sign).max(0) as usize * n);
            farthest.sum()
        };
        let (before, after) = (reach(-1), reach(1));
        let length = if count == 0 {
            0
        } else {
            before + after + WORD as usize
        };
        Self {
            memory: Guarded::new(length, bytes.byte().is_multiple_of(2), PATTERN),
            origin: before,
            strides,
            components,
        }
    }

    fn offset(&self, i: usize, c: usize) -> usize {
        let [element, component] = self.strides;
        (self.origin as isize + i as isize * element + c as isize * component) as usize
    }

    fn set(&mut self, i: usize, c: usize, number: f32) {
        let at = self.offset(i, c);
        self.memory.bytes_mut()[at..at + 4].copy_from_slice(&number.to_ne_bytes());
    }

    fn get(&self, i: usize, c: usize) -> u32 {
        let at = self.offset(i, c);
        u32::from_ne_bytes(self.memory.bytes()[at..at + 4].try_into().unwrap())
    }

    fn numbers<const N: usize>(&self, i: usize) -> [f32; N] {
        std::array::from_fn(|c| f32::from_bits(self.get(i, c)))
    }

    fn data(&self) -> *mut f32 {
        // SAFETY: within the memory, or at the end of none.
        unsafe { self.memory.pointer().add(self.origin).cast() }
    }

    fn view(&self) -> PellicleView {
        let [element_stride, component_stride] = self.strides;
        PellicleView {
            data: self.data(),
            element_stride,
            component_stride,
        }
    }

    fn const_view(&self) -> PellicleConstView {
        let view = self.view();
        PellicleConstView {
            data: view.data,
            element_stride: view.element_stride,
            component_stride: view.component_stride,
        }
    }

    fn uint_view(&self) -> PellicleUintView {
        PellicleUintView {
            data: self.data().cast(),
            element_stride: self.strides[0],
        }
    }

    /// Panics if anything but its numbers was written.
    fn rest_must_be_untouched(&self, count: usize) {
        let mut is_named = vec![false; self.memory.bytes().len()];
        for i in 0..count {
            for c in 0..self.components {
                is_named[self.offset(i, c)..][..4].fill(true);
            }
        }
        let mut rest = self.memory.bytes().iter().zip(is_named);
        assert!(
            rest.all(|(byte, is_named)| is_named || *byte == PATTERN),
            "bytes between were written"
        );
    }
}

fn stride(bytes: &mut Bytes) -> isize {
    match bytes.byte() % 8 {
        0..4 => WORD * (bytes.byte() as i8) as isize,
        4..6 => (bytes.byte() as i8).into(),
        6 => (bytes.word() as i16).into(),
        _ => bytes.word() as isize,
    }
}

/// Whether two numbers of such an array share a byte.
fn overlaps(strides: [isize; 2], [count, components]: [usize; 2]) -> bool {
    let place = |i: usize, c: usize| i as isize * strides[0] + c as isize * strides[1];
    let mut places: Vec<isize> = (0..count)
        .flat_map(|i| (0..components).map(move |c| place(i, c)))
        .collect();
    places.sort_unstable();
    places.windows(2).any(|pair| pair[1] - pair[0] < WORD)
}

pub fn run(data: &[u8]) {
    let bytes = &mut Bytes(data);
    let number = bytes.word();
    let count = match number >> 16 & 3 {
        0 => bytes.index(20),
        _ => bytes.word() as usize % (MOST_ELEMENTS + 1),
    };
    let subject = subject(number as u16);
    match number >> 18 & 7 {
        0..3 => eval(&subject, count, bytes),
        3..6 => sample(&subject, count, bytes),
        6 => film(count, bytes),
        _ => refused(&subject, bytes),
    }
}

fn directions(bytes: &mut Bytes, count: usize) -> Array {
    let mut array = Array::new(bytes, count, 3, false);
    for i in 0..count {
        for (c, number) in bytes.direction().into_iter().enumerate() {
            array.set(i, c, number);
        }
    }
    array
}

/// Arrays of the varying parameters.
fn varying(subject: &Subject, count: usize, bytes: &mut Bytes) -> Vec<Array> {
    let mut arrays = Vec::new();
    for (components, [min, max]) in subject.varying {
        let mut array = Array::new(bytes, count, *components, false);
        for i in 0..count {
            for c in 0..*components {
                array.set(i, c, bytes.number(*min, *max));
            }
        }
        arrays.push(array);
    }
    arrays
}

/// Lane i of them, one after another.
fn flat(arrays: &[Array], i: usize) -> Vec<f32> {
    let number = |array: &Array, c| f32::from_bits(array.get(i, c));
    let all = arrays
        .iter()
        .flat_map(|array| (0..array.components).map(move |c| (array, c)));
    all.map(|(array, c)| number(array, c)).collect()
}

fn bits<const N: usize>(numbers: [f32; N]) -> [u32; N] {
    numbers.map(f32::to_bits)
}

fn eval(subject: &Subject, count: usize, bytes: &mut Bytes) {
    let (wo, wi) = (directions(bytes, count), directions(bytes, count));
    let varying = varying(subject, count, bytes);
    let views: Vec<_> = varying.iter().map(Array::const_view).collect();
    let value = Array::new(bytes, count, 3, true);
    let pdf = Array::new(bytes, count, 1, true);
    let reverse = Array::new(bytes, count, 1, true);
    let args = PellicleEvalBatchArgs {
        count,
        wo: wo.const_view(),
        wi: wi.const_view(),
        varying: views.as_ptr(),
        varying_count: views.len(),
        call: null(),
        value: value.view(),
        pdf: pdf.view(),
        pdf_reverse: reverse.view(),
    };
    // SAFETY: the handle lives on; all views are of arrays of `count` elements.
    let status = unsafe { pellicle_bsdf_eval_batch(subject.bsdf, &args, size_of_val(&args)) };
    assert_eq!(status, PELLICLE_OK);
    for i in 0..count {
        let (wo, wi, varying) = (wo.numbers::<3>(i), wi.numbers::<3>(i), flat(&varying, i));
        let (mut single, mut densities) = ([0.0; 3], [0.0; 2]);
        // SAFETY: arrays and outputs are as long as they must be.
        unsafe {
            let (wo, wi, varying) = (wo.as_ptr(), wi.as_ptr(), varying.as_ptr());
            pellicle_bsdf_eval(
                subject.bsdf,
                wo,
                wi,
                varying,
                null(),
                single.as_mut_ptr(),
                &mut densities[0],
                &mut densities[1],
            );
        }
        assert_eq!(
            bits(value.numbers(i)),
            bits(single),
            "element {i} of {count}"
        );
        let found = [pdf.numbers(i), reverse.numbers(i)];
        assert_eq!(
            found.map(bits::<1>),
            densities.map(|density| bits([density])),
            "element {i} of {count}"
        );
    }
    value.rest_must_be_untouched(count);
    pdf.rest_must_be_untouched(count);
    reverse.rest_must_be_untouched(count);
}

fn sample(subject: &Subject, count: usize, bytes: &mut Bytes) {
    let wo = directions(bytes, count);
    let mut u = Array::new(bytes, count, 3, false);
    for i in 0..count {
        for (c, number) in bytes.uniforms().into_iter().enumerate() {
            u.set(i, c, number);
        }
    }
    let varying = varying(subject, count, bytes);
    let views: Vec<_> = varying.iter().map(Array::const_view).collect();
    let [wi, pdf, weight, eta, probability, flags, lobe] =
        [3, 1, 3, 1, 1, 1, 1].map(|components| Array::new(bytes, count, components, true));
    let wanted = bytes.byte() | 1;
    let wanted_view = |bit: u8, array: &Array| PellicleView {
        data: if wanted >> bit & 1 == 1 {
            array.data()
        } else {
            null_mut()
        },
        ..array.view()
    };
    let args = PellicleSampleBatchArgs {
        count,
        wo: wo.const_view(),
        u: u.const_view(),
        varying: views.as_ptr(),
        varying_count: views.len(),
        call: null(),
        wi: wanted_view(0, &wi),
        pdf: wanted_view(1, &pdf),
        weight: wanted_view(2, &weight),
        eta: wanted_view(3, &eta),
        flags: flags.uint_view(),
        lobe: lobe.uint_view(),
        lobe_probability: wanted_view(4, &probability),
    };
    // SAFETY: the handle lives on; all views are of arrays of `count` elements.
    let status = unsafe { pellicle_bsdf_sample_batch(subject.bsdf, &args, size_of_val(&args)) };
    assert_eq!(status, PELLICLE_OK);
    for i in 0..count {
        let (wo, u, varying) = (wo.numbers::<3>(i), u.numbers::<3>(i), flat(&varying, i));
        let mut single = PellicleSample::default();
        let size = size_of::<PellicleSample>();
        // SAFETY: arrays and outputs are as long as they must be.
        unsafe {
            let (wo, u, varying) = (wo.as_ptr(), u.as_ptr(), varying.as_ptr());
            pellicle_bsdf_sample(subject.bsdf, wo, u, varying, null(), &mut single, size);
        }
        let is_wanted = |bit: u8| wanted >> bit & 1 == 1;
        assert!(
            !is_wanted(0) || bits(wi.numbers(i)) == bits(single.wi),
            "element {i} of {count}"
        );
        assert!(
            !is_wanted(1) || bits(pdf.numbers(i)) == bits([single.pdf]),
            "element {i} of {count}"
        );
        assert!(
            !is_wanted(2) || bits(weight.numbers(i)) == bits(single.weight),
            "element {i} of {count}"
        );
        assert!(
            !is_wanted(3) || bits(eta.numbers(i)) == bits([single.eta]),
            "element {i} of {count}"
        );
        assert!(
            !is_wanted(4) || bits(probability.numbers(i)) == bits([single.lobe_probability]),
            "element {i} of {count}"
        );
        assert_eq!(
            [flags.get(i, 0), lobe.get(i, 0)],
            [single.flags, single.lobe],
            "element {i} of {count}"
        );
    }
    for (bit, array) in [&wi, &pdf, &weight, &eta, &probability, &flags, &lobe]
        .into_iter()
        .enumerate()
    {
        let is_written = bit >= 5 || wanted >> bit & 1 == 1;
        array.rest_must_be_untouched(if is_written { count } else { 0 });
    }
}

fn film(count: usize, bytes: &mut Bytes) {
    let film = super::subjects::film(bytes.index(256));
    let mut column = |min, max| {
        let mut array = Array::new(bytes, count, 1, false);
        (0..count).for_each(|i| array.set(i, 0, bytes.number(min, max)));
        array
    };
    let (cosines, thicknesses) = (column(0.0, 1.0), column(0.0, 1000.0));
    let found = Array::new(bytes, count, 3, true);
    let args = PellicleFilmBatchArgs {
        count,
        cos_theta: cosines.const_view(),
        thickness_nm: thicknesses.const_view(),
        reflectance: found.view(),
        // These films allow no spread.
        thickness_spread_nm: PellicleConstView {
            data: null(),
            element_stride: 0,
            component_stride: 0,
        },
    };
    // SAFETY: the film lives on; all views are of arrays of `count` elements.
    let status = unsafe { pellicle_film_reflectance_batch(film, &args, size_of_val(&args)) };
    assert_eq!(status, PELLICLE_OK);
    for i in 0..count {
        let ([cos_theta], [thickness_nm]) = (cosines.numbers(i), thicknesses.numbers(i));
        let mut single = [0.0; 3];
        // SAFETY: three numbers.
        unsafe { pellicle_film_reflectance(film, cos_theta, thickness_nm, single.as_mut_ptr()) };
        assert_eq!(
            bits(found.numbers(i)),
            bits(single),
            "element {i} of {count}"
        );
    }
    found.rest_must_be_untouched(count);
}

/// One view of many reaches beyond what an address can say: nothing may be read or written, as nothing
/// can be.
fn refused(subject: &Subject, bytes: &mut Bytes) {
    let nowhere = Guarded::new(0, true, 0);
    let data: *mut f32 = nowhere.pointer().cast();
    let count = 3 + bytes.word() as usize % (isize::MAX as usize);
    // (count - 1) strides, or two, are more than half of the address space.
    let beyond = isize::MAX / (count - 1) as isize + 1;
    let strides = match bytes.byte() % 4 {
        0 => [beyond, WORD],
        1 => [-beyond, WORD],
        2 => [isize::MIN, isize::MIN],
        _ => [0, isize::MAX - 1],
    };
    let wrong = bytes.index(4);
    let view = |place: usize| PellicleView {
        data,
        element_stride: if place == wrong { strides[0] } else { 0 },
        component_stride: if place == wrong { strides[1] } else { 0 },
    };
    let read = |place: usize| PellicleConstView {
        data,
        element_stride: view(place).element_stride,
        component_stride: view(place).component_stride,
    };
    let args = PellicleEvalBatchArgs {
        count,
        wo: read(0),
        wi: read(1),
        varying: std::ptr::null(),
        varying_count: 0,
        call: null(),
        value: view(2),
        pdf: view(if strides[0] == 0 { 4 } else { 3 }),
        pdf_reverse: PellicleView {
            data: null_mut(),
            ..view(4)
        },
    };
    let is_needed = wrong < 3 || strides[0] != 0;
    if !is_needed {
        return;
    }
    // SAFETY: refused before any address is used, which the inaccessible memory proves.
    let status = unsafe { pellicle_bsdf_eval_batch(subject.bsdf, &args, size_of_val(&args)) };
    assert!(
        !succeeded(status, &[PELLICLE_INVALID_ARGUMENT]),
        "an impossible view was accepted"
    );
}
