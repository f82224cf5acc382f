//! The axes of a table, by how quickly the colours change along them.

use super::super::axes::{LEAST_NM, Shape};
use super::{Limits, Source, Task};
use crate::num::Rgb;

/// The part that each coordinate is meant to have.
const EACH: f64 = 0.33;
/// The error of a quadratic spline in an interval h is h^3 f''' times max |t^3 - t / 4| / 6 = 1 / 124.7.
const LEADING: f64 = 1.0 / 124.7;
/// Points of the lines along which the axes are chosen.
const ALONG_COSINE: usize = 120;
const ALONG_THICKNESS: usize = 160;
/// The candidates for gamma of [`Shape`], and for the thickness at which it has half its value.
const SCALES: [f64; 8] = [0.03, 0.07, 0.15, 0.3, 0.5, 1.0, 2.0, 1e3];
const HALVES_NM: [f64; 4] = [0.0, 30.0, 100.0, 300.0];
/// Far below [`LEAST_NM`], but more than 0, which would make gamma vanish.
const VANISHING_NM: f64 = 1e-7 * LEAST_NM;
const FADES: [f64; 8] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0];

/// Values along a line, and how densely a spline must be set there: values per unit of the line's own
/// parameter, by the third differences.
struct Line {
    t: Vec<f64>,
    density: Vec<f64>,
}

impl Line {
    fn new(t: Vec<f64>, values: &[Rgb<f64>], limits: &Limits) -> Self {
        // Where colours are clipped the table is not measured, but its spline must be smooth a little way
        // beyond.
        let seen = |x: f64| {
            if limits.unclipped {
                x
            } else {
                x.clamp(-0.1, 1.1)
            }
        };
        let density = (0..t.len()).map(|i| {
            let first = i.saturating_sub(1).min(t.len() - 4);
            let third = (0..3)
                .map(|c| {
                    let mut divided: [f64; 4] = std::array::from_fn(|k| seen(values[first + k][c]));
                    for order in 1..4 {
                        for k in 0..4 - order {
                            divided[k] = (divided[k + 1] - divided[k])
                                / (t[first + k + order] - t[first + k]);
                        }
                    }
                    (6.0 * divided[0]).abs()
                })
                .fold(0.0, f64::max);
            (third * LEADING / (EACH * limits.tolerance)).cbrt()
        });
        Self {
            density: density.collect(),
            t,
        }
    }

    /// How many values a coordinate needs whose change with the line's parameter is `slope`.
    fn count(&self, slope: impl Fn(f64) -> f64) -> f64 {
        let each = self.t.iter().zip(&self.density);
        each.map(|(t, density)| density / slope(*t).max(1e-12))
            .fold(0.0, f64::max)
    }
}

/// The axes with which the fewest values are needed over the cosine alone, and how many.
pub(super) fn of_curve(source: &mut Source<'_>, limits: &Limits) -> (Shape, f64) {
    let t = cosines();
    let values: Vec<_> = t.iter().map(|&c| source(c, 0.0)).collect();
    let line = Line::new(t, &values, limits);
    let (count, scale) = fewest(SCALES.map(|scale| {
        let slope = |c: f64| scale * (1.0 + scale) / (c + scale).powi(2);
        (line.count(slope), scale)
    }));
    let shape = Shape {
        scale,
        least: 1.0,
        half: 1.0,
        tilt: 0.0,
        fade: 1.0,
    };
    (shape, count)
}

/// The axes with which the fewest values are needed, and how many. Those whose gamma depends on the
/// thickness must be so many times better.
pub(super) fn of_table(task: &mut Task<'_>, handicap: f64) -> (Shape, [f64; 2]) {
    let (height, fade) = along_thickness(task);
    let (width, shape) = along_cosine(task, handicap, fade);
    (shape, [width, height])
}

/// Along the thickness, at some cosines: how many values are needed, and the fade with which.
fn along_thickness(task: &mut Task<'_>) -> (f64, f64) {
    let limits = task.limits;
    let [least, greatest] = task.range;
    let extent = greatest - least;
    let dense = 10.0;
    let lines: Vec<Line> = [1.0, 0.4, 0.1, 0.02]
        .into_iter()
        .map(|c| {
            let count = ALONG_THICKNESS;
            let t = (0..count).map(|i| {
                let y = i as f64 / (count - 1) as f64;
                extent * y / (1.0 + dense * (1.0 - y))
            });
            let t: Vec<f64> = t.collect();
            let values: Vec<_> = t.iter().map(|d| (task.source)(c, least + d)).collect();
            Line::new(t, &values, &limits)
        })
        .collect();
    fewest(FADES.map(|fade| {
        let slope = |d: f64| (1.0 + fade) / (extent * (1.0 + fade * d / extent).powi(2));
        let count = lines
            .iter()
            .map(|line| line.count(slope))
            .fold(0.0, f64::max);
        (count, fade)
    }))
}

/// Along the cosine, at some thicknesses, with upright fringes and without: how many values are needed,
/// and the axes with which.
fn along_cosine(task: &mut Task<'_>, handicap: f64, fade: f64) -> (f64, Shape) {
    let limits = task.limits;
    let extent = task.range[1] - task.range[0];
    let mut best: Option<(f64, Shape)> = None;
    for tilt in [task.tilt, 0.0] {
        if tilt == 0.0 && task.tilt == 0.0 && best.is_some() {
            break;
        }
        let upright = |c: f64| (1.0 - tilt * (1.0 - c * c)).sqrt();
        let paths = [0.003, 0.02, 0.08, 0.25, 0.6, 1.0].map(|y| y * extent * upright(0.0));
        let lines = lines_along_cosine(task, &limits, &paths, &upright);
        for scale in SCALES {
            for half in HALVES_NM {
                let least = if half > 0.0 { VANISHING_NM } else { 1.0 };
                let shape = Shape {
                    scale,
                    least,
                    half: half.max(least),
                    tilt,
                    fade,
                };
                let count = lines.iter().zip(paths).map(|(line, path)| {
                    line.count(|c| {
                        let d = path / upright(c);
                        let gamma = scale * (d + shape.least) / (d + shape.half);
                        gamma * (1.0 + gamma) / (c + gamma).powi(2)
                    })
                });
                let count = count.fold(0.0, f64::max);
                let handicap = if half > 0.0 { handicap } else { 1.0 };
                if best.is_none_or(|(least, _)| handicap * count < least) {
                    best = Some((handicap * count, shape));
                }
            }
        }
    }
    let (width, shape) = best.unwrap_or_default();
    let is_handicapped = shape.least < LEAST_NM;
    (
        if is_handicapped {
            width / handicap
        } else {
            width
        },
        shape,
    )
}

/// The first of those with the least count.
fn fewest<T: Copy, const N: usize>(candidates: [(f64, T); N]) -> (f64, T) {
    let least = |a: (f64, T), b: (f64, T)| if b.0 < a.0 { b } else { a };
    candidates.into_iter().fold(candidates[0], least)
}

/// Cosines, dense towards 0.
fn cosines() -> Vec<f64> {
    let last = (ALONG_COSINE - 1) as f64;
    (0..ALONG_COSINE)
        .map(|i| (i as f64 / last).powi(2))
        .collect()
}

/// At several path lengths; all of a cosine together, which is cheaper.
fn lines_along_cosine(
    task: &mut Task<'_>,
    limits: &Limits,
    paths: &[f64],
    upright: &impl Fn(f64) -> f64,
) -> Vec<Line> {
    let t = cosines();
    let mut values = vec![Vec::with_capacity(t.len()); paths.len()];
    for &c in &t {
        for (values, path) in values.iter_mut().zip(paths) {
            values.push((task.source)(c, task.range[0] + path / upright(c)));
        }
    }
    let lines = values
        .iter()
        .map(|values| Line::new(t.clone(), values, limits));
    lines.collect()
}
