//! Batches through views of every kind: any stride, any alignment, and counts about the sizes of chunks.
//! Results have exactly the bits of single calls, and no other byte is written.

#![allow(unsafe_code)] // batches go by addresses

use super::batch_inputs::*;
use crate::common::films::{bare, constant};
use crate::common::rng;
use crate::strided::{Array, BROADCAST, LAYOUTS, Layout};
use pellicle::Bsdf;
use pellicle::batch::{ConstView, FilmArgs, SampleArgs, eval, film_reflectance, sample};
use pellicle::film::{Film, FilmDescription};
use pellicle::num::Level;
use rand::RngExt;

/// Calls `check` with every BSDF, count, and pair of layouts of inputs and outputs; inputs may be one
/// element for all.
fn for_every_view(check: impl Fn(&Bsdf, usize, Layout, Layout)) {
    for bsdf in subjects() {
        for count in COUNTS {
            for input in LAYOUTS.into_iter().chain([BROADCAST]) {
                for output in LAYOUTS {
                    // Every layout is met as an input and as an output, not every pair of them.
                    if input.0 == output.0 || input.0 == "elements" || output.0 == "planes" {
                        check(&bsdf, count, input, output);
                    }
                }
            }
        }
    }
}

#[test]
fn values_go_through_every_view() {
    for_every_view(|bsdf, count, input, output| {
        let inputs = Inputs::new(bsdf, count, input);
        let expected = inputs.evaluated(bsdf);
        for level in Level::all() {
            let mut value = Array::new(output, count, 3);
            let [mut pdf, mut reverse] = [(); 2].map(|()| Array::new(output, count, 1));
            let varying = inputs.views();
            let args = inputs.eval_args(&varying, value.view(), [pdf.view(), reverse.view()]);
            // SAFETY: all views are of arrays of `count` elements.
            unsafe { eval(bsdf, &args, level) }.unwrap();
            let what = format!("{}: {count} {} -> {}", level.name(), input.0, output.0);
            for (i, expected) in expected.iter().enumerate() {
                assert_eq!(bits(value.get(i)), bits(expected.value), "{what}, {i}");
                assert_eq!(bits(pdf.get(i)), bits([expected.pdf]), "{what}, {i}");
                let found = bits(reverse.get(i));
                assert_eq!(found, bits([expected.pdf_reverse]), "{what}, {i}");
            }
            let mut outputs = [&value, &pdf, &reverse].into_iter();
            assert!(outputs.all(Array::rest_is_untouched), "{what}");
        }
    });
}

#[test]
fn samples_go_through_every_view() {
    for_every_view(|bsdf, count, input, output| {
        let inputs = Inputs::new(bsdf, count, input);
        let expected = inputs.sampled(bsdf);
        for level in Level::all() {
            let [mut wi, mut weight] = [(); 2].map(|()| Array::new(output, count, 3));
            let mut numbers = [(); 5].map(|()| Array::new(output, count, 1));
            let [pdf, eta, flags, lobe, probability] = &mut numbers;
            let varying = inputs.views();
            let args = SampleArgs {
                pdf: pdf.view(),
                weight: weight.view(),
                eta: eta.view(),
                flags: flags.view(),
                lobe_probability: probability.view(),
                ..inputs.sample_args(&varying, wi.view(), lobe.view())
            };
            // SAFETY: all views are of arrays of `count` elements.
            unsafe { sample(bsdf, &args, level) }.unwrap();
            let what = format!("{}: {count} {} -> {}", level.name(), input.0, output.0);
            for (i, expected) in expected.iter().enumerate() {
                assert_eq!(bits(wi.get(i)), bits(expected.wi.to_array()), "{what}, {i}");
                assert_eq!(bits(weight.get(i)), bits(expected.weight), "{what}, {i}");
                let [pdf, eta, probability] =
                    bits([expected.pdf, expected.eta, expected.lobe_probability]);
                let expected = [
                    pdf,
                    eta,
                    expected.flags.0,
                    expected.lobe as u32,
                    probability,
                ];
                let found = numbers.each_ref().map(|array| array.bits(i, 0));
                assert_eq!(found, expected, "{what}, {i}");
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
            thickness_spread_nm: ConstView::NONE,
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
