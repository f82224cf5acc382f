//! A film's batch call, which is what the C interface's does.

#![allow(unsafe_code)]

use crate::suite::Point;
use pellicle::Error;
use pellicle::batch::{ConstView, FilmArgs, View, film_reflectance};
use pellicle::film::Film;
use pellicle::num::Level;

/// Fills `colors` with the film's reflectance at as many points.
pub fn evaluate(
    film: &Film,
    level: Level,
    points: &[Point],
    colors: &mut [[f32; 3]],
) -> Result<(), Error> {
    let count = points.len().min(colors.len());
    let input = |component: usize| ConstView {
        data: points.as_flattened()[component..].as_ptr(),
        element_stride: size_of::<Point>() as isize,
        component_stride: 0,
    };
    if count == 0 {
        return Ok(());
    }
    let args = FilmArgs {
        count,
        cos_theta: input(0),
        thickness_nm: input(1),
        reflectance: View {
            data: colors.as_mut_ptr().cast(),
            element_stride: size_of::<[f32; 3]>() as isize,
            component_stride: size_of::<f32>() as isize,
        },
    };
    // SAFETY: the views stand for the first `count` elements of two slices that live on.
    unsafe { film_reflectance(film, &args, level) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{RANGES, points, stacks};

    #[test]
    fn batches_are_the_single_calls() {
        let description = stacks().unwrap()[1].description(RANGES[0], 1e-2);
        let film = Film::new(&description).unwrap();
        let points = points(RANGES[0], 9, 1);
        let single: Vec<[f32; 3]> = points
            .iter()
            .map(|p| film.reflectance(p[0], p[1]))
            .collect();
        for level in Level::all() {
            let mut colors = vec![[0.0; 3]; points.len()];
            evaluate(&film, level, &points, &mut colors).unwrap();
            assert_eq!(colors, single);
        }
    }
}
