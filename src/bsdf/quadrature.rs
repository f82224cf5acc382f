//! Directional albedo by deterministic quadrature over the lobes' own parametrisations.

use super::job::choices;
use super::lobes::{LobeSet, MAX_LOBES, PerLobe, mixture_density};
use super::surface::Surface;
use crate::num::{Lane, Mask, Rgb, Vec3};

/// Two successive Fibonacci numbers: the nodes of a lobe are (i + 1/2) / NODES and
/// i * GENERATOR / NODES mod 1, the Fibonacci lattice, which is the most evenly spread lattice of two
/// dimensions (Niederreiter 1992, section 5). A product grid is worse where a lobe is cut by the critical
/// cone, since whole rows cross the edge at once.
const NODES: u32 = 4181;
const GENERATOR: u32 = 2584;

/// The integral of the value over wi: the sum over lobes of the probability times the mean of
/// value / pdf over the lattice in the lobe's two uniform numbers. This is the balance heuristic with fixed
/// instead of random numbers, so every integrand is bounded.
///
/// A test measures the error against adaptive integration: below 2e-3 of the albedo's greatest channel for
/// all models, for layers to 3 um and microfacets to 80 degrees; at 89 degrees up to 1.5e-2 for microfacets
/// whose samples are not those of visible normals.
pub fn albedo<L: Lane, S: Surface<L>>(surface: &S, lobes: LobeSet, wo: Vec3<L>) -> Rgb<L> {
    let shares = choices(surface, wo, lobes);
    let zero = L::new(0.0);
    let mut sum = [zero; 3];
    for lobe in (0..MAX_LOBES).filter(|&lobe| shares[lobe].gt(zero).any()) {
        for i in 0..NODES {
            let fraction = |numerator: f64| L::new(numerator / f64::from(NODES));
            let u1 = fraction(f64::from(i) + 0.5);
            let u2 = fraction(f64::from(i * GENERATOR % NODES));
            let wi = surface.sample(lobe, wo, [u1, u2]);
            let (value, densities) = eval_outlined(surface, wo, wi);
            let pdf = mixture_density(&shares, &densities);
            let is_usable = wi.z.gt(zero) & pdf.gt(zero) & shares[lobe].gt(zero);
            for channel in 0..3 {
                let weight = shares[lobe] * value[channel] / pdf;
                sum[channel] = sum[channel] + L::select(is_usable, weight, zero);
            }
        }
    }
    sum.map(|channel| channel * L::new(1.0 / f64::from(NODES)))
}

/// [`Surface::eval_with_densities`] as a call: code that is not hot needs no inlined copy, which takes long
/// to compile.
#[inline(never)]
pub fn eval_outlined<L: Lane, S: Surface<L>>(
    surface: &S,
    wo: Vec3<L>,
    wi: Vec3<L>,
) -> (Rgb<L>, PerLobe<L>) {
    surface.eval_with_densities(wo, wi)
}
