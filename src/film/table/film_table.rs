//! The colours of a film over the cosine in one medium, and over the thickness of the layer that varies.

use super::axes::LEAST_NM;
use super::critical::{Centre, CriticalAxis, MIDDLE_NM};
use super::errors::Errors;
use super::fit;
use super::patches::{PatchSource, Patches};
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits, FitTask};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::num::{Lane, Rgb};

/// The greatest number of values of one spline around critical angles: patches need fewer where it would need more.
const MOST_WARPED: usize = 12_000;
/// At smaller cosines than this, films thinner than [`LEAST_NM`] have no tolerance.
const LEAST_VANISHING_COSINE: f64 = 1e-4;
/// Below 1, so that thicknesses stay finite where light in the film goes along it.
const GREATEST_TILT: f64 = 0.9;

/// A table, with the coordinate of its cosines where that is not the cosine itself.
#[derive(Clone, Debug)]
pub(super) enum FilmTable {
    /// One spline over the cosine.
    Plain(SplineTable),
    /// One spline, or many, over a coordinate that spreads the critical angles.
    Warped(Box<Warped>),
}

/// A table over the coordinate of an axis, and over the product of thickness and the cosine in the layer.
#[derive(Clone, Debug)]
pub(super) struct Warped {
    axis: CriticalAxis,
    /// Least and greatest thickness, nm.
    range: [f64; 2],
    shape: Shape,
}

#[derive(Clone, Debug)]
enum Shape {
    /// One spline over both.
    Spline(SplineTable),
    /// Patches over the axis and the root of the path's part of its range.
    Patches(Patches),
}

/// What a table is over, besides the thickness.
#[derive(Clone)]
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
            let plain = fitted(description, source, range, tilt.min(GREATEST_TILT), limits)?;
            if let Some((spline, errors)) = plain {
                return Ok(Some((Self::Plain(spline), errors)));
            }
        } else {
            let axis = CriticalAxis::new(&centres, tilt);
            let smaller = FitLimits {
                size: limits.size.min(MOST_WARPED),
                ..limits
            };
            let warped = Warped::fit(description, source, axis, range, smaller)?;
            if let Some((warped, errors)) = warped {
                return Ok(Some((Self::Warped(Box::new(warped)), errors)));
            }
        }
        let centres: Vec<Centre> = centres.into_iter().chain([Centre::GRAZING]).collect();
        let axis = CriticalAxis::new(&centres, tilt);
        let patches = Warped::fit_patches(source, axis, range, limits)?;
        Ok(patches.map(|(warped, errors)| (Self::Warped(Box::new(warped)), errors)))
    }

    /// The colours at a cosine and a thickness within its range, nm.
    #[inline(always)]
    pub fn at(&self, cos_theta: f64, thickness_nm: f32) -> Rgb<f32> {
        match self {
            Self::Plain(spline) => f32::channels(spline.at(cos_theta as f32, thickness_nm)),
            Self::Warped(warped) => warped.at(cos_theta, thickness_nm),
        }
    }

    /// The spline, if it is over the cosine itself.
    #[inline(always)]
    pub fn over_cosine(&self) -> Option<&SplineTable> {
        match self {
            Self::Plain(spline) => Some(spline),
            Self::Warped(_) => None,
        }
    }

    /// Bytes of the control points.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Plain(spline) => spline.bytes(),
            Self::Warped(warped) => match &warped.shape {
                Shape::Spline(spline) => spline.bytes(),
                Shape::Patches(patches) => patches.bytes(),
            },
        }
    }

    /// The number of values and where they are, in words.
    pub fn size(&self) -> String {
        match self {
            Self::Plain(spline) => spline.size(),
            Self::Warped(warped) => match &warped.shape {
                Shape::Spline(spline) => spline.size(),
                Shape::Patches(patches) => format!("{} values in patches", patches.len()),
            },
        }
    }
}

impl Warped {
    fn fit(
        description: &FilmDescription,
        source: &mut ColorSource<'_>,
        axis: CriticalAxis,
        range: [f64; 2],
        limits: FitLimits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let mut last = LastCosine::new(&axis);
        let mut warped = |x: f64, path: f64| {
            let (c, upright) = last.at(x);
            source(c, range[0] + (path - range[0]) / upright)
        };
        let fitted = fitted(description, &mut warped, range, 0.0, limits)?;
        Ok(fitted.map(|(spline, errors)| {
            let shape = Shape::Spline(spline);
            (Self { axis, range, shape }, errors)
        }))
    }

    fn fit_patches(
        source: &mut ColorSource<'_>,
        axis: CriticalAxis,
        range: [f64; 2],
        limits: FitLimits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let [least, greatest] = range;
        let thickness = |upright: f64, y: f64| least + y * y * (greatest - least) / upright;
        let mut last = LastCosine::new(&axis);
        let fitted = Patches::fit(
            PatchSource {
                color: &mut |x, y| {
                    let (c, upright) = last.at(x);
                    source(c, thickness(upright, y))
                },
                is_seen: &|x, y| thickness(axis.upright(axis.cosine(x)), y) <= greatest,
                // Thinner films at smaller cosines have none, see Film.
                has_tolerance: &|x, y| {
                    let c = axis.cosine(x);
                    thickness(axis.upright(c), y) >= LEAST_NM || c >= LEAST_VANISHING_COSINE
                },
            },
            limits,
        )?;
        Ok(fitted.map(|(patches, errors)| {
            let shape = Shape::Patches(patches);
            (Self { axis, range, shape }, errors)
        }))
    }

    fn at(&self, cos_theta: f64, thickness_nm: f32) -> Rgb<f32> {
        let [least, greatest] = self.range;
        let path = (f64::from(thickness_nm) - least) * self.axis.upright(cos_theta);
        let x = self.axis.coordinate(cos_theta);
        match &self.shape {
            Shape::Spline(spline) => f32::channels(spline.at(x as f32, (least + path) as f32)),
            Shape::Patches(patches) => patches.at([x, (path / (greatest - least)).sqrt()]),
        }
    }
}

/// The cosine of a coordinate, and its cosine in the layer; equal coordinates one after another are found once.
struct LastCosine<'a> {
    axis: &'a CriticalAxis,
    last: [f64; 3],
}

impl<'a> LastCosine<'a> {
    fn new(axis: &'a CriticalAxis) -> Self {
        Self {
            axis,
            last: [f64::NAN; 3],
        }
    }

    fn at(&mut self, x: f64) -> (f64, f64) {
        if self.last[0] != x {
            let c = self.axis.cosine(x);
            self.last = [x, c, self.axis.upright(c)];
        }
        (self.last[1], self.last[2])
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
