//! The distribution of Beckmann and Spizzichino 1963: normally distributed slopes.

use super::half_vector::HalfVector;
use super::ndf::{Ndf, stretched};
use crate::num::{Lane, Mask, PI, Real, Vec3, erfcx, erfinv};

/// Beckmann's distribution with a roughness along each axis; the variances of the slopes are alpha^2 / 2.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beckmann<T> {
    /// The roughness along X and along Y, > 0.
    pub alpha: [T; 2],
}

/// The steepest slope that is searched for, for alpha = 1. Steeper ones have a probability of 1e-35, and
/// the Gaussian is 0 in single precision.
const STEEPEST: f64 = 9.0;
/// The greatest number of steps. Newton's method converges within 6 where the density is not small, and
/// halves the interval where it is.
const GREATEST_STEPS: usize = 40;
/// The search ends with a step below this. Convergence is quadratic, so that the error is then of the order
/// of its square.
const LAST_STEP: f64 = 1e-4;
const INVERSE_SQRT_PI: f64 = 0.564_189_583_547_756_3;

/// erfc(x) / 2 for x >= 0, given e^(-x^2).
#[inline(always)]
fn half_erfc<T: Real>(x: T, gaussian: T) -> T {
    T::new(0.5) * gaussian * erfcx(x)
}

/// The integral of [`visible_slope`] up to x, and its derivative.
#[inline(always)]
fn seen_below<T: Real>(cos: T, sin: T, x: T) -> (T, T) {
    let gaussian = (-x.squared()).exp();
    let tail = half_erfc(x.abs(), gaussian);
    let below = T::select(x.lt(T::new(0.0)), tail, T::new(1.0) - tail);
    let value = cos * below + sin * gaussian * T::new(0.5 * INVERSE_SQRT_PI);
    (value, (cos - x * sin) * gaussian * T::new(INVERSE_SQRT_PI))
}

/// Samples the slope along the view of visible normals, for alpha = 1 and a view with the given cosine and
/// sine. It inverts the integral of max(0, cos - x sin) e^(-x^2) / sqrt(pi) from -infinity to x, which is
/// cos erfc(-x) / 2 + sin e^(-x^2) / (2 sqrt(pi)), at `u` times its total: Jakob 2014, "An Improved Visible
/// Normal Sampling Routine for the Beckmann Distribution", eq. 3. The inversion is by Newton's method
/// inside a shrinking interval, as there, but from another start and with cos and sin in place of their
/// ratio, so that normal and grazing incidence are no special cases.
#[inline(always)]
fn visible_slope<T: Real>(cos: T, sin: T, u: T) -> T {
    let (zero, one, half) = (T::new(0.0), T::new(1.0), T::new(0.5));
    let mut low = T::new(-STEEPEST);
    // The steepest visible slope is cos / sin.
    let is_seen_whole = (sin * T::new(STEEPEST)).le(cos);
    let mut high = T::select(
        is_seen_whole,
        T::new(STEEPEST),
        cos / T::select(is_seen_whole, one, sin),
    );
    let target = u * seen_below(cos, sin, high).0;
    // For a view along the normal the slopes are normally distributed; for a view along the horizon u =
    // e^(-x^2) with x < 0.
    let from_above = erfinv(u + u - one);
    let from_horizon = -(-u.max(T::new(T::EPSILON)).ln()).sqrt_positive();
    let mut x = from_horizon + cos.squared() * (from_above - from_horizon);
    x = x.max(low).min(high);
    // Each lane stops at its own step, so that it has the bits of a single call.
    let mut is_open = zero.equals(zero);
    for _ in 0..GREATEST_STEPS {
        let (value, slope) = seen_below(cos, sin, x);
        let is_above = value.gt(target);
        (low, high) = (T::select(is_above, low, x), T::select(is_above, x, high));
        let newton = x - (value - target) / T::select(slope.gt(zero), slope, one);
        let is_inside = slope.gt(zero) & newton.ge(low) & newton.le(high);
        let next = T::select(is_inside, newton, (low + high) * half);
        let step = (next - x).abs();
        x = T::select(is_open, next, x);
        is_open = is_open & step.gt(T::new(LAST_STEP));
        if !is_open.any() {
            break;
        }
    }
    x
}

impl<T: Lane> Ndf<T> for Beckmann<T> {
    /// Walter et al. 2007, eq. 25, and its anisotropic form, Heitz 2014, eq. 83. The tangent is computed
    /// from h.x and h.y, which keep their digits for small alpha. Where the exponential is below e^-80 the
    /// density counts as 0, so that 1 / h.z^4 cannot overflow.
    #[inline(always)]
    fn density(&self, h: Vec3<T>) -> T {
        let [x, y] = self.alpha;
        let (zero, one) = (T::new(0.0), T::new(1.0));
        let exponent = ((h.x / x).squared() + (h.y / y).squared()) / h.z.squared();
        let is_seen = h.z.gt(zero) & exponent.lt(T::new(80.0));
        let cosine_squared = T::select(is_seen, h.z.squared(), one);
        let gaussian = (-T::select(is_seen, exponent, one)).exp();
        let density = gaussian * T::new(1.0 / PI) / (x * y * cosine_squared.squared());
        T::select(is_seen, density, zero)
    }

    /// Lambda = (erf(a) - 1) / 2 + e^(-a^2) / (2 a sqrt(pi)) with a = 1 / (alpha tan): Heitz 2014, eq. 72,
    /// after Smith 1967. With the stretched sine s, w.z is a s, and the product is s e^(-a^2) (1 /
    /// sqrt(pi) - a erfcx(a)) / 2. Beyond a = 6 it counts as 0: it is below 1e-16 of w.z.
    #[inline(always)]
    fn cos_times_lambda(&self, w: Vec3<T>) -> T {
        let stretched = stretched(w, self.alpha);
        let sine = (stretched.x.squared() + stretched.y.squared()).sqrt();
        let is_bounded = w.z.lt(sine * T::new(6.0));
        let a = T::select(is_bounded, w.z, T::new(0.0)) / T::select(is_bounded, sine, T::new(1.0));
        let bracket = T::new(INVERSE_SQRT_PI) - a * erfcx(a);
        let area = T::new(0.5) * sine * (-a.squared()).exp() * bracket.max(T::new(0.0));
        T::select(is_bounded, area, T::new(0.0))
    }

    /// Visible normals: the slope along the view is sampled by [`visible_slope`], and the slope across it
    /// is normally distributed. Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the
    /// Distribution of Visible Normals", section 4.
    #[inline(always)]
    fn sample(&self, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let one = T::new(1.0);
        let view = stretched(wo, self.alpha).normalized();
        let sine = (view.x.squared() + view.y.squared()).sqrt();
        let is_above = sine.equals(T::new(0.0));
        let divisor = T::select(is_above, one, sine);
        let cos_phi = T::select(is_above, one, view.x / divisor);
        let sin_phi = view.y / divisor;
        let along = visible_slope(view.z, sine, u[0]);
        let across = erfinv(u[1] + u[1] - one);
        let x = (along * cos_phi - across * sin_phi) * self.alpha[0];
        let y = (along * sin_phi + across * cos_phi) * self.alpha[1];
        Vec3::new(-x, -y, one).normalized()
    }

    /// The density of visible normals, G1 D <wo, h> / wo.z, over 4 <wo, h>.
    #[inline(always)]
    fn reflected_density(&self, pair: &HalfVector<T>, d: T) -> T {
        d / (pair.wo.z + self.cos_times_lambda(pair.wo)) * T::new(0.25)
    }
}
