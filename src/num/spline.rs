//! Quadratic splines through equidistant values.

use super::{Real, Rgb};

/// The least number of values that a spline goes through.
pub(crate) const LEAST_VALUES: usize = 5;

/// Computes the n + 2 control points of the quadratic B-spline through n >= 5 equidistant values and stores
/// them in `out`; the first control point belongs one step before the first value. The polynomials of the
/// spline meet halfway between the values. The first two are the same polynomial, and so are the last two
/// (de Boor 1978, "A Practical Guide to Splines", chapter IV: "not a knot"), which keeps the order 3 up to
/// the ends.
///
/// The spline at value k is (c(k - 1) + 6 c(k) + c(k + 1)) / 8.
pub(crate) fn controls(values: &[Rgb<f64>], out: &mut Vec<Rgb<f64>>) {
    let n = values.len();
    let combine = |a: [f64; 3], f: [Rgb<f64>; 3]| -> Rgb<f64> {
        std::array::from_fn(|c| a[0] * f[0][c] + a[1] * f[1][c] + a[2] * f[2][c])
    };
    let none = [0.0; 3];
    out.clear();
    out.resize(n + 2, none);
    let c = &mut out[1..=n]; // c[k] belongs to value k
    // The end condition is c1 - c0 = f1 - f0: the equation at 1 becomes 7 c1 + c2 = 9 f1 - f0, and
    // likewise at the other end. Between them c(k - 1) + 6 c(k) + c(k + 1) = 8 f(k), by elimination
    // and substitution.
    let mut pivots = vec![0.0; n];
    for k in 1..n - 1 {
        let (mut diagonal, mut right) = (6.0, combine([8.0, 0.0, 0.0], [values[k], none, none]));
        for (is_end, outer) in [(k == 1, 0), (k == n - 2, n - 1)] {
            if is_end {
                diagonal += 1.0;
                right = combine([1.0, 1.0, -1.0], [right, values[k], values[outer]]);
            }
        }
        if k > 1 {
            diagonal -= pivots[k - 1];
            right = combine([1.0, -1.0, 0.0], [right, c[k - 1], none]);
        }
        pivots[k] = 1.0 / diagonal;
        c[k] = combine([pivots[k], 0.0, 0.0], [right, none, none]);
    }
    for k in (1..n - 2).rev() {
        c[k] = combine([1.0, -pivots[k], 0.0], [c[k], c[k + 1], none]);
    }
    c[0] = combine([1.0, -1.0, 1.0], [c[1], values[1], values[0]]);
    c[n - 1] = combine([1.0, -1.0, 1.0], [c[n - 2], values[n - 2], values[n - 1]]);
    out[0] = combine([8.0, -6.0, -1.0], [values[0], out[1], out[2]]);
    out[n + 1] = combine([8.0, -6.0, -1.0], [values[n - 1], out[n], out[n - 1]]);
}

/// The weights of the three control points around a value, at a distance in [-1/2, 1/2] steps from that
/// value.
#[inline(always)]
pub(crate) fn weights<T: Real>(distance: T) -> [T; 3] {
    let root = T::new(std::f64::consts::FRAC_1_SQRT_2);
    let half = T::new(0.5 * std::f64::consts::FRAC_1_SQRT_2);
    let (before, after) = (distance * root - half, distance * root + half);
    [
        before * before,
        T::new(0.75) - distance * distance,
        after * after,
    ]
}

/// The distance from the nearest value, in steps, at which the spline's error is greatest. The leading term
/// of the error is proportional to t^3 - t / 4, which is 0 at the values and halfway between them and
/// greatest at t = 1 / sqrt(12).
pub(crate) const FARTHEST: f64 = 0.288_675; // 1 / sqrt(12)

#[cfg(test)]
mod tests {
    use super::*;

    /// A spline of order 3 reproduces parabolas everywhere, and goes through any values.
    #[test]
    fn reproduces_parabolas_and_values() {
        let f = |x: f64| [1.0 + x, x * x - 2.0, 0.3 - x * x * 0.7 - x];
        let at = |c: &[Rgb<f64>], x: f64| -> Rgb<f64> {
            let k = x.round();
            let w = weights(x - k);
            std::array::from_fn(|ch| (0..3).map(|j| w[j] * c[k as usize + j][ch]).sum())
        };
        for n in 5..12 {
            let values: Vec<_> = (0..n).map(|k| f(f64::from(k))).collect();
            let mut c = Vec::new();
            controls(&values, &mut c);
            for i in 0..=10 * (n - 1) {
                let x = f64::from(i) / 10.0;
                for (found, expected) in at(&c, x).into_iter().zip(f(x)) {
                    assert!((found - expected).abs() < 1e-11, "{n} {x}");
                }
            }
            let values: Vec<_> = (0..n).map(|k| [f64::from(k * k % 7); 3]).collect();
            controls(&values, &mut c);
            for (k, value) in values.iter().enumerate() {
                assert!((at(&c, k as f64)[0] - value[0]).abs() < 1e-12, "{n} {k}");
            }
        }
    }
}
