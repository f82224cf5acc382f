//! # `oren_nayar`: a rough diffuse surface of V-shaped grooves
//!
//! Oren and Nayar 1994 ("Generalization of Lambert's Reflectance Model"): Lambertian facets in grooves
//! whose slope angles are normally distributed with the standard deviation sigma, `sigma_radians`. The
//! surface is brighter than Lambert's when seen from the direction of the light, and looks flatter. sigma =
//! 0 is `lambert`. Use it for clay, cloth, concrete and the moon. Its roughness is not that of the
//! highlight: the grooves that broaden a highlight are smaller than the distance that light travels below
//! the surface, so that diffuse light does not depend on them.
//!
//! There are two forms: the paper's functional approximation of its integrals for Gaussian slopes (section
//! 4), and its qualitative model. With s = sigma^2, the greater polar angle a, the lesser polar angle b,
//! and the difference phi of the azimuths, pi f / rho is
//!
//! ```text
//! full:         C1 + cos phi C2 tan b + (1 - |cos phi|) C3 tan((a + b) / 2)
//!               + 0.17 rho s / (s + 0.13) (1 - cos phi (2 b / pi)^2)
//! qualitative:  C1 + 0.45 s / (s + 0.09) max(0, cos phi) sin a tan b
//!
//! C1 = 1 - 0.5 s / (s + 0.33)
//! C2 = 0.45 s / (s + 0.09) (sin a - ((2 b / pi)^3 where cos phi < 0))
//! C3 = 0.125 s / (s + 0.09) (4 a b / pi^2)^2
//! ```
//!
//! The term with 0.17 is light that facets reflect onto each other. The qualitative form leaves it out and
//! costs a third.
//!
//! **The difference**: without the light between facets the qualitative form is darker, most along the
//! normal. Its albedo is lower by -0.007 to 0.021 (reflectance 0.5, sigma 0.35), 0.017 to 0.067 (0.9, 0.35)
//! and 0.047 to 0.131 (0.9, pi / 2), depending on the viewer. In pi f |wi.z| / rho the forms differ by up
//! to 0.14, 0.14 and 0.23.
//!
//! **Limits**: both forms are fits. With a reflectance of 1 the albedo exceeds 1 at grazing angles: that of
//! the full form by up to 5.1 %, for sigma below 0.63, that of the qualitative form by up to 1.6 %, for
//! sigma below 0.33. With a reflectance of 0.95 neither does. From sigma = 0.67 on the full form is
//! negative where light and viewer graze the surface from opposite sides; it is clamped to 0 there.

use crate::bsdf::compiled::{Compiled, kernel};
use crate::bsdf::info::{Exception, LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::surface::Surface;
use crate::bsdf::values::Values;
use crate::num::{Lane, PI, Real, Rgb, Vec3, angle_turns, each};

/// The model; see the module's documentation.
pub struct OrenNayar;

const REFLECTANCE: usize = 0;
const SIGMA_RADIANS: usize = 1;
const FORM: usize = 2;

const QUALITATIVE: usize = 1;

impl Model for OrenNayar {
    const INFO: ModelInfo = ModelInfo {
        name: "oren_nayar",
        summary: "Diffuse reflection by a rough surface, flatter than Lambert's and brighter towards the light.",
        source: "Oren and Nayar 1994, Generalization of Lambert's Reflectance Model, section 4",
        params: &[
            ParamInfo::rgb(
                "reflectance",
                "Fraction of light reflected by a facet, RGB.",
                [0.0, 1.0],
                0.5,
            ),
            ParamInfo::number(
                "sigma_radians",
                "Standard deviation of the facets' slope angle; 0 is lambert.",
                [0.0, std::f32::consts::FRAC_PI_2],
                0.35,
            )
            .in_unit("radians"),
            ParamInfo::choice(
                "form",
                "The full fit with light between facets, or the paper's short one without.",
                &["full", "qualitative"],
            ),
        ],
        lobes: &[LobeInfo::DIFFUSE],
        not_conserving: Some(Exception {
            cases: &[&[]],
            reason: "a reflectance near 1 with sigma below 0.63 (full) or 0.33 (qualitative): up to 5.1 % or 1.6 % too much at grazing angles",
        }),
        ..ModelInfo::PLAIN
    };

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        Ok(kernel(OrenNayarSurface {
            reflectance: values.rgb(REFLECTANCE),
            grooves: Grooves::new(values.number(SIGMA_RADIANS)),
            is_qualitative: values.choice(FORM) == QUALITATIVE,
        }))
    }
}

/// The values of the parameters, for one surface or for one in each lane.
#[derive(Clone, Copy)]
pub struct OrenNayarSurface<T> {
    reflectance: Rgb<T>,
    grooves: Grooves<T>,
    is_qualitative: bool,
}

/// The coefficients that depend on sigma alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grooves<T> {
    /// C1
    constant: T,
    /// s / (s + 0.09)
    directional: T,
    /// 0.17 s / (s + 0.13)
    mutual: T,
}

/// The quotient, or 0 where the divisor is 0.
#[inline(always)]
fn quotient<T: Real>(dividend: T, divisor: T) -> T {
    let (zero, one) = (T::new(0.0), T::new(1.0));
    let is_null = divisor.le(zero);
    T::select(is_null, zero, dividend / T::select(is_null, one, divisor))
}

/// The sine of the angle to the normal.
#[inline(always)]
fn sine<T: Real>(w: Vec3<T>) -> T {
    (w.x.squared() + w.y.squared()).sqrt()
}

impl<T: Lane<Scalar = T>> Grooves<T> {
    /// The same coefficients in every lane.
    #[inline(always)]
    pub(super) fn splat<L: Lane<Scalar = T>>(&self) -> Grooves<L> {
        Grooves {
            constant: L::splat(self.constant),
            directional: L::splat(self.directional),
            mutual: L::splat(self.mutual),
        }
    }
}

impl<T: Lane> Grooves<T> {
    #[inline(always)]
    pub(super) fn new(sigma: T) -> Self {
        let s = sigma.squared();
        Self {
            constant: T::new(1.0) - T::new(0.5) * s / (s + T::new(0.33)),
            directional: s / (s + T::new(0.09)),
            mutual: T::new(0.17) * s / (s + T::new(0.13)),
        }
    }

    /// f |wi.z| of the full form.
    ///
    /// Tangents are written as sines over cosines, and multiplied by wi.z before they can overflow at
    /// grazing angles.
    #[inline(always)]
    pub(super) fn full(&self, reflectance: T::Rgb, wo: Vec3<T>, wi: Vec3<T>) -> T::Rgb {
        let (zero, one, four) = (T::new(0.0), T::new(1.0), T::new(4.0));
        let [sine_o, sine_i] = [sine(wo), sine(wi)];
        // 2 theta / pi, within [0, 1].
        let part_o = four * angle_turns(sine_o, wo.z);
        let part_i = four * angle_turns(sine_i, wi.z);
        let (greater, lesser) = (part_o.max(part_i), part_o.min(part_i));
        // `across` is cos phi sin a sin b; cos phi and cos phi sin b follow from it.
        let across = wo.x * wi.x + wo.y * wi.y;
        let cos_phi = quotient(across, sine_o * sine_i);
        let cos_phi_sine_b = quotient(across, sine_o.max(sine_i));
        let is_behind = across.lt(zero);
        let cube = T::select(is_behind, lesser.squared() * lesser, zero);
        let second = T::new(0.45) * (across - cube * cos_phi_sine_b) * wi.z / wo.z.max(wi.z);
        let tangent = (sine_o + sine_i) * (wi.z / (wo.z + wi.z));
        let sideways = (one - cos_phi.abs()).max(zero);
        let third = T::new(0.125) * sideways * (greater * lesser).squared() * tangent;
        let single = self.constant * wi.z + self.directional * (second + third);
        let mutual = self.mutual * (one - cos_phi * lesser.squared()) * wi.z;
        let sum = single.gray() + reflectance * mutual.gray();
        reflectance * sum.max(T::Rgb::new(0.0)) * T::Rgb::new(1.0 / PI)
    }

    /// The directional albedo of the full form for a viewer at the horizon, which is the greatest one where
    /// it exceeds 1. The cosine-weighted mean over the hemisphere of the terms with s / (s + 0.09) is the
    /// constant below; the mean of cos phi is 0.
    #[inline(always)]
    pub(super) fn albedo_at_horizon(&self, reflectance: T::Rgb) -> T::Rgb {
        let single = self.constant + T::new(0.177_196_4) * self.directional;
        reflectance * (single.gray() + reflectance * self.mutual.gray())
    }

    /// f |wi.z| of the qualitative form.
    #[inline(always)]
    fn qualitative(&self, reflectance: Rgb<T>, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        let across = (wo.x * wi.x + wo.y * wi.y).max(T::new(0.0));
        let second = T::new(0.45) * self.directional * across * wi.z / wo.z.max(wi.z);
        let factor = (self.constant * wi.z + second) * T::new(1.0 / PI);
        each!(reflectance, |rho| rho * factor)
    }
}

impl<T: Precision> Compiled<T> for OrenNayarSurface<T> {
    type Surface<'a, L: Lane<Scalar = T>> = OrenNayarSurface<L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> OrenNayarSurface<L> {
        OrenNayarSurface {
            reflectance: each!(self.reflectance, |channel| L::splat(channel)),
            grooves: self.grooves.splat(),
            is_qualitative: self.is_qualitative,
        }
    }
}

impl<L: Lane> Surface<L> for OrenNayarSurface<L> {
    const SAMPLES_ARE_UNIT: bool = true;

    #[inline(always)]
    fn vary(&mut self, param: usize, value: [L; 3]) {
        match param {
            REFLECTANCE => self.reflectance = value,
            _ => self.grooves = Grooves::new(value[0]),
        }
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<L>, wi: Vec3<L>) -> Rgb<L> {
        if self.is_qualitative {
            self.grooves.qualitative(self.reflectance, wo, wi)
        } else {
            L::channels(self.grooves.full(L::rgb(self.reflectance), wo, wi))
        }
    }
}
