//! The laws for a smooth film, whose Dirac lobes only sampling finds.

use super::laws::{Law, Measured};
use crate::shared::bsdf::{self, sample};
use glam::DVec3;
use pellicle::Bsdf;
use pellicle::bsdf::Precision;

/// The light that one lobe passes on.
struct Passed {
    wi: DVec3,
    /// Of green light, as power: without radiance's factor.
    power: f64,
}

/// At one direction of the viewer. Both instances have the film's own single precision.
pub fn measure(single: &Bsdf<f32>, double: &Bsdf<f64>, wo: DVec3) -> Measured {
    let (there, rounded) = (lobes(double, wo), lobes(single, wo));
    let pairs = there.iter().zip(&rounded);
    let precision = pairs.map(|(a, b)| (a.power - b.power).abs());
    // Light that comes through must come back the same way.
    let through = there.iter().find(|passed| passed.wi.z < 0.0);
    let reciprocity = through.map_or(0.0, |passed| {
        let back = lobes(double, passed.wi);
        let back = back.into_iter().find(|back| back.wi.z > 0.0);
        back.map_or(1.0, |back| (back.power - passed.power).abs())
    });
    let power: f64 = there.iter().map(|passed| passed.power).sum();
    let mut errors = [None; Law::ALL.len()];
    errors[Law::Precision as usize] = Some(precision.fold(0.0, f64::max));
    errors[Law::Reciprocity as usize] = Some(reciprocity);
    errors[Law::Energy as usize] = Some((power - 1.0).max(0.0));
    let is_bad = |passed: &&Passed| !(passed.power.is_finite() && passed.power >= 0.0);
    Measured {
        errors,
        not_finite: rounded.iter().filter(is_bad).count(),
        evaluations: 6,
    }
}

fn lobes<T: Precision>(bsdf: &Bsdf<T>, wo: DVec3) -> Vec<Passed> {
    let vector = |w: DVec3| T::Vector::from(w.to_array().map(T::new));
    let number = |x: T| f64::from(x.to_f32());
    let [probabilities, _] = bsdf::lobes(bsdf, vector(wo), vector(wo));
    let probabilities = probabilities.into_iter().map(number);
    let (mut below, mut passed) = (0.0, Vec::new());
    for probability in probabilities.filter(|p| *p > 0.0) {
        let u = DVec3::new(below + 0.5 * probability, 0.5, 0.5);
        let sample = sample(bsdf, vector(wo), vector(u), None);
        let wi: [T; 3] = sample.wi.into();
        passed.push(Passed {
            wi: DVec3::from(wi.map(number)),
            power: probability * number(sample.weight[1]) * number(sample.eta).powi(2),
        });
        below += probability;
    }
    passed
}
