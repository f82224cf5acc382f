//! # `lambert`: the ideal diffuse reflector
//!
//! f = reflectance / pi (Lambert 1760; the lecture's `f_Lambert = c_diff / pi`). The radiance does not
//! depend on the viewer. Use it for chalk, plaster and unvarnished wood; do not use it for rough surfaces,
//! which look flatter (see `oren_nayar`).

use crate::bsdf::compiled::{Compiled, kernel};
use crate::bsdf::info::{LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::surface::Surface;
use crate::bsdf::values::Values;
use crate::num::{Lane, PI, Rgb, Vec3, each};

/// The model; see the module's documentation.
pub struct Lambert;

const REFLECTANCE: usize = 0;

impl Model for Lambert {
    const INFO: ModelInfo = ModelInfo {
        name: "lambert",
        summary: "Ideal diffuse reflection.",
        source: "Lambert 1760, Photometria",
        params: &[ParamInfo::rgb(
            "reflectance",
            "Fraction of light reflected, RGB.",
            [0.0, 1.0],
            0.5,
        )],
        lobes: &[LobeInfo::DIFFUSE],
        ..ModelInfo::PLAIN
    };

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        Ok(kernel(LambertSurface {
            reflectance: values.rgb(REFLECTANCE),
        }))
    }
}

/// The values of the parameters, for one surface or for one in each lane.
#[derive(Clone, Copy)]
pub struct LambertSurface<T> {
    reflectance: Rgb<T>,
}

impl<T: Precision> Compiled<T> for LambertSurface<T> {
    type Surface<'a, L: Lane<Scalar = T>> = LambertSurface<L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> LambertSurface<L> {
        let reflectance = each!(self.reflectance, |channel| L::splat(channel));
        LambertSurface { reflectance }
    }
}

impl<L: Lane> Surface<L> for LambertSurface<L> {
    const SAMPLES_ARE_UNIT: bool = true;

    #[inline(always)]
    fn vary(&mut self, _param: usize, value: [L; 3]) {
        self.reflectance = value;
    }

    #[inline(always)]
    fn eval(&self, _wo: Vec3<L>, wi: Vec3<L>) -> Rgb<L> {
        let factor = wi.z * L::new(1.0 / PI);
        each!(self.reflectance, |reflectance| reflectance * factor)
    }

    fn closed_albedo(&self) -> Option<Rgb<L>> {
        Some(self.reflectance)
    }
}
