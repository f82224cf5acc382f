//! Random films, from both sides.

use super::common::rng;
use super::inputs::{any_bits, varying};
use super::planes::Planes;
use super::{BATCH, Settings, Tally, promise};
use pellicle::batch::{FilmArgs, film_reflectance};
use pellicle::film::Film;
use pellicle::num::{Level, Rgb};
use pellicle::optics::stack::Side;
use rand::{Rng, RngExt};

/// Batches of a film that is evaluated by the reference, some hundred microseconds a colour.
const SLOW_ELEMENTS: usize = 64;

pub fn run(settings: &Settings, number: usize, tally: &mut Tally) {
    let rng = &mut rng(settings.seed ^ (number as u64) << 32);
    let stack = promise::draw::stack(settings.seed, number);
    let mut description = stack.description([1e-2, 2e-3][number % 2]);
    description.unclipped = number % 8 == 7;
    let greatest = if description.unclipped {
        f32::INFINITY
    } else {
        1.0
    };
    let film = match Film::new(&description) {
        Ok(film) => film,
        Err(error) => return tally.fail(|| format!("{stack}: {error}")),
    };
    let range = stack.varying_nm().unwrap_or([0.0; 2]);
    let levels = Level::all();
    let level = levels[number % levels.len()];
    let is_slow = film.plan().method == "reference";
    let (batches, elements) = if is_slow {
        (1, SLOW_ELEMENTS)
    } else {
        (settings.batches, BATCH)
    };
    for _ in 0..batches {
        let (mut cosines, mut thicknesses) =
            (Planes::<f32, 1>::new(0.0), Planes::<f32, 1>::new(0.0));
        let mut found = Planes::<f32, 3>::new(f32::NAN);
        for i in 0..elements {
            cosines.set(i, [cosine(rng)]);
            thicknesses.set(i, [varying(rng, range[0], range[1])]);
        }
        let args = FilmArgs {
            count: elements,
            cos_theta: cosines.const_view(),
            thickness_nm: thicknesses.const_view(),
            reflectance: found.view(),
        };
        // SAFETY: all views are of arrays of BATCH elements.
        if let Err(error) = unsafe { film_reflectance(&film, &args, level) } {
            return tally.fail(|| format!("{stack}: {error}"));
        }
        tally.count("film_reflectance", elements);
        for i in 0..elements {
            let given = || {
                format!(
                    "{stack}, {}, cos {:?}, {:?} nm",
                    level.name(),
                    cosines.get(i),
                    thicknesses.get(i)
                )
            };
            look(found.get(i), description.unclipped, greatest, &given, tally);
        }
        if stack.both_sides {
            // The base's side may be the reference's.
            for i in 0..SLOW_ELEMENTS {
                for side in [Side::Ambient, Side::Base] {
                    let ([cos_theta], [thickness_nm]) = (cosines.get(i), thicknesses.get(i));
                    let given =
                        || format!("{stack}, {side:?}, cos {cos_theta:?}, {thickness_nm:?} nm");
                    let colors = film.colors(side, cos_theta, thickness_nm).unwrap();
                    tally.count("film_eval", 1);
                    look(
                        colors.reflectance,
                        description.unclipped,
                        greatest,
                        &given,
                        tally,
                    );
                    look(
                        colors.transmittance,
                        description.unclipped,
                        greatest,
                        &given,
                        tally,
                    );
                }
            }
        }
    }
}

/// Any number, most often a cosine of any size.
fn cosine(rng: &mut impl Rng) -> f32 {
    match rng.random_range(0..8) {
        0 => any_bits(rng),
        1 | 2 => (-40.0 * rng.random::<f32>()).exp2(),
        _ => rng.random(),
    }
}

/// Finite; within [0, 1] unless colours are not clipped.
fn look(
    rgb: Rgb<f32>,
    is_unclipped: bool,
    greatest: f32,
    given: &dyn Fn() -> String,
    tally: &mut Tally,
) {
    let is_good = |x: f32| x.is_finite() && (is_unclipped || x >= 0.0) && x <= greatest;
    if !rgb.into_iter().all(is_good) {
        tally.fail(|| format!("{rgb:?} of {}", given()));
    }
}
