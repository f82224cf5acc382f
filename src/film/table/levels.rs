//! Averages of a table over spreads of thickness.

use super::critical_axis::Cosine;
use super::film_table::FilmTable;
use super::nodes;
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::film::spread::average::Fringes;
use crate::film::spread::cut_normal::{CutNormal, ORDERS};
use crate::num::Rgb;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};

/// A thickness within its range and the standard deviation around it, above 0, nm.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct Spread {
    pub thickness_nm: f32,
    pub deviation_nm: f32,
}

/// The averages of a table.
///
/// Up to a deviation at which its error is measured to be small, a Gauss rule of the cut distribution averages the
/// table itself: 3, 5 or 7 nodes, and until fringes have faded 24 or 64. Beyond, tables of averages at fixed deviations
/// are interpolated. They are averages of the fitted table, because those of the series differ by less than the table
/// does, and cost a hundred times as much. The cut is in them, and they become smoother with the deviation, so that each
/// is smaller than the one before.
///
/// Levels come in groups of three, of which neighbours share one, and a parabola over the logarithm of the deviation
/// goes through each group: it is continuous. Groups are as wide as the error of the parabola allows.
#[derive(Clone, Debug)]
pub(super) struct Levels {
    pub fringes: Fringes,
    pub rules: Box<CutNormal>,
    /// The greatest deviation for each rule, nm.
    pub limits: [f32; ORDERS],
    /// An odd number, or none.
    pub levels: Vec<SpreadLevel>,
}

#[derive(Clone, Debug)]
pub(super) struct SpreadLevel {
    /// The logarithm of the deviation in nm.
    pub ln_nm: f32,
    pub table: FilmTable,
}

/// The greatest number of levels, and the greatest deviation, nm, of a film that is loaded.
const MOST_LOADED: usize = 1 << 8;
const MOST_NM: f64 = 1e12;

impl Levels {
    pub fn save(&self, block: &mut ByteWriter) {
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

    pub fn load(block: &mut ByteReader<'_>, description: &FilmDescription) -> Result<Self, Error> {
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

    /// The number of levels.
    pub fn count(&self) -> usize {
        self.levels.len()
    }

    pub fn bytes(&self) -> usize {
        let tables = self.levels.iter().map(|level| level.table.bytes());
        size_of::<Self>() + size_of::<CutNormal>() + tables.sum::<usize>()
    }

    pub fn at(&self, base: &FilmTable, cosine: Cosine<f32>, spread: Spread) -> Rgb<f32> {
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
    pub fn by_rule(
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
        let mut thicknesses = [0.0; nodes::MOST];
        for (d, (node, _)) in thicknesses.iter_mut().zip(rule.iter()) {
            *d = (thickness_nm + node * deviation_nm).clamp(least, greatest);
        }
        let mut colors = [[0.0; 3]; nodes::MOST];
        nodes::colors(base, cosine, &thicknesses[..rule.count()], &mut colors);
        let mut sum = [0.0; 3];
        for ((_, weight), found) in rule.iter().zip(&colors) {
            for channel in 0..3 {
                sum[channel] += weight * found[channel];
            }
        }
        sum
    }
}

/// The average of a table by many nodes.
pub(super) fn average(
    fringes: &Fringes,
    base: &FilmTable,
    cosine: Cosine<f32>,
    thickness_nm: f64,
    deviation_nm: f64,
) -> Rgb<f64> {
    let [least, greatest] = fringes.range.map(|nm| nm as f32);
    let mut colors = [[0.0; 3]; nodes::MOST];
    let mut rounded = [0.0; nodes::MOST];
    let found = fringes.average_of_many(thickness_nm, deviation_nm, &mut |thicknesses, found| {
        let rounded = &mut rounded[..thicknesses.len()];
        for (d, t) in rounded.iter_mut().zip(thicknesses) {
            *d = (*t as f32).clamp(least, greatest);
        }
        nodes::colors(base, cosine, rounded, &mut colors);
        for (found, color) in found.iter_mut().zip(&colors) {
            found.reflectance = color.map(f64::from);
        }
    });
    found.reflectance
}

/// The weights of the values at three places in the parabola through them (Lagrange).
pub(super) fn parabola([a, b, c]: [f32; 3], at: f32) -> [f32; 3] {
    let weight = |x: f32, y: f32, own: f32| (at - x) * (at - y) / ((own - x) * (own - y));
    [weight(b, c, a), weight(a, c, b), weight(a, b, c)]
}
