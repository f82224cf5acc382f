//! Layers against closed forms, and the exact promises of `src/optics/stack.rs`.
//!
//! Guards the failure cases of thin-film code: very thin films at grazing angles, films that equal
//! their neighbours, total reflection, Brewster's angle, the branch of the complex cosine, metals
//! from k = 0 to 1e3, layers that absorb everything.

use crate::stacks::{Index, assert_close, draw_index, film, index, magnitude, outside};
use pellicle::optics::stack::{Incidence, Layer, P, S, Side, Stack};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::PI;

/// A second implementation, for one film: amplitudes of Fresnel (Born and Wolf, 1.5.2) summed by
/// Airy (Born and Wolf 7.6), with the textbook's angles and a complex type of its own.
mod airy {
    use super::{Index, P, PI, S};

    type C = (f64, f64);

    fn mul(a: C, b: C) -> C {
        (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
    }
    fn add(a: C, b: C) -> C {
        (a.0 + b.0, a.1 + b.1)
    }
    fn sub(a: C, b: C) -> C {
        (a.0 - b.0, a.1 - b.1)
    }
    fn div(a: C, b: C) -> C {
        let norm = b.0 * b.0 + b.1 * b.1;
        let (re, im) = mul(a, (b.0, -b.1));
        (re / norm, im / norm)
    }
    fn norm(a: C) -> f64 {
        a.0 * a.0 + a.1 * a.1
    }
    /// The root in the upper half-plane, by angle.
    fn root(a: C) -> C {
        let (modulus, angle) = (a.0.hypot(a.1).sqrt(), a.1.atan2(a.0) / 2.0);
        (modulus * angle.cos(), modulus * angle.sin())
    }

    fn amplitude(pol: usize, na: C, ca: C, nb: C, cb: C) -> C {
        let (x, y) = if pol == S {
            (mul(na, ca), mul(nb, cb))
        } else {
            (mul(nb, ca), mul(na, cb))
        };
        div(sub(x, y), add(x, y))
    }

    pub fn reflectance(n: [Index; 3], d: f64, cos_theta: f64, nm: f64) -> [f64; 2] {
        let n = n.map(|n| (n.re, n.im));
        let sin = ((1.0 - cos_theta * cos_theta).sqrt(), 0.0);
        let cos = n.map(|index| {
            let sin = div(mul(n[0], sin), index);
            root(sub((1.0, 0.0), mul(sin, sin)))
        });
        // Above: the root of cos^2; the wave decays if n cos lies in the upper half-plane.
        let cos: [C; 3] = std::array::from_fn(|i| {
            if mul(n[i], cos[i]).1 < 0.0 {
                (-cos[i].0, -cos[i].1)
            } else {
                cos[i]
            }
        });
        let phase = mul(n[1], cos[1]);
        let phase = (phase.0 * 4.0 * PI * d / nm, phase.1 * 4.0 * PI * d / nm);
        let e = (
            (-phase.1).exp() * phase.0.cos(),
            (-phase.1).exp() * phase.0.sin(),
        );
        [S, P].map(|pol| {
            let r01 = amplitude(pol, n[0], cos[0], n[1], cos[1]);
            let r12 = mul(amplitude(pol, n[1], cos[1], n[2], cos[2]), e);
            norm(div(add(r01, r12), add((1.0, 0.0), mul(r01, r12))))
        })
    }
}

#[test]
fn one_film_is_airys_sum() {
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    let mut worst: f64 = 0.0;
    for _ in 0..100_000 {
        let ambient = if rng.random_bool(0.5) {
            1.0
        } else {
            magnitude(&mut rng, 1.0, 2.5)
        };
        // The textbook's amplitudes lose their digits between k and 1 / k^2: moderate k here.
        let moderate = |n: Index| index(n.re, n.im.min(20.0));
        let (n1, n2) = (
            moderate(draw_index(&mut rng)),
            moderate(draw_index(&mut rng)),
        );
        let d = magnitude(&mut rng, 1.0, 3000.0);
        let cos_theta = magnitude(&mut rng, 0.05, 1.0);
        let nm = 380.0 + 400.0 * rng.random::<f64>();
        let found = outside(ambient, &[film(n1, d)], n2, cos_theta, nm).reflectance;
        let expected = airy::reflectance([index(ambient, 0.0), n1, n2], d, cos_theta, nm);
        for pol in [S, P] {
            let error = (found[pol] - expected[pol]).abs();
            assert!(
                error < 1e-9,
                "{ambient} {n1:?} {n2:?} {d} {cos_theta} {nm}: {found:?} {expected:?}"
            );
            worst = worst.max(error);
        }
    }
    println!("greatest error {worst:.1e}");
}

#[test]
fn thin_films_at_grazing_angles_keep_their_digits() {
    // A free film, s: R = x^2 / (1 + x^2), x = (n^2 - 1) sin(beta) / (2 q0 q1), from Airy's sum with
    // r^2 and 1 - r^2 simplified (Born and Wolf 7.6, eq. 15). p: divide the immittances by n^2.
    let eta: f64 = 1.33;
    for exponent_d in -12..4 {
        for exponent_cos in -12..1 {
            let d = 7.0 * 10.0_f64.powi(exponent_d);
            let cos_theta = 10.0_f64.powi(exponent_cos);
            let nm = 550.0;
            let q1 = (eta * eta - 1.0 + cos_theta * cos_theta).sqrt();
            let sin = (2.0 * PI * q1 * d / nm).sin();
            let [w0, w1] = [[cos_theta; 2], [q1, q1 / (eta * eta)]];
            let expected = [S, P].map(|pol| {
                let x = (w1[pol] / w0[pol] - w0[pol] / w1[pol]) * sin / 2.0;
                x * x / (1.0 + x * x)
            });
            let found = outside(
                1.0,
                &[film(index(eta, 0.0), d)],
                index(1.0, 0.0),
                cos_theta,
                nm,
            );
            for pol in [S, P] {
                let relative = (found.reflectance[pol] - expected[pol]).abs() / expected[pol];
                // sin^2 of many radians has lost some digits of its own.
                assert!(relative < 1e-10, "{d} {cos_theta}: {found:?} {expected:?}");
                let complement = (found.transmittance[pol] + found.reflectance[pol] - 1.0).abs();
                assert!(complement < 1e-12, "{d} {cos_theta}: {found:?}");
            }
        }
    }
}

#[test]
fn quarter_waves() {
    // Macleod, Thin-Film Optical Filters: one layer makes the base look like n1^2 / ns, and N pairs
    // of high and low like (nH / nL)^2N ns; R = ((n0 - Y) / (n0 + Y))^2, T = 4 n0 Y / (n0 + Y)^2.
    let (n0, ns, nm) = (1.0, 1.52, 550.0);
    let quarter = |eta: f64| film(index(eta, 0.0), nm / 4.0 / eta);
    let square = |x: f64| x * x;
    for n1 in [1.38, 2.4, f64::sqrt(ns)] {
        let expected = square((n0 * ns - n1 * n1) / (n0 * ns + n1 * n1));
        let found = outside(n0, &[quarter(n1)], index(ns, 0.0), 1.0, nm);
        assert_close(found.reflectance, [expected; 2], 1e-15, "one quarter wave");
    }
    let (high, low) = (2.35_f64, 1.46_f64);
    for pairs in 1..=40 {
        let layers = [quarter(high), quarter(low)].repeat(pairs);
        let ratio = (high / low).powi(2 * pairs as i32);
        let expected = 4.0 * n0 * ns * ratio / square(n0 + ns * ratio);
        let found = outside(n0, &layers, index(ns, 0.0), 1.0, nm);
        assert_close(
            found.transmittance,
            [expected; 2],
            expected * 1e-12,
            "pairs",
        );
        assert_close(found.reflectance, [1.0 - expected; 2], 1e-13, "pairs");
    }
    // A half wave is absent at its wavelength.
    let absent = [film(index(2.4, 0.0), nm / 2.0 / 2.4)];
    let found = outside(n0, &absent, index(ns, 0.0), 1.0, nm);
    assert_close(
        found.reflectance,
        [square((ns - 1.0) / (ns + 1.0)); 2],
        1e-15,
        "half wave",
    );
}

#[test]
fn brewster_and_critical_angles() {
    for eta in [1.33_f64, 1.5, 2.4] {
        let brewster = eta.atan().cos();
        let found = outside(1.0, &[], index(eta, 0.0), brewster, 550.0);
        assert!(
            found.reflectance[P] < 1e-30 && found.reflectance[S] > 0.05,
            "{found:?}"
        );

        // From inside: nothing passes beyond the critical angle, and it closes like a root.
        let critical = (1.0 - 1.0 / (eta * eta)).sqrt();
        let stack = Stack {
            ambient: 1.0,
            layers: &[],
            base: index(eta, 0.0),
        };
        for beyond in [
            0.0,
            0.1 * critical,
            0.9 * critical,
            critical * (1.0 - 1e-12),
        ] {
            let found = stack.respond(Side::Base, beyond, 550.0);
            assert_close(found.reflectance, [1.0; 2], 1e-15, "total reflection");
            assert_eq!(found.transmittance, [0.0; 2]);
        }
        let before = stack.respond(Side::Base, critical * (1.0 + 1e-8), 550.0);
        assert!(
            before.reflectance[S] < 0.9999 && before.transmittance[S] > 1e-4,
            "{before:?}"
        );
        // The same interface in the other order.
        let dense = Stack {
            ambient: eta,
            layers: &[],
            base: index(1.0, 0.0),
        };
        assert_eq!(
            dense.respond(Side::Ambient, 0.9, 550.0),
            stack.respond(Side::Base, 0.9, 550.0)
        );
    }
}

#[test]
fn total_reflection_is_frustrated_by_a_second_prism() {
    // The gap's wave decays; T = 1 / (1 + x^2), x = (w1/w0 + w0/w1) sinh(b) / 2 with moduli.
    let (eta, cos_theta, nm): (f64, f64, f64) = (1.5, 0.5, 550.0);
    let q0 = eta * cos_theta;
    let q1 = (eta * eta * (1.0 - cos_theta * cos_theta) - 1.0).sqrt();
    for d in [0.1, 10.0, 100.0, 400.0] {
        let sinh = (2.0 * PI * q1 * d / nm).sinh();
        let expected = [[q0, q1], [q0 / (eta * eta), q1]]
            .map(|[w0, w1]: [f64; 2]| 1.0 / (1.0 + ((w1 / w0 + w0 / w1) * sinh / 2.0).powi(2)));
        let found = outside(
            eta,
            &[film(index(1.0, 0.0), d)],
            index(eta, 0.0),
            cos_theta,
            nm,
        );
        assert_close(found.transmittance, expected, 1e-13, "gap");
        assert_close(found.absorptance(), [0.0; 2], 1e-13, "gap");
    }
}

#[test]
fn what_makes_no_difference_makes_none_at_all() {
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    for _ in 0..20_000 {
        let ambient = if rng.random_bool(0.5) {
            1.0
        } else {
            magnitude(&mut rng, 1.0, 2.0)
        };
        let (n1, n2) = (draw_index(&mut rng), draw_index(&mut rng));
        let (d1, d2) = (
            (magnitude(&mut rng, 1.0, 2e3)).round(),
            magnitude(&mut rng, 1.0, 2e3).round(),
        );
        let cos_theta = if rng.random_bool(0.1) {
            0.0
        } else {
            magnitude(&mut rng, 1e-6, 1.0)
        };
        let nm = 550.0;
        let respond = |layers: &[Layer<f64>]| outside(ambient, layers, n2, cos_theta, nm);
        let bare = respond(&[]);
        let one = respond(&[film(n1, d1)]);

        assert_eq!(respond(&[film(n1, 0.0)]), bare, "thickness 0");
        assert_eq!(
            respond(&[film(n1, d1), film(draw_index(&mut rng), 0.0)]),
            one,
            "thickness 0"
        );
        let like_ambient = film(index(ambient, 0.0), d2);
        assert_eq!(respond(&[like_ambient]), bare, "film like the ambient");
        assert_eq!(
            respond(&[like_ambient, film(n1, d1)]),
            one,
            "film like the ambient"
        );
        assert_eq!(
            respond(&[film(n2, d2)]).reflectance,
            bare.reflectance,
            "film like the base"
        );
        let buried = respond(&[film(n1, d1), film(n2, d2)]);
        assert_eq!(buried.reflectance, one.reflectance, "film like the base");
        let whole = respond(&[film(n1, d1 + d2)]);
        assert_eq!(
            respond(&[film(n1, d1), film(n1, d2)]),
            whole,
            "a film in two parts"
        );
        let parts = [film(n1, d1), film(index(7.0, 1.0), 0.0), film(n1, d2)];
        assert_eq!(respond(&parts), whole, "a film in two parts around nothing");
    }
}

#[test]
fn grazing_light_is_reflected_unless_there_is_nothing() {
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    for _ in 0..20_000 {
        let ambient = magnitude(&mut rng, 1.0, 2.0);
        let layers: Vec<_> = (0..rng.random_range(0..4))
            .map(|_| film(draw_index(&mut rng), magnitude(&mut rng, 1e-6, 1e5)))
            .collect();
        let base = draw_index(&mut rng);
        let found = outside(ambient, &layers, base, 0.0, 550.0);
        assert_eq!(
            (found.reflectance, found.transmittance),
            ([1.0; 2], [0.0; 2])
        );
        // ... continuously.
        let near = outside(ambient, &layers, base, 1e-14, 550.0);
        assert!(
            near.reflectance[S] > 0.999 && near.reflectance[P] > 0.9,
            "{layers:?} {near:?}"
        );
    }
    let same = index(1.33, 0.0);
    for cos_theta in [0.0, 1e-320, 1e-200, 1e-30, 0.5, 1.0] {
        let found = outside(1.33, &[film(same, 300.0)], same, cos_theta, 550.0);
        assert_eq!(
            (found.reflectance, found.transmittance),
            ([0.0; 2], [1.0; 2]),
            "{cos_theta}"
        );
    }
    // Thinner than any number of the other: no quotient of nothings.
    for (cos_theta, d) in [
        (0.0, 1e-320),
        (1e-320, 1e-320),
        (1e-320, 1.0),
        (1e-200, 1e-100),
    ] {
        let found = outside(1.0, &[film(same, d)], index(1.0, 0.0), cos_theta, 550.0);
        for pol in [S, P] {
            assert!(
                (0.0..=1.0).contains(&found.reflectance[pol]),
                "{cos_theta} {d}: {found:?}"
            );
        }
    }
}

#[test]
fn the_critical_angle_inside_the_stack_is_smooth() {
    // q = 0 exactly in the film: cos^2 = 1 - (n1 / n0)^2 is representable for n0 = 1.25, n1 = 1.
    let (ambient, base) = (1.25, index(1.5, 0.0));
    let respond = |cos_theta| {
        outside(
            ambient,
            &[film(index(1.0, 0.0), 500.0)],
            base,
            cos_theta,
            550.0,
        )
    };
    let wave = Incidence::new(ambient, 0.6).wave(index(1.0, 0.0));
    assert!(wave.immittance[S].norm_squared() < 1e-15, "{wave:?}");
    let at = respond(0.6);
    let (below, above) = (respond(0.6 - 1e-9), respond(0.6 + 1e-9));
    assert_close(at.reflectance, below.reflectance, 1e-7, "below");
    assert_close(at.reflectance, above.reflectance, 1e-7, "above");
    let (two, zero) = (
        Incidence::new(2.0, 0.0).wave(index(2.0, 0.0)),
        index(0.0, 0.0),
    );
    assert_eq!(two.immittance, [zero; 2]);
}

#[test]
fn waves_decay_away_from_the_light() {
    let mut rng = Pcg64Mcg::seed_from_u64(4);
    for _ in 0..100_000 {
        let incidence = Incidence::new(magnitude(&mut rng, 1.0, 4.0), rng.random::<f64>());
        let k = if rng.random_bool(0.3) {
            0.0
        } else {
            magnitude(&mut rng, 1e-9, 1e3)
        };
        let n = index(magnitude(&mut rng, 1e-3, 1e3), k);
        let [q, ratio] = incidence.wave(n).immittance;
        assert!(q.im >= 0.0 && q.re >= 0.0, "{incidence:?} {n:?}: {q:?}");
        // Power flows the same way in p: Re(q / n^2) >= 0.
        assert!(
            ratio.re >= -1e-15 * ratio.magnitude(),
            "{incidence:?} {n:?}: {ratio:?}"
        );
    }
}
