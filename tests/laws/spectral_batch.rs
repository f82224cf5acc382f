//! Batches of spectral calls return exactly the bits of single calls, over the whole registry.

#![allow(unsafe_code)] // batches go by addresses

use super::spectral::{Spectral, cases, sampled, spectral_numbers};
use crate::common::{hemisphere, rng, uniforms};
use glam::Vec3;
use pellicle::Call;
use pellicle::batch::{
    ConstView, EvalSpectralArgs, SampleSpectralArgs, SpectralInputs, View, eval_spectral,
    sample_spectral,
};
use pellicle::bsdf::{MAX_WAVELENGTHS, models};
use rand::RngExt;

/// Elements of a batch.
const COUNT: usize = 21;

/// Numbers that lie one element after another.
fn rows(numbers: &[f32], components: usize) -> ConstView {
    ConstView {
        data: numbers.as_ptr(),
        element_stride: 4 * components as isize,
        component_stride: 4,
    }
}

fn rows_mut<T>(numbers: &mut [T], components: usize) -> View<T> {
    View {
        data: numbers.as_mut_ptr(),
        element_stride: 4 * components as isize,
        component_stride: 4,
    }
}

#[test]
fn batches_are_the_bits_of_single_calls() {
    let (mut values, mut samples) = (0, 0);
    for entry in models() {
        for case in cases(entry).iter().step_by(3) {
            let mut rng = rng(5);
            let count = rng.random_range(1..=MAX_WAVELENGTHS);
            let hero = rng.random_range(0..count);
            let bsdf = &case.single;
            let each = |rng: &mut _| hemisphere(rng).as_vec3();
            let wo: Vec<Vec3> = (0..COUNT).map(|_| each(&mut rng)).collect();
            let wi: Vec<Vec3> = (0..COUNT).map(|_| each(&mut rng)).collect();
            let u: Vec<[f32; 3]> = (0..COUNT).map(|_| uniforms(&mut rng)).collect();
            let lambda_nm: Vec<f32> = (0..COUNT * count)
                .map(|_| rng.random_range(400.0..700.0))
                .collect();
            let numbers: Vec<Vec<f32>> = (0..COUNT)
                .map(|_| spectral_numbers(case, count, &mut rng))
                .collect();
            let floats = bsdf.spectral_varying_floats(count);
            assert_eq!(floats, numbers[0].len());
            let (flat, mut first, mut views) = (numbers.concat(), 0, Vec::new());
            for varying in bsdf.varying() {
                let view = rows(&flat[first.min(flat.len() - 1)..], floats);
                views.push(view);
                first += varying.param.spectral_components(count);
            }
            let flat_vectors = |vectors: &[Vec3]| -> Vec<f32> {
                vectors.iter().flat_map(|w| w.to_array()).collect()
            };
            let (wo_flat, wi_flat) = (flat_vectors(&wo), flat_vectors(&wi));
            let inputs = SpectralInputs {
                count: COUNT,
                lambda_count: count,
                call: Call::default(),
                lambda_nm: rows(&lambda_nm, count),
                wo: rows(&wo_flat, 3),
                varying: &views,
            };
            let [mut value, mut pdf, mut weight, mut density] =
                [(); 4].map(|()| vec![-1.0; COUNT * count]);
            let args = EvalSpectralArgs {
                inputs,
                wi: rows(&wi_flat, 3),
                value: rows_mut(&mut value, count),
                pdf: rows_mut(&mut pdf, count),
            };
            // SAFETY: the views are those of arrays of COUNT elements.
            unsafe { eval_spectral(bsdf, &args).unwrap() };
            let mut directions = vec![-1.0; 3 * COUNT];
            let [mut eta, mut probability] = [(); 2].map(|()| vec![-1.0; COUNT]);
            let [mut flags, mut lobe, mut hero_only] = [(); 3].map(|()| vec![9_u32; COUNT]);
            let args = SampleSpectralArgs {
                inputs,
                hero,
                u: rows(u.as_flattened(), 3),
                wi: rows_mut(&mut directions, 3),
                weight: rows_mut(&mut weight, count),
                pdf: rows_mut(&mut density, count),
                eta: rows_mut(&mut eta, 1),
                flags: rows_mut(&mut flags, 1),
                lobe: rows_mut(&mut lobe, 1),
                lobe_probability: rows_mut(&mut probability, 1),
                hero_only: rows_mut(&mut hero_only, 1),
            };
            // SAFETY: the same.
            unsafe { sample_spectral(bsdf, &args).unwrap() };
            for i in 0..COUNT {
                let own = i * count..(i + 1) * count;
                let nm: Vec<f64> = lambda_nm[own.clone()]
                    .iter()
                    .map(|nm| f64::from(*nm))
                    .collect();
                let pair = [wo[i].as_dvec3(), wi[i].as_dvec3()];
                let single = Spectral::of(bsdf, pair, &numbers[i], &nm).unwrap();
                assert_eq!(bits(&single.value), bits(&value[own.clone()]));
                assert_eq!(bits(&single.pdf), bits(&pdf[own.clone()]));
                values += single.value.iter().filter(|value| **value > 0.0).count();
                let u = Vec3::from(u[i]).as_dvec3();
                let (sample, weights, pdfs) = sampled(bsdf, pair[0], u, &numbers[i], &nm, hero);
                assert_eq!(bits(&weights), bits(&weight[own.clone()]));
                assert_eq!(bits(&pdfs), bits(&density[own.clone()]));
                let row = &directions[3 * i..3 * i + 3];
                assert_eq!(bits(&sample.wi.to_array()), bits(row));
                assert_eq!(
                    [sample.eta, sample.lobe_probability],
                    [eta[i], probability[i]]
                );
                let numbers = [
                    sample.flags.0,
                    sample.lobe as u32,
                    sample.is_hero_only.into(),
                ];
                assert_eq!(numbers, [flags[i], lobe[i], hero_only[i]]);
                samples += usize::from(sample.lobe_probability > 0.0);
            }
        }
    }
    assert!(values > 1000 && samples > 500, "{values} {samples}");
}

fn bits(numbers: &[f32]) -> Vec<u32> {
    numbers.iter().map(|number| number.to_bits()).collect()
}
