//! The colours of a film over the cosine in one medium, and over the thickness of the layer that varies.

use super::axes::LEAST_NM;
use super::critical::{Centre, CriticalAxis};
use super::errors::Errors;
use super::fit;
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits, FitTask};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::num::{Lane, Rgb};

/// The wavelength whose indices decide where total reflection begins and how fringes bend, nm: near the
/// eye's greatest sensitivity.
pub(super) const MIDDLE_NM: f64 = 550.0;
/// Below 1, so that thicknesses stay finite where light in the film goes along it.
const GREATEST_TILT: f64 = 0.9;

/// A table, with the coordinate of its cosines where that is not the cosine itself.
#[derive(Clone, Debug)]
pub(super) struct FilmTable {
    axis: Option<Box<CriticalAxis>>,
    spline: SplineTable,
    /// The least thickness, nm.
    from: f64,
}

/// What a table is over, besides the thickness.
pub(super) enum Over {
    /// The cosine in a medium of this index, with critical angles.
    Cosine(f64, Vec<Centre>),
    /// A number in [0, 1] without fringes.
    Plain,
}

impl FilmTable {
    /// Fits a table to colours over `over` and the thickness, nm; `None` if the limits cannot be met.
    pub fn fit(
        description: &FilmDescription,
        source: &mut ColorSource<'_>,
        over: Over,
        limits: FitLimits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let range = table_range(description.varying_range());
        let (index, centres) = match over {
            Over::Cosine(index, centres) => (Some(index), centres),
            Over::Plain => (None, Vec::new()),
        };
        let tilt = tilt(description, index);
        if centres.is_empty() {
            let fitted = fitted(description, source, range, tilt.min(GREATEST_TILT), limits)?;
            return Ok(fitted.map(|(spline, errors)| {
                let table = Self {
                    axis: None,
                    spline,
                    from: range[0],
                };
                (table, errors)
            }));
        }
        let axis = CriticalAxis::new(&centres, tilt);
        let mut last = (f64::NAN, 0.0, 1.0);
        let mut warped = |x: f64, path: f64| {
            if last.0 != x {
                let c = axis.cosine(x);
                last = (x, c, axis.upright(c));
            }
            source(last.1, range[0] + (path - range[0]) / last.2)
        };
        let fitted = fitted(description, &mut warped, range, 0.0, limits)?;
        Ok(fitted.map(|(spline, errors)| {
            let table = Self {
                axis: Some(Box::new(axis)),
                spline,
                from: range[0],
            };
            (table, errors)
        }))
    }

    /// The colours at a cosine and a thickness within its range, nm.
    #[inline(always)]
    pub fn at(&self, cos_theta: f64, thickness_nm: f32) -> Rgb<f32> {
        let (x, thickness_nm) = match &self.axis {
            None => (cos_theta, thickness_nm),
            Some(axis) => {
                let path = (f64::from(thickness_nm) - self.from) * axis.upright(cos_theta);
                (axis.coordinate(cos_theta), (self.from + path) as f32)
            }
        };
        f32::channels(self.spline.at(x as f32, thickness_nm))
    }

    /// The spline, if it is over the cosine itself.
    #[inline(always)]
    pub fn over_cosine(&self) -> Option<&SplineTable> {
        self.axis.is_none().then_some(&self.spline)
    }

    /// Bytes of the control points.
    pub fn bytes(&self) -> usize {
        self.spline.bytes()
    }

    /// The number of values and where they are, in words.
    pub fn size(&self) -> String {
        self.spline.size()
    }
}

/// (n0 / n1)^2 of the medium that the cosine is in and the layer that varies; 0 without fringes.
fn tilt(description: &FilmDescription, index: Option<f64>) -> f64 {
    let (Some(index), Some(varying)) = (index, description.varying()) else {
        return 0.0;
    };
    let inside = description.layers[varying].medium.index(MIDDLE_NM);
    // The fringes of a metal need not be made parallel to the axis.
    if inside.im > inside.re {
        0.0
    } else {
        (index / inside.re).powi(2)
    }
}

/// The range of a table's thickness: its ends in single precision, in which it is looked up, and never so narrow
/// that steps per nm are beyond single precision.
fn table_range(thickness_nm: [f64; 2]) -> [f64; 2] {
    let [least, greatest] = thickness_nm.map(|x| f64::from(x as f32));
    [least, greatest.max(least + LEAST_NM)]
}

fn fitted(
    description: &FilmDescription,
    source: &mut ColorSource<'_>,
    range: [f64; 2],
    tilt: f64,
    limits: FitLimits,
) -> Result<Option<fit::Fitted>, Error> {
    if description.varying().is_none() {
        return fit::over_cosine(source, limits);
    }
    fit::over_both(&mut FitTask {
        source,
        range,
        tilt,
        is_costly: description.layers.len() > 1,
        limits,
    })
}
