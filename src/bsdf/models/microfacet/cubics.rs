//! A function of one number as cubic pieces of equal length.

use crate::num::Lane;

/// A function on [0, N] as N cubics, one for each unit interval, with a continuous slope. N is at least 1.
pub(super) struct Cubics<T, const N: usize> {
    /// The coefficients of each piece, in powers of the distance from its start, the constant first.
    pieces: [[T; 4]; N],
}

impl<T: Lane<Scalar = T>, const N: usize> Cubics<T, N> {
    /// The function with the given values and slopes at the N + 1 whole positions (Hermite interpolation).
    pub(super) fn new(knots: &[[f64; 2]]) -> Self {
        let pieces = std::array::from_fn(|k| {
            let ([value, slope], [next_value, next_slope]) = (knots[k], knots[k + 1]);
            let rise = next_value - value;
            let square = 3.0 * rise - 2.0 * slope - next_slope;
            let cube = slope + next_slope - 2.0 * rise;
            [value, slope, square, cube].map(T::new)
        });
        Self { pieces }
    }

    /// The value at a position, which is clamped to [0, N].
    #[inline(always)]
    pub(super) fn at<L: Lane<Scalar = T>>(&self, position: L) -> L {
        let zero = L::new(0.0);
        let position = position.max(zero).min(L::new(N as f64));
        // At a whole position the pieces on both sides have the same value.
        let piece = (position - L::new(0.5)).round().max(zero);
        let piece = piece.min(L::new((N - 1) as f64));
        let x = position - piece;
        let [value, slope, square, cube] = L::load_entry(&self.pieces, piece);
        value + x * (slope + x * (square + x * cube))
    }
}

/// Limits slopes to three times those of the chords beside them, so that the cubics through falling values
/// fall too (Fritsch and Carlson 1980, "Monotone Piecewise Cubic Interpolation", section 3).
pub(super) fn keep_falling(knots: &mut [[f64; 2]]) {
    for k in 1..knots.len() {
        let steepest = 3.0 * (knots[k][0] - knots[k - 1][0]);
        for knot in &mut knots[k - 1..=k] {
            knot[1] = knot[1].max(steepest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reproduces_cubics_and_holds_the_ends() {
        let f = |x: f64| 1.0 + x * (0.5 + x * (-0.25 + x * 0.125));
        let slope = |x: f64| 0.5 + x * (-0.5 + x * 0.375);
        let knots: Vec<_> = (0..=4)
            .map(|k| [f(f64::from(k)), slope(f64::from(k))])
            .collect();
        let (double, single) = (Cubics::<f64, 4>::new(&knots), Cubics::<f32, 4>::new(&knots));
        for i in 0..=400 {
            let x = f64::from(i) / 100.0;
            assert!((double.at(x) - f(x)).abs() < 1e-14, "{x}");
            assert!((f64::from(single.at(x as f32)) - f(x)).abs() < 2e-6, "{x}");
        }
        assert_eq!(double.at(-1e300), f(0.0));
        assert_eq!(double.at(f64::NEG_INFINITY), f(0.0));
        assert_eq!(double.at(1e300), f(4.0));
    }

    /// A step, at which unlimited slopes would make the cubics overshoot.
    #[test]
    fn falling_values_keep_falling() {
        let mut knots = vec![[1.0, 0.0], [1.0, -9.0], [0.01, -0.5], [0.0, 0.0]];
        let overshoots = |knots: &[[f64; 2]]| {
            let curve = Cubics::<f64, 3>::new(knots);
            (0..3000).any(|i| curve.at(f64::from(i + 1) * 1e-3) > curve.at(f64::from(i) * 1e-3))
        };
        assert!(overshoots(&knots));
        keep_falling(&mut knots);
        assert!(!overshoots(&knots));
    }
}
