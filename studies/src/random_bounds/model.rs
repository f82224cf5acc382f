//! A model with random parameters, some of which vary.

use super::bounds::{ALBEDO, greatest_weight};
use super::inputs::{beside, direction, uniform, varying};
use super::{Settings, Tally, is_good};
use crate::shared::batch::{Varying, samples, values};
use crate::shared::bsdf::albedo;
use crate::shared::directions::rng;
use crate::shared::draw::{Drawn, Variant};
use glam::Vec3;
use pellicle::bsdf::Flags;
use pellicle::num::Level;
use pellicle::{Bsdf, Error, Sample};
use rand::{Rng, RngExt};

/// The length of a sampled direction may be off by this. Directions are accepted up to 1e-3 from unit length, and a
/// direction close to the mirror image of such a one is off by at most twice that.
const AS_UNIT: f32 = 2e-3;

/// A model at one level of instructions.
struct Subject {
    drawn: Drawn,
    bsdf: Bsdf,
    level: Level,
}

pub fn run(settings: &Settings, number: usize, variants: &[Variant], tally: &mut Tally) {
    let rng = &mut rng(!settings.seed ^ (number as u64) << 32);
    let levels = Level::all();
    let variant = &variants[rng.random_range(0..variants.len())];
    let varies = [0.0, 0.3, 1.0][rng.random_range(0..3)];
    let (drawn, bsdf) = Drawn::new(variant, varies, rng);
    let model = variant.entry.name();
    tally.draws.insert(model, 1);
    tally
        .varied
        .extend(drawn.varied.iter().map(|varied| ((model, varied.name), 1)));
    let subject = Subject {
        drawn,
        bsdf,
        level: levels[number % levels.len()],
    };
    for _ in 0..settings.batches {
        if let Err(error) = subject.batch(settings.elements, rng, tally) {
            return tally.fail(|| format!("{}: {error}", subject.name()));
        }
    }
    subject.albedo(rng, tally);
}

impl Subject {
    fn name(&self) -> String {
        format!("{:?} {}", self.drawn.description, self.level.name())
    }

    fn varying(&self, count: usize, rng: &mut impl Rng) -> Varying {
        self.drawn.varying(count, rng, |rng, varied, numbers| {
            // Directions may have any length, and any side.
            let range = varied.range.unwrap_or([-0.5, 1.0]);
            numbers.extend((0..varied.components).map(|_| varying(rng, range)));
        })
    }

    fn batch(&self, count: usize, rng: &mut impl Rng, tally: &mut Tally) -> Result<(), Error> {
        let wo: Vec<Vec3> = (0..count).map(|_| direction(rng)).collect();
        let wi: Vec<Vec3> = wo.iter().map(|wo| beside(*wo, rng)).collect();
        let u: Vec<Vec3> = (0..count).map(|_| uniform(rng)).collect();
        let varying = self.varying(count, rng);
        let place =
            |i: usize| format!("{} wo {:?} varying {:?}", self.name(), wo[i], varying.of(i));

        let found = values(&self.bsdf, self.level, &wo, &wi, &varying)?;
        tally.count("bsdf_eval", count);
        for (i, (value, pdf)) in found.into_iter().enumerate() {
            if !value.into_iter().chain([pdf]).all(is_good) {
                tally.fail(|| format!("{} wi {:?}: {value:?} pdf {pdf}", place(i), wi[i]));
            }
        }

        let found = samples(&self.bsdf, self.level, &wo, &u, &varying)?;
        tally.count("bsdf_sample", count);
        for (i, sample) in found.into_iter().enumerate() {
            let greatest = sample.weight.into_iter().fold(0.0, f32::max);
            let bound = greatest_weight(&self.drawn, wo[i], sample.wi, sample.eta);
            let bound = bound.expect("a test sees that every model has a bound");
            let what = || format!("{} u {:?}: {sample:?}", place(i), u[i]);
            if !(is_none(&sample) || self.is_sample(&sample) && greatest <= bound) {
                tally.fail(what);
            }
            tally.weight(self.drawn.entry.name(), greatest / bound, what);
        }
        Ok(())
    }

    /// Whether it is a sample of one of the lobes.
    fn is_sample(&self, sample: &Sample) -> bool {
        let numbers = sample.weight.into_iter().chain([sample.pdf, sample.eta]);
        self.bsdf.flags().contains(sample.flags)
            && sample.lobe < self.bsdf.lobe_infos().len()
            && (sample.wi.length() - 1.0).abs() < AS_UNIT
            && { numbers }.all(is_good)
    }

    fn albedo(&self, rng: &mut impl Rng, tally: &mut Tally) {
        let wo = direction(rng);
        let varying = self.varying(1, rng);
        let albedo = albedo(&self.bsdf, wo, varying.of(0));
        tally.count("bsdf_albedo", 1);
        // Transmitted light counts as radiance, which a dense base concentrates.
        let is_reflecting = !self.bsdf.flags().contains(Flags::TRANSMISSION);
        let info = self.drawn.entry.info;
        let conserves = is_reflecting && !self.drawn.is_excepted(&info.not_conserving);
        let greatest = if conserves { ALBEDO } else { f32::INFINITY };
        if !albedo.into_iter().all(|x| is_good(x) && x <= greatest) {
            let varying = &varying.numbers;
            tally.fail(|| {
                format!(
                    "{} wo {wo:?} varying {varying:?}: albedo {albedo:?}",
                    self.name()
                )
            });
        }
    }
}

fn is_none(sample: &Sample) -> bool {
    sample.flags == Flags(0)
        && sample.weight == [0.0; 3]
        && [sample.pdf, sample.eta] == [0.0; 2]
        && sample.wi == Vec3::ZERO
}
