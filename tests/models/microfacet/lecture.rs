//! The factors of the `microfacet` model against their printed formulas and defining integrals: the
//! lecture's D and G, the normalisation of D, and Smith's masking as the visible area.

use super::rough::{
    DISTRIBUTIONS, MASKINGS, density, double, masking, over_normals, stretched, white,
};
use crate::common;
use crate::common::calls::Calls;
use crate::common::{hemisphere, rng};
use glam::DVec3;
use std::f64::consts::PI;

/// D as the lecture prints it, of n.m: `D_tr`, `D_b` and `D_p`.
fn printed(distribution: &str, alpha: f64, cosine: f64) -> f64 {
    let c2 = cosine * cosine;
    let a2 = alpha * alpha;
    match distribution {
        "ggx" => a2 / (PI * (c2 * (a2 - 1.0) + 1.0).powi(2)),
        "beckmann" => (-(1.0 - c2) / (a2 * c2)).exp() / (PI * a2 * c2 * c2),
        _ => {
            let exponent = 2.0 / a2 - 2.0;
            (exponent + 2.0) / (2.0 * PI) * cosine.powf(exponent)
        }
    }
}

#[test]
fn densities_are_the_printed_ones() {
    for distribution in ["ggx", "beckmann", "blinn_phong"] {
        for alpha in [0.05f32, 0.3, 0.7, 1.0] {
            let surface = double(&white(distribution, "implicit", alpha));
            for i in 1..100 {
                let z = f64::from(i) / 100.0;
                let h = DVec3::new((1.0 - z * z).sqrt(), 0.0, z);
                let found = density(&surface, h);
                let expected = printed(distribution, f64::from(alpha), z);
                let error = (found - expected).abs();
                assert!(
                    error <= 1e-10 * expected + 1e-30,
                    "{distribution} {alpha} {z}: {found}, not {expected}"
                );
            }
        }
    }
}

/// The roughness along a direction of a stretched surface, and along the axes: Burley 2012.
#[test]
fn stretching_keeps_the_peak_and_widens_one_axis() {
    for distribution in ["ggx", "beckmann"] {
        let description = white(distribution, "implicit", 0.2);
        let round = double(&description);
        let long = description.set("anisotropy", &[0.8]);
        let turned = double(&long.clone().set("rotation_turns", &[0.25]));
        let long = double(&long);
        let peak = density(&round, DVec3::Z);
        assert!((density(&long, DVec3::Z) / peak - 1.0).abs() < 1e-12);
        // Where the tangent over the axis' roughness is the same, so is D cos^4.
        let aspect = (1.0f64 - 0.9 * f64::from(0.8f32)).sqrt();
        let slope = |surface, x: f64, y: f64| {
            let z = 1.0 / (1.0 + x * x + y * y).sqrt();
            density(surface, DVec3::new(x, y, 1.0) * z) * z.powi(4)
        };
        for t in [0.05, 0.2, 0.5] {
            let expected = slope(&round, t, 0.0);
            let found = [
                slope(&long, t / aspect, 0.0),
                slope(&long, 0.0, t * aspect),
                slope(&turned, 0.0, t / aspect),
                slope(&turned, t * aspect, 0.0),
            ];
            for found in found {
                assert!((found / expected - 1.0).abs() < 1e-6, "{distribution} {t}");
            }
        }
    }
}

/// The facets' area projected onto the surface is the surface's.
#[test]
fn densities_are_normalised() {
    for distribution in ["ggx", "beckmann", "blinn_phong", "abc", "sgd"] {
        for alpha in [1e-3f32, 0.01, 0.05, 0.2, 0.5, 0.8, 1.0] {
            let mut description = white(distribution, "implicit", alpha);
            if distribution == "abc" {
                description = description.set("abc_exponent", &[2.5]);
            }
            for description in stretched(distribution, &description) {
                let surface = double(&description);
                let area = over_normals(f64::from(alpha), 256, |h| density(&surface, h) * h.z);
                assert!((area - 1.0).abs() < 1e-6, "{description:?}: {area}");
            }
        }
    }
}

/// Smith's G1 is what makes the visible facets' projected area that of the surface: the integral of
/// G1(w) D(h) max(0, <w, h>) is w.z. With correlated heights 1 / G = 2 / G1 - 1 for w and its mirror
/// image.
#[test]
fn smith_masking_shows_the_visible_area() {
    for distribution in DISTRIBUTIONS {
        for alpha in [1e-3f32, 0.1, 1.0] {
            let plain = white(distribution, "implicit", alpha);
            let smith = white(distribution, "smith", alpha);
            let pairs = stretched(distribution, &plain).into_iter();
            for (plain, smith) in pairs.zip(stretched(distribution, &smith)) {
                let (implicit, surface) = (double(&plain), double(&smith));
                for theta in [0.0, 30.0, 60.0, 80.0, 89.0] {
                    let w = common::degrees(theta, 35.0);
                    let mirrored = DVec3::new(-w.x, -w.y, w.z);
                    let g1 = 2.0 / (1.0 / masking(&surface, &implicit, w, mirrored) + 1.0);
                    let area = over_normals(f64::from(alpha), 240, |h| {
                        density(&implicit, h) * w.dot(h).max(0.0)
                    });
                    let visible = g1 * area / w.z;
                    assert!(
                        (visible - 1.0).abs() < 2e-4,
                        "{smith:?} at {theta} degrees: {visible}"
                    );
                }
            }
        }
    }
}

/// The other maskings as they are printed, from the cosines; all within [0, 1], and symmetric.
#[test]
fn maskings_are_the_printed_ones() {
    let mut rng = rng(3);
    for distribution in DISTRIBUTIONS {
        for alpha in [0.01f32, 0.3, 1.0] {
            let implicit = double(&white(distribution, "implicit", alpha));
            for name in MASKINGS {
                let surface = double(&white(distribution, name, alpha));
                for _ in 0..200 {
                    let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
                    if implicit.value(wo, wi, None)[0] < 1e-200 {
                        continue;
                    }
                    let g = masking(&surface, &implicit, wo, wi);
                    assert!((0.0..=1.0 + 1e-12).contains(&g), "{name} {g}");
                    let back = masking(&surface, &implicit, wi, wo);
                    assert!((g / back - 1.0).abs() < 1e-9, "{name} {g} {back}");
                    let h = (wo + wi).normalize();
                    let (nl, nv, nh, vh) = (wi.z, wo.z, h.z, wo.dot(h));
                    let k = f64::from(alpha) * (2.0 / PI).sqrt();
                    let schlick = |cosine: f64| cosine / (cosine * (1.0 - k) + k);
                    let expected = match name {
                        "implicit" => nl * nv,
                        "schlick" => schlick(nl) * schlick(nv),
                        "kelemen" => nl * nv / (vh * vh),
                        "cook_torrance" => (2.0 * nh * nv / vh).min(2.0 * nh * nl / vh).min(1.0),
                        _ => continue,
                    };
                    assert!(
                        (g / expected - 1.0).abs() < 1e-9,
                        "{name}: {g}, not {expected}"
                    );
                }
            }
        }
    }
}

/// Kelemen's approximation and the product of cosines never exceed the grooves' masking, with which
/// every symmetric D conserves energy: that is why the model declares no exception for them.
#[test]
fn maskings_are_ordered() {
    let mut rng = rng(4);
    let [grooves, kelemen, implicit] =
        ["cook_torrance", "kelemen", "implicit"].map(|name| double(&white("ggx", name, 0.5)));
    for _ in 0..10_000 {
        let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
        let [a, b, c] = [&grooves, &kelemen, &implicit].map(|s| s.value(wo, wi, None)[0]);
        assert!(
            a >= b * (1.0 - 1e-12) && b >= c * (1.0 - 1e-12),
            "{wo} {wi}: {a} {b} {c}"
        );
    }
}
