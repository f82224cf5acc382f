//! The laws that models should obey, and how far they break them at one point of a map.

use super::case::Case;
use super::smooth;
use crate::shared::bsdf::{self, albedo, sample, value, value_pdf};
use crate::shared::directions::{direction, hemisphere};
use glam::DVec3;
use pellicle::bsdf::Flags;
use pellicle::{Bsdf, Error};
use rand::{Rng, RngExt};

/// A law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Single precision against double: values and densities, relative to their sum.
    Precision,
    /// value(wo, wi) wo.z against value(wi, wo) wi.z, relative to the greater.
    Reciprocity,
    /// The excess of the albedo over 1.
    Energy,
    /// The density against the inverse of the sampler's Jacobian, relative.
    Sampling,
}

impl Law {
    pub const ALL: [Self; 4] = [
        Self::Precision,
        Self::Reciprocity,
        Self::Energy,
        Self::Sampling,
    ];

    pub fn title(self) -> &'static str {
        match self {
            Self::Precision => "float32 against float64",
            Self::Reciprocity => "not reciprocal by",
            Self::Energy => "albedo above 1 by",
            Self::Sampling => "sample against pdf",
        }
    }
}

/// One cell.
pub struct Measured {
    /// One per law; none if it does not apply.
    pub errors: [Option<f64>; Law::ALL.len()],
    /// Results that are NaN, infinite or negative, in single precision.
    pub not_finite: usize,
    pub evaluations: usize,
}

/// A model at one value of its parameter.
pub struct Subject {
    single: Bsdf<f32>,
    double: Bsdf<f64>,
}

/// The viewer's azimuth, degrees: off the axes.
const AZIMUTH: f64 = 25.0;
/// Directions to the light per cell that values are compared at.
const DIRECTIONS: usize = 24;
/// Samples per lobe and cell whose density is compared.
const SAMPLES: usize = 6;
/// Values and densities below this do not count as a whole: a relative error would say nothing.
const FAINT: f64 = 1e-3;
/// Of the differences that give the Jacobian.
const STEP: f64 = 1e-5;

impl Subject {
    pub fn new(case: &Case, x: f64) -> Result<Self, Error> {
        let description = case.describe(x);
        Ok(Self {
            single: Bsdf::new(&description)?,
            double: Bsdf::new(&description)?,
        })
    }

    /// At the viewer's angle, degrees.
    pub fn measure(&self, angle: f64, rng: &mut impl Rng) -> Measured {
        let wo = direction(angle.to_radians().cos(), AZIMUTH.to_radians());
        // The same numbers in both precisions.
        let wo = wo.as_vec3().as_dvec3();
        if self.double.flags().contains(Flags::DELTA) {
            return smooth::measure(&self.single, &self.double, wo);
        }
        let mut measured = Measured {
            errors: [Some(0.0); Law::ALL.len()],
            not_finite: 0,
            evaluations: 1,
        };
        for i in 0..DIRECTIONS {
            let wi = self.direction(i, wo, rng);
            self.compare(wo, wi, &mut measured);
        }
        let albedo = albedo(&self.double, wo, None)
            .into_iter()
            .fold(0.0, f64::max);
        measured.errors[Law::Energy as usize] = Some((albedo - 1.0).max(0.0));
        self.sample(wo, rng, &mut measured);
        measured
    }

    /// The mirror direction first; of the others two in three where the light is, one anywhere.
    fn direction(&self, i: usize, wo: DVec3, rng: &mut impl Rng) -> DVec3 {
        let wi = if i == 0 {
            DVec3::new(-wo.x, -wo.y, wo.z)
        } else if i.is_multiple_of(3) {
            hemisphere(rng)
        } else {
            let u = DVec3::new(rng.random(), rng.random(), rng.random());
            sample(&self.double, wo, u, None).wi
        };
        if wi.z > 0.0 {
            wi.as_vec3().as_dvec3()
        } else {
            wo
        }
    }

    fn compare(&self, wo: DVec3, wi: DVec3, measured: &mut Measured) {
        let (found, pdf) = value_pdf(&self.single, wo.as_vec3(), wi.as_vec3(), None);
        let (truth, true_pdf) = value_pdf(&self.double, wo, wi, None);
        let back = value(&self.double, wi, wo);
        measured.evaluations += 3;
        let numbers = found.into_iter().chain([pdf]);
        let bad = numbers.filter(|x| !x.is_finite() || *x < 0.0).count();
        measured.not_finite += bad;
        let mut precision = (f64::from(pdf) - true_pdf).abs() / (true_pdf + FAINT);
        let mut reciprocity = 0.0f64;
        for c in 0..3 {
            let error = (f64::from(found[c]) - truth[c]).abs();
            precision = precision.max(error / (truth[c] + true_pdf + FAINT));
            let [there, back] = [truth[c] * wo.z, back[c] * wi.z];
            let greater = there.max(back).max(1e-12);
            reciprocity = reciprocity.max((there - back).abs() / greater);
        }
        measured.worsen(Law::Precision, precision);
        measured.worsen(Law::Reciprocity, reciprocity);
    }

    /// A lobe's density is the inverse of how much its sampler stretches the square of its two numbers.
    fn sample(&self, wo: DVec3, rng: &mut impl Rng, measured: &mut Measured) {
        let mut below = 0.0;
        let [probabilities, _] = bsdf::lobes(&self.double, wo, wo);
        for (lobe, probability) in probabilities.into_iter().enumerate() {
            let chosen = below + 0.5 * probability;
            below += probability;
            for _ in 0..if probability > 0.0 { SAMPLES } else { 0 } {
                let u = [(); 2].map(|()| rng.random_range(0.01..0.99));
                measured.evaluations += 11;
                if let Some(error) = self.density_error(lobe, chosen, wo, u) {
                    measured.worsen(Law::Sampling, error);
                }
            }
        }
    }

    /// None where a sample is refused, or the sampler has a kink within the step, where two steps find different
    /// Jacobians.
    fn density_error(&self, lobe: usize, chosen: f64, wo: DVec3, u: [f64; 2]) -> Option<f64> {
        let at = |du: f64, dv: f64| {
            let u = DVec3::new(chosen, u[0] + du, u[1] + dv);
            let sample = sample(&self.double, wo, u, None);
            (sample.pdf > 0.0).then_some(sample.wi)
        };
        let stretch = |step: f64| {
            let du = at(step, 0.0)? - at(-step, 0.0)?;
            let dv = at(0.0, step)? - at(0.0, -step)?;
            Some(du.cross(dv).length() / (4.0 * step * step))
        };
        let [coarse, fine] = [stretch(STEP)?, stretch(0.5 * STEP)?];
        let density = bsdf::lobes(&self.double, wo, at(0.0, 0.0)?)[1][lobe];
        let is_smooth = (coarse / fine - 1.0).abs() < 1e-4;
        is_smooth.then(|| (density * fine - 1.0).abs())
    }
}

impl Measured {
    fn worsen(&mut self, law: Law, error: f64) {
        let known = &mut self.errors[law as usize];
        // Not a number is the worst.
        *known = known.map(|known| if known >= error { known } else { error });
    }
}
