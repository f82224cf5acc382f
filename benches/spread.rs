//! Colours averaged over a spread of thickness: one call at each deviation, and without one.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use std::hint::black_box;

/// Standard deviations, nm.
const DEVIATIONS_NM: [f32; 7] = [0.0, 1.0, 10.0, 20.0, 40.0, 80.0, 320.0];

fn films() -> [(&'static str, Film); 2] {
    let spread = |base: Medium, layer: Medium, range: [f64; 2]| {
        let description = FilmDescription {
            thickness_spread_max_nm: 400.0,
            ..FilmDescription::new(base).layer(layer, range)
        };
        Film::new(&description).expect("a valid film")
    };
    let water = Medium::rgb([1.33; 3], [0.0; 3]).expect("a valid index");
    let [titanium, titania] = ["Ti", "TiO2"].map(|name| Medium::named(name).expect("a known name"));
    [
        ("soap", spread(Medium::vacuum(), water, [0.0, 1000.0])),
        ("anodised titanium", spread(titanium, titania, [0.0, 300.0])),
    ]
}

fn calls(criterion: &mut Criterion) {
    for (name, film) in films() {
        let [least, greatest] = film
            .varying_thickness_nm()
            .expect("a thickness varies")
            .map(|nm| nm as f32);
        let mut group = criterion.benchmark_group(name);
        for deviation_nm in DEVIATIONS_NM {
            let id = BenchmarkId::from_parameter(deviation_nm);
            group.bench_function(id, |bencher| {
                let mut part = 0.0f32;
                bencher.iter(|| {
                    part = (part + 0.618_034).fract();
                    let thickness_nm = least + part * (greatest - least);
                    film.reflectance_spread(black_box(1.0 - part), thickness_nm, deviation_nm)
                });
            });
        }
        group.finish();
    }
}

criterion_group!(spread, calls);
criterion_main!(spread);
