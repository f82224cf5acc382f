//! The lobe cos^e about an axis, which `phong` and `layered` share.

use crate::bsdf::precision::Precision;
use crate::num::{Lane, PI, Real, Rgb, Vec3, warp};

/// An exponent e, and the cheapest way to compute the power e of a cosine.
#[derive(Clone, Copy, Debug)]
pub struct Power<T> {
    way: Way,
    /// For `Multiply` the cosine below which the power is 0; for `Logarithm` e / 2.
    number: T,
}

#[derive(Clone, Copy, Debug)]
enum Way {
    /// e is whole and at most [`MOST_FACTORS`]: e = 2 pairs, plus 1 if it is odd.
    Multiply { pairs: u32, is_odd: bool },
    /// e is any number >= 0.
    Logarithm,
}

/// The greatest whole exponent that is computed by multiplication. The rounding errors of the cosine and of
/// the products are magnified e times: up to 2e-5 of the power.
const MOST_FACTORS: f64 = 256.0;

/// ln 1e-17. A power whose root is less counts as 0, so that products with two such roots are 0 or far
/// above the least normal number, below which processors are slow.
const LN_LEAST_ROOT: f64 = -39.143_946_580_898_78;

impl<T: Precision> Power<T> {
    /// The power for an exponent >= 0 that does not vary.
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
    /// The same power in every lane.
    #[inline(always)]
    pub fn splat<L: Lane<Scalar = T>>(self) -> Power<L> {
        let Self { way, number } = self;
        Power {
            way,
            number: L::splat(number),
        }
    }

    /// The same power in every channel.
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
    /// The power for any exponent >= 0, by the logarithm.
    #[inline(always)]
    pub fn of_any(exponent: T) -> Self {
        Self {
            way: Way::Logarithm,
            number: exponent * T::new(0.5),
        }
    }

    /// Whether the power is computed by multiplication.
    pub fn is_multiplied(&self) -> bool {
        matches!(self.way, Way::Multiply { .. })
    }

    /// The square root of max(0, c)^e for the cosine c = 1 - `complement`; 0 where the root is below 1e-17.
    ///
    /// The argument is the complement, |a - b|^2 / 2 for unit vectors a and b, because near the axis the
    /// cosine in single precision has too few digits for an exponent of 1e5.
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

/// (e + 2) / (2 pi), the factor with which the albedo of the lobe cos^e is at most 1: Lafortune and Willems
/// 1994, eq. 6. The density has another one, [`warp::power_cosine_normalization`], because it is not
/// weighted by wi.z.
#[inline(always)]
pub fn conserving_normalization<T: Real>(exponent: T) -> T {
    (exponent + T::new(2.0)) * T::new(0.5 / PI)
}

/// Samples a direction about `axis` with the density (e + 1) / (2 pi) cos^e per solid angle.
#[inline(always)]
pub fn sample_about<T: Real>(axis: Vec3<T>, exponent: T, u: [T; 2]) -> Vec3<T> {
    axis.frame_to_world(warp::power_cosine(exponent, u[0], u[1]))
}

/// An estimate of the integral of cos^e wi.z over the hemisphere, for a lobe whose axis has the z component
/// `axis_z`. It is used to choose between lobes, so that only its ratio to other integrals matters.
///
/// For a narrow lobe it is 2 pi / (e + 2) times the mean of max(0, wi.z) over the lobe. With the variance
/// sigma^2 = 1 / (e + 2) of the lobe, that mean goes from z for a steep axis to 0.4 sigma at the horizon
/// (the mean of half a normal distribution), and (z + sqrt(z^2 + 0.64 sigma^2)) / 2 approximates it.
#[inline(always)]
pub fn estimated_integral<T: Real>(exponent: T, axis_z: T) -> T {
    T::new(std::f64::consts::TAU) / (exponent + T::new(2.0)) * smooth_cosine(exponent, axis_z)
}

/// An estimate of the mean of max(0, wi.z) over the lobe, see [`estimated_integral`].
#[inline(always)]
pub fn smooth_cosine<T: Real>(exponent: T, axis_z: T) -> T {
    let variance = T::new(0.64) / (exponent + T::new(2.0));
    (axis_z + (axis_z.squared() + variance).sqrt()) * T::new(0.5)
}

/// The mean of the three channels.
#[inline(always)]
pub fn mean<T: Real>([r, g, b]: Rgb<T>) -> T {
    (r + g + b) * T::new(1.0 / 3.0)
}
