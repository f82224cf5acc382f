//! # `metallic_roughness`: the material of textures and interchange formats
//!
//! Base colour, metallic and roughness: the parametrisation of Burley 2012 ("Physically-Based Shading at
//! Disney"), of glTF 2.0 and of the lecture's 25 spheres. Every number may vary. Use it for assets authored
//! that way; `microfacet` has measured metals, films and other distributions.
//!
//! **Highlight**: D G F / (4 (n.l)(n.v)) with GGX (Walter et al. 2007, eq. 33), height-correlated Smith
//! masking (Heitz 2014, eq. 99) and Schlick's F. alpha = roughness^2, and at least 1e-4. F0 of a dielectric
//! is ((eta - 1) / (eta + 1))^2 (`dielectric_from` = eta) or given (f0), that of a metal is the base
//! colour, and `metallic` interpolates linearly between them. F90 is 1, also for an index of 1. Indices
//! below 1 are not offered: they occur for metals, whose F0 does not follow from that formula because they
//! absorb.
//!
//! **Diffuse part**: dielectrics only, so with the factor 1 - metallic, and with the base colour as
//! reflectance: f_d (1 - E(wo)) (1 - E(wi)) / (1 - E_avg), where E is the highlight's albedo for the
//! dielectric F0, E_avg its mean, and f_d one of
//!
//! - `lambert`;
//! - `oren_nayar`, the full form, sigma = `sigma_radians`;
//! - `disney`, roughness = diffuse_roughness.
//!
//! This product is that of Kelemen and Szirmay-Kalos 2001 ("A Microfacet Based Coupled Specular-Matte BRDF
//! Model with Importance Sampling", section 2.2): the diffuse part gets the light that the highlight does
//! not reflect, and is reciprocal. E comes from a table (`microfacet/energy.rs`) made at creation.
//!
//! **Energy**: the albedo exceeds 1 by no more than the error of the table, 1e-3. For base colour 1 and
//! `lambert` a dielectric reflects everything to within that error, and a metal all but the light that
//! masking takes away: at least 0.89, 0.83, 0.62 and 0.30 at roughness 0.25, 0.5, 0.75 and 1. The albedos
//! of `oren_nayar` and `disney` exceed 1 where the base colour is near 1. There these forms are divided by
//! an upper bound of their albedo: for base colour 1 by up to 1.06 and 1.6 for F0 below 0.5, and by up to
//! 3.4 as F0 tends to 1, where little light is left for them. Multiple scattering between facets is left
//! out, so that rough metals are darker than real ones.

mod params;
mod surface;

use crate::bsdf::compiled::kernel;
use crate::bsdf::info::{LobeInfo, ModelInfo, ParamInfo, chosen};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::values::Values;
use params::{DIELECTRIC_FROM, DIFFUSE_FORM, DISNEY, FROM_ETA, FROM_F0, OREN_NAYAR};
use surface::CompiledMaterial;

/// The model; see the module's documentation.
pub struct MetallicRoughness;

impl Model for MetallicRoughness {
    const INFO: ModelInfo = ModelInfo {
        name: "metallic_roughness",
        summary: "Base colour, metallic and roughness: a GGX highlight over a diffuse part that gets what it leaves.",
        source: "Burley 2012; Walter et al. 2007; Heitz 2014; Kelemen and Szirmay-Kalos 2001, section 2.2",
        params: &[
            ParamInfo::rgb(
                "base_color",
                "Reflectance of a dielectric's diffuse part, F0 of a metal, RGB.",
                [0.0, 1.0],
                0.5,
            ),
            ParamInfo::number("metallic", "0 a dielectric, 1 a metal.", [0.0, 1.0], 0.0),
            ParamInfo::number(
                "roughness",
                "Of the highlight: its square is alpha, at least 1e-4.",
                [0.0, 1.0],
                0.5,
            ),
            ParamInfo::choice(
                "dielectric_from",
                "Whether eta or f0 gives the dielectric's reflectance.",
                &["eta", "f0"],
            ),
            ParamInfo::number(
                "eta",
                "Refractive index of the dielectric (dielectric_from eta).",
                [1.0, 3.0],
                1.5,
            )
            .used_with(&[&[chosen(DIELECTRIC_FROM, FROM_ETA)]]),
            ParamInfo::number(
                "f0",
                "Reflectance of the dielectric at normal incidence (dielectric_from f0).",
                [0.0, 1.0],
                0.04,
            )
            .used_with(&[&[chosen(DIELECTRIC_FROM, FROM_F0)]]),
            ParamInfo::choice(
                "diffuse_form",
                "Form of the diffuse part.",
                &["lambert", "oren_nayar", "disney"],
            ),
            ParamInfo::number(
                "sigma_radians",
                "Standard deviation of the facets' slope angle (diffuse_form oren_nayar).",
                [0.0, 1.0],
                0.0,
            )
            .in_unit("radians")
            .used_with(&[&[chosen(DIFFUSE_FORM, OREN_NAYAR)]]),
            ParamInfo::number(
                "diffuse_roughness",
                "0 darkens grazing angles, 1 brightens them (diffuse_form disney).",
                [0.0, 1.0],
                0.0,
            )
            .used_with(&[&[chosen(DIFFUSE_FORM, DISNEY)]]),
        ],
        lobes: &[LobeInfo::DIFFUSE, LobeInfo::SPECULAR],
        ..ModelInfo::PLAIN
    };

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        Ok(kernel(CompiledMaterial::new(values)))
    }
}
