//! The angle of a vector, over any [`Real`].

use super::{PI, Real};

/// tan(pi / 8), the greatest argument of the polynomial.
const EIGHTH: f64 = std::f64::consts::SQRT_2 - 1.0;

/// atan(t) / t by powers of t^2 for |t| <= tan(pi / 8): the interpolant in the 8 Chebyshev nodes of
/// [0, tan^2(pi / 8)], our own; greatest error 7.6e-13.
const POLYNOMIAL: [f64; 8] = [
    0.999999999999244762,
    -0.333333332769224921,
    0.199999930535558136,
    -0.142853865537521393,
    0.111034569089474629,
    -0.0899255290615091148,
    0.0697419768659526513,
    -0.037655106012914021,
];

/// The angle from the first axis to the vector (x, y), in turns, within [-1/2, 1/2]; 0 for the null vector.
/// The relative error is 1e-12 or the rounding error of the type, whichever is greater, for small angles
/// too.
#[inline(always)]
pub(crate) fn angle_turns<T: Real>(y: T, x: T) -> T {
    let (zero, one) = (T::new(0.0), T::new(1.0));
    let (ay, ax) = (y.abs(), x.abs());
    // The angle of (large, small) is at most 1/8; beyond 1/16 it is measured from the diagonal.
    let (small, large) = (ay.min(ax), ay.max(ax));
    let is_null = large.le(zero);
    let is_wide = small.gt(large * T::new(EIGHTH));
    let numerator = T::select(is_wide, small - large, small);
    let denominator = T::select(is_wide, small + large, T::select(is_null, one, large));
    let t = numerator / denominator;
    let z = t * t;
    let mut p = T::new(POLYNOMIAL[7]);
    for coefficient in POLYNOMIAL[..7].iter().rev() {
        p = p * z + T::new(*coefficient);
    }
    let angle = t * p * T::new(0.5 / PI);
    let angle = T::select(is_wide, T::new(0.125) + angle, angle);
    let angle = T::select(ay.gt(ax), T::new(0.25) - angle, angle);
    let angle = T::select(x.lt(zero), T::new(0.5) - angle, angle);
    T::select(y.lt(zero), -angle, angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_the_angle_of_the_standard_library() {
        for i in 0..100_000 {
            let angle = (i as f64 / 50_000.0 - 1.0) * PI;
            let (y, x) = angle.sin_cos();
            let expected = y.atan2(x) / (2.0 * PI);
            assert!((angle_turns(y, x) - expected).abs() < 2e-13, "{angle}");
            let (y, x) = (y as f32, x as f32);
            let expected = f64::from(y).atan2(f64::from(x)) / (2.0 * PI);
            assert!((f64::from(angle_turns(y, x)) - expected).abs() < 8e-8);
        }
        assert_eq!(angle_turns(0.0, 0.0), 0.0);
        assert_eq!(angle_turns(0.0, -1.0), 0.5);
        for tiny in [1e-30f32, 1e-10, 1e-3] {
            let expected = tiny.atan2(2.0) / (2.0 * PI as f32);
            assert!((angle_turns(tiny, 2.0) / expected - 1.0).abs() < 1e-6);
        }
    }
}
