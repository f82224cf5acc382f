//! Chooses the axes of a table by how quickly the colours change along them.

use super::axes::{AxisParams, LEAST_NM};
use super::task::{ColorSource, FitLimits, FitTask};
use crate::num::Rgb;

/// The part of the tolerance that the error along one coordinate may have.
const EACH: f64 = 0.33;
/// The error of a quadratic spline in an interval h is h^3 f''' times max |t^3 - t / 4| / 6 = 1 / 124.7.
const LEADING: f64 = 1.0 / 124.7;
/// The numbers of points of the profiles by which the axes are chosen.
const ALONG_COSINE: usize = 120;
const ALONG_THICKNESS: usize = 160;
/// The candidates for `scale` and `half` of [`AxisParams`].
const SCALES: [f64; 8] = [0.03, 0.07, 0.15, 0.3, 0.5, 1.0, 2.0, 1e3];
const HALVES_NM: [f64; 4] = [0.0, 30.0, 100.0, 300.0];
/// Far below [`LEAST_NM`], but more than 0, at which gamma would vanish.
const VANISHING_NM: f64 = 1e-7 * LEAST_NM;
/// The candidates for `fade` of [`AxisParams`].
const FADES: [f64; 8] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0];

/// Colours along a line of constant cosine or thickness, and how densely a spline's values must lie
/// there: values per unit of the parameter t, by the third differences.
struct ColorProfile {
    t: Vec<f64>,
    density: Vec<f64>,
}

impl ColorProfile {
    fn new(t: Vec<f64>, values: &[Rgb<f64>], limits: &FitLimits) -> Self {
        // The table is not measured where colours are clipped, but its spline must be smooth a little
        // way beyond [0, 1].
        let displayed = |x: f64| {
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
                    let mut divided: [f64; 4] =
                        std::array::from_fn(|k| displayed(values[first + k][c]));
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

    /// The number of values that a coordinate needs whose derivative with respect to t is `slope`.
    fn count(&self, slope: impl Fn(f64) -> f64) -> f64 {
        let each = self.t.iter().zip(&self.density);
        each.map(|(t, density)| density / slope(*t).max(1e-12))
            .fold(0.0, f64::max)
    }
}

/// The axes that need the fewest values over the cosine alone, and their number.
pub(super) fn over_cosine(source: &mut ColorSource<'_>, limits: &FitLimits) -> (AxisParams, f64) {
    let t = cosines();
    let values: Vec<_> = t.iter().map(|&c| source(c, 0.0)).collect();
    let profile = ColorProfile::new(t, &values, limits);
    let (count, scale) = fewest(SCALES.map(|scale| {
        let slope = |c: f64| scale * (1.0 + scale) / (c + scale).powi(2);
        (profile.count(slope), scale)
    }));
    let params = AxisParams {
        scale,
        least: 1.0,
        half: 1.0,
        tilt: 0.0,
        fade: 1.0,
    };
    (params, count)
}

/// The axes that need the fewest values over both coordinates, and their numbers along each. Axes whose
/// gamma depends on the thickness are chosen only if `handicap` times their number is less.
pub(super) fn over_both(task: &mut FitTask<'_>, handicap: f64) -> (AxisParams, [f64; 2]) {
    let (height, fade) = along_thickness(task);
    let (width, params) = along_cosine(task, handicap, fade);
    (params, [width, height])
}

/// The number of values needed along the thickness, at some cosines, and the fade that needs it.
fn along_thickness(task: &mut FitTask<'_>) -> (f64, f64) {
    let limits = task.limits;
    let [least, greatest] = task.range;
    let extent = greatest - least;
    let dense = 10.0;
    let profiles: Vec<ColorProfile> = [1.0, 0.4, 0.1, 0.02]
        .into_iter()
        .map(|c| {
            let count = ALONG_THICKNESS;
            let t = (0..count).map(|i| {
                let y = i as f64 / (count - 1) as f64;
                extent * y / (1.0 + dense * (1.0 - y))
            });
            let t: Vec<f64> = t.collect();
            let values: Vec<_> = t.iter().map(|d| (task.source)(c, least + d)).collect();
            ColorProfile::new(t, &values, &limits)
        })
        .collect();
    fewest(FADES.map(|fade| {
        let slope = |d: f64| (1.0 + fade) / (extent * (1.0 + fade * d / extent).powi(2));
        let count = profiles
            .iter()
            .map(|profile| profile.count(slope))
            .fold(0.0, f64::max);
        (count, fade)
    }))
}

/// The number of values needed along the cosine, at some thicknesses, and the axes that need it. Axes
/// with upright fringes and without are tried.
fn along_cosine(task: &mut FitTask<'_>, handicap: f64, fade: f64) -> (f64, AxisParams) {
    let limits = task.limits;
    let extent = task.range[1] - task.range[0];
    let mut best: Option<(f64, AxisParams)> = None;
    for tilt in [task.tilt, 0.0] {
        if tilt == 0.0 && task.tilt == 0.0 && best.is_some() {
            break;
        }
        let upright = |c: f64| (1.0 - tilt * (1.0 - c * c)).sqrt();
        let paths = [0.003, 0.02, 0.08, 0.25, 0.6, 1.0].map(|y| y * extent * upright(0.0));
        let profiles = profiles_along_cosine(task, &limits, &paths, &upright);
        for scale in SCALES {
            for half in HALVES_NM {
                let least = if half > 0.0 { VANISHING_NM } else { 1.0 };
                let params = AxisParams {
                    scale,
                    least,
                    half: half.max(least),
                    tilt,
                    fade,
                };
                let count = profiles.iter().zip(paths).map(|(profile, path)| {
                    profile.count(|c| {
                        let d = path / upright(c);
                        let gamma = scale * (d + params.least) / (d + params.half);
                        gamma * (1.0 + gamma) / (c + gamma).powi(2)
                    })
                });
                let count = count.fold(0.0, f64::max);
                let handicap = if half > 0.0 { handicap } else { 1.0 };
                if best.is_none_or(|(least, _)| handicap * count < least) {
                    best = Some((handicap * count, params));
                }
            }
        }
    }
    let (width, params) = best.unwrap_or_default();
    let is_handicapped = params.least < LEAST_NM;
    (
        if is_handicapped {
            width / handicap
        } else {
            width
        },
        params,
    )
}

/// The first candidate with the least count.
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

/// Profiles at several path lengths. Those at one cosine are sampled together, which is cheaper.
fn profiles_along_cosine(
    task: &mut FitTask<'_>,
    limits: &FitLimits,
    paths: &[f64],
    upright: &impl Fn(f64) -> f64,
) -> Vec<ColorProfile> {
    let t = cosines();
    let mut values = vec![Vec::with_capacity(t.len()); paths.len()];
    for &c in &t {
        for (values, path) in values.iter_mut().zip(paths) {
            values.push((task.source)(c, task.range[0] + path / upright(c)));
        }
    }
    let profiles = values
        .iter()
        .map(|values| ColorProfile::new(t.clone(), values, limits));
    profiles.collect()
}
