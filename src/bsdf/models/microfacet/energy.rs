//! The directional albedo of a microfacet lobe that absorbs nothing, in a table made at creation.
//!
//! With F = 1 a lobe still loses what its masking takes away. Kulla and Conty 2017 ("Revisiting
//! Physically Based Shading at Imageworks") return that share, and Kelemen and Szirmay-Kalos 2001
//! leave to a diffuse part what the highlight has not reflected; both need the lobe's albedo E(wo)
//! and its mean over the hemisphere. Schlick's Fresnel term is linear in F0 and F90, so two numbers
//! serve every colour:
//!
//! E(F0, F90) = F0 (whole - grazing) + F90 grazing,
//!
//! where `grazing` is the albedo under F = (1 - <wo, h>)^5 (the two moments of the split-sum
//! approximation: Karis 2013, "Real Shading in Unreal Engine 4").
//!
//! **Table.** A quadratic spline through the values at 14 roughnesses and 20 cosines. Roughnesses lie
//! at equal steps of the cube root of alpha. Cosines lie at equal steps of
//! sqrt((1 + c) mu / (mu + c)) with c = 4 alpha: E bends where the cosine is about alpha, and for
//! great alpha like mu log(mu) at the horizon. Of `grazing` the table holds what differs from
//! E (1 - mu)^5, its limit for alpha = 0, which is as smooth in these coordinates as E.
//!
//! **Error** against quadrature: at most 1e-3 for GGX with height-correlated masking, alpha in
//! [1e-4, 1] and every cosine (`tests` below). Results are held to 0 <= grazing <= whole <= 1, which
//! the spline may leave by its error.
//!
//! **Cost**: 105,560 samples of the lobe for all alphas, 7,540 for one.

use super::half_vector::HalfVector;
use super::masking::Masking;
use super::ndf::Ndf;
use crate::bsdf::precision::Precision;
use crate::num::spline::{controls, weights};
use crate::num::{INDEX_BIAS, Lane, Real, Rgb, TableBlock, TableEntry, Vec3, each};

/// Values along the cosine and, if there is more than one, along alpha.
const COSINES: usize = 20;
const ALPHAS: usize = 14;
/// Control points of one alpha.
const STRIDE: usize = COSINES + 2;

/// The least alpha of a table; smoother lobes are mirrors.
pub(crate) const LEAST_ALPHA: f64 = 1e-4;

/// Cosine in units of alpha at which half of the coordinate's square is spent.
const BEND: f64 = 4.0;

/// The Fibonacci lattice of `bsdf/quadrature.rs`, smaller.
const NODES: u32 = 377;
const GENERATOR: u32 = 233;

/// Midpoints for the mean over the hemisphere; its error is below 1e-5.
const MEAN_NODES: u32 = 256;

/// Albedo of a lobe with F = 1, and with F = (1 - <wo, h>)^5.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Albedo<T> {
    /// F = 1.
    pub whole: T,
    /// F = (1 - <wo, h>)^5, the part of F90.
    pub grazing: T,
}

impl<T: Real> Albedo<T> {
    /// Under Schlick's F with reflectance `f0` at normal incidence and `f90` at grazing incidence.
    #[inline(always)]
    pub fn under_schlick(&self, f0: T, f90: T) -> T {
        f0 * (self.whole - self.grazing) + f90 * self.grazing
    }
}

/// What a lobe's sampler gives for one pair of random numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reflected<T> {
    /// value / pdf with F = 1; 0 where there is no direction.
    pub weight: T,
    /// <wo, h>
    pub cos_half: T,
}

impl<T: Lane> Reflected<T> {
    /// By the normals that the distribution draws.
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
    /// Control points by cosine: `whole`, the difference of `grazing`, and fillers. Rows of equal
    /// alpha, one or [`ALPHAS`] + 2.
    points: Box<[TableEntry<T>]>,
    /// Control points of the means over the hemisphere, one per row; with one row thrice the same.
    means: Box<[TableEntry<T>]>,
    /// Whether there is one row.
    is_fixed: bool,
}

impl<T: Precision> Energy<T> {
    /// For every alpha in [1e-4, 1]. `lobe` samples the lobe of an alpha for a viewer in the plane
    /// y = 0, with u\[0\] as its azimuth.
    pub fn over_alpha(lobe: impl Fn(T, Vec3<T>, [T; 2]) -> Reflected<T>) -> Self {
        let lattice = lattice();
        let alphas: [f64; ALPHAS] = std::array::from_fn(|row| {
            let part = row as f64 / (ALPHAS - 1) as f64;
            let root = LEAST_ALPHA.cbrt() * (1.0 - part) + part;
            root.powi(3)
        });
        let rows = alphas.map(|alpha| row_of(T::new(alpha), &lattice, &lobe));
        let mut energy = Self {
            points: along_alpha(&rows),
            means: vec![TableEntry::new([T::new(0.0); 3]); ALPHAS + 2].into(),
            is_fixed: false,
        };
        let means = alphas.map(|alpha| vec![energy.mean(T::new(alpha))]);
        energy.means = along_alpha(&means);
        energy
    }

    /// For one alpha.
    pub fn of_alpha(alpha: T, lobe: impl Fn(Vec3<T>, [T; 2]) -> Reflected<T>) -> Self {
        let row = row_of(alpha, &lattice(), &|_, wo, u| lobe(wo, u));
        let mut energy = Self {
            points: row.into_iter().map(packed).collect(),
            means: [TableEntry::new([T::new(0.0); 3]); 3].into(),
            is_fixed: true,
        };
        let mean = packed(energy.mean(alpha));
        energy.means = [mean; 3].into();
        energy
    }

    /// Where the table has one alpha: within [1e-4, 1], or the one it was made for.
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
        let [whole, grazing, _] = L::channels(L::weighted_row(&self.means, first, along));
        Row {
            first,
            along,
            bend: alpha * L::new(BEND),
            mean: Albedo { whole, grazing },
        }
    }

    /// The albedo at the alpha of `row` for a viewer at this cosine.
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
        let [whole, difference, _] = L::channels(sum);
        let whole = whole.max(zero).min(one);
        let smooth = whole * (one - cos_theta).pow5();
        let grazing = (smooth + difference).max(zero).min(whole);
        Albedo { whole, grazing }
    }

    /// The mean of the table's albedo over the hemisphere, by the midpoint rule in sqrt(mu), in which
    /// it is smooth at the horizon: the integral of 2 mu E(mu) over mu in [0, 1].
    fn mean(&self, alpha: T) -> Rgb<f64> {
        let row = self.row(alpha);
        let mut sum = [0.0; 3];
        for i in 0..MEAN_NODES {
            let root = (f64::from(i) + 0.5) / f64::from(MEAN_NODES);
            let weight = 4.0 * root.powi(3) / f64::from(MEAN_NODES);
            let albedo = self.albedo(&row, T::new(root * root));
            sum[0] += weight * f64::from(albedo.whole.to_f32());
            sum[1] += weight * f64::from(albedo.grazing.to_f32());
        }
        sum
    }
}

/// One alpha of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<T> {
    /// The first of the three rows of control points around alpha, and their weights.
    first: T,
    along: [T; 3],
    bend: T,
    /// The mean over the hemisphere, weighted by the cosine.
    pub mean: Albedo<T>,
}

impl<T: Lane<Scalar = T>> Row<T> {
    /// The same everywhere.
    #[inline(always)]
    pub fn splat<L: Lane<Scalar = T>>(&self) -> Row<L> {
        Row {
            first: L::splat(self.first),
            along: each!(self.along, |weight| L::splat(weight)),
            bend: L::splat(self.bend),
            mean: Albedo {
                whole: L::splat(self.mean.whole),
                grazing: L::splat(self.mean.grazing),
            },
        }
    }
}

/// The whole number in [0, count) nearest to a position, plus [`INDEX_BIAS`], and the distance from it.
#[inline(always)]
fn nearest<T: Real>(position: T, count: usize) -> (T, T) {
    let index = position.round().max(T::new(0.0));
    let index = index.min(T::new((count - 1) as f64));
    (index + T::new(INDEX_BIAS), position - index)
}

fn packed<T: Real>([whole, difference, _]: Rgb<f64>) -> TableEntry<T> {
    TableEntry::new([whole, difference, difference].map(T::new))
}

/// Two uniform numbers and their weight, for the mean over the lobe's random numbers: the azimuth
/// first, the other through 1 - (1 - t)^2, as lobes end at the horizon, where that number is 1.
fn lattice<T: Real>() -> Vec<([T; 2], T)> {
    let nodes = (0..NODES).map(|i| {
        let t = (f64::from(i) + 0.5) / f64::from(NODES);
        let azimuth = (f64::from(i * GENERATOR % NODES) + 0.25) / f64::from(NODES);
        let weight = 2.0 * (1.0 - t) / f64::from(NODES);
        let u = [azimuth, 1.0 - (1.0 - t).powi(2)];
        (u.map(T::new), T::new(weight))
    });
    nodes.collect()
}

/// The control points of one alpha.
fn row_of<T: Precision>(
    alpha: T,
    lattice: &[([T; 2], T)],
    lobe: &impl Fn(T, Vec3<T>, [T; 2]) -> Reflected<T>,
) -> Vec<Rgb<f64>> {
    let bend = f64::from(alpha.to_f32()) * BEND;
    let values: Vec<Rgb<f64>> = (0..COSINES)
        .map(|i| {
            // The horizon itself is a limit: near it E changes by less than its share of a step.
            let x = (i as f64 / (COSINES - 1) as f64).max(1e-3).powi(2);
            let cosine = (bend * x / (1.0 + bend - x)).min(1.0);
            let wo = Vec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
            let wo = Vec3::new(T::new(wo.x), T::new(wo.y), T::new(wo.z));
            let (mut whole, mut grazing) = (T::new(0.0), T::new(0.0));
            for (u, weight) in lattice {
                let reflected = lobe(alpha, wo, *u);
                let part = reflected.weight * *weight;
                whole = whole + part;
                grazing = grazing + part * (T::new(1.0) - reflected.cos_half).pow5();
            }
            let [whole, grazing] = [whole, grazing].map(|sum| f64::from(sum.to_f32()));
            let difference = grazing - whole * (1.0 - cosine).powi(5);
            [whole, difference, difference]
        })
        .collect();
    let mut points = Vec::new();
    controls(&values, &mut points);
    points
}

/// The control points along alpha of every column of [`ALPHAS`] rows.
fn along_alpha<T: Real>(rows: &[Vec<Rgb<f64>>; ALPHAS]) -> Box<[TableEntry<T>]> {
    let width = rows[0].len();
    let mut points = vec![TableEntry::new([T::new(0.0); 3]); (ALPHAS + 2) * width];
    let mut fitted = Vec::new();
    for column in 0..width {
        let values: Vec<Rgb<f64>> = rows.iter().map(|row| row[column]).collect();
        controls(&values, &mut fitted);
        for (row, point) in fitted.iter().enumerate() {
            points[row * width + column] = packed(*point);
        }
    }
    points.into()
}

#[cfg(test)]
mod tests;
