//! Diffuse models: one broad lobe, whose directions are drawn in proportion to their cosine.

use crate::bsdf::model::{MAX_LOBES, PerLobe, Scattering};
use crate::num::{Lane, Rgb, Vec3, warp};

/// A compiled model of one diffuse lobe.
pub trait Diffuse<T: Lane> {
    /// As [`Scattering::vary`].
    fn vary(&mut self, param: usize, value: [T; 3]);

    /// f(wo, wi) wi.z
    fn value(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T>;

    /// Directional albedo, if it has a closed form.
    fn closed_albedo(&self) -> Option<Rgb<T>> {
        None
    }
}

/// The scattering of a [`Diffuse`] model.
#[derive(Clone, Copy)]
pub struct CosineLobe<D>(pub D);

impl<T: Lane, D: Diffuse<T>> Scattering<T> for CosineLobe<D> {
    #[inline(always)]
    fn vary(&mut self, param: usize, value: [T; 3]) {
        self.0.vary(param, value);
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.0.value(wo, wi)
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let mut densities = [T::new(0.0); MAX_LOBES];
        densities[0] = warp::cosine_hemisphere_pdf(wi.z);
        (self.0.value(wo, wi), densities)
    }

    #[inline(always)]
    fn selection(&self, _wo: Vec3<T>) -> PerLobe<T> {
        let mut selection = [T::new(0.0); MAX_LOBES];
        selection[0] = T::new(1.0);
        selection
    }

    #[inline(always)]
    fn sample(&self, _lobe: usize, _wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        warp::cosine_hemisphere(u[0], u[1])
    }

    fn closed_albedo(&self) -> Option<Rgb<T>> {
        self.0.closed_albedo()
    }
}
