//! A surface with random parameters and many elements of it: by batches at every level, by single calls, and in
//! double precision.

use super::row::{HORIZON, Quantity, Row};
use super::tally::{FLOOR, relative, relative_in_double};
use super::{at_every_level, elements};
use crate::shared::batch::{Evaluated, Varying, samples, values};
use crate::shared::bsdf::{sample, value_pdf};
use crate::shared::directions::{hemisphere, number};
use crate::shared::draw::{Drawn, Variant};
use glam::{DVec3, Vec3};
use pellicle::bsdf::Flags;
use pellicle::{Bsdf, Sample};
use rand::{Rng, RngExt};
use std::fmt::Debug;

/// Four units in the last place of 1: no renderer knows the components of a direction better, and no dot product
/// tells them apart.
const LAST_DIGITS: f64 = 4.0 * f32::EPSILON as f64;

/// The least uniform number that most renderers draw: theirs are multiples of it.
const LEAST_UNIFORM: f32 = f32::EPSILON / 2.0;

/// Samples a new surface at `count` elements and evaluates it at the same number.
pub fn check(variant: &Variant, count: usize, rng: &mut impl Rng, row: &mut Row) {
    let varies = if rng.random_bool(0.5) { 0.5 } else { 0.0 };
    let (drawn, bsdf) = Drawn::new(variant, varies, rng);
    let varying = drawn.varying(count, rng, |rng, varied, numbers| match varied.range {
        Some([min, max]) => numbers.extend((0..varied.components).map(|_| number(rng, min, max))),
        // Directions may have any length.
        None => numbers.extend((hemisphere(rng) * 2.0).as_vec3().to_array()),
    });
    let surface = Surface {
        double: Bsdf::new(&drawn.description).unwrap(),
        single: bsdf,
        drawn: &drawn,
        wo: (0..count).map(|_| elements::viewer(rng)).collect(),
        varying,
    };
    let u: Vec<Vec3> = (0..count).map(|_| elements::uniform(rng)).collect();
    let found = surface.check_samples(&u, row);
    let wi = surface.wo.iter().zip(&found).map(|(wo, sample)| {
        let sampled = (sample.pdf > 0.0).then_some(sample.wi);
        elements::light(rng, *wo, sampled)
    });
    surface.check_values(&wi.collect::<Vec<Vec3>>(), row);
    row.evaluations += 2 * count as u64;
}

struct Surface<'a> {
    single: Bsdf<f32>,
    double: Bsdf<f64>,
    drawn: &'a Drawn,
    wo: Vec<Vec3>,
    varying: Varying,
}

impl Surface<'_> {
    fn place(&self, i: usize, other: &str, w: Vec3, what: String) -> String {
        format!(
            "{:?}; varying {:?}, wo {:?}, {other} {:?}: {what}",
            self.drawn.description,
            self.varying.of(i).unwrap_or_default(),
            self.wo[i].to_array(),
            w.to_array()
        )
    }

    fn varying_in_double(&self, i: usize) -> Option<Vec<f64>> {
        let varying = self.varying.of(i)?;
        Some(varying.iter().copied().map(f64::from).collect())
    }

    fn value_in_double(&self, i: usize, wo: DVec3, wi: DVec3) -> ([f64; 3], f64) {
        let varying = self.varying_in_double(i);
        value_pdf(&self.double, wo, wi, varying.as_deref())
    }

    fn check_values(&self, wi: &[Vec3], row: &mut Row) {
        let in_double =
            |(i, wi): (usize, &Vec3)| self.value_in_double(i, self.wo[i].as_dvec3(), wi.as_dvec3());
        let truth: Vec<([f64; 3], f64)> = wi.iter().enumerate().map(in_double).collect();
        let bits = |(value, pdf): &Evaluated| (value.map(f32::to_bits), pdf.to_bits());
        at_every_level(
            |level| values(&self.single, level, &self.wo, wi, &self.varying).unwrap(),
            |i| value_pdf(&self.single, self.wo[i], wi[i], self.varying.of(i)),
            |first, found| bits(first) == bits(found),
            |i, found, other| {
                let place = |what: String| self.place(i, "wi", wi[i], what);
                if let Some((name, first)) = other {
                    let difference = relative(found.0, first.0.map(f64::from))
                        .max(relative([found.1], [f64::from(first.1)]));
                    row.add_difference(difference, || {
                        place(format!("{name}: {found:?}, not {first:?}"))
                    });
                }
                let ((value, pdf), (true_value, true_pdf)) = (*found, truth[i]);
                let [of_value, of_pdf] = kinds([self.wo[i], wi[i]]);
                let spread = || self.spread(i, wi[i].as_dvec3(), true_value, true_pdf);
                row.add_or_excuse(
                    of_value,
                    relative(value, true_value),
                    || spread()[0],
                    || place(format!("{value:?}, not {true_value:?}")),
                );
                row.add_or_excuse(
                    of_pdf,
                    relative([pdf], [true_pdf]),
                    || spread()[1],
                    || place(format!("{pdf:e}, not {true_pdf:e}")),
                );
            },
        );
    }

    fn check_samples(&self, u: &[Vec3], row: &mut Row) -> Vec<Sample> {
        at_every_level(
            |level| samples(&self.single, level, &self.wo, u, &self.varying).unwrap(),
            |i| sample(&self.single, self.wo[i], u[i], self.varying.of(i)),
            |first, found| bits(first) == bits(found),
            |i, found, other| {
                if let Some((name, first)) = other {
                    // Samples of different lobes have nothing in common. f64 tells below how often that happens.
                    let is_alike = first.lobe == found.lobe && first.flags == found.flags;
                    let distance = f64::from((found.wi - first.wi).length());
                    row.add_difference(if is_alike { distance } else { 0.0 }, || {
                        self.place(i, "u", u[i], format!("{name}: {found:?}, not {first:?}"))
                    });
                }
                self.add_sample(i, u[i], found, row);
            },
        )
    }

    fn add_sample(&self, i: usize, u: Vec3, found: &Sample, row: &mut Row) {
        let varying = self.varying_in_double(i);
        let wo = self.wo[i].as_dvec3();
        let double = sample(&self.double, wo, u.as_dvec3(), varying.as_deref());
        // Below the least number that renderers draw, 2 u - 1 is -1 in single precision, and where a quantile is
        // infinite each precision has a limit of its own.
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
        let (value, pdf) = self.value_in_double(i, wo, wi);
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
        let of_both = || spread()[0] + share * spread()[1];
        row.add_or_excuse(of_weight, error, of_both, || {
            place(&value.map(|channel| channel / pdf), &found.weight)
        });
        let error = relative([found.pdf], [pdf]);
        row.add_or_excuse(of_pdf, error, || spread()[1], || place(&pdf, &found.pdf));
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
    fn spread(&self, i: usize, wi: DVec3, value: [f64; 3], pdf: f64) -> [f64; 2] {
        over_last_digits(self.wo[i].as_dvec3(), wi, |wo, wi| {
            let moved = self.value_in_double(i, wo, wi);
            [
                relative_in_double(moved.0, value),
                relative_in_double([moved.1], [pdf]),
            ]
        })
    }

    /// How far those of the viewer's direction and of the uniform numbers move a sampled direction.
    fn spread_of_samples(&self, i: usize, u: DVec3, double: &Sample<f64>) -> f64 {
        let varying = self.varying_in_double(i);
        let [distance] = over_last_digits(self.wo[i].as_dvec3(), u, |wo, u| {
            let u = u.clamp(DVec3::ZERO, DVec3::splat(1.0 - f64::EPSILON));
            let moved = sample(&self.double, wo, u, varying.as_deref());
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

/// The quantities that value and density between these directions belong to.
fn kinds(directions: [Vec3; 2]) -> [Quantity; 2] {
    if directions.iter().any(|w| w.z.abs() < HORIZON) {
        [Quantity::Horizon; 2]
    } else {
        [Quantity::Value, Quantity::Pdf]
    }
}

fn bits(sample: &Sample) -> ([u32; 3], [u32; 3], [u32; 2], Flags, usize) {
    let [wi, weight] = [sample.wi.to_array(), sample.weight].map(|v| v.map(f32::to_bits));
    let numbers = [sample.pdf, sample.eta].map(f32::to_bits);
    (wi, weight, numbers, sample.flags, sample.lobe)
}
