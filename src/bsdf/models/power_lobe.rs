//! The lobe cos^e about an axis, which Phong's model and the layered model share.

use crate::bsdf::precision::Precision;
use crate::num::{Lane, PI, Real, Rgb, Vec3, warp};

/// An exponent e, and the cheapest way to the power e of a cosine.
#[derive(Clone, Copy, Debug)]
pub struct Power<T> {
    way: Way,
    /// The cosine below which the power is 0, or e / 2.
    number: T,
}

#[derive(Clone, Copy, Debug)]
enum Way {
    /// e is whole and at most [`MOST_FACTORS`]: as many pairs of factors, and perhaps one more.
    Multiply { pairs: u32, is_odd: bool },
    /// e is any.
    Logarithm,
}

/// Whole exponents up to this one are multiplied out, of which the rounding errors of the cosine and of the
/// products are magnified e times: 2e-5 of the power at worst.
const MOST_FACTORS: f64 = 256.0;

/// ln 1e-17: powers whose root is less are 0. So products of two roots and of what multiplies them are 0 or
/// far from the least normal number, below which processors are slow.
const LN_LEAST_ROOT: f64 = -39.143_946_580_898_78;

impl<T: Precision> Power<T> {
    /// Of an exponent >= 0 that does not vary.
    pub fn of(exponent: T) -> Self {
        let number: f64 = exponent.into();
        if number.fract() != 0.0 || !(1.0..=MOST_FACTORS).contains(&number) {
            return Self::of_any(exponent);
        }
        let count = number as u32;
        Self {
            way: Way::Multiply {
                pairs: count / 2,
                is_odd: count % 2 == 1,
            },
            number: T::new((2.0 * LN_LEAST_ROOT / number).exp()),
        }
    }
}

impl<T: Lane> Power<T> {
    /// The same everywhere.
    #[inline(always)]
    pub fn splat<L: Lane<Scalar = T>>(self) -> Power<L> {
        let Self { way, number } = self;
        Power {
            way,
            number: L::splat(number),
        }
    }

    /// The same in every channel.
    #[inline(always)]
    pub fn gray(self) -> Power<T::Rgb> {
        let Self { way, number } = self;
        Power {
            way,
            number: number.gray(),
        }
    }
}

impl<T: Real> Power<T> {
    /// Of any exponent >= 0.
    #[inline(always)]
    pub fn of_any(exponent: T) -> Self {
        Self {
            way: Way::Logarithm,
            number: exponent * T::new(0.5),
        }
    }

    /// Whether it is found by multiplication.
    pub fn is_multiplied(&self) -> bool {
        matches!(self.way, Way::Multiply { .. })
    }

    /// The root of max(0, c)^e, or 0 below 1e-17, for the cosine c = 1 - `complement`.
    ///
    /// The complement |a - b|^2 / 2 of unit vectors has the digits that the cosine has lost: near the axis
    /// the cosine in single precision has none left for an exponent of 1e5 to amplify.
    #[inline(always)]
    pub fn root(self, complement: T) -> T {
        let (zero, one) = (T::new(0.0), T::new(1.0));
        match self.way {
            Way::Multiply { pairs, is_odd } => {
                let cosine = one - complement;
                let mut factor = T::select(cosine.gt(self.number), cosine, zero);
                let mut root = if is_odd { factor.sqrt() } else { one };
                let mut left = pairs;
                while left > 0 {
                    if left & 1 == 1 {
                        root = root * factor;
                    }
                    factor = factor.squared();
                    left >>= 1;
                }
                root
            }
            Way::Logarithm => {
                let logarithm = self.number * (-complement).ln_1p();
                let is_seen = complement.lt(one) & logarithm.gt(T::new(LN_LEAST_ROOT));
                T::select(is_seen, logarithm.exp(), zero)
            }
        }
    }
}

/// (e + 2) / (2 pi), with which cos^e reflects no more than it receives: Lafortune and Willems 1994,
/// eq. 6. Not the normalisation of the density, which lacks the cosine of reflection.
#[inline(always)]
pub fn conserving_normalization<T: Real>(exponent: T) -> T {
    (exponent + T::new(2.0)) * T::new(0.5 / PI)
}

/// A direction about `axis` with density (e + 1) / (2 pi) cos^e per solid angle.
#[inline(always)]
pub fn sample_about<T: Real>(axis: Vec3<T>, exponent: T, u: [T; 2]) -> Vec3<T> {
    axis.frame_to_world(warp::power_cosine(exponent, u[0], u[1]))
}

/// Estimate of the integral of cos^e wi.z over the hemisphere, for a lobe whose axis has the given
/// z: only its ratio to other lobes' integrals matters, to choose between them.
///
/// For a narrow lobe it is 2 pi / (e + 2) times the mean of max(0, wi.z) over the lobe. With the
/// lobe's spread sigma^2 = 1 / (e + 2), that mean goes from z to 0.4 sigma at the horizon (the mean
/// of half a normal distribution), which (z + sqrt(z^2 + 0.64 sigma^2)) / 2 follows.
#[inline(always)]
pub fn estimated_integral<T: Real>(exponent: T, axis_z: T) -> T {
    T::new(std::f64::consts::TAU) / (exponent + T::new(2.0)) * smooth_cosine(exponent, axis_z)
}

/// The mean of max(0, wi.z) over the lobe, see [`estimated_integral`].
#[inline(always)]
pub fn smooth_cosine<T: Real>(exponent: T, axis_z: T) -> T {
    let variance = T::new(0.64) / (exponent + T::new(2.0));
    (axis_z + (axis_z.squared() + variance).sqrt()) * T::new(0.5)
}

/// Mean of three channels.
#[inline(always)]
pub fn mean<T: Real>([r, g, b]: Rgb<T>) -> T {
    (r + g + b) * T::new(1.0 / 3.0)
}
