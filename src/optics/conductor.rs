//! The reflectance of an absorbing medium without square roots, for one index at many angles.

use super::{Complex, conductor_reflectance};
use crate::num::{Lane, PI, Real, each};

/// [`conductor_reflectance`] for one index per channel, by a polynomial.
///
/// The real part of q, the root of n^2 - sin^2 (Born and Wolf, "Principles of Optics", section 14.2),
/// determines the reflectance: with x = cos^2 and B = 2 Re q, |q|^2 is B^2 / 2 - Re(n^2 - 1) - x. As a
/// function of x, B is a square root with the branch point 1 - n^2. For metals and glass this point is far
/// enough from \[0, 1\] that a polynomial of degree 4 has all the digits of single precision; for indices
/// below or close to 1 it is not.
///
/// With u = B cos, R_s = (|q|^2 + x - u) / (|q|^2 + x + u) and R_p / R_s = (x |q|^2 + (1 - x)^2 - u (1 -
/// x)) / (x |q|^2 + (1 - x)^2 + u (1 - x)), so that the mean of R_s and R_p is one quotient.
#[derive(Clone, Copy, Debug)]
pub struct ConductorPolynomial<C> {
    /// Re(n^2 - 1)
    excess: C,
    /// The coefficients of B as a polynomial of cos^2, the constant first.
    twice_root: [C; TERMS],
}

const TERMS: usize = 5;

/// The number of equal steps of the cosine at which a polynomial is tested.
const TRIALS: u32 = 128;

/// The greatest relative error of a polynomial in single precision: five units in the last place.
const GREATEST_ERROR: f64 = 6e-7;

impl<C: Real> ConductorPolynomial<C> {
    /// The polynomials for one index eta + i k per channel; `None` if the reflectance of a channel is off
    /// by more than five units in the last place at some angle.
    pub fn new<T>(eta: [T; 3], k: [T; 3]) -> Option<Self>
    where
        T: Lane<Rgb = C, Scalar = T> + Into<f64>,
    {
        let [r, g, b] = each!([0, 1, 2], |c| ConductorPolynomial::fitted(
            eta[c].into(),
            k[c].into()
        ));
        let fitted = Self {
            excess: T::rgb(each!([r, g, b], |channel| T::new(channel.excess))),
            twice_root: std::array::from_fn(|power| {
                T::rgb(each!([r, g, b], |channel| T::new(
                    channel.twice_root[power]
                )))
            }),
        };
        let greatest = GREATEST_ERROR * T::EPSILON / f64::from(f32::EPSILON);
        let keeps_digits = (0..=TRIALS).all(|i| {
            let cosine = f64::from(i) / f64::from(TRIALS);
            let approximate = T::channels(fitted.reflectance(T::new(cosine)));
            (0..3).all(|c| {
                let exact = conductor_reflectance(cosine, eta[c].into(), k[c].into());
                (approximate[c].into() - exact).abs() <= greatest * exact
            })
        });
        keeps_digits.then_some(fitted)
    }

    /// The reflectance of unpolarised light for `cos_theta` in \[0, 1\]. Each coefficient is loaded where
    /// it is used, because there are more of them than registers.
    #[inline(always)]
    pub fn reflectance<T, L>(&self, cos_theta: L) -> L::Rgb
    where
        T: Lane<Rgb = C>,
        L: Lane<Scalar = T>,
    {
        let cos_theta = cos_theta.gray();
        let x = cos_theta.squared();
        let [a, b, c, d, e] = &self.twice_root;
        let mut twice_root = L::splat_rgb(*e);
        for coefficient in [d, c, b, a] {
            twice_root = twice_root * x + L::splat_rgb(*coefficient);
        }
        let norm = twice_root.squared() * L::Rgb::new(0.5) - (L::splat_rgb(self.excess) + x);
        let u = twice_root * cos_theta;
        let sum = norm + x;
        let sine_squared = L::Rgb::new(1.0) - x;
        let sum_p = x * norm + sine_squared.squared();
        (sum - u) * sum_p / ((sum + u) * (sum_p + u * sine_squared))
    }
}

impl ConductorPolynomial<f64> {
    /// Interpolates B at the zeros of Chebyshev's polynomial, by Newton's divided differences.
    fn fitted(eta: f64, k: f64) -> Self {
        let excess = Complex::new((eta - 1.0) * (eta + 1.0) - k * k, 2.0 * eta * k);
        let nodes: [f64; TERMS] = std::array::from_fn(|i| {
            let angle = (i as f64 + 0.5) * PI / TERMS as f64;
            0.5 + 0.5 * angle.cos()
        });
        let mut differences = nodes.map(|x| 2.0 * (excess + Complex::real(x)).sqrt_upper().re);
        for order in 1..TERMS {
            for i in (order..TERMS).rev() {
                differences[i] =
                    (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - order]);
            }
        }
        // Newton's form is multiplied out to powers of x by Horner's scheme.
        let mut twice_root = [0.0; TERMS];
        for (difference, node) in differences.iter().zip(nodes).rev() {
            for power in (1..TERMS).rev() {
                twice_root[power] = twice_root[power - 1] - node * twice_root[power];
            }
            twice_root[0] = difference - node * twice_root[0];
        }
        Self {
            excess: excess.re,
            twice_root,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial agrees with the exact formula between the angles at which it was tested too. There is
    /// one for metals and glass, but not for total reflection and nearly equal indices.
    #[test]
    fn a_polynomial_agrees_with_the_roots_or_is_not_made() {
        let made = |eta: f32, k: f32| ConductorPolynomial::new([eta; 3], [k; 3]);
        // Gold, silver, copper, aluminium, titanium, tungsten at 445 to 645 nm; glass.
        let metals = [
            (0.16, 3.5),
            (1.5, 1.9),
            (0.05, 4.2),
            (0.04, 2.4),
            (0.24, 3.6),
            (1.16, 2.4),
            (1.5, 7.8),
            (0.6, 5.3),
            (2.7, 3.8),
            (3.6, 2.9),
        ];
        for (eta, k) in metals {
            let polynomial = made(eta, k).unwrap_or_else(|| panic!("none for {eta} + {k} i"));
            for i in 0..=10_007 {
                let cosine = f64::from(i) / 10_007.0;
                let [found, ..] = f32::channels(polynomial.reflectance(cosine as f32));
                let cosine = f64::from(cosine as f32);
                let exact = conductor_reflectance(cosine, f64::from(eta), f64::from(k));
                let error = f64::from(found) / exact - 1.0;
                assert!(error.abs() < 1e-6, "{eta} + {k} i at {cosine}: {error:e}");
            }
        }
        for (eta, k) in [
            (0.6, 0.0),
            (0.6, 0.01),
            (1.0, 0.0),
            (1.001, 0.0),
            (1.0, 0.01),
        ] {
            assert!(made(eta, k).is_none(), "{eta} + {k} i");
        }
        assert!(ConductorPolynomial::new([0.16f64; 3], [3.5; 3]).is_none());
    }
}
