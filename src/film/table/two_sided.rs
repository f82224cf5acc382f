//! The tables of a film, for light from either side.

use super::constant_sides::ConstantSides;
use super::dispersing_sides::DispersingSides;
use super::errors::Errors;
use super::lane_table::LaneTable;
#[cfg(test)]
use super::levelled::LevelledTable;
use super::levelled::Thickness;
use super::spline::SplineTable;
use super::task::FitLimits;
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::fringe_series::series::FringeSeries;
use crate::num::Rgb;
use crate::num::bytes::{ByteReader, ByteWriter};
use crate::optics::stack::Side;

/// Reflectance and, if the film keeps it, transmittance from both sides.
#[derive(Clone, Debug)]
pub(in crate::film) enum TwoSidedTables {
    /// Both sides share one critical angle and most tables.
    Constant(ConstantSides),
    /// Each side has tables of its own.
    Dispersing(DispersingSides),
}

impl TwoSidedTables {
    /// Fits the tables to a series, and returns the errors of each side; `None` if the limits cannot be met.
    pub(in crate::film) fn fit(
        description: &FilmDescription,
        series: &FringeSeries,
        limits: FitLimits,
    ) -> Result<Option<(Self, [Errors; 2])>, Error> {
        // Both sides of a base that absorbs share neither tables nor what is beyond the critical angle.
        if description.disperses() || description.is_base_tinted() {
            let fitted = DispersingSides::fit(description, series, limits)?;
            return Ok(fitted.map(|(sides, errors)| (Self::Dispersing(sides), errors)));
        }
        let fitted = ConstantSides::fit(description, series, limits)?;
        Ok(fitted.map(|(sides, errors)| (Self::Constant(sides), errors)))
    }

    /// Writes the tables.
    pub(in crate::film) fn save(&self, block: &mut ByteWriter) {
        block.flag(matches!(self, Self::Dispersing(_)));
        match self {
            Self::Constant(sides) => sides.save(block),
            Self::Dispersing(sides) => sides.save(block),
        }
    }

    /// Reads the tables of a film.
    pub(in crate::film) fn load(
        block: &mut ByteReader<'_>,
        description: &FilmDescription,
    ) -> Result<Self, Error> {
        if block.flag()? {
            DispersingSides::load(block, description).map(Self::Dispersing)
        } else {
            ConstantSides::load(block, description).map(Self::Constant)
        }
    }

    /// The table of the reflectance from the ambient's side, if it is over the cosine there.
    #[inline(always)]
    pub(in crate::film) fn over_ambient_cosine(&self) -> Option<&SplineTable> {
        match self {
            Self::Constant(sides) => sides.over_ambient_cosine(),
            Self::Dispersing(sides) => sides.over_ambient_cosine(),
        }
    }

    /// The table of the reflectance from the ambient's side for lanes, if it is one spline.
    pub(in crate::film) fn in_lanes(&self) -> Option<LaneTable<'_>> {
        match self {
            Self::Constant(sides) => sides.in_lanes(),
            Self::Dispersing(sides) => sides.in_lanes(),
        }
    }

    /// The table of the reflectance from the ambient's side.
    #[cfg(test)]
    pub(super) fn front(&self) -> &LevelledTable {
        match self {
            Self::Constant(sides) => sides.front(),
            Self::Dispersing(sides) => sides.front(),
        }
    }

    /// Estimated time of the look-ups of a call from a side, ns.
    pub(in crate::film) fn cost_ns(&self, side: Side) -> f64 {
        match self {
            Self::Constant(sides) => sides.cost_ns(side),
            Self::Dispersing(sides) => sides.cost_ns(side),
        }
    }

    /// Bytes of all tables.
    pub(in crate::film) fn bytes(&self) -> usize {
        match self {
            Self::Constant(sides) => sides.bytes(),
            Self::Dispersing(sides) => sides.bytes(),
        }
    }

    /// The number of values and where they are, in words.
    pub(in crate::film) fn size(&self) -> String {
        match self {
            Self::Constant(sides) => sides.size(),
            Self::Dispersing(sides) => sides.size(),
        }
    }

    /// Reflectance from the ambient's side, not clipped.
    pub(in crate::film) fn reflectance<T: Thickness>(
        &self,
        cos_theta: f32,
        thickness: T,
    ) -> Rgb<f32> {
        match self {
            Self::Constant(sides) => sides.reflectance(cos_theta, thickness),
            Self::Dispersing(sides) => sides.reflectance(cos_theta, thickness),
        }
    }

    /// Reflectance and transmittance from either side, not clipped; of a film fitted with transmittance.
    pub(in crate::film) fn colors<T: Thickness>(
        &self,
        side: Side,
        cos_theta: f32,
        thickness: T,
    ) -> Colors {
        match self {
            Self::Constant(sides) => sides.colors(side, cos_theta, thickness),
            Self::Dispersing(sides) => sides.colors(side, cos_theta, thickness),
        }
    }
}
