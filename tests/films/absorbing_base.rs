//! A base that absorbs a little is no other film: nothing jumps as its extinction k grows, but for the flag of
//! transmission at a stated k.

use crate::common::calls::Calls;
use crate::common::films::{bare, compiled, constant, difference, medium, rounded};
use crate::film_lobes::{REFLECTION, TRANSMISSION, on};
use glam::Vec3;
use pellicle::bsdf::Flags;
use pellicle::film::{BaseOpacity, Film, FilmDescription, OPAQUE_K};
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};
use pellicle::{Bsdf, Colors};

/// From 0 to 1e-2, dense around the limit.
const K: [f64; 20] = [
    0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 5e-5, 1e-4, 2e-4, 4e-4, 7e-4, 0.999e-3, 1e-3,
    1.001e-3, 1.5e-3, 2.5e-3, 4e-3, 7e-3, 1e-2,
];
const COSINES: [f32; 8] = [1.0, 0.8, 0.7453, 0.72, 0.5, 0.2, 0.05, 1e-3];
const SIDES: [Side; 2] = [Side::Ambient, Side::Base];

/// Glass of index 1.5, of an extinction k.
fn glass(k: f64) -> Medium {
    constant(1.5, k)
}

/// BK7's indices with an extinction k, as tables of measurements have them.
fn measured_glass(k: f64) -> Medium {
    let nm: Vec<f64> = (0..=20u8).map(|i| 380.0 + 20.0 * f64::from(i)).collect();
    let eta: Vec<f64> = nm.iter().map(|nm| medium("BK7").index(*nm).re).collect();
    Medium::table(&nm, &eta, &vec![k; nm.len()]).unwrap()
}

/// Bare, coated, coated with a layer that absorbs, seen from a denser medium, measured.
fn films(k: f64) -> [(&'static str, FilmDescription); 5] {
    let lens = |base| bare(base).layer(constant(1.38, 0.0), [0.0, 300.0]);
    let mirror = bare(glass(k))
        .layer(constant(2.3, 0.0), [60.0; 2])
        .layer(constant(1.46, 0.02), [95.0; 2]);
    let from_oil = FilmDescription {
        ambient: constant(1.7, 0.0),
        ..lens(glass(k))
    };
    [
        ("bare", bare(glass(k))),
        ("lens", lens(glass(k))),
        ("mirror", mirror),
        ("from oil", from_oil),
        ("measured", bare(measured_glass(k))),
    ]
    .map(|(name, description)| (name, two_sided(description, BaseOpacity::Transparent)))
}

fn two_sided(description: FilmDescription, base_opacity: BaseOpacity) -> FilmDescription {
    FilmDescription {
        transmittance: true,
        base_opacity,
        ..description
    }
}

fn truth(description: &FilmDescription, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
    let layers = description.layers.iter().map(|layer| layer.medium.clone());
    let (ambient, base) = (description.ambient.clone(), description.base.clone());
    let space = ColorSpace::Rec709;
    let reference = Reference::new(ambient, layers.collect(), base, White::E, space).unwrap();
    let thicknesses: Vec<f64> = description
        .layers
        .iter()
        .map(|layer| f64::from(thickness_nm).clamp(layer.thickness_nm[0], layer.thickness_nm[1]))
        .collect();
    let found = reference.evaluate(side, f64::from(cos_theta), &thicknesses);
    Colors {
        reflectance: rounded(found.reflectance),
        transmittance: rounded(found.transmittance),
    }
}

fn change(a: &Colors, b: &Colors) -> f64 {
    let r = difference(a.reflectance, b.reflectance);
    r.max(difference(a.transmittance, b.transmittance))
}

/// What changes between two extinctions is in proportion to their difference or, where light of a denser ambient
/// begins to go along the base, to its root: q there is the root of n^2 - n0^2 sin^2, whose imaginary part is k.
#[test]
fn wave_optics_does_not_jump_from_either_side() {
    for (index, (name, _)) in films(0.0).iter().enumerate() {
        for side in SIDES {
            for c in COSINES.into_iter().chain([0.4706, 0.4708]) {
                let mut before = truth(&films(0.0)[index].1, side, c, 130.0);
                for pair in K.windows(2) {
                    let next = truth(&films(pair[1])[index].1, side, c, 130.0);
                    let step = pair[1] - pair[0];
                    let allowed = match *name {
                        "from oil" => 4e-5 + 3.0 * (pair[1].sqrt() - pair[0].sqrt()),
                        _ => 4e-5 + 2.0 * step,
                    };
                    let jump = change(&before, &next);
                    assert!(jump <= allowed, "{name} {side:?} {c} {pair:?}: {jump:e}");
                    before = next;
                }
            }
        }
    }
}

/// Tables, too, hold their tolerance at every k, from both sides, so that they jump by no more than twice that.
#[test]
fn films_hold_their_tolerance_at_every_extinction() {
    for tolerance in [2e-3, 2e-4] {
        for k in [1e-12, 1e-8, 1e-5, 1e-3, 1.001e-3, 1e-2] {
            for (name, description) in films(k) {
                let description = FilmDescription {
                    tolerance,
                    ..description
                };
                let film = Film::new(&description).unwrap();
                for side in SIDES {
                    for c in COSINES.into_iter().chain([0.4706, 0.4708, 0.46, 0.3]) {
                        for d in [0.0, 40.0, 130.0, 290.0] {
                            let found = film.colors(side, c, d).unwrap();
                            let error = change(&found, &truth(&description, side, c, d));
                            let plan = film.plan();
                            assert!(
                                error <= tolerance,
                                "{name} {k} {side:?} {c} {d}: {error:e} {plan:?}"
                            );
                        }
                    }
                }
            }
        }
    }
}

/// What light from the base's side leaves out by taking the real part of its index, by Stokes' reversion: the
/// transmittance from there differs from that at the same angle from the ambient's side by the order of k.
#[test]
fn the_real_index_is_off_by_the_order_of_k() {
    let mut greatest = 0.0f64;
    for k in [1e-5, 1e-4, 1e-3] {
        for (name, description) in films(k) {
            if name == "from oil" || name == "measured" {
                continue;
            }
            for i in 1..=50u8 {
                let c = f32::from(i) / 50.0;
                let inside = (1.0 - (1.0 - c * c) / 2.25).sqrt();
                for d in [0.0, 100.0, 300.0] {
                    let front = truth(&description, Side::Ambient, c, d);
                    let back = truth(&description, Side::Base, inside, d);
                    let error = difference(front.transmittance, back.transmittance);
                    greatest = greatest.max((error - 2e-5) / k);
                }
            }
        }
    }
    println!("greatest error over k: {greatest}");
    assert!(greatest > 0.1 && greatest < 2.0, "{greatest}");
}

/// The albedo of each lobe by a loop over samples.
fn albedo(film: &FilmDescription, wo: Vec3) -> [[f32; 3]; 2] {
    const COUNT: u16 = 2000;
    let bsdf: Bsdf = Bsdf::new(&on(&compiled(film))).unwrap();
    let mut sums = [[0.0; 3]; 2];
    for i in 0..COUNT {
        let u = Vec3::new((f32::from(i) + 0.5) / f32::from(COUNT), 0.5, 0.5);
        let sample = bsdf.sampled(wo, u, None);
        // Radiance is compressed by refraction, power is not.
        let factor = sample.eta * sample.eta / f32::from(COUNT);
        for (sum, weight) in sums[sample.lobe].iter_mut().zip(sample.weight) {
            *sum += weight * factor;
        }
    }
    sums
}

/// A BSDF loses light at the limit only, and only what enters; never where the description says `Transparent`.
#[test]
fn the_albedo_of_samples_does_not_jump() {
    let at = |k: f64, opacity| {
        two_sided(
            bare(glass(k)).layer(constant(1.38, 0.0), [100.0; 2]),
            opacity,
        )
    };
    for wo in [
        Vec3::Z,
        Vec3::new(0.6, 0.0, 0.8),
        Vec3::new(0.6, 0.0, -0.8),
        -Vec3::Z,
    ] {
        let mut before = albedo(&at(0.0, BaseOpacity::Transparent), wo);
        for k in K {
            let next = albedo(&at(k, BaseOpacity::Transparent), wo);
            for lobe in [REFLECTION, TRANSMISSION] {
                let jump = difference(before[lobe], next[lobe]);
                // Each film has the tolerance 2e-3, and the loop an error of its own.
                assert!(jump < 6e-3, "{k} {wo} {lobe}: {before:?} {next:?}");
            }
            let by_k = albedo(&at(k, BaseOpacity::ByExtinction), wo);
            if k <= OPAQUE_K {
                assert_eq!(by_k, next, "{k} {wo}");
            } else if wo.z > 0.0 {
                assert!(
                    difference(by_k[REFLECTION], next[REFLECTION]) < 6e-3,
                    "{k} {wo}"
                );
                assert_eq!(by_k[TRANSMISSION], [0.0; 3]);
            } else {
                assert_eq!(by_k, [[0.0; 3]; 2]);
            }
            before = next;
        }
        let whole: f32 = before.iter().map(|rgb| rgb[1]).sum();
        assert!((whole - 1.0).abs() < 0.01, "{wo} {before:?}");
    }
}

/// The flag and the lobes switch at k = 1e-3 at 550 nm, or where the description says so.
#[test]
fn the_limit_is_where_it_is_said_to_be() {
    let flags = |k: f64, opacity| {
        let film = compiled(&two_sided(bare(glass(k)), opacity));
        let opaque = film.description().is_base_opaque();
        let bsdf: Bsdf = Bsdf::new(&on(&film)).unwrap();
        let transmits = bsdf.flags().contains(Flags::TRANSMISSION);
        assert_eq!(opaque, !transmits);
        assert_eq!(bsdf.lobe_infos().len(), if transmits { 2 } else { 1 });
        let below = film.colors(Side::Base, 0.9, 0.0).unwrap();
        assert_eq!(below == Colors::default(), opaque);
        transmits
    };
    for (k, expected) in [
        (0.0, true),
        (1e-12, true),
        (1e-3, true),
        (f64::from(1e-3f32), true),
        (1.00001e-3, false),
        (3.0, false),
    ] {
        assert_eq!(flags(k, BaseOpacity::ByExtinction), expected, "{k}");
        assert!(!flags(k, BaseOpacity::Opaque), "{k}");
        assert!(flags(k, BaseOpacity::Transparent), "{k}");
    }
    // By k at 550 nm, whatever it is elsewhere.
    let filter = Medium::table(
        &[500.0, 540.0, 560.0, 600.0],
        &[1.5; 4],
        &[0.5, 1e-4, 1e-4, 0.5],
    );
    let film = two_sided(bare(filter.unwrap()), BaseOpacity::ByExtinction);
    assert!(!film.is_base_opaque());
}

/// The attenuation of the base is what wave optics says that a plate of it takes away, and for a constant k each
/// channel's 4 pi k over a wavelength of its colour.
#[test]
fn the_attenuation_is_that_of_a_plate() {
    let narrow = Medium::table(&[549.9, 550.0, 550.1], &[1.5; 3], &[0.0, 1e-4, 0.0]).unwrap();
    for (name, medium) in [
        ("constant", constant(1.5, 1e-6)),
        (
            "red glass",
            Medium::rgb([1.5; 3], [1e-8, 1e-6, 2e-6]).unwrap(),
        ),
        ("a line", narrow),
    ] {
        let film = compiled(&two_sided(bare(medium.clone()), BaseOpacity::ByExtinction));
        let found = film.base_attenuation_per_mm();
        let thickness_nm = 1e3;
        let (clear, space) = (constant(1.5, 0.0), ColorSpace::Rec709);
        let layers = vec![medium];
        let plate = Reference::new(clear.clone(), layers, clear, White::E, space).unwrap();
        let through = plate.evaluate(Side::Ambient, 1.0, &[thickness_nm]);
        for c in 0..3 {
            let expected = (1.0 - through.transmittance[c]) / (thickness_nm * 1e-6);
            let error = (found[c] - expected.max(0.0)).abs();
            // The reference's own rounding, over the thickness.
            assert!(
                error < 1e-3 * expected.abs() + 1e-8,
                "{name} {found:?} {expected}"
            );
        }
        if name == "constant" {
            let nm = found.map(|per_mm| 4.0 * std::f64::consts::PI * 1e-6 / per_mm * 1e6);
            assert!(
                nm[0] > 590.0 && (530.0..560.0).contains(&nm[1]) && nm[2] < 470.0,
                "{nm:?}"
            );
        }
    }
    let clear = compiled(&bare(glass(0.0)));
    assert_eq!(clear.base_attenuation_per_mm(), [0.0; 3]);
}
