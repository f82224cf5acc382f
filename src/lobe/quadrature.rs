//! Directional albedo by deterministic quadrature over the lobes' own parametrisations.

use super::scattering::{MAX_LOBES, Scattering};
use crate::math::{Mask, Real, Rgb, Vec3};

/// Nodes along each of a lobe's two uniform numbers.
const NODES: usize = 48;

/// The integral of value over wi, as the sum over lobes of probability times the mean of
/// value / pdf over a NODES x NODES midpoint grid of the lobe's uniform numbers: the balance
/// heuristic with stratified instead of random numbers, so every integrand is bounded.
///
/// The error, measured against adaptive integration in `tests/albedo.rs`, is stated there per model.
pub fn albedo<T: Real, S: Scattering<T>>(scattering: &S, wo: Vec3<T>) -> Rgb<T> {
    let selection = scattering.selection(wo);
    let node = |i: usize| T::new((i as f64 + 0.5) / NODES as f64);
    let zero = T::new(0.0);
    let mut sum = [zero; 3];
    for lobe in (0..MAX_LOBES).filter(|&lobe| selection[lobe].gt(zero).any()) {
        for (i, j) in (0..NODES * NODES).map(|n| (n / NODES, n % NODES)) {
            let wi = scattering.sample(lobe, wo, [node(i), node(j)]);
            let (value, densities) = scattering.eval_with_densities(wo, wi);
            let pdf = mixture(&selection, &densities);
            let usable = wi.z.gt(zero) & pdf.gt(zero) & selection[lobe].gt(zero);
            for channel in 0..3 {
                let weight = selection[lobe] * value[channel] / pdf;
                sum[channel] = sum[channel] + T::select(usable, weight, zero);
            }
        }
    }
    sum.map(|channel| channel * T::new(1.0 / (NODES * NODES) as f64))
}

/// The density of all lobes together.
#[inline(always)]
pub fn mixture<T: Real>(selection: &[T; MAX_LOBES], densities: &[T; MAX_LOBES]) -> T {
    let mut sum = T::new(0.0);
    for lobe in 0..MAX_LOBES {
        sum = sum + selection[lobe] * densities[lobe];
    }
    sum
}
