//! All beams at three wavelengths.

use super::layer::{Line, pack_lines};
use super::{Method, OneLayer, held};
use crate::num::{Lane, Rgb};
use crate::optics::RGB_WAVELENGTHS_NM;

/// The exact reflectance (Airy 1833) at 645, 525 and 445 nm, taken for red, green and blue, as in
/// Adobe's openpbr-bsdf.
///
/// Cost: one evaluation with the three wavelengths in lanes.
///
/// Exact for thickness 0 and for bare bases without dispersion. Fails when the fringes are finer
/// than a channel is wide: beyond about 500 nm of optical path the colours stay saturated for ever
/// and alias. Three wavelengths are also no observer: the primaries' overlap is missing, so that
/// thin films are somewhat too saturated.
#[derive(Clone, Copy, Debug)]
pub struct AiryRgb<T: Lane> {
    line: Line<T::Rgb>,
}

impl<T: Lane> AiryRgb<T> {
    /// For a film; its white and colour space are not used.
    pub fn new(layer: &OneLayer) -> Self {
        let lines = RGB_WAVELENGTHS_NM.map(|nm| Line::at(layer, nm));
        Self {
            line: pack_lines::<T>(lines),
        }
    }
}

impl<T: Lane> Method<T> for AiryRgb<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let (cos_theta, thickness_nm) = held(cos_theta, thickness_nm);
        let waves = self.line.waves(cos_theta);
        T::channels(self.line.reflectance(&waves, thickness_nm))
    }
}
