//! Chooses and fits the averages of a table.

use super::critical_axis::Cosine;
use super::errors::Errors;
use super::film_table::{FilmTable, Over};
use super::levels::{Levels, Spread, SpreadLevel, average, parabola};
use super::task::FitLimits;
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::film::spread::average::Fringes;
use crate::film::spread::cut_normal::{CutNormal, ORDERS};
use crate::num::Rgb;

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

impl Levels {
    /// The averages of a table.
    #[inline(never)]
    pub fn fit(
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
}
