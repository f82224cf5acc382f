//! # `lambert`: the ideal diffuse reflector
//!
//! f = reflectance / pi (Lambert 1760; the lecture's `f_Lambert = c_diff / pi`). The radiance does
//! not depend on the viewer. Use it for chalk, plaster and unvarnished wood; not for rough surfaces
//! seen at grazing angles, which are flatter than this.

use super::info::{Flags, LobeInfo, ModelInfo, ParamInfo, ParamKind};
use super::mixture::Mixture;
use super::precision::Precision;
use super::scattering::{MAX_LOBES, Model, PerLobe, Scattering};
use super::values::Values;
use crate::error::Error;
use crate::math::{Element, PI, Rgb, Vec3, warp};

/// The model; see the module's documentation.
pub struct Lambert;

const REFLECTANCE: usize = 0;

impl Model for Lambert {
    const INFO: ModelInfo = ModelInfo {
        name: c"lambert",
        summary: c"Ideal diffuse reflection.",
        source: c"Lambert 1760, Photometria",
        params: &[ParamInfo {
            name: c"reflectance",
            unit: c"",
            summary: c"Fraction of light reflected, RGB.",
            kind: ParamKind::Number {
                components: 3,
                min: 0.0,
                max: 1.0,
                default: 0.5,
            },
            can_vary: true,
        }],
        lobes: &[LobeInfo {
            name: c"diffuse",
            flags: Flags::REFLECTION.with(Flags::DIFFUSE),
        }],
        film_thickness: None,
        film_choice: None,
        not_reciprocal: None,
        not_conserving: None,
    };

    type Prepared<T: Precision> = Mixture<Prepared<T>>;

    fn prepare<T: Precision>(values: &Values<T>) -> Result<Mixture<Prepared<T>>, Error> {
        Ok(Mixture(Prepared {
            reflectance: values.rgb(REFLECTANCE),
        }))
    }
}

/// The compiled model.
#[derive(Clone, Copy)]
pub struct Prepared<T> {
    reflectance: Rgb<T>,
}

impl<T: Element> Scattering<T> for Prepared<T> {
    #[inline(always)]
    fn vary(&mut self, _param: usize, value: [T; 3]) {
        self.reflectance = value;
    }

    #[inline(always)]
    fn eval(&self, _wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        let factor = wi.z * T::new(1.0 / PI);
        self.reflectance.map(|reflectance| reflectance * factor)
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let mut densities = [T::new(0.0); MAX_LOBES];
        densities[0] = warp::cosine_hemisphere_pdf(wi.z);
        (self.eval(wo, wi), densities)
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

    fn albedo(&self, _wo: Vec3<T>) -> Rgb<T> {
        self.reflectance
    }
}
