//! Two ways to evaluate a formula for many elements at once, for the choice in `docs/decisions.md`: the
//! library's lanes over `fearless_simd`, and a loop over single numbers in a function that is compiled for
//! the same instructions, where the compiler finds the vectors. Both take the same source, at every level
//! that the processor has, and must find the same bits. Random directions, in cache.

#![allow(unsafe_code)] // Functions compiled for instructions which not every processor has.
#![cfg_attr(not(target_arch = "x86_64"), allow(unused_variables))]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pellicle::num::{Lane, Level, Real, TableEntry, Vec3, Work};
use pellicle::optics::schlick;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::FRAC_1_PI;
use std::hint::black_box;
use std::time::Duration;

const COUNT: usize = 1 << 12;

/// Numbers by component: wo and wi, or a colour.
type Columns<const N: usize> = [[f32; COUNT]; N];

/// A BSDF's value, three channels.
trait Formula {
    fn value<T: Lane<Scalar = f32>>(&self, wo: Vec3<T>, wi: Vec3<T>) -> [T; 3];
}

/// GGX at alpha = 0.3 with Smith's masking and Schlick's Fresnel factor: roots and quotients.
struct Microfacet;

impl Formula for Microfacet {
    #[inline(always)]
    fn value<T: Lane<Scalar = f32>>(&self, wo: Vec3<T>, wi: Vec3<T>) -> [T; 3] {
        let (factor, cosine) = facets(wo, wi);
        [
            factor * schlick(T::new(1.0), cosine),
            factor * schlick(T::new(0.71), cosine),
            factor * schlick(T::new(0.29), cosine),
        ]
    }
}

/// The same with the Fresnel factor from a table over the cosine: quadratic splines, as films have them.
struct TableMicrofacet(Vec<TableEntry<f32>>);

impl Formula for TableMicrofacet {
    #[inline(always)]
    fn value<T: Lane<Scalar = f32>>(&self, wo: Vec3<T>, wi: Vec3<T>) -> [T; 3] {
        let (half, one) = (T::new(0.5), T::new(1.0));
        let (factor, cosine) = facets(wo, wi);
        let intervals = (self.0.len() - 2) as f64;
        let place = cosine.max(T::new(0.0)).min(one) * T::new(intervals);
        let first = (place - half).round().max(T::new(0.0));
        let first = first.min(T::new(intervals - 1.0));
        let t = place - first;
        let [last, start] = [half * t.squared(), half * (one - t).squared()];
        let fresnel = T::weighted_row(&self.0, first, [start, half + t * (one - t), last]);
        let [r, g, b] = T::channels(fresnel);
        [factor * r, factor * g, factor * b]
    }
}

const ALPHA_SQUARED: f64 = 0.09;

/// All but F: Walter et al. 2007, eq. 20, 33 and 34; and <wo, h>.
#[inline(always)]
fn facets<T: Real>(wo: Vec3<T>, wi: Vec3<T>) -> (T, T) {
    let h = wo.plus(wi).normalized();
    let slope = T::new(1.0) + T::new(ALPHA_SQUARED - 1.0) * h.z.squared();
    let density = T::new(ALPHA_SQUARED * FRAC_1_PI) / slope.squared();
    let masked = T::new(0.5) / (wo.z * length(wi) + wi.z * length(wo));
    (density * masked * wi.z, wo.dot(h))
}

#[inline(always)]
fn length<T: Real>(w: Vec3<T>) -> T {
    (T::new(ALPHA_SQUARED) + T::new(1.0 - ALPHA_SQUARED) * w.z.squared()).sqrt()
}

/// Granier and Heidrich 2002, eq. 5 to 10, for parallel boundaries, with the lobe of the lower one outside
/// the layer: a logarithm, exponentials and cosines.
struct Layered;

impl Formula for Layered {
    #[inline(always)]
    fn value<T: Lane<Scalar = f32>>(&self, wo: Vec3<T>, wi: Vec3<T>) -> [T; 3] {
        let complement = wo.minus(wi.mirrored()).length_squared() * T::new(0.5);
        let lobes = [power(complement, 90.0), power(complement, 40.0)];
        [
            interference(wi, lobes, 1.4, 645.0),
            interference(wi, lobes, 1.45, 525.0),
            interference(wi, lobes, 1.6, 445.0),
        ]
    }
}

#[inline(always)]
fn power<T: Real>(complement: T, exponent: f64) -> T {
    let power = (T::new(exponent) * (-complement).ln_1p()).exp();
    T::select(complement.lt(T::new(1.0)), power, T::new(0.0))
}

#[inline(always)]
fn interference<T: Real>(wi: Vec3<T>, lobes: [T; 2], eta: f64, wavelength_nm: f64) -> T {
    let one = T::new(1.0);
    let fresnel = schlick(T::new(((eta - 1.0) / (eta + 1.0)).powi(2)), wi.z);
    let (r, t) = (fresnel * lobes[0], (one - fresnel) * lobes[1]);
    let inside = (one - (one - wi.z.squared()) * T::new(1.0 / (eta * eta))).sqrt();
    let turns = T::new(2.0 * eta * 300.0 / wavelength_nm) * inside;
    (T::new(0.5) * (r + t) + turns.cos_turns() * (r * t).sqrt()) * wi.z
}

/// A formula at all directions. Input and output are arguments of their own, so that the compiler knows
/// them to be apart.
#[inline(always)]
fn evaluate<F: Formula, L: Lane<Scalar = f32>>(f: &F, input: &Columns<6>, out: &mut Columns<3>) {
    for from in (0..COUNT).step_by(L::COUNT) {
        let [wo, wi] = [vector::<L>(&input[..3], from), vector(&input[3..], from)];
        let [r, g, b] = f.value(wo, wi);
        r.store(&mut out[0][from..from + L::COUNT]);
        g.store(&mut out[1][from..from + L::COUNT]);
        b.store(&mut out[2][from..from + L::COUNT]);
    }
}

#[inline(always)]
fn vector<L: Lane<Scalar = f32>>(columns: &[[f32; COUNT]], from: usize) -> Vec3<L> {
    let x = L::load(&columns[0][from..from + L::COUNT]);
    let y = L::load(&columns[1][from..from + L::COUNT]);
    Vec3::new(x, y, L::load(&columns[2][from..from + L::COUNT]))
}

struct Lanes<'a, F>(&'a F, &'a Columns<6>, &'a mut Columns<3>);

impl<F: Formula> Work<f32> for Lanes<'_, F> {
    type Output = ();
    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) {
        evaluate::<F, L>(self.0, self.1, self.2);
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt")]
fn loop_avx2<F: Formula>(f: &F, input: &Columns<6>, out: &mut Columns<3>) {
    evaluate::<F, f32>(f, input, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl,fma,bmi1,bmi2,lzcnt")]
fn loop_avx512<F: Formula>(f: &F, input: &Columns<6>, out: &mut Columns<3>) {
    evaluate::<F, f32>(f, input, out);
}

/// The loop over single numbers.
fn in_loop<F: Formula>(level: Level, f: &F, input: &Columns<6>, out: &mut Columns<3>) {
    match level.name() {
        // SAFETY: the level is one of the processor's.
        #[cfg(target_arch = "x86_64")]
        "avx512" => unsafe { loop_avx512(f, input, out) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        "avx2" => unsafe { loop_avx2(f, input, out) },
        _ => evaluate::<F, f32>(f, input, out),
    }
}

fn bench_formula<F: Formula>(criterion: &mut Criterion, name: &str, formula: &F) {
    let input = &directions();
    let mut found = [[0.0; COUNT]; 3];
    evaluate::<F, f32>(formula, input, &mut found);
    let bits = |found: &Columns<3>| found.map(|channel| channel.map(f32::to_bits));
    let expected = bits(&found);
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(COUNT as u64));
    group
        .sample_size(20)
        .measurement_time(Duration::from_millis(500));
    group.warm_up_time(Duration::from_millis(100));
    for level in Level::all() {
        let mut measure = |way: &str, run: &dyn Fn(&mut Columns<3>)| {
            run(&mut found);
            let name = format!("{way} {}", level.name());
            assert!(bits(&found) == expected, "{name}: other bits");
            group.bench_function(name, |bencher| {
                bencher.iter(|| run(black_box(&mut found)));
            });
        };
        measure("lanes", &|found| {
            level.run(Lanes(formula, black_box(input), found))
        });
        measure("loop", &|found| {
            in_loop(level, formula, black_box(input), found)
        });
    }
    group.finish();
}

/// Random, above the surface.
fn directions() -> Columns<6> {
    let mut rng = Pcg64Mcg::seed_from_u64(5);
    let mut columns = [[0.0; COUNT]; 6];
    for [x, y, z] in columns.as_chunks_mut().0 {
        for i in 0..COUNT {
            z[i] = rng.random_range(0.01..1.0f32);
            let (sine, cosine) = rng.random_range(0.0..std::f32::consts::TAU).sin_cos();
            let radius = (1.0 - z[i] * z[i]).sqrt();
            [x[i], y[i]] = [radius * cosine, radius * sine];
        }
    }
    columns
}

fn bench(criterion: &mut Criterion) {
    let entry = |i| TableEntry::new([1.0, 0.71, 0.29].map(|f0| schlick(f0, i as f32 / 32.0)));
    let table = TableMicrofacet((0..34).map(entry).collect());
    bench_formula(criterion, "ggx", &Microfacet);
    bench_formula(criterion, "ggx, table", &table);
    bench_formula(criterion, "layered", &Layered);
}

criterion_group!(benches, bench);
criterion_main!(benches);
