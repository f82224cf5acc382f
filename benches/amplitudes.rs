//! Time of complex amplitudes through the C interface: a call with four wavelengths, by the number of layers and
//! the media, and a batch per element.

use criterion::{Criterion, criterion_group, criterion_main};
use pellicle::capi::*;
use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

const WAVELENGTHS: [f32; 4] = [430.0, 510.0, 590.0, 670.0];
const ELEMENTS: usize = 256;

fn constant(eta: f64) -> Medium {
    Medium::rgb([eta; 3], [0.0; 3]).unwrap()
}

fn named(name: &str) -> Medium {
    Medium::named(name).unwrap()
}

fn measured(count: u32) -> Medium {
    let nm: Vec<f64> = (0..count)
        .map(|i| 380.0 + 400.0 * f64::from(i) / f64::from(count))
        .collect();
    let eta: Vec<f64> = nm.iter().map(|nm| 1.4 + 1e4 / (nm * nm)).collect();
    Medium::table(&nm, &eta, &vec![0.0; nm.len()]).unwrap()
}

/// The first layer varies, the others are 80 nm thick.
fn film(layers: &[Medium], base: Medium) -> *mut PellicleFilm {
    let mut description = FilmDescription {
        method: Some("reference".into()),
        ..FilmDescription::new(base)
    };
    for (i, medium) in layers.iter().enumerate() {
        let range = if i == 0 { [0.0, 500.0] } else { [80.0; 2] };
        description = description.layer(medium.clone(), range);
    }
    film_handle(Arc::new(Film::new(&description).unwrap()), None).unwrap()
}

fn bench(criterion: &mut Criterion) {
    let repeated = |medium: &Medium, count| vec![medium.clone(); count];
    let cases = [
        ("constant, 0 layers", film(&[], constant(1.5))),
        ("constant, 1 layer", film(&[constant(1.33)], constant(1.5))),
        (
            "constant, 2 layers",
            film(&repeated(&constant(1.33), 2), constant(1.5)),
        ),
        (
            "constant, 9 layers",
            film(&repeated(&constant(1.33), 9), constant(1.5)),
        ),
        ("MgF2 on BK7", film(&[named("MgF2")], named("BK7"))),
        ("TiO2 on titanium", film(&[named("TiO2")], named("Ti"))),
        ("Fe2O3 on gold", film(&[named("Fe2O3")], named("Au"))),
        (
            "gold, 1 layer",
            film(&repeated(&named("Au"), 1), named("Au")),
        ),
        (
            "gold, 9 layers",
            film(&repeated(&named("Au"), 9), named("Au")),
        ),
        (
            "BK7, 9 layers",
            film(&repeated(&named("BK7"), 9), named("BK7")),
        ),
        (
            "8 different layers",
            film(
                &["Au", "TiO2", "Ag", "SiO2", "Al", "MgF2", "Cu", "Al2O3"].map(named),
                named("BK7"),
            ),
        ),
        (
            "81 measurements, 1 layer",
            film(&repeated(&measured(81), 1), measured(81)),
        ),
        (
            "81 measurements, 9 layers",
            film(&repeated(&measured(81), 9), measured(81)),
        ),
    ];
    let mut group = criterion.benchmark_group("amplitudes");
    group
        .sample_size(20)
        .measurement_time(Duration::from_millis(600));
    group.warm_up_time(Duration::from_millis(200));
    for (name, film) in cases {
        let mut found = [[0f32; 8]; 4];
        let mut call = 0;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                call = (call + 61) % 97;
                let at = call as f32 / 97.0;
                // SAFETY: a live handle, four wavelengths and four structs.
                let status = unsafe {
                    let found = found.as_mut_ptr().cast();
                    pellicle_film_amplitudes(
                        film,
                        at,
                        500.0 * at,
                        0,
                        WAVELENGTHS.as_ptr(),
                        4,
                        found,
                    )
                };
                assert_eq!(status, PELLICLE_OK);
                black_box(&found);
            });
        });
    }
    let film = film(&[named("MgF2")], named("BK7"));
    let cosines: Vec<f32> = (0..ELEMENTS).map(|i| (i * 61 % 97) as f32 / 97.0).collect();
    let mut found = vec![0f32; ELEMENTS * 32];
    let output = |quantity: usize, found: &mut [f32]| PellicleView {
        data: found[quantity * ELEMENTS * 8..].as_mut_ptr(),
        element_stride: 32,
        component_stride: 4,
    };
    group.bench_function("batch, MgF2 on BK7, 256 elements", |bencher| {
        bencher.iter(|| {
            let view = |data: &[f32], element_stride| PellicleConstView {
                data: data.as_ptr(),
                element_stride,
                component_stride: 4,
            };
            let args = PellicleAmplitudesBatchArgs {
                count: ELEMENTS,
                lambda_count: 4,
                lambda_nm: view(&WAVELENGTHS, 0),
                cos_theta: view(&cosines, 4),
                thickness_nm: view(&cosines, 4),
                r_s: output(0, &mut found),
                r_p: output(1, &mut found),
                t_s: output(2, &mut found),
                t_p: output(3, &mut found),
                side: PELLICLE_SIDE_AMBIENT,
            };
            // SAFETY: live handle; the views lie in the arrays above.
            let status = unsafe { pellicle_film_amplitudes_batch(film, &args, size_of_val(&args)) };
            assert_eq!(status, PELLICLE_OK);
            black_box(&found);
        });
    });
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
