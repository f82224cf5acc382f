//! A surface with random parameters, and many elements of it: by batches at every level, by single calls, and
//! in double precision.

use super::batch::{Evaluated, Varying, evaluated, sampled};
use super::drawn::varying;
use super::elements;
use super::row::{HORIZON, Quantity, Row};
use super::tally::{FLOOR, relative, relative_in_double};
use super::variants::Variant;
use glam::{DVec3, Vec3};
use pellicle::bsdf::Flags;
use pellicle::num::Level;
use pellicle::{Bsdf, Sample};
use rand::Rng;
use std::fmt::Debug;

/// Four units in the last place of 1: no renderer knows the components of a direction better, and no dot
/// product tells them apart.
const LAST_DIGITS: f64 = 4.0 * f32::EPSILON as f64;

/// Uniform numbers are multiples of it in most renderers.
const LEAST_UNIFORM: f32 = f32::EPSILON / 2.0;

/// `count` elements sampled and as many evaluated, of a new surface.
pub fn check(variant: &Variant, count: usize, rng: &mut impl Rng, row: &mut Row) {
    let (drawn, bsdf) = variant.drawn(rng);
    let double = Bsdf::<f64>::new(&drawn.description).unwrap();
    let mut numbers = Vec::new();
    for _ in 0..count {
        varying(&drawn.ranges, rng, &mut numbers);
    }
    let wo: Vec<Vec3> = (0..count).map(|_| elements::viewer(rng)).collect();
    let u: Vec<Vec3> = (0..count).map(|_| elements::uniform(rng)).collect();
    let surface = Surface {
        single: &bsdf,
        double: &double,
        text: &drawn.text,
        wo: &wo,
        varying: Varying {
            numbers: &numbers,
            floats: bsdf.varying_floats(),
            components: bsdf.varying_components().collect(),
        },
    };
    let found = surface.check_samples(&u, row);
    let is_found = |sample: &Sample| sample.pdf > 0.0;
    let wi = wo.iter().zip(&found).map(|(wo, sample)| {
        elements::light(rng, *wo, Some(sample).filter(|s| is_found(s)).map(|s| s.wi))
    });
    surface.check_values(&wi.collect::<Vec<Vec3>>(), row);
    row.evaluations += 2 * count as u64;
}

struct Surface<'a> {
    single: &'a Bsdf<f32>,
    double: &'a Bsdf<f64>,
    text: &'a str,
    wo: &'a [Vec3],
    varying: Varying<'a>,
}

impl Surface<'_> {
    fn place(&self, i: usize, other: &str, w: Vec3, what: String) -> String {
        let varying = self.varying.of(i).unwrap_or_default();
        format!(
            "{}; varying {varying:?}, wo {:?}, {other} {:?}: {what}",
            self.text,
            self.wo[i].to_array(),
            w.to_array()
        )
    }

    fn in_double(&self, i: usize) -> Option<Vec<f64>> {
        let varying = self.varying.of(i)?;
        Some(varying.iter().copied().map(f64::from).collect())
    }

    /// At every level, and by single calls: the first is what the others are compared with.
    fn check_values(&self, wi: &[Vec3], row: &mut Row) {
        let count = self.wo.len();
        let truth: Vec<([f64; 3], f64)> = (0..count)
            .map(|i| {
                let varying = self.in_double(i);
                let (wo, wi) = (self.wo[i].as_dvec3(), wi[i].as_dvec3());
                self.double.eval_pdf(wo, wi, varying.as_deref())
            })
            .collect();
        let add = |i: usize, (value, pdf): Evaluated, row: &mut Row| {
            let (true_value, true_pdf) = truth[i];
            let [of_value, of_pdf] = kinds([self.wo[i], wi[i]]);
            let spread = || self.spread(i, wi[i].as_dvec3(), true_value, true_pdf);
            let error = relative(value, true_value);
            row.add_or_excuse(
                of_value,
                error,
                || spread().0,
                || self.place(i, "wi", wi[i], format!("{value:?}, not {true_value:?}")),
            );
            let error = relative([pdf], [true_pdf]);
            row.add_or_excuse(
                of_pdf,
                error,
                || spread().1,
                || self.place(i, "wi", wi[i], format!("{pdf:e}, not {true_pdf:e}")),
            );
        };
        let levels = Level::all();
        let first = evaluated(self.single, levels[0], self.wo, wi, &self.varying);
        for (i, found) in first.iter().enumerate() {
            add(i, *found, row);
        }
        let singles = || {
            let single = |i| self.single.eval_pdf(self.wo[i], wi[i], self.varying.of(i));
            (0..count).map(single).collect()
        };
        let bits = |(value, pdf): Evaluated| (value.map(f32::to_bits), pdf.to_bits());
        for (name, found) in others(
            &levels,
            |level| evaluated(self.single, level, self.wo, wi, &self.varying),
            singles,
        ) {
            for (i, (first, found)) in first.iter().zip(&found).enumerate() {
                if bits(*first) == bits(*found) {
                    continue;
                }
                let difference = relative(found.0, first.0.map(f64::from))
                    .max(relative([found.1], [f64::from(first.1)]));
                row.add_difference(difference, || {
                    self.place(i, "wi", wi[i], format!("{name}: {found:?}, not {first:?}"))
                });
                add(i, *found, row);
            }
        }
    }

    fn check_samples(&self, u: &[Vec3], row: &mut Row) -> Vec<Sample> {
        let count = self.wo.len();
        let levels = Level::all();
        let first = sampled(self.single, levels[0], self.wo, u, &self.varying);
        for (i, found) in first.iter().enumerate() {
            self.add_sample(i, u[i], found, row);
        }
        let singles = || {
            let single = |i| self.single.sample(self.wo[i], u[i], self.varying.of(i));
            (0..count).map(single).collect()
        };
        for (name, found) in others(
            &levels,
            |level| sampled(self.single, level, self.wo, u, &self.varying),
            singles,
        ) {
            for (i, (first, found)) in first.iter().zip(&found).enumerate() {
                if sample_bits(first) == sample_bits(found) {
                    continue;
                }
                // Of another lobe, nothing need be alike: f64 tells below how often that happens.
                let difference = if first.lobe == found.lobe && first.flags == found.flags {
                    f64::from((found.wi - first.wi).length())
                } else {
                    0.0
                };
                row.add_difference(difference, || {
                    self.place(i, "u", u[i], format!("{name}: {found:?}, not {first:?}"))
                });
                self.add_sample(i, u[i], found, row);
            }
        }
        first
    }

    fn add_sample(&self, i: usize, u: Vec3, found: &Sample, row: &mut Row) {
        let varying = self.in_double(i);
        let varying = varying.as_deref();
        let wo = self.wo[i].as_dvec3();
        let double = self.double.sample(wo, u.as_dvec3(), varying);
        // The least numbers that renderers draw: below, 2 u - 1 is -1 in single precision, and where a
        // quantile is infinite each precision has a limit of its own.
        if u.min_element() >= LEAST_UNIFORM {
            self.add_direction(i, u, found, &double, row);
        }
        if found.flags == Flags(0) {
            return;
        }
        let place = |truth: &dyn Debug, found_number: &dyn Debug| {
            let what = format!("{found_number:?}, not {truth:?} at {:?}", found.wi);
            self.place(i, "u", u, what)
        };
        if found.flags.contains(Flags::DELTA) {
            if found.lobe == double.lobe {
                let error = relative(found.weight, double.weight);
                row.add(Quantity::Weight, error, || {
                    place(&double.weight, &found.weight)
                });
            }
            return;
        }
        let wi = found.wi.as_dvec3();
        let (value, pdf) = self.double.eval_pdf(wo, wi, varying);
        let spread = || self.spread(i, wi, value, pdf);
        let [of_value, of_pdf] = kinds([self.wo[i], found.wi]);
        let of_weight = if of_value == Quantity::Value {
            Quantity::Weight
        } else {
            of_value
        };
        let estimate = found.weight.map(|channel| f64::from(channel) * pdf);
        let error = relative_in_double(estimate, value);
        let brightest = value.into_iter().fold(0.0, f64::max);
        let weight = f64::from(found.weight.into_iter().fold(0.0, f32::max));
        let share = weight * (FLOOR + pdf) / (FLOOR + brightest);
        let of_both = || spread().0 + share * spread().1;
        row.add_or_excuse(of_weight, error, of_both, || {
            place(&value.map(|channel| channel / pdf), &found.weight)
        });
        let error = relative([found.pdf], [pdf]);
        row.add_or_excuse(of_pdf, error, || spread().1, || place(&pdf, &found.pdf));
    }

    fn add_direction(
        &self,
        i: usize,
        u: Vec3,
        found: &Sample,
        double: &Sample<f64>,
        row: &mut Row,
    ) {
        row.samples += 1;
        if (found.lobe, found.flags) != (double.lobe, double.flags) {
            row.add_switched(|| self.place(i, "u", u, format!("{found:?}, not {double:?}")));
        } else if double.flags != Flags(0) {
            let distance = found.wi.as_dvec3().distance(double.wi);
            let spread = || self.spread_of_samples(i, u.as_dvec3(), double);
            row.add_or_excuse(Quantity::Direction, distance, spread, || {
                self.place(i, "u", u, format!("{:?}, not {:?}", found.wi, double.wi))
            });
        }
    }

    /// How far [`LAST_DIGITS`] of the directions' components move value and density, in the measure of both.
    fn spread(&self, i: usize, wi: DVec3, value: [f64; 3], pdf: f64) -> (f64, f64) {
        let varying = self.in_double(i);
        let of_both = over_last_digits(self.wo[i].as_dvec3(), wi, |wo, wi| {
            let moved = self.double.eval_pdf(wo, wi, varying.as_deref());
            [
                relative_in_double(moved.0, value),
                relative_in_double([moved.1], [pdf]),
            ]
        });
        (of_both[0], of_both[1])
    }

    /// The same of a sampled direction, for those of the viewer's direction and the uniform numbers.
    fn spread_of_samples(&self, i: usize, u: DVec3, double: &Sample<f64>) -> f64 {
        let varying = self.in_double(i);
        let [distance] = over_last_digits(self.wo[i].as_dvec3(), u, |wo, u| {
            let u = u.clamp(DVec3::ZERO, DVec3::splat(1.0 - f64::EPSILON));
            let moved = self.double.sample(wo, u, varying.as_deref());
            [moved.wi.distance(double.wi)]
        });
        distance
    }
}

/// The sum over all components of the greater of both changes that [`LAST_DIGITS`] make.
fn over_last_digits<const N: usize>(
    a: DVec3,
    b: DVec3,
    change: impl Fn(DVec3, DVec3) -> [f64; N],
) -> [f64; N] {
    let mut sums = [0.0; N];
    for axis in DVec3::AXES {
        for [in_a, in_b] in [[1.0, 0.0], [0.0, 1.0]] {
            let step = axis * LAST_DIGITS;
            let [up, down] =
                [1.0, -1.0].map(|sign| change(a + step * in_a * sign, b + step * in_b * sign));
            for (sum, (up, down)) in sums.iter_mut().zip(up.into_iter().zip(down)) {
                *sum += up.max(down);
            }
        }
    }
    sums
}

/// What values and densities between these directions count as.
fn kinds(directions: [Vec3; 2]) -> [Quantity; 2] {
    if directions.iter().any(|w| w.z.abs() < HORIZON) {
        [Quantity::Horizon; 2]
    } else {
        [Quantity::Value, Quantity::Pdf]
    }
}

/// What the levels but the first find, and what single calls do.
fn others<T>(
    levels: &[Level],
    batch: impl Fn(Level) -> Vec<T>,
    singles: impl FnOnce() -> Vec<T>,
) -> Vec<(&'static str, Vec<T>)> {
    let more = levels[1..].iter();
    let mut all: Vec<_> = more.map(|level| (level.name(), batch(*level))).collect();
    all.push(("single call", singles()));
    all
}

fn sample_bits(sample: &Sample) -> [u32; 10] {
    let ([a, b, c], [d, e, f]) = (sample.wi.to_array(), sample.weight);
    let [a, b, c, d, e, f, g, h] = [a, b, c, d, e, f, sample.pdf, sample.eta].map(f32::to_bits);
    [a, b, c, d, e, f, g, h, sample.flags.0, sample.lobe as u32]
}
