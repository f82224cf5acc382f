//! How a film is evaluated: the cheapest method that holds the tolerance.

use super::FilmDescription;
use super::compiled::{Colors, Evaluator};
use crate::error::Error;
use crate::math::Rgb;
use crate::optics::Reference;
use crate::optics::stack::Side;

/// What was chosen, and what it was measured to do.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The method's name.
    pub method: &'static std::ffi::CStr,
    /// The error that was allowed.
    pub tolerance: f64,
    /// The greatest error of a channel found between the nodes, clipped colours.
    pub measured_max: f64,
    /// The root of the mean square of the errors found.
    pub measured_rms: f64,
    /// Bytes of the tables.
    pub bytes: usize,
    /// One sentence.
    pub reason: std::ffi::CString,
    /// The range that thicknesses are held in, nm.
    pub(super) thickness_nm: [f32; 2],
}

struct Converged {
    reference: Reference,
    ranges: Vec<[f64; 2]>,
}

impl Converged {
    fn thicknesses(&self, varying_nm: f32) -> Vec<f64> {
        let held = |[min, max]: &[f64; 2]| f64::from(varying_nm).clamp(*min, *max);
        self.ranges.iter().map(held).collect()
    }
}

impl Evaluator for Converged {
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        self.colors(Side::Ambient, cos_theta, thickness_nm)
            .reflectance
    }

    fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        let thicknesses = self.thicknesses(thickness_nm);
        let found = self
            .reference
            .evaluate(side, f64::from(cos_theta), &thicknesses);
        Colors {
            reflectance: found.reflectance.map(|x| x as f32),
            transmittance: found.transmittance.map(|x| x as f32),
        }
    }
}

/// Chooses and compiles.
pub(super) fn plan(
    description: &FilmDescription,
    reference: &Reference,
) -> Result<(Box<dyn Evaluator>, Plan), Error> {
    let ranges: Vec<[f64; 2]> = description.layers.iter().map(|l| l.thickness_nm).collect();
    let varying = description.varying().map_or([0.0; 2], |v| ranges[v]);
    let evaluator = Converged {
        reference: reference.clone(),
        ranges,
    };
    let plan = Plan {
        method: c"reference",
        tolerance: description.tolerance,
        measured_max: 0.0,
        measured_rms: 0.0,
        bytes: 0,
        reason: c"converged wave optics".into(),
        thickness_nm: varying.map(|x| x as f32),
    };
    Ok((Box::new(evaluator), plan))
}
