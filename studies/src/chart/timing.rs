//! ns per colour, on one core.

use super::suite::Point;
use crate::shared::batch::fill_reflectances;
use crate::shared::peer::Compiled;
use pellicle::num::Level;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Random points of one repetition, which should end before the operating system interrupts it.
const POINTS: usize = 1 << 11;
/// Times are the median of this number of repetitions.
pub const REPETITIONS: usize = 15;
/// Every repetition has points of its own, because a processor learns the branches of points that return.
pub const ALL_POINTS: usize = POINTS * REPETITIONS;
/// Caches are filled for at least this time before a repetition.
const WARM_UP: Duration = Duration::from_micros(500);
/// A method slower than this, in ns, is timed at few points per repetition.
const SLOW_NS: f64 = 2000.0;
const FEW_POINTS: usize = 24;

/// One repetition, after unmeasured ones at other points that fill the caches.
pub fn single_calls(compiled: &Compiled, points: &[Point], repetition: usize) -> f64 {
    // The loops are within the cases: choosing one at every point would count.
    match compiled {
        Compiled::Method(method) => measured(points, repetition, |points| {
            for [cos_theta, thickness_nm] in points {
                black_box(method.single.reflectance(*cos_theta, *thickness_nm));
            }
        }),
        Compiled::Film(film) => measured(points, repetition, |points| {
            for [cos_theta, thickness_nm] in points {
                black_box(film.reflectance(*cos_theta, *thickness_nm));
            }
        }),
        _ => measured(points, repetition, |points| {
            for [cos_theta, thickness_nm] in points {
                black_box(compiled.single(*cos_theta, *thickness_nm));
            }
        }),
    }
}

/// The same for a batch call at each level of instructions; none for a peer without batches.
pub fn batches(
    compiled: &Compiled,
    levels: &[Level],
    points: &[Point],
    repetition: usize,
) -> Vec<f64> {
    let Compiled::Film(film) = compiled else {
        return Vec::new();
    };
    let mut colors = vec![[0.0; 3]; POINTS];
    let time = |level: &Level| {
        measured(points, repetition, |points| {
            fill_reflectances(film, *level, points, &mut colors[..points.len()]).unwrap();
            black_box(&colors);
        })
    };
    levels.iter().map(time).collect()
}

/// ns per call at a point, of one repetition.
pub fn calls<T>(points: &[Point], repetition: usize, call: impl Fn(Point) -> T) -> f64 {
    measured(points, repetition, |points| {
        for point in points {
            black_box(call(*point));
        }
    })
}

/// ns per point of work on a repetition's points, or on a few of them if it is slow.
fn measured(points: &[Point], repetition: usize, mut work: impl FnMut(&[Point])) -> f64 {
    let mut time = |points: &[Point]| {
        let start = Instant::now();
        work(points);
        start.elapsed().as_secs_f64() * 1e9 / points.len() as f64
    };
    let chunk = |i: usize| &points[i * POINTS..(i + 1) * POINTS];
    let few = &chunk(repetition)[..FEW_POINTS];
    let first = &few[..8];
    if time(first).min(time(first)) > SLOW_NS {
        return time(few);
    }
    let start = Instant::now();
    for other in 1..REPETITIONS {
        time(chunk((repetition + other) % REPETITIONS));
        if start.elapsed() >= WARM_UP {
            break;
        }
    }
    time(chunk(repetition))
}

/// The middle one, or the mean of the middle two.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    if values.len() % 2 == 1 {
        values[half]
    } else {
        0.5 * (values[half - 1] + values[half])
    }
}
