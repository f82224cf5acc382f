//! Models with random parameters, some of which vary.

use super::bounds::{ALBEDO, greatest_weight};
use super::common::{Drawn, rng};
use super::inputs::{beside, direction, uniform, varying};
use super::planes::Planes;
use super::{BATCH, Settings, Tally};
use glam::Vec3;
use pellicle::batch::{ConstView, EvalArgs, SampleArgs, eval, sample};
use pellicle::bsdf::{Flags, models};
use pellicle::num::Level;
use pellicle::{Bsdf, Description};
use rand::{Rng, RngExt};

/// Of the albedo, which is a quadrature.
const ALBEDOS: usize = 1;

/// Directions are accepted up to 1e-3 from unit length; what lies about a mirror image of such a one is off
/// by twice that at most.
const AS_UNIT: f32 = 2e-3;

/// A BSDF and what its varying numbers are drawn from.
struct Subject {
    drawn: Drawn,
    description: Description,
    bsdf: Bsdf,
    ranges: Vec<[f32; 2]>,
    conserves: bool,
    level: Level,
}

pub fn run(settings: &Settings, number: usize, tally: &mut Tally) {
    let rng = &mut rng(!settings.seed ^ (number as u64) << 32);
    let levels = Level::all();
    let subject = subject(settings, number, levels[number % levels.len()], rng);
    for _ in 0..settings.batches {
        if let Err(error) = subject.batch(rng, tally) {
            return tally.fail(|| format!("{}: {error}", subject.name()));
        }
    }
    for _ in 0..ALBEDOS {
        subject.albedo(rng, tally);
    }
}

/// Random parameters, each of which varies or not by a coin, as far as the model allows it.
fn subject(settings: &Settings, number: usize, level: Level, rng: &mut impl Rng) -> Subject {
    let entries = models();
    let entry = &entries[number % entries.len()];
    let seed = settings.seed.wrapping_mul(1_000_003) + (number / entries.len()) as u64;
    let drawn = Drawn::new(entry, seed);
    let share = [0.0, 0.3, 1.0][rng.random_range(0..3)];
    let (description, varying) = drawn.varying(|| rng.random_bool(share));
    let mut ranges = Vec::new();
    for (components, range) in varying {
        // Directions are of any length.
        let range = if range == [0.0; 2] {
            [-0.5, 1.0]
        } else {
            range
        };
        ranges.extend(vec![range; components]);
    }
    Subject {
        bsdf: Bsdf::new(&description).unwrap(),
        conserves: !drawn.is_excepted(&entry.info.not_conserving),
        drawn,
        description,
        ranges,
        level,
    }
}

impl Subject {
    fn name(&self) -> String {
        format!("{:?} {}", self.description, self.level.name())
    }

    fn batch(&self, rng: &mut impl Rng, tally: &mut Tally) -> Result<(), pellicle::Error> {
        let mut wo = Planes::<f32, 3>::new(0.0);
        let (mut wi, mut u) = (Planes::<f32, 3>::new(0.0), Planes::<f32, 3>::new(0.0));
        for i in 0..BATCH {
            let to_viewer = direction(rng);
            wo.set(i, to_viewer.to_array());
            wi.set(i, beside(to_viewer, rng).to_array());
            u.set(i, uniform(rng).to_array());
        }
        let numbers = self.numbers(BATCH, rng);
        let views = self.views(&numbers);
        let varying_of = |i: usize| &numbers[i * self.ranges.len()..][..self.ranges.len()];

        let (mut value, mut pdf) = (
            Planes::<f32, 3>::new(f32::NAN),
            Planes::<f32, 1>::new(f32::NAN),
        );
        let args = EvalArgs {
            count: BATCH,
            wo: wo.const_view(),
            wi: wi.const_view(),
            varying: &views,
            value: value.view(),
            pdf: pdf.view(),
        };
        // SAFETY: all views are of arrays of BATCH elements.
        unsafe { eval(&self.bsdf, &args, self.level)? };
        tally.count("bsdf_eval", BATCH);
        for i in 0..BATCH {
            let (value, [pdf]) = (value.get(i), pdf.get(i));
            if !value.into_iter().chain([pdf]).all(is_good) {
                tally.fail(|| {
                    let (wo, wi) = (wo.get(i), wi.get(i));
                    format!(
                        "{} wo {wo:?} wi {wi:?} varying {:?}: {value:?} pdf {pdf}",
                        self.name(),
                        varying_of(i)
                    )
                });
            }
        }

        let (mut pdf, mut eta) = (
            Planes::<f32, 1>::new(f32::NAN),
            Planes::<f32, 1>::new(f32::NAN),
        );
        let (mut found, mut weight) = (
            Planes::<f32, 3>::new(f32::NAN),
            Planes::<f32, 3>::new(f32::NAN),
        );
        let (mut flags, mut lobe) = (
            Planes::<u32, 1>::new(u32::MAX),
            Planes::<u32, 1>::new(u32::MAX),
        );
        let args = SampleArgs {
            count: BATCH,
            wo: wo.const_view(),
            u: u.const_view(),
            varying: &views,
            wi: found.view(),
            pdf: pdf.view(),
            weight: weight.view(),
            eta: eta.view(),
            flags: flags.view(),
            lobe: lobe.view(),
        };
        // SAFETY: all views are of arrays of BATCH elements.
        unsafe { sample(&self.bsdf, &args, self.level)? };
        tally.count("bsdf_sample", BATCH);
        for i in 0..BATCH {
            let (weight, [pdf], [eta], [flags]) =
                (weight.get(i), pdf.get(i), eta.get(i), flags.get(i));
            let wi = Vec3::from(found.get(i));
            let greatest = weight.into_iter().fold(0.0, f32::max);
            let what = || {
                let (wo, u) = (wo.get(i), u.get(i));
                format!(
                    "{} wo {wo:?} u {u:?} varying {:?}: wi {wi} weight {weight:?} pdf {pdf} eta {eta}",
                    self.name(),
                    varying_of(i)
                )
            };
            let is_none =
                flags == 0 && weight == [0.0; 3] && pdf == 0.0 && eta == 0.0 && wi == Vec3::ZERO;
            let is_sample = self.bsdf.flags().contains(Flags(flags))
                && (lobe.get(i)[0] as usize) < self.bsdf.lobe_infos().len()
                && (wi.length() - 1.0).abs() < AS_UNIT
                && weight.into_iter().chain([pdf, eta]).all(is_good);
            let bound = greatest_weight(&self.drawn, Vec3::from(wo.get(i)), wi, eta);
            if !(is_none || is_sample && greatest <= bound) {
                tally.fail(what);
            }
            tally.weight(self.drawn.entry.name(), greatest / bound, what);
        }
        Ok(())
    }

    /// Of so many elements, one element after another.
    fn numbers(&self, elements: usize, rng: &mut impl Rng) -> Vec<f32> {
        let ranges = self
            .ranges
            .iter()
            .cycle()
            .take(elements * self.ranges.len());
        ranges.map(|[min, max]| varying(rng, *min, *max)).collect()
    }

    fn views(&self, numbers: &[f32]) -> Vec<ConstView> {
        let mut first = 0;
        let view = |components| {
            let view = ConstView {
                data: numbers[first..].as_ptr(),
                element_stride: 4 * self.ranges.len() as isize,
                component_stride: 4,
            };
            first += components;
            view
        };
        self.bsdf.varying_components().map(view).collect()
    }

    fn albedo(&self, rng: &mut impl Rng, tally: &mut Tally) {
        let wo = direction(rng);
        let numbers = self.numbers(1, rng);
        let varying = (!numbers.is_empty()).then_some(&numbers[..]);
        let albedo = self.bsdf.albedo(wo, varying);
        tally.count("bsdf_albedo", 1);
        // Transmitted light counts as radiance, which a dense base concentrates.
        let is_reflecting = !self.bsdf.flags().contains(Flags::TRANSMISSION);
        let greatest = if self.conserves && is_reflecting {
            ALBEDO
        } else {
            f32::INFINITY
        };
        if !albedo.into_iter().all(|x| is_good(x) && x <= greatest) {
            tally.fail(|| {
                format!(
                    "{} wo {wo:?} varying {numbers:?}: albedo {albedo:?}",
                    self.name()
                )
            });
        }
    }
}

/// What every result is.
fn is_good(x: f32) -> bool {
    x.is_finite() && x >= 0.0
}
