//! Outputs of batches that take the place of inputs, and overlaps that are not allowed.

#![allow(unsafe_code)] // batches go by addresses

use super::batch_inputs::*;
use crate::common::films::{bare, compiled, constant};
use crate::strided::{Array, LAYOUTS, Layout};
use pellicle::Bsdf;
use pellicle::batch::{ConstView, FilmArgs, View, eval, film_reflectance, sample};
use pellicle::num::Level;

/// The input whose memory an output uses.
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

/// Inputs whose memory is used by an output of three numbers, and by one of one number.
const IN_PLACE: [[Over; 2]; 4] = [
    [Over::Wo, Over::Varying(0)],
    [Over::Other, Over::Varying(0)],
    [Over::Varying(1), Over::Varying(0)],
    [Over::Varying(2), Over::Varying(0)],
];

#[test]
fn outputs_may_take_the_place_of_inputs() {
    // The BSDF in which a scalar, a direction and a colour vary.
    let bsdf = &subjects()[2];
    for layout in LAYOUTS {
        for count in COUNTS {
            for level in Level::all() {
                for [vector, scalar] in IN_PLACE {
                    let what = format!("{}: {count} {} {vector:?}", level.name(), layout.0);
                    check_eval_in_place(bsdf, count, layout, level, vector, scalar, &what);
                    check_sample_in_place(bsdf, count, layout, level, vector, scalar, &what);
                }
            }
        }
    }
}

fn check_eval_in_place(
    bsdf: &Bsdf,
    count: usize,
    layout: Layout,
    level: Level,
    vector: Over,
    scalar: Over,
    what: &str,
) {
    let mut inputs = Inputs::new(bsdf, count, layout);
    let expected = inputs.evaluated(bsdf);
    let value = vector.array(&mut inputs, false).view();
    let pdf = scalar.array(&mut inputs, false).view();
    let varying = inputs.views();
    let args = inputs.eval_args(&varying, value, [pdf, NOT_WANTED]);
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { eval(bsdf, &args, level) }.unwrap();
    for (i, expected) in expected.iter().enumerate() {
        let value = vector.array(&mut inputs, false).get(i);
        assert_eq!(bits(value), bits(expected.value), "{what}, {i}");
        let pdf = inputs.varying[0].get(i);
        assert_eq!(bits(pdf), bits([expected.pdf]), "{what}, {i}");
    }
}

fn check_sample_in_place(
    bsdf: &Bsdf,
    count: usize,
    layout: Layout,
    level: Level,
    vector: Over,
    scalar: Over,
    what: &str,
) {
    let mut inputs = Inputs::new(bsdf, count, layout);
    let expected = inputs.sampled(bsdf);
    let wi = vector.array(&mut inputs, true).view();
    let lobe = scalar.array(&mut inputs, true).view();
    let varying = inputs.views();
    let args = inputs.sample_args(&varying, wi, lobe);
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { sample(bsdf, &args, level) }.unwrap();
    for (i, expected) in expected.iter().enumerate() {
        let wi = vector.array(&mut inputs, true).get(i);
        assert_eq!(bits(wi), bits(expected.wi.to_array()), "{what}, {i}");
        let lobe = inputs.varying[0].bits(i, 0);
        assert_eq!(lobe, expected.lobe as u32, "{what}, {i}");
    }
}

/// After an overlap that is not allowed, results are unspecified, but nothing outside the views is written, and
/// elements before the overlap are right.
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
            thickness_spread_nm: ConstView::NONE,
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
