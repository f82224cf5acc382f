//! What a spectral call gives to a kernel and takes from it, and which BSDFs have spectral calls.

use super::call::Transport;
use super::info::ModelInfo;
use super::lobes::LobeSet;
use super::values::Values;
use super::varying::{MAX_VARYING, VaryingValues};
use crate::num::{Lane, Real, Vec3};
use std::ops::Range;

/// The greatest number of wavelengths of a call.
pub const MAX_WAVELENGTHS: usize = 16;

/// The most values that varying parameters have together in a spectral call.
pub(crate) const MAX_SPECTRAL_FLOATS: usize = MAX_VARYING * MAX_WAVELENGTHS;

/// A number for each wavelength of a call. Those beyond the last are not used.
pub type PerWavelength<T> = [T; MAX_WAVELENGTHS];

/// What a kernel needs to know of a spectral call.
pub struct SpectralCall<'a, T> {
    /// Vacuum wavelengths, nm; beyond the last one it is repeated.
    pub lambda_nm: PerWavelength<T>,
    /// The number of wavelengths, at least 1.
    pub count: usize,
    /// The wavelength that directions are sampled for.
    pub hero: usize,
    /// The values of the parameters that vary; element j has those at wavelength j.
    pub varying: VaryingValues<'a, T>,
    /// The lobes that take part.
    pub lobes: LobeSet,
    /// The quantity that is transported along the path.
    pub transport: Transport,
}

impl<T> SpectralCall<'_, T> {
    /// The wavelengths in blocks of that many, of which the last may go beyond the last wavelength.
    pub fn blocks(&self, length: usize) -> impl Iterator<Item = Range<usize>> {
        (0..self.count)
            .step_by(length)
            .map(move |from| from..from + length)
    }
}

/// What a kernel finds at each wavelength.
pub struct SpectralValues<T> {
    /// f |wi.z|; of a sample value / mean of the densities.
    pub value: PerWavelength<T>,
    /// The density of wi as if the wavelength had been the hero; of a Dirac lobe the probability of choosing it.
    pub pdf: PerWavelength<T>,
}

impl<T: Real> SpectralValues<T> {
    /// Zeros.
    pub fn new() -> Self {
        let zeros = [T::new(0.0); MAX_WAVELENGTHS];
        Self {
            value: zeros,
            pdf: zeros,
        }
    }

    /// Copies the numbers of the wavelengths that a call has, as many as `value` and `pdf` hold.
    pub fn copy_to(&self, value: &mut [T], pdf: &mut [T]) {
        value.copy_from_slice(&self.value[..value.len()]);
        pdf.copy_from_slice(&self.pdf[..pdf.len()]);
    }

    /// Makes values weights: divides them by the mean of the densities over `count` wavelengths.
    pub fn weigh(&mut self, count: usize) {
        let mut sum = T::new(0.0);
        for density in &self.pdf[..count] {
            sum = sum + *density;
        }
        let mean = sum / T::new(count as f64);
        for value in &mut self.value[..count] {
            *value = *value / mean;
        }
    }
}

/// Why spectral calls of a BSDF with these values are refused; `None` if they are not.
pub(super) fn refusal<T: Real + PartialOrd + Into<f64>>(
    info: &ModelInfo,
    values: &Values<T>,
) -> Option<String> {
    for (index, param) in info.params.iter().enumerate() {
        let [a, b, c] = values.rgb(index);
        let is_used = param.is_used(|choice| values.choice(choice)) && !values.varies(index);
        if param.is_color() && is_used && !(a == b && b == c) {
            let name = param.name();
            let (a, b, c): (f64, f64, f64) = (a.into(), b.into(), c.into());
            let remedy = if param.can_vary {
                "declare it varying and give a number for each wavelength"
            } else {
                "give three equal numbers"
            };
            return Some(format!(
                "spectral calls of a BSDF whose colour '{name}' is ({a}, {b}, {c}): three numbers do not determine \
                 a spectrum; {remedy}"
            ));
        }
    }
    let spread = info.film_thickness_spread?;
    let is_spread = values.varies(spread) || values.number(spread) > T::new(0.0);
    is_spread.then(|| {
        format!(
            "spectral calls of a BSDF with '{}', whose averages are of colours; vary the thickness instead",
            info.params[spread].name()
        )
    })
}

/// The same vector in every lane.
#[inline(always)]
pub(super) fn splat_vector<L: Lane>(v: Vec3<L::Scalar>) -> Vec3<L> {
    Vec3::new(L::splat(v.x), L::splat(v.y), L::splat(v.z))
}
