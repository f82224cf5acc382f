//! Sampling of isotropic distributions for which the integral of D(h) h.z has no inverse in closed form.

use super::cubics::Cubics;
use super::slopes::slope_density;
use crate::num::{Lane, Vec3};

/// The number of pieces of the table, which takes 4 KiB in single precision.
const PIECES: usize = 256;
/// The table goes from -END to END in ln(u / (1 - u)). The greatest number below 1 in single precision is
/// at 16.6.
const END: f64 = 24.0;

/// The squared slope t below which the share u of the projected area is: the solution of
///
/// ```text
/// u = integral from 0 to t of pi P22(t') dt'
/// ```
///
/// tabulated as ln(t (1 - u) / u) over ln(u / (1 - u)). Near the normal t is proportional to u, and near
/// the horizon, if the distribution reaches it, to 1 / (1 - u), so that the tabulated function is constant
/// at both ends. In between it varies slowly for powers and exponentials of any steepness.
///
/// The density of samples is D(h) h.z with a relative error of at most 4e-5 for u between 1e-7 and 1 -
/// 1e-7. The greatest error is that of slopes spread evenly over eight decades; 6e-6 is usual. The unit
/// tests measure it.
pub(super) struct Quantile<T> {
    curve: Cubics<T, PIECES>,
}

impl<T: Lane<Scalar = T>> Quantile<T> {
    /// The table for a normalised density D, whose height at the normal is 1 / (pi alpha^2).
    pub(super) fn new(alpha: f64, density: impl Fn(Vec3<f64>) -> f64) -> Self {
        let shares = Shares::new(alpha, density);
        let step = 2.0 * END / PIECES as f64;
        let mut x = 2.0 * alpha.ln() - END;
        let mut slope = 1.0;
        let knots: Vec<[f64; 2]> = (0..=PIECES)
            .map(|k| {
                let logit = -END + step * k as f64;
                x = shares.solve(logit, x + slope * step);
                slope = shares.slope(logit, x);
                [x - logit, (slope - 1.0) * step]
            })
            .collect();
        Self {
            curve: Cubics::new(&knots),
        }
    }

    /// Samples a normal with the density D(h) h.z from two uniform numbers in [0, 1).
    #[inline(always)]
    pub(super) fn sample<L: Lane<Scalar = T>>(&self, u: [L; 2]) -> Vec3<L> {
        let one = L::new(1.0);
        let odds = u[0] / (one - u[0]);
        let scale = L::new(PIECES as f64 / (2.0 * END));
        let position = (odds.ln() + L::new(END)) * scale;
        let tan_squared = self.curve.at(position).exp() * odds;
        let cos_squared = one / (one + tan_squared);
        let sine = (tan_squared * cos_squared).sqrt();
        Vec3::new(
            sine * u[1].cos_turns(),
            sine * u[1].sin_turns(),
            cos_squared.sqrt(),
        )
    }
}

/// The positive nodes of the 8-point Gauss-Legendre rule on [-1, 1], and their weights: Abramowitz and
/// Stegun, table 25.4.
const GAUSS: [(f64, f64); 4] = [
    (0.183434642495650, 0.362683783378362),
    (0.525532409916329, 0.313706645877887),
    (0.796666477413627, 0.222381034453374),
    (0.960289856497536, 0.101228536290376),
];
/// The length in ln t of the intervals that the rule is applied to.
const INTERVAL: f64 = 0.5;

/// The projected area below and above equidistant values of ln t.
struct Shares<D> {
    density: D,
    from: f64,
    below: Vec<f64>,
    above: Vec<f64>,
}

impl<D: Fn(Vec3<f64>) -> f64> Shares<D> {
    fn new(alpha: f64, density: D) -> Self {
        let from = 2.0 * alpha.ln() - END - 6.0;
        let count = ((END + 6.0 - from) / INTERVAL).ceil() as usize;
        let mut shares = Self {
            density,
            from,
            below: vec![0.0; count + 1],
            above: vec![0.0; count + 1],
        };
        // Below the first edge the area is proportional to t, and above the last one to 1 / t, if there is
        // any.
        shares.below[0] = shares.per_ln(from);
        shares.above[count] = shares.per_ln(shares.edge(count));
        let parts: Vec<f64> = (0..count)
            .map(|k| shares.area(shares.edge(k), shares.edge(k + 1)))
            .collect();
        for k in 0..count {
            shares.below[k + 1] = shares.below[k] + parts[k];
            let last = count - 1 - k;
            shares.above[last] = shares.above[last + 1] + parts[last];
        }
        shares
    }

    fn edge(&self, k: usize) -> f64 {
        self.from + INTERVAL * k as f64
    }

    /// The area per ln t.
    fn per_ln(&self, x: f64) -> f64 {
        let t = x.exp();
        std::f64::consts::PI * slope_density(&self.density, t) * t
    }

    fn area(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
        let pair = |d: f64| self.per_ln(middle - half * d) + self.per_ln(middle + half * d);
        half * GAUSS.iter().map(|(d, w)| w * pair(*d)).sum::<f64>()
    }

    /// The areas below and above x = ln t.
    fn split(&self, x: f64) -> [f64; 2] {
        let k = ((x - self.from) / INTERVAL).max(0.0) as usize;
        let k = k.min(self.below.len() - 1);
        let part = self.area(self.edge(k), x);
        [self.below[k] + part, self.above[k] - part]
    }

    /// The ln t at which ln(below / above) = logit, by Newton's method from a start nearby.
    fn solve(&self, logit: f64, start: f64) -> f64 {
        let mut x = start;
        for _ in 0..50 {
            let [below, above] = self.split(x);
            let change = ((below / above).ln() - logit) * below * above / self.per_ln(x);
            x -= change.clamp(-2.0, 2.0);
            if change.abs() < 1e-12 {
                break;
            }
        }
        x
    }

    /// d ln t / d logit.
    fn slope(&self, logit: f64, x: f64) -> f64 {
        let share = 1.0 / (1.0 + (-logit).exp());
        share / (1.0 + logit.exp()) / self.per_ln(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bsdf::models::microfacet::slopes::sin_squared;
    use std::f64::consts::PI;

    /// The greatest relative error of the density of samples: the error of the rate at which the share
    /// below a sample grows, by central differences in ln(u / (1 - u)). `logit` is the exact ln(u / (1 -
    /// u)) as a function of tan^2.
    fn worst(
        alpha: f64,
        density: impl Fn(Vec3<f64>) -> f64,
        logit: impl Fn(f64) -> f64,
    ) -> [f64; 2] {
        let quantile = Quantile::<f64>::new(alpha, density);
        let reached = |x: f64| {
            let h = quantile.sample([1.0 / (1.0 + (-x).exp()), 0.0]);
            logit((h.x / h.z).powi(2))
        };
        let mut errors = [0.0; 2];
        for i in 0..3200 {
            let x = -16.0 + f64::from(i) * 0.01;
            let rate = (reached(x + 1e-3) - reached(x - 1e-3)) / 2e-3;
            for (worst, error) in errors.iter_mut().zip([reached(x) - x, rate - 1.0]) {
                *worst = f64::max(*worst, error.abs());
            }
        }
        println!(
            "alpha = {alpha}: share {:.1e}, density {:.1e}",
            errors[0], errors[1]
        );
        errors
    }

    /// A power of the cosine and Beckmann's distribution, whose shares above are cos^(2 / alpha^2)
    /// and e^(-(tan / alpha)^2).
    #[test]
    fn inverts_narrow_lobes() {
        for alpha in [1e-4, 1e-2, 0.3, 1.0] {
            let squared = alpha * alpha;
            let beckmann = |h: Vec3<f64>| {
                let (cos_squared, height) = (h.z * h.z, 1.0 / (PI * squared));
                let tan_squared = sin_squared(h) / cos_squared;
                height * (-tan_squared / squared).exp() / (cos_squared * cos_squared)
            };
            // ln((1 - e^-x) / e^-x) = ln(e^x - 1)
            let share = worst(alpha, beckmann, |t| (t / squared).exp_m1().ln());
            assert!(share[0] < 1e-6 && share[1] < 1e-5, "{share:?}");
            let power = |h: Vec3<f64>| {
                let ln_cosine = 0.5 * (-sin_squared(h)).ln_1p();
                ((2.0 / squared - 2.0) * ln_cosine).exp() / (PI * squared)
            };
            let share = worst(alpha, power, |t| (t.ln_1p() / squared).exp_m1().ln());
            assert!(share[0] < 1e-6 && share[1] < 1e-5, "{share:?}");
        }
    }

    /// ABC with C = 1: the area up to w = 1 + B (1 - cos) is 2 pi A ((B + 1) ln w - (w - 1)) / B^2. For
    /// B = 4.4e9 the slopes are spread evenly over the logarithm from 1e-5 to 1, and alpha is 1e-4.
    #[test]
    fn inverts_slopes_of_every_scale() {
        for b in [1.0, 1e3, 4.4e9] {
            let below = |ln_w: f64| 2.0 * ((b + 1.0) * ln_w - ln_w.exp_m1()) / (b * b);
            let squared = below(b.ln_1p());
            let height = 1.0 / (PI * squared);
            let complement = |t: f64| {
                let c = (1.0 + t).sqrt();
                t / (c * (1.0 + c))
            };
            // Above w, with v = ln((B + 1) / w): (B + 1) (v + e^-v - 1), without cancellation.
            let above = |v: f64| {
                let sum = if v > 1e-3 {
                    v + (-v).exp_m1()
                } else {
                    v * v * (0.5 - v * (1.0 / 6.0 - v / 24.0))
                };
                2.0 * (b + 1.0) * sum / (b * b)
            };
            let logit = |t: f64| {
                let ln_w = (b * complement(t)).ln_1p();
                // 1 - (1 - cos) is the cosine.
                let v = (b / (1.0 + t).sqrt() / ln_w.exp()).ln_1p();
                (below(ln_w) / above(v)).ln()
            };
            let density = |h: Vec3<f64>| height / (1.0 + b * sin_squared(h) / (1.0 + h.z));
            let share = worst(squared.sqrt(), density, logit);
            assert!(share[0] < 3e-6 && share[1] < 4e-5, "{share:?}");
        }
    }
}
