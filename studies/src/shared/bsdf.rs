//! Single calls of a BSDF.

use pellicle::bsdf::Precision;
use pellicle::{Bsdf, Call, Sample};

/// Value and density of a pair of directions.
pub fn value_pdf<T: Precision>(
    bsdf: &Bsdf<T>,
    wo: T::Vector,
    wi: T::Vector,
    varying: Option<&[T]>,
) -> ([T; 3], T) {
    let found = bsdf.evaluate(wo, wi, varying, &Call::default());
    (found.value, found.pdf)
}

/// The value alone.
pub fn value<T: Precision>(bsdf: &Bsdf<T>, wo: T::Vector, wi: T::Vector) -> [T; 3] {
    bsdf.eval(wo, wi, None, &Call::default())
}

pub fn sample<T: Precision>(
    bsdf: &Bsdf<T>,
    wo: T::Vector,
    u: T::Vector,
    varying: Option<&[T]>,
) -> Sample<T> {
    bsdf.sample(wo, u, varying, &Call::default())
}

pub fn albedo<T: Precision>(bsdf: &Bsdf<T>, wo: T::Vector, varying: Option<&[T]>) -> [T; 3] {
    bsdf.albedo(wo, varying, &Call::default())
}

/// The probabilities of the lobes, and each lobe's density at wi.
pub fn lobes<T: Precision>(bsdf: &Bsdf<T>, wo: T::Vector, wi: T::Vector) -> [Vec<T>; 2] {
    let (probabilities, densities) = bsdf.lobes(wo, wi, None);
    [
        probabilities.into_iter().collect(),
        densities.into_iter().collect(),
    ]
}
