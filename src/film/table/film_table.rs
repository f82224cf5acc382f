//! The colours of a film over the cosine in one medium, and over the thickness of the layer that varies.

use super::axes::LEAST_NM;
use super::critical::{Centre, MIDDLE_NM};
use super::critical_axis::{Cosine, CriticalAxis};
use super::errors::Errors;
use super::fit;
use super::lane_table::LaneTable;
use super::patches::Patches;
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits};
use super::warped::{Shape, Warped};
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::num::bytes::{ByteReader, ByteWriter};
use crate::num::{Lane, Rgb};

/// The greatest number of values of one spline around critical angles: patches need fewer where it would need more.
const MOST_WARPED: usize = 12_000;
/// Times in ns on one core of a 2024 server, fitted to those that `./x check film_cliffs` measures: of a look-up over the
/// cosine alone and over both coordinates, of the coordinate around critical angles and of each of them, and of the way to
/// a patch.
const OVER_COSINE_NS: f64 = 5.0;
const OVER_BOTH_NS: f64 = 13.0;
const COORDINATE_NS: f64 = 10.0;
const CENTRE_NS: f64 = 1.0;
const PATCH_NS: f64 = 20.0;
/// Below 1, so that thicknesses stay finite where light in the film goes along it.
const GREATEST_TILT: f64 = 0.9;

/// A table, with the coordinate of its cosines where that is not the cosine itself.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant)] // most tables are plain, and one pointer less is followed
pub(super) enum FilmTable {
    /// One spline over the cosine.
    Plain(SplineTable),
    /// One spline, or many, over a coordinate that spreads the critical angles.
    Warped(Box<Warped>),
}

/// How a saved table begins, by its kind.
const PLAIN: u8 = 0;
const WARPED: u8 = 1;
const PATCHES: u8 = 2;

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
            let plain = fit::of_film(description, source, range, tilt.min(GREATEST_TILT), limits)?;
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
    pub fn at(&self, cosine: Cosine<f32>, thickness_nm: f32) -> Rgb<f32> {
        match self {
            Self::Plain(spline) => f32::channels(spline.at(cosine.value(), thickness_nm)),
            Self::Warped(warped) => warped.at(cosine, thickness_nm),
        }
    }

    /// Whether both tables have one spline each, over the same coordinate.
    pub fn shares_axis(&self, other: &Self) -> bool {
        let warped = [self, other].map(|table| table.in_lanes()?.warped);
        matches!(warped, [Some(one), Some(other)] if one.axis.is_like(&other.axis))
    }

    /// The colours of two tables that share their axis: the coordinate is found once.
    #[inline(always)]
    pub fn both_at(tables: [&Self; 2], cosine: Cosine<f32>, thickness_nm: f32) -> [Rgb<f32>; 2] {
        if let [Self::Warped(one), Self::Warped(other)] = tables
            && let [Shape::Spline(first), Shape::Spline(second)] = [&one.shape, &other.shape]
        {
            let [x, path] = one.spline_arguments(cosine, thickness_nm, first);
            return [first.at(x, path), second.at(x, path)].map(f32::channels);
        }
        tables.map(|table| table.at(cosine, thickness_nm))
    }

    /// Estimated time of a look-up, ns.
    pub fn cost_ns(&self) -> f64 {
        match self {
            Self::Plain(spline) => spline_ns(spline),
            Self::Warped(warped) => {
                let centres = warped.axis.centres() as f64;
                let look_up = match &warped.shape {
                    Shape::Spline(spline) => spline_ns(spline),
                    Shape::Patches(_) => OVER_BOTH_NS + PATCH_NS,
                };
                COORDINATE_NS + centres * CENTRE_NS + look_up
            }
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

    /// The table for lanes; `None` for patches.
    pub fn in_lanes(&self) -> Option<LaneTable<'_>> {
        match self {
            Self::Plain(spline) => Some(LaneTable {
                warped: None,
                spline,
            }),
            Self::Warped(warped) => match &warped.shape {
                Shape::Spline(spline) => Some(LaneTable {
                    warped: Some(warped),
                    spline,
                }),
                Shape::Patches(_) => None,
            },
        }
    }

    pub fn save(&self, block: &mut ByteWriter) {
        match self {
            Self::Plain(spline) => {
                block.byte(PLAIN);
                spline.save(block);
            }
            Self::Warped(warped) => {
                let Warped {
                    axis,
                    range: _,
                    shape,
                } = &**warped;
                block.byte(match shape {
                    Shape::Spline(_) => WARPED,
                    Shape::Patches(_) => PATCHES,
                });
                axis.save(block);
                match shape {
                    Shape::Spline(spline) => spline.save(block),
                    Shape::Patches(patches) => patches.save(block),
                }
            }
        }
    }

    /// Reads a table of a film.
    pub fn load(block: &mut ByteReader<'_>, description: &FilmDescription) -> Result<Self, Error> {
        let range = table_range(description.varying_range());
        let kind = block.choice(&[PLAIN, WARPED, PATCHES])?;
        if kind == PLAIN {
            return Ok(Self::Plain(SplineTable::load(block, range)?));
        }
        let axis = CriticalAxis::load(block)?;
        let shape = if kind == WARPED {
            Shape::Spline(SplineTable::load(block, range)?)
        } else {
            Shape::Patches(Patches::load(block)?)
        };
        Ok(Self::Warped(Box::new(Warped { axis, range, shape })))
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

fn spline_ns(spline: &SplineTable) -> f64 {
    if spline.is_over_cosine() {
        OVER_COSINE_NS
    } else {
        OVER_BOTH_NS
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
