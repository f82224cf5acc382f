//! Fresnel's equations, for a dielectric base of one index without coating.

use super::compiled_method::CompiledMethod;
use super::info::{Compile, MethodInfo};
use super::schlick::is_bare;
use crate::film::description::FilmDescription;
use crate::num::Rgb;
use crate::optics::dielectric_reflectance;

/// The exact reflectance.
pub(super) const INFO: MethodInfo = MethodInfo {
    name: "fresnel",
    sizes: &[1],
    cost_ns: |_| 9.0,
    is_automatic: true,
    takes: |description| {
        !description.transmittance && is_bare(description) && has_two_indices(description)
    },
    takes_words: "a dielectric base of one index without coating, and no transmittance",
    allowed_error: |tolerance| tolerance,
    reason: "nothing is coated, and Fresnel's equations are exact",
    compile: Compile::BareBase(|description, _| {
        let [ambient, base] =
            [&description.ambient, &description.base].map(|medium| medium.index(550.0).re);
        let eta = (base / ambient) as f32;
        let size = format!("relative index {eta}");
        (Box::new(FresnelBase { eta }), size)
    }),
};

struct FresnelBase {
    /// Index of the base over that of the ambient.
    eta: f32,
}

impl CompiledMethod<f32> for FresnelBase {
    fn reflectance(&self, cos_theta: f32, _: f32) -> Rgb<f32> {
        [dielectric_reflectance(cos_theta, self.eta); 3]
    }
}

/// Whether both half-spaces are transparent and have one index each.
fn has_two_indices(description: &FilmDescription) -> bool {
    [&description.ambient, &description.base]
        .into_iter()
        .all(|medium| medium.constant().is_some_and(|index| index.im == 0.0))
}
