//! A table that is one spline, for lanes.

use super::critical_axis::Cosine;
use super::spline::SplineTable;
use super::warped::Warped;
use crate::num::Lane;

/// One spline over the cosine or its coordinate, for single numbers and for lanes.
#[derive(Clone, Copy)]
pub(in crate::film) struct LaneTable<'a> {
    /// What the coordinate is from; `None` for a plain table.
    pub(super) warped: Option<&'a Warped>,
    pub(super) spline: &'a SplineTable,
}

impl<'a> LaneTable<'a> {
    /// The table at a cosine.
    pub(super) fn line(&self, cosine: Cosine<f32>) -> Line<'a> {
        let Self { warped, spline } = *self;
        let is_warped = warped.is_some() && !spline.is_over_cosine();
        let [x, upright, least] = match warped {
            Some(warped) => [
                warped.axis.coordinate_lanes(cosine),
                warped.axis.upright_lanes(cosine),
                warped.range[0] as f32,
            ],
            None => [cosine.value(), 1.0, 0.0],
        };
        Line {
            spline,
            x,
            upright,
            least,
            is_warped,
        }
    }

    /// The spline, for [`SplineTable::around`].
    #[inline(always)]
    pub fn spline(&self) -> &'a SplineTable {
        self.spline
    }

    /// The place in the spline of a cosine and a thickness within its range, nm.
    #[inline(always)]
    pub fn position<L: Lane<Scalar = f32>>(&self, cosine: Cosine<L>, thickness_nm: L) -> L::Rgb {
        let Some(warped) = self.warped else {
            return self.spline.position(cosine.value(), thickness_nm);
        };
        let [x, path] = warped.spline_arguments(cosine, thickness_nm, self.spline);
        self.spline.position(x, path)
    }
}

/// A [`LaneTable`] at one cosine.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    spline: &'a SplineTable,
    /// The first coordinate, and the path per nm of thickness.
    x: f32,
    upright: f32,
    /// The thickness from which paths count, nm.
    least: f32,
    is_warped: bool,
}

impl Line<'_> {
    /// The colours at thicknesses within the range, nm: the bits of [`FilmTable::at`].
    #[inline(always)]
    pub fn at<L: Lane<Scalar = f32>>(&self, thickness_nm: L) -> L::Rgb {
        let path = if self.is_warped {
            let least = L::splat(self.least);
            least + (thickness_nm - least) * L::splat(self.upright)
        } else {
            thickness_nm
        };
        self.spline.at(L::splat(self.x), path)
    }
}
