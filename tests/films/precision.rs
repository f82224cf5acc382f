//! The film methods in single precision against double.

use pellicle::film::{CompiledMethod, OneLayer, OneLayerMethod};
use pellicle::optics::{ColorSpace, Medium, White};

fn medium(eta: f64, k: f64) -> Medium {
    Medium::rgb([eta; 3], [k; 3]).unwrap()
}

fn layer(film: Medium, base: Medium) -> OneLayer {
    OneLayer::new(Medium::vacuum(), film, base, White::E, ColorSpace::Rec709).unwrap()
}

/// The phase of a film of 1000 nm is up to some 12 turns, known to 1e-6 turns in single precision;
/// resonances at grazing angles magnify that by 1 / (1 - |g|).
#[test]
fn single_precision_is_close_to_double() {
    let layers = [
        layer(medium(1.33, 0.0), medium(1.0, 0.0)),
        layer(medium(1.5, 0.0), medium(1.33, 0.0)),
        layer(medium(2.4, 0.0), medium(2.9, 3.1)),
        layer(medium(1.5, 0.1), medium(1.5, 3.0)),
        layer(medium(1.33, 1e-4), medium(1.0, 0.0)),
        layer(Medium::named("TiO2").unwrap(), Medium::named("Au").unwrap()),
        layer(Medium::named("Au").unwrap(), Medium::named("SiO2").unwrap()),
    ];
    for kind in OneLayerMethod::ALL {
        let mut greatest = [0.0f64; 2];
        for layer in &layers {
            let single: Box<dyn CompiledMethod<f32>> = kind.single(layer).unwrap();
            let double: Box<dyn CompiledMethod<f64>> = kind.double(layer).unwrap();
            for i in 0..100 * 40 {
                let d = (i / 40) as f32 / 99.0 * 1000.0;
                let c = ((i % 40) as f32 / 39.0).powi(2);
                let a = single.reflectance(c, d);
                let b = double.reflectance(f64::from(c), f64::from(d));
                let is_grazing = usize::from(c < 0.03);
                for (a, b) in a.iter().zip(b) {
                    let error = (f64::from(*a) - b).abs();
                    assert!(error < 1.0, "{kind:?} {c} {d} {a} {b}");
                    greatest[is_grazing] = greatest[is_grazing].max(error);
                }
            }
        }
        println!("{kind:?}: {greatest:?}");
        assert!(greatest[0] < 5e-5, "{kind:?}: {greatest:?}");
        assert!(greatest[1] < 1e-3, "{kind:?}: {greatest:?}");
    }
}
