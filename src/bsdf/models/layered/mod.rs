//! # `layered`: a thin layer on an object, with interference at three wavelengths
//!
//! The model of Granier and Heidrich 2002, "A Simple Layered RGB BRDF Model" (GH02): light reflected by the
//! upper boundary of a layer interferes with light that crossed the layer and was reflected once by its
//! lower boundary, whose normal may differ. The colour of a diffuse part depends on the thickness too.
//!
//! Subscripts: 0 is the ambient, 1 the layer, 2 the object. Each channel has one wavelength: 645, 525 and
//! 445 nm.
//!
//! **Variants.** `paper` has the formulas as printed, with the misprints below corrected. Its lobes are not
//! normalised, and it is not reciprocal, because its Fresnel factor depends on the light's cosine only and
//! the two crossings of the upper boundary take their cosines in different media. `energy`, the default,
//! has the same parameters, colours and lobe shapes, is reciprocal, and has an albedo of at most 1:
//!
//! ```text
//! f_R = min(F(wi), F(wo)) (e0 + 2) / (2 pi) max(0, <r_i, wo>)^e0
//! f_T = base (1 - F(wi)) (1 - F(wo)) (e1 + 2) / (2 pi (r1/r0)^2) max(0, <r_ii, -i_o>)^e1
//! f   = ks (f_R + f_T + 2 cos(2 Phi) sqrt(f_R f_T)) / 2  +  kd rho_d / (2 pi)
//! ```
//!
//! It conserves energy because 2 sqrt(ab) <= a + b, the modified Phong lobe integrates to at most 1
//! with the cosine (Lafortune and Willems 1994), refraction compresses solid angle
//! (cos_o dw_o = (r1/r0)^2 cos_io dw_io), and min(F_i, F_o) <= F_i.
//!
//! **Misprints and limits of the paper.**
//! 1. Eq. 10 prints F(i); with eq. 6 and 7 it must be F(-i), the cosine on the light's side.
//! 2. Eq. 1 prints <i, -n0> and eq. 3 <i + i_o, -n0>; eq. 2 needs i_i, the ray inside the layer. In the
//!    text i_o depends on n1; here the reflection at n1 is in r_ii, and i_o is refracted at n0 alone.
//! 3. The paper says that for parallel boundaries the three null conditions after eq. 10 are always true.
//!    The first two never are, and the third can be for r1 < sqrt(2).
//! 4. Eq. 11 is misprinted; it means R_d + T_d + 2 cos(2 Phi) sqrt(R_d T_d).
//! 5. Eq. 11 and 16 lack the division by 2 of eq. 5: rho_d reaches 2, and rho_d / 2 is an albedo.
//! 6. Eq. 14 at r1 = 1.5 gives 0.835, not .85; the formula is right.
//! 7. R and T are not normalised lobes, so that rho is not an energy-conserving BRDF.
//! 8. The lower boundary reflects everything: there is no Fresnel factor between 1 and 2. `base` is its
//!    reflectance in the specular part of both variants; 1 is that of the paper.
//! 9. There is no half-wave shift, which is right only if the indices rise inwards. `phase_shift` =
//!    `half_wave` shifts 2 Phi by pi for a base whose index is below the layer's (a soap film, which is
//!    black when thin).
//! 10. By wave optics a lossless layer on a perfect reflector has the reflectance 1 at every wavelength;
//!     the colours here come from stopping after one traversal. The model looks plausible but does not
//!     predict colours; for these use a film.

mod formulas;
mod params;
mod sampling;
mod terms;
#[cfg(test)]
mod tests;

use crate::bsdf::compiled::kernel;
use crate::bsdf::info::{Exception, Flags, LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::values::{Bounds, Values};
use crate::error::Error;
use formulas::LayeredSurface;
use params::{DIFFUSE_WEIGHT, PAPER, SPECULAR_WEIGHT, VARIANT, VARIANT_PAPER};

/// The model; see the module's documentation.
pub struct Layered;

const GLOSSY: Flags = Flags::REFLECTION.with(Flags::GLOSSY);

impl Model for Layered {
    const INFO: ModelInfo = ModelInfo {
        name: "layered",
        summary: "A thin layer on an object: reflection, one traversal, and their interference at three wavelengths.",
        source: "Granier and Heidrich 2002, A Simple Layered RGB BRDF Model",
        params: &[
            ParamInfo::rgb(
                "eta",
                "Refractive index of the layer at 645, 525 and 445 nm.",
                [1.0, 4.0],
                1.5,
            )
            .index()
            .fixed(),
            ParamInfo::number("ambient_eta", "Refractive index outside.", [1.0, 4.0], 1.0).fixed(),
            ParamInfo::number(
                "exponent_reflection",
                "Phong exponent of the upper boundary, e0; 0 reflects to the whole hemisphere.",
                [0.0, 1e5],
                50.0,
            )
            .fixed(),
            ParamInfo::number(
                "exponent_transmission",
                "Phong exponent of the lower boundary, e1, inside the layer.",
                [0.0, 1e5],
                50.0,
            )
            .fixed(),
            ParamInfo::number("thickness_nm", "Thickness of the layer.", [0.0, 1e5], 300.0)
                .in_unit("nm"),
            ParamInfo::direction(
                "base_normal",
                "Normal of the lower boundary in the shading frame; (0, 0, 1): parallel boundaries.",
                0.05,
            ),
            ParamInfo::rgb(
                "base",
                "Reflectance of the lower boundary, RGB.",
                [0.0, 1.0],
                1.0,
            ),
            ParamInfo::number(
                "specular_weight",
                "Weight of the specular part; in energy, specular_weight + diffuse_weight <= 1.",
                [0.0, 1.0],
                0.5,
            )
            .fixed(),
            ParamInfo::number(
                "diffuse_weight",
                "Weight of the diffuse part.",
                [0.0, 1.0],
                0.5,
            )
            .fixed(),
            ParamInfo::choice(
                "variant",
                "energy: reciprocal, albedo <= 1; paper: the printed formulas.",
                &["energy", "paper"],
            ),
            ParamInfo::choice(
                "phase_shift",
                "half_wave for a base whose index is below the layer's.",
                &["none", "half_wave"],
            ),
        ],
        lobes: &[
            LobeInfo {
                name: "mirror",
                flags: GLOSSY,
            },
            LobeInfo {
                name: "refracted red",
                flags: GLOSSY,
            },
            LobeInfo {
                name: "refracted green",
                flags: GLOSSY,
            },
            LobeInfo {
                name: "refracted blue",
                flags: GLOSSY,
            },
            LobeInfo::DIFFUSE,
        ],
        not_reciprocal: Some(Exception {
            cases: &[&[PAPER]],
            reason: "variant = paper: the Fresnel factor takes the light's cosine alone, and the two crossings of the upper boundary take cosines in different media",
        }),
        not_conserving: Some(Exception {
            cases: &[&[PAPER]],
            reason: "variant = paper: the lobes are not normalised, and the diffuse part reaches 2 / pi",
        }),
        ..ModelInfo::PLAIN
    };

    fn check(bounds: &Bounds) -> Result<(), Error> {
        let upper = &bounds.greatest;
        let specular = upper.number(SPECULAR_WEIGHT);
        let diffuse = upper.number(DIFFUSE_WEIGHT);
        let sum = specular + diffuse;
        if upper.choice(VARIANT) != VARIANT_PAPER && sum > 1.0 {
            return Err(Error::out_of_range(format!(
                "specular_weight + diffuse_weight = {specular} + {diffuse} = {sum} exceeds 1, \
                 which variant energy does not allow (variant paper does)"
            )));
        }
        Ok(())
    }

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        Ok(kernel(LayeredSurface::new(values)))
    }
}
