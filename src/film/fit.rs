//! Finds the axes and the size of a table, fills it, and measures it.

use super::axes::{Axes, LEAST_NM, Shape};
use super::table::{Curve, Table, reserve};
use crate::error::Error;
use crate::math::spline::{FARTHEST, LEAST_VALUES};
use crate::math::{Element, Rgb};

/// Colours at a cosine and a thickness, exact beside the tolerance. Calls at the same cosine one after
/// another are cheaper.
pub(super) type Source<'a> = dyn FnMut(f64, f64) -> Rgb<f64> + 'a;

/// What is to be tabulated.
pub(super) struct Task<'a> {
    pub source: &'a mut Source<'a>,
    /// Least and greatest thickness, nm.
    pub range: [f64; 2],
    /// The square of the ratio of the ambient's index and the layer's.
    pub tilt: f64,
    /// Whether a cosine of its own for every value is slow.
    pub is_costly: bool,
    pub limits: Limits,
}

/// What a table must hold.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The greatest error.
    pub tolerance: f64,
    /// Whether colours outside [0, 1] count.
    pub unclipped: bool,
    /// The greatest number of values.
    pub size: usize,
}

/// A table, and the errors found between its values.
pub(super) struct Fitted<T> {
    pub table: T,
    pub errors: Errors,
}

/// Errors of single channels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Errors {
    pub max: f64,
    pub squares: f64,
    pub count: usize,
}

/// The part of the tolerance that an error found may have: the points between which it is looked for
/// are as many as the table's own, not all there are.
const FOUND: f64 = 0.5;
/// The part that each coordinate is meant to have.
const EACH: f64 = 0.33;
/// The error of a quadratic spline in an interval h is h^3 f''' times max |t^3 - t / 4| / 6 = 1 / 124.7.
const LEADING: f64 = 1.0 / 124.7;
/// A table whose error is below this part of what is allowed is made smaller.
const WASTED: f64 = 0.3;
/// How many cosines are measured besides, and the range that they are in.
const GRAZING: usize = 24;
const GREATEST_GRAZING: f64 = 0.2;
const LEAST_GRAZING: f64 = 1e-5;
/// About how many of the worst points a table is measured again, at how many points along each coordinate,
/// and how far from them, in intervals.
const WORST: usize = 16;
const AROUND: usize = 6;
const CLOSE: f64 = 1.0;
/// How often a table is made larger, or smaller.
const ATTEMPTS: usize = 8;
/// Points of the lines along which the axes are chosen.
const ALONG_COSINE: usize = 120;
const ALONG_THICKNESS: usize = 160;
/// The candidates for gamma of [`Shape`], and for the thickness at which it has half its value.
const SCALES: [f64; 8] = [0.03, 0.07, 0.15, 0.3, 0.5, 1.0, 2.0, 1e3];
const HALVES_NM: [f64; 4] = [0.0, 30.0, 100.0, 300.0];
/// Far below [`LEAST_NM`], but more than 0, which would make gamma vanish.
const VANISHING_NM: f64 = 1e-6 * LEAST_NM;
const FADES: [f64; 8] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0];

impl Errors {
    pub(super) fn add(&mut self, found: Rgb<f64>, expected: Rgb<f64>, unclipped: bool) -> f64 {
        let seen = |x: f64| if unclipped { x } else { x.clamp(0.0, 1.0) };
        let mut worst = 0.0f64;
        for c in 0..3 {
            let error = (seen(found[c]) - seen(expected[c])).abs();
            // Which max() would leave out.
            let error = if error.is_nan() { f64::INFINITY } else { error };
            self.squares += error * error;
            worst = worst.max(error);
        }
        self.count += 3;
        self.max = self.max.max(worst);
        worst
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.max = self.max.max(other.max);
        self.squares += other.squares;
        self.count += other.count;
    }

    pub(super) fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

/// Values along a line, and how densely a spline must be set there: values per unit of the line's own
/// parameter, by the third differences.
struct Line {
    t: Vec<f64>,
    density: Vec<f64>,
}

impl Line {
    fn new(t: Vec<f64>, values: &[Rgb<f64>], limits: &Limits) -> Self {
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

/// Values for a count that was estimated, within what is possible.
fn bounded(estimate: f64, limit: usize) -> usize {
    (estimate.ceil().min(1e6) as usize + 3).clamp(LEAST_VALUES + 2, limit)
}

/// A table over the cosine alone; none if the limits cannot be met.
pub(super) fn curve(
    source: &mut Source<'_>,
    limits: Limits,
) -> Result<Option<Fitted<Curve>>, Error> {
    let line = along_cosine(source, &limits, &mut |_| 0.0);
    let best = SCALES.map(|scale| {
        let slope = |c: f64| scale * (1.0 + scale) / (c + scale).powi(2);
        (line.count(slope), scale)
    });
    let (estimate, scale) = best
        .into_iter()
        .fold(best[0], |a, b| if b.0 < a.0 { b } else { a });
    let shape = Shape {
        scale,
        least: 1.0,
        half: 1.0,
        tilt: 0.0,
        fade: 1.0,
    };
    let axes = Axes::new(shape, [0.0, 0.0]);
    let mut count = bounded(estimate, limits.size);
    for _ in 0..ATTEMPTS {
        let at = |i: f64| axes.point(i / (count - 1) as f64, 0.0).0;
        let values: Vec<_> = (0..count).map(|i| source(at(i as f64), 0.0)).collect();
        let table = Curve::new(&axes, &values)?;
        let mut errors = Errors::default();
        for i in 0..count - 1 {
            for t in [FARTHEST, 1.0 - FARTHEST] {
                let c = at(i as f64 + t);
                let found = f32::channels(table.at(c as f32)).map(f64::from);
                errors.add(found, source(c, 0.0), limits.unclipped);
            }
        }
        if errors.max <= FOUND * limits.tolerance {
            return Ok(Some(Fitted { table, errors }));
        }
        count = enlarged(count, errors.max, &limits);
        if count > limits.size {
            break;
        }
    }
    Ok(None)
}

/// A table over both coordinates; none if the limits cannot be met.
pub(super) fn table(task: &mut Task<'_>) -> Result<Option<Fitted<Table>>, Error> {
    let first = if task.is_costly { 2.0 } else { 1.0 };
    for handicap in [first, 0.2] {
        let (shape, counts) = shape(task, handicap);
        let axes = Axes::new(shape, task.range);
        let fitted = grown(task, &axes, counts)?;
        if fitted.is_some() {
            return Ok(fitted);
        }
    }
    Ok(None)
}

/// A table on these axes, of the size that the limits take; none if they cannot be met.
fn grown(
    task: &mut Task<'_>,
    axes: &Axes<f64>,
    mut counts: [usize; 2],
) -> Result<Option<Fitted<Table>>, Error> {
    let limits = task.limits;
    let allowed = FOUND * limits.tolerance;
    let mut held: Option<Fitted<Table>> = None;
    for _ in 0..ATTEMPTS {
        let [width, height] = counts;
        if width * height > limits.size {
            break;
        }
        let (fitted, [across, along]) = filled(task, axes, counts)?;
        let max = fitted.errors.max;
        if max <= allowed {
            // Once smaller, if much too good, and as it was, if that was too small.
            if held.is_some() || max > WASTED * allowed {
                return Ok(Some(fitted));
            }
            let factor = (max / (0.7 * allowed)).cbrt().max(0.5);
            let smaller =
                |count: usize| ((count as f64 * factor).ceil() as usize).max(LEAST_VALUES + 2);
            counts = counts.map(smaller);
            held = Some(fitted);
            continue;
        }
        if held.is_some() {
            break;
        }
        // Whichever coordinate is to blame; the sum of both is what was found.
        let share = max / (across + along).max(f64::MIN_POSITIVE);
        let larger = [(width, across), (height, along)].map(|(count, error)| {
            if error * share > 0.3 * allowed {
                enlarged(count, error * share, &limits)
            } else {
                count
            }
        });
        counts = if larger == counts {
            counts.map(|count| count + count / 4)
        } else {
            larger
        };
    }
    Ok(held)
}

/// A table of so many values, its errors, and at the worst point those along each coordinate alone.
fn filled(
    task: &mut Task<'_>,
    axes: &Axes<f64>,
    [width, height]: [usize; 2],
) -> Result<(Fitted<Table>, [f64; 2]), Error> {
    let point = |i: f64, j: f64| axes.point(i / (width - 1) as f64, j / (height - 1) as f64);
    let mut values = reserve(width * height)?;
    values.resize(width * height, [0.0; 3]);
    for i in 0..width {
        for j in 0..height {
            let (c, d) = point(i as f64, j as f64);
            values[j * width + i] = (task.source)(c, d);
        }
    }
    let table = Table::new(axes, &values, width)?;
    let (errors, shares) = between(task, &table, [width, height], &point);
    Ok((Fitted { table, errors }, shares))
}

/// A count with which an error, of order 3, would be small enough.
fn enlarged(count: usize, error: f64, limits: &Limits) -> usize {
    let factor = (error / (0.7 * FOUND * limits.tolerance)).cbrt();
    (count as f64 * factor.clamp(1.1, 2.0)).ceil() as usize
}

/// The errors between the values of a table, where they are greatest within an interval; and at the
/// worst point the errors along each coordinate alone.
fn between(
    task: &mut Task<'_>,
    table: &Table,
    [width, height]: [usize; 2],
    point: &impl Fn(f64, f64) -> (f64, f64),
) -> (Errors, [f64; 2]) {
    let limits = task.limits;
    let [least, greatest] = task.range;
    let mut errors = Errors::default();
    let mut worst: Vec<(f64, [f64; 2])> = Vec::new();
    let measure = |task: &mut Task<'_>, i: f64, j: f64, errors: &mut Errors| {
        let (c, d) = point(i, j);
        // Thicker films than the range allows are in the table, but are not asked for.
        if d > greatest && point(i, j.floor() - 1.0).1 > greatest {
            return 0.0;
        }
        let d = d.clamp(least, greatest);
        let found = f32::channels(table.at(c as f32, d as f32)).map(f64::from);
        errors.add(found, (task.source)(c, d), limits.unclipped)
    };
    // Each interval on one of the two sides where the error is greatest, by turns; those at the ends,
    // where its shape is another, on both and in the middle.
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
    // Narrow peaks have their tops elsewhere.
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
    // What is narrower than an interval hides at grazing angles.
    for i in 0..GRAZING {
        let c =
            GREATEST_GRAZING * (LEAST_GRAZING / GREATEST_GRAZING).powf(i as f64 / GRAZING as f64);
        for j in 0..GRAZING / 2 {
            let part = (0.5 + 0.618_034 * (i + j * GRAZING) as f64).fract();
            let d = least + part * part * (greatest - least);
            let found = f32::channels(table.at(c as f32, d as f32)).map(f64::from);
            errors.add(found, (task.source)(c, d), limits.unclipped);
        }
    }
    let [x, y] = worst.first().map_or([0.0; 2], |worst| worst.1);
    let mut aside = Errors::default();
    let across = measure(task, x, y.round(), &mut aside);
    let along = measure(task, x.round(), y, &mut aside);
    (errors, [across, along])
}

/// The axes with which the fewest values are needed, and how many. Those whose gamma depends on the
/// thickness must be so many times better.
fn shape(task: &mut Task<'_>, handicap: f64) -> (Shape, [usize; 2]) {
    let limits = task.limits;
    let [least, greatest] = task.range;
    let extent = greatest - least;
    // Along the thickness, at some cosines: which fade?
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
    let along = FADES.map(|fade| {
        let slope = |d: f64| (1.0 + fade) / (extent * (1.0 + fade * d / extent).powi(2));
        let count = lines
            .iter()
            .map(|line| line.count(slope))
            .fold(0.0, f64::max);
        (count, fade)
    });
    let (height, fade) = along
        .into_iter()
        .fold(along[0], |a, b| if b.0 < a.0 { b } else { a });
    // Along the cosine, at some thicknesses, with upright fringes and without: which gamma?
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
    let width = if shape.least < LEAST_NM {
        width / handicap
    } else {
        width
    };
    let sizes = [bounded(width, limits.size), bounded(height, limits.size)];
    (shape, sizes)
}

/// Cosines, dense towards 0.
fn cosines() -> Vec<f64> {
    let last = (ALONG_COSINE - 1) as f64;
    (0..ALONG_COSINE)
        .map(|i| (i as f64 / last).powi(2))
        .collect()
}

fn along_cosine(
    source: &mut Source<'_>,
    limits: &Limits,
    thickness: &mut dyn FnMut(f64) -> f64,
) -> Line {
    let t = cosines();
    let values: Vec<_> = t.iter().map(|&c| source(c, thickness(c))).collect();
    Line::new(t, &values, limits)
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
