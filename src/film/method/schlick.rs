//! Schlick's approximation, for a base without coating.

use super::compiled_method::CompiledMethod;
use super::info::{Compile, MethodInfo};
use crate::film::description::FilmDescription;
use crate::num::Rgb;
use crate::optics::{Medium, schlick};

/// Schlick's approximation, which takes three numbers.
pub(super) const INFO: MethodInfo = MethodInfo {
    name: "schlick",
    sizes: &[1],
    cost_ns: |_| 6.0,
    is_automatic: true,
    takes: |description| !description.transmittance && is_bare(description),
    takes_words: "a base without coating, and no transmittance",
    allowed_error: |tolerance| tolerance,
    reason: "nothing is coated, and no cheaper method exists",
    compile: Compile::BareBase(|_, normal| (Box::new(SchlickBase(normal)), "three numbers".into())),
};

/// Schlick 1994, eq. 15, from the colour at normal incidence.
struct SchlickBase(Rgb<f32>);

impl CompiledMethod<f32> for SchlickBase {
    fn reflectance(&self, cos_theta: f32, _: f32) -> Rgb<f32> {
        self.0.map(|f0| schlick(f0, cos_theta))
    }
}

/// Whether every layer with a thickness equals the half-space beside it.
pub(super) fn is_bare(description: &FilmDescription) -> bool {
    let same = |a: &Medium, b: &Medium| a.constant().is_some() && a.constant() == b.constant();
    let layers = description.layers.iter();
    let mut layers = layers
        .filter(|layer| layer.thickness_nm[1] > 0.0)
        .peekable();
    while layers
        .peek()
        .is_some_and(|layer| same(&layer.medium, &description.ambient))
    {
        layers.next();
    }
    layers.all(|layer| same(&layer.medium, &description.base))
}
