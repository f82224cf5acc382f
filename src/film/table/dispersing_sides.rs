//! The tables of a film between half-spaces of which one disperses, so that every wavelength has its own critical angle.

use super::critical::{MIDDLE_NM, centres};
use super::errors::Errors;
use super::film_table::Over;
use super::lane_table::LaneTable;
use super::levelled::{LevelledTable, Thickness};
use super::series_sampler::SeriesSampler;
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits};
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::fringe_series::series::FringeSeries;
use crate::num::Rgb;
use crate::num::bytes::{ByteReader, ByteWriter};
use crate::optics::stack::Side;

/// One or two tables for each side that light is asked for from, over the cosine there: the critical angles are smeared
/// out over the spectrum, and a coordinate spreads their interval.
#[derive(Clone, Debug)]
pub(in crate::film) struct DispersingSides {
    front: OneSide,
    /// `None` if no light is asked for from the base.
    back: Option<Box<OneSide>>,
}

/// The tables of one side.
#[derive(Clone, Debug)]
struct OneSide {
    reflectance: LevelledTable,
    /// `None`: 1 - reflectance, as nothing absorbs.
    transmittance: Option<Box<LevelledTable>>,
    /// Whether both tables share their axis.
    has_one_axis: bool,
}

impl DispersingSides {
    /// Fits the tables to a series, and returns the errors of each side; `None` if the limits cannot be met.
    pub(super) fn fit(
        description: &FilmDescription,
        series: &FringeSeries,
        limits: FitLimits,
    ) -> Result<Option<(Self, [Errors; 2])>, Error> {
        let mut errors = [Errors::default(); 2];
        let mut side = |side| {
            let errors = &mut errors[side as usize];
            OneSide::fit(description, series, side, limits, errors)
        };
        let Some(front) = side(Side::Ambient)? else {
            return Ok(None);
        };
        let back = if description.sides().contains(&Side::Base) {
            let back = side(Side::Base)?;
            if back.is_none() {
                return Ok(None);
            }
            back.map(Box::new)
        } else {
            None
        };
        Ok(Some((Self { front, back }, errors)))
    }

    /// Writes the tables.
    pub(super) fn save(&self, block: &mut ByteWriter) {
        let Self { front, back } = self;
        front.save(block);
        block.flag(back.is_some());
        if let Some(back) = back {
            back.save(block);
        }
    }

    /// Reads the tables of a film.
    pub(super) fn load(
        block: &mut ByteReader<'_>,
        description: &FilmDescription,
    ) -> Result<Self, Error> {
        let front = OneSide::load(block, description)?;
        let back = if block.flag()? {
            Some(Box::new(OneSide::load(block, description)?))
        } else {
            None
        };
        Ok(Self { front, back })
    }

    #[inline(always)]
    pub(super) fn over_ambient_cosine(&self) -> Option<&SplineTable> {
        self.front.reflectance.over_cosine()
    }

    /// The table of the reflectance from the ambient's side, for lanes.
    pub(super) fn in_lanes(&self) -> Option<LaneTable<'_>> {
        self.front.reflectance.in_lanes()
    }

    fn tables(&self) -> impl Iterator<Item = &LevelledTable> {
        let sides = std::iter::once(&self.front).chain(self.back.as_deref());
        sides.flat_map(|side| {
            std::iter::once(&side.reflectance).chain(side.transmittance.as_deref())
        })
    }

    #[cfg(test)]
    pub(super) fn front(&self) -> &LevelledTable {
        &self.front.reflectance
    }

    /// Estimated time of the look-ups of a call from a side, ns; 0 if no light is asked for from it.
    pub(super) fn cost_ns(&self, side: Side) -> f64 {
        match side {
            Side::Ambient => self.front.cost_ns(),
            Side::Base => self.back.as_ref().map_or(0.0, |back| back.cost_ns()),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        self.tables().map(LevelledTable::bytes).sum()
    }

    pub(super) fn size(&self) -> String {
        let sizes: Vec<String> = self.tables().map(LevelledTable::size).collect();
        sizes.join("; ")
    }

    pub(super) fn reflectance<T: Thickness>(&self, cos_theta: f32, thickness: T) -> Rgb<f32> {
        thickness.color(&self.front.reflectance, cos_theta.into())
    }

    pub(super) fn colors<T: Thickness>(&self, side: Side, cos_theta: f32, thickness: T) -> Colors {
        match (side, &self.back) {
            (Side::Ambient, _) => self.front.colors(cos_theta, thickness),
            (Side::Base, Some(back)) => back.colors(cos_theta, thickness),
            (Side::Base, None) => Colors::default(),
        }
    }
}

impl OneSide {
    fn fit(
        description: &FilmDescription,
        series: &FringeSeries,
        side: Side,
        limits: FitLimits,
        errors: &mut Errors,
    ) -> Result<Option<Self>, Error> {
        let is_opaque = description.is_base_opaque();
        let [near, far] = description.near_and_far(side);
        let mut sampler = SeriesSampler::new(series);
        let mut fitted = |source: &mut ColorSource<'_>| {
            let far = (!is_opaque).then_some(far);
            let centres = centres(description, near, far);
            let over = Over::Cosine(near.index(MIDDLE_NM).re, centres);
            let fitted = LevelledTable::fit(description, source, over, limits)?;
            Ok::<_, Error>(fitted.map(|(table, found)| {
                errors.merge(&found);
                table
            }))
        };
        let Some(reflectance) = fitted(&mut |c, d| sampler.at(side, c, d).reflectance)? else {
            return Ok(None);
        };
        let absorbs = is_opaque
            || description
                .layers
                .iter()
                .any(|layer| layer.medium.absorbs());
        let mut transmittance = None;
        if description.transmittance && absorbs {
            transmittance = fitted(&mut |c, d| sampler.at(side, c, d).transmittance)?;
            if transmittance.is_none() {
                return Ok(None);
            }
        }
        Ok(Some(Self::new(reflectance, transmittance.map(Box::new))))
    }

    fn new(reflectance: LevelledTable, transmittance: Option<Box<LevelledTable>>) -> Self {
        let table = transmittance.as_ref();
        Self {
            has_one_axis: table.is_some_and(|table| table.shares_axis(&reflectance)),
            reflectance,
            transmittance,
        }
    }

    fn cost_ns(&self) -> f64 {
        let transmittance = self.transmittance.as_ref();
        self.reflectance.cost_ns() + transmittance.map_or(0.0, |table| table.cost_ns())
    }

    fn save(&self, block: &mut ByteWriter) {
        let Self {
            reflectance,
            transmittance,
            has_one_axis: _,
        } = self;
        reflectance.save(block);
        LevelledTable::save_optional(transmittance.as_deref(), block);
    }

    fn load(block: &mut ByteReader<'_>, description: &FilmDescription) -> Result<Self, Error> {
        let reflectance = LevelledTable::load(block, description)?;
        let transmittance = LevelledTable::load_optional(block, description)?;
        Ok(Self::new(reflectance, transmittance))
    }

    fn colors<T: Thickness>(&self, cos_theta: f32, thickness: T) -> Colors {
        let c = cos_theta.into();
        let [reflectance, transmittance] = match &self.transmittance {
            Some(table) if self.has_one_axis => thickness.both([&self.reflectance, table], c),
            Some(table) => [&self.reflectance, table].map(|table| thickness.color(table, c)),
            None => {
                let reflectance = thickness.color(&self.reflectance, c);
                [reflectance, reflectance.map(|r| 1.0 - r)]
            }
        };
        Colors {
            reflectance,
            transmittance,
        }
    }
}
