//! Batches through views of every kind: any stride, any alignment, every count about the sizes that batches are
//! cut into, outputs that take the place of inputs. Results are those of single calls, bit for bit, and
//! nothing else is written.

#![allow(unsafe_code)] // batches go by addresses

mod common;
#[path = "common/strided.rs"]
mod strided;

use common::films::{Kind, bare, compiled, constant};
use common::{hemisphere, rng, uniforms};
use glam::Vec3;
use pellicle::batch::{
    ConstView, EvalArgs, FilmArgs, SampleArgs, View, eval, film_reflectance, sample,
};
use pellicle::film::{Film, FilmDescription};
use pellicle::num::Level;
use pellicle::{Bsdf, Description, Sample};
use rand::RngExt;
use strided::{Array, BROADCAST, LAYOUTS, Layout};

/// None, one by one, less than a tile, about 16 lanes, and more than a chunk of 256.
const COUNTS: [usize; 9] = [0, 1, 4, 7, 63, 64, 65, 256, 277];

/// A BSDF, and the ranges of the numbers that vary; of a direction none.
struct Subject {
    bsdf: Bsdf,
    ranges: Vec<Option<[f32; 2]>>,
}

/// With nothing that varies, with a colour, with all that can, and one that batches call one by one.
fn subjects() -> Vec<Subject> {
    let lambert = Description::new("lambert").vary("reflectance", 0.0, 1.0);
    let microfacet = Description::new("microfacet").choose("distribution", "ggx");
    let layered = Description::new("layered")
        .vary("thickness_nm", 0.0, 800.0)
        .vary("base_normal", 0.0, 0.0)
        .vary("base", 0.0, 1.0);
    let film = Description::new("film")
        .film(Kind::Lens.film())
        .vary("thickness_nm", 0.0, 600.0);
    let new = |description: &Description, ranges: &[Option<[f32; 2]>]| Subject {
        bsdf: Bsdf::new(description).unwrap(),
        ranges: ranges.to_vec(),
    };
    let unit = Some([0.0, 1.0]);
    vec![
        new(&microfacet, &[]),
        new(&lambert, &[unit]),
        new(&layered, &[Some([0.0, 800.0]), None, unit]),
        new(&film, &[Some([0.0, 600.0])]),
    ]
}

/// What is given, in memory.
struct Inputs {
    wo: Array,
    wi: Array,
    u: Array,
    varying: Vec<Array>,
}

impl Inputs {
    fn new(subject: &Subject, count: usize, layout: Layout) -> Self {
        let rng = &mut rng(count as u64);
        let [mut wo, mut wi, mut u] = [(); 3].map(|()| Array::new(layout, count, 3));
        let components = subject.bsdf.varying_components();
        let mut varying: Vec<Array> = components.map(|c| Array::new(layout, count, c)).collect();
        for i in 0..count {
            wo.set(i, &hemisphere(rng).as_vec3().to_array());
            wi.set(i, &hemisphere(rng).as_vec3().to_array());
            u.set(i, &uniforms(rng));
            for (array, range) in varying.iter_mut().zip(&subject.ranges) {
                let numbers: Vec<f32> = match range {
                    Some([min, max]) => {
                        let number = |_| min + (max - min) * rng.random::<f32>();
                        (0..array.numbers(i).len()).map(number).collect()
                    }
                    None => hemisphere(rng).as_vec3().to_array().to_vec(),
                };
                array.set(i, &numbers);
            }
        }
        Self { wo, wi, u, varying }
    }

    fn views(&self) -> Vec<ConstView> {
        self.varying.iter().map(Array::const_view).collect()
    }

    fn numbers(&self, i: usize) -> Vec<f32> {
        self.varying
            .iter()
            .flat_map(|array| array.numbers(i))
            .collect()
    }

    fn evaluated(&self, bsdf: &Bsdf, count: usize) -> Vec<([f32; 3], f32)> {
        let single = |i| {
            let [wo, wi] = [&self.wo, &self.wi].map(|array| Vec3::from(array.get(i)));
            let varying = self.numbers(i);
            bsdf.eval_pdf(wo, wi, (!varying.is_empty()).then_some(&varying))
        };
        (0..count).map(single).collect()
    }

    fn sampled(&self, bsdf: &Bsdf, count: usize) -> Vec<Sample> {
        let single = |i| {
            let [wo, u] = [&self.wo, &self.u].map(|array| Vec3::from(array.get(i)));
            let varying = self.numbers(i);
            bsdf.sample(wo, u, (!varying.is_empty()).then_some(&varying))
        };
        (0..count).map(single).collect()
    }
}

/// Calls `check` with every subject, count, and pair of layouts of inputs and outputs; inputs may be one
/// element for all.
fn for_every_view(check: impl Fn(&Subject, usize, Layout, Layout)) {
    for subject in subjects() {
        for count in COUNTS {
            for input in LAYOUTS.into_iter().chain([BROADCAST]) {
                for output in LAYOUTS {
                    // All of one kind, or one of them far apart: every kind is met on both sides.
                    if input.0 == output.0 || input.0 == "elements" || output.0 == "planes" {
                        check(&subject, count, input, output);
                    }
                }
            }
        }
    }
}

fn bits<const N: usize>(numbers: [f32; N]) -> [u32; N] {
    numbers.map(f32::to_bits)
}

const NOT_WANTED: View = View {
    data: std::ptr::null_mut(),
    element_stride: 0,
    component_stride: 0,
};

#[test]
fn values_go_through_every_view() {
    for_every_view(|subject, count, input, output| {
        let inputs = Inputs::new(subject, count, input);
        let expected = inputs.evaluated(&subject.bsdf, count);
        for level in Level::all() {
            let mut value = Array::new(output, count, 3);
            let mut pdf = Array::new(output, count, 1);
            let args = EvalArgs {
                count,
                wo: inputs.wo.const_view(),
                wi: inputs.wi.const_view(),
                varying: &inputs.views(),
                value: value.view(),
                pdf: pdf.view(),
            };
            // SAFETY: all views are of arrays of `count` elements.
            unsafe { eval(&subject.bsdf, &args, level) }.unwrap();
            let what = format!("{}: {count} {} -> {}", level.name(), input.0, output.0);
            for (i, expected) in expected.iter().enumerate() {
                assert_eq!(bits(value.get(i)), bits(expected.0), "{what}, {i}");
                assert_eq!(bits(pdf.get(i)), bits([expected.1]), "{what}, {i}");
            }
            assert!(
                value.rest_is_untouched() && pdf.rest_is_untouched(),
                "{what}"
            );
        }
    });
}

#[test]
fn samples_go_through_every_view() {
    for_every_view(|subject, count, input, output| {
        let inputs = Inputs::new(subject, count, input);
        let expected = inputs.sampled(&subject.bsdf, count);
        for level in Level::all() {
            let [mut wi, mut weight] = [(); 2].map(|()| Array::new(output, count, 3));
            let mut numbers = [(); 4].map(|()| Array::new(output, count, 1));
            let [pdf, eta, flags, lobe] = &mut numbers;
            let args = SampleArgs {
                count,
                wo: inputs.wo.const_view(),
                u: inputs.u.const_view(),
                varying: &inputs.views(),
                wi: wi.view(),
                pdf: pdf.view(),
                weight: weight.view(),
                eta: eta.view(),
                flags: flags.view(),
                lobe: lobe.view(),
            };
            // SAFETY: all views are of arrays of `count` elements.
            unsafe { sample(&subject.bsdf, &args, level) }.unwrap();
            let what = format!("{}: {count} {} -> {}", level.name(), input.0, output.0);
            for (i, expected) in expected.iter().enumerate() {
                assert_eq!(bits(wi.get(i)), bits(expected.wi.to_array()), "{what}, {i}");
                assert_eq!(bits(weight.get(i)), bits(expected.weight), "{what}, {i}");
                let found = [&numbers[0], &numbers[1], &numbers[2], &numbers[3]];
                let [pdf, eta] = bits([expected.pdf, expected.eta]);
                let expected = [pdf, eta, expected.flags.0, expected.lobe as u32];
                assert_eq!(found.map(|array| array.bits(i, 0)), expected, "{what}, {i}");
            }
            let mut outputs = [&wi, &weight].into_iter().chain(&numbers);
            assert!(outputs.all(Array::rest_is_untouched), "{what}");
        }
    });
}

/// A film that is a table, one that is a curve, and one that is neither.
fn films() -> Vec<Film> {
    let lens = |range| bare(constant(1.5, 0.0)).layer(constant(1.38, 0.0), range);
    let bands = FilmDescription {
        method: Some("bands".into()),
        tolerance: 2e-2,
        ..lens([0.0, 600.0])
    };
    let descriptions = [lens([0.0, 600.0]), lens([300.0; 2]), bands];
    descriptions
        .iter()
        .map(|description| Film::new(description).unwrap())
        .collect()
}

#[test]
fn reflectances_go_through_every_view() {
    for film in films() {
        for count in COUNTS {
            for input in LAYOUTS.into_iter().chain([BROADCAST]) {
                for output in LAYOUTS {
                    check_film(&film, count, input, output);
                }
            }
        }
    }
}

fn check_film(film: &Film, count: usize, input: Layout, output: Layout) {
    let rng = &mut rng(count as u64);
    let [mut cos_theta, mut thickness_nm] = [(); 2].map(|()| Array::new(input, count, 1));
    for i in 0..count {
        cos_theta.set(i, &[rng.random()]);
        thickness_nm.set(i, &[600.0 * rng.random::<f32>()]);
    }
    for level in Level::all() {
        let mut reflectance = Array::new(output, count, 3);
        let args = FilmArgs {
            count,
            cos_theta: cos_theta.const_view(),
            thickness_nm: thickness_nm.const_view(),
            reflectance: reflectance.view(),
        };
        // SAFETY: all views are of arrays of `count` elements.
        unsafe { film_reflectance(film, &args, level) }.unwrap();
        let what = format!("{}: {count} {} -> {}", level.name(), input.0, output.0);
        for i in 0..count {
            let single = film.reflectance(cos_theta.get::<1>(i)[0], thickness_nm.get::<1>(i)[0]);
            assert_eq!(bits(reflectance.get(i)), bits(single), "{what}, {i}");
        }
        assert!(reflectance.rest_is_untouched(), "{what}");
    }
}

/// What an output may take the place of.
#[derive(Clone, Copy, Debug)]
enum Over {
    Wo,
    Other,
    /// A varying parameter.
    Varying(usize),
}

impl Over {
    fn array(self, inputs: &mut Inputs, is_sampled: bool) -> &mut Array {
        match self {
            Self::Wo => &mut inputs.wo,
            Self::Other if is_sampled => &mut inputs.u,
            Self::Other => &mut inputs.wi,
            Self::Varying(param) => &mut inputs.varying[param],
        }
    }
}

/// Outputs of three numbers, and of one, and what they take the place of.
const IN_PLACE: [[Over; 2]; 4] = [
    [Over::Wo, Over::Varying(0)],
    [Over::Other, Over::Varying(0)],
    [Over::Varying(1), Over::Varying(0)],
    [Over::Varying(2), Over::Varying(0)],
];

#[test]
fn outputs_may_take_the_place_of_inputs() {
    // The one with a scalar, a direction and a colour that vary.
    let subject = &subjects()[2];
    for layout in LAYOUTS {
        for count in COUNTS {
            for level in Level::all() {
                for [vector, scalar] in IN_PLACE {
                    let what = format!("{}: {count} {} {vector:?}", level.name(), layout.0);
                    check_eval_in_place(subject, count, layout, level, vector, scalar, &what);
                    check_sample_in_place(subject, count, layout, level, vector, scalar, &what);
                }
            }
        }
    }
}

fn check_eval_in_place(
    subject: &Subject,
    count: usize,
    layout: Layout,
    level: Level,
    vector: Over,
    scalar: Over,
    what: &str,
) {
    let mut inputs = Inputs::new(subject, count, layout);
    let expected = inputs.evaluated(&subject.bsdf, count);
    let value = vector.array(&mut inputs, false).view();
    let pdf = scalar.array(&mut inputs, false).view();
    let args = EvalArgs {
        count,
        wo: inputs.wo.const_view(),
        wi: inputs.wi.const_view(),
        varying: &inputs.views(),
        value,
        pdf,
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { eval(&subject.bsdf, &args, level) }.unwrap();
    for (i, expected) in expected.iter().enumerate() {
        let value = vector.array(&mut inputs, false).get(i);
        assert_eq!(bits(value), bits(expected.0), "{what}, {i}");
        let pdf = inputs.varying[0].get(i);
        assert_eq!(bits(pdf), bits([expected.1]), "{what}, {i}");
    }
}

fn check_sample_in_place(
    subject: &Subject,
    count: usize,
    layout: Layout,
    level: Level,
    vector: Over,
    scalar: Over,
    what: &str,
) {
    let mut inputs = Inputs::new(subject, count, layout);
    let expected = inputs.sampled(&subject.bsdf, count);
    let wi = vector.array(&mut inputs, true).view();
    let lobe = scalar.array(&mut inputs, true).view();
    let args = SampleArgs {
        count,
        wo: inputs.wo.const_view(),
        u: inputs.u.const_view(),
        varying: &inputs.views(),
        wi,
        pdf: NOT_WANTED,
        weight: NOT_WANTED,
        eta: NOT_WANTED,
        flags: View {
            data: std::ptr::null_mut(),
            element_stride: 0,
            component_stride: 0,
        },
        lobe,
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { sample(&subject.bsdf, &args, level) }.unwrap();
    for (i, expected) in expected.iter().enumerate() {
        let wi = vector.array(&mut inputs, true).get(i);
        assert_eq!(bits(wi), bits(expected.wi.to_array()), "{what}, {i}");
        let lobe = inputs.varying[0].bits(i, 0);
        assert_eq!(lobe, expected.lobe as u32, "{what}, {i}");
    }
}

/// An overlap that is not allowed: what comes of it is anybody's guess, but nothing outside the views is
/// written, and elements before the overlap are right.
#[test]
fn other_overlaps_are_safe() {
    const COUNT: usize = 600;
    /// Numbers by which the output lies further on.
    const SHIFT: usize = 301;
    let film = compiled(&bare(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [0.0, 600.0]));
    for level in Level::all() {
        let number = |i: usize| (i as f32 * 0.618_034).fract();
        let mut memory: Vec<f32> = (0..SHIFT + 4 * COUNT).map(number).collect();
        let given = memory.clone();
        let data = memory.as_mut_ptr();
        let plane = |data: *mut f32| ConstView {
            data,
            element_stride: 4,
            component_stride: 4,
        };
        let args = FilmArgs {
            count: COUNT,
            cos_theta: plane(data),
            thickness_nm: plane(data.wrapping_add(COUNT)),
            reflectance: View {
                data: data.wrapping_add(SHIFT),
                element_stride: 4,
                component_stride: 4 * COUNT as isize,
            },
        };
        // SAFETY: all addresses are within `memory`.
        unsafe { film_reflectance(&film, &args, level) }.unwrap();
        let end = SHIFT + 3 * COUNT;
        assert_eq!(memory[..SHIFT], given[..SHIFT], "{}", level.name());
        assert_eq!(memory[end..], given[end..], "{}", level.name());
        let single = film.reflectance(given[0], given[COUNT]);
        let first = [0, 1, 2].map(|c| memory[SHIFT + c * COUNT]);
        assert_eq!(bits(first), bits(single), "{}", level.name());
    }
}
