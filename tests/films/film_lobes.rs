//! What the tests of the `film` model share.

#![allow(dead_code)] // each test program uses a part

use crate::common::calls::Calls;
use crate::common::films::Kind;
use crate::common::rng;
use glam::Vec3;
use pellicle::bsdf::Precision;
use pellicle::film::Film;
use pellicle::optics::stack::Side;
use pellicle::{Bsdf, Description, Sample};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use std::sync::Arc;

pub const REFLECTION: usize = 0;
pub const TRANSMISSION: usize = 1;

pub fn on(film: &Arc<Film>) -> Description {
    Description::new("film").film(Arc::clone(film))
}

/// A film of that kind at a thickness within its range.
pub fn drawn(kind: Kind, rng: &mut Pcg64Mcg) -> (Description, Arc<Film>, f32) {
    let film = kind.film();
    match film.varying_thickness_nm() {
        Some([min, max]) => {
            let thickness = rng.random_range(min as f32..max as f32);
            let description = on(&film).set("thickness_nm", &[thickness]);
            (description, film, thickness)
        }
        None => (on(&film), film, 0.0),
    }
}

/// Calls `law` with every kind of film at several thicknesses.
pub fn for_every_film(seed: u64, law: impl Fn(Kind, &Bsdf, &Film, f32, &mut Pcg64Mcg)) {
    for kind in Kind::ALL {
        let mut rng = rng(seed);
        for _ in 0..10 {
            let (description, film, thickness) = drawn(kind, &mut rng);
            let bsdf = Bsdf::new(&description).unwrap();
            law(kind, &bsdf, &film, thickness, &mut rng);
        }
    }
}

pub fn bsdf(kind: Kind, seed: u64) -> Bsdf {
    Bsdf::new(&drawn(kind, &mut rng(seed)).0).unwrap()
}

/// The probability and a sample of each lobe that can be chosen. A lobe is left out whose probability is so
/// small that no number lies in its share of [0, 1).
pub fn lobes<T: Precision>(bsdf: &Bsdf<T>, wo: T::Vector) -> Vec<(T, Sample<T>)> {
    let probabilities = bsdf.lobe_densities(wo, wo, None).0;
    let [zero, half, one] = [0.0, 0.5, 1.0].map(T::new);
    let mut below = zero;
    let mut found = Vec::new();
    for (lobe, probability) in probabilities.into_iter().enumerate() {
        let middle = below + probability * half;
        if probability > zero && middle < one {
            let sample = bsdf.sampled(wo, [middle, half, half].into(), None);
            assert_eq!(sample.lobe, lobe);
            found.push((probability, sample));
        }
        below = below + probability;
    }
    found
}

/// The transmission lobe, if there is one.
pub fn transmitted<T: Precision>(bsdf: &Bsdf<T>, wo: T::Vector) -> Option<(T, Sample<T>)> {
    let mut lobes = lobes(bsdf, wo).into_iter();
    lobes.find(|(_, sample)| sample.lobe == TRANSMISSION)
}

pub fn side(wo: Vec3) -> Side {
    if wo.z > 0.0 {
        Side::Ambient
    } else {
        Side::Base
    }
}

/// R and T by the film itself as the model promises: T from the ambient's side, R clipped.
pub fn split(film: &Film, bsdf: &Bsdf, wo: Vec3, thickness: f32) -> [[f32; 3]; 2] {
    let outer = transmitted(bsdf, wo).map(|(_, sample)| wo.z.max(sample.wi.z));
    let transmittance = outer.map_or([0.0; 3], |cos_theta| {
        let colors = film.colors(Side::Ambient, cos_theta, thickness).unwrap();
        colors.transmittance
    });
    let colors = film.colors(side(wo), wo.z.abs(), thickness).unwrap();
    let reflectance = std::array::from_fn(|c| colors.reflectance[c].min(1.0 - transmittance[c]));
    [reflectance, transmittance]
}

pub fn indices(film: &Film) -> [f64; 2] {
    film.half_spaces().map(|medium| medium.index(550.0).re)
}

/// Every channel is near.
pub fn assert_colors(found: [f32; 3], expected: [f32; 3], tolerance: f32, what: &str) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert_near(found, expected, tolerance, what);
    }
}

pub fn assert_near(found: f32, expected: f32, tolerance: f32, what: &str) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "{what}: {found}, not {expected}");
}
