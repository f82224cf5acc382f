//! Evaluators that compile nothing but what they are given.

use super::FilmDescription;
use super::compiled::{Colors, Evaluator};
use super::points::critical_angles;
use super::series::Series;
use super::{Kind, Method, OneLayer};
use crate::error::Error;
use crate::num::Rgb;
use crate::optics::stack::Side;
use crate::optics::{dielectric_reflectance, schlick};

/// Schlick's approximation from the colour at normal incidence.
pub(super) struct SchlickBase(pub Rgb<f32>);

/// Fresnel's equations between two dielectrics without dispersion.
pub(super) struct FresnelBase {
    /// Index of the base over that of the ambient.
    pub eta: f32,
}

/// A method for one layer. In double precision if some light is reflected totally: at a critical angle
/// a wave is the root of a difference of squares, and has half the digits that they have. In single
/// precision bands were off by 5e-3 there.
pub(super) struct OneLayerMethod {
    method: Box<dyn Method<f32>>,
    fixed_nm: Option<f32>,
}

/// The series at every call.
pub(super) struct SeriesMethod(pub Series);

impl OneLayerMethod {
    /// `layer` of a description with one layer.
    pub(super) fn new(
        description: &FilmDescription,
        layer: &OneLayer,
        kind: Kind,
    ) -> Result<Self, Error> {
        let fixed = description.varying().is_none();
        let thickness = description.layers[0].thickness_nm[0] as f32;
        let critical = critical_angles(description, Side::Ambient).all();
        let method = if critical.is_empty() {
            kind.compile::<f32>(layer)?
        } else {
            Box::new(Rounded(kind.compile::<f64>(layer)?))
        };
        Ok(Self {
            method,
            fixed_nm: fixed.then_some(thickness),
        })
    }
}

/// Evaluated in double precision.
struct Rounded(Box<dyn Method<f64>>);

impl Method<f32> for Rounded {
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        let found = self
            .0
            .reflectance(f64::from(cos_theta), f64::from(thickness_nm));
        found.map(|channel| channel as f32)
    }
}

impl Evaluator for SchlickBase {
    fn reflectance(&self, cos_theta: f32, _: f32) -> Rgb<f32> {
        self.0.map(|f0| schlick(f0, cos_theta))
    }
}

impl Evaluator for FresnelBase {
    fn reflectance(&self, cos_theta: f32, _: f32) -> Rgb<f32> {
        [dielectric_reflectance(cos_theta, self.eta); 3]
    }
}

impl Evaluator for OneLayerMethod {
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        let thickness_nm = self.fixed_nm.unwrap_or(thickness_nm);
        self.method.reflectance(cos_theta, thickness_nm)
    }
}

impl Evaluator for SeriesMethod {
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        self.colors(Side::Ambient, cos_theta, thickness_nm)
            .reflectance
    }

    fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        let (cos_theta, thickness_nm) = (f64::from(cos_theta), f64::from(thickness_nm));
        let found = self.0.at(side, cos_theta, thickness_nm);
        Colors::rounded(found.reflectance, found.transmittance)
    }
}
