//! ns per call of every model in single precision, through the Rust interface: the value alone,
//! value and density, a sample. The inputs are a million random pairs of directions, so that neither
//! caches nor branch predictors have seen them. The baseline, plain C++, is in `cpp_tests/bench`.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;
use pellicle::bsdf::{Values, models};
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use pellicle::{Bsdf, Call, Description};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

const INPUTS: usize = 1 << 20;
/// Pairs per timed iteration.
const CHUNK: usize = 1 << 14;

fn direction(rng: &mut Pcg64Mcg) -> Vec3 {
    let z: f32 = rng.random_range(0.01..1.0);
    let phi = rng.random_range(0.0..std::f32::consts::TAU);
    let radius = (1.0 - z * z).sqrt();
    Vec3::new(radius * phi.cos(), radius * phi.sin(), z)
}

/// Hands out the inputs chunk by chunk, round and round.
struct Inputs {
    pairs: Vec<(Vec3, Vec3)>,
    next: usize,
}

impl Inputs {
    fn new() -> Self {
        let mut rng = Pcg64Mcg::seed_from_u64(7);
        let pairs = (0..INPUTS)
            .map(|_| (direction(&mut rng), direction(&mut rng)))
            .collect();
        Self { pairs, next: 0 }
    }

    fn chunk(&mut self) -> Vec<(Vec3, Vec3)> {
        let start = self.next;
        self.next = (self.next + CHUNK) % INPUTS;
        self.pairs[start..start + CHUNK].to_vec()
    }
}

/// What models that need a film are measured with.
fn soap() -> Arc<Film> {
    let water = Medium::named("water").unwrap();
    let soap = FilmDescription::new(Medium::vacuum()).layer(water, [50.0, 900.0]);
    let soap = FilmDescription {
        transmittance: true,
        ..soap
    };
    Arc::new(Film::new(&soap).unwrap())
}

/// A texture's numbers, one parameter after another.
type Varying = Option<&'static [f32]>;

fn measure(criterion: &mut Criterion, inputs: &mut Inputs, name: &str, bsdf: &Bsdf, v: Varying) {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(CHUNK as u64));
    group
        .sample_size(20)
        .measurement_time(Duration::from_secs(1));
    group.warm_up_time(Duration::from_millis(300));
    let mut run = |name: &str, call: &dyn Fn(Vec3, Vec3)| {
        group.bench_function(name, |bencher| {
            bencher.iter_batched(
                || inputs.chunk(),
                |chunk| chunk.into_iter().for_each(|(wo, wi)| call(wo, wi)),
                BatchSize::LargeInput,
            );
        });
    };
    run("eval", &|wo, wi| {
        black_box(bsdf.eval(wo, wi, v, &Call::default()));
    });
    run("eval_pdf", &|wo, wi| {
        black_box(bsdf.eval_pdf(wo, wi, v, &Call::default()));
    });
    // A direction's components in [0, 1) do as uniform numbers here.
    run("sample", &|wo, wi| {
        black_box(bsdf.sample(
            wo,
            wi.abs().min(Vec3::splat(0.999_999)),
            v,
            &Call::default(),
        ));
    });
    group.finish();
}

fn bench(criterion: &mut Criterion) {
    let mut inputs = Inputs::new();
    for entry in models() {
        let mut description = Description::new(entry.name());
        if (entry.needs_film)(&Values::defaults(entry.info)) {
            description = description.film(soap()).set("thickness_nm", &[400.0]);
        }
        let bsdf = Bsdf::new(&description).unwrap();
        measure(criterion, &mut inputs, entry.name(), &bsdf, None);
    }
    for (name, description, varying) in variants() {
        let bsdf = Bsdf::new(&description).unwrap();
        measure(criterion, &mut inputs, name, &bsdf, varying);
    }
}

/// What the defaults do not show.
fn variants() -> Vec<(&'static str, Description, Varying)> {
    let metallic_roughness = || Description::new("metallic_roughness");
    let qualitative = Description::new("oren_nayar").choose("form", "qualitative");
    let textured = metallic_roughness()
        .vary("base_color", 0.0, 1.0)
        .vary("metallic", 0.0, 1.0)
        .vary("roughness", 0.0, 1.0);
    let by_form = |form, roughness| {
        metallic_roughness()
            .choose("diffuse_form", form)
            .set(roughness, &[0.5])
    };
    vec![
        ("oren_nayar qualitative", qualitative, None),
        (
            "metallic_roughness textured",
            textured,
            Some(&[0.8, 0.5, 0.2, 0.3, 0.4]),
        ),
        (
            "metallic_roughness oren_nayar",
            by_form("oren_nayar", "sigma_radians"),
            None,
        ),
        (
            "metallic_roughness disney",
            by_form("disney", "diffuse_roughness"),
            None,
        ),
    ]
}

/// The value alone of every combination of the `microfacet` model's factors.
fn bench_microfacets(criterion: &mut Criterion) {
    let mut inputs = Inputs::new();
    let mut group = criterion.benchmark_group("microfacet_eval");
    group.throughput(Throughput::Elements(CHUNK as u64));
    group
        .sample_size(10)
        .measurement_time(Duration::from_millis(300));
    group.warm_up_time(Duration::from_millis(100));
    let film = soap();
    for distribution in ["ggx", "beckmann", "blinn_phong", "abc", "sgd"] {
        for masking in ["smith", "schlick", "kelemen", "cook_torrance", "implicit"] {
            for fresnel in ["schlick", "dielectric", "conductor", "film"] {
                let mut description = Description::new("microfacet")
                    .choose("distribution", distribution)
                    .choose("masking", masking)
                    .choose("fresnel", fresnel);
                if fresnel == "film" {
                    description = description.film(Arc::clone(&film));
                    description = description.set("thickness_nm", &[400.0]);
                }
                let bsdf = Bsdf::<f32>::new(&description).unwrap();
                let name = format!("{distribution}/{masking}/{fresnel}");
                group.bench_function(name, |bencher| {
                    bencher.iter_batched(
                        || inputs.chunk(),
                        |chunk| {
                            for (wo, wi) in chunk {
                                black_box(bsdf.eval(wo, wi, None, &Call::default()));
                            }
                        },
                        BatchSize::LargeInput,
                    );
                });
            }
        }
    }
    group.finish();
}

criterion_group!(benches, bench, bench_microfacets);
criterion_main!(benches);
