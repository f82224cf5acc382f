//! # `microfacet`: rough reflection, f = D G F / (4 (n.l)(n.v))
//!
//! The surface consists of facets, each a mirror, too small to be seen and large compared with the
//! wavelength. The facets that reflect wi to wo have the half vector h as normal: D is their density, G the
//! part of them that both directions see, and F their reflectance (Torrance and Sparrow 1967, Cook and
//! Torrance 1982, Walter et al. 2007, eq. 20; the lecture's specular term). Use it for metals, coated or
//! not, and for the gloss of other materials; do not use it for surfaces with visible scratches or flakes.
//!
//! **D** is normalised: the integral of D(h) (n.h) over the hemisphere is 1.
//! - `ggx`, Trowbridge and Reitz 1975: the normals of an ellipsoid; a sharp highlight with long tails.
//! - `beckmann`, Beckmann and Spizzichino 1963: normally distributed slopes; no tails.
//! - `blinn_phong`, Blinn 1977: a power of the cosine, nearly `beckmann`.
//! - `abc`, Church and Takacs; Löw et al. 2012: a tail of any power, `abc_exponent`. The lecture prints it
//!   without its normalisation, which is added here.
//! - `sgd`, shifted gamma, Bagher et al. 2012: a tail of power `sgd_p` that an exponential ends.
//!
//! **alpha** sets the height at the normal: D(n) = 1 / (pi alpha^2) for all distributions, so that they can
//! be exchanged. The alpha of a roughness slider is usually its square (Burley 2012). A Phong exponent e of
//! normals has alpha = sqrt(2 / (e + 2)) (Walter et al. 2007, section 5.2). `ggx` and `beckmann` can be
//! anisotropic: with a = sqrt(1 - 0.9 anisotropy) (Burley 2012) the roughness is alpha / a along the
//! rougher axis, which is `rotation_turns` from +X, and alpha a across it. alpha = 0 is a perfect mirror; a
//! description with an alpha between 0 and 1e-4 is refused, because single precision has too few digits for
//! it. The other three distributions have tables for one alpha, so that theirs cannot vary.
//!
//! **G**
//! - `smith`: exact for the distribution if neighbouring facets are independent of each other, with
//!   correlated heights (Smith 1967; Heitz 2014, eq. 99).
//! - `schlick`: G1 = n.v / (n.v (1 - k) + k), k = m sqrt(2 / pi), where m is alpha, for anisotropic
//!   surfaces the roughness along the direction (Schlick 1994; the lecture). It approximates `smith` of
//!   `beckmann` and is darker.
//! - `kelemen`: (n.l)(n.v) / (v.h)^2 (Kelemen and Szirmay-Kalos 2001).
//! - `cook_torrance`: all facets form V-shaped grooves (Torrance and Sparrow 1967).
//! - `implicit`: (n.l)(n.v), which darkens even a mirror.
//!
//! **F**
//! - `schlick`: f0 + (f90 - f0) (1 - v.h)^5 (Schlick 1994).
//! - `dielectric`: exact, with `eta` per channel.
//! - `conductor`: exact, with `eta` and `k` per channel; or a `metal` by its measured spectrum, integrated
//!   as for a film.
//! - `film`: the reflectance of a film at v.h and `thickness_nm`, with the rules of the model `film`. It is
//!   clipped to \[0, 1\] for unclipped films too, and averaged over `thickness_spread_nm`. A film without a table (its plan says so) takes some
//!   hundred us a call.
//!
//! **Energy**: with `cook_torrance`, whose grooves are a possible surface, and with `smith` the albedo is
//! at most that of F for every D (Heitz 2014); `kelemen` and `implicit` are below it everywhere. `schlick`
//! depends on alpha alone: with `abc`, whose tail has steeper facets than alpha suggests, the albedo may
//! exceed 100. All combinations are reciprocal. Light that facets reflect onto other facets is lost: with F
//! = 1 and seen along the normal half to two thirds of it for alpha = 1, a tenth and less for alpha = 0.3.
//! `energy_compensation` adds it back, with an error of 4e-3 of the albedo of a white surface (6e-4 for
//! `ggx` with `smith`): see `compensation.rs`.
//!
//! **Sampling**: by visible normals for `ggx` and `beckmann`, so that the weight is F G / G1, at most 1
//! with `smith`; by D (n.h) for the others, whose weights grow towards the horizon.
//!
//! Films are evaluated in single precision, in double-precision BSDFs too.

pub(crate) mod abc;
pub(crate) mod beckmann;
pub(crate) mod blinn_phong;
mod compensation;
mod cubics;
mod distribution;
pub(crate) mod energy;
mod fresnel;
pub(crate) mod ggx;
pub(crate) mod half_vector;
pub(crate) mod masking;
mod mirror;
pub(crate) mod ndf;
mod params;
mod projected;
mod quantile;
mod rough;
mod roughness;
pub(crate) mod sgd;
mod slopes;
mod tabulated;

use self::compensation::{Average, Compensation};
use self::distribution::Distribution;
use self::fresnel::{CompiledFresnel, ThreeIndices};
use self::masking::Masking;
use self::mirror::Mirror;
use self::params::{
    ABC, ABC_EXPONENT, ALPHA, ANISOTROPY, BECKMANN, BLINN_PHONG, CONDUCTOR, CUSTOM, DIELECTRIC,
    DISTRIBUTION, ENERGY_COMPENSATION, ETA, F0, F90, FILM, FRESNEL, GGX, IMPLICIT, K, MASKING,
    METAL, OFF, ROTATION, SCHLICK, SCHLICK_MASKING, SGD, SGD_P, THICKNESS_NM, THICKNESS_SPREAD_NM,
};
use self::rough::Rough;
use self::roughness::Roughness;
use self::tabulated::Tabulated;
use crate::bsdf::compiled::kernel;
use crate::bsdf::info::{
    Choice, Exception, Flags, LobeInfo, ModelInfo, ParamInfo, ParamKind, chosen,
};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::values::{Bounds, Values};
use crate::error::Error;
use crate::film::MAX_THICKNESS_NM;
use crate::optics::ConductorPolynomial;
use std::sync::Arc;

/// The model; see the module's documentation.
pub struct Microfacet;

/// The choices of `metal`. All but the first are names of media.
const METALS: &[&str] = &[
    "custom", "Ag", "Al", "Au", "Cr", "Cu", "Fe", "Ni", "Pt", "Ti",
];

const WITH_SCHLICK: &[&[Choice]] = &[&[chosen(FRESNEL, SCHLICK)]];
const WITH_CONDUCTOR: &[&[Choice]] = &[&[chosen(FRESNEL, CONDUCTOR)]];
const WITH_K: &[&[Choice]] = &[&[chosen(FRESNEL, CONDUCTOR), chosen(METAL, CUSTOM)]];
const WITH_ETA: &[&[Choice]] = &[
    &[chosen(FRESNEL, DIELECTRIC)],
    &[chosen(FRESNEL, CONDUCTOR), chosen(METAL, CUSTOM)],
];
/// The distributions that can be anisotropic.
const WITH_STRETCH: &[&[Choice]] = &[
    &[chosen(DISTRIBUTION, GGX)],
    &[chosen(DISTRIBUTION, BECKMANN)],
];

/// The least alpha of a rough surface.
const LEAST_ALPHA: f32 = energy::LEAST_ALPHA as f32;

/// A mirror has the first lobe; a rough surface has the second and, with energy compensation, the third.
const LOBES: &[LobeInfo] = &[
    LobeInfo {
        name: "mirror",
        flags: Flags::REFLECTION.with(Flags::DELTA),
    },
    LobeInfo {
        name: "reflection",
        flags: Flags::REFLECTION.with(Flags::GLOSSY),
    },
    LobeInfo {
        name: "multiple reflection",
        flags: Flags::REFLECTION.with(Flags::DIFFUSE),
    },
];

impl Model for Microfacet {
    const INFO: ModelInfo = ModelInfo {
        name: "microfacet",
        summary: "Reflection by many small facets: distribution of normals, masking and Fresnel factor of choice.",
        source: "Torrance and Sparrow 1967; Cook and Torrance 1982; Walter et al. 2007, eq. 20; Heitz 2014",
        params: &[
            ParamInfo::choice(
                "distribution",
                "Distribution of the facets' normals, D.",
                &["ggx", "beckmann", "blinn_phong", "abc", "sgd"],
            ),
            ParamInfo::choice(
                "masking",
                "Masking and shadowing, G; smith is exact for the distribution.",
                &[
                    "smith",
                    "schlick",
                    "kelemen",
                    "cook_torrance",
                    "implicit",
                ],
            ),
            ParamInfo::choice(
                "fresnel",
                "Fresnel factor, F: schlick takes f0 and f90; dielectric eta; conductor a metal, or eta and k; film a film and thickness_nm.",
                &["schlick", "dielectric", "conductor", "film"],
            ),
            ParamInfo::number("alpha", "Roughness: 0 is a perfect mirror, else at least 1e-4; the square of a roughness slider, sqrt(2 / (e + 2)) for a Phong exponent e. Varies for ggx and beckmann.", [0.0, 1.0], 0.3),
            ParamInfo::number("anisotropy", "Stretch of the highlight, ggx and beckmann only: alpha over and times sqrt(1 - 0.9 anisotropy) along and across.", [0.0, 1.0], 0.0),
            ParamInfo::number("rotation_turns", "Angle from +X to the rougher axis about +Z.", [0.0, 1.0], 0.0).in_unit("turns").used_with(WITH_STRETCH),
            ParamInfo::rgb("f0", "Reflectance at normal incidence, RGB (fresnel schlick).", [0.0, 1.0], 0.04).used_with(WITH_SCHLICK),
            ParamInfo::rgb("f90", "Reflectance at grazing incidence, RGB (fresnel schlick).", [0.0, 1.0], 1.0).fixed().used_with(WITH_SCHLICK),
            ParamInfo::rgb("eta", "Refractive index, RGB (fresnel dielectric, at least 1, and conductor).", [0.01, 10.0], 1.5).index().fixed().used_with(WITH_ETA),
            ParamInfo::rgb("k", "Extinction coefficient, RGB (fresnel conductor).", [0.0, 20.0], 0.0).index().fixed().used_with(WITH_K),
            ParamInfo::choice(
                "metal",
                "Fresnel conductor: custom takes eta and k, a metal its measured spectrum.",
                METALS,
            )
            .used_with(WITH_CONDUCTOR),
            ParamInfo::number("thickness_nm", "Thickness of the film's layer that varies, within its range: needed if one varies, refused if none does (fresnel film).", [0.0, MAX_THICKNESS_NM as f32], 0.0).in_unit("nm"),
            ParamInfo::number("abc_exponent", "Steepness of the tail, the lecture's second parameter (distribution abc).", [0.5, 10.0], 1.2).fixed().used_with(&[&[chosen(DISTRIBUTION, ABC)]]),
            ParamInfo::number("sgd_p", "Power of the tail; 0 is beckmann (distribution sgd).", [0.0, 4.0], 0.44).fixed().used_with(&[&[chosen(DISTRIBUTION, SGD)]]),
            ParamInfo::choice(
                "energy_compensation",
                "on: light that masking takes away comes back as if reflected by further facets; not for stretched surfaces.",
                &["off", "on"],
            ),
            ParamInfo::number("thickness_spread_nm", "Standard deviation of that thickness within a pixel or a real layer: colours are averaged over a normal distribution cut to the layer's range. At most the thickness_spread_max_nm of the film, refused if no layer varies (fresnel film).", [0.0, MAX_THICKNESS_NM as f32], 0.0).in_unit("nm"),
        ],
        lobes: LOBES,
        film_thickness: Some(THICKNESS_NM),
        film_thickness_spread: Some(THICKNESS_SPREAD_NM),
        film_choice: Some(chosen(FRESNEL, FILM)),
        not_conserving: Some(Exception {
            cases: &[&[
                chosen(DISTRIBUTION, ABC),
                chosen(MASKING, SCHLICK_MASKING),
            ]],
            reason: "distribution = abc with masking = schlick: the printed k follows from alpha alone, and the tail's facets are steeper",
        }),
        ..ModelInfo::PLAIN
    };

    fn lobes(values: &Values<f32>) -> &'static [LobeInfo] {
        match (is_mirror(values), values.choice(ENERGY_COMPENSATION)) {
            (true, _) => &LOBES[..1],
            (false, OFF) => &LOBES[1..2],
            (false, _) => &LOBES[1..],
        }
    }

    fn check(bounds: &Bounds) -> Result<(), Error> {
        check(bounds)
    }

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        let fresnel = fresnel(values)?;
        let masking = Masking::ALL[values.choice(MASKING)];
        let indices = ThreeIndices {
            eta: values.rgb(ETA),
            k: values.rgb(K),
        };
        if is_mirror(values) {
            return Ok(Box::new(Mirror {
                fresnel,
                masking,
                indices,
            }));
        }
        let roughness = Roughness::new(
            values.number(ALPHA),
            values.number(ANISOTROPY),
            values.number(ROTATION),
            values.number(ANISOTROPY) == T::new(0.0) && !values.varies(ANISOTROPY),
        );
        let compensation = if values.choice(ENERGY_COMPENSATION) == OFF {
            None
        } else {
            let varies = values.varies(THICKNESS_NM) || values.varies(THICKNESS_SPREAD_NM);
            let average = Average::new(&fresnel, varies)?;
            let alpha = (!values.varies(ALPHA)).then(|| double(values, ALPHA));
            let energy = distribution(values).energy(masking, alpha).rounded();
            Some(Compensation { energy, average })
        };
        Ok(kernel(Rough {
            distribution: distribution(values),
            roughness,
            fresnel,
            masking,
            compensation,
            indices,
        }))
    }
}

fn is_mirror<T: Precision>(values: &Values<T>) -> bool {
    values.number(ALPHA) == T::new(0.0)
}

/// A parameter in double precision, in which tables are made.
fn double<T: Precision>(values: &Values<T>, param: usize) -> f64 {
    values.number(param).into()
}

fn distribution<T: Precision, N: Precision>(values: &Values<T>) -> Distribution<N> {
    let of = |param| double(values, param);
    match values.choice(DISTRIBUTION) {
        GGX => Distribution::Ggx,
        BECKMANN => Distribution::Beckmann,
        BLINN_PHONG => Distribution::Tabulated(Box::new(Tabulated::blinn_phong(of(ALPHA)))),
        ABC => Distribution::Tabulated(Box::new(Tabulated::abc(of(ALPHA), of(ABC_EXPONENT)))),
        _ => Distribution::Tabulated(Box::new(Tabulated::shifted_gamma(of(ALPHA), of(SGD_P)))),
    }
}

fn fresnel<T: Precision>(values: &Values<T>) -> Result<CompiledFresnel<T>, Error> {
    let rgb = |param| T::rgb(values.rgb(param));
    Ok(match values.choice(FRESNEL) {
        SCHLICK => {
            let greatest_f0 = if values.varies(F0) {
                [T::new(1.0); 3]
            } else {
                values.rgb(F0)
            };
            let mut f90_and_f0 = values.rgb(F90).into_iter().zip(greatest_f0);
            CompiledFresnel::Schlick {
                f0: rgb(F0),
                f90: rgb(F90),
                falls: f90_and_f0.any(|(f90, f0)| f90 < f0),
            }
        }
        DIELECTRIC => {
            let [r, g, b] = values.rgb(ETA);
            CompiledFresnel::Dielectric {
                eta: rgb(ETA),
                is_gray: r == g && r == b,
            }
        }
        CONDUCTOR if values.choice(METAL) == CUSTOM => {
            let (eta, k) = (values.rgb(ETA), values.rgb(K));
            match ConductorPolynomial::new(eta, k) {
                Some(polynomial) => CompiledFresnel::Polynomial(polynomial),
                None => CompiledFresnel::Conductor {
                    eta: T::rgb(eta),
                    k: T::rgb(k),
                },
            }
        }
        CONDUCTOR => {
            let name = METALS[values.choice(METAL)];
            CompiledFresnel::of_metal(name)?
        }
        _ => CompiledFresnel::Film {
            film: Arc::clone(values.film().expect("validation refuses a lack of it")),
            thickness_nm: values.number(THICKNESS_NM),
            spread_nm: (values.varies(THICKNESS_SPREAD_NM)
                || values.number(THICKNESS_SPREAD_NM) > T::new(0.0))
            .then(|| values.number(THICKNESS_SPREAD_NM)),
        },
    })
}

/// Refuses values that are allowed alone but not together.
fn check(bounds: &Bounds) -> Result<(), Error> {
    let (least, greatest) = (&bounds.least, &bounds.greatest);
    let (smoothest, roughest) = (least.number(ALPHA), greatest.number(ALPHA));
    if smoothest < LEAST_ALPHA && (smoothest > 0.0 || roughest > 0.0) {
        return Err(Error::out_of_range(format!(
            "alpha = {smoothest} is below {LEAST_ALPHA}; allowed is exactly 0, a perfect mirror, which \
             cannot vary, or [{LEAST_ALPHA}, 1]"
        )));
    }
    if least.varies(ALPHA) && roughest == 0.0 {
        return Err(Error::out_of_range(format!(
            "varying alpha has the range [0, 0]; allowed is [{LEAST_ALPHA}, 1]"
        )));
    }
    let distribution = least.choice(DISTRIBUTION);
    if distribution != GGX && distribution != BECKMANN {
        let ParamKind::Choice { choices } = Microfacet::INFO.params[DISTRIBUTION].kind else {
            unreachable!("distribution is a choice")
        };
        let name = choices[distribution];
        if least.varies(ALPHA) {
            return Err(Error::unsupported(format!(
                "alpha cannot vary with distribution {name}, whose masking is a table made at creation; \
                 it can with ggx and beckmann"
            )));
        }
        if greatest.number(ANISOTROPY) > 0.0 {
            return Err(Error::unsupported(format!(
                "anisotropy = {} with distribution {name}; only ggx and beckmann can be stretched",
                greatest.number(ANISOTROPY)
            )));
        }
    }
    if least.choice(ENERGY_COMPENSATION) != OFF {
        if greatest.number(ANISOTROPY) > 0.0 {
            return Err(Error::unsupported(format!(
                "anisotropy = {} with energy_compensation on, which takes surfaces that look the same \
                 from all around",
                greatest.number(ANISOTROPY)
            )));
        }
        if least.choice(MASKING) == IMPLICIT {
            return Err(Error::unsupported(
                "energy_compensation on with masking implicit, which darkens even a mirror; it takes \
                 smith, schlick, kelemen and cook_torrance",
            ));
        }
    }
    if least.choice(FRESNEL) == DIELECTRIC {
        let dense = least.rgb(ETA).into_iter().enumerate();
        if let Some((channel, eta)) = dense.into_iter().find(|(_, eta)| *eta < 1.0) {
            return Err(Error::out_of_range(format!(
                "eta[{channel}] = {eta} is outside [1, 10], which fresnel dielectric allows; light comes \
                 from vacuum"
            )));
        }
    }
    Ok(())
}
