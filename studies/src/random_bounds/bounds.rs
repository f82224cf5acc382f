//! The greatest results, as far as the models state any.

use crate::shared::draw::Drawn;
use glam::Vec3;

/// The greatest albedo where energy is conserved: 1, and the error of the quadrature (tests of albedo).
pub const ALBEDO: f32 = 1.015;

/// Rounding of quotients, relative.
const ROUNDING: f32 = 1e-4;

/// The greatest weight of a sample, value / pdf, by the model's documentation: the greatest finite number for a model
/// that gives no bound. None for a model that is not listed here.
pub fn greatest_weight(drawn: &Drawn, wo: Vec3, wi: Vec3, eta: f32) -> Option<f32> {
    let greatest = match drawn.entry.name() {
        // The reflectance.
        "lambert" => 1.0,
        // F_D90 of both directions, at most 0.5 + 2 each: Burley 2012, section 5.3.
        "disney_diffuse" => 2.5 * 2.5,
        // pi f of the terms of Oren and Nayar 1994, eq. 30 and 31 (27 has no more): C1 <= 1,
        // C2 tan(beta) with C2 <= 0.45, C3 tan((alpha + beta) / 2) with C3 <= 0.125, where the tangent of
        // the mean angle is at most 2 / cos(beta); between facets twice 0.17.
        "oren_nayar" => 1.34 + 0.7 / wo.z.max(wi.z),
        // Each lobe is chosen in proportion to the mean of its channels, and all may be in one of them.
        // Transmitted light counts as radiance.
        "film" => 3.0 * (1.0 / (eta * eta)).max(1.0),
        // F G / G1 for visible normals.
        "microfacet" if is_by_visible_normals(drawn) => 1.0,
        "phong" | "layered" | "microfacet" | "metallic_roughness" => return Some(f32::MAX),
        _ => return None,
    };
    Some(greatest * (1.0 + ROUNDING))
}

fn is_by_visible_normals(drawn: &Drawn) -> bool {
    let distribution = drawn.choice("distribution");
    ["ggx", "beckmann"].contains(&distribution)
        && drawn.choice("masking") == "smith"
        && drawn.choice("energy_compensation") == "off"
}
