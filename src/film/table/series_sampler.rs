//! The colours that tables are filled with.

use crate::film::colors::Colors;
use crate::film::fringe_series::series::{FringeSeries, SeriesAtAngle};
use crate::optics::stack::Side;

/// A series that keeps the angle it was last evaluated at.
pub(super) struct SeriesSampler<'a> {
    series: &'a FringeSeries,
    last: Option<(Side, f64, SeriesAtAngle<'a>)>,
}

impl<'a> SeriesSampler<'a> {
    pub fn new(series: &'a FringeSeries) -> Self {
        Self { series, last: None }
    }

    pub fn at(&mut self, side: Side, cos_theta: f64, thickness_nm: f64) -> Colors<f64> {
        if !matches!(&self.last, Some((s, c, _)) if *s == side && *c == cos_theta) {
            self.last = Some((side, cos_theta, self.series.at_angle(side, cos_theta)));
        }
        match &self.last {
            Some((_, _, at_angle)) => at_angle.at(thickness_nm),
            None => Colors::default(),
        }
    }
}
