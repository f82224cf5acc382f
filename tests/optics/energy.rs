//! Where the light goes: R + T + A = 1, reciprocity of transmission, opaque layers, Beer's law.

use crate::stacks::{assert_close, draw_index, film, index, magnitude, outside};
use pellicle::optics::Medium;
use pellicle::optics::stack::{P, S, Side, Stack};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::PI;

#[test]
fn energy_is_conserved() {
    let mut rng = Pcg64Mcg::seed_from_u64(5);
    let mut worst: f64 = 0.0;
    for _ in 0..20_000 {
        let absorbing = rng.random_bool(0.5);
        let draw = |rng: &mut Pcg64Mcg| {
            let n = draw_index(rng);
            if absorbing {
                n
            } else {
                index(n.re.max(1.0), 0.0)
            }
        };
        let layers: Vec<_> = (0..rng.random_range(0..=64))
            .map(|_| film(draw(&mut rng), magnitude(&mut rng, 0.1, 1e4)))
            .collect();
        let (ambient, base) = (magnitude(&mut rng, 1.0, 2.0), draw(&mut rng));
        let cos_theta = magnitude(&mut rng, 1e-4, 1.0);
        let stack = Stack {
            ambient,
            layers: &layers,
            base,
        };
        for side in [Side::Ambient, Side::Base] {
            let found = stack.respond(side, cos_theta, 550.0);
            for pol in [S, P] {
                let [r, t, a] = [
                    found.reflectance[pol],
                    found.transmittance[pol],
                    found.absorptance()[pol],
                ];
                assert!(
                    (0.0..1.0 + 1e-9).contains(&r) && (0.0..1.0 + 1e-9).contains(&t),
                    "{found:?}"
                );
                assert!(a > -1e-9, "{found:?} {stack:?}");
                if !absorbing {
                    worst = worst.max(a.abs());
                }
            }
        }
    }
    println!("greatest |1 - R - T| without absorption: {worst:.1e}");
    assert!(worst < 1e-9, "{worst}");
}

#[test]
fn transmission_is_the_same_both_ways() {
    // Reciprocity, absorbing layers included; the reflectances differ then.
    let mut rng = Pcg64Mcg::seed_from_u64(6);
    for _ in 0..20_000 {
        let layers: Vec<_> = (0..rng.random_range(0..6))
            .map(|_| film(draw_index(&mut rng), magnitude(&mut rng, 0.1, 300.0)))
            .collect();
        let (ambient, base) = (1.0, magnitude(&mut rng, 1.0, 2.0));
        let cos_outside = magnitude(&mut rng, 0.01, 1.0);
        let sin = (1.0 - cos_outside * cos_outside).sqrt() / base;
        let stack = Stack {
            ambient,
            layers: &layers,
            base: index(base, 0.0),
        };
        let there = stack
            .respond(Side::Ambient, cos_outside, 550.0)
            .transmittance;
        let back = stack
            .respond(Side::Base, (1.0 - sin * sin).sqrt(), 550.0)
            .transmittance;
        assert_close(there, back, 1e-9, "both ways");
    }
}

#[test]
fn opaque_layers_hide_what_is_below() {
    let gold = Medium::named("gold").unwrap().index(600.0);
    let glass = index(1.5, 0.0);
    let top = film(index(1.46, 0.0), 120.0);
    let bare = outside(1.0, &[top], gold, 0.4, 600.0);
    for d in [1e4, 1e6, 1e9, 1e300] {
        let layers = [top, film(gold, d), film(glass, 77.0), film(gold, d)];
        let found = outside(1.0, &layers, glass, 0.4, 600.0);
        assert_close(found.reflectance, bare.reflectance, 1e-14, "thick gold");
        assert_eq!(found.transmittance, [0.0; 2]);
    }
    // 64 of them, and k from nearly nothing to 1e3.
    for exponent in -12..=3 {
        let absorbing = index(1.5, 10.0_f64.powi(exponent));
        let layers = [film(absorbing, 5e4), film(glass, 3e3)].repeat(32);
        let found = outside(1.0, &layers, absorbing, 0.2, 400.0);
        for pol in [S, P] {
            let (r, t) = (found.reflectance[pol], found.transmittance[pol]);
            assert!(
                r > 0.0 && t >= 0.0 && r + t < 1.0 + 1e-12,
                "k = 1e{exponent}: {found:?}"
            );
        }
    }
}

#[test]
fn absorption_is_what_is_lost_inside() {
    // Beer and Lambert: with n equal on all sides there is no reflection to speak of, and
    // T = exp(-4 pi k d / lambda).
    let (k, d, nm) = (1e-4, 1e5, 500.0);
    let found = outside(1.5, &[film(index(1.5, k), d)], index(1.5, 0.0), 1.0, nm);
    let expected = (-4.0 * PI * k * d / nm).exp();
    assert_close(found.transmittance, [expected; 2], 1e-8, "Beer");
    assert_close(found.absorptance(), [1.0 - expected; 2], 1e-8, "Beer");
    // The same where the layer continues as the base: what crosses the surface of the base.
    let continued = outside(1.5, &[film(index(1.5, k), d)], index(1.5, k), 1.0, nm);
    assert_close(
        continued.transmittance,
        [expected; 2],
        1e-8,
        "Beer, half-space",
    );
}
