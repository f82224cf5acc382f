//! `metallic_roughness`: its value against the definitions evaluated independently and another
//! package's numbers, its parameters per call against the same fixed, and its limits.

use crate::common::calls::Calls;
use crate::common::{degrees, hemisphere, rng, roughness_of, rounded};
use glam::DVec3;
use pellicle::{Bsdf, Description};
use rand::RngExt;
use std::f64::consts::PI;

fn metallic_roughness() -> Description {
    Description::new("metallic_roughness")
}

/// The definitions in their own variables, in double precision.
struct Truth {
    alpha: f64,
    f0: f64,
    /// Albedo of the highlight with F = 1 and with F = (1 - <wo, h>)^5, at 400 cosines, sqrt(z) in
    /// equal steps.
    albedos: Vec<[f64; 2]>,
}

const STEPS: usize = 400;

impl Truth {
    fn new(alpha: f64, f0: f64) -> Self {
        let cosine = |i: usize| ((i as f64 + 0.5) / STEPS as f64).powi(2);
        let albedos = (0..STEPS).map(|i| highlight_albedo(alpha, cosine(i)));
        Self {
            alpha,
            f0,
            albedos: albedos.collect(),
        }
    }

    fn under_schlick(&self, [whole, grazing]: [f64; 2]) -> f64 {
        self.f0 * whole + (1.0 - self.f0) * grazing
    }

    fn remainder(&self, cosine: f64) -> f64 {
        1.0 - self.under_schlick(highlight_albedo(self.alpha, cosine))
    }

    fn mean_remainder(&self) -> f64 {
        let parts = self.albedos.iter().enumerate().map(|(i, albedo)| {
            let root = (i as f64 + 0.5) / STEPS as f64;
            4.0 * root.powi(3) / STEPS as f64 * (1.0 - self.under_schlick(*albedo))
        });
        parts.sum()
    }

    /// The coupled diffuse part with reflectance 1 and Lambert's form, times |wi.z|.
    fn diffuse(&self, wo: DVec3, wi: DVec3) -> f64 {
        let both = self.remainder(wo.z) * self.remainder(wi.z);
        both / self.mean_remainder() / PI * wi.z
    }
}

/// Smith's Lambda of GGX: Heitz 2014, eq. 72.
fn lambda(alpha: f64, cosine: f64) -> f64 {
    ((1.0 + alpha * alpha * (1.0 / (cosine * cosine) - 1.0)).sqrt() - 1.0) / 2.0
}

/// The highlight with F = 1, times |wi.z|.
fn highlight(alpha: f64, wo: DVec3, wi: DVec3) -> f64 {
    let h = (wo + wi).normalize();
    let a2 = alpha * alpha;
    let d = a2 / (PI * (h.z * h.z * (a2 - 1.0) + 1.0).powi(2));
    let g = 1.0 / (1.0 + lambda(alpha, wo.z) + lambda(alpha, wi.z));
    d * g / (4.0 * wo.z)
}

/// The integral of the highlight over wi, by normals with density D h.z: the mean of
/// G <wo, h> / (wo.z h.z) over tan^2 = alpha^2 u / (1 - u) and azimuth.
fn highlight_albedo(alpha: f64, cosine: f64) -> [f64; 2] {
    const NODES: usize = 150;
    let sine = (1.0 - cosine * cosine).sqrt();
    let mut sums = [0.0; 2];
    for i in 0..NODES {
        let t = (i as f64 + 0.5) / NODES as f64;
        let u = t * t * (3.0 - 2.0 * t);
        let weight = 6.0 * t * (1.0 - t) / (NODES * NODES) as f64;
        let tangent = alpha * (u / (1.0 - u)).sqrt();
        let z = 1.0 / (1.0 + tangent * tangent).sqrt();
        for j in 0..NODES {
            let azimuth = PI * (j as f64 + 0.5) / NODES as f64;
            let dot = z * (cosine + sine * tangent * azimuth.cos());
            let wi = 2.0 * dot * z - cosine;
            if dot > 0.0 && wi > 0.0 {
                let g = 1.0 / (1.0 + lambda(alpha, cosine) + lambda(alpha, wi));
                let part = weight * g * dot / (cosine * z);
                sums[0] += part;
                sums[1] += part * (1.0 - dot).powi(5);
            }
        }
    }
    sums
}

fn schlick(f0: f64, cosine: f64) -> f64 {
    f0 + (1.0 - f0) * (1.0 - cosine).powi(5)
}

/// A metal has no table in its value: it is the definition to rounding.
#[test]
fn a_metals_value_is_the_definition() {
    let mut rng = rng(1);
    for _ in 0..300 {
        let roughness: f32 = rng.random_range(0.05..1.0);
        let color: f32 = rng.random();
        let description = metallic_roughness()
            .set("metallic", &[1.0])
            .set("roughness", &[roughness])
            .set("base_color", &[color]);
        let bsdf: Bsdf<f64> = Bsdf::new(&description).unwrap();
        for _ in 0..20 {
            let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
            let alpha = f64::from(roughness).powi(2);
            let cosine = wo.dot((wo + wi).normalize());
            let expected = highlight(alpha, wo, wi) * schlick(f64::from(color), cosine);
            let found = bsdf.value(wo, wi, None)[0];
            assert!(
                (found / expected - 1.0).abs() < 1e-9,
                "{description:?} {wo} {wi}: {found} {expected}"
            );
        }
    }
}

/// A dielectric's value is the definition to the table's error: 1e-3 of 1 - E either way.
#[test]
fn a_dielectrics_value_is_the_definition() {
    let mut rng = rng(2);
    for (roughness, f0, metallic) in [
        (0.1f32, 0.04f32, 0.0f32),
        (0.5, 0.04, 0.0),
        (0.5, 0.2, 0.4),
        (1.0, 0.04, 0.0),
        (1.0, 0.8, 0.0),
    ] {
        let description = metallic_roughness()
            .set("roughness", &[roughness])
            .set("metallic", &[metallic])
            .set("base_color", &[0.7])
            .choose("dielectric_from", "f0")
            .set("f0", &[f0]);
        let bsdf: Bsdf<f64> = Bsdf::new(&description).unwrap();
        let truth = Truth::new(f64::from(roughness).powi(2), f64::from(f0));
        let (metallic, color) = (f64::from(metallic), f64::from(0.7f32));
        for _ in 0..30 {
            let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
            let cosine = wo.dot((wo + wi).normalize());
            let mixed = f64::from(f0) * (1.0 - metallic) + color * metallic;
            let specular = highlight(truth.alpha, wo, wi) * schlick(mixed, cosine);
            let diffuse = (1.0 - metallic) * color * truth.diffuse(wo, wi);
            let found = bsdf.value(wo, wi, None)[0];
            let least = truth.remainder(wo.z).min(truth.remainder(wi.z));
            let allowed = diffuse * (3e-3 / least) + 1e-9;
            assert!(
                (found - specular - diffuse).abs() < allowed,
                "{description:?} {wo} {wi}: {found} {}",
                specular + diffuse
            );
        }
    }
}

/// How F0 is calculated, the lecture's question: from the index by ((eta - 1) / (eta + 1))^2.
#[test]
fn the_index_gives_f0() {
    let (wo, wi) = (degrees(20.0, 0.0), degrees(30.0, 170.0));
    for (eta, f0) in [
        (1.0, 0.0),
        (1.33, 0.020_06),
        (1.5, 0.04),
        (2.42, 0.172_4),
        (3.0, 0.25),
    ] {
        let black = metallic_roughness().set("base_color", &[0.0]);
        let by_index: Bsdf = Bsdf::new(&black.clone().set("eta", &[eta])).unwrap();
        let by_f0 = black.choose("dielectric_from", "f0").set("f0", &[f0]);
        let by_f0: Bsdf = Bsdf::new(&by_f0).unwrap();
        let [a, b] =
            [&by_index, &by_f0].map(|bsdf| bsdf.value(wo.as_vec3(), wi.as_vec3(), None)[0]);
        assert!((a - b).abs() < 1e-3 * a + 1e-6, "{eta}: {a} {b}");
    }
}

/// Mitsuba 3.9.1, `principled` with metallic 1: the same D and F, and the product of Smith's G1 instead
/// of the height-correlated G, which is divided out here. Values for base colour 0.9, printed by
///
/// ```python
/// import mitsuba as mi
/// from math import sin, cos, radians
/// mi.set_variant("scalar_rgb")
/// def d(t, p):
///     t, p = radians(t), radians(p)
///     return mi.Vector3f(sin(t) * cos(p), sin(t) * sin(p), cos(t))
/// for r in (0.2, 0.5, 1.0):
///     b = mi.load_dict({"type": "principled", "base_color": {"type": "rgb", "value": [.9, .6, .3]},
///                       "metallic": 1.0, "roughness": r})
///     for wo, wi in (((20, 0), (35, 150)), ((60, 10), (55, 200)), ((75, 0), (40, 30)),
///                    ((5, 0), (80, 90)), ((45, 0), (45, 180))):
///         si = mi.SurfaceInteraction3f()
///         si.wi = d(*wo)
///         si.sh_frame = mi.Frame3f(mi.Vector3f(0, 0, 1))
///         print(r, wo, wi, b.eval(mi.BSDFContext(), si, d(*wi))[0])
/// ```
#[test]
fn a_metal_has_mitsubas_values() {
    let pairs = [
        ((20.0, 0.0), (35.0, 150.0)),
        ((60.0, 10.0), (55.0, 200.0)),
        ((75.0, 0.0), (40.0, 30.0)),
        ((5.0, 0.0), (80.0, 90.0)),
        ((45.0, 0.0), (45.0, 180.0)),
    ];
    let values = [
        (
            0.2,
            [0.1010643, 0.4841461, 0.0009035946, 0.0006514477, 63.26805],
        ),
        (0.5, [0.5383779, 1.25621, 0.02816007, 0.01600382, 1.572199]),
        (
            1.0,
            [0.06650523, 0.06977073, 0.09871469, 0.02123518, 0.06952809],
        ),
    ];
    for (roughness, values) in values {
        let description = metallic_roughness()
            .set("metallic", &[1.0])
            .set("base_color", &[0.9])
            .set("roughness", &[roughness]);
        let bsdf: Bsdf<f64> = Bsdf::new(&description).unwrap();
        for ((wo, wi), expected) in pairs.into_iter().zip(values) {
            let (wo, wi) = (degrees(wo.0, wo.1), degrees(wi.0, wi.1));
            let alpha = f64::from(roughness).powi(2);
            let [out, back] = [wo, wi].map(|w| lambda(alpha, w.z));
            let separable = (1.0 + out + back) / ((1.0 + out) * (1.0 + back));
            let found: f64 = bsdf.value(wo, wi, None)[0] * separable;
            // 2e-4: single precision, at the sharp lobe's centre 63.
            let error: f64 = found / expected - 1.0;
            assert!(
                error.abs() < 2e-4,
                "{roughness} {wo} {wi}: {found} {expected}"
            );
        }
    }
}

/// The numbers of every choice.
const NUMBERS: [(&str, usize); 3] = [("base_color", 3), ("metallic", 1), ("roughness", 1)];

fn range(name: &str) -> [f32; 2] {
    if name == "eta" {
        [1.0, 3.0]
    } else {
        [0.0, 1.0]
    }
}

/// Everything given per call equals the same fixed: to rounding, but for the table over all
/// roughnesses instead of the one at hand, which shifts the diffuse part by the tables' errors.
#[test]
fn varying_everything_equals_everything_fixed() {
    let mut rng = rng(3);
    for specular in ["eta", "f0"] {
        for diffuse in ["lambert", "oren_nayar", "disney"] {
            let chosen = metallic_roughness()
                .choose("dielectric_from", specular)
                .choose("diffuse_form", diffuse);
            let mut numbers = NUMBERS.to_vec();
            numbers.push((specular, 1));
            numbers.extend(roughness_of(diffuse).map(|param| (param, 1)));
            let varying = numbers
                .iter()
                .fold(chosen.clone(), |description, &(name, _)| {
                    let [min, max] = range(name);
                    description.vary(name, min, max)
                });
            let varying: Bsdf = Bsdf::new(&varying).unwrap();
            for _ in 0..100 {
                let mut flat = Vec::new();
                let mut fixed = chosen.clone();
                for &(name, components) in &numbers {
                    let [min, max] = range(name);
                    let numbers: Vec<f32> = (0..components)
                        .map(|_| rng.random_range(min..=max))
                        .collect();
                    flat.extend(&numbers);
                    fixed = fixed.set(name, &numbers);
                }
                let fixed: Bsdf = Bsdf::new(&fixed).unwrap();
                for _ in 0..20 {
                    let wo = hemisphere(&mut rng).as_vec3();
                    let wi = hemisphere(&mut rng).as_vec3();
                    let (found, pdf) = varying.value_pdf(wo, wi, Some(&flat));
                    let (expected, expected_pdf) = fixed.value_pdf(wo, wi, None);
                    for c in 0..3 {
                        let error = (found[c] - expected[c]).abs();
                        assert!(
                            error <= 1e-5 * expected[c] + 4e-3 * wi.z,
                            "{diffuse} {specular} {flat:?} {wo} {wi}: {found:?} {expected:?}"
                        );
                    }
                    // The diffuse lobe, whose density is wi.z / pi, has the share d / (d + s), where the albedos
                    // d and s come from a table. The two tables compared are each within 1e-3 of the truth.
                    // With F0 near 1, s is near 1 and the share moves by up to 2e-3, however small it is.
                    // More rows in the table do not help: the error is that of its 377 quadrature nodes.
                    let moved = 2e-3 * wi.z * std::f32::consts::FRAC_1_PI;
                    let error = (pdf - expected_pdf).abs();
                    assert!(
                        error <= 5e-3 * expected_pdf + moved,
                        "{flat:?}: {pdf} {expected_pdf}"
                    );
                }
            }
        }
    }
}

/// Roughnesses below 0.01, 0 included, are alpha = 1e-4, whose lobe keeps its digits in single
/// precision.
#[test]
fn the_least_alpha_is_as_stated() {
    let of = |roughness: f32| {
        metallic_roughness()
            .set("metallic", &[1.0])
            .set("roughness", &[roughness])
    };
    let single = [0.0, 0.005, 0.01].map(|roughness| Bsdf::<f32>::new(&of(roughness)).unwrap());
    let double: Bsdf<f64> = Bsdf::new(&of(0.01)).unwrap();
    let mut rng = rng(4);
    for _ in 0..1000 {
        let (wo, wo_double) = rounded(hemisphere(&mut rng));
        let shift = DVec3::new(rng.random::<f64>(), rng.random::<f64>(), 0.0) * 3e-4;
        let mirrored = DVec3::new(-wo_double.x, -wo_double.y, wo_double.z) + shift;
        let (wi, wi_double) = rounded(mirrored.normalize());
        let values = single.each_ref().map(|bsdf| bsdf.value(wo, wi, None)[0]);
        assert!(values[0] == values[1]);
        let expected = double.value(wo_double, wi_double, None)[0];
        let error = (f64::from(values[2]) / expected - 1.0).abs();
        assert!(error < 5e-3, "{wo} {wi}: {} {expected}", values[2]);
        assert!((values[0] / values[2] - 1.0).abs() < 1e-5);
    }
}

#[test]
fn wrong_values_are_refused_with_the_choices() {
    let message = |description: Description| Bsdf::<f32>::new(&description).err().unwrap().message;
    let found = message(metallic_roughness().choose("diffuse_form", "burley"));
    assert!(found.contains("lambert") && found.contains("oren_nayar") && found.contains("disney"));
    let found = message(metallic_roughness().choose("dielectric_from", "ior"));
    assert!(found.contains("eta") && found.contains("f0"));
    let found = message(metallic_roughness().set("roughness", &[1.5]));
    assert!(found.contains("1.5") && found.contains("[0, 1]"), "{found}");
    let found = message(metallic_roughness().set("eta", &[0.24]));
    assert!(
        found.contains("0.24") && found.contains("[1, 3]"),
        "{found}"
    );
}
