//! Discontinuities: differences of neighbouring colours that do not shrink with their distance.

use super::map::Found;
use super::scene::{Across, Scene};
use crate::shared::peer::Compiled;
use crate::shared::stack::Truth;
use pellicle::num::Rgb;

/// Lines along either axis.
const LINES: usize = 24;
/// Points along each line.
const POINTS: usize = 400;
/// The number of a line's greatest steps that are looked into.
const LOOKED_INTO: usize = 3;
/// After this number of halvings two numbers are neighbours.
const HALVINGS: usize = 60;
/// Steps below this are not looked into.
const LEAST: f64 = 1e-6;

/// The greatest jump along lines of constant angle, and of constant thickness, of a peer compiled for a scene with
/// the thickness across.
pub fn greatest_jump(compiled: &Compiled, scene: &Scene, reference: &Truth) -> Found {
    assert_eq!(scene.across, Across::Thickness);
    let mut found = Found::default();
    for line in 0..LINES {
        let fixed = (line as f64 + 0.5) / LINES as f64;
        for along_thickness in [true, false] {
            let place = |part: f64| {
                if along_thickness {
                    [part, fixed]
                } else {
                    [fixed, part]
                }
            };
            let ends = jump(&|part| at(compiled, scene, place(part)));
            let [a, b] = ends.map(|part| at(compiled, scene, place(part)));
            // An infinite slope, as at a critical angle, is no jump: the truth has it too.
            let is_single = compiled.double(1.0, 1.0).is_none();
            let truths = ends.map(|part| truth(reference, scene, place(part), is_single));
            let size = difference(a, b) - difference(truths[0], truths[1]);
            let [x, y] = place(ends[0]);
            found = found.or(size, scene.x.at(x), scene.cos_theta(scene.y.at(y)));
        }
    }
    found
}

/// The colour at parts of both axes: in double precision, of films in single.
fn at(compiled: &Compiled, scene: &Scene, [x, y]: [f64; 2]) -> Option<Rgb<f64>> {
    let [x, cos_theta] = [scene.x.at(x), scene.exact_cos_theta(scene.y.at(y))];
    compiled.double(cos_theta, x).or_else(|| {
        let color = compiled.single(cos_theta as f32, x as f32)?;
        Some(color.map(f64::from))
    })
}

/// What the reference says there, with the numbers rounded as films get them if `is_single`.
fn truth(reference: &Truth, scene: &Scene, [x, y]: [f64; 2], is_single: bool) -> Option<Rgb<f64>> {
    let exact = [scene.x.at(x), scene.exact_cos_theta(scene.y.at(y))];
    let rounded = exact.map(|number| f64::from(number as f32));
    let [x, cos_theta] = if is_single { rounded } else { exact };
    Some(reference.reflectance(cos_theta, x))
}

/// The ends of the greatest jump of a function on \[0, 1\].
pub fn jump(color: &impl Fn(f64) -> Option<Rgb<f64>>) -> [f64; 2] {
    let part = |i: usize| i as f64 / POINTS as f64;
    let along: Vec<_> = (0..=POINTS).map(|i| color(part(i))).collect();
    let mut steps: Vec<(f64, usize)> = (0..POINTS)
        .map(|i| (difference(along[i], along[i + 1]), i))
        .collect();
    steps.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut greatest = (0.0, [0.0; 2]);
    for (_, i) in steps.into_iter().take(LOOKED_INTO) {
        let found = narrowed(color, part(i), part(i + 1));
        if found.0 > greatest.0 {
            greatest = found;
        }
    }
    greatest.1
}

/// The difference between two places, and the places, after the half with the greater difference was kept again and
/// again.
fn narrowed(
    color: &impl Fn(f64) -> Option<Rgb<f64>>,
    mut from: f64,
    mut to: f64,
) -> (f64, [f64; 2]) {
    let (mut left, mut right) = (color(from), color(to));
    for _ in 0..HALVINGS {
        if difference(left, right) < LEAST {
            return (0.0, [from; 2]);
        }
        let middle = 0.5 * (from + to);
        let found = color(middle);
        if difference(left, found) > difference(found, right) {
            (to, right) = (middle, found);
        } else {
            (from, left) = (middle, found);
        }
    }
    (difference(left, right), [from, to])
}

fn difference(a: Option<Rgb<f64>>, b: Option<Rgb<f64>>) -> f64 {
    let (Some(a), Some(b)) = (a, b) else {
        return 0.0;
    };
    let pairs = a.into_iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
