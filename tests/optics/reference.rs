//! The reference against closed forms and brute force: what every method of the library is later
//! measured with must itself be right, above all where the spectrum is finer than any fixed step.

use pellicle::num::Rgb;
use pellicle::optics::stack::{Layer, Side, Stack};
use pellicle::optics::{
    ChannelWeights, ColorSpace, Medium, Reference, TOLERANCE, VISIBLE_NM, White,
};

const SPACES: [ColorSpace; 4] = [
    ColorSpace::Rec709,
    ColorSpace::Rec2020,
    ColorSpace::AcesCg,
    ColorSpace::Xyz,
];

fn constant(eta: f64) -> Medium {
    Medium::rgb([eta; 3], [0.0; 3]).unwrap()
}

fn named(name: &str) -> Medium {
    Medium::named(name).unwrap()
}

fn reference(layers: &[Medium], base: Medium) -> Reference {
    let (white, space) = (White::E, ColorSpace::Rec709);
    Reference::new(Medium::vacuum(), layers.to_vec(), base, white, space).unwrap()
}

fn greatest_difference(a: Rgb<f64>, b: Rgb<f64>) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

/// The trapezoid rule with a fixed number of steps from 380 to 780 nm.
fn fixed_step(
    side: Side,
    steps: usize,
    layers: &[Medium],
    base: &Medium,
    cos_theta: f64,
    thickness_nm: &[f64],
) -> Rgb<f64> {
    let weights = ChannelWeights::new(White::E, ColorSpace::Rec709);
    let (mut sum, mut white) = ([0.0; 3], [0.0; 3]);
    for i in 0..=steps {
        let nm = VISIBLE_NM[0] + (VISIBLE_NM[1] - VISIBLE_NM[0]) * i as f64 / steps as f64;
        let end = if i == 0 || i == steps { 0.5 } else { 1.0 };
        let layers: Vec<_> = layers
            .iter()
            .zip(thickness_nm)
            .map(|(medium, &thickness_nm)| Layer {
                index: medium.index(nm),
                thickness_nm,
            })
            .collect();
        let stack = Stack {
            ambient: 1.0,
            layers: &layers,
            base: base.index(nm),
        };
        let reflectance = stack.respond(side, cos_theta, nm).unpolarized_reflectance();
        for (c, weight) in weights.at(nm).into_iter().enumerate() {
            white[c] += end * weight;
            sum[c] += end * weight * reflectance;
        }
    }
    std::array::from_fn(|c| sum[c] / white[c])
}

#[test]
fn a_perfect_mirror_is_one_and_nothing_is_zero() {
    for white in [White::E, White::D65] {
        for space in SPACES {
            // Total reflection is the one perfect mirror there is.
            let mirror =
                Reference::new(constant(1.5), vec![], Medium::vacuum(), white, space).unwrap();
            let found = mirror.evaluate(Side::Ambient, 0.3, &[]);
            assert!(
                greatest_difference(found.reflectance, [1.0; 3]) < 1e-14,
                "{found:?}"
            );
            assert!(
                greatest_difference(found.transmittance, [0.0; 3]) < 1e-14,
                "{found:?}"
            );

            let nothing = Reference::new(
                constant(1.5),
                vec![constant(1.5)],
                constant(1.5),
                white,
                space,
            );
            let found = nothing.unwrap().evaluate(Side::Ambient, 0.3, &[300.0]);
            assert_eq!(found.reflectance, [0.0; 3]);
            assert!(
                greatest_difference(found.transmittance, [1.0; 3]) < 1e-14,
                "{found:?}"
            );
        }
    }
}

#[test]
fn a_grey_interface_is_grey() {
    // Constant indices and no film: every channel is the Fresnel reflectance, ((1.5 - 1) / 2.5)^2.
    let found = reference(&[], constant(1.5)).evaluate(Side::Ambient, 1.0, &[]);
    assert!(
        greatest_difference(found.reflectance, [0.04; 3]) < 1e-15,
        "{found:?}"
    );
    assert!(
        greatest_difference(found.transmittance, [0.96; 3]) < 1e-15,
        "{found:?}"
    );
}

#[test]
fn converges_to_brute_force_where_fringes_are_narrow() {
    let soap = constant(1.33);
    let cases: [(&str, Medium, Medium, f64, f64); 13] = [
        ("soap", soap.clone(), constant(1.0), 0.7, 300.0),
        ("soap", soap.clone(), constant(1.0), 0.02, 1000.0),
        ("soap", soap.clone(), constant(1.0), 0.003, 1000.0),
        ("soap", soap.clone(), constant(1.0), 0.002, 1000.0),
        ("soap", soap.clone(), constant(1.0), 0.001, 700.0),
        ("soap", soap.clone(), constant(1.0), 1e-4, 1000.0),
        ("soap", soap.clone(), constant(1.0), 2e-3, 1.0),
        ("thick soap", soap.clone(), constant(1.0), 0.05, 1e4),
        (
            "index 4 on aluminium",
            constant(4.0),
            named("Al"),
            0.3,
            2500.0,
        ),
        (
            "index 4 on silver",
            constant(4.0),
            named("Ag"),
            0.05,
            3000.0,
        ),
        (
            "titania on titanium",
            named("TiO2"),
            named("Ti"),
            0.8,
            25_000.0,
        ),
        ("lacquer on aluminium", constant(1.5), named("Al"), 0.5, 1e5),
        ("silica on silicon", named("SiO2"), named("Si"), 0.9, 500.0),
    ];
    let mut worst: f64 = 0.0;
    for (name, film, base, cos_theta, d) in cases {
        let found = reference(std::slice::from_ref(&film), base.clone()).evaluate(
            Side::Ambient,
            cos_theta,
            &[d],
        );
        let truth = fixed_step(Side::Ambient, 1 << 19, &[film], &base, cos_theta, &[d]);
        let error = greatest_difference(found.reflectance, truth);
        println!(
            "{name}, {d} nm, cosine {cos_theta}: error {error:.1e}, change {:.1e}, {} samples",
            found.change, found.samples
        );
        assert!(
            found.change <= TOLERANCE && TOLERANCE == 1e-5,
            "{name}: {found:?}"
        );
        worst = worst.max(error);
    }
    println!("greatest error {worst:.1e}");
    assert!(worst < 1e-5, "{worst}");
}

#[test]
fn faint_fringes_do_not_alias() {
    // On a grid coarser than the fringes two successive sums can agree by chance; with fringes this
    // faint that happens within a few tries.
    let (film, base) = (constant(1.501), constant(1.5));
    let stack = reference(std::slice::from_ref(&film), base.clone());
    let mut worst: f64 = 0.0;
    for i in 0..200 {
        let d = [5000.0 + 217.3 * f64::from(i)];
        let found = stack.evaluate(Side::Ambient, 1.0, &d).reflectance;
        let truth = fixed_step(
            Side::Ambient,
            6400,
            std::slice::from_ref(&film),
            &base,
            1.0,
            &d,
        );
        worst = worst.max(greatest_difference(found, truth));
    }
    println!("greatest error of faint fringes {worst:.1e}");
    assert!(worst < 3e-6, "{worst}");
}

/// Between half-spaces that disperse the spectrum has a square root at the wavelength whose critical angle the light has
/// (an error of up to 8e-5 at these cosines if the grid does not know of it).
#[test]
fn converges_at_critical_angles_that_depend_on_the_wavelength() {
    for (layers, thickness_nm) in [(vec![], vec![]), (vec![named("MgF2")], vec![110.0])] {
        let reference = reference(&layers, named("BK7"));
        for i in 0..=100 {
            let cos_theta = 0.7492 + 1e-4 * f64::from(i);
            let found = reference.evaluate(Side::Base, cos_theta, &thickness_nm);
            let base = named("BK7");
            let expected = fixed_step(Side::Base, 20_000, &layers, &base, cos_theta, &thickness_nm);
            let error = greatest_difference(found.reflectance, expected);
            assert!(error <= TOLERANCE, "{cos_theta}: {error:e} {found:?}");
        }
    }
}

#[test]
fn a_fixed_step_of_one_nanometre_is_not_enough() {
    // The reason for all the adaptivity: soap near grazing (.0046 among these, more elsewhere).
    let worst = [0.001, 0.0015, 0.002, 0.0025, 0.003]
        .iter()
        .flat_map(|&cos_theta| [600.0, 700.0, 800.0, 900.0, 1000.0].map(|d| (cos_theta, d)))
        .map(|(cos_theta, d)| {
            let soap = [constant(1.33)];
            let found = reference(&soap, constant(1.0)).evaluate(Side::Ambient, cos_theta, &[d]);
            let coarse = fixed_step(Side::Ambient, 400, &soap, &constant(1.0), cos_theta, &[d]);
            greatest_difference(found.reflectance, coarse)
        })
        .fold(0.0, f64::max);
    println!("1 nm: {worst:.4}");
    assert!(worst > 3e-3, "{worst}");
}

#[test]
fn resonances_of_many_layers_are_found() {
    // A cavity between two mirrors of 14 pairs: a line far below 0.01 nm wide, in a spectrum that
    // is flat around it. In transmission it is all there is.
    let (high, low) = (constant(2.35), constant(1.46));
    let quarter = |eta: f64| 550.0 / 4.0 / eta;
    let mut layers = vec![];
    let mut thickness_nm = vec![];
    let mut add = |medium: &Medium, d: f64| {
        layers.push(medium.clone());
        thickness_nm.push(d);
    };
    for _ in 0..14 {
        add(&high, quarter(2.35));
        add(&low, quarter(1.46));
    }
    add(&high, 2.0 * quarter(2.35));
    for _ in 0..14 {
        add(&low, quarter(1.46));
        add(&high, quarter(2.35));
    }
    let stack = reference(&layers, Medium::vacuum());
    let found = stack.evaluate(Side::Ambient, 1.0, &thickness_nm);
    let sum: Rgb<f64> = std::array::from_fn(|c| found.reflectance[c] + found.transmittance[c]);
    assert!(greatest_difference(sum, [1.0; 3]) < 1e-10, "{sum:?}");
    assert!(
        found.change <= TOLERANCE && found.samples < 20_000,
        "{found:?}"
    );
    // On the line everything passes; the grid must have been refined towards it.
    let on_line = stack.spectrum(Side::Ambient, 1.0, &thickness_nm, 550.0);
    assert!(
        on_line.unpolarized_transmittance() > 0.999_999,
        "{on_line:?}"
    );
    let beside = stack.spectrum(Side::Ambient, 1.0, &thickness_nm, 550.01);
    assert!(beside.unpolarized_transmittance() < 0.01, "{beside:?}");
}

#[test]
fn thick_films_reach_the_incoherent_limit() {
    // Averaged over a fringe, a film reflects R1 + (1 - R1)^2 R2 / (1 - R1 R2).
    let (eta, base_eta, d) = (1.5_f64, 2.5, 1e6);
    let interface = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
    let (r1, r2) = (interface(1.0, eta), interface(eta, base_eta));
    let limit = r1 + (1.0 - r1).powi(2) * r2 / (1.0 - r1 * r2);
    let found = reference(&[constant(eta)], constant(base_eta)).evaluate(Side::Ambient, 1.0, &[d]);
    assert!(
        greatest_difference(found.reflectance, [limit; 3]) < 1e-5,
        "{found:?} {limit}"
    );
    assert!(found.change <= TOLERANCE, "{found:?}");
}

#[test]
fn what_cannot_be_seen_costs_nothing() {
    // A metal of 1 mm shows no fringes, nor does what lies below it.
    let layers = [named("SiO2"), named("Au"), constant(1.5)];
    let thick = reference(&layers, constant(1.33));
    let found = thick.evaluate(Side::Ambient, 0.8, &[300.0, 1e6, 1e6]);
    let bare = reference(&layers[..1], named("Au")).evaluate(Side::Ambient, 0.8, &[300.0]);
    assert_eq!(found.samples, bare.samples);
    assert!(greatest_difference(found.reflectance, bare.reflectance) < 1e-14);
    assert_eq!(found.transmittance, [0.0; 3]);
}

#[test]
fn both_sides_of_a_lossless_film_reflect_alike() {
    let stack = reference(&[constant(2.4), constant(1.38)], constant(1.5));
    let (cos_outside, d): (f64, _) = (0.6, [120.0, 90.0]);
    let sin_inside = (1.0 - cos_outside * cos_outside).sqrt() / 1.5;
    let outside = stack.evaluate(Side::Ambient, cos_outside, &d);
    let inside = stack.evaluate(Side::Base, (1.0 - sin_inside * sin_inside).sqrt(), &d);
    assert!(greatest_difference(outside.reflectance, inside.reflectance) < 1e-12);
    assert!(greatest_difference(outside.transmittance, inside.transmittance) < 1e-12);
    // Light in a base that absorbs travels as if its extinction were 0.
    let absorbing = Medium::rgb([1.5; 3], [0.7; 3]).unwrap();
    let absorbing = reference(&[constant(2.4), constant(1.38)], absorbing);
    assert_eq!(
        absorbing.evaluate(Side::Base, 0.8, &d).reflectance,
        stack.evaluate(Side::Base, 0.8, &d).reflectance
    );
}

#[test]
fn the_ambient_must_be_transparent_and_dense() {
    for ambient in [
        named("Au"),
        constant(0.9),
        Medium::rgb([1.5; 3], [0.0, 0.1, 0.0]).unwrap(),
    ] {
        let refused = Reference::new(
            ambient,
            vec![],
            Medium::vacuum(),
            White::E,
            ColorSpace::Rec709,
        );
        assert!(refused.unwrap_err().message.contains("ambient medium"));
    }
}

#[test]
fn extreme_inputs_stay_finite() {
    let layers = [
        constant(1.33),
        Medium::rgb([1e-3; 3], [1e3; 3]).unwrap(),
        named("TiO2"),
    ];
    let stack = reference(&layers, Medium::rgb([1e3; 3], [1e3; 3]).unwrap());
    for cos_theta in [0.0, 1e-300, 1e-30, 1e-6, 0.5, 1.0] {
        for d in [0.0, 1e-300, 1e-9, 1.0, 1e4] {
            let found = stack.evaluate(Side::Ambient, cos_theta, &[d, d * 0.01, d]);
            let all = [found.reflectance, found.transmittance];
            for number in all.as_flattened() {
                assert!(
                    (-1e-12..1.0 + 1e-12).contains(number),
                    "{cos_theta} {d}: {found:?}"
                );
            }
        }
    }
}
