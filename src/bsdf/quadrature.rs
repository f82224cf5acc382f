//! Directional albedo by deterministic quadrature over the lobes' own parametrisations.

use super::model::{MAX_LOBES, Scattering};
use crate::num::{Lane, Mask, Real, Rgb, Vec3};

/// Two successive Fibonacci numbers: the nodes of a lobe are (i + 1/2) / NODES and
/// i * GENERATOR / NODES mod 1, the Fibonacci lattice, which of all lattices of two dimensions is
/// spread most evenly (Niederreiter 1992, section 5). A product grid is worse
/// where a lobe is cut by the critical cone, since whole rows cross the edge at once.
const NODES: u32 = 4181;
const GENERATOR: u32 = 2584;

/// The integral of value over wi, as the sum over lobes of probability times the mean of
/// value / pdf over the lattice in the lobe's two uniform numbers: the balance heuristic with fixed
/// instead of random numbers, so every integrand is bounded.
///
/// `tests/laws/albedo.rs` measures the error against adaptive integration: below 2e-3 of the albedo's
/// greatest channel for all models, for layers to 3 um and microfacets to 80 degrees; at 89 degrees up
/// to 1.5e-2 for microfacets whose samples are not those of visible normals.
pub fn albedo<T: Lane, S: Scattering<T>>(scattering: &S, wo: Vec3<T>) -> Rgb<T> {
    let selection = scattering.selection(wo);
    let zero = T::new(0.0);
    let mut sum = [zero; 3];
    for lobe in (0..MAX_LOBES).filter(|&lobe| selection[lobe].gt(zero).any()) {
        for i in 0..NODES {
            let fraction = |numerator: f64| T::new(numerator / f64::from(NODES));
            let u1 = fraction(f64::from(i) + 0.5);
            let u2 = fraction(f64::from(i * GENERATOR % NODES));
            let wi = scattering.sample(lobe, wo, [u1, u2]);
            let (value, densities) = scattering.eval_with_densities(wo, wi);
            let pdf = mixture(&selection, &densities);
            let usable = wi.z.gt(zero) & pdf.gt(zero) & selection[lobe].gt(zero);
            for channel in 0..3 {
                let weight = selection[lobe] * value[channel] / pdf;
                sum[channel] = sum[channel] + T::select(usable, weight, zero);
            }
        }
    }
    sum.map(|channel| channel * T::new(1.0 / f64::from(NODES)))
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
