//! Errors of colours, and those of a table between its values.

use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits, FitTask};
use crate::num::spline::FARTHEST;
use crate::num::{Lane, Rgb};

/// Errors of single channels.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::film) struct Errors {
    /// The greatest error.
    pub max: f64,
    /// The sum of the squares.
    squares: f64,
    /// The number of channels compared.
    count: usize,
}

/// The number of cosines near grazing incidence that are measured too, and their range.
const GRAZING: usize = 24;
const GREATEST_GRAZING: f64 = 0.2;
const LEAST_GRAZING: f64 = 1e-5;
/// A table is measured again around this number of its worst points.
const WORST: usize = 16;
/// The number of points along each coordinate around a worst point, and how far they reach, in
/// intervals.
const AROUND: usize = 6;
const CLOSE: f64 = 1.0;

impl Errors {
    /// Adds the differences of two colours, clipped to [0, 1] unless `unclipped`, and returns the
    /// greatest. A difference that is NaN counts as infinite.
    pub(in crate::film) fn add(
        &mut self,
        found: Rgb<f64>,
        expected: Rgb<f64>,
        unclipped: bool,
    ) -> f64 {
        let displayed = |x: f64| if unclipped { x } else { x.clamp(0.0, 1.0) };
        let mut worst = 0.0f64;
        for c in 0..3 {
            let error = (displayed(found[c]) - displayed(expected[c])).abs();
            // max() would ignore a NaN.
            let error = if error.is_nan() { f64::INFINITY } else { error };
            self.squares += error * error;
            worst = worst.max(error);
        }
        self.count += 3;
        self.max = self.max.max(worst);
        worst
    }

    /// Adds other errors.
    pub(in crate::film) fn merge(&mut self, other: &Self) {
        self.max = self.max.max(other.max);
        self.squares += other.squares;
        self.count += other.count;
    }

    /// The root of the mean square.
    pub(in crate::film) fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

/// The errors between the values of a table over the cosine alone. Value i is at the cosine `at(i)`.
pub(super) fn over_cosine(
    source: &mut ColorSource<'_>,
    table: &SplineTable,
    count: usize,
    limits: FitLimits,
    at: impl Fn(f64) -> f64,
) -> Errors {
    let mut errors = Errors::default();
    for i in 0..count - 1 {
        for t in [FARTHEST, 1.0 - FARTHEST] {
            let c = at(i as f64 + t);
            let found = color(table, c, 0.0);
            errors.add(found, source(c, 0.0), limits.unclipped);
        }
    }
    errors
}

/// A table's colour, in double precision.
fn color(table: &SplineTable, cos_theta: f64, thickness_nm: f64) -> Rgb<f64> {
    f32::channels(table.at(cos_theta as f32, thickness_nm as f32)).map(f64::from)
}

/// The errors between the values of a table over both coordinates, measured where they are greatest
/// within an interval; and, at the worst point, the errors along each coordinate alone. Value (i, j) is
/// at the cosine and thickness `point(i, j)`.
pub(super) fn over_both(
    task: &mut FitTask<'_>,
    table: &SplineTable,
    [width, height]: [usize; 2],
    point: &impl Fn(f64, f64) -> (f64, f64),
) -> (Errors, [f64; 2]) {
    let limits = task.limits;
    let [least, greatest] = task.range;
    let mut errors = Errors::default();
    let mut worst: Vec<(f64, [f64; 2])> = Vec::new();
    let measure = |task: &mut FitTask<'_>, i: f64, j: f64, errors: &mut Errors| {
        let (c, d) = point(i, j);
        // The part of the table beyond the range of the thickness is never looked up.
        if d > greatest && point(i, j.floor() - 1.0).1 > greatest {
            return 0.0;
        }
        let d = d.clamp(least, greatest);
        let found = color(table, c, d);
        errors.add(found, (task.source)(c, d), limits.unclipped)
    };
    // Each interval has two points where the error is greatest: they take turns. At the ends, where
    // the error has another shape, both and the middle are measured.
    const SIDES: [f64; 3] = [FARTHEST, 1.0 - FARTHEST, 0.5];
    let sides = |i: usize, count: usize| {
        let is_end = i < 2 || i + 3 >= count;
        let sides = if is_end {
            &SIDES[..]
        } else {
            &SIDES[i % 2..][..1]
        };
        sides.iter().map(move |side| i as f64 + side)
    };
    for x in (0..width - 1).flat_map(|i| sides(i, width)) {
        for y in (0..height - 1).flat_map(|j| sides(j, height)) {
            let error = measure(task, x, y, &mut errors);
            if worst.len() < WORST {
                worst.push((error, [x, y]));
            } else if error > worst[WORST - 1].0 {
                worst[WORST - 1] = (error, [x, y]);
            } else {
                continue;
            }
            worst.sort_by(|a, b| b.0.total_cmp(&a.0));
        }
    }
    // The top of a narrow peak may lie beside the points above.
    for &(_, [x, y]) in &worst {
        let inside = |at: f64, step: usize, count: usize| {
            let offset = CLOSE * ((step as f64 + 0.5) / AROUND as f64 * 2.0 - 1.0);
            (at + offset).clamp(0.0, (count - 1) as f64)
        };
        for i in 0..AROUND {
            for j in 0..AROUND {
                measure(task, inside(x, i, width), inside(y, j, height), &mut errors);
            }
        }
    }
    // At grazing angles features are narrower than an interval.
    for i in 0..GRAZING {
        let c =
            GREATEST_GRAZING * (LEAST_GRAZING / GREATEST_GRAZING).powf(i as f64 / GRAZING as f64);
        for j in 0..GRAZING / 2 {
            let part = (0.5 + 0.618_034 * (i + j * GRAZING) as f64).fract();
            let d = least + part * part * (greatest - least);
            let found = color(table, c, d);
            errors.add(found, (task.source)(c, d), limits.unclipped);
        }
    }
    let [x, y] = worst.first().map_or([0.0; 2], |worst| worst.1);
    let mut aside = Errors::default();
    let across = measure(task, x, y.round(), &mut aside);
    let along = measure(task, x.round(), y, &mut aside);
    (errors, [across, along])
}
