//! The trait of a model's formulas, generic over the lane type.

use super::lobes::{LobeSet, PerLobe, first_lobe};
use crate::num::{Lane, Rgb, Vec3, warp};

/// The formulas of a model whose lobes all reflect and have a density, for one surface or for one in each
/// lane. The defaults of `eval_with_densities`, `choose` and `sample` are those of a single diffuse lobe.
///
/// Directions passed in have unit length and z > 0; the results of lanes in which they do not are
/// discarded. A returned direction that has z <= 0 or is null means that there is no sample.
pub trait Surface<L: Lane> {
    /// Whether sampled directions are unit to rounding, whatever rounding has left of the length of wo. Others are
    /// looked at, and normalised where they are not.
    const SAMPLES_ARE_UNIT: bool = false;

    /// Replaces the value of a parameter that varies per call. All three components of a scalar are equal;
    /// a direction has unit length.
    fn vary(&mut self, param: usize, value: [L; 3]);

    /// Sets the vacuum wavelength, nm, of everything that depends on it: indices and films. All channels then have the
    /// value at this wavelength. It is called at most once, after the last [`Surface::vary`].
    #[inline(always)]
    fn set_wavelength(&mut self, _lambda_nm: L) {}

    /// Computes what depends on several parameters. It is called after the last [`Surface::vary`], and at
    /// least once before evaluation.
    #[inline(always)]
    fn finish_vary(&mut self) {}

    /// Removes the lobes that are not in the set from the value, by setting their weights to 0. A model
    /// with one lobe has nothing to do.
    #[inline(always)]
    fn retain(&mut self, _lobes: LobeSet) {}

    /// f(wo, wi) |wi.z|.
    fn eval(&self, wo: Vec3<L>, wi: Vec3<L>) -> Rgb<L>;

    /// [`Surface::eval`], and the density of each lobe at wi per solid angle.
    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<L>, wi: Vec3<L>) -> (Rgb<L>, PerLobe<L>) {
        (
            self.eval(wo, wi),
            first_lobe(warp::cosine_hemisphere_pdf(wi.z)),
        )
    }

    /// The probability of choosing each lobe, in proportion to its estimated share of the reflected light.
    /// The probabilities sum to 1, or are all 0 where nothing is reflected.
    #[inline(always)]
    fn choose(&self, _wo: Vec3<L>) -> PerLobe<L> {
        first_lobe(L::new(1.0))
    }

    /// Samples a direction with the density of `lobe` from two uniform numbers in [0, 1).
    #[inline(always)]
    fn sample(&self, _lobe: usize, _wo: Vec3<L>, u: [L; 2]) -> Vec3<L> {
        warp::cosine_hemisphere(u[0], u[1])
    }

    /// The directional albedo, if it has a closed form.
    fn closed_albedo(&self) -> Option<Rgb<L>> {
        None
    }
}
