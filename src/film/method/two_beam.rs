//! Two beams at three wavelengths.

use super::compiled_method::CompiledMethod;
use super::info::{MethodInfo, OneLayerCompile};
use super::media::{MediaAtWavelength, pack_media, phasor};
use super::one_layer::{OneLayer, clamped};
use crate::error::Error;
use crate::num::{Lane, Real, Rgb};
use crate::optics::RGB_WAVELENGTHS_NM;
use crate::optics::stack::{P, S};

pub(super) const INFO: MethodInfo = MethodInfo {
    cost_ns: |_| 41.0,
    ..MethodInfo::one_layer(
        "two_beam",
        OneLayerCompile {
            single: compile,
            double: compile,
            work: |_| "two reflected beams at 3 wavelengths".into(),
        },
    )
};

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
/// Fails wherever further beams matter, which is everywhere but on films and bases close in index.
/// Energy is not conserved: a perfect base reaches (r + 1 - r^2)^2, up to 25/16, times white; beyond a
/// critical angle, where |t01| exceeds 1, 2.4 were found. A film of thickness 0 does not reflect like
/// the bare base, with r01 + (1 - r01^2) r12 for (r01 + r12) / (1 + r01 r12); a film that equals a
/// neighbour does. Three wavelengths alias as in `airy_rgb.rs`.
struct TwoBeam<T: Lane> {
    media: MediaAtWavelength<T::Rgb>,
}

/// The film's white and colour space are not used; the method has one size.
fn compile<T: Lane>(layer: &OneLayer, _: usize) -> Result<Box<dyn CompiledMethod<T>>, Error> {
    let media = RGB_WAVELENGTHS_NM.map(|nm| MediaAtWavelength::at(layer, nm));
    Ok(Box::new(TwoBeam::<T> {
        media: pack_media::<T>(media),
    }))
}

impl<T: Lane> CompiledMethod<T> for TwoBeam<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let [cos_theta, thickness_nm] = clamped(cos_theta, thickness_nm);
        let waves = self.media.waves(cos_theta);
        let (turns, loss) = self.media.round_trip(&waves, thickness_nm);
        let trip = phasor(turns).scaled(T::Rgb::new(1.0) - loss);
        let [s, p] = [S, P].map(|pol| {
            let amplitudes = waves.amplitudes(pol);
            (amplitudes.top + amplitudes.crossing * amplitudes.bottom * trip).norm_squared()
        });
        T::channels((s + p) * T::Rgb::new(0.5))
    }
}
