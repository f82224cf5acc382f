//! The Fresnel factors of the `microfacet` model: limits, closed forms, and films.

use super::rough::{double, over_normals, white};
use crate::common;
use crate::common::calls::Calls;
use crate::common::films::{Kind, compiled, constant, medium};
use crate::common::{hemisphere, rng};
use glam::DVec3;
use pellicle::bsdf::Flags;
use pellicle::film::{Film, FilmDescription};
use pellicle::{Bsdf, Description};
use std::sync::Arc;

/// F at a cosine <wo, h>, as the ratio of values with that factor and with F = 1.
fn factor(description: &Description, cosine: f64) -> [f64; 3] {
    let sine = (1.0 - cosine * cosine).sqrt();
    let wo = DVec3::new(sine, 0.0, cosine);
    let wi = DVec3::new(-sine, 0.0, cosine);
    let unit = double(&white("ggx", "smith", 0.3)).value(wo, wi, None);
    let value = double(description).value(wo, wi, None);
    std::array::from_fn(|c| value[c] / unit[c])
}

fn with(fresnel: &str) -> Description {
    Description::new("microfacet").choose("fresnel", fresnel)
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "{what}: {found}, not {expected}");
}

/// R_s and R_p averaged, from Snell's law in complex numbers: Born and Wolf, section 14.2. The branch
/// with the positive imaginary part is the wave that decays inwards.
fn exact(cosine: f64, eta: f64, k: f64) -> f64 {
    type Complex = (f64, f64);
    let multiply = |a: Complex, b: Complex| (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0);
    let divide = |a: Complex, b: Complex| {
        let norm = b.0 * b.0 + b.1 * b.1;
        multiply(a, (b.0 / norm, -b.1 / norm))
    };
    let root = |a: Complex| {
        let (radius, angle) = (a.0.hypot(a.1).sqrt(), a.1.atan2(a.0) / 2.0);
        (radius * angle.cos(), radius * angle.sin())
    };
    let n = (eta, k);
    let sine = (1.0 - cosine * cosine).sqrt();
    let inside = divide((sine, 0.0), n);
    let squared = multiply(inside, inside);
    let cos_inside = root((1.0 - squared.0, -squared.1));
    let n_cos = multiply(n, cos_inside);
    let n_cos = if n_cos.1 < 0.0 {
        (-n_cos.0, -n_cos.1)
    } else {
        n_cos
    };
    let cos_inside = divide(n_cos, n);
    let reflectance = |a: Complex, b: Complex| {
        let r = divide((a.0 - b.0, a.1 - b.1), (a.0 + b.0, a.1 + b.1));
        r.0 * r.0 + r.1 * r.1
    };
    let s = reflectance((cosine, 0.0), n_cos);
    let p = reflectance(multiply(n, (cosine, 0.0)), cos_inside);
    (s + p) / 2.0
}

#[test]
fn schlick_goes_from_f0_to_f90() {
    let description = with("schlick")
        .set("f0", &[0.0, 0.2, 1.0])
        .set("f90", &[1.0, 0.5, 0.7]);
    for i in 1..=100 {
        let c = f64::from(i) / 100.0;
        let found = factor(&description, c);
        let expected: [f64; 3] = std::array::from_fn(|channel| {
            let (f0, f90) = ([0.0, 0.2f32, 1.0], [1.0, 0.5, 0.7f32]);
            let (f0, f90) = (f64::from(f0[channel]), f64::from(f90[channel]));
            f0 + (f90 - f0) * (1.0 - c).powi(5)
        });
        for channel in 0..3 {
            assert_near(found[channel], expected[channel], 1e-12, "schlick");
        }
    }
}

/// Normal incidence, Brewster's angle where p vanishes, grazing incidence.
#[test]
fn dielectrics_have_textbook_limits() {
    let etas = [1.0f32, 1.33, 1.5, 2.4, 10.0];
    for eta in etas {
        let description = with("dielectric").set("eta", &[eta]);
        let eta = f64::from(eta);
        let normal = ((eta - 1.0) / (eta + 1.0)).powi(2);
        assert_near(factor(&description, 1.0)[0], normal, 1e-12, "normal");
        let brewster = 1.0 / (1.0 + eta * eta).sqrt();
        let s = (1.0 - eta * eta) / (1.0 + eta * eta);
        assert_near(
            factor(&description, brewster)[0],
            0.5 * s * s,
            1e-12,
            "Brewster",
        );
        if eta > 1.0 {
            assert_near(factor(&description, 1e-9)[0], 1.0, 1e-6, "grazing");
        } else {
            assert_near(factor(&description, 1e-9)[0], 0.0, 0.0, "nothing there");
        }
    }
}

#[test]
fn conductors_are_exact_and_go_over_into_dielectrics() {
    for (eta, k) in [
        (0.2, 3.4),
        (1.5, 0.0),
        (2.9, 3.1),
        (0.05, 20.0),
        (0.6, 0.0),
        (1.0, 0.5),
    ] {
        let (eta, k) = (eta as f32, k as f32);
        let description = with("conductor").set("eta", &[eta]).set("k", &[k]);
        for i in 1..=100 {
            let c = f64::from(i) / 100.0;
            let expected = exact(c, f64::from(eta), f64::from(k));
            assert_near(factor(&description, c)[1], expected, 1e-9, "conductor");
        }
    }
    let glass = with("dielectric").set("eta", &[1.5]);
    for k in [0.0, 1e-4f32] {
        let nearly = with("conductor").set("eta", &[1.5]).set("k", &[k]);
        for i in 1..=100 {
            let c = f64::from(i) / 100.0;
            let tolerance = 1e-12 + 10.0 * f64::from(k * k);
            assert_near(
                factor(&nearly, c)[2],
                factor(&glass, c)[2],
                tolerance,
                "k -> 0",
            );
        }
    }
}

/// An index below 1 without absorption: everything is reflected from the critical angle on.
#[test]
fn conductors_reflect_totally_beyond_the_critical_angle() {
    let eta = 0.6f64;
    let description = with("conductor").set("eta", &[0.6]);
    let critical = (1.0 - eta * eta).sqrt();
    for part in [0.01, 0.5, 0.99] {
        assert_near(
            factor(&description, critical * part)[0],
            1.0,
            1e-9,
            "beyond",
        );
    }
    let inside = factor(&description, critical + 1e-3)[0];
    assert!(inside < 0.9, "{inside}");
}

/// A named metal is its bare surface by wave optics.
#[test]
fn named_metals_are_bare_films() {
    for name in ["Ag", "Al", "Au", "Cr", "Cu", "Fe", "Ni", "Pt", "Ti"] {
        let description = with("conductor").choose("metal", name);
        let film = Film::new(&FilmDescription::new(medium(name))).unwrap();
        for c in [1.0, 0.7, 0.3, 0.05] {
            let expected = film
                .reference(c, 0.0)
                .map(|channel| channel.clamp(0.0, 1.0));
            let found = factor(&description, c);
            for channel in 0..3 {
                assert_near(found[channel], expected[channel], 2e-3, name);
            }
        }
    }
}

fn coated(film: &Arc<Film>, thickness_nm: f32) -> Description {
    with("film")
        .film(Arc::clone(film))
        .set("thickness_nm", &[thickness_nm])
}

#[test]
fn films_are_asked_at_the_half_angle_and_the_thickness() {
    let film = Kind::Lens.film();
    for thickness in [0.0f32, 137.0, 600.0] {
        let description = coated(&film, thickness);
        for c in [1.0, 0.6, 0.2] {
            let expected = film.reflectance(c as f32, thickness);
            let found = factor(&description, c);
            for channel in 0..3 {
                assert_near(found[channel], f64::from(expected[channel]), 1e-6, "film");
            }
        }
    }
}

/// A film of no thickness is its bare base, to the film's tolerance.
#[test]
fn a_film_of_no_thickness_is_the_bare_base() {
    let film =
        compiled(&FilmDescription::new(constant(1.5, 0.0)).layer(constant(2.0, 0.0), [0.0, 300.0]));
    let bare = with("dielectric").set("eta", &[1.5]);
    let metal =
        compiled(&FilmDescription::new(constant(0.4, 2.9)).layer(constant(1.5, 0.0), [0.0, 300.0]));
    let conductor = with("conductor").set("eta", &[0.4]).set("k", &[2.9]);
    for (film, bare) in [(film, bare), (metal, conductor)] {
        let coated = coated(&film, 0.0);
        for i in 1..=50 {
            let c = f64::from(i) / 50.0;
            let (found, expected) = (factor(&coated, c), factor(&bare, c));
            for channel in 0..3 {
                assert_near(found[channel], expected[channel], 2e-3, "no thickness");
            }
        }
    }
}

#[test]
fn thickness_and_f0_vary_per_call() {
    let film = Kind::Lens.film();
    let varying = with("film")
        .film(Arc::clone(&film))
        .vary("thickness_nm", 50.0, 600.0);
    let varying: Bsdf = Bsdf::new(&varying).unwrap();
    let mut rng = rng(5);
    for thickness in [50.0f32, 200.0, 600.0] {
        let fixed: Bsdf = Bsdf::new(&coated(&film, thickness)).unwrap();
        let (wo, wi) = (
            hemisphere(&mut rng).as_vec3(),
            hemisphere(&mut rng).as_vec3(),
        );
        let found = varying.value_pdf(wo, wi, Some(&[thickness]));
        assert_eq!(found, fixed.value_pdf(wo, wi, None));
    }
    let tinted: Bsdf = Bsdf::new(&with("schlick").vary("f0", 0.0, 1.0)).unwrap();
    let fixed: Bsdf = Bsdf::new(&with("schlick").set("f0", &[0.9, 0.5, 0.1])).unwrap();
    let (wo, wi) = (
        hemisphere(&mut rng).as_vec3(),
        hemisphere(&mut rng).as_vec3(),
    );
    assert_eq!(
        tinted.value_pdf(wo, wi, Some(&[0.9, 0.5, 0.1])),
        fixed.value_pdf(wo, wi, None)
    );
}

/// The mean colour of a rough metal under a film tends to the smooth film's as roughness goes to 0,
/// and is the smooth film's for a mirror.
#[test]
fn rough_films_tend_to_the_smooth_film() {
    let film = compiled(&FilmDescription::new(medium("Ti")).layer(medium("TiO2"), [0.0, 200.0]));
    for thickness in [60.0f32, 170.0] {
        let smooth = Description::new("film").film(Arc::clone(&film));
        let smooth: Bsdf<f64> = double(&smooth.set("thickness_nm", &[thickness]));
        for theta in [0.0, 45.0, 70.0] {
            let wo = common::degrees(theta, 10.0);
            let expected = smooth.directional_albedo(wo, None);
            let mut errors = Vec::new();
            for alpha in [0.1f32, 0.03, 0.01, 0.0] {
                let rough = double(&coated(&film, thickness).set("alpha", &[alpha]));
                assert_eq!(rough.flags().contains(Flags::DELTA), alpha == 0.0);
                let found = rough.directional_albedo(wo, None);
                let error = (0..3).map(|c| (found[c] - expected[c]).abs());
                errors.push(error.fold(0.0, f64::max));
            }
            // The angle's spread is alpha, and the colour changes with its square.
            assert!(
                errors[1] < 2e-2 && errors[2] < 3e-3,
                "{thickness} {theta}: {errors:?}"
            );
            assert!(errors[3] < 1e-6, "{thickness} {theta}: {errors:?}");
        }
    }
}

/// A mirror reflects F, times the limit of G where that is not 1.
#[test]
fn a_mirror_reflects_its_fresnel_factor() {
    let description = Description::new("microfacet").set("f0", &[0.3]);
    let set_alpha = |description: Description, alpha: f32| description.set("alpha", &[alpha]);
    for (masking, power) in [
        ("smith", 0),
        ("schlick", 0),
        ("kelemen", 0),
        ("implicit", 2),
    ] {
        let mirror = description.clone().choose("masking", masking);
        let mirror = double(&set_alpha(mirror, 0.0));
        assert_eq!(mirror.flags(), Flags::REFLECTION.with(Flags::DELTA));
        for theta in [0.0f64, 50.0, 85.0] {
            let wo = common::degrees(theta, 30.0);
            let f = 0.3f32 as f64;
            let expected = (f + (1.0 - f) * (1.0 - wo.z).powi(5)) * wo.z.powi(power);
            let sample = mirror.sampled(wo, DVec3::splat(0.4), None);
            assert_eq!(
                (sample.wi, sample.pdf),
                (DVec3::new(-wo.x, -wo.y, wo.z), 0.0)
            );
            assert_near(sample.weight[0], expected, 1e-12, masking);
            let rough = description.clone().choose("masking", masking);
            let rough = double(&set_alpha(rough, 1e-4)).directional_albedo(wo, None)[0];
            assert_near(rough, expected, 2e-3, masking);
        }
    }
}

/// The value against quadrature that knows only the formula: the albedo at normal incidence of a white
/// surface is the integral of D G <wo, h> over normals.
#[test]
fn albedo_is_the_integral_over_normals() {
    for (distribution, alpha) in [("ggx", 0.4f32), ("beckmann", 0.7), ("ggx", 0.05)] {
        let surface = double(&white(distribution, "kelemen", alpha));
        let implicit = double(&white(distribution, "implicit", alpha));
        let expected = over_normals(f64::from(alpha), 64, |h| {
            let l = DVec3::new(2.0 * h.z * h.x, 2.0 * h.z * h.y, 2.0 * h.z * h.z - 1.0);
            let g = (l.z / (h.z * h.z)).max(0.0);
            super::rough::density(&implicit, h) * g * h.z
        });
        let found = surface.directional_albedo(DVec3::Z, None)[0];
        assert_near(found, expected, 1e-3, distribution);
    }
}
