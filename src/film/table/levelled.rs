//! A table, and its averages over spreads of thickness.

use super::critical_axis::Cosine;
use super::errors::Errors;
use super::film_table::{FilmTable, Over};
use super::lane_table::LaneTable;
use super::levels::{Levels, Spread};
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::num::Rgb;
use crate::num::bytes::{ByteReader, ByteWriter};

/// What a table is looked up at besides the cosine: a thickness, nm, or a [`Spread`] of it.
pub(in crate::film) trait Thickness: Copy {
    /// The colours at a cosine, not clipped.
    fn color(self, table: &LevelledTable, cosine: Cosine<f32>) -> Rgb<f32>;

    /// The colours of two tables that share their axis.
    #[inline(always)]
    fn both(self, tables: [&LevelledTable; 2], cosine: Cosine<f32>) -> [Rgb<f32>; 2] {
        tables.map(|table| self.color(table, cosine))
    }
}

impl Thickness for f32 {
    #[inline(always)]
    fn color(self, table: &LevelledTable, cosine: Cosine<f32>) -> Rgb<f32> {
        table.base.at(cosine, self)
    }

    #[inline(always)]
    fn both(self, [one, other]: [&LevelledTable; 2], cosine: Cosine<f32>) -> [Rgb<f32>; 2] {
        FilmTable::both_at([&one.base, &other.base], cosine, self)
    }
}

impl Thickness for Spread {
    fn color(self, table: &LevelledTable, cosine: Cosine<f32>) -> Rgb<f32> {
        match &table.levels {
            Some(levels) => levels.at(&table.base, cosine, self),
            None => table.base.at(cosine, self.thickness_nm),
        }
    }
}

/// A table and its levels.
#[derive(Clone, Debug)]
pub(in crate::film) struct LevelledTable {
    base: FilmTable,
    /// `None` if the description allows no spread.
    levels: Option<Box<Levels>>,
}

impl LevelledTable {
    /// [`FilmTable::fit`], and its levels if the description allows a spread.
    pub(super) fn fit(
        description: &FilmDescription,
        source: &mut ColorSource<'_>,
        over: Over,
        limits: FitLimits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let fitted = FilmTable::fit(description, source, over.clone(), limits)?;
        let Some((base, errors)) = fitted else {
            return Ok(None);
        };
        let levels = if description.thickness_spread_max_nm > 0.0 {
            Some(Box::new(Levels::fit(description, &base, &over, limits)?))
        } else {
            None
        };
        Ok(Some((Self { base, levels }, errors)))
    }

    /// The table without spread.
    #[cfg(test)]
    pub(super) fn base(&self) -> &FilmTable {
        &self.base
    }

    /// The spline, if it is over the cosine itself.
    #[inline(always)]
    pub fn over_cosine(&self) -> Option<&SplineTable> {
        self.base.over_cosine()
    }

    /// [`FilmTable::shares_axis`], without spread.
    pub fn shares_axis(&self, other: &Self) -> bool {
        self.base.shares_axis(&other.base)
    }

    /// [`FilmTable::in_lanes`], without spread.
    pub fn in_lanes(&self) -> Option<LaneTable<'_>> {
        self.base.in_lanes()
    }

    pub fn save(&self, block: &mut ByteWriter) {
        let Self { base, levels } = self;
        base.save(block);
        block.flag(levels.is_some());
        if let Some(levels) = levels {
            levels.save(block);
        }
    }

    /// Reads a table of a film.
    pub fn load(block: &mut ByteReader<'_>, description: &FilmDescription) -> Result<Self, Error> {
        let base = FilmTable::load(block, description)?;
        let levels = if block.flag()? {
            Some(Box::new(Levels::load(block, description)?))
        } else {
            None
        };
        Ok(Self { base, levels })
    }

    /// Writes a table that may be missing.
    pub fn save_optional(table: Option<&Self>, block: &mut ByteWriter) {
        block.flag(table.is_some());
        if let Some(table) = table {
            table.save(block);
        }
    }

    /// Reads a table that may be missing.
    pub fn load_optional(
        block: &mut ByteReader<'_>,
        description: &FilmDescription,
    ) -> Result<Option<Box<Self>>, Error> {
        if !block.flag()? {
            return Ok(None);
        }
        Self::load(block, description).map(|table| Some(Box::new(table)))
    }

    /// Estimated time of a look-up without spread, ns.
    pub fn cost_ns(&self) -> f64 {
        self.base.cost_ns()
    }

    /// Bytes of all control points.
    pub fn bytes(&self) -> usize {
        let levels = self.levels.as_deref();
        self.base.bytes() + levels.map_or(0, Levels::bytes)
    }

    /// The number of values and where they are, in words.
    pub fn size(&self) -> String {
        let levels = self.levels.as_deref();
        match levels.map_or(0, Levels::count) {
            0 => self.base.size(),
            levels => format!("{} with {levels} levels of spread", self.base.size()),
        }
    }
}
