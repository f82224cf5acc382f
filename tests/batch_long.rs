//! Ten million elements at once: all of them are those of batches of pieces, and those at the boundaries of
//! pieces, with some others, those of single calls, bit for bit.

#![allow(unsafe_code)] // batches go by addresses

mod common;

use common::films::{bare, compiled, constant};
use common::rng;
use glam::Vec3;
use pellicle::batch::{
    ConstView, EvalArgs, FilmArgs, SampleArgs, View, eval, film_reflectance, sample,
};
use pellicle::num::Level;
use pellicle::{Bsdf, Description};
use rand::RngExt;

const COUNT: usize = 10_000_000;
/// No multiple of what batches are cut into.
const PIECE: usize = 100_003;
/// What they are cut into.
const CHUNK: usize = 256;
/// Elements compared with single calls beside those at boundaries.
const SINGLES: usize = 10_000;

/// A number in [0, 1) for element i: multiples of an irrational number fill it evenly.
fn number(i: usize, which: usize) -> f32 {
    const STEPS: [f64; 5] = [
        0.618_033_988_7,
        0.414_213_562_4,
        0.732_050_807_6,
        0.236_067_977_5,
        0.645_751_311_1,
    ];
    ((i as f64 * STEPS[which]).fract() as f32).min(1.0 - f32::EPSILON)
}

/// A direction for element i; every seventh is below the surface.
fn direction(i: usize, which: usize) -> Vec3 {
    let square = Vec3::new(number(i, which) - 0.5, number(i, which + 1) - 0.5, 0.35);
    let w = square.normalize();
    if i % 7 == 3 { -w } else { w }
}

fn uniform(i: usize) -> Vec3 {
    [2, 3, 4].map(|which| number(i, which)).into()
}

/// The elements on both sides of every boundary, and others.
fn checked() -> impl Iterator<Item = usize> {
    let mut rng = rng(5);
    let boundaries = (0..COUNT).step_by(CHUNK).flat_map(|i| [i, i + CHUNK - 1]);
    let others = (0..SINGLES).map(move |_| rng.random_range(0..COUNT));
    let all = boundaries.chain(others).chain([COUNT - 1]);
    all.filter(|i| *i < COUNT)
}

/// As they lie when components are side by side.
fn planes<const N: usize>(count: usize, element: impl Fn(usize) -> [f32; N]) -> Vec<f32> {
    let mut numbers = vec![0.0; N * count];
    for i in 0..count {
        for (c, number) in element(i).into_iter().enumerate() {
            numbers[c * count + i] = number;
        }
    }
    numbers
}

fn plane_view(numbers: &[f32], count: usize) -> ConstView {
    ConstView {
        data: numbers.as_ptr(),
        element_stride: 4,
        component_stride: 4 * count as isize,
    }
}

fn plane_target<T>(numbers: &mut [T], count: usize) -> View<T> {
    View {
        data: numbers.as_mut_ptr(),
        element_stride: 4,
        component_stride: 4 * count as isize,
    }
}

fn bits(numbers: [f32; 3]) -> [u32; 3] {
    numbers.map(f32::to_bits)
}

/// First element and count of every piece.
fn pieces() -> impl Iterator<Item = (usize, usize)> {
    (0..COUNT)
        .step_by(PIECE)
        .map(|first| (first, PIECE.min(COUNT - first)))
}

/// Whether components of elements from `first` on are those of the piece.
fn is_piece(all: &[f32], piece: &[f32], first: usize, count: usize) -> bool {
    let same = |(a, b): (&f32, &f32)| a.to_bits() == b.to_bits();
    (0..piece.len() / count).all(|c| {
        let whole = &all[c * COUNT + first..][..count];
        whole.iter().zip(&piece[c * count..][..count]).all(same)
    })
}

/// Values and densities of planes, of `count` elements from `first` on.
fn evaluated(bsdf: &Bsdf, first: usize, count: usize) -> (Vec<f32>, Vec<f32>) {
    let wo = planes(count, |i| direction(first + i, 0).to_array());
    let wi = planes(count, |i| direction(first + i, 3).to_array());
    let (mut value, mut pdf) = (vec![f32::NAN; 3 * count], vec![f32::NAN; count]);
    let args = EvalArgs {
        count,
        wo: plane_view(&wo, count),
        wi: plane_view(&wi, count),
        varying: &[],
        value: plane_target(&mut value, count),
        pdf: plane_target(&mut pdf, count),
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { eval(bsdf, &args, Level::chosen()) }.unwrap();
    (value, pdf)
}

#[test]
fn ten_million_values() {
    let bsdf = Bsdf::<f32>::new(&Description::new("microfacet")).unwrap();
    let (value, pdf) = evaluated(&bsdf, 0, COUNT);
    for (first, count) in pieces() {
        let (piece_value, piece_pdf) = evaluated(&bsdf, first, count);
        assert!(
            is_piece(&value, &piece_value, first, count),
            "from {first} on"
        );
        assert!(is_piece(&pdf, &piece_pdf, first, count), "from {first} on");
    }
    for i in checked() {
        let single = bsdf.eval_pdf(direction(i, 0), direction(i, 3), None);
        let found = [0, 1, 2].map(|c| value[c * COUNT + i]);
        assert_eq!(bits(found), bits(single.0), "{i}");
        assert_eq!(pdf[i].to_bits(), single.1.to_bits(), "{i}");
    }
}

/// Directions where the uniform numbers were and weights where the viewers were, element by element, and
/// the varying reflectance the same for all: what has to be copied.
fn sampled(bsdf: &Bsdf, first: usize, count: usize) -> [Vec<Vec3>; 2] {
    let mut wo: Vec<Vec3> = (0..count).map(|i| direction(first + i, 0)).collect();
    let mut u: Vec<Vec3> = (0..count).map(|i| uniform(first + i)).collect();
    let [wo_view, u_view]: [View; 2] = [&mut wo, &mut u].map(|vectors| View {
        data: vectors.as_mut_ptr().cast(),
        element_stride: size_of::<Vec3>() as isize,
        component_stride: 4,
    });
    let const_view = |view: View| ConstView {
        data: view.data,
        element_stride: view.element_stride,
        component_stride: view.component_stride,
    };
    let not_wanted = View {
        data: std::ptr::null_mut(),
        ..u_view
    };
    let not_wanted_integers = View::<u32> {
        data: std::ptr::null_mut(),
        element_stride: 0,
        component_stride: 0,
    };
    let args = SampleArgs {
        count,
        wo: const_view(wo_view),
        u: const_view(u_view),
        varying: &[ConstView {
            data: REFLECTANCE.as_ptr(),
            element_stride: 0,
            component_stride: 4,
        }],
        wi: u_view,
        pdf: not_wanted,
        weight: wo_view,
        eta: not_wanted,
        flags: not_wanted_integers,
        lobe: not_wanted_integers,
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { sample(bsdf, &args, Level::chosen()) }.unwrap();
    [u, wo]
}

const REFLECTANCE: [f32; 3] = [0.2, 0.4, 0.8];

#[test]
fn ten_million_samples() {
    let description = Description::new("disney_diffuse").vary("reflectance", 0.0, 1.0);
    let bsdf = Bsdf::<f32>::new(&description).unwrap();
    let [wi, weight] = sampled(&bsdf, 0, COUNT);
    let same = |a: &Vec3, b: &Vec3| bits(a.to_array()) == bits(b.to_array());
    for (first, count) in pieces() {
        let [piece_wi, piece_weight] = sampled(&bsdf, first, count);
        for (all, piece) in [(&wi, &piece_wi), (&weight, &piece_weight)] {
            let mut pairs = all[first..].iter().zip(piece);
            assert!(pairs.all(|(a, b)| same(a, b)), "from {first} on");
        }
    }
    for i in checked() {
        let single = bsdf.sample(direction(i, 0), uniform(i), Some(&REFLECTANCE));
        assert!(same(&wi[i], &single.wi), "{i}");
        assert!(same(&weight[i], &single.weight.into()), "{i}");
    }
}

#[test]
fn ten_million_reflectances() {
    let film = compiled(&bare(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [0.0, 600.0]));
    let evaluated = |first: usize, count: usize| {
        let cos_theta: Vec<f32> = (first..first + count).map(|i| number(i, 0)).collect();
        let thickness_nm = (first..first + count).map(|i| 600.0 * number(i, 1));
        let thickness_nm: Vec<f32> = thickness_nm.collect();
        let mut reflectance = vec![f32::NAN; 3 * count];
        let args = FilmArgs {
            count,
            cos_theta: plane_view(&cos_theta, count),
            thickness_nm: plane_view(&thickness_nm, count),
            reflectance: plane_target(&mut reflectance, count),
        };
        // SAFETY: all views are of arrays of `count` elements.
        unsafe { film_reflectance(&film, &args, Level::chosen()) }.unwrap();
        reflectance
    };
    let reflectance = evaluated(0, COUNT);
    for (first, count) in pieces() {
        let piece = evaluated(first, count);
        assert!(
            is_piece(&reflectance, &piece, first, count),
            "from {first} on"
        );
    }
    for i in checked() {
        let single = film.reflectance(number(i, 0), 600.0 * number(i, 1));
        let found = [0, 1, 2].map(|c| reflectance[c * COUNT + i]);
        assert_eq!(bits(found), bits(single), "{i}");
    }
}
