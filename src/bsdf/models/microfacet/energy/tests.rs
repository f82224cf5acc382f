//! The table against quadrature over normals, and against closed forms.

use super::super::ggx::Ggx;
use super::super::masking::Masking;
use super::*;

/// GGX with height-correlated masking.
fn ggx(alpha: f64, wo: Vec3<f64>, u: [f64; 2]) -> Reflected<f64> {
    Reflected::by_ndf(&Ggx::isotropic(alpha), Masking::Smith, [alpha; 2], wo, u)
}

/// The two albedos by their definitions, with normals sampled by D h.z instead of visible normals: the mean
/// of G2 <wo, h> / (wo.z h.z) over tan^2 = alpha^2 u / (1 - u) (Walter et al. 2007, eq. 35) and the
/// azimuth.
fn by_quadrature(alpha: f64, cosine: f64, nodes: u32) -> [f64; 2] {
    let sine = (1.0 - cosine * cosine).sqrt();
    let lambda = |z: f64| ((1.0 + alpha * alpha * (1.0 / (z * z) - 1.0)).sqrt() - 1.0) / 2.0;
    let mut sums = [0.0; 2];
    for i in 0..nodes {
        // Nodes are denser at both ends: u = t^2 (3 - 2 t).
        let t = (f64::from(i) + 0.5) / f64::from(nodes);
        let u = t * t * (3.0 - 2.0 * t);
        let weight = 6.0 * t * (1.0 - t) / f64::from(nodes).powi(2);
        let tangent = alpha * (u / (1.0 - u)).sqrt();
        let z = 1.0 / (1.0 + tangent * tangent).sqrt();
        for j in 0..nodes {
            let azimuth = std::f64::consts::PI * (f64::from(j) + 0.5) / f64::from(nodes);
            let dot = z * (cosine + sine * tangent * azimuth.cos());
            let wi = 2.0 * dot * z - cosine;
            if dot > 0.0 && wi > 0.0 {
                let masking = 1.0 / (1.0 + lambda(cosine) + lambda(wi));
                let part = weight * masking * dot / (cosine * z);
                sums[0] += part;
                sums[1] += part * (1.0 - dot).powi(5);
            }
        }
    }
    sums
}

const ALPHAS_TRIED: [f64; 12] = [
    1e-4, 3e-4, 2e-3, 0.0114, 0.03, 0.09, 0.2, 0.37, 0.55, 0.72, 0.9, 1.0,
];

/// Cosines between the nodes of the table.
fn cosines_tried(alpha: f64) -> Vec<f64> {
    let bend = BEND * alpha;
    let by_table = (0..2 * COSINES - 2).step_by(3).map(|i| {
        let x = ((f64::from(i as u32) + 0.5) / (2 * COSINES - 2) as f64).powi(2);
        bend * x / (1.0 + bend - x)
    });
    by_table.chain([0.02, 0.1, 0.35, 0.7, 0.93, 1.0]).collect()
}

/// The bound that the module states.
#[test]
fn the_table_is_within_its_error() {
    let single = Energy::over_alpha(ggx).rounded::<f32>();
    let double = Energy::over_alpha(ggx);
    let (mut worst, mut of_truth) = ([0.0f64; 2], 0.0f64);
    for alpha in ALPHAS_TRIED {
        let fixed = Energy::of_alpha(alpha, |wo, u| ggx(alpha, wo, u));
        for cosine in cosines_tried(alpha) {
            let truth = by_quadrature(alpha, cosine, 700);
            if cosine > 0.3 && alpha > 0.3 {
                let finer = by_quadrature(alpha, cosine, 1400);
                of_truth = of_truth.max((truth[0] - finer[0]).abs());
            }
            let from_single = single.albedo(&single.row(alpha as f32), cosine as f32);
            let from_single = [from_single.whole, from_single.grazing].map(f64::from);
            let [from_double, from_fixed] = [&double, &fixed]
                .map(|energy| energy.albedo(&energy.row(alpha), cosine))
                .map(|albedo| [albedo.whole, albedo.grazing]);
            for found in [from_single, from_double, from_fixed] {
                for k in 0..2 {
                    let error = (found[k] - truth[k]).abs();
                    assert!(error <= 1e-3, "{alpha} {cosine} {k}: {found:?} {truth:?}");
                    worst[k] = worst[k].max(error);
                }
            }
        }
    }
    println!("worst {worst:?}; quadrature itself {of_truth:.1e}");
}

/// For alpha = 1 and a viewer along the normal, wi.z = 1 - 2 u and G1 = 2 z / (1 + z), so that E is
/// the integral of z / (1 + z) over z in [0, 1].
#[test]
fn the_albedo_has_its_closed_value() {
    let energy = Energy::over_alpha(ggx);
    let found = energy.albedo(&energy.row(1.0), 1.0).whole;
    let expected = 1.0 - std::f64::consts::LN_2;
    assert!((found - expected).abs() < 1e-4, "{found} {expected}");
}

/// A mirror has the albedo 1 with F = 1, and (1 - mu)^5 with Schlick's term, whose mean is 1/21 (GH02 eq.
/// 12).
#[test]
fn the_smoothest_lobe_is_a_mirror() {
    let energy = Energy::over_alpha(ggx).rounded::<f32>();
    let row = energy.row(LEAST_ALPHA as f32);
    for i in 1..=100 {
        let cosine = i as f32 / 100.0;
        let albedo = energy.albedo(&row, cosine);
        assert!((albedo.whole - 1.0).abs() < 1e-3, "{cosine} {albedo:?}");
        let error = albedo.grazing - (1.0 - cosine).powi(5);
        assert!(error.abs() < 1e-3, "{cosine} {albedo:?}");
        let f = albedo.under_schlick(0.04, 0.5);
        let expected = 0.04 * (1.0 - (1.0 - cosine).powi(5)) + 0.5 * (1.0 - cosine).powi(5);
        assert!((f - expected).abs() < 1e-3);
    }
    assert!((row.mean.whole - 1.0).abs() < 1e-4);
    assert!((row.mean.grazing - 1.0 / 21.0).abs() < 2e-4);
}

/// The mean of the table agrees with quadrature and, ten times as exactly, with the mean of the table's own
/// albedo, which the normalisation of a coupled diffuse part needs.
#[test]
fn the_mean_is_that_of_the_albedo() {
    const COUNT: u32 = 60;
    let energy = Energy::over_alpha(ggx);
    for alpha in ALPHAS_TRIED {
        let row = energy.row(alpha);
        let (mut truth, mut own) = ([0.0; 2], [0.0; 2]);
        for i in 0..COUNT {
            let root = (f64::from(i) + 0.5) / f64::from(COUNT);
            let (cosine, weight) = (root * root, 4.0 * root.powi(3) / f64::from(COUNT));
            let value = by_quadrature(alpha, cosine, 300);
            let albedo = energy.albedo(&row, cosine);
            for (k, found) in [albedo.whole, albedo.grazing].into_iter().enumerate() {
                truth[k] += weight * value[k];
                own[k] += weight * found;
            }
        }
        let mean = [row.mean.whole, row.mean.grazing];
        for k in 0..2 {
            let errors = [mean[k] - truth[k], mean[k] - own[k]].map(f64::abs);
            println!("{alpha} {k}: {errors:?}");
            assert!(errors[0] < 1e-3 && errors[1] < 3e-4, "{alpha} {errors:?}");
        }
    }
}

/// Every result is in range for all alphas and cosines, even where the spline overshoots.
#[test]
fn results_are_in_range() {
    let energy = Energy::over_alpha(ggx).rounded::<f32>();
    for i in 0..=300 {
        let alpha = (1e-4f32).powf(i as f32 / 300.0);
        let row = energy.row(alpha);
        for j in 0..=300 {
            for cosine in [
                j as f32 / 300.0,
                10f32.powf(-38.0 * j as f32 / 300.0),
                1.001,
            ] {
                let albedo = energy.albedo(&row, cosine);
                let ordered = 0.0 <= albedo.grazing && albedo.grazing <= albedo.whole;
                assert!(
                    ordered && albedo.whole <= 1.0,
                    "{alpha} {cosine} {albedo:?}"
                );
            }
        }
    }
}

/// Making a table takes a few milliseconds. Samples are counted instead, because time on a busy machine
/// proves nothing.
#[test]
fn a_table_takes_its_stated_number_of_samples() {
    let count = std::cell::Cell::new(0);
    let counted = |alpha, wo, u| {
        count.set(count.get() + 1);
        ggx(alpha, wo, u)
    };
    Energy::over_alpha(counted);
    assert_eq!(count.replace(0), 105_560);
    Energy::of_alpha(0.3, |wo, u| counted(0.3, wo, u));
    assert_eq!(count.get(), 7_540);
}
