//! Energy compensation of the `microfacet` model: the white furnace, and its colour against the series of
//! reflections, with albedos and means integrated here.

use super::rough::{DISTRIBUTIONS, MASKINGS, double, white};
use crate::common::calls::Calls;
use crate::common::films::{compiled, medium};
use crate::common::{degrees, rng, uniforms};
use glam::{DVec3, Vec3};
use pellicle::bsdf::Flags;
use pellicle::film::{Film, FilmDescription};
use pellicle::{Bsdf, Description, Status};
use std::sync::Arc;

fn compensated(description: &Description) -> Description {
    description.clone().choose("energy_compensation", "on")
}

const THETAS: [f64; 5] = [0.0, 30.0, 60.0, 75.0, 85.0];
const ALPHAS: [f32; 5] = [1e-3, 0.1, 0.4, 0.7, 1.0];

/// A white surface returns everything, to the error of the table of E. Where masking takes away too
/// little there is nothing to mend: the combination that the model declares not to conserve energy.
#[test]
fn white_surfaces_stay_white_in_a_white_furnace() {
    for distribution in DISTRIBUTIONS {
        for masking in MASKINGS {
            if masking == "implicit" || (distribution, masking) == ("abc", "schlick") {
                continue;
            }
            for alpha in ALPHAS {
                let surface = double(&compensated(&white(distribution, masking, alpha)));
                for theta in THETAS {
                    let albedo = surface.directional_albedo(degrees(theta, 0.0), None)[0];
                    let error = (albedo - 1.0).abs();
                    assert!(
                        error < 4e-3,
                        "{distribution} {masking} {alpha} {theta}: {albedo}"
                    );
                }
            }
        }
    }
}

/// The same with alpha given per call, for which the table has another dimension.
#[test]
fn varying_surfaces_stay_white_too() {
    for (distribution, bound) in [("ggx", 2e-3), ("beckmann", 6e-3)] {
        let description = Description::new("microfacet")
            .choose("distribution", distribution)
            .set("f0", &[1.0])
            .vary("alpha", 1e-4, 1.0);
        let surface = double(&compensated(&description));
        for alpha in [1e-4, 0.003, 0.05, 0.17, 0.33, 0.62, 0.9, 1.0] {
            for theta in THETAS {
                let albedo = surface.directional_albedo(degrees(theta, 0.0), Some(&[alpha]))[0];
                let error = (albedo - 1.0).abs();
                assert!(error < bound, "{distribution} {alpha} {theta}: {albedo}");
            }
        }
    }
}

/// The mean over the hemisphere of a function of the cosine, by midpoints.
fn mean(f: impl Fn(f64) -> [f64; 3]) -> [f64; 3] {
    const NODES: u32 = 200;
    let mut sum = [0.0; 3];
    for i in 0..NODES {
        let squared = (f64::from(i) + 0.5) / f64::from(NODES);
        let value = f(squared.sqrt());
        for c in 0..3 {
            sum[c] += value[c] / f64::from(NODES);
        }
    }
    sum
}

/// What is added has the albedo (1 - E(mu)) Favg^2 Eavg / (1 - Favg (1 - Eavg)).
fn assert_added(
    description: &Description,
    varying: Option<&[f64]>,
    reflectance: [f64; 3],
    alpha: f32,
) {
    let bare = white("ggx", "smith", alpha);
    let bare = double(&bare);
    let albedo = |cosine: f64| {
        let wo = DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
        bare.directional_albedo(wo, None)
    };
    let escaping = mean(albedo)[0];
    let [off, on] = [description.clone(), compensated(description)].map(|d| double(&d));
    for theta in [0.0, 50.0, 80.0] {
        let wo = degrees(theta, 0.0);
        let lost = 1.0 - albedo(wo.z)[0];
        let (off, on) = (
            off.directional_albedo(wo, varying),
            on.directional_albedo(wo, varying),
        );
        for c in 0..3 {
            let f = reflectance[c];
            let expected = lost * f * f * escaping / (1.0 - f * (1.0 - escaping));
            let added = on[c] - off[c];
            assert!(
                (added - expected).abs() < 2e-3,
                "{description:?} {theta}: {added}, not {expected}"
            );
        }
    }
}

#[test]
fn what_is_added_has_the_colour_of_further_reflections() {
    let alpha = 0.8f32;
    let rough = Description::new("microfacet").set("alpha", &[alpha]);
    // 2 integral mu (1 - mu)^5 dmu = 1 / 21.
    let schlick = rough.clone().set("f0", &[0.9, 0.6, 0.2]);
    let f0 = [0.9f32, 0.6, 0.2].map(f64::from);
    assert_added(&schlick, None, f0.map(|f0| f0 + (1.0 - f0) / 21.0), alpha);
    let clipped = |film: &Film, thickness: f64| {
        mean(|cosine| {
            film.reference(cosine, thickness)
                .map(|channel| channel.clamp(0.0, 1.0))
        })
    };
    let gold = Film::new(&FilmDescription::new(medium("Au"))).unwrap();
    let named = rough
        .clone()
        .choose("fresnel", "conductor")
        .choose("metal", "Au");
    assert_added(&named, None, clipped(&gold, 0.0), alpha);
    let film = FilmDescription::new(medium("Ti")).layer(medium("TiO2"), [20.0, 120.0]);
    let film = compiled(&film);
    let coated = rough.choose("fresnel", "film").film(Arc::clone(&film));
    for thickness in [20.0f32, 63.0, 120.0] {
        let expected = clipped(&film, f64::from(thickness));
        let fixed = coated.clone().set("thickness_nm", &[thickness]);
        assert_added(&fixed, None, expected, alpha);
        let varying = coated.clone().vary("thickness_nm", 20.0, 120.0);
        assert_added(&varying, Some(&[f64::from(thickness)]), expected, alpha);
    }
}

#[test]
fn there_is_a_lobe_more() {
    let description = compensated(&white("ggx", "smith", 0.8));
    let bsdf: Bsdf = Bsdf::new(&description).unwrap();
    let glossy = Flags::REFLECTION.with(Flags::GLOSSY);
    assert_eq!(bsdf.flags(), glossy.with(Flags::DIFFUSE));
    let mut rng = rng(8);
    let mut seen = [0; 2];
    for _ in 0..1000 {
        let wo = degrees(60.0, 0.0).as_vec3();
        let sample = bsdf.sampled(wo, Vec3::from(uniforms(&mut rng)), None);
        if sample.pdf > 0.0 {
            assert_eq!(sample.flags, bsdf.lobe_infos()[sample.lobe].flags);
            seen[sample.lobe] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
    // A mirror loses nothing.
    let mirror: Bsdf = Bsdf::new(&compensated(&white("ggx", "smith", 0.0))).unwrap();
    assert_eq!(mirror.flags(), Flags::REFLECTION.with(Flags::DELTA));
}

#[test]
fn what_cannot_be_compensated_is_refused() {
    let stretched = white("ggx", "smith", 0.3).set("anisotropy", &[0.1]);
    let implicit = white("ggx", "implicit", 0.3);
    for (description, word) in [(stretched, "anisotropy"), (implicit, "implicit")] {
        let Err(error) = Bsdf::<f32>::new(&compensated(&description)) else {
            panic!("{description:?}");
        };
        assert_eq!(error.status, Status::Unsupported);
        assert!(error.message.contains(word), "{error}");
    }
}
