//! Batches at every level of instructions that this processor has: equal to the single calls bit for
//! bit, over the whole registry, whatever the numbers.

#![allow(unsafe_code)] // batches go by addresses

mod common;

use common::{Drawn, combinations, hemisphere, rng, uniforms};
use glam::Vec3;
use pellicle::batch::{ConstView, EvalArgs, SampleArgs, View, eval, sample};
use pellicle::bsdf::{ParamKind, RegisteredModel, models};
use pellicle::num::Level;
use pellicle::{Bsdf, Description};
use rand::{Rng, RngExt};

/// More than two chunks, and a rest that no lanes divide.
const COUNT: usize = 2 * 256 + 16 + 5;

/// Components side by side, one after another: what batches read and write where it lies.
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
        ConstView {
            data: self.numbers.as_ptr(),
            element_stride: 4,
            component_stride: 4 * COUNT as isize,
        }
    }
}

/// A direction; now and then one that is none, or hard.
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
        9 => w * 1.0004,
        10 => Vec3::new(f32::MAX, 0.0, 0.1),
        _ => w,
    }
}

/// Three uniform numbers; now and then some that are not.
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

/// A number of a varying parameter; now and then outside of its range, or none.
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

/// Wherever one more parameter may vary, with its range.
fn varied(entry: &RegisteredModel, drawn: &Drawn) -> Vec<(Description, Vec<[f32; 2]>)> {
    let mut all = vec![(drawn.description.clone(), vec![])];
    for (index, param) in entry.info.params.iter().enumerate() {
        if !param.can_vary {
            continue;
        }
        let range = match param.kind {
            ParamKind::Number { min, max, .. } => [min, max],
            _ => [0.0, 0.0],
        };
        let own = if entry.info.film_thickness == Some(index) {
            [100.0, 200.0]
        } else {
            range
        };
        let description = drawn.description.clone().vary(param.name(), own[0], own[1]);
        if Bsdf::<f32>::new(&description).is_ok() {
            let ranges = vec![if own == [0.0; 2] { [-0.5, 1.0] } else { own }; param.components()];
            all.push((description, ranges));
        }
    }
    all
}

struct Batch {
    wo: Vec<Vec3>,
    other: Vec<Vec3>,
    varying: Vec<Vec<f32>>,
}

impl Batch {
    fn drawn(ranges: &[[f32; 2]], is_sampled: bool, rng: &mut impl Rng) -> Self {
        let mut varying = Vec::new();
        for _ in 0..COUNT {
            varying.push(
                ranges
                    .iter()
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

    /// Their numbers, each component in a plane.
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

fn check_eval(description: &Description, ranges: &[[f32; 2]], seed: u64) {
    let bsdf = Bsdf::<f32>::new(description).unwrap();
    let batch = Batch::drawn(ranges, false, &mut rng(seed));
    let (wo, wi, varying) = (
        Planes::of(&batch.wo),
        Planes::of(&batch.other),
        batch.planes(),
    );
    let views = [varying.const_view()];
    for level in Level::all() {
        for with_pdf in [false, true] {
            let mut value = Planes::new(3, |_, _| f32::NAN);
            let mut pdf = Planes::new(1, |_, _| f32::NAN);
            let mut pdf_view = pdf.view();
            if !with_pdf {
                pdf_view.data = std::ptr::null_mut();
            }
            let args = EvalArgs {
                count: COUNT,
                wo: wo.const_view(),
                wi: wi.const_view(),
                varying: if ranges.is_empty() { &[] } else { &views },
                value: value.view(),
                pdf: pdf_view,
            };
            // SAFETY: all views are of arrays of COUNT elements.
            unsafe { eval(&bsdf, &args, level) }.unwrap();
            for i in 0..COUNT {
                let single = bsdf.eval_pdf(batch.wo[i], batch.other[i], batch.of(i));
                let what = format!(
                    "{} {description:?} {:?} {:?} {:?}",
                    level.name(),
                    batch.wo[i],
                    batch.other[i],
                    batch.varying[i]
                );
                assert_eq!(bits(value.get(i)), bits(single.0), "{what} {:?}", single.0);
                if with_pdf {
                    assert_eq!(bits(pdf.get(i)), bits([single.1]), "{what} {}", single.1);
                }
            }
        }
    }
}

fn check_sample(description: &Description, ranges: &[[f32; 2]], seed: u64) {
    let bsdf = Bsdf::<f32>::new(description).unwrap();
    let batch = Batch::drawn(ranges, true, &mut rng(seed));
    let (wo, u, varying) = (
        Planes::of(&batch.wo),
        Planes::of(&batch.other),
        batch.planes(),
    );
    let views = [varying.const_view()];
    for level in Level::all() {
        let [mut wi, mut weight] = [(); 2].map(|()| Planes::new(3, |_, _| f32::NAN));
        let [mut pdf, mut eta] = [(); 2].map(|()| Planes::new(1, |_, _| f32::NAN));
        let [mut flags, mut lobe] = [(); 2].map(|()| Planes::new(1, |_, _| u32::MAX));
        let args = SampleArgs {
            count: COUNT,
            wo: wo.const_view(),
            u: u.const_view(),
            varying: if ranges.is_empty() { &[] } else { &views },
            wi: wi.view(),
            pdf: pdf.view(),
            weight: weight.view(),
            eta: eta.view(),
            flags: flags.view(),
            lobe: lobe.view(),
        };
        // SAFETY: all views are of arrays of COUNT elements.
        unsafe { sample(&bsdf, &args, level) }.unwrap();
        for i in 0..COUNT {
            let single = bsdf.sample(batch.wo[i], batch.other[i], batch.of(i));
            let what = format!("{} {description:?} {single:?}", level.name());
            assert_eq!(bits(wi.get(i)), bits(single.wi.to_array()), "{what}");
            assert_eq!(bits(weight.get(i)), bits(single.weight), "{what}");
            let found = [pdf.get::<1>(i)[0], eta.get::<1>(i)[0]];
            assert_eq!(bits(found), bits([single.pdf, single.eta]), "{what}");
            let found = [flags.get::<1>(i)[0], lobe.get::<1>(i)[0]];
            assert_eq!(found, [single.flags.0, single.lobe as u32], "{what}");
        }
    }
}

fn for_every_model(check: impl Fn(&Description, &[[f32; 2]], u64)) {
    let mut count = 0;
    for entry in models() {
        for seed in 0..combinations(entry) {
            let drawn = Drawn::new(entry, seed);
            for (description, ranges) in varied(entry, &drawn) {
                check(&description, &ranges, seed);
                count += 1;
            }
        }
    }
    assert!(count > 300, "only {count} descriptions");
}

#[test]
fn values_are_those_of_single_calls() {
    for_every_model(check_eval);
}

#[test]
fn samples_are_those_of_single_calls() {
    for_every_model(check_sample);
}

/// Descriptions with values that leave terms out or have shorter formulas, and what their plans say.
fn specialised() -> Vec<(Description, &'static str)> {
    const THREE: [f32; 3] = [1.4, 1.45, 1.6];
    const DEVIATED: [f32; 3] = [0.17, 0.0, 0.98];
    let layered = |eta: &[f32], base_normal: [f32; 3], exponents: [f32; 2]| {
        Description::new("layered")
            .set("eta", eta)
            .set("base_normal", &base_normal)
            .set("exponent_reflection", &exponents[..1])
            .set("exponent_transmission", &exponents[1..])
    };
    let real = || layered(&THREE, DEVIATED, [90.5, 170.5]);
    let gray = || layered(&[1.5], DEVIATED, [90.5, 170.5]);
    let microfacet = |fresnel| {
        Description::new("microfacet")
            .choose("fresnel", fresnel)
            .set("alpha", &[0.3])
    };
    let gold = || {
        microfacet("conductor")
            .set("eta", &[0.13, 0.4, 1.5])
            .set("k", &[4.1, 2.5, 1.9])
    };
    let of_gold = "isotropic, conductor by polynomials";
    vec![
        (real(), "all terms"),
        (gray(), "one index for all channels"),
        (
            gray().choose("variant", "paper"),
            "one index for all channels",
        ),
        (
            layered(&THREE, [0.0, 0.0, 1.0], [90.5, 170.5]),
            "parallel boundaries",
        ),
        (
            layered(&THREE, DEVIATED, [91.0, 170.5]),
            "exponent_reflection by products",
        ),
        (
            layered(&THREE, DEVIATED, [256.5, 256.0]),
            "exponent_transmission by products",
        ),
        (real().set("diffuse_weight", &[0.0]), "no diffuse part"),
        (real().set("specular_weight", &[0.0]), "no specular part"),
        (
            Description::new("phong").set("exponent", &[1.0]),
            "exponent by products",
        ),
        (microfacet("schlick"), "isotropic"),
        (
            microfacet("dielectric").set("eta", &[1.5]),
            "isotropic, one index for all channels",
        ),
        (gold(), of_gold),
        (gold().set("anisotropy", &[0.5]), "conductor by polynomials"),
        (gold().choose("masking", "kelemen"), of_gold),
        (gold().choose("distribution", "beckmann"), of_gold),
        (
            microfacet("conductor").set("k", &[0.01]).set("eta", &[0.6]),
            "isotropic",
        ),
    ]
}

#[test]
fn what_is_specialised_is_told_and_equal_to_single_calls() {
    for (number, (description, plan)) in specialised().into_iter().enumerate() {
        let bsdf = Bsdf::<f32>::new(&description).unwrap();
        let found = bsdf.plan();
        let (terms, batches) = found.split_once("; batches by ").unwrap();
        assert_eq!(terms, plan, "{description:?}");
        assert_eq!(batches, Level::chosen().name(), "{description:?}");
        check_eval(&description, &[], number as u64);
        check_sample(&description, &[], number as u64);
    }
}

/// Values of a specialised surface are those of the double-precision instance, which takes the long way for
/// conductors; its worst error is that of a power of 256 factors.
#[test]
fn what_is_specialised_keeps_its_digits() {
    for (number, (description, plan)) in specialised().into_iter().enumerate() {
        let single = Bsdf::<f32>::new(&description).unwrap();
        let double = Bsdf::<f64>::new(&description).unwrap();
        let mut rng = rng(number as u64);
        for _ in 0..20_000 {
            let wo = hemisphere(&mut rng).as_vec3();
            // Near the mirror direction, where the lobes are.
            let near = hemisphere(&mut rng).as_vec3() * rng.random_range(0.0..0.5);
            let wi = (Vec3::new(-wo.x, -wo.y, wo.z) + near).normalize();
            let found = single.eval(wo, wi, None);
            let exact = double.eval(wo.as_dvec3(), wi.as_dvec3(), None);
            for channel in 0..3 {
                let error = (f64::from(found[channel]) - exact[channel]).abs();
                let allowed = 5e-5 * exact[channel] + 1e-6;
                assert!(error <= allowed, "{plan}: {wo} {wi}: {found:?} {exact:?}");
            }
        }
    }
}

/// On x86-64 processors from the last ten years there is more than the baseline to test.
#[test]
fn levels_have_names() {
    let names: Vec<_> = Level::all().iter().map(|level| level.name()).collect();
    println!("{names:?}");
    assert!(!names.is_empty());
    assert!(cfg!(not(target_arch = "x86_64")) || names[0] == "sse2");
}
