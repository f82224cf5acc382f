//! A table, and its averages over spreads of thickness.

use super::critical_axis::Cosine;
use super::errors::Errors;
use super::film_table::{FilmTable, LaneTable, Over};
use super::spline::SplineTable;
use super::task::{ColorSource, FitLimits};
use crate::error::Error;
use crate::film::colors::Colors;
use crate::film::description::FilmDescription;
use crate::film::spread::average::Fringes;
use crate::film::spread::cut_normal::{CutNormal, ORDERS};
use crate::num::Rgb;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};

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

/// A thickness within its range and the standard deviation around it, above 0, nm.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct Spread {
    pub thickness_nm: f32,
    pub deviation_nm: f32,
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

/// The averages of a table.
///
/// Up to a deviation at which its error is measured to be small, a Gauss rule of the cut distribution averages the
/// table itself: 3, 5 or 7 nodes, and until fringes have faded 24 or 64. Beyond, tables of averages at fixed deviations
/// are interpolated. They are averages of the fitted table, because those of the series differ by less than the table does, and cost a hundredth. The
/// cut is in them, and they become smoother with the deviation, so that each is smaller than the one before.
///
/// Levels come in groups of three, of which neighbours share one, and a parabola over the logarithm of the deviation
/// goes through each group: it is continuous. Groups are as wide as the error of the parabola allows.
#[derive(Clone, Debug)]
struct Levels {
    fringes: Fringes,
    rules: Box<CutNormal>,
    /// The greatest deviation for each rule, nm.
    limits: [f32; ORDERS],
    /// An odd number, or none.
    levels: Vec<SpreadLevel>,
}

#[derive(Clone, Debug)]
struct SpreadLevel {
    /// The logarithm of the deviation in nm.
    ln_nm: f32,
    table: FilmTable,
}

/// The greatest number of levels, and the greatest deviation, nm, of a film that is loaded.
const MOST_LOADED: usize = 1 << 8;
const MOST_NM: f64 = 1e12;
/// Parts of the tolerance: the errors allowed of a rule and of a parabola between levels, at the points that are
/// tried, and the tolerance of a level's own fit, of which it uses half.
const RULE: f64 = 0.2;
const PARABOLA: f64 = 0.35;
const LEVEL: f64 = 0.7;
/// The numbers of cosines and thicknesses that are tried.
const COSINES: usize = 7;
const THICKNESSES: usize = 9;
/// The ratio of the deviations that are tried for a rule, and the first one as a part of a fringe.
const RATIO: f64 = 1.25;
const FIRST: f64 = 0.02;
/// The greatest and the least distance of levels, as logarithms, and the ratio of those that are tried.
const WIDEST: f64 = 1.5;
const NARROWEST: f64 = 0.1;
const NARROWER: f64 = 0.8;
/// Where a parabola through levels at 0, 1 and 2 is farthest off.
const FARTHEST: [f64; 2] = [0.42, 1.58];
/// Deviations beyond this multiple of the range count as this one: the distribution is uniform to 1e-3.
const UNIFORM: f64 = 20.0;

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
        let levels = self.levels.as_deref().map_or(0, |levels| {
            let tables = levels.levels.iter().map(|level| level.table.bytes());
            size_of::<Levels>() + size_of::<CutNormal>() + tables.sum::<usize>()
        });
        self.base.bytes() + levels
    }

    /// The number of values and where they are, in words.
    pub fn size(&self) -> String {
        let levels = self
            .levels
            .as_deref()
            .map_or(0, |levels| levels.levels.len());
        match levels {
            0 => self.base.size(),
            _ => format!("{} with {levels} levels of spread", self.base.size()),
        }
    }
}

impl Levels {
    #[inline(never)]
    fn fit(
        description: &FilmDescription,
        base: &FilmTable,
        over: &Over,
        limits: FitLimits,
    ) -> Result<Self, Error> {
        let mut levels = Self {
            fringes: Fringes::new(description),
            rules: CutNormal::new(),
            limits: [0.0; ORDERS],
            levels: Vec::new(),
        };
        let [least, greatest] = levels.fringes.range;
        let most = description
            .thickness_spread_max_nm
            .min(UNIFORM * (greatest - least));
        let samples = levels.samples();
        for order in 0..ORDERS {
            levels.limits[order] = levels.limit(base, order, &samples, most, &limits);
        }
        let first = f64::from(levels.limits[ORDERS - 1]);
        if first >= most {
            return Ok(levels);
        }
        let level_limits = FitLimits {
            tolerance: LEVEL * limits.tolerance,
            ..limits
        };
        let steps = levels.steps(base, &samples, [first.ln(), most.ln()], &limits);
        for ln_nm in steps {
            let fringes = levels.fringes;
            let mut source =
                |c: f64, d: f64| average(&fringes, base, Cosine::of_f64(c), d, ln_nm.exp());
            let fitted = FilmTable::fit(description, &mut source, over.clone(), level_limits)?;
            let Some((table, _)) = fitted else {
                // Averages by many nodes are slower, but not wrong.
                levels.levels.clear();
                return Ok(levels);
            };
            let ln_nm = ln_nm as f32;
            levels.levels.push(SpreadLevel { ln_nm, table });
        }
        Ok(levels)
    }

    fn save(&self, block: &mut ByteWriter) {
        let Self {
            fringes: _,
            rules: _,
            limits,
            levels,
        } = self;
        block.numbers(&limits.map(f64::from));
        block.count(levels.len());
        for SpreadLevel { ln_nm, table } in levels {
            block.numbers(&[f64::from(*ln_nm)]);
            table.save(block);
        }
    }

    fn load(block: &mut ByteReader<'_>, description: &FilmDescription) -> Result<Self, Error> {
        let mut limits = [0.0; ORDERS];
        for limit in &mut limits {
            *limit = block.number_within("the deviation of a rule", [0.0, MOST_NM])? as f32;
        }
        let count = block.count(size_of::<f64>(), MOST_LOADED)?;
        if count != 0 && (count < 3 || count.is_multiple_of(2)) {
            return Err(unusable("its levels of spread are no groups of three"));
        }
        let mut levels: Vec<SpreadLevel> = Error::reserve(count, "a film's levels of spread")?;
        for _ in 0..count {
            let ln_nm =
                block.number_within("the deviation of a level", [-MOST_NM, MOST_NM])? as f32;
            if levels.last().is_some_and(|last| last.ln_nm >= ln_nm) {
                return Err(unusable("its levels of spread do not ascend"));
            }
            let table = FilmTable::load(block, description)?;
            levels.push(SpreadLevel { ln_nm, table });
        }
        Ok(Self {
            fringes: Fringes::new(description),
            rules: CutNormal::new(),
            limits,
            levels,
        })
    }

    /// Cosines and thicknesses at which errors are measured; the ends of the range are among them.
    fn samples(&self) -> Vec<(Cosine<f32>, f32)> {
        let [least, greatest] = self.fringes.range;
        let mut samples = Vec::new();
        for i in 0..COSINES {
            // Denser at grazing incidence.
            let c = ((i as f64 + 0.7) / (COSINES as f64 - 0.3)).powf(1.3);
            for j in 0..THICKNESSES {
                // Denser where films are thin and fringes strong.
                let part = (j as f64 / (THICKNESSES - 1) as f64).powf(1.5);
                samples.push((
                    Cosine::of_f64(c),
                    (least + part * (greatest - least)) as f32,
                ));
            }
        }
        samples
    }

    /// The greatest deviation at which a rule is exact enough, nm.
    fn limit(
        &self,
        base: &FilmTable,
        order: usize,
        samples: &[(Cosine<f32>, f32)],
        most: f64,
        limits: &FitLimits,
    ) -> f32 {
        let before = order
            .checked_sub(1)
            .map_or(0.0, |order| f64::from(self.limits[order]));
        let mut found = before.max(FIRST * self.fringes.period);
        while found < most {
            let next = found * RATIO;
            let is_exact = samples.iter().all(|&(c, d)| {
                let spread = Spread {
                    thickness_nm: d,
                    deviation_nm: next as f32,
                };
                let quick = self.by_rule(base, order, c, spread).map(f64::from);
                let truth = average(&self.fringes, base, c, f64::from(d), next);
                let mut errors = Errors::default();
                errors.add(quick, truth, limits.unclipped) <= RULE * limits.tolerance
            });
            if !is_exact {
                break;
            }
            found = next;
        }
        found as f32
    }

    /// The logarithms of the levels' deviations, from the first one to at least the last one.
    fn steps(
        &self,
        base: &FilmTable,
        samples: &[(Cosine<f32>, f32)],
        [first, last]: [f64; 2],
        limits: &FitLimits,
    ) -> Vec<f64> {
        let averages = |ln_nm: f64| -> Vec<Rgb<f64>> {
            let of = |&(c, d): &(Cosine<f32>, f32)| {
                average(&self.fringes, base, c, f64::from(d), ln_nm.exp())
            };
            samples.iter().map(of).collect()
        };
        let mut steps = vec![first];
        let mut start = (first, averages(first));
        let mut step = WIDEST.min(0.5 * (last - first)).max(NARROWEST);
        while start.0 < last {
            let (middle, end) = loop {
                let [middle, end] = [1.0, 2.0].map(|i| averages(start.0 + i * step));
                let is_exact = FARTHEST.into_iter().all(|part| {
                    let truth = averages(start.0 + part * step);
                    let weights = parabola([0.0, 1.0, 2.0], part as f32).map(f64::from);
                    truth.iter().enumerate().all(|(i, truth)| {
                        let found = std::array::from_fn(|c| {
                            weights[0] * start.1[i][c]
                                + weights[1] * middle[i][c]
                                + weights[2] * end[i][c]
                        });
                        let mut errors = Errors::default();
                        errors.add(found, *truth, limits.unclipped) <= PARABOLA * limits.tolerance
                    })
                });
                if is_exact || step <= NARROWEST {
                    break (start.0 + step, (start.0 + 2.0 * step, end));
                }
                step = (step * NARROWER).max(NARROWEST);
            };
            steps.extend([middle, end.0]);
            start = end;
            step = (step / NARROWER / NARROWER).min(WIDEST);
        }
        steps
    }

    fn at(&self, base: &FilmTable, cosine: Cosine<f32>, spread: Spread) -> Rgb<f32> {
        let deviation = spread.deviation_nm;
        if let Some(order) = self.limits.iter().position(|limit| deviation <= *limit) {
            return self.by_rule(base, order, cosine, spread);
        }
        if self.levels.is_empty() {
            let (d, deviation) = (f64::from(spread.thickness_nm), f64::from(deviation));
            return average(&self.fringes, base, cosine, d, deviation).map(|x| x as f32);
        }
        let last = self.levels.len() - 3;
        let ln_nm = deviation.ln().min(self.levels[last + 2].ln_nm);
        let mut first = 0;
        while first < last && self.levels[first + 2].ln_nm < ln_nm {
            first += 2;
        }
        let group = &self.levels[first..first + 3];
        let weights = parabola([0, 1, 2].map(|i| group[i].ln_nm), ln_nm);
        let mut sum = [0.0; 3];
        for (level, weight) in group.iter().zip(weights) {
            let found = level.table.at(cosine, spread.thickness_nm);
            for channel in 0..3 {
                sum[channel] += weight * found[channel];
            }
        }
        sum
    }

    /// The average by a rule over the table itself.
    fn by_rule(
        &self,
        base: &FilmTable,
        order: usize,
        cosine: Cosine<f32>,
        spread: Spread,
    ) -> Rgb<f32> {
        let [least, greatest] = self.fringes.range.map(|nm| nm as f32);
        let Spread {
            thickness_nm,
            deviation_nm,
        } = spread;
        let ends = [thickness_nm - least, greatest - thickness_nm].map(|nm| nm / deviation_nm);
        let rule = self.rules.rule(order, ends);
        let mut sum = [0.0; 3];
        for (node, weight) in rule.iter() {
            let d = (thickness_nm + node * deviation_nm).clamp(least, greatest);
            let found = base.at(cosine, d);
            for channel in 0..3 {
                sum[channel] += weight * found[channel];
            }
        }
        sum
    }
}

/// The average of a table by many nodes.
fn average(
    fringes: &Fringes,
    base: &FilmTable,
    cosine: Cosine<f32>,
    thickness_nm: f64,
    deviation_nm: f64,
) -> Rgb<f64> {
    let [least, greatest] = fringes.range.map(|nm| nm as f32);
    let found = fringes.average(thickness_nm, deviation_nm, &mut |t| {
        let found = base.at(cosine, (t as f32).clamp(least, greatest));
        Colors {
            reflectance: found.map(f64::from),
            transmittance: [0.0; 3],
        }
    });
    found.reflectance
}

/// The weights of the values at three places in the parabola through them (Lagrange).
fn parabola([a, b, c]: [f32; 3], at: f32) -> [f32; 3] {
    let weight = |x: f32, y: f32, own: f32| (at - x) * (at - y) / ((own - x) * (own - y));
    [weight(b, c, a), weight(a, c, b), weight(a, b, c)]
}
