//! Energy of `metallic_roughness`: the white furnace over metallic x roughness and everything else.
//!
//! The albedo is integrated adaptively from the double-precision value, not by the library.

use crate::common::calls::Calls;
use crate::common::quadrature::Patch;
use crate::common::{degrees, rng, roughness_of};
use glam::DVec3;
use pellicle::{Bsdf, Description};
use rand::RngExt;

/// The integral of the value over wi. For narrow lobes the cells are those of a polar grid about the
/// mirror direction, whose radius grows by octaves.
fn albedo(bsdf: &Bsdf<f64>, wo: DVec3, alpha: f64) -> [f64; 3] {
    let mirror = DVec3::new(-wo.x, -wo.y, wo.z);
    let across = if mirror.z < 0.999 {
        DVec3::Z.cross(mirror).normalize()
    } else {
        DVec3::X
    };
    let along = mirror.cross(across);
    // (z, phi) of a patch about the mirror direction, z = 1 - q, q in octaves below 2.
    let value = |local: DVec3| {
        let wi = across * local.x + along * local.y + mirror * local.z;
        if wi.z > 0.0 {
            bsdf.value(wo, wi.normalize(), None)
        } else {
            [0.0; 3]
        }
    };
    let mut sum = [0.0; 3];
    let mut upper = 2.0;
    while upper > 1e-3 * alpha * alpha {
        let lower = if upper * 0.5 > 1e-3 * alpha * alpha {
            upper * 0.5
        } else {
            0.0
        };
        for j in 0..16 {
            let turn = |j: u32| f64::from(j) / 16.0 * std::f64::consts::TAU;
            let patch = Patch {
                z: [1.0 - upper, 1.0 - lower],
                phi: [turn(j), turn(j + 1)],
            };
            let part = patch.integrate(&value, 2e-6, 8);
            for c in 0..3 {
                sum[c] += part[c];
            }
        }
        upper = lower;
    }
    sum
}

const VIEWS: [f64; 6] = [0.0, 30.0, 60.0, 75.0, 85.0, 89.0];

/// The error that the model states: the table's.
const ERROR: f64 = 1e-3;

fn white() -> Description {
    Description::new("metallic_roughness").set("base_color", &[1.0])
}

/// The 25 spheres of the lecture's exercise, white, in a white furnace: never brighter than the
/// furnace, and as bright as the documentation says.
#[test]
fn the_25_white_spheres_stay_within_their_bounds() {
    for roughness in [0.0f32, 0.25, 0.5, 0.75, 1.0] {
        let alpha = f64::from(roughness).powi(2).max(1e-4);
        for view in VIEWS {
            let wo = degrees(view, 25.0);
            let of = |metallic: f32| {
                let description = white()
                    .set("metallic", &[metallic])
                    .set("roughness", &[roughness]);
                albedo(&Bsdf::new(&description).unwrap(), wo, alpha)[0]
            };
            let [dielectric, .., metal] = [0.0, 0.25, 0.5, 0.75, 1.0].map(|metallic| {
                let found = of(metallic);
                assert!(
                    found <= 1.0 + ERROR,
                    "{metallic} {roughness} {view}: {found}"
                );
                found
            });
            println!("roughness {roughness} at {view}: {dielectric:.5} to {metal:.5}");
            assert!(
                (dielectric - 1.0).abs() <= ERROR,
                "{roughness} {view}: {dielectric}"
            );
            // Between them in proportion.
            let half = of(0.5);
            assert!((half - (dielectric + metal) / 2.0).abs() <= ERROR);
        }
    }
}

/// The lower bounds of a white metal that the documentation states, from whatever side.
#[test]
fn white_metals_lose_what_is_stated() {
    for (roughness, stated) in [(0.25f32, 0.89), (0.5, 0.83), (0.75, 0.62), (1.0, 0.3)] {
        let description = white()
            .set("metallic", &[1.0])
            .set("roughness", &[roughness]);
        let bsdf = Bsdf::new(&description).unwrap();
        let alpha = f64::from(roughness).powi(2);
        let views = VIEWS.into_iter().chain([70.0, 80.0, 83.0, 87.0]);
        let albedos = views.map(|view| albedo(&bsdf, degrees(view, 0.0), alpha)[0]);
        let least = albedos.fold(1.0, f64::min);
        assert!(
            (stated..stated + 0.011).contains(&least),
            "{roughness}: {least}"
        );
    }
}

/// No parameters give more than 1: every diffuse form, any F0, where the forms alone exceed it.
#[test]
fn no_parameters_exceed_1() {
    let mut rng = rng(1);
    let mut worst = 0.0f64;
    for i in 0..400 {
        let roughness = [0.02f32, 0.1, 0.22, 0.35, 0.6, 1.0][i % 6];
        let f0 = [0.0f32, 0.04, 0.3, 0.8, 0.95, 0.99, 1.0][rng.random_range(0..7)];
        let form = ["oren_nayar", "disney"][i / 6 % 2];
        let diffuse_roughness = rng.random_range(0.0..=1.0f32);
        let description = Description::new("metallic_roughness")
            .set("roughness", &[roughness])
            .set("base_color", &[1.0, 0.97, rng.random_range(0.8..=1.0)])
            .choose("dielectric_from", "f0")
            .set("f0", &[f0])
            .choose("diffuse_form", form)
            .set(roughness_of(form).unwrap(), &[diffuse_roughness]);
        let bsdf = Bsdf::new(&description).unwrap();
        let view = [0.0, 50.0, 75.0, 84.0, 87.0, 88.5, 89.5][rng.random_range(0..7)];
        let alpha = f64::from(roughness).powi(2).max(1e-4);
        for found in albedo(&bsdf, degrees(view, 0.0), alpha) {
            worst = worst.max(found);
            assert!(found <= 1.0 + ERROR, "{description:?} at {view}: {found}");
        }
    }
    println!("worst {worst}");
}

/// The bounds by which `oren_nayar` and `disney` are divided are not so loose as to darken them for
/// nothing: a white dielectric still returns what the form returns at its brightest, less 4 %.
#[test]
fn bounds_are_close() {
    for (form, diffuse_roughness) in [
        ("oren_nayar", 0.1),
        ("oren_nayar", 0.3),
        ("disney", 0.5),
        ("disney", 0.75),
        ("disney", 1.0),
    ] {
        let description = white()
            .choose("diffuse_form", form)
            .set(roughness_of(form).unwrap(), &[diffuse_roughness]);
        let bsdf = Bsdf::new(&description).unwrap();
        let albedos = [0.0, 60.0, 75.0, 80.0, 85.0, 89.0, 89.9]
            .map(|view| albedo(&bsdf, degrees(view, 0.0), 0.25)[0]);
        let brightest = albedos.into_iter().fold(0.0, f64::max);
        println!("{form} {diffuse_roughness}: {albedos:.4?}");
        assert!(brightest >= 0.96, "{form} {diffuse_roughness}: {brightest}");
    }
}
