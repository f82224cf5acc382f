//! The smooth `film` model: where light goes, and that it finds its way back.

use crate::common::calls::Calls;
use crate::common::films::{Kind, compiled, constant};
use crate::common::{degrees, rng, rounded, visible};
use crate::film_lobes::{
    REFLECTION, assert_near, bsdf, drawn, for_every_film, indices, lobes, on, transmitted,
};
use glam::{DVec3, Vec3};
use pellicle::Bsdf;
use pellicle::bsdf::Flags;
use pellicle::film::FilmDescription;
use pellicle::optics::stack::Side;

#[test]
fn reflection_mirrors() {
    for_every_film(8, |_, bsdf, _, _, rng| {
        let wo = visible(bsdf, rng).as_vec3();
        for (_, sample) in lobes(bsdf, wo) {
            if sample.lobe == REFLECTION {
                assert_eq!(sample.wi, Vec3::new(-wo.x, -wo.y, wo.z));
                assert_eq!(sample.eta, 1.0);
                assert_eq!(sample.flags, Flags::REFLECTION.with(Flags::DELTA));
            }
        }
    });
}

/// Snell: n_o sin_o = n_i sin_i, in one plane, on the other side.
#[test]
fn transmission_refracts() {
    let mut rng = rng(9);
    for kind in [Kind::Lens, Kind::Sunglasses, Kind::Prism] {
        let (description, film, _) = drawn(kind, &mut rng);
        let [ambient, base] = indices(&film);
        assert_ne!(ambient, base);
        let single: Bsdf = Bsdf::new(&description).unwrap();
        let double: Bsdf<f64> = Bsdf::new(&description).unwrap();
        for _ in 0..500 {
            let (wo, wo_double) = rounded(visible(&single, &mut rng));
            let (n_o, n_i) = if wo.z > 0.0 {
                (ambient, base)
            } else {
                (base, ambient)
            };
            let Some((_, sample)) = transmitted(&single, wo) else {
                continue;
            };
            let wi = sample.wi.as_dvec3();
            assert!((wi.length() - 1.0).abs() < 1e-6);
            assert!(wi.z * wo_double.z < 0.0);
            let sum = n_o * wo_double.truncate() + n_i * wi.truncate();
            assert!(sum.length() < 1e-6, "{wo} {sample:?}");
            assert_near(sample.eta, (n_i / n_o) as f32, 1e-6, "eta");
            assert_eq!(sample.flags, Flags::TRANSMISSION.with(Flags::DELTA));
            // The instance in double precision.
            let wo_double = wo_double.normalize();
            let (_, sample) = transmitted(&double, wo_double).unwrap();
            let sum = n_o * wo_double.truncate() + n_i * sample.wi.truncate();
            assert!(sum.length() < 1e-13, "{sum}");
            // Grazing angles magnify single precision's rounding.
            let distance = sample.wi.distance(wi);
            assert!(
                distance < 1e-6 / wi.z.abs().min(wo_double.z.abs()),
                "{distance}"
            );
        }
    }
}

/// Directions that are unit to 1e-3 only leave with unit length, out of the densest base too.
#[test]
fn refraction_gives_unit_directions() {
    let film = FilmDescription {
        transmittance: true,
        ..FilmDescription::new(constant(4.0, 0.0))
    };
    let bsdf: Bsdf = Bsdf::new(&on(&compiled(&film))).unwrap();
    for scale in [0.9992, 1.0, 1.0008] {
        for theta in [0.0, 5.0, 10.0, 14.0] {
            let wo = -scale * degrees(theta, 30.0).as_vec3();
            for (_, sample) in lobes(&bsdf, wo) {
                let length = sample.wi.as_dvec3().length();
                assert!((length - 1.0).abs() <= 1e-6, "{wo} {sample:?}");
            }
        }
    }
}

#[test]
fn beyond_the_critical_angle_all_is_reflected() {
    let film = Kind::Lens.film();
    let description = on(&film).set("thickness_nm", &[250.0]);
    let bsdf: Bsdf = Bsdf::new(&description).unwrap();
    let critical = (1.0_f64 / 1.5).asin().to_degrees();
    for beyond in [1e-3, 0.1, 5.0, 30.0, 48.0] {
        let wo = -degrees(critical + beyond, 20.0).as_vec3();
        let found = lobes(&bsdf, wo);
        assert_eq!(found.len(), 1, "{beyond}: {found:?}");
        let (probability, sample) = found[0];
        assert_eq!((probability, sample.lobe), (1.0, REFLECTION));
        for channel in sample.weight {
            assert!(channel > 0.99, "{beyond}: {sample:?}");
        }
        assert_eq!(bsdf.directional_albedo(wo, None), sample.weight);
    }
    for below in [1e-2, 1.0, 20.0] {
        let wo = -degrees(critical - below, 20.0).as_vec3();
        assert_eq!(lobes(&bsdf, wo).len(), 2, "{below}");
    }
}

/// The critical angle is that of the one wavelength, although a film may still transmit red.
#[test]
fn there_is_one_critical_angle() {
    let film = Kind::Prism.film();
    let description = on(&film).set("thickness_nm", &[100.0]);
    let bsdf: Bsdf = Bsdf::new(&description).unwrap();
    let [ambient, base] = indices(&film);
    let critical = (base / ambient).asin().to_degrees();
    let wo = degrees(critical + 0.05, 20.0).as_vec3();
    let own = film.colors(Side::Ambient, wo.z, 100.0).unwrap();
    assert!(own.transmittance[0] > 0.05, "{own:?}");
    let found = lobes(&bsdf, wo);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].0, found[0].1.lobe), (1.0, REFLECTION));
    assert_eq!(bsdf.directional_albedo(wo, None), own.reflectance);
    let wo = degrees(critical - 0.05, 20.0).as_vec3();
    assert_eq!(lobes(&bsdf, wo).len(), 2);
}

/// Equal media on both sides: directions pass bit for bit, from either side.
#[test]
fn a_bubble_does_not_turn_light() {
    let bubble = bsdf(Kind::Bubble, 10);
    let mut rng = rng(10);
    for _ in 0..200 {
        let wo = visible(&bubble, &mut rng).as_vec3();
        let grazing = DVec3::new(0.6, 0.8, 1e-25).as_vec3();
        for wo in [wo, grazing, -grazing] {
            let Some((_, sample)) = transmitted(&bubble, wo) else {
                // Where every film is a mirror there may be nothing left to transmit.
                assert!(wo.z.abs() < 1e-6, "{wo}");
                continue;
            };
            assert_eq!((sample.wi, sample.eta), (-wo, 1.0));
        }
    }
}

/// f(wo, wi) eta_i^2 == f(wi, wo) eta_o^2, which for Dirac lobes (f = T (eta_o / eta_i)^2 delta, and
/// eta^2 times projected solid angle is kept) says: light finds its way back, and T is the same.
#[test]
fn transmission_is_reciprocal() {
    for kind in [Kind::Lens, Kind::Bubble, Kind::Sunglasses, Kind::Prism] {
        let mut rng = rng(7);
        let mut worst: f64 = 0.0;
        for _ in 0..200 {
            let bsdf: Bsdf<f64> = Bsdf::new(&drawn(kind, &mut rng).0).unwrap();
            let wo = visible(&bsdf, &mut rng);
            let Some((p, there)) = transmitted(&bsdf, wo) else {
                continue;
            };
            let (q, back) = transmitted(&bsdf, there.wi).expect("a way back");
            assert!(back.wi.distance(wo) < 1e-12, "{wo} {back:?}");
            assert!((there.eta * back.eta - 1.0).abs() < 1e-12);
            for c in 0..3 {
                let forward = p * there.weight[c] * there.eta.powi(2);
                let backward = q * back.weight[c] * back.eta.powi(2);
                worst = worst.max((forward - backward).abs());
            }
        }
        println!("{kind:?}: T differs by {worst}");
        // The rounding of the cosine that the film is asked for: its error is the same both ways.
        assert!(worst < 1e-5, "{kind:?}: {worst}");
    }
}
