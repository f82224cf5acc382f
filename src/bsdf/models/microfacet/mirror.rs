//! The perfect mirror, alpha = 0.

use super::fresnel::CompiledFresnel;
use super::masking::Masking;
use crate::bsdf::call::Transport;
use crate::bsdf::job::{Direction, with_overrides};
use crate::bsdf::kernel::Kernel;
use crate::bsdf::lobes::{LobeSet, MAX_LOBES, PerLobe, first_lobe};
use crate::bsdf::precision::Precision;
use crate::bsdf::varying::VaryingValues;
use crate::num::{Rgb, Vec3};

/// The compiled mirror.
pub(super) struct Mirror<T: Precision> {
    pub(super) fresnel: CompiledFresnel<T>,
    pub(super) masking: Masking,
}

impl<T: Precision> Mirror<T> {
    fn reflectance(&self, overrides: &[(usize, [T; 3])], wo: Vec3<T>) -> Rgb<T> {
        let mut fresnel = self.fresnel.fresnel::<T>();
        for (param, value) in overrides {
            fresnel.vary(*param, *value);
        }
        let cos_theta = wo.z.min(T::new(1.0));
        let masking = self.masking.of_mirror(cos_theta);
        let reflectance = fresnel.reflectance(cos_theta);
        reflectance.map(|reflectance| reflectance * masking)
    }
}

impl<T: Precision> Kernel<T> for Mirror<T> {
    fn sample(
        &self,
        wo: Vec3<T>,
        _u: [T; 3],
        varying: &VaryingValues<T>,
        _lobes: LobeSet,
        _transport: Transport,
    ) -> Direction<T> {
        let weight = with_overrides(varying, |overrides| self.reflectance(overrides, wo));
        weight.map_or(Direction::none(), |weight| Direction {
            wi: wo.mirrored(),
            pdf: T::new(0.0),
            weight,
            eta: T::new(1.0),
            lobe: T::new(0.0),
            lobe_probability: T::new(1.0),
        })
    }

    fn albedo(&self, wo: Vec3<T>, varying: &VaryingValues<T>, _: LobeSet) -> Rgb<T> {
        with_overrides(varying, |overrides| self.reflectance(overrides, wo))
            .unwrap_or([T::new(0.0); 3])
    }

    fn lobes(
        &self,
        _wo: Vec3<T>,
        _wi: Vec3<T>,
        _varying: &VaryingValues<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        (first_lobe(T::new(1.0)), [T::new(0.0); MAX_LOBES])
    }

    fn plan(&self) -> Vec<&'static str> {
        let mirror = std::iter::once("perfect mirror");
        mirror.chain(self.fresnel.plan()).collect()
    }
}
