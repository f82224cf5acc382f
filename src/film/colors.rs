//! Colours of a film, and the clamping of its inputs.

use crate::num::{Mask, Real, Rgb};
use crate::optics::Converged;

/// Reflectance and transmittance of unpolarised light, linear RGB, as fractions of the power that
/// arrives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Colors<T = f32> {
    /// The fraction that returns to the side that the light came from.
    pub reflectance: Rgb<T>,
    /// The fraction that arrives on the other side.
    pub transmittance: Rgb<T>,
}

impl Colors<f64> {
    /// Rounded to single precision.
    pub(super) fn to_f32(self) -> Colors {
        let [reflectance, transmittance] =
            [self.reflectance, self.transmittance].map(|rgb| rgb.map(|x| x as f32));
        Colors {
            reflectance,
            transmittance,
        }
    }
}

impl From<Converged> for Colors<f64> {
    fn from(found: Converged) -> Self {
        Self {
            reflectance: found.reflectance,
            transmittance: found.transmittance,
        }
    }
}

/// The cosine and the thickness, each clamped to a range (least, greatest). NaN becomes the least.
#[inline(always)]
pub(super) fn clamp_inputs<L: Real>(
    [cos_theta, thickness_nm]: [L; 2],
    cosines: [L; 2],
    thicknesses: [L; 2],
) -> [L; 2] {
    [
        cos_theta.max(cosines[0]).min(cosines[1]),
        thickness_nm.max(thicknesses[0]).min(thicknesses[1]),
    ]
}

/// Whether an input of any lane is NaN.
#[inline(always)]
pub(super) fn has_nan<L: Real>([cos_theta, thickness_nm]: [L; 2]) -> bool {
    (!(cos_theta.equals(cos_theta) & thickness_nm.equals(thickness_nm))).any()
}
