//! Batches return exactly the bits of single calls, at every level of instructions that this processor has,
//! over the whole registry, for any numbers.

#![allow(unsafe_code)] // batches go by addresses

use crate::common::{Drawn, Variation, combinations, hemisphere, rng, uniforms};
use glam::Vec3;
use pellicle::batch::{ConstView, EvalArgs, SampleArgs, View, eval, sample};
use pellicle::bsdf::{Flags, ParamKind, models};
use pellicle::num::Level;
use pellicle::{Bsdf, Call, Description, Transport};
use rand::{Rng, RngExt};

/// Two chunks and a rest that is no multiple of any number of lanes.
const COUNT: usize = 2 * 256 + 16 + 5;

/// One plane for each component, one after another: batches use such arrays without a copy.
struct Planes<T = f32> {
    numbers: Vec<T>,
}

impl<T: Copy + Default> Planes<T> {
    fn new(components: usize, number: impl FnMut(usize, usize) -> T) -> Self {
        let mut number = number;
        let numbers = (0..components).flat_map(|c| (0..COUNT).map(move |i| (i, c)));
        Self {
            numbers: numbers.map(|(i, c)| number(i, c)).collect(),
        }
    }

    fn get<const N: usize>(&self, i: usize) -> [T; N] {
        std::array::from_fn(|c| self.numbers[c * COUNT + i])
    }

    fn view(&mut self) -> View<T> {
        View {
            data: self.numbers.as_mut_ptr(),
            element_stride: 4,
            component_stride: 4 * COUNT as isize,
        }
    }
}

impl Planes {
    fn of(vectors: &[Vec3]) -> Self {
        Self::new(3, |i, c| vectors[i][c])
    }

    fn const_view(&self) -> ConstView {
        self.view_from(0)
    }

    /// The planes from one of them on.
    fn view_from(&self, plane: usize) -> ConstView {
        ConstView {
            data: self.numbers.as_ptr().wrapping_add(plane * COUNT),
            element_stride: 4,
            component_stride: 4 * COUNT as isize,
        }
    }

    /// A view for each parameter, whose planes follow one another.
    fn views(&self, ranges: &[Vec<[f32; 2]>]) -> Vec<ConstView> {
        let mut plane = 0;
        let next = |components: &Vec<[f32; 2]>| {
            plane += components.len();
            self.view_from(plane - components.len())
        };
        ranges.iter().map(next).collect()
    }
}

/// A direction, sometimes an invalid one or one that is hard to handle.
fn direction(rng: &mut impl Rng) -> Vec3 {
    let w = hemisphere(rng).as_vec3();
    match rng.random_range(0..40) {
        0 => -w,
        1 => Vec3::ZERO,
        2 => Vec3::new(f32::NAN, w.y, w.z),
        3 => Vec3::new(w.x, f32::INFINITY, w.z),
        4 => w * 1.5,
        5 => Vec3::new(1.0, 0.0, 0.0),
        6 => Vec3::new(0.6, 0.8, 1e-30),
        7 => Vec3::new(0.6, 0.8, f32::from_bits(1)),
        8 => Vec3::Z,
        9..=14 => w * rng.random_range(0.9985..1.0015),
        15 => w * (1.0 + rng.random_range(-3e-6..3e-6)),
        16 => Vec3::new(f32::MAX, 0.0, 0.1),
        _ => w,
    }
}

/// Three uniform numbers, sometimes invalid ones.
fn uniform(rng: &mut impl Rng) -> Vec3 {
    let u = Vec3::from(uniforms(rng));
    match rng.random_range(0..20) {
        0 => Vec3::new(1.0, u.y, u.z),
        1 => Vec3::new(u.x, f32::NAN, u.z),
        2 => Vec3::new(u.x, u.y, -0.5),
        3 => Vec3::ZERO,
        _ => u,
    }
}

/// A number of a varying parameter, sometimes outside of its range or not finite.
fn number(rng: &mut impl Rng, min: f32, max: f32) -> f32 {
    match rng.random_range(0..40) {
        0 => f32::NAN,
        1 => f32::NEG_INFINITY,
        2 => min - 1.0,
        3 => max + 1.0,
        4 => min,
        5 => max,
        _ => min + (max - min) * rng.random::<f32>(),
    }
}

/// The range of each number of each parameter that varies; a direction's numbers also give invalid ones.
fn ranges(drawn: &Drawn, variations: &[Variation]) -> Vec<Vec<[f32; 2]>> {
    let of = |variation: &Variation| {
        let param = &drawn.entry.info.params[variation.param];
        let range = match param.kind {
            ParamKind::Direction { .. } => [-0.5, 1.0],
            _ => variation.range,
        };
        vec![range; param.components()]
    };
    variations.iter().map(of).collect()
}

struct Batch {
    wo: Vec<Vec3>,
    other: Vec<Vec3>,
    varying: Vec<Vec<f32>>,
}

impl Batch {
    fn drawn(ranges: &[Vec<[f32; 2]>], is_sampled: bool, rng: &mut impl Rng) -> Self {
        let mut varying = Vec::new();
        for _ in 0..COUNT {
            varying.push(
                ranges
                    .iter()
                    .flatten()
                    .map(|[min, max]| number(rng, *min, *max))
                    .collect(),
            );
        }
        Self {
            wo: (0..COUNT).map(|_| direction(rng)).collect(),
            other: (0..COUNT)
                .map(|_| {
                    if is_sampled {
                        uniform(rng)
                    } else {
                        direction(rng)
                    }
                })
                .collect(),
            varying,
        }
    }

    /// The varying numbers, one plane for each component.
    fn planes(&self) -> Planes {
        let components = self.varying[0].len();
        Planes::new(components, |i, c| self.varying[i][c])
    }

    fn of(&self, i: usize) -> Option<&[f32]> {
        (!self.varying[i].is_empty()).then_some(&self.varying[i])
    }
}

fn bits<const N: usize>(numbers: [f32; N]) -> [u32; N] {
    numbers.map(f32::to_bits)
}

/// The default for most seeds; for the others importance, and one of the BSDF's lobes or none.
fn call(bsdf: &Bsdf, seed: u64) -> Call {
    if !seed.is_multiple_of(3) {
        return Call::default();
    }
    let lobes = bsdf.lobe_infos();
    let lobe = lobes.get(seed as usize / 3 % (lobes.len() + 1));
    Call {
        transport: Transport::Importance,
        lobes: lobe.map_or(Flags(0), |lobe| lobe.flags),
    }
}

pub fn check_eval(description: &Description, ranges: &[Vec<[f32; 2]>], seed: u64) {
    let bsdf = Bsdf::<f32>::new(description).unwrap();
    let call = call(&bsdf, seed);
    let batch = Batch::drawn(ranges, false, &mut rng(seed));
    let (wo, wi, varying) = (
        Planes::of(&batch.wo),
        Planes::of(&batch.other),
        batch.planes(),
    );
    let views = varying.views(ranges);
    let singles: Vec<_> = (0..COUNT)
        .map(|i| bsdf.evaluate(batch.wo[i], batch.other[i], batch.of(i), &call))
        .collect();
    for level in Level::all() {
        for with_pdf in [false, true] {
            let mut value = Planes::new(3, |_, _| f32::NAN);
            let [mut pdf, mut reverse] = [(); 2].map(|()| Planes::new(1, |_, _| f32::NAN));
            let [mut pdf_view, mut reverse_view] = [pdf.view(), reverse.view()];
            if !with_pdf {
                pdf_view.data = std::ptr::null_mut();
                reverse_view.data = std::ptr::null_mut();
            }
            let args = EvalArgs {
                count: COUNT,
                call,
                wo: wo.const_view(),
                wi: wi.const_view(),
                varying: &views,
                value: value.view(),
                pdf: pdf_view,
                pdf_reverse: reverse_view,
            };
            // SAFETY: all views are of arrays of COUNT elements.
            unsafe { eval(&bsdf, &args, level) }.unwrap();
            for (i, single) in singles.iter().enumerate() {
                let what = || {
                    let (wo, wi, varying) = (batch.wo[i], batch.other[i], &batch.varying[i]);
                    let level = level.name();
                    format!("{level} {description:?} {wo:?} {wi:?} {varying:?} {single:?}")
                };
                assert_eq!(bits(value.get(i)), bits(single.value), "{}", what());
                if with_pdf {
                    let found = [pdf.get::<1>(i)[0], reverse.get::<1>(i)[0]];
                    let expected = [single.pdf, single.pdf_reverse];
                    assert_eq!(bits(found), bits(expected), "{}", what());
                }
            }
        }
    }
}

pub fn check_sample(description: &Description, ranges: &[Vec<[f32; 2]>], seed: u64) {
    let bsdf = Bsdf::<f32>::new(description).unwrap();
    let call = call(&bsdf, seed);
    let batch = Batch::drawn(ranges, true, &mut rng(seed));
    let (wo, u, varying) = (
        Planes::of(&batch.wo),
        Planes::of(&batch.other),
        batch.planes(),
    );
    let views = varying.views(ranges);
    let singles: Vec<_> = (0..COUNT)
        .map(|i| bsdf.sample(batch.wo[i], batch.other[i], batch.of(i), &call))
        .collect();
    for level in Level::all() {
        let [mut wi, mut weight] = [(); 2].map(|()| Planes::new(3, |_, _| f32::NAN));
        let [mut pdf, mut eta, mut probability] = [(); 3].map(|()| Planes::new(1, |_, _| f32::NAN));
        let [mut flags, mut lobe] = [(); 2].map(|()| Planes::new(1, |_, _| u32::MAX));
        let args = SampleArgs {
            count: COUNT,
            call,
            wo: wo.const_view(),
            u: u.const_view(),
            varying: &views,
            wi: wi.view(),
            pdf: pdf.view(),
            weight: weight.view(),
            eta: eta.view(),
            flags: flags.view(),
            lobe: lobe.view(),
            lobe_probability: probability.view(),
        };
        // SAFETY: all views are of arrays of COUNT elements.
        unsafe { sample(&bsdf, &args, level) }.unwrap();
        for (i, single) in singles.iter().enumerate() {
            let what = || format!("{} {description:?} {single:?}", level.name());
            assert_eq!(bits(wi.get(i)), bits(single.wi.to_array()), "{}", what());
            assert_eq!(bits(weight.get(i)), bits(single.weight), "{}", what());
            let found = [&pdf, &eta, &probability].map(|plane| plane.get::<1>(i)[0]);
            let expected = [single.pdf, single.eta, single.lobe_probability];
            assert_eq!(bits(found), bits(expected), "{}", what());
            let found = [flags.get::<1>(i)[0], lobe.get::<1>(i)[0]];
            let expected = [single.flags.0, single.lobe as u32];
            assert_eq!(found, expected, "{}", what());
        }
    }
}

/// Draws of each model at the least; more where it has more combinations of choices.
const DRAWS: u64 = 30;
/// Draws in which each parameter that can vary must have varied.
const LEAST_VARIED: usize = 10;

/// Calls `check` with draws of every model: with nothing that varies, with all that can, and with one parameter
/// varying. Fails if a parameter that can vary hardly ever did.
fn for_every_model(check: impl Fn(&Description, &[Vec<[f32; 2]>], u64)) {
    let mut missing = Vec::new();
    for entry in models() {
        let params = entry.info.params;
        let can_vary: Vec<usize> = (0..params.len()).filter(|i| params[*i].can_vary).collect();
        let mut varied = vec![0; params.len()];
        for seed in 0..combinations(entry).max(DRAWS) {
            let drawn = Drawn::new(entry, seed);
            let rng = &mut rng(!seed);
            check(&drawn.description, &[], seed);
            // Drawn, because a cycle would be in step with that of the choices.
            let one = can_vary[rng.random_range(0..can_vary.len())];
            for chosen in [&can_vary[..], &[one]] {
                let (description, variations) = drawn.varied(rng, |param| chosen.contains(&param));
                check(&description, &ranges(&drawn, &variations), seed);
                for variation in variations {
                    varied[variation.param] += 1;
                }
            }
        }
        for param in can_vary
            .into_iter()
            .filter(|param| varied[*param] < LEAST_VARIED)
        {
            missing.push((entry.name(), params[param].name(), varied[param]));
        }
    }
    assert!(
        missing.is_empty(),
        "parameters that hardly ever varied: {missing:?}"
    );
}

#[test]
fn values_are_those_of_single_calls() {
    for_every_model(check_eval);
}

#[test]
fn samples_are_those_of_single_calls() {
    for_every_model(check_sample);
}

/// On x86-64 processors from the last ten years there is more than the baseline to test.
#[test]
fn levels_have_names() {
    let names: Vec<_> = Level::all().iter().map(|level| level.name()).collect();
    println!("{names:?}");
    assert!(!names.is_empty());
    assert!(cfg!(not(target_arch = "x86_64")) || names[0] == "sse2");
}
