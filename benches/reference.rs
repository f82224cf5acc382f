//! Time per converged colour of the wave-optics reference, over angles down to grazing: what an exact
//! answer costs, and what every approximation is to be compared with.

use criterion::{Criterion, criterion_group, criterion_main};
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};
use std::hint::black_box;
use std::time::Duration;

fn constant(eta: f64) -> Medium {
    Medium::rgb([eta; 3], [0.0; 3]).unwrap()
}

fn named(name: &str) -> Medium {
    Medium::named(name).unwrap()
}

fn bench(criterion: &mut Criterion) {
    let five = [1.46, 2.35, 1.46, 2.35, 1.46].map(constant).to_vec();
    let soap = vec![constant(1.33)];
    let cases = [
        ("bare gold", vec![], named("Au"), vec![]),
        ("300 nm soap", soap.clone(), constant(1.0), vec![300.0]),
        (
            "300 nm silica on silicon",
            vec![named("SiO2")],
            named("Si"),
            vec![300.0],
        ),
        (
            "5 layers, 3 um, on glass",
            five.clone(),
            constant(1.5),
            vec![600.0; 5],
        ),
        ("5 layers, 3 um, on gold", five, named("Au"), vec![600.0; 5]),
        (
            "30 um titania on titanium",
            vec![named("TiO2")],
            named("Ti"),
            vec![3e4],
        ),
        ("100 um soap", soap, constant(1.0), vec![1e5]),
    ];
    let mut group = criterion.benchmark_group("reference");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(1));
    group.warm_up_time(Duration::from_millis(300));
    for (name, layers, base, thickness_nm) in cases {
        let (white, space) = (White::E, ColorSpace::Rec709);
        let reference = Reference::new(Medium::vacuum(), layers, base, white, space).unwrap();
        let mut call = 0;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                // 61 and 97 are coprime: all angles come in turn, none beside its neighbour.
                call = (call + 61) % 97;
                let cos_theta = f64::from(call) / 97.0 + 0.003;
                black_box(reference.evaluate(Side::Ambient, cos_theta, &thickness_nm))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
