//! The greatest errors of single precision, by model.

use super::row::Quantity;
use super::tally::FLOOR;

/// How far results at different levels of instructions, and of single calls, may differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Between {
    /// Every element has the same bits.
    SameBits,
    /// At most this, in the measure of each quantity.
    Within(f64),
}

/// The greatest errors, in the measure of each quantity.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    pub value: f64,
    pub pdf: f64,
    pub weight: f64,
    pub direction: f64,
    pub horizon: f64,
    pub reflectance: f64,
    /// The part of all elements that may be beyond the bound, because a density is infinite close by.
    pub poles: f64,
    /// The part of the samples whose lobe, or existence, rounding may decide.
    pub switched: f64,
    pub between: Between,
}

impl Bounds {
    const NONE: Self = Self {
        value: 0.0,
        pdf: 0.0,
        weight: 0.0,
        direction: 0.0,
        horizon: 0.0,
        reflectance: 0.0,
        poles: 0.0,
        switched: 0.0,
        between: Between::SameBits,
    };

    pub fn of(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Value => self.value,
            Quantity::Pdf => self.pdf,
            Quantity::Weight => self.weight,
            Quantity::Direction => self.direction,
            Quantity::Horizon => self.horizon,
            Quantity::Reflectance => self.reflectance,
        }
    }
}

/// The bounds of a variant of a model, by its name in the table; none of a model that has none.
pub fn find(variant: &str) -> Option<Bounds> {
    // A dozen operations of 6e-8 each, with room for grazing angles and for Schlick's factor where f90 is 0:
    // then f0 - f0 (1 - cos)^5 cancels.
    let plain = Bounds {
        value: 1e-4,
        pdf: 1e-4,
        weight: 5e-4,
        direction: 1e-5,
        horizon: 5e-4,
        switched: 1e-4,
        ..Bounds::NONE
    };
    if variant.ends_with("energy_compensation on") {
        // The compensation is in proportion to 1 - E of both directions. Where masking takes next to nothing away,
        // that difference has no digits left, and 2e-5 of the value remain of a compensation that is 0. On a
        // surface that is black from there (f0 is 0) such remainders choose the lobe: the density may be off by 1.
        return Some(Bounds {
            value: 0.1,
            pdf: 1.0 / FLOOR,
            weight: 0.1,
            direction: 1e-3,
            horizon: 0.1,
            switched: 1e-3,
            ..plain
        });
    }
    Some(match variant.split(' ').next().unwrap_or_default() {
        // The phase of 100 um is up to 2000 turns, each known to 1e-7 of all; lobes of exponents to 1e5 and
        // refraction close to the critical angle magnify a direction's error a thousand times. At that angle
        // the refracted lobe's density is infinite, 1 / cos, and then 0.
        "layered" => Bounds {
            poles: 1e-5,
            value: 5e-3,
            pdf: 2e-2,
            weight: 1e-2,
            direction: 1e-3,
            horizon: 5e-3,
            ..plain
        },
        // GGX samples visible normals on a disc, at whose rim 1 - t1^2 - t2^2 cancels; Beckmann uses the inverse of
        // erf, whose argument 2 u - 1 has no digits left where u is close to 0.
        "microfacet" => Bounds {
            direction: 1e-3,
            ..plain
        },
        // Where f0 is 1 the diffuse part is the rounding of 1 - E. Its lobe's share is no better: E is a sum of nine
        // products, 5e-7 off, and so is 1 / pi of it in the density.
        "metallic_roughness" => Bounds {
            value: 1e-2,
            pdf: 3e-4,
            weight: 1e-2,
            direction: 1e-3,
            ..plain
        },
        "lambert" | "oren_nayar" | "disney_diffuse" | "phong" | "film" => plain,
        _ => return None,
    })
}

/// The same; panics if the model has no bounds.
pub fn of_variant(variant: &str) -> Bounds {
    find(variant).unwrap_or_else(|| panic!("{variant} has no bounds in f32_vs_f64/bounds.rs"))
}

/// The bounds of a film's method. Where the truth is the reference, the method's own error counts too, up to its
/// tolerance; elsewhere `tolerance` is 0.
pub fn of_method(method: &str, tolerance: f64) -> Bounds {
    let own = match method {
        "schlick" => 1e-6,
        // The sine of the refracted angle has an infinite slope at the critical angle.
        "fresnel" => 2e-3,
        // As in the layered model: phases of 100 um; resonances at grazing angles magnify their error.
        "two_beam" | "airy_rgb" | "quadrature" => 2e-3,
        // Thick films have no harmonics, and bands average over the phase.
        _ => 1e-4,
    };
    Bounds {
        reflectance: if tolerance > 0.0 { tolerance } else { own },
        ..Bounds::NONE
    }
}
