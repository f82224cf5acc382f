//! The tables of a film between half-spaces whose relative index is the same at all wavelengths.

use super::critical::{MIDDLE_NM, centres};
use super::critical_axis::Cosine;
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

/// The time of finding the zone and the cosine in the rarer half-space, ns.
const ZONE_NS: f64 = 12.0;
const BOTH: [Side; 2] = [Side::Ambient, Side::Base];

/// Reflectance and transmittance from both sides.
///
/// All tables are over the cosine in the rarer half-space, in which the colours are smooth; the
/// transmittance is the same from both sides. Beyond the critical angle, which only the denser side
/// has, nothing is transmitted, and the reflectance has a table of its own over kappa / (kappa + cos),
/// kappa the decay in the rarer half-space, both in units of their greatest value.
#[derive(Clone, Debug)]
pub(in crate::film) struct ConstantSides {
    /// The reflectance from the ambient's side.
    front: LevelledTable,
    /// The square of the ratio of the denser index and the rarer one.
    ratio: f64,
    rarer: Side,
    /// The transmittance; `None`: 1 - reflectance, as nothing absorbs.
    through: Option<Box<LevelledTable>>,
    /// The reflectance from the base's side; `None`: as `front`.
    back: Option<Box<LevelledTable>>,
    /// The reflectance beyond the critical angle; `None`: 1.
    beyond: Option<Box<LevelledTable>>,
}

/// The zone of a direction.
enum Zone {
    /// Below the critical angle, at this cosine in the rarer half-space.
    Below(Cosine<f32>),
    /// Beyond the critical angle, at this kappa / (kappa + cos).
    Beyond(f32),
}

impl ConstantSides {
    /// Fits the tables to a series, and returns the errors of each side; `None` if the limits cannot be met.
    pub(super) fn fit(
        description: &FilmDescription,
        series: &FringeSeries,
        limits: FitLimits,
    ) -> Result<Option<(Self, [Errors; 2])>, Error> {
        let is_opaque = description.is_base_opaque();
        let (rarer, ratio) = rarer_side(description);
        let denser = match rarer {
            Side::Ambient => Side::Base,
            Side::Base => Side::Ambient,
        };
        let rare_medium = match rarer {
            Side::Ambient => &description.ambient,
            Side::Base => &description.base,
        };
        let rare_index = rare_medium.index(MIDDLE_NM).re;
        let mut sampler = SeriesSampler::new(series);
        let mut errors = [Errors::default(); 2];
        let below = || Over::Cosine(rare_index, centres(description, rare_medium, None));
        let mut fitted = |source: &mut ColorSource<'_>, over: Over, sides: &[Side]| {
            let fitted = LevelledTable::fit(description, source, over, limits)?;
            if let Some((_, found)) = &fitted {
                for side in sides {
                    errors[*side as usize].merge(found);
                }
            }
            Ok::<_, Error>(fitted.map(|(table, _)| table))
        };
        // The cosine on a side for a cosine in the rarer half-space.
        let cosine = |side: Side, c: f64| {
            if side == rarer {
                c
            } else {
                ((ratio - 1.0) + c * c).sqrt() / ratio.sqrt()
            }
        };
        let absorbs = description
            .layers
            .iter()
            .any(|layer| layer.medium.absorbs());
        let is_lossless = !absorbs && !is_opaque;

        // A film that is its own mirror image reflects the same from both sides.
        let is_mirrored = ratio == 1.0 && !is_opaque && description.layers.len() < 2;
        let is_front_both = description.transmittance && (!absorbs || is_mirrored);
        let mut reflectance = |side: Side, sides: &[Side]| {
            fitted(
                &mut |c, d| sampler.at(side, cosine(side, c), d).reflectance,
                below(),
                sides,
            )
        };
        let front_sides = if is_front_both { &BOTH[..] } else { &BOTH[..1] };
        let Some(front) = reflectance(Side::Ambient, front_sides)? else {
            return Ok(None);
        };
        let (mut back, mut through, mut beyond) = (None, None, None);
        if description.transmittance && absorbs {
            if !is_opaque && !is_mirrored {
                back = reflectance(Side::Base, &BOTH[1..])?;
                if back.is_none() {
                    return Ok(None);
                }
            }
            through = fitted(
                &mut |c, d| {
                    sampler
                        .at(Side::Ambient, cosine(Side::Ambient, c), d)
                        .transmittance
                },
                below(),
                &BOTH,
            )?;
            if through.is_none() {
                return Ok(None);
            }
        }
        let is_seen = denser == Side::Ambient || description.transmittance;
        if !is_lossless && !is_opaque && ratio > 1.0 && is_seen {
            let critical = (1.0 - 1.0 / ratio).sqrt();
            beyond = fitted(
                &mut |t, d| {
                    let part = (1.0 - t) / (t * t + (1.0 - t) * (1.0 - t)).sqrt();
                    sampler.at(denser, critical * part, d).reflectance
                },
                Over::Plain,
                &[denser],
            )?;
            if beyond.is_none() {
                return Ok(None);
            }
        }
        let [through, back, beyond] = [through, back, beyond].map(|table| table.map(Box::new));
        let tables = Self {
            front,
            ratio,
            rarer,
            through,
            back,
            beyond,
        };
        Ok(Some((tables, errors)))
    }

    /// Writes the tables.
    pub(super) fn save(&self, block: &mut ByteWriter) {
        let Self {
            front,
            ratio: _,
            rarer: _,
            through,
            back,
            beyond,
        } = self;
        front.save(block);
        for table in [through, back, beyond] {
            LevelledTable::save_optional(table.as_deref(), block);
        }
    }

    /// Reads the tables of a film.
    pub(super) fn load(
        block: &mut ByteReader<'_>,
        description: &FilmDescription,
    ) -> Result<Self, Error> {
        let (rarer, ratio) = rarer_side(description);
        Ok(Self {
            front: LevelledTable::load(block, description)?,
            ratio,
            rarer,
            through: LevelledTable::load_optional(block, description)?,
            back: LevelledTable::load_optional(block, description)?,
            beyond: LevelledTable::load_optional(block, description)?,
        })
    }

    /// The table of the reflectance from the ambient's side, if it is over the cosine there.
    #[inline(always)]
    pub(super) fn over_ambient_cosine(&self) -> Option<&SplineTable> {
        if self.rarer == Side::Ambient {
            self.front.over_cosine()
        } else {
            None
        }
    }

    /// The same table for lanes.
    pub(super) fn in_lanes(&self) -> Option<LaneTable<'_>> {
        if self.rarer == Side::Ambient {
            self.front.in_lanes()
        } else {
            None
        }
    }

    fn others(&self) -> impl Iterator<Item = &LevelledTable> {
        let others = [&self.through, &self.back, &self.beyond];
        others.into_iter().flatten().map(Box::as_ref)
    }

    #[cfg(test)]
    pub(super) fn front(&self) -> &LevelledTable {
        &self.front
    }

    /// Estimated time of the look-ups of a call from a side, ns.
    pub(super) fn cost_ns(&self, side: Side) -> f64 {
        let reflectance = match (&self.back, side) {
            (Some(table), Side::Base) => table.cost_ns(),
            _ => self.front.cost_ns(),
        };
        let mut below = reflectance + self.through.as_ref().map_or(0.0, |table| table.cost_ns());
        if side != self.rarer && self.ratio > 1.0 {
            let beyond = self.beyond.as_ref().map_or(0.0, |table| table.cost_ns());
            below = below.max(beyond) + ZONE_NS;
        }
        below
    }

    /// Bytes of all tables.
    pub(super) fn bytes(&self) -> usize {
        self.front.bytes() + self.others().map(LevelledTable::bytes).sum::<usize>()
    }

    /// The number of values and where they are, in words.
    pub(super) fn size(&self) -> String {
        match self.others().count() {
            0 => self.front.size(),
            count => format!("{} and {count} more", self.front.size()),
        }
    }

    #[inline(always)]
    fn zone(&self, side: Side, cos_theta: f32) -> Zone {
        if side == self.rarer || self.ratio == 1.0 {
            return Zone::Below(cos_theta.into());
        }
        let c = f64::from(cos_theta);
        // In this order of operations a small cosine keeps its digits between media of similar index.
        let rare_squared = (1.0 - self.ratio) + self.ratio * c * c;
        if rare_squared >= 0.0 {
            return Zone::Below(Cosine::of_f64(rare_squared.sqrt()));
        }
        let kappa = (-rare_squared / (self.ratio - 1.0)).sqrt();
        let part = c / (1.0 - 1.0 / self.ratio).sqrt();
        Zone::Beyond((kappa / (kappa + part)) as f32)
    }

    /// Reflectance from the ambient's side, not clipped.
    pub(super) fn reflectance<T: Thickness>(&self, cos_theta: f32, thickness: T) -> Rgb<f32> {
        match self.zone(Side::Ambient, cos_theta) {
            Zone::Below(c) => thickness.color(&self.front, c),
            Zone::Beyond(t) => self.reflectance_beyond(t, thickness),
        }
    }

    /// Reflectance and transmittance from either side, not clipped; of a film fitted with transmittance.
    pub(super) fn colors<T: Thickness>(&self, side: Side, cos_theta: f32, thickness: T) -> Colors {
        let c = match self.zone(side, cos_theta) {
            Zone::Below(c) => c,
            Zone::Beyond(t) => {
                return Colors {
                    reflectance: self.reflectance_beyond(t, thickness),
                    transmittance: [0.0; 3],
                };
            }
        };
        let reflectance = match (&self.back, side) {
            (Some(table), Side::Base) => thickness.color(table, c),
            _ => thickness.color(&self.front, c),
        };
        let transmittance = match &self.through {
            Some(table) => thickness.color(table, c),
            None => reflectance.map(|r| 1.0 - r),
        };
        Colors {
            reflectance,
            transmittance,
        }
    }

    fn reflectance_beyond<T: Thickness>(&self, t: f32, thickness: T) -> Rgb<f32> {
        let table = self.beyond.as_ref();
        table.map_or([1.0; 3], |table| thickness.color(table, t.into()))
    }
}

/// The half-space of the smaller index, and the square of the ratio of the indices. A base that is opaque counts as of
/// the same index.
#[inline(never)]
fn rarer_side(description: &FilmDescription) -> (Side, f64) {
    if description.is_base_opaque() {
        return (Side::Ambient, 1.0);
    }
    let [ambient, base] =
        [&description.ambient, &description.base].map(|medium| medium.index(MIDDLE_NM).re);
    let rarer = if ambient <= base {
        Side::Ambient
    } else {
        Side::Base
    };
    (rarer, (ambient.max(base) / ambient.min(base)).powi(2))
}
