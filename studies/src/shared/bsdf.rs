//! Single calls of a BSDF.

use pellicle::{Bsdf, Sample, Scalar};

/// Value and density of a pair of directions.
pub fn value_pdf<T: Scalar>(
    bsdf: &Bsdf<T>,
    wo: T::Vector,
    wi: T::Vector,
    varying: Option<&[T]>,
) -> ([T; 3], T) {
    bsdf.eval_pdf(wo, wi, varying)
}

/// The value alone.
pub fn value<T: Scalar>(bsdf: &Bsdf<T>, wo: T::Vector, wi: T::Vector) -> [T; 3] {
    bsdf.eval(wo, wi, None)
}

pub fn sample<T: Scalar>(
    bsdf: &Bsdf<T>,
    wo: T::Vector,
    u: T::Vector,
    varying: Option<&[T]>,
) -> Sample<T> {
    bsdf.sample(wo, u, varying)
}

pub fn albedo<T: Scalar>(bsdf: &Bsdf<T>, wo: T::Vector, varying: Option<&[T]>) -> [T; 3] {
    bsdf.albedo(wo, varying)
}

/// The probabilities of the lobes, and each lobe's density at wi.
pub fn lobes<T: Scalar>(bsdf: &Bsdf<T>, wo: T::Vector, wi: T::Vector) -> [Vec<T>; 2] {
    let (probabilities, densities) = bsdf.lobes(wo, wi, None);
    [
        probabilities.into_iter().collect(),
        densities.into_iter().collect(),
    ]
}
