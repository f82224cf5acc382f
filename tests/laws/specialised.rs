//! Values that leave terms out or have shorter formulas: the plan says so, batches return the bits of single
//! calls, and no digits are lost.

use super::batch::{check_eval, check_sample};
use crate::common::calls::Calls;
use crate::common::{hemisphere, rng};
use glam::Vec3;
use pellicle::num::Level;
use pellicle::{Bsdf, Description};
use rand::RngExt;

/// Descriptions with values that leave terms out or have shorter formulas, and what their plans say.
fn specialised() -> Vec<(Description, &'static str)> {
    const THREE: [f32; 3] = [1.4, 1.45, 1.6];
    const DEVIATED: [f32; 3] = [0.17, 0.0, 0.98];
    let layered = |eta: &[f32], base_normal: [f32; 3], exponents: [f32; 2]| {
        Description::new("layered")
            .set("eta", eta)
            .set("base_normal", &base_normal)
            .set("exponent_reflection", &exponents[..1])
            .set("exponent_transmission", &exponents[1..])
    };
    let real = || layered(&THREE, DEVIATED, [90.5, 170.5]);
    let gray = || layered(&[1.5], DEVIATED, [90.5, 170.5]);
    let microfacet = |fresnel| {
        Description::new("microfacet")
            .choose("fresnel", fresnel)
            .set("alpha", &[0.3])
    };
    let gold = || {
        microfacet("conductor")
            .set("eta", &[0.13, 0.4, 1.5])
            .set("k", &[4.1, 2.5, 1.9])
    };
    let of_gold = "isotropic, conductor by polynomials";
    vec![
        (real(), "all terms"),
        (gray(), "one index for all channels"),
        (
            gray().choose("variant", "paper"),
            "one index for all channels",
        ),
        (
            layered(&THREE, [0.0, 0.0, 1.0], [90.5, 170.5]),
            "parallel boundaries",
        ),
        (
            layered(&THREE, DEVIATED, [91.0, 170.5]),
            "exponent_reflection by products",
        ),
        (
            layered(&THREE, DEVIATED, [256.5, 256.0]),
            "exponent_transmission by products",
        ),
        (real().set("diffuse_weight", &[0.0]), "no diffuse part"),
        (real().set("specular_weight", &[0.0]), "no specular part"),
        (
            Description::new("phong").set("exponent", &[1.0]),
            "exponent by products",
        ),
        (microfacet("schlick"), "isotropic"),
        (
            microfacet("dielectric").set("eta", &[1.5]),
            "isotropic, one index for all channels, what enters the facets is absorbed, as this model \
             only reflects",
        ),
        (gold(), of_gold),
        (gold().set("anisotropy", &[0.5]), "conductor by polynomials"),
        (gold().choose("masking", "kelemen"), of_gold),
        (gold().choose("distribution", "beckmann"), of_gold),
        (
            microfacet("conductor").set("k", &[0.01]).set("eta", &[0.6]),
            "isotropic",
        ),
    ]
}

#[test]
fn what_is_specialised_is_told_and_equal_to_single_calls() {
    for (number, (description, plan)) in specialised().into_iter().enumerate() {
        let bsdf = Bsdf::<f32>::new(&description).unwrap();
        let found = bsdf.plan();
        let (terms, batches) = found.split_once("; batches by ").unwrap();
        assert_eq!(terms, plan, "{description:?}");
        assert_eq!(batches, Level::widest().name(), "{description:?}");
        check_eval(&description, &[], number as u64);
        check_sample(&description, &[], number as u64);
    }
}

/// Values of a specialised surface are those of the double-precision instance, which takes the long way for
/// conductors; its worst error is that of a power of 256 factors.
#[test]
fn what_is_specialised_keeps_its_digits() {
    for (number, (description, plan)) in specialised().into_iter().enumerate() {
        let single = Bsdf::<f32>::new(&description).unwrap();
        let double = Bsdf::<f64>::new(&description).unwrap();
        let mut rng = rng(number as u64);
        for _ in 0..20_000 {
            let wo = hemisphere(&mut rng).as_vec3();
            // Near the mirror direction, where the lobes are.
            let near = hemisphere(&mut rng).as_vec3() * rng.random_range(0.0..0.5);
            let wi = (Vec3::new(-wo.x, -wo.y, wo.z) + near).normalize();
            let found = single.value(wo, wi, None);
            let exact = double.value(wo.as_dvec3(), wi.as_dvec3(), None);
            for channel in 0..3 {
                let error = (f64::from(found[channel]) - exact[channel]).abs();
                let allowed = 5e-5 * exact[channel] + 1e-6;
                assert!(error <= allowed, "{plan}: {wo} {wi}: {found:?} {exact:?}");
            }
        }
    }
}
