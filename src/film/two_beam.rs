//! Two beams at three wavelengths.

use super::layer::{Line, pack_lines, phasor};
use super::{Method, OneLayer, held};
use crate::num::{Lane, Real, Rgb};
use crate::optics::RGB_WAVELENGTHS_NM;
use crate::optics::stack::{P, S};

/// The beam reflected by the film's surface and that reflected once by the base, interfering at
/// 645, 525 and 445 nm: Granier & Heidrich 2002, eq. 5,
///
/// ```text
/// rho = R + T + 2 cos(2 Phi) sqrt(R T)
/// ```
///
/// without its factor 1/2, per polarisation, with R = |r01|^2 and T = |t01 t10 r12 E|^2 by the
/// exact Fresnel amplitudes of both interfaces in place of eq. 6-10, and with their phases in
/// 2 Phi: the half wave of an interface to a higher index, the phase of a metal, total reflection.
///
/// Cost: the Fresnel amplitudes of two interfaces and one phase, the three wavelengths in lanes.
///
/// Fails wherever further beams matter, which is everywhere but on films and bases close in index:
/// energy is not conserved (a perfect base reaches (r + 1 - r^2)^2, up to 25/16, times white; beyond a
/// critical angle, where |t01| exceeds 1, 2.4 were found), and a
/// film of thickness 0 does not reflect like the bare base (r01 + (1 - r01^2) r12, not
/// (r01 + r12) / (1 + r01 r12)); it does if the film equals a neighbour. Three wavelengths alias
/// like [`AiryRgb`](super::AiryRgb).
#[derive(Clone, Copy, Debug)]
pub struct TwoBeam<T: Lane> {
    line: Line<T::Rgb>,
}

impl<T: Lane> TwoBeam<T> {
    /// For a film; its white and colour space are not used.
    pub fn new(layer: &OneLayer) -> Self {
        let lines = RGB_WAVELENGTHS_NM.map(|nm| Line::at(layer, nm));
        Self {
            line: pack_lines::<T>(lines),
        }
    }
}

impl<T: Lane> Method<T> for TwoBeam<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let (cos_theta, thickness_nm) = held(cos_theta, thickness_nm);
        let waves = self.line.waves(cos_theta);
        let (turns, loss) = self.line.round_trip(&waves, thickness_nm);
        let trip = phasor(turns).scaled(T::Rgb::new(1.0) - loss);
        let [s, p] = [S, P].map(|pol| {
            let amplitudes = waves.amplitudes(pol);
            (amplitudes.top + amplitudes.crossing * amplitudes.bottom * trip).norm_squared()
        });
        T::channels((s + p) * T::Rgb::new(0.5))
    }
}
