//! The tables of a film, for light from either side.

use super::FilmDescription;
use super::compiled::{Colors, Evaluator};
use super::fit::{self, Errors, Limits, Task};
use super::series::{Column, Powers, Series};
use super::table::{Curve, Table};
use crate::error::Error;
use crate::num::{Lane, Rgb};
use crate::optics::stack::Side;

/// The wavelength whose indices decide where total reflection begins and which way fringes lean, nm:
/// near the eye's greatest sensitivity.
const MIDDLE_NM: f64 = 550.0;

/// Colours over the cosine, and over the thickness if one varies.
#[derive(Clone, Debug)]
pub(super) enum Sheet {
    Curve(Curve),
    Table(Table),
}

/// Reflectance and transmittance from both sides; from the base only if neither half-space disperses.
///
/// Tables are over the cosine in the rarer half-space, in which all of them are smooth; the
/// transmittance is the same from both sides. Beyond the critical angle, which only the denser side
/// has, nothing is transmitted, and what is reflected has a table of its own, over
/// kappa / (kappa + cos) with both in units of their greatest value, kappa the decay in the rarer side.
#[derive(Clone, Debug)]
pub(super) struct Sheets {
    /// The square of the ratio of indices, denser over rarer; and which is rarer.
    ratio: f64,
    rarer: Side,
    front: Sheet,
    /// None: 1 - `front`, as nothing absorbs.
    through: Option<Sheet>,
    /// From the base. None: as `front`.
    back: Option<Sheet>,
    /// None: 1.
    beyond: Option<Sheet>,
}

/// Where a direction lies.
enum Zone {
    /// The cosine in the rarer half-space.
    Below(f64),
    /// Beyond the critical angle.
    Beyond(f64),
}

impl Sheet {
    #[inline(always)]
    pub(super) fn at(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        match self {
            Self::Curve(curve) => f32::channels(curve.at(cos_theta)),
            Self::Table(table) => f32::channels(table.at(cos_theta, thickness_nm)),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::Curve(curve) => curve.bytes(),
            Self::Table(table) => table.bytes(),
        }
    }

    /// In words, for the plan.
    pub(super) fn size(&self) -> String {
        match self {
            Self::Curve(curve) => format!("{} values over the cosine", curve.count()),
            Self::Table(table) => {
                let [width, height] = table.counts();
                format!("{width} x {height} values over cosine and thickness")
            }
        }
    }
}

/// The series, with the column last asked for.
struct Sampler<'a> {
    series: &'a Series,
    column: Option<(Side, f64, Column<'a>)>,
}

impl Sampler<'_> {
    fn at(&mut self, side: Side, cos_theta: f64, thickness_nm: f64) -> Powers {
        if !matches!(&self.column, Some((s, c, _)) if *s == side && *c == cos_theta) {
            self.column = Some((side, cos_theta, self.series.column(side, cos_theta)));
        }
        match &self.column {
            Some((_, _, column)) => column.at(thickness_nm),
            None => Powers::default(),
        }
    }
}

impl Sheets {
    /// Fitted to a series; none if the limits cannot be met.
    pub(super) fn fit(
        description: &FilmDescription,
        series: &Series,
        limits: Limits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let is_opaque = description.base.absorbs();
        let [ambient, base] =
            [&description.ambient, &description.base].map(|medium| medium.index(MIDDLE_NM).re);
        let rarer = if is_opaque || ambient <= base {
            Side::Ambient
        } else {
            Side::Base
        };
        let disperses = description.disperses();
        // Where every wavelength has a critical angle of its own, colours are not smooth.
        if disperses && rarer == Side::Base {
            return Ok(None);
        }
        let keeps_base = description.transmittance && !disperses;
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
        let mut sampler = Sampler {
            series,
            column: None,
        };
        let mut errors = Errors::default();
        let mut sheet = |source: &mut fit::Source<'_>, index: Option<f64>| {
            let fitted = sheet(description, source, index, limits)?;
            if let Some((_, found)) = &fitted {
                errors.merge(found);
            }
            Ok::<_, Error>(fitted.map(|(sheet, _)| sheet))
        };
        // The cosine on a side for one in the rarer half-space.
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

        let mut reflectance = |side: Side| {
            sheet(
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
            through = sheet(
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
            beyond = sheet(
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
        let sheets = Self {
            ratio,
            rarer,
            front,
            through,
            back,
            beyond,
        };
        Ok(Some((sheets, errors)))
    }

    /// The table of the reflectance from the ambient's side alone, if that is over its own cosine. It is
    /// not copied, as there may be no room for a second one.
    pub(super) fn into_simple(self: Box<Self>) -> Result<Sheet, Box<Self>> {
        if self.rarer == Side::Ambient {
            Ok(self.front)
        } else {
            Err(self)
        }
    }

    pub(super) fn bytes(&self) -> usize {
        let others = [&self.through, &self.back, &self.beyond];
        self.front.bytes()
            + others
                .into_iter()
                .flatten()
                .map(Sheet::bytes)
                .sum::<usize>()
    }

    /// In words, for the plan.
    pub(super) fn size(&self) -> String {
        let others = [&self.through, &self.back, &self.beyond];
        match others.into_iter().flatten().count() {
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
        // Keeps the digits of a small cosine between like media.
        let rare_squared = (1.0 - self.ratio) + self.ratio * c * c;
        if rare_squared >= 0.0 {
            return Zone::Below(rare_squared.sqrt());
        }
        let kappa = (-rare_squared / (self.ratio - 1.0)).sqrt();
        let part = c / (1.0 - 1.0 / self.ratio).sqrt();
        Zone::Beyond(kappa / (kappa + part))
    }
}

impl Evaluator for Sheets {
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        match self.zone(Side::Ambient, cos_theta) {
            Zone::Below(c) => self.front.at(c as f32, thickness_nm),
            Zone::Beyond(t) => beyond(&self.beyond, t, thickness_nm),
        }
    }

    fn colors(&self, side: Side, cos_theta: f32, thickness_nm: f32) -> Colors {
        let c = match self.zone(side, cos_theta) {
            Zone::Below(c) => c as f32,
            Zone::Beyond(t) => {
                return Colors {
                    reflectance: beyond(&self.beyond, t, thickness_nm),
                    transmittance: [0.0; 3],
                };
            }
        };
        let reflectance = match (&self.back, side) {
            (Some(sheet), Side::Base) => sheet.at(c, thickness_nm),
            _ => self.front.at(c, thickness_nm),
        };
        let transmittance = match &self.through {
            Some(sheet) => sheet.at(c, thickness_nm),
            None => reflectance.map(|r| 1.0 - r),
        };
        Colors {
            reflectance,
            transmittance,
        }
    }
}

fn beyond(sheet: &Option<Sheet>, t: f64, thickness_nm: f32) -> Rgb<f32> {
    let table = sheet.as_ref();
    table.map_or([1.0; 3], |sheet| sheet.at(t as f32, thickness_nm))
}

/// Over the cosine in a medium of that index.
fn sheet(
    description: &FilmDescription,
    source: &mut fit::Source<'_>,
    index: Option<f64>,
    limits: Limits,
) -> Result<Option<(Sheet, Errors)>, Error> {
    let Some(varying) = description.varying() else {
        let fitted = fit::curve(source, limits)?;
        return Ok(fitted.map(|fitted| (Sheet::Curve(fitted.table), fitted.errors)));
    };
    let layer = &description.layers[varying];
    let inside = layer.medium.index(MIDDLE_NM);
    // Upright fringes, unless the film is a metal, in which there are none.
    let tilt = index.map_or(0.0, |index| {
        if inside.im > inside.re {
            0.0
        } else {
            (index / inside.re).powi(2).min(GREATEST_TILT)
        }
    });
    let mut task = Task {
        source,
        range: layer.thickness_nm,
        tilt,
        is_costly: description.layers.len() > 1,
        limits,
    };
    let fitted = fit::table(&mut task)?;
    Ok(fitted.map(|fitted| (Sheet::Table(fitted.table), fitted.errors)))
}

/// Below 1, so that thicknesses stay finite where light in the film goes along it.
const GREATEST_TILT: f64 = 0.9;
