//! The ABC distribution of normals (Löw, Kronander, Ynnerman and Unger 2012, "BRDF Models for Accurate
//! and Efficient Rendering of Glossy Surfaces", section on the microfacet model; after Church and
//! Takacs's spectra of polished surfaces): a tip and a tail of any power.

use super::distribution::Normals;
use super::projected::Projected;
use super::quantile::Quantile;
use super::slopes::{matched_width, sin_squared, slope_density};
use crate::math::{Element, PI, Vec3};

/// D(h) = A / (1 + B (1 - h.z))^C.
///
/// The papers fit A, and the lecture prints the function without it; here A makes the projected area 1.
/// B follows from alpha: the height at the normal is A = 1 / (pi alpha^2), as for GGX, Beckmann's
/// distribution and Blinn's. So
///
/// ```text
/// alpha^2 = 2 integral from 0 to 1 of (1 - u) / (1 + B u)^C du
/// ```
///
/// which is solved for B at creation; for C > 1 and small alpha, B is near 2 / ((C - 1) alpha^2).
/// alpha = 1 is B = 0, an even density.
///
/// alpha is in [1e-4, 1], the exponent C in [0.5, 10]. C = 2 is nearly GGX, C = 10 nearly Blinn's; at
/// C <= 1 most of the area is in the tail, whatever alpha. Löw et al.'s fits to 100 measured materials
/// have C from 0.02 to 2.7, half of them between 0.9 and 1.5 about a median of 1.2.
pub(crate) struct Abc<T> {
    lobe: Lobe<T>,
    projected: Projected<T>,
    quantile: Quantile<T>,
}

impl<T: Element> Abc<T> {
    /// With its tables.
    pub(crate) fn new(alpha: f64, exponent: f64) -> Self {
        let at_normal = 1.0 / (PI * alpha * alpha);
        let b = width(alpha, exponent);
        let lobe = Lobe::<f64>::new(at_normal, b, exponent);
        Self {
            lobe: Lobe::new(at_normal, b, exponent),
            projected: Projected::new(alpha, |h| lobe.density(h)),
            quantile: Quantile::new(alpha, |h| lobe.density(h)),
        }
    }
}

/// The greatest ln(1 + B) that can be asked for: 37.4 for alpha = 1e-4 and C = 1/2.
const WIDEST: f64 = 40.0;

/// B.
fn width(alpha: f64, exponent: f64) -> f64 {
    if alpha >= 1.0 {
        return 0.0;
    }
    let ln_1p_b = matched_width(alpha, [0.0, WIDEST], |ln_1p_b, tan_squared| {
        let lobe = Lobe::new(1.0, ln_1p_b.exp_m1(), exponent);
        slope_density(|h| lobe.density(h), tan_squared)
    });
    ln_1p_b.exp_m1()
}

/// The function with its three parameters.
struct Lobe<T> {
    a: T,
    b: T,
    c: T,
}

impl<T: Element> Lobe<T> {
    fn new(a: f64, b: f64, c: f64) -> Self {
        let [a, b, c] = [a, b, c].map(T::new);
        Self { a, b, c }
    }

    /// 1 - h.z is sin^2 / (1 + h.z), which keeps its digits.
    #[inline(always)]
    fn density(&self, h: Vec3<T>) -> T {
        let one = T::new(1.0);
        let complement = sin_squared(h) / (one + h.z);
        let density = self.a * (-(self.c * (self.b * complement).ln_1p())).exp();
        T::select(h.z.gt(T::new(0.0)), density, T::new(0.0))
    }
}

impl<T: Element> Normals<T> for &Abc<T> {
    #[inline(always)]
    fn density(&self, h: Vec3<T>) -> T {
        self.lobe.density(h)
    }

    #[inline(always)]
    fn averted_area(&self, w: Vec3<T>) -> T {
        self.projected.averted_area(w)
    }

    /// The area up to an angle is the difference of two powers of 1 + B (1 - h.z), which has no inverse
    /// in closed form: by table.
    #[inline(always)]
    fn sample(&self, _wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        self.quantile.sample(u)
    }

    /// D(h) h.z
    #[inline(always)]
    fn sample_density(&self, _wo: Vec3<T>, h: Vec3<T>) -> T {
        self.density(h) * h.z
    }
}
