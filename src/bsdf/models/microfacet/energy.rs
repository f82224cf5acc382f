//! The directional albedo of a microfacet lobe whose facets absorb nothing, in a table made at creation.
//!
//! Even with F = 1 a lobe loses the light that masking takes away. Kulla and Conty 2017 ("Revisiting
//! Physically Based Shading at Imageworks") add that light back, and Kelemen and Szirmay-Kalos 2001 give
//! the light that the highlight does not reflect to a diffuse part. Both need the lobe's albedo E(wo) and
//! its mean over the hemisphere. Schlick's Fresnel factor is linear in F0 and F90, so that two numbers are
//! enough for every colour:
//!
//! E(F0, F90) = F0 (whole - grazing) + F90 grazing,
//!
//! where `grazing` is the albedo under F = (1 - <wo, h>)^5 (the two moments of the split-sum
//! approximation: Karis 2013, "Real Shading in Unreal Engine 4").
//!
//! **Table.** A quadratic spline through the values at 14 roughnesses and 20 cosines mu. The roughnesses
//! are at equal steps of the cube root of alpha. The cosines are at equal steps of sqrt((1 + c) mu / (mu +
//! c)) with c = 4 alpha, because E has its greatest curvature at cosines of about alpha, and for large
//! alpha behaves like mu log(mu) at the horizon. For `grazing` the table has the difference from E (1 -
//! mu)^5, its limit for alpha = 0, which is as smooth in these coordinates as E. For `whole` it has 1 - E,
//! computed in double precision, because that is what compensation adds, and of 1 - E = 1e-6 single
//! precision would keep one digit.
//!
//! **Error** against quadrature: at most 1e-3 for GGX with height-correlated masking, alpha in [1e-4, 1]
//! and every cosine (`tests` below). Results are clamped to 0 <= grazing <= whole <= 1, because the spline
//! may exceed these bounds by its error.
//!
//! **Cost**: 105,560 samples of the lobe for a table of all alphas, 7,540 for one alpha.

use super::half_vector::HalfVector;
use super::masking::Masking;
use super::ndf::Ndf;
use crate::bsdf::precision::Precision;
use crate::num::spline::{controls, weights};
use crate::num::{INDEX_BIAS, Lane, Real, Rgb, TableBlock, TableEntry, Vec3, each};

/// The numbers of values along the cosine and, in a table of all alphas, along alpha.
const COSINES: usize = 20;
const ALPHAS: usize = 14;
/// The number of control points for one alpha.
const STRIDE: usize = COSINES + 2;

/// The least alpha of a table.
pub(crate) const LEAST_ALPHA: f64 = 1e-4;

/// c / alpha for the c of the coordinate along the cosine.
const BEND: f64 = 4.0;

/// A Fibonacci lattice as in `bsdf/quadrature.rs`, but smaller.
const NODES: u32 = 377;
const GENERATOR: u32 = 233;

/// The number of midpoints for the mean over the hemisphere. The error of the mean is below 1e-5.
const MEAN_NODES: u32 = 256;

/// The albedo of a lobe for two Fresnel factors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Albedo<T> {
    /// The albedo with F = 1.
    pub whole: T,
    /// 1 - `whole`, with all of its digits.
    pub lost: T,
    /// The albedo with F = (1 - <wo, h>)^5, the factor of F90.
    pub grazing: T,
}

impl<T: Real> Albedo<T> {
    /// The albedo with Schlick's F, which is `f0` at normal incidence and `f90` at grazing incidence.
    #[inline(always)]
    pub fn under_schlick(&self, f0: T, f90: T) -> T {
        f0 * (self.whole - self.grazing) + f90 * self.grazing
    }
}

/// A sample of a lobe.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reflected<T> {
    /// value / pdf with F = 1; 0 where there is no valid direction.
    pub weight: T,
    /// <wo, h>
    pub cos_half: T,
}

impl<T: Lane> Reflected<T> {
    /// Samples the lobe by the normals of the distribution.
    #[inline(always)]
    pub fn by_ndf<N: Ndf<T>>(
        ndf: &N,
        masking: Masking,
        alpha: [T; 2],
        wo: Vec3<T>,
        u: [T; 2],
    ) -> Self {
        let zero = T::new(0.0);
        let wi = wo.mirrored_about(ndf.sample(wo, u));
        let is_above = wi.z.gt(zero);
        let pair = HalfVector::new(wo, Vec3::select(is_above, wi, wo));
        let d = ndf.density_between(&pair);
        let density = ndf.reflected_density(&pair, d);
        let value = d * masking.factor(masking.of_ndf(ndf, &pair), alpha, &pair);
        let is_usable = is_above & density.gt(zero);
        let weight = value / T::select(is_usable, density, T::new(1.0));
        Self {
            weight: T::select(is_usable, weight, zero),
            cos_half: pair.cos_half,
        }
    }
}

/// The table of one lobe.
#[derive(Clone, Debug)]
pub(crate) struct Energy<T> {
    /// Control points: `lost`, the difference for `grazing`, and fillers. A row has the points of one
    /// alpha; there is one row, or [`ALPHAS`] + 2.
    points: Box<[TableEntry<T>]>,
    /// Control points of the means over the hemisphere, one per row; with one row three equal ones.
    means: Box<[TableEntry<T>]>,
    /// Whether the table has one row, for one alpha.
    is_fixed: bool,
}

impl Energy<f64> {
    /// The table for all alphas in [1e-4, 1]. `lobe` samples the lobe of an alpha for a viewer in the plane
    /// y = 0; u\[0\] must be the azimuth of its sample.
    pub fn over_alpha(lobe: impl Fn(f64, Vec3<f64>, [f64; 2]) -> Reflected<f64>) -> Self {
        let lattice = lattice();
        let alphas: [f64; ALPHAS] = std::array::from_fn(|row| {
            let part = row as f64 / (ALPHAS - 1) as f64;
            let root = LEAST_ALPHA.cbrt() * (1.0 - part) + part;
            root.powi(3)
        });
        let rows = alphas.map(|alpha| row_of(alpha, &lattice, &lobe));
        let mut energy = Self {
            points: along_alpha(&rows),
            means: vec![TableEntry::new([0.0; 3]); ALPHAS + 2].into(),
            is_fixed: false,
        };
        let means = alphas.map(|alpha| vec![energy.mean(alpha)]);
        energy.means = along_alpha(&means);
        energy
    }

    /// The table for one alpha.
    pub fn of_alpha(alpha: f64, lobe: impl Fn(Vec3<f64>, [f64; 2]) -> Reflected<f64>) -> Self {
        let row = row_of(alpha, &lattice(), &|_, wo, u| lobe(wo, u));
        let mut energy = Self {
            points: row.into_iter().map(TableEntry::new).collect(),
            means: [TableEntry::new([0.0; 3]); 3].into(),
            is_fixed: true,
        };
        let mean = TableEntry::new(energy.mean(alpha));
        energy.means = [mean; 3].into();
        energy
    }

    /// The table in another precision.
    pub fn rounded<T: Precision>(&self) -> Energy<T> {
        let round = |entries: &[TableEntry<f64>]| {
            let rounded = entries.iter().map(|entry| entry.cast(T::new));
            rounded.collect()
        };
        Energy {
            points: round(&self.points),
            means: round(&self.means),
            is_fixed: self.is_fixed,
        }
    }

    /// The mean of the albedo over the hemisphere, which is the integral of 2 mu E(mu) over mu in [0, 1],
    /// by the midpoint rule in sqrt(mu), in which E is smooth at the horizon.
    fn mean(&self, alpha: f64) -> Rgb<f64> {
        let row = self.row(alpha);
        let mut sum = [0.0; 3];
        for i in 0..MEAN_NODES {
            let root = (f64::from(i) + 0.5) / f64::from(MEAN_NODES);
            let weight = 4.0 * root.powi(3) / f64::from(MEAN_NODES);
            let albedo = self.albedo(&row, root * root);
            sum[0] += weight * albedo.lost;
            sum[1] += weight * albedo.grazing;
        }
        sum
    }
}

impl<T: Precision> Energy<T> {
    /// The row of the table at an alpha in [1e-4, 1]. For a table of one alpha it must be that alpha.
    #[inline(always)]
    pub fn row<L: Lane<Scalar = T>>(&self, alpha: L) -> Row<L> {
        let (first, along) = if self.is_fixed {
            (L::new(INDEX_BIAS), weights(L::new(0.0)))
        } else {
            let least = L::new(LEAST_ALPHA.cbrt());
            let step = L::new((ALPHAS - 1) as f64 / (1.0 - LEAST_ALPHA.cbrt()));
            let root = (alpha.ln() * L::new(1.0 / 3.0)).exp();
            let (nearest, distance) = nearest((root - least) * step, ALPHAS);
            (nearest, weights(distance))
        };
        let [lost, grazing, _] = L::channels(L::weighted_row(&self.means, first, along));
        Row {
            first,
            along,
            bend: alpha * L::new(BEND),
            mean: Albedo {
                whole: L::new(1.0) - lost,
                lost,
                grazing,
            },
        }
    }

    /// The albedo at the alpha of `row` for a viewer at the cosine `cos_theta`.
    #[inline(always)]
    pub fn albedo<L: Lane<Scalar = T>>(&self, row: &Row<L>, cos_theta: L) -> Albedo<L> {
        let (zero, one) = (L::new(0.0), L::new(1.0));
        let x = ((one + row.bend) * cos_theta / (cos_theta + row.bend)).sqrt();
        let (nearest, distance) = nearest(x * L::new((COSINES - 1) as f64), COSINES);
        let across = weights(distance);
        let sum = if self.is_fixed {
            L::weighted_row(&self.points, nearest, across)
        } else {
            let block = TableBlock {
                first: [nearest, row.first],
                across,
                along: row.along,
            };
            L::weighted_block(&self.points, STRIDE, block)
        };
        let [lost, difference, _] = L::channels(sum);
        let lost = lost.max(zero).min(one);
        let whole = one - lost;
        let smooth = whole * (one - cos_theta).pow5();
        let grazing = (smooth + difference).max(zero).min(whole);
        Albedo {
            whole,
            lost,
            grazing,
        }
    }
}

/// A table at one alpha.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<T> {
    /// The index of the first of the three rows of control points around alpha, and the weights of these
    /// rows.
    first: T,
    along: [T; 3],
    bend: T,
    /// The mean over the hemisphere, weighted by the cosine.
    pub mean: Albedo<T>,
}

impl<T: Lane<Scalar = T>> Row<T> {
    /// The same row in every lane.
    #[inline(always)]
    pub fn splat<L: Lane<Scalar = T>>(&self) -> Row<L> {
        Row {
            first: L::splat(self.first),
            along: each!(self.along, |weight| L::splat(weight)),
            bend: L::splat(self.bend),
            mean: Albedo {
                whole: L::splat(self.mean.whole),
                lost: L::splat(self.mean.lost),
                grazing: L::splat(self.mean.grazing),
            },
        }
    }
}

/// The whole number in [0, count) that is nearest to a position, plus [`INDEX_BIAS`], and the distance of
/// the position from it.
#[inline(always)]
fn nearest<T: Real>(position: T, count: usize) -> (T, T) {
    let index = position.round().max(T::new(0.0));
    let index = index.min(T::new((count - 1) as f64));
    (index + T::new(INDEX_BIAS), position - index)
}

/// The nodes of the mean over the two random numbers of a lobe, with their weights. The first number is the
/// azimuth. The second is 1 - (1 - t)^2 of a lattice coordinate t, because lobes end at the horizon, where
/// that number is 1.
fn lattice() -> Vec<([f64; 2], f64)> {
    let nodes = (0..NODES).map(|i| {
        let t = (f64::from(i) + 0.5) / f64::from(NODES);
        let azimuth = (f64::from(i * GENERATOR % NODES) + 0.25) / f64::from(NODES);
        let weight = 2.0 * (1.0 - t) / f64::from(NODES);
        let u = [azimuth, 1.0 - (1.0 - t).powi(2)];
        (u, weight)
    });
    nodes.collect()
}

/// The control points for one alpha.
fn row_of(
    alpha: f64,
    lattice: &[([f64; 2], f64)],
    lobe: &impl Fn(f64, Vec3<f64>, [f64; 2]) -> Reflected<f64>,
) -> Vec<Rgb<f64>> {
    let bend = alpha * BEND;
    let values: Vec<Rgb<f64>> = (0..COSINES)
        .map(|i| {
            // At the horizon itself E is a limit, so the first node is close to it.
            let x = (i as f64 / (COSINES - 1) as f64).max(1e-3).powi(2);
            let cosine = (bend * x / (1.0 + bend - x)).min(1.0);
            let wo = Vec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
            let (mut whole, mut grazing) = (0.0, 0.0);
            for (u, weight) in lattice {
                let reflected = lobe(alpha, wo, *u);
                let part = reflected.weight * weight;
                whole += part;
                grazing += part * (1.0 - reflected.cos_half).powi(5);
            }
            let difference = grazing - whole * (1.0 - cosine).powi(5);
            [1.0 - whole, difference, difference]
        })
        .collect();
    let mut points = Vec::new();
    controls(&values, &mut points);
    points
}

/// The control points along alpha, for every column of [`ALPHAS`] rows.
fn along_alpha(rows: &[Vec<Rgb<f64>>; ALPHAS]) -> Box<[TableEntry<f64>]> {
    let width = rows[0].len();
    let mut points = vec![TableEntry::new([0.0; 3]); (ALPHAS + 2) * width];
    let mut fitted = Vec::new();
    for column in 0..width {
        let values: Vec<Rgb<f64>> = rows.iter().map(|row| row[column]).collect();
        controls(&values, &mut fitted);
        for (row, point) in fitted.iter().enumerate() {
            points[row * width + column] = TableEntry::new(*point);
        }
    }
    points.into()
}

#[cfg(test)]
mod tests;
