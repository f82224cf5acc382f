//! The distributions whose masking, and for two of them sampling, is a table: `blinn_phong`, `abc` and
//! `sgd` of the `microfacet` model. The truth is integrals of D, closed forms of distributions
//! that they coincide with, and numbers computed with mpmath.

use super::tails::*;
use crate::common;
use crate::common::calls::Calls;
use crate::common::{rng, rounded, uniforms};
use glam::{DVec3, Vec3};
use pellicle::Bsdf;
use rand::RngExt;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use statrs::function::erf::erf;
use std::f64::consts::PI;

#[test]
fn projected_area_is_one_and_height_as_documented() {
    let mut worst: f64 = 0.0;
    for surface in Surface::all() {
        let density = surface.density::<f64>();
        let error = (area(&density, range(surface.alpha)) - 1.0).abs();
        worst = worst.max(error);
        assert!(error < 1e-9, "{surface:?}: 1 + {error:e}");
        let height = density(DVec3::Z) * PI * f64::from(surface.alpha).powi(2);
        assert!((height - 1.0).abs() < 1e-12, "{surface:?}: {height}");
    }
    println!("worst {worst:.1e}");
}

#[test]
fn smith_masking_is_the_visible_area() {
    let mut worst: f64 = 0.0;
    for surface in Surface::all() {
        let (density, masking) = (surface.density::<f64>(), surface.masking::<f64>());
        for w in viewers(surface.alpha) {
            let truth = w.z / visible_area(&density, w, range(surface.alpha));
            let error = (masking(w) / truth - 1.0).abs();
            worst = worst.max(error);
            assert!(error < 1e-7, "{surface:?} {w}: {error:e}");
        }
    }
    println!("worst {worst:.1e}");
}

/// The table's pieces neither leave [0, 1] nor turn back; single precision may by its rounding.
#[test]
fn smith_masking_rises_with_the_cosine() {
    for surface in Surface::all() {
        let (single, double) = (surface.masking::<f32>(), surface.masking::<f64>());
        let (mut last, mut last_single) = (0.0, 0.0);
        for k in 0..4000 {
            let tangent = (25.0 - 0.011 * f64::from(k)).exp();
            let found = double(over_x(tangent));
            assert!(found >= last - 1e-15, "{surface:?} {tangent}");
            assert!(
                (0.0..=1.0 + 1e-15).contains(&found),
                "{surface:?} {tangent}"
            );
            last = found;
            let found = single(over_x(tangent).as_vec3());
            assert!(found >= last_single * (1.0 - 1e-6), "{surface:?} {tangent}");
            assert!((0.0..=1.0 + 3e-7).contains(&found), "{surface:?} {tangent}");
            last_single = found;
        }
        assert!(last > 1.0 - 1e-6);
    }
}

/// sgd with p = 0 is Beckmann's distribution, whose Lambda is Heitz 2014, eq. 61. Every distribution
/// is even at alpha = 1 but sgd, and so is GGX, whose Lambda is (1 / cos - 1) / 2 there.
#[test]
fn closed_forms_are_met() {
    for alpha in ALPHAS {
        let surface = Surface {
            distribution: "sgd",
            shape: 0.0,
            alpha,
        };
        let squared = f64::from(alpha).powi(2);
        let (density, masking) = (surface.density::<f64>(), surface.masking::<f64>());
        for w in viewers(alpha) {
            let (tangent, a) = (w.x / w.z, w.z / w.x / f64::from(alpha));
            let lambda = (erf(a) - 1.0) / 2.0 + (-a * a).exp() / (2.0 * a * PI.sqrt());
            let error = masking(w) * (1.0 + lambda) - 1.0;
            assert!(error.abs() < 1e-7, "alpha = {alpha} {w}: {error:e}");
            let expected = (-tangent * tangent / squared).exp() / (PI * squared * w.z.powi(4));
            // Its width is found to 1.2e-11.
            let tolerance = 2e-11 * (1.0 + tangent * tangent / squared) * expected;
            let error = (density(w) - expected).abs();
            assert!(error <= tolerance, "alpha = {alpha} {w}: {error:e}");
        }
    }
    for surface in Surface::all() {
        if surface.alpha == 1.0 && surface.distribution != "sgd" {
            let (density, masking) = (surface.density::<f64>(), surface.masking::<f64>());
            for w in viewers(1.0) {
                assert!((density(w) * PI - 1.0).abs() < 1e-12, "{surface:?} {w}");
                let error = masking(w) * (0.5 / w.z + 0.5) - 1.0;
                assert!(error.abs() < 1e-8, "{surface:?} {w}: {error:e}");
            }
        }
    }
}

/// Orientation only: Walter et al. 2007, section 5.2, take Beckmann's G1, by their eq. 27, with
/// a = sqrt(e / 2 + 1) / tan for a power e. It is an approximation of the exact one: 0.003 off for
/// narrow lobes, 0.014 for alpha = 0.3, 0.06 for 0.6, 0.22 for 1.
#[test]
fn blinn_phong_masking_is_near_the_usual_approximation() {
    for (alpha, bound) in ALPHAS
        .into_iter()
        .zip([4e-3, 4e-3, 4e-3, 4e-3, 0.02, 0.08, 0.3])
    {
        let surface = Surface {
            distribution: "blinn_phong",
            shape: 0.0,
            alpha,
        };
        let masking = surface.masking::<f64>();
        let mut worst: f64 = 0.0;
        for w in viewers(alpha) {
            let exponent = 2.0 / f64::from(alpha).powi(2) - 2.0;
            let a = (exponent / 2.0 + 1.0).sqrt() * w.z / w.x;
            let rational = (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a);
            let approximation = if a < 1.6 { rational } else { 1.0 };
            worst = worst.max((masking(w) - approximation).abs());
        }
        println!("alpha = {alpha}: {worst:.1e}");
        assert!(worst < bound, "alpha = {alpha}: {worst}");
    }
}

/// By mpmath 1.4.1 at 30 digits (`python reference.py` in an environment with `pip install mpmath`):
///
/// ```python
/// from mpmath import *
/// mp.dps = 30
/// def sgd(alpha, p):  # Bagher et al. 2012 in their notation
///     f = lambda la: (1 + p) * la + exp(la) + log(gammainc(1 - p, exp(la))) - 2 * log(alpha)
///     a = exp(findroot(f, (2 * log(alpha) - 1, mpf(1)), solver='anderson'))
///     K = 1 / (a * gammainc(1 - p, a))
///     return lambda t: K * exp(-(a + t * t / a)) * (a + t * t / a) ** -p / pi * (1 + t * t) ** 2
/// def abc(alpha, C):  # 2 times the integral of (1 - u) / (1 + B u)^C is 2F1(C, 1; 3; -B)
///     f = lambda b: log(hyp2f1(C, 1, 3, -exp(b))) - 2 * log(alpha)
///     B = exp(findroot(f, (mpf(-5), mpf(38)), solver='anderson'))
///     A = 1 / (pi * quad(lambda u: 2 * (1 - u) * (1 + B * u) ** -C, [0] + [10 ** mpf(k) for k in range(-16, 1)]))
///     return lambda t: A * (1 + B * (1 - 1 / sqrt(1 + t * t))) ** -C
/// def G1(D, alpha, theta):
///     s, c = sin(theta), cos(theta)
///     def ring(x):
///         t = exp(x); cb = 1 / sqrt(1 + t * t); sb = t * cb
///         e = pi if s * t <= c else acos(-c / (s * t))
///         return 2 * (e * c * cb + sin(e) * s * sb) * D(t) * sb * t * cb ** 2
///     edges = sorted([mpf(x) for x in range(int(log(alpha)) - 24, 24, 2)] + [log(c / s)])
///     return c / quad(ring, edges)
/// ```
///
/// with alpha rounded to single precision, but not in the tangents. A row is alpha; p or C; D at
/// tan = 0, alpha, 5 alpha and 1; G1 at 45, 80 and 89 degrees.
const SGD: &str = "
    0.0001 0.75 31830990.2266 1534048.0515 136497.044649 0.0 1.0 1.0 1.0
    0.01 0.5 3183.09900413 446.173975427 18.5766056449 0.0 1.0 1.0 0.8920080197
    0.125 1.25 20.3718327158 5.70185767235 0.00874403497474 1.42351561201e-5 0.9999999964 0.9686078936 0.3124545345
    0.5 0.5 1.27323954474 0.669854563178 1.90069253677e-6 0.158226728183 0.9990676786 0.6866636997 0.1084856125
    1.0 3.0 0.318309886184 0.44768692535 7.90228450297e-6 0.44768692535 0.9696879728 0.4534053907 0.05800474216
";
const ABC: &str = "
    0.0001 1.25 31830990.2266 4291396.20537 100400.334787 0.00110899779588 0.999771752 0.9947008602 0.9015308906
    0.01 0.5 3183.09900413 16.882276155 3.37953741776 0.220572398531 0.9177866475 0.4431737087 0.0581739945
    0.125 1.0 20.3718327158 3.12564699693 0.185859540362 0.0968800008406 0.9756257181 0.6792665098 0.1190615807
    0.5 2.0 1.27323954474 0.531379402804 0.0700761604134 0.200473788009 0.9653998278 0.5495447707 0.07719922769
    0.75 8.0 0.565884242105 0.372601001682 0.132457542828 0.309079657921 0.9220895137 0.4160855829 0.05227304279
";

#[test]
fn independent_numbers_are_met() {
    let (mut worst_density, mut worst_masking): (f64, f64) = (0.0, 0.0);
    let rows = |name, table: &'static str| table.trim().lines().map(move |row| (name, row));
    for (distribution, row) in rows("sgd", SGD).chain(rows("abc", ABC)) {
        let row: Vec<f64> = row.split_whitespace().map(|n| n.parse().unwrap()).collect();
        let [alpha, shape, ref densities @ .., g45, g80, g89] = row[..] else {
            panic!("nine numbers to a row: {row:?}");
        };
        let surface = Surface {
            distribution,
            shape: shape as f32,
            alpha: alpha as f32,
        };
        let density = surface.density::<f64>();
        let tangents = [0.0, alpha, 5.0 * alpha, 1.0];
        for (tangent, expected) in tangents.into_iter().zip(densities.iter().copied()) {
            let error = (density(over_x(tangent)) - expected).abs() / expected.max(1e-200);
            worst_density = worst_density.max(error);
            assert!(error < 1e-9, "{surface:?} tan = {tangent}: {error:e}");
        }
        let masking = surface.masking::<f64>();
        for (degrees, expected) in [(45.0, g45), (80.0, g80), (89.0, g89)] {
            let error = (masking(common::degrees(degrees, 0.0)) / expected - 1.0).abs();
            worst_masking = worst_masking.max(error);
            assert!(error < 1e-7, "{surface:?} at {degrees}: {error:e}");
        }
    }
    println!("D {worst_density:.1e}, G1 {worst_masking:.1e}");
}

/// Directions half of which are near the normal, half anywhere, so that both are in the tail and in
/// the tip.
#[test]
fn single_precision_is_near_double() {
    let mut rng = rng(7);
    let (mut worst_density, mut worst_masking): (f64, f64) = (0.0, 0.0);
    for surface in Surface::all() {
        let (single, double) = (surface.density::<f32>(), surface.density::<f64>());
        let (single_masking, double_masking) = (surface.masking::<f32>(), surface.masking::<f64>());
        for _ in 0..2000 {
            let [least, most] = [1e-3 * f64::from(surface.alpha), 1e4].map(f64::ln);
            let tangent = rng.random_range(least..most).exp();
            let turn = rng.random_range(0.0..2.0 * PI);
            let h = over_x(tangent);
            let (h32, h64) = rounded(DVec3::new(h.x * turn.cos(), h.x * turn.sin(), h.z));
            let (found, expected) = (f64::from(single(h32)), double(h64));
            // The exponent of e is rounded, so the error grows with it; e^-87 is single precision's
            // least power.
            let least = 1e-31 * double(DVec3::Z);
            let exponent = (double(DVec3::Z) / expected.max(least)).ln().abs();
            let error = (found - expected).abs() / expected.max(least) / (1.0 + exponent);
            worst_density = worst_density.max(error);
            assert!(
                error < 1e-6,
                "{surface:?} {h32}: {found:e}, not {expected:e}"
            );
            let error = f64::from(single_masking(h32)) / double_masking(h64) - 1.0;
            worst_masking = worst_masking.max(error.abs());
            assert!(error.abs() < 2e-6, "{surface:?} {h32}: {error:e}");
        }
    }
    println!("D {worst_density:.1e} per e-fold, G1 {worst_masking:.1e}");
}

const SAMPLES: u32 = 200_000;
const RINGS: usize = 16;
const SECTORS: usize = 4;

/// From straight above, the half vector's slope is the sine of wi over 1 + its cosine. Rings of nearly
/// equal area are found by bisection of the integrated density; slopes above 1 send light below the
/// horizon and are one cell. The cells are few, so that tan^2 off by 2 % is found out. The density that
/// sample() reports is D / 4.
#[test]
fn samples_have_the_density_of_normals() {
    let surfaces: Vec<_> = Surface::all().collect();
    // Sidak: the whole file fails by chance once in a thousand runs.
    let level = 1.0 - 0.999f64.powf(1.0 / surfaces.len() as f64);
    let mut least: f64 = 1.0;
    for (seed, surface) in surfaces.into_iter().enumerate() {
        let density = surface.density::<f64>();
        let [lowest, _] = range(surface.alpha);
        let total = area(&density, [lowest, 0.0]);
        let mut edges = vec![lowest];
        for ring in 1..RINGS {
            let share = total / RINGS as f64;
            let from = edges[ring - 1];
            let (mut low, mut high) = (from, 0.0);
            for _ in 0..16 {
                let middle = (low + high) / 2.0;
                let part = area(&density, [from, middle]);
                *(if part < share { &mut low } else { &mut high }) = middle;
            }
            edges.push((low + high) / 2.0);
        }
        let bsdf: Bsdf = surface.bsdf("smith");
        let mut rng = rng(seed as u64);
        let mut counts = [[0.0; SECTORS]; RINGS];
        for n in 0..SAMPLES {
            let sample = bsdf.sampled(Vec3::Z, Vec3::from(uniforms(&mut rng)), None);
            if sample.pdf == 0.0 {
                continue;
            }
            let wi = sample.wi.as_dvec3();
            let slope = wi.truncate().length() / (1.0 + wi.z);
            let ring = edges.partition_point(|edge| *edge <= slope.ln()).max(1) - 1;
            let turn = wi.y.atan2(wi.x) / (2.0 * PI) + 1.0;
            counts[ring][(turn * SECTORS as f64) as usize % SECTORS] += 1.0;
            if n % 16 == 0 {
                let expected = density(over_x(slope)) / 4.0;
                let error = f64::from(sample.pdf) / expected - 1.0;
                assert!(error.abs() < 1e-5, "{surface:?} {slope}: {error:e}");
            }
        }
        edges.push(0.0);
        let (mut statistic, mut missing) = (0.0, f64::from(SAMPLES));
        let mut observed_missing = f64::from(SAMPLES);
        for (ring, counts) in counts.iter().enumerate() {
            let share = area(&density, [edges[ring], edges[ring + 1]]);
            let expected = f64::from(SAMPLES) * share / SECTORS as f64;
            for count in counts {
                statistic += (count - expected).powi(2) / expected;
                missing -= expected;
                observed_missing -= count;
            }
        }
        let mut cells = RINGS * SECTORS;
        if missing > 5.0 {
            statistic += (observed_missing - missing).powi(2) / missing;
            cells += 1;
        } else {
            assert!(observed_missing < 25.0, "{surface:?}: {observed_missing}");
        }
        let p = ChiSquared::new((cells - 1) as f64).unwrap().sf(statistic);
        assert!(p > level, "{surface:?}: p = {p:e}");
        least = least.min(p);
    }
    println!("least p {least:.1e}, threshold {level:.1e}");
}
