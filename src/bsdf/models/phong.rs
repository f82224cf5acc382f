//! # `phong`: a diffuse part and a normalised highlight about the mirror direction
//!
//! f = diffuse / pi + specular (e + 2) / (2 pi) max(0, <mirror of wo, wi>)^e
//!
//! Phong 1975 in the reciprocal, energy-conserving form of Lafortune and Willems 1994 ("Using the modified
//! Phong reflectance model for physically based rendering", eq. 5 and 6): the highlight is not divided by
//! the cosine, and its albedo is `specular` at normal incidence and less elsewhere. diffuse + specular must
//! not exceed 1 in any channel. Use it for plastics and as a baseline. It darkens towards grazing angles,
//! where real surfaces become brighter.
//!
//! **Ambient**: Phong's third term (the lecture shows ambient + diffuse + specular) approximates light that
//! arrives equally from all directions. It describes a light and not the surface, so it is not a parameter
//! here. A renderer without light between surfaces adds it once per visible point: the ambient radiance
//! times a reflectance. Phong takes the diffuse colour as reflectance; exact is the directional albedo
//! (`Bsdf::albedo`, `pellicle_bsdf_albedo`), which integrates and is meant for preparation. A renderer that
//! computes light between surfaces leaves the term out.

use super::power_lobe::{Power, conserving_normalization, estimated_integral, mean, sample_about};
use crate::bsdf::compiled::{Compiled, kernel};
use crate::bsdf::info::{LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::lobes::{LobeSet, MAX_LOBES, PerLobe, normalized};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::surface::Surface;
use crate::bsdf::values::{Bounds, Values};
use crate::error::Error;
use crate::num::{Lane, PI, Real, Rgb, Vec3, each, warp};

/// The model; see the module's documentation.
pub struct Phong;

const DIFFUSE: usize = 0;
const SPECULAR: usize = 1;
const EXPONENT: usize = 2;

const DIFFUSE_LOBE: usize = 0;
const SPECULAR_LOBE: usize = 1;

impl Model for Phong {
    const INFO: ModelInfo = ModelInfo {
        name: "phong",
        summary: "A diffuse part and a normalised highlight about the mirror direction.",
        source: "Phong 1975, normalised by Lafortune and Willems 1994, eq. 5 and 6",
        params: &[
            ParamInfo::rgb(
                "diffuse",
                "Albedo of the diffuse part, RGB; diffuse + specular <= 1.",
                [0.0, 1.0],
                0.5,
            ),
            ParamInfo::rgb(
                "specular",
                "Albedo of the highlight at normal incidence, RGB.",
                [0.0, 1.0],
                0.25,
            ),
            ParamInfo::number("exponent", "Sharpness of the highlight.", [0.0, 1e5], 50.0),
        ],
        lobes: &[LobeInfo::DIFFUSE, LobeInfo::SPECULAR],
        ..ModelInfo::PLAIN
    };

    fn check(bounds: &Bounds) -> Result<(), Error> {
        let upper = &bounds.greatest;
        let (diffuse, specular) = (upper.rgb(DIFFUSE), upper.rgb(SPECULAR));
        for channel in 0..3 {
            let sum = diffuse[channel] + specular[channel];
            if sum > 1.0 {
                return Err(Error::out_of_range(format!(
                    "diffuse[{channel}] + specular[{channel}] = {} + {} = {sum} exceeds 1",
                    diffuse[channel], specular[channel]
                )));
            }
        }
        Ok(())
    }

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        Ok(kernel(PhongSurface {
            diffuse: values.rgb(DIFFUSE),
            specular: values.rgb(SPECULAR),
            exponent: values.number(EXPONENT),
            power: if values.varies(EXPONENT) {
                Power::of_any(values.number(EXPONENT))
            } else {
                Power::of(values.number(EXPONENT))
            },
        }))
    }
}

/// The values of the parameters, for one surface or for one in each lane.
#[derive(Clone, Copy)]
pub struct PhongSurface<T> {
    diffuse: Rgb<T>,
    specular: Rgb<T>,
    exponent: T,
    power: Power<T>,
}

impl<T: Precision> Compiled<T> for PhongSurface<T> {
    type Surface<'a, L: Lane<Scalar = T>> = PhongSurface<L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> PhongSurface<L> {
        PhongSurface {
            diffuse: each!(self.diffuse, |channel| L::splat(channel)),
            specular: each!(self.specular, |channel| L::splat(channel)),
            exponent: L::splat(self.exponent),
            power: self.power.splat(),
        }
    }

    fn plan(&self) -> Vec<&'static str> {
        let is_multiplied = self.power.is_multiplied();
        is_multiplied
            .then_some("exponent by products")
            .into_iter()
            .collect()
    }
}

impl<T: Real> PhongSurface<T> {
    /// The value, and cos^e, which the density needs too.
    #[inline(always)]
    fn value_and_power(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, T) {
        let complement = wo.mirrored().minus(wi).length_squared() * T::new(0.5);
        let power = self.power.root(complement).squared();
        let normalization = conserving_normalization(self.exponent);
        let highlight = normalization * power;
        let value = each!([0, 1, 2], |channel| {
            let diffuse = self.diffuse[channel] * T::new(1.0 / PI);
            (diffuse + self.specular[channel] * highlight) * wi.z
        });
        (value, power)
    }
}

impl<T: Lane> Surface<T> for PhongSurface<T> {
    #[inline(always)]
    fn vary(&mut self, param: usize, value: [T; 3]) {
        match param {
            DIFFUSE => self.diffuse = value,
            SPECULAR => self.specular = value,
            _ => {
                self.exponent = value[0];
                self.power = Power::of_any(value[0]);
            }
        }
    }

    #[inline(always)]
    fn retain(&mut self, lobes: LobeSet) {
        let zero = [T::new(0.0); 3];
        if !lobes.contains(DIFFUSE_LOBE) {
            self.diffuse = zero;
        }
        if !lobes.contains(SPECULAR_LOBE) {
            self.specular = zero;
        }
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.value_and_power(wo, wi).0
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let (value, power) = self.value_and_power(wo, wi);
        let mut densities = [T::new(0.0); MAX_LOBES];
        densities[DIFFUSE_LOBE] = warp::cosine_hemisphere_pdf(wi.z);
        densities[SPECULAR_LOBE] = power * warp::power_cosine_normalization(self.exponent);
        (value, densities)
    }

    #[inline(always)]
    fn choose(&self, wo: Vec3<T>) -> PerLobe<T> {
        let normalization = conserving_normalization(self.exponent);
        let specular =
            mean(self.specular) * normalization * estimated_integral(self.exponent, wo.z);
        let mut shares = [T::new(0.0); MAX_LOBES];
        shares[DIFFUSE_LOBE] = mean(self.diffuse);
        shares[SPECULAR_LOBE] = specular;
        normalized(shares)
    }

    #[inline(always)]
    fn sample(&self, lobe: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        if lobe == DIFFUSE_LOBE {
            warp::cosine_hemisphere(u[0], u[1])
        } else {
            sample_about(wo.mirrored(), self.exponent, u)
        }
    }
}
