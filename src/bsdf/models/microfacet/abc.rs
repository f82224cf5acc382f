//! The ABC distribution of normals (Löw, Kronander, Ynnerman and Unger 2012, "BRDF Models for Accurate
//! and Efficient Rendering of Glossy Surfaces", section on the microfacet model; after Church and
//! Takacs's spectra of polished surfaces): a tip and a tail of any power.

use super::slopes::{height, matched_width, sin_squared, slope_density};
use crate::num::{Lane, Vec3, each};

/// D(h) = A / (1 + B (1 - h.z))^C.
///
/// The papers fit A, and the lecture prints the function without it; here A makes the projected area 1. B
/// follows from alpha, because the height at the normal is A = 1 / (pi alpha^2), as for GGX, Beckmann's
/// distribution and Blinn's:
///
/// ```text
/// alpha^2 = 2 integral from 0 to 1 of (1 - u) / (1 + B u)^C du
/// ```
///
/// This equation is solved for B at creation. For C > 1 and small alpha, B is near 2 / ((C - 1) alpha^2).
/// alpha = 1 gives B = 0, a constant density.
///
/// alpha is in [1e-4, 1], the exponent C in [0.5, 10]. C = 2 is nearly GGX, and C = 10 nearly Blinn's
/// distribution; at C <= 1 most of the area is in the tail for every alpha. Löw et al.'s fits to 100
/// measured materials have C from 0.02 to 2.7, half of them between 0.9 and 1.5 about a median of 1.2.
///
/// The area up to an angle is the difference of two powers of 1 + B (1 - h.z), which has no inverse in
/// closed form, so that normals are sampled by a table.
#[derive(Clone, Copy)]
pub(crate) struct Abc<T> {
    a: T,
    b: T,
    c: T,
}

/// An upper bound of ln(1 + B), which is 37.4 for alpha = 1e-4 and C = 1/2.
const WIDEST: f64 = 40.0;

/// B for alpha and C.
fn width(alpha: f64, exponent: f64) -> f64 {
    if alpha >= 1.0 {
        return 0.0;
    }
    let ln_1p_b = matched_width(alpha, [0.0, WIDEST], |ln_1p_b, tan_squared| {
        let lobe = Abc::<f64>::of_numbers(1.0, ln_1p_b.exp_m1(), exponent);
        slope_density(|h| lobe.density(h), tan_squared)
    });
    ln_1p_b.exp_m1()
}

impl<T: Lane<Scalar = T>> Abc<T> {
    /// The distribution for alpha and the exponent C.
    pub(crate) fn new(alpha: f64, exponent: f64) -> Self {
        Self::of_numbers(height(alpha), width(alpha, exponent), exponent)
    }

    fn of_numbers(a: f64, b: f64, c: f64) -> Self {
        let [a, b, c] = [a, b, c].map(T::new);
        Self { a, b, c }
    }

    /// D(h), per steradian. 1 - h.z is computed as sin^2 / (1 + h.z), which keeps its digits.
    #[inline(always)]
    pub(super) fn density<L: Lane<Scalar = T>>(&self, h: Vec3<L>) -> L {
        let [a, b, c] = each!([self.a, self.b, self.c], |number| L::splat(number));
        let complement = sin_squared(h) / (L::new(1.0) + h.z);
        let density = a * (-(c * (b * complement).ln_1p())).exp();
        L::select(h.z.gt(L::new(0.0)), density, L::new(0.0))
    }
}
