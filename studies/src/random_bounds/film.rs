//! Random films, from both sides.

use super::inputs::{any_bits, varying};
use super::{Settings, Tally};
use crate::film_tolerance::draw;
use crate::shared::batch::reflectances;
use crate::shared::directions::rng;
use crate::shared::peer::method_of;
use pellicle::film::Film;
use pellicle::num::Level;
use pellicle::optics::stack::Side;
use rand::{Rng, RngExt};

/// Elements of a film that the reference evaluates, which takes some hundred microseconds a colour.
const SLOW_ELEMENTS: usize = 64;

pub fn run(settings: &Settings, number: usize, tally: &mut Tally) {
    let rng = &mut rng(settings.seed ^ (number as u64) << 32);
    let stack = draw::general(settings.seed, number);
    let mut description = stack.description([1e-2, 2e-3][number % 2]);
    description.unclipped = number % 8 == 7;
    let film = match Film::new(&description) {
        Ok(film) => film,
        Err(error) => return tally.fail(|| format!("{stack}: {error}")),
    };
    let range = stack.varying_nm().unwrap_or([0.0; 2]);
    let levels = Level::all();
    let level = levels[number % levels.len()];
    let (batches, elements) = if method_of(&film) == "reference" {
        (1, SLOW_ELEMENTS)
    } else {
        (settings.batches, settings.elements)
    };
    let is_good = |x: f32| {
        // Colours that are not clipped may be beyond both ends.
        x.is_finite() && (description.unclipped || (0.0..=1.0).contains(&x))
    };
    let look = |rgb: [f32; 3], side: Side, point: [f32; 2], tally: &mut Tally| {
        if !rgb.into_iter().all(is_good) {
            let level = level.name();
            tally
                .fail(|| format!("{rgb:?} of {stack}, {level}, {side:?}, cosine and nm {point:?}"));
        }
    };
    for _ in 0..batches {
        let points: Vec<[f32; 2]> = (0..elements)
            .map(|_| [cosine(rng), varying(rng, range)])
            .collect();
        let found = match reflectances(&film, level, &points) {
            Ok(found) => found,
            Err(error) => return tally.fail(|| format!("{stack}: {error}")),
        };
        tally.count("film_reflectance", elements);
        for (rgb, point) in found.into_iter().zip(&points) {
            look(rgb, Side::Ambient, *point, tally);
        }
        // The base's side may be the reference's.
        let of_both = if stack.both_sides { SLOW_ELEMENTS } else { 0 };
        for point in points.iter().take(of_both) {
            for side in [Side::Ambient, Side::Base] {
                let colors = film.colors(side, point[0], point[1]).unwrap();
                tally.count("film_eval", 1);
                look(colors.reflectance, side, *point, tally);
                look(colors.transmittance, side, *point, tally);
            }
        }
    }
}

/// Most often a cosine of any size; one in eight is any number.
fn cosine(rng: &mut impl Rng) -> f32 {
    match rng.random_range(0..8) {
        0 => any_bits(rng),
        1 | 2 => (-40.0 * rng.random::<f32>()).exp2(),
        _ => rng.random(),
    }
}
