//! A table over a coordinate that spreads the critical angles.

use super::axes::LEAST_NM;
use super::critical_axis::{Cosine, CriticalAxis};
use super::errors::Errors;
use super::fit;
use super::patches::{PatchSource, Patches};
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::num::{Lane, Rgb};

/// At smaller cosines than this, films thinner than [`LEAST_NM`] have no tolerance.
const LEAST_VANISHING_COSINE: f64 = 1e-4;

/// A table over the coordinate of an axis, and over the product of thickness and the cosine in the layer.
#[derive(Clone, Debug)]
pub(in crate::film) struct Warped {
    pub axis: CriticalAxis,
    /// Least and greatest thickness, nm.
    pub range: [f64; 2],
    pub shape: Shape,
}

#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// One spline over both.
    Spline(SplineTable),
    /// Patches over the axis and the root of the path's part of its range.
    Patches(Patches),
}

impl Warped {
    pub fn fit(
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
        let fitted = fit::of_film(description, &mut warped, range, 0.0, limits)?;
        Ok(fitted.map(|(spline, errors)| {
            let shape = Shape::Spline(spline);
            (Self { axis, range, shape }, errors)
        }))
    }

    pub fn fit_patches(
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

    /// The colours at a cosine and a thickness within its range, nm.
    #[inline(always)]
    pub fn at(&self, cosine: Cosine<f32>, thickness_nm: f32) -> Rgb<f32> {
        match &self.shape {
            Shape::Spline(spline) => {
                let [x, path] = self.spline_arguments(cosine, thickness_nm, spline);
                f32::channels(spline.at(x, path))
            }
            Shape::Patches(patches) => self.at_patch(patches, cosine, thickness_nm),
        }
    }

    #[inline(never)]
    fn at_patch(&self, patches: &Patches, cosine: Cosine<f32>, thickness_nm: f32) -> Rgb<f32> {
        let [least, greatest] = self.range;
        let c = cosine.to_f64();
        let path = (f64::from(thickness_nm) - least) * self.axis.upright(c);
        patches.at([self.axis.coordinate(c), (path / (greatest - least)).sqrt()])
    }

    /// The coordinate, and the path in nm, at which a spline is looked up.
    #[inline(always)]
    pub fn spline_arguments<L: Lane<Scalar = f32>>(
        &self,
        cosine: Cosine<L>,
        thickness_nm: L,
        spline: &SplineTable,
    ) -> [L; 2] {
        let x = self.axis.coordinate_lanes(cosine);
        if spline.is_over_cosine() {
            return [x, thickness_nm];
        }
        let least = L::splat(self.range[0] as f32);
        let path = (thickness_nm - least) * self.axis.upright_lanes(cosine);
        [x, least + path]
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
