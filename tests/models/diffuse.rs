//! The rough diffuse models: closed values, the definitions evaluated independently, another
//! package's numbers, and the limits that their documentation states.

use crate::common::calls::Calls;
use crate::common::quadrature::Patch;
use crate::common::{degrees, hemisphere, rng};
use glam::DVec3;
use pellicle::{Bsdf, Description};
use rand::RngExt;
use std::f64::consts::{FRAC_PI_2, PI};

fn oren_nayar(reflectance: f32, sigma: f32, form: &str) -> Bsdf<f64> {
    let description = Description::new("oren_nayar")
        .set("reflectance", &[reflectance])
        .set("sigma_radians", &[sigma])
        .choose("form", form);
    Bsdf::new(&description).unwrap()
}

fn disney(reflectance: f32, roughness: f32) -> Bsdf<f64> {
    let description = Description::new("disney_diffuse")
        .set("reflectance", &[reflectance])
        .set("roughness", &[roughness]);
    Bsdf::new(&description).unwrap()
}

/// The integral of the value over the hemisphere, adaptively.
fn albedo(bsdf: &Bsdf<f64>, wo: DVec3) -> f64 {
    let cells = (0..64).map(|n| Patch::cell(n / 8, n % 8, 8, 8));
    cells
        .map(|cell| cell.integrate(&|wi| [bsdf.value(wo, wi, None)[0]], 1e-7, 8)[0])
        .sum()
}

/// Near the horizon, where both families have their greatest albedo.
fn horizon() -> DVec3 {
    degrees(89.99, 0.0)
}

/// sigma = 0 is `lambert` in either form.
#[test]
fn smooth_facets_are_lambert() {
    let lambert: Bsdf<f64> =
        Bsdf::new(&Description::new("lambert").set("reflectance", &[0.7])).unwrap();
    let mut rng = rng(1);
    for form in ["full", "qualitative"] {
        let bsdf = oren_nayar(0.7, 0.0, form);
        for _ in 0..1000 {
            let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
            let (found, expected) = (bsdf.value(wo, wi, None)[0], lambert.value(wo, wi, None)[0]);
            assert!((found - expected).abs() < 1e-15, "{form} {wo} {wi}");
        }
    }
}

/// The paper's formulas in its own variables, angles in radians: pi f / rho.
fn by_the_paper(form: &str, rho: f64, sigma: f64, wo: DVec3, wi: DVec3) -> f64 {
    let (theta_r, theta_i) = (wo.z.acos(), wi.z.acos());
    let difference = (wo.y.atan2(wo.x) - wi.y.atan2(wi.x)).cos();
    let (alpha, beta) = (theta_r.max(theta_i), theta_r.min(theta_i));
    let s = sigma * sigma;
    let c1 = 1.0 - 0.5 * s / (s + 0.33);
    if form == "qualitative" {
        let b = 0.45 * s / (s + 0.09);
        return c1 + b * difference.max(0.0) * alpha.sin() * beta.tan();
    }
    let c2 = if difference >= 0.0 {
        0.45 * s / (s + 0.09) * alpha.sin()
    } else {
        0.45 * s / (s + 0.09) * (alpha.sin() - (2.0 * beta / PI).powi(3))
    };
    let c3 = 0.125 * s / (s + 0.09) * (4.0 * alpha * beta / (PI * PI)).powi(2);
    let l1 = c1
        + difference * c2 * beta.tan()
        + (1.0 - difference.abs()) * c3 * ((alpha + beta) / 2.0).tan();
    let l2 = 0.17 * rho * s / (s + 0.13) * (1.0 - difference * (2.0 * beta / PI).powi(2));
    (l1 + l2).max(0.0)
}

#[test]
fn oren_nayar_is_the_papers() {
    let mut rng = rng(2);
    for form in ["full", "qualitative"] {
        for _ in 0..5000 {
            let (rho, sigma) = (rng.random::<f32>(), rng.random_range(0.0..1.57f32));
            let bsdf = oren_nayar(rho, sigma, form);
            let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
            let (rho, sigma) = (f64::from(rho), f64::from(sigma));
            let expected = rho / PI * wi.z * by_the_paper(form, rho, sigma, wo, wi);
            let found = bsdf.value(wo, wi, None)[0];
            // 1e-11: the angles of single calls have 12 digits.
            assert!(
                (found - expected).abs() < 1e-11 * (1.0 + expected),
                "{form} {rho} {sigma} {wo} {wi}: {found} {expected}"
            );
        }
    }
}

/// Along the normal cos phi drops out: full C1 + 0.17 rho s / (s + 0.13), qualitative C1. At the
/// horizon the qualitative form gives C1 + B / 2, as the mean of max(0, cos phi) sin b over the
/// hemisphere is 1 / 2 without a cosine: sin b tan b cos b = sin^2 b, whose integral is pi / 4.
#[test]
fn oren_nayar_has_closed_albedos() {
    for sigma in [0.1f32, 0.35, 0.8, 1.5] {
        let s = f64::from(sigma).powi(2);
        let rho = f64::from(0.6f32);
        let c1 = 1.0 - 0.5 * s / (s + 0.33);
        let full = rho * (c1 + 0.17 * rho * s / (s + 0.13));
        let at_normal = albedo(&oren_nayar(0.6, sigma, "full"), DVec3::Z);
        assert!((at_normal - full).abs() < 1e-6, "{at_normal} {full}");
        let qualitative = oren_nayar(0.6, sigma, "qualitative");
        assert!((albedo(&qualitative, DVec3::Z) - rho * c1).abs() < 1e-6);
        let expected = rho * (c1 + 0.5 * 0.45 * s / (s + 0.09));
        let found = albedo(&qualitative, horizon());
        assert!((found - expected).abs() < 1e-4, "{found} {expected}");
    }
}

/// The two forms' difference that the documentation states: of the albedo, full less qualitative, and
/// of pi f |wi.z| / reflectance at any two directions.
#[test]
fn the_forms_differ_as_stated() {
    let mut rng = rng(3);
    for (rho, sigma, of_albedo, of_value) in [
        (0.5f32, 0.35f32, [-0.007, 0.021], [-0.132, 0.135]),
        (0.9, 0.35, [0.017, 0.067], [-0.106, 0.137]),
        (0.9, FRAC_PI_2 as f32, [0.047, 0.131], [-0.161, 0.230]),
    ] {
        let [full, qualitative] = ["full", "qualitative"].map(|form| oren_nayar(rho, sigma, form));
        let mut albedos = [f64::MAX, f64::MIN];
        for theta in [0.0, 20.0, 40.0, 60.0, 70.0, 75.0, 85.0, 89.0] {
            let wo = degrees(theta, 0.0);
            let difference = albedo(&full, wo) - albedo(&qualitative, wo);
            albedos = [albedos[0].min(difference), albedos[1].max(difference)];
        }
        let mut values = [f64::MAX, f64::MIN];
        for _ in 0..300_000 {
            let (wo, wi) = (hemisphere(&mut rng), hemisphere(&mut rng));
            let difference = full.value(wo, wi, None)[0] - qualitative.value(wo, wi, None)[0];
            let difference = difference * PI / f64::from(rho);
            values = [values[0].min(difference), values[1].max(difference)];
        }
        println!("{rho} {sigma} albedo {albedos:.4?} value {values:.4?}");
        for k in 0..2 {
            assert!((albedos[k] - of_albedo[k]).abs() < 1e-3, "{albedos:?}");
            // Random directions come close to the extremes.
            assert!((values[k] - of_value[k]).abs() < 2e-2, "{values:?}");
        }
    }
}

/// The greatest albedo for reflectance 1, and up to which sigma it exceeds 1.
#[test]
fn oren_nayar_exceeds_1_as_stated() {
    for (form, greatest, last) in [("full", 1.051, 0.62), ("qualitative", 1.0155, 0.32)] {
        let albedos = (1..=50).map(|i| {
            let sigma = i as f32 * 0.02;
            (sigma, albedo(&oren_nayar(1.0, sigma, form), horizon()))
        });
        let albedos: Vec<_> = albedos.collect();
        let worst = albedos
            .iter()
            .fold(0.0, |worst, (_, a)| f64::max(worst, *a));
        assert!((worst - greatest).abs() < 1e-3, "{form} {worst}");
        for (sigma, albedo) in albedos {
            assert_eq!(albedo > 1.0, sigma < last + 0.01, "{form} {sigma} {albedo}");
        }
        // It is greatest at the horizon, and nowhere above 1 for a reflectance of 0.95.
        for theta in [0.0, 30.0, 60.0, 80.0, 89.0, 89.99] {
            let wo = degrees(theta, 0.0);
            assert!(albedo(&oren_nayar(1.0, 0.3, form), wo) <= worst + 1e-6);
            for sigma in [0.1, 0.2, 0.3, 0.4, 0.6] {
                assert!(albedo(&oren_nayar(0.95, sigma, form), wo) <= 1.0);
            }
        }
    }
}

/// The full fit is negative where light and viewer graze the surface from opposite sides, from
/// sigma = 0.67 on; then the value is 0, and never before.
#[test]
fn oren_nayar_is_held_at_0_as_stated() {
    let least = |sigma: f32| {
        let bsdf = oren_nayar(0.01, sigma, "full");
        let values = (0..=900).map(|i| {
            let theta = f64::from(i) / 10.0 * 0.9999;
            bsdf.value(degrees(theta, 0.0), degrees(theta, 180.0), None)[0]
        });
        values.fold(f64::MAX, f64::min)
    };
    assert!(least(0.6) > 0.0 && least(0.66) > 0.0);
    assert!(least(0.69) == 0.0 && least(1.5) == 0.0);
}

/// Burley's form expanded by hand along the normal, where one factor is 1: the mean of
/// 1 + (roughness (1 + z) - 1/2) (1 - z)^5 is 1 + (roughness - 1/2) / 21 + roughness / 84; and at the
/// horizon, 41/84 + roughness + 5/72 roughness^2.
#[test]
fn disney_has_closed_albedos() {
    for roughness in [0.0f32, 0.25, 0.5, 1.0] {
        let bsdf = disney(1.0, roughness);
        let r = f64::from(roughness);
        let expected = 1.0 + (r - 0.5) / 21.0 + r / 84.0;
        let found = albedo(&bsdf, DVec3::Z);
        assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        let expected = 41.0 / 84.0 + r + 5.0 / 72.0 * r * r;
        let found = albedo(&bsdf, degrees(89.9999, 0.0));
        assert!((found - expected).abs() < 1e-4, "{found} {expected}");
    }
}

/// Mitsuba 3.9.1, whose `principled` has Burley's diffuse term (in the expanded form of Burley 2015)
/// alone if metallic and specular are 0. Values for base colour 0.8, printed by
///
/// ```python
/// import mitsuba as mi
/// from math import sin, cos, radians
/// mi.set_variant("scalar_rgb")
/// def d(t, p):
///     t, p = radians(t), radians(p)
///     return mi.Vector3f(sin(t) * cos(p), sin(t) * sin(p), cos(t))
/// for r in (0.0, 0.3, 1.0):
///     b = mi.load_dict({"type": "principled", "base_color": {"type": "rgb", "value": [.8, .5, .2]},
///                       "metallic": 0.0, "specular": 0.0, "roughness": r})
///     for wo, wi in (((20, 0), (35, 150)), ((60, 10), (55, 200)), ((75, 0), (40, 30)), ((5, 0), (80, 90))):
///         si = mi.SurfaceInteraction3f()
///         si.wi = d(*wo)
///         si.sh_frame = mi.Frame3f(mi.Vector3f(0, 0, 1))
///         print(r, wo, wi, b.eval(mi.BSDFContext(), si, d(*wi))[0])
/// ```
#[test]
fn disney_has_mitsubas_values() {
    let pairs = [
        ((20.0, 0.0), (35.0, 150.0)),
        ((60.0, 10.0), (55.0, 200.0)),
        ((75.0, 0.0), (40.0, 30.0)),
        ((5.0, 0.0), (80.0, 90.0)),
    ];
    let values = [
        (0.0, [0.2085751, 0.1427642, 0.1731944, 0.03569982]),
        (0.3, [0.2085945, 0.1439236, 0.1959817, 0.04169566]),
        (1.0, [0.2086399, 0.1466445, 0.2492164, 0.05568595]),
    ];
    for (roughness, values) in values {
        let bsdf = disney(0.8, roughness);
        for ((wo, wi), expected) in pairs.into_iter().zip(values) {
            let found = bsdf.value(degrees(wo.0, wo.1), degrees(wi.0, wi.1), None)[0];
            let error: f64 = found / expected - 1.0;
            assert!(error.abs() < 1e-6, "{roughness}: {found} {expected}");
        }
    }
}

/// What the documentation says of reflectance 1.
#[test]
fn disney_exceeds_1_as_stated() {
    let greatest = |roughness: f32| {
        let bsdf = disney(1.0, roughness);
        let angles = [0.0, 50.0, 60.0, 70.0, 75.0, 80.0, 85.0, 88.0, 89.99];
        let albedos = angles.map(|theta| albedo(&bsdf, degrees(theta, 0.0)));
        albedos.into_iter().fold(0.0, f64::max)
    };
    assert!(greatest(0.39) < 1.0 && greatest(0.41) > 1.0);
    assert!((greatest(1.0) - 1.557).abs() < 1e-3);
    assert!((albedo(&disney(1.0, 1.0), DVec3::Z) - 1.036).abs() < 1e-3);
}
