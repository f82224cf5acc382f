//! The perfect mirror, alpha = 0.

use super::fresnel::{CompiledFresnel, ThreeIndices};
use super::masking::Masking;
use crate::bsdf::call::Transport;
use crate::bsdf::job::{Direction, with_overrides};
use crate::bsdf::kernel::Kernel;
use crate::bsdf::lobes::{LobeSet, MAX_LOBES, PerLobe, first_lobe};
use crate::bsdf::precision::Precision;
use crate::bsdf::varying::VaryingValues;
use crate::bsdf::wavelengths::{SpectralCall, SpectralValues};
use crate::film::Film;
use crate::num::{Lane, Real, Rgb, Vec3};

/// The compiled mirror.
pub(super) struct Mirror<T: Precision> {
    pub(super) fresnel: CompiledFresnel<T>,
    pub(super) masking: Masking,
    pub(super) indices: ThreeIndices<T>,
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

/// The sample of a mirror.
fn reflected<T: Precision>(wo: Vec3<T>, weight: Rgb<T>) -> Direction<T> {
    Direction {
        wi: wo.mirrored(),
        pdf: T::new(0.0),
        weight,
        eta: T::new(1.0),
        lobe: T::new(0.0),
        lobe_probability: T::new(1.0),
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
        weight.map_or(Direction::none(), |weight| reflected(wo, weight))
    }

    fn sample_spectral(
        &self,
        wo: Vec3<T>,
        _u: [T; 3],
        call: &SpectralCall<T>,
        found: &mut SpectralValues<T>,
    ) -> (Direction<T>, bool) {
        let (zero, one) = (T::Wavelengths::new(0.0), T::Wavelengths::new(1.0));
        let cos_theta = wo.z.min(T::new(1.0));
        let masking = T::Wavelengths::splat(self.masking.of_mirror(cos_theta));
        for used in call.blocks(T::Wavelengths::COUNT) {
            let mut fresnel = self.fresnel.fresnel::<T::Wavelengths>();
            let varied = |param, value| fresnel.vary(param, value);
            let is_usable = call.varying.clamp_inputs(used.start, varied);
            let lambda_nm = T::Wavelengths::load(&call.lambda_nm[used.clone()]);
            let fresnel = fresnel.at_wavelength(&self.indices, lambda_nm);
            let [reflectance, ..] = fresnel.reflectance(T::Wavelengths::splat(cos_theta));
            T::Wavelengths::select(is_usable, reflectance * masking, zero)
                .store(&mut found.value[used.clone()]);
            T::Wavelengths::select(is_usable, one, zero).store(&mut found.pdf[used]);
        }
        if found.pdf[call.hero] == T::new(0.0) {
            *found = SpectralValues::new();
            return (Direction::none(), false);
        }
        found.weigh(call.count);
        (reflected(wo, [found.value[call.hero]; 3]), false)
    }

    fn film(&self) -> Option<&Film> {
        self.fresnel.film()
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
