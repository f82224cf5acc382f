//! All beams at three wavelengths.

use super::compiled_method::CompiledMethod;
use super::info::{MethodInfo, OneLayerCompile};
use super::media::{MediaAtWavelength, pack_media};
use super::one_layer::{OneLayer, clamped};
use crate::error::Error;
use crate::num::{Lane, Rgb};
use crate::optics::RGB_WAVELENGTHS_NM;

pub(super) const INFO: MethodInfo = MethodInfo {
    cost_ns: |_| 49.0,
    ..MethodInfo::one_layer(
        "airy_rgb",
        OneLayerCompile {
            single: compile,
            double: compile,
            work: |_| "all reflected beams at 3 wavelengths".into(),
        },
    )
};

/// The exact reflectance (Airy 1833) at 645, 525 and 445 nm, taken for red, green and blue, as in
/// Adobe's openpbr-bsdf.
///
/// Cost: one evaluation with the three wavelengths in lanes.
///
/// Exact for thickness 0 and for bare bases without dispersion. Fails when the fringes are finer
/// than a channel is wide: beyond about 500 nm of optical path the colours stay saturated and alias.
/// Without the overlap of an observer's matching functions, thin films are somewhat too saturated.
struct AiryRgb<T: Lane> {
    media: MediaAtWavelength<T::Rgb>,
}

/// The film's white and colour space are not used; the method has one size.
fn compile<T: Lane>(layer: &OneLayer, _: usize) -> Result<Box<dyn CompiledMethod<T>>, Error> {
    let media = RGB_WAVELENGTHS_NM.map(|nm| MediaAtWavelength::at(layer, nm));
    Ok(Box::new(AiryRgb::<T> {
        media: pack_media::<T>(media),
    }))
}

impl<T: Lane> CompiledMethod<T> for AiryRgb<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let [cos_theta, thickness_nm] = clamped(cos_theta, thickness_nm);
        let waves = self.media.waves(cos_theta);
        T::channels(self.media.reflectance(&waves, thickness_nm))
    }
}
