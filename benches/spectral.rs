//! Spectral calls through the C interface: value and density at 4 and at 16 wavelengths, beside the RGB call.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use pellicle::capi::*;
use pellicle::film::{Film, FilmDescription};
use pellicle::{Bsdf, Description, Medium};
use std::hint::black_box;
use std::ptr::null;
use std::sync::Arc;

/// Pairs of directions.
const PAIRS: usize = 512;

fn subjects() -> [(&'static str, Description); 6] {
    let titania = Medium::named("TiO2").expect("a known name");
    let oxide = FilmDescription::new(Medium::named("Ti").expect("a known name"));
    let film = Arc::new(Film::new(&oxide.layer(titania, [0.0, 400.0])).expect("a valid film"));
    let ggx = || Description::new("microfacet").set("alpha", &[0.2]);
    [
        ("lambert", Description::new("lambert")),
        ("layered", Description::new("layered")),
        ("metallic_roughness", Description::new("metallic_roughness")),
        ("ggx schlick", ggx()),
        (
            "ggx gold",
            ggx().choose("fresnel", "conductor").choose("metal", "Au"),
        ),
        (
            "ggx oxide",
            ggx()
                .choose("fresnel", "film")
                .set("thickness_nm", &[200.0])
                .film(film),
        ),
    ]
}

fn directions() -> Vec<[[f32; 3]; 2]> {
    let mut part = 0.0f32;
    let mut next = || {
        part = (part + 0.618_034).fract();
        let (z, phi) = (0.05 + 0.95 * part, 40.0 * part);
        let r = (1.0 - z * z).sqrt();
        [r * phi.cos(), r * phi.sin(), z]
    };
    (0..PAIRS).map(|_| [next(), next()]).collect()
}

fn bench(criterion: &mut Criterion) {
    let pairs = directions();
    let lambda_nm: Vec<f32> = (0..16).map(|i| 400.0 + 20.0 * i as f32).collect();
    for (name, description) in subjects() {
        let bsdf: Bsdf = Bsdf::new(&description).expect("a valid description");
        let handle = bsdf_handle(bsdf);
        let mut group = criterion.benchmark_group(name);
        for count in [0, 4, 16] {
            let mut at = 0;
            group.bench_function(BenchmarkId::from_parameter(count), |bencher| {
                bencher.iter(|| {
                    at = (at + 1) % PAIRS;
                    let [wo, wi] = &pairs[at];
                    let (mut value, mut pdf) = ([0.0; 16], [0.0; 16]);
                    let (value, pdf) = (value.as_mut_ptr(), pdf.as_mut_ptr());
                    // SAFETY: the handle lives, and the arrays are as long as the calls ask.
                    let status = unsafe {
                        if count == 0 {
                            let none = std::ptr::null_mut();
                            pellicle_bsdf_eval(
                                handle,
                                wo.as_ptr(),
                                wi.as_ptr(),
                                null(),
                                null(),
                                value,
                                pdf,
                                none,
                            )
                        } else {
                            let nm = lambda_nm.as_ptr();
                            pellicle_bsdf_eval_spectral(
                                handle,
                                wo.as_ptr(),
                                wi.as_ptr(),
                                null(),
                                null(),
                                nm,
                                count,
                                value,
                                pdf,
                            )
                        }
                    };
                    black_box((status, value, pdf))
                });
            });
        }
        group.finish();
        // SAFETY: the handle is not used any more.
        unsafe { pellicle_bsdf_release(handle) };
    }
}

criterion_group!(spectral, bench);
criterion_main!(spectral);
