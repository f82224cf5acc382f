//! ns per colour of every film method in single precision, on a dielectric and on a metallic base, at
//! random cosines and thicknesses to 1 um. The baseline, the converged reference, is in `reference.rs`;
//! the errors of the same methods are printed by `cargo test --release --test films accuracy -- --nocapture`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use pellicle::film::{OneLayer, OneLayerMethod};
use pellicle::optics::{ColorSpace, Medium, White};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::hint::black_box;
use std::time::Duration;

const POINTS: usize = 1 << 14;

fn layer(base_k: f64) -> OneLayer {
    let medium = |eta: f64, k: f64| Medium::rgb([eta; 3], [k; 3]).unwrap();
    let (film, base) = (medium(1.5, 0.0), medium(1.33, base_k));
    OneLayer::new(Medium::vacuum(), film, base, White::E, ColorSpace::Rec709).unwrap()
}

fn bench(criterion: &mut Criterion) {
    let mut rng = Pcg64Mcg::seed_from_u64(11);
    let points: Vec<[f32; 2]> = (0..POINTS)
        .map(|_| [rng.random(), rng.random_range(0.0..1000.0)])
        .collect();
    for (name, base_k) in [("film on dielectric", 0.0), ("film on metal", 3.0)] {
        let layer = layer(base_k);
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(POINTS as u64));
        group
            .sample_size(10)
            .measurement_time(Duration::from_millis(500));
        group.warm_up_time(Duration::from_millis(100));
        for kind in OneLayerMethod::ALL {
            let method = kind.single(&layer).unwrap();
            let id = BenchmarkId::from_parameter(format!("{kind:?}"));
            group.bench_function(id, |bencher| {
                bencher.iter(|| {
                    for [cos_theta, thickness_nm] in &points {
                        black_box(method.reflectance(*cos_theta, *thickness_nm));
                    }
                });
            });
        }
        group.finish();
    }
}

criterion_group!(benches, bench);
criterion_main!(benches);
