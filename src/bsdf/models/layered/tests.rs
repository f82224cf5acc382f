//! The model against an independent double-precision evaluation of the paper's formulas.

use super::params::*;
use super::*;
use crate::bsdf::model::Model;
use crate::bsdf::values::Values;
use crate::num::{Lane, Vec3};

/// A direction from its polar angle and azimuth in degrees.
fn direction(theta: f64, phi: f64) -> Vec3<f64> {
    let (theta, phi) = (theta.to_radians(), phi.to_radians());
    Vec3::new(
        theta.sin() * phi.cos(),
        theta.sin() * phi.sin(),
        theta.cos(),
    )
}

struct Case {
    wi: (f64, f64),
    wo: (f64, f64),
    n1: (f64, f64),
    eta: [f64; 3],
    thickness_nm: f64,
    exponents: (f64, f64),
}

/// The specular terms R, T, Phi and rho of the variant `paper`.
fn terms(case: &Case) -> [[f64; 3]; 4] {
    let mut values = Values::defaults(&Layered::INFO);
    values.set_numbers(ETA, case.eta);
    values.set_numbers(THICKNESS_NM, [case.thickness_nm; 3]);
    values.set_numbers(EXPONENT_REFLECTION, [case.exponents.0; 3]);
    values.set_numbers(EXPONENT_TRANSMISSION, [case.exponents.1; 3]);
    values.set_numbers(BASE_NORMAL, direction(case.n1.0, case.n1.1).to_array());
    values.set_choice(VARIANT, VARIANT_PAPER);
    let prepared = LayeredSurface::<f64>::new(&values);
    let (wo, wi) = (
        direction(case.wo.0, case.wo.1),
        direction(case.wi.0, case.wi.1),
    );
    let shapes = prepared.shapes(&prepared.upper, wo, wi);
    let terms = prepared.terms(&prepared.upper, wo, wi, &shapes);
    [
        f64::channels(terms.reflected),
        f64::channels(terms.transmitted),
        f64::channels(terms.turns).map(|turns| turns * std::f64::consts::PI),
        f64::channels(terms.interference()),
    ]
}

fn assert_close(found: [f64; 3], expected: [f64; 3], what: &str) {
    for c in 0..3 {
        // The expected numbers carry 9 or 10 digits.
        let error = (found[c] / expected[c] - 1.0).abs();
        assert!(
            error < 1e-6,
            "{what}[{c}]: {} instead of {}",
            found[c],
            expected[c]
        );
    }
}

#[test]
fn parallel_boundaries_give_the_reference_terms() {
    let [r, t, phi, rho] = terms(&Case {
        wi: (30.0, 0.0),
        wo: (30.0, 180.0),
        n1: (0.0, 0.0),
        eta: [1.4, 1.45, 1.6],
        thickness_nm: 70.0,
        exponents: (90.0, 170.0),
    });
    assert_close(r, [0.027819742, 0.033777650, 0.053295302], "R");
    assert_close(t, [0.945174072, 0.933625117, 0.896288189], "T");
    assert_close(phi, [0.891694831, 1.140243784, 1.502186613], "Phi");
    assert_close(rho, [0.452282757, 0.367988482, 0.258287357], "rho");
}

#[test]
fn deviated_boundaries_give_the_reference_terms() {
    let [r, t, phi, rho] = terms(&Case {
        wi: (45.0, 20.0),
        wo: (50.0, 185.0),
        n1: (10.0, 0.0),
        eta: [1.5, 1.6, 1.8],
        thickness_nm: 90.0,
        exponents: (130.0, 130.0),
    });
    assert_close(r, [0.002253534, 0.002962006, 0.004478872], "R");
    assert_close(t, [3.397198478e-6, 4.785555093e-6, 8.056320841e-6], "T");
    assert_close(phi, [1.145227754, 1.529489487, 2.086678738], "Phi");
    assert_close(rho, [0.001070794, 0.001364744, 0.002145959], "rho");
}

#[test]
fn other_configurations_give_the_reference_rho() {
    let cases = [
        (
            Case {
                wi: (30.0, 0.0),
                wo: (25.0, 170.0),
                n1: (0.0, 0.0),
                eta: [1.4, 1.45, 1.6],
                thickness_nm: 70.0,
                exponents: (9.0, 17.0),
            },
            [0.424467583, 0.346664442, 0.248385238],
        ),
        (
            Case {
                wi: (60.0, 10.0),
                wo: (20.0, 200.0),
                n1: (14.0, 90.0),
                eta: [1.5, 1.6, 1.8],
                thickness_nm: 180.0,
                exponents: (3.0, 5.0),
            },
            [0.209157423, 0.333592106, 0.134917799],
        ),
        (
            Case {
                wi: (85.0, 0.0),
                wo: (85.0, 180.0),
                n1: (0.0, 0.0),
                eta: [1.5; 3],
                thickness_nm: 15.0,
                exponents: (90.0, 90.0),
            },
            [0.935467595, 0.922962756, 0.908586506],
        ),
    ];
    for (case, expected) in cases {
        assert_close(terms(&case)[3], expected, "rho");
    }
}

#[test]
fn thickness_gives_the_reference_diffuse_coefficient() {
    let rho_d = |eta, thickness| {
        let mut values = Values::defaults(&Layered::INFO);
        values.set_numbers(ETA, eta);
        values.set_numbers(THICKNESS_NM, [thickness; 3]);
        f64::channels(LayeredSurface::<f64>::new(&values).rho_d)
    };
    let old_metal = [1.506945410, 1.480631200, 1.450620590];
    assert_close(rho_d([1.5; 3], 15.0), old_metal, "rho_d");
    let colourful = [0.493054590, 0.451685610, 0.992987000];
    assert_close(rho_d([1.5, 1.6, 1.8], 92.5), colourful, "rho_d");
}

/// Mean of f over uniform values of its argument in (0, 1), by the midpoint rule.
fn mean_over_unit(f: impl Fn(f64) -> f64) -> f64 {
    const COUNT: u32 = 200_000;
    (0..COUNT)
        .map(|i| f((f64::from(i) + 0.5) / f64::from(COUNT)))
        .sum::<f64>()
        / f64::from(COUNT)
}

/// Eq. 12 and 13 against their definition, the cosine-weighted mean of Schlick's reflectance.
#[test]
fn the_mean_transmittance_is_the_mean_of_schlicks() {
    for (r0, r1) in [(1.0, 1.5), (1.0, 1.3), (1.33, 1.5), (1.0, 4.0)] {
        let f0 = crate::optics::normal_reflectance(r0, r1);
        let mean = mean_over_unit(|z| 2.0 * z * crate::optics::schlick_transmittance(f0, z));
        let closed = terms::average_transmittance(r0, r1);
        assert!((closed - mean).abs() < 1e-9, "{closed} {mean}");
    }
}

/// Eq. 14, which the model does not use because it takes the normal direction (eq. 15): the formula is
/// right, but the paper's number for an index of 1.5 is not.
#[test]
fn the_mean_refracted_cosine_is_not_as_printed() {
    let (r0, r1) = (1.0f64, 1.5f64);
    let logarithm = ((r1 + r0) / (r1 - r0)).ln();
    let printed = 0.25 * (logarithm * (r1 * r1 - r0 * r0) + 2.0 * r1 * r0) / (r1 * r0);
    let interface = crate::optics::Interface::new(r0, r1);
    let mean = mean_over_unit(|z| interface.inside(Vec3::new((1.0 - z * z).sqrt(), 0.0, z)).z);
    assert!((printed - mean).abs() < 1e-9, "{printed} {mean}");
    assert!((printed - 0.835).abs() < 5e-4, "{printed}");
}
