//! # `disney_diffuse`: a diffuse reflector fitted to measured materials
//!
//! pi f / reflectance = (1 + (F - 1)(1 - wi.z)^5) (1 + (F - 1)(1 - wo.z)^5)
//!
//! with F = 0.5 + 2 roughness cos^2 theta_d, where theta_d is the angle between wi and the half vector:
//! Burley 2012 ("Physically-Based Shading at Disney"), section 5.3. At grazing angles smooth surfaces are
//! darker, as below a refracting boundary, and rough ones brighter. The form is an empirical fit. Use it to
//! match assets authored for it. As with `oren_nayar`, its roughness is not that of the highlight.
//!
//! **Limits**: the albedo exceeds 1 if the reflectance is near 1 and the roughness is above 0.4: for
//! reflectance 1 and roughness 1 by 3.6 % at normal incidence and by 56 % at grazing angles.

use crate::bsdf::compiled::{Compiled, kernel};
use crate::bsdf::info::{Exception, LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::surface::Surface;
use crate::bsdf::values::Values;
use crate::num::{Lane, PI, Real, Rgb, Vec3, each};

/// The model; see the module's documentation.
pub struct DisneyDiffuse;

const REFLECTANCE: usize = 0;
const ROUGHNESS: usize = 1;

impl Model for DisneyDiffuse {
    const INFO: ModelInfo = ModelInfo {
        name: "disney_diffuse",
        summary: "Diffuse reflection fitted to measured materials: darker or brighter at grazing angles.",
        source: "Burley 2012, Physically-Based Shading at Disney, section 5.3",
        params: &[
            ParamInfo::rgb(
                "reflectance",
                "Fraction of light reflected, RGB, apart from grazing angles.",
                [0.0, 1.0],
                0.5,
            ),
            ParamInfo::number(
                "roughness",
                "0 darkens grazing angles, 1 brightens them.",
                [0.0, 1.0],
                0.5,
            ),
        ],
        lobes: &[LobeInfo::DIFFUSE],
        not_conserving: Some(Exception {
            cases: &[&[]],
            reason: "a reflectance near 1 with roughness above 0.4: up to 56 % too much at grazing angles",
        }),
        ..ModelInfo::PLAIN
    };

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        Ok(kernel(DisneySurface {
            reflectance: values.rgb(REFLECTANCE),
            roughness: values.number(ROUGHNESS),
        }))
    }
}

/// The values of the parameters, for one surface or for one in each lane.
#[derive(Clone, Copy)]
pub struct DisneySurface<T> {
    reflectance: Rgb<T>,
    roughness: T,
}

/// f |wi.z| divided by the reflectance; cos^2 theta_d = (1 + <wo, wi>) / 2.
#[inline(always)]
pub(super) fn value<T: Real>(roughness: T, wo: Vec3<T>, wi: Vec3<T>) -> T {
    let one = T::new(1.0);
    let excess = roughness * (one + wo.dot(wi)) - T::new(0.5);
    let factor = |w: Vec3<T>| one + excess * (one - w.z).pow5();
    factor(wo) * factor(wi) * wi.z * T::new(1.0 / PI)
}

/// An upper bound of the directional albedo for reflectance 1, our own fit. From roughness 0.4 on, where
/// the albedo begins to exceed 1, the bound is above it by less than 0.03.
#[inline(always)]
pub(super) fn greatest_albedo<T: Real>(roughness: T) -> T {
    let above = (roughness - T::new(0.4)).max(T::new(0.0));
    T::new(1.0) + T::new(1.3) * above.squared() / (above + T::new(0.2))
}

impl<T: Precision> Compiled<T> for DisneySurface<T> {
    type Surface<'a, L: Lane<Scalar = T>> = DisneySurface<L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> DisneySurface<L> {
        DisneySurface {
            reflectance: each!(self.reflectance, |channel| L::splat(channel)),
            roughness: L::splat(self.roughness),
        }
    }
}

impl<L: Lane> Surface<L> for DisneySurface<L> {
    const SAMPLES_ARE_UNIT: bool = true;

    #[inline(always)]
    fn vary(&mut self, param: usize, value: [L; 3]) {
        match param {
            REFLECTANCE => self.reflectance = value,
            _ => self.roughness = value[0],
        }
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<L>, wi: Vec3<L>) -> Rgb<L> {
        let value = value(self.roughness, wo, wi);
        each!(self.reflectance, |reflectance| reflectance * value)
    }
}
