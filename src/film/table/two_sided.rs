//! The tables of a film, for light from either side.

use super::axes::LEAST_NM;
use super::errors::Errors;
use super::fit::{self, Fitted};
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits, FitTask};
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::fringe_series::series::{FringeSeries, SeriesAtAngle};
use crate::num::{Lane, Rgb};
use crate::optics::stack::Side;

/// The wavelength whose indices decide where total reflection begins and how fringes bend, nm: near the
/// eye's greatest sensitivity.
const MIDDLE_NM: f64 = 550.0;
/// Below 1, so that thicknesses stay finite where light in the film goes along it.
const GREATEST_TILT: f64 = 0.9;

/// Reflectance and transmittance from both sides; from the base only if neither half-space disperses.
///
/// All tables are over the cosine in the rarer half-space, in which the colours are smooth; the
/// transmittance is the same from both sides. Beyond the critical angle, which only the denser side
/// has, nothing is transmitted, and the reflectance has a table of its own over kappa / (kappa + cos),
/// kappa the decay in the rarer half-space, both in units of their greatest value.
#[derive(Clone, Debug)]
pub(in crate::film) struct TwoSidedTables {
    /// The reflectance from the ambient's side.
    front: SplineTable,
    /// The square of the ratio of the denser index and the rarer one.
    ratio: f64,
    rarer: Side,
    /// The transmittance; `None`: 1 - reflectance, as nothing absorbs.
    through: Option<Box<SplineTable>>,
    /// The reflectance from the base's side; `None`: as `front`.
    back: Option<Box<SplineTable>>,
    /// The reflectance beyond the critical angle; `None`: 1.
    beyond: Option<Box<SplineTable>>,
}

/// The zone of a direction.
enum Zone {
    /// Below the critical angle, at this cosine in the rarer half-space.
    Below(f64),
    /// Beyond the critical angle, at this kappa / (kappa + cos).
    Beyond(f64),
}

/// A series that keeps the angle it was last evaluated at.
struct SeriesSampler<'a> {
    series: &'a FringeSeries,
    last: Option<(Side, f64, SeriesAtAngle<'a>)>,
}

impl SeriesSampler<'_> {
    fn at(&mut self, side: Side, cos_theta: f64, thickness_nm: f64) -> Colors<f64> {
        if !matches!(&self.last, Some((s, c, _)) if *s == side && *c == cos_theta) {
            self.last = Some((side, cos_theta, self.series.at_angle(side, cos_theta)));
        }
        match &self.last {
            Some((_, _, at_angle)) => at_angle.at(thickness_nm),
            None => Colors::default(),
        }
    }
}

impl TwoSidedTables {
    /// Fits the tables to a series; `None` if the limits cannot be met.
    pub(in crate::film) fn fit(
        description: &FilmDescription,
        series: &FringeSeries,
        limits: FitLimits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let is_opaque = description.is_base_opaque();
        let [ambient, base] =
            [&description.ambient, &description.base].map(|medium| medium.index(MIDDLE_NM).re);
        let rarer = if is_opaque || ambient <= base {
            Side::Ambient
        } else {
            Side::Base
        };
        let disperses = description.disperses();
        // Colours are not smooth where every wavelength has its own critical angle, and what enters a base that
        // absorbs beyond it has no table.
        let is_tinted = description.is_base_tinted();
        if (disperses || is_tinted) && rarer == Side::Base {
            return Ok(None);
        }
        let keeps_base = description.transmittance && !disperses;
        if keeps_base && description.is_base_side_apart() {
            return Ok(None);
        }
        let denser = match rarer {
            Side::Ambient => Side::Base,
            Side::Base => Side::Ambient,
        };
        let ratio = if is_opaque {
            1.0
        } else {
            (ambient.max(base) / ambient.min(base)).powi(2)
        };
        let rare_index = if rarer == Side::Ambient {
            ambient
        } else {
            base
        };
        let mut sampler = SeriesSampler { series, last: None };
        let mut errors = Errors::default();
        let mut fitted = |source: &mut ColorSource<'_>, index: Option<f64>| {
            let fitted = fitted(description, source, index, limits)?;
            if let Some((_, found)) = &fitted {
                errors.merge(found);
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
            .any(|layer| layer.medium.absorbs())
            || is_tinted;
        let is_lossless = !absorbs && !is_opaque;

        let mut reflectance = |side: Side| {
            fitted(
                &mut |c, d| sampler.at(side, cosine(side, c), d).reflectance,
                Some(rare_index),
            )
        };
        let Some(front) = reflectance(Side::Ambient)? else {
            return Ok(None);
        };
        let (mut back, mut through, mut beyond) = (None, None, None);
        if description.transmittance && absorbs {
            if !is_opaque && keeps_base {
                back = reflectance(Side::Base)?;
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
                Some(rare_index),
            )?;
            if through.is_none() {
                return Ok(None);
            }
        }
        let is_seen = denser == Side::Ambient || keeps_base;
        if !is_lossless && !is_opaque && ratio > 1.0 && is_seen {
            let critical = (1.0 - 1.0 / ratio).sqrt();
            beyond = fitted(
                &mut |t, d| {
                    let part = (1.0 - t) / (t * t + (1.0 - t) * (1.0 - t)).sqrt();
                    sampler.at(denser, critical * part, d).reflectance
                },
                None,
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

    /// The table of the reflectance from the ambient's side, if it is over the cosine there.
    #[inline(always)]
    pub(in crate::film) fn over_ambient_cosine(&self) -> Option<&SplineTable> {
        (self.rarer == Side::Ambient).then_some(&self.front)
    }

    fn others(&self) -> impl Iterator<Item = &SplineTable> {
        let others = [&self.through, &self.back, &self.beyond];
        others.into_iter().flatten().map(Box::as_ref)
    }

    /// Bytes of all tables.
    pub(in crate::film) fn bytes(&self) -> usize {
        self.front.bytes() + self.others().map(SplineTable::bytes).sum::<usize>()
    }

    /// The number of values and where they are, in words.
    pub(in crate::film) fn size(&self) -> String {
        match self.others().count() {
            0 => self.front.size(),
            count => format!("{} and {count} more", self.front.size()),
        }
    }

    #[inline(always)]
    fn zone(&self, side: Side, cos_theta: f32) -> Zone {
        let c = f64::from(cos_theta);
        if side == self.rarer {
            return Zone::Below(c);
        }
        // In this order of operations a small cosine keeps its digits between media of similar index.
        let rare_squared = (1.0 - self.ratio) + self.ratio * c * c;
        if rare_squared >= 0.0 {
            return Zone::Below(rare_squared.sqrt());
        }
        let kappa = (-rare_squared / (self.ratio - 1.0)).sqrt();
        let part = c / (1.0 - 1.0 / self.ratio).sqrt();
        Zone::Beyond(kappa / (kappa + part))
    }

    /// Reflectance from the ambient's side, not clipped.
    pub(in crate::film) fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        match self.zone(Side::Ambient, cos_theta) {
            Zone::Below(c) => color(&self.front, c, thickness_nm),
            Zone::Beyond(t) => self.reflectance_beyond(t, thickness_nm),
        }
    }

    /// Reflectance and transmittance from either side, not clipped; of a film fitted with transmittance.
    pub(in crate::film) fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        let c = match self.zone(side, cos_theta) {
            Zone::Below(c) => c,
            Zone::Beyond(t) => {
                return Colors {
                    reflectance: self.reflectance_beyond(t, thickness_nm),
                    transmittance: [0.0; 3],
                };
            }
        };
        let reflectance = match (&self.back, side) {
            (Some(table), Side::Base) => color(table, c, thickness_nm),
            _ => color(&self.front, c, thickness_nm),
        };
        let transmittance = match &self.through {
            Some(table) => color(table, c, thickness_nm),
            None => reflectance.map(|r| 1.0 - r),
        };
        Colors {
            reflectance,
            transmittance,
        }
    }

    fn reflectance_beyond(&self, t: f64, thickness_nm: f32) -> Rgb<f32> {
        let table = self.beyond.as_ref();
        table.map_or([1.0; 3], |table| color(table, t, thickness_nm))
    }
}

#[inline(always)]
fn color(table: &SplineTable, x: f64, thickness_nm: f32) -> Rgb<f32> {
    f32::channels(table.at(x as f32, thickness_nm))
}

/// The range of a table's thickness: its ends in single precision, in which it is looked up, and never so narrow
/// that steps per nm are beyond single precision.
fn table_range(thickness_nm: [f64; 2]) -> [f64; 2] {
    let [least, greatest] = thickness_nm.map(|x| f64::from(x as f32));
    [least, greatest.max(least + LEAST_NM)]
}

/// A table over the cosine in a medium of index `index`, or over kappa / (kappa + cos) if that is
/// `None`.
fn fitted(
    description: &FilmDescription,
    source: &mut ColorSource<'_>,
    index: Option<f64>,
    limits: FitLimits,
) -> Result<Option<Fitted>, Error> {
    let Some(varying) = description.varying() else {
        return fit::over_cosine(source, limits);
    };
    let layer = &description.layers[varying];
    let inside = layer.medium.index(MIDDLE_NM);
    // The fringes of a metal need not be made parallel to the axis.
    let tilt = index.map_or(0.0, |index| {
        if inside.im > inside.re {
            0.0
        } else {
            (index / inside.re).powi(2).min(GREATEST_TILT)
        }
    });
    fit::over_both(&mut FitTask {
        source,
        range: table_range(layer.thickness_nm),
        tilt,
        is_costly: description.layers.len() > 1,
        limits,
    })
}
