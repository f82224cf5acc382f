//! Directional albedo by deterministic quadrature over the random numbers of each lobe.

use super::job::choices;
use super::lobes::{LobeSet, MAX_LOBES, PerLobe, mixture_density};
use super::surface::Surface;
use crate::num::{Lane, Mask, Rgb, Vec3};

/// Two successive Fibonacci numbers. The nodes are ((i + 1/2) / NODES, i * GENERATOR / NODES mod 1): the
/// Fibonacci lattice, which is the most evenly spread lattice in two dimensions (Niederreiter 1992, section
/// 5). A product grid is worse where the critical cone cuts a lobe, because whole rows cross its edge at
/// once.
const NODES: u32 = 4181;
const GENERATOR: u32 = 2584;

/// The integral of the value over wi. It is the sum over the lobes of the lobe's probability times the mean
/// of value / pdf over the lattice in its two uniform numbers: the balance heuristic with fixed instead of
/// random numbers, so that every integrand is bounded.
///
/// A test measures the error against adaptive integration. It is below 2e-3 of the greatest channel of the
/// albedo for all models, for layers up to 3 um and microfacets up to 80 degrees; at 89 degrees it is up to
/// 1.5e-2 for microfacets that do not sample visible normals.
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

/// [`Surface::eval_with_densities`] without inlining: code that is not hot needs no copy of its own, which
/// would lengthen the build.
#[inline(never)]
pub fn eval_outlined<L: Lane, S: Surface<L>>(
    surface: &S,
    wo: Vec3<L>,
    wi: Vec3<L>,
) -> (Rgb<L>, PerLobe<L>) {
    surface.eval_with_densities(wo, wi)
}
