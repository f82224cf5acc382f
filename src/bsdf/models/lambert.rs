//! # `lambert`: the ideal diffuse reflector
//!
//! f = reflectance / pi (Lambert 1760; the lecture's `f_Lambert = c_diff / pi`). The radiance does
//! not depend on the viewer. Use it for chalk, plaster and unvarnished wood; not for rough surfaces
//! seen at grazing angles, which are flatter than this.

use super::cosine_lobe::{CosineLobe, Diffuse};
use crate::bsdf::info::{LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::mixture::{Mixture, Surfaces};
use crate::bsdf::model::{Compiled, Model};
use crate::bsdf::precision::Precision;
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

    fn prepare<T: Precision>(values: &Values<T>) -> Compiled<T> {
        Ok(Box::new(Mixture(Prepared {
            reflectance: values.rgb(REFLECTANCE),
        })))
    }
}

/// The compiled model.
#[derive(Clone, Copy)]
pub struct Prepared<T> {
    reflectance: Rgb<T>,
}

impl<T: Precision> Surfaces<T> for Prepared<T> {
    type Surface<'a, L: Lane<Scalar = T>> = CosineLobe<Prepared<L>>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> CosineLobe<Prepared<L>> {
        let reflectance = each!(self.reflectance, |channel| L::splat(channel));
        CosineLobe(Prepared { reflectance })
    }
}

impl<T: Lane> Diffuse<T> for Prepared<T> {
    #[inline(always)]
    fn vary(&mut self, _param: usize, value: [T; 3]) {
        self.reflectance = value;
    }

    #[inline(always)]
    fn value(&self, _wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        let factor = wi.z * T::new(1.0 / PI);
        each!(self.reflectance, |reflectance| reflectance * factor)
    }

    fn closed_albedo(&self) -> Option<Rgb<T>> {
        Some(self.reflectance)
    }
}
