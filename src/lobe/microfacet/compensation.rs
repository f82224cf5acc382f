//! What masking takes away, given back: light that facets reflect onto other facets.
//!
//! Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks": with E(mu) the albedo for
//! F = 1 and Eavg its mean 2 integral E(mu) mu dmu, the lobe
//!
//! f = (1 - E(n.v)) (1 - E(n.l)) / (pi (1 - Eavg))
//!
//! returns the rest of a white surface: their sum has the albedo 1. What has been reflected k times more
//! has the colour Favg^k, Favg the mean of F over the hemisphere of a facet, and a share (1 - Eavg)^k
//! has not left before. The sum of the series from k = 1, times the colour Favg and the share Eavg with
//! which the last facet lets go, over 1 - Eavg for which the lobe is made, is
//!
//! Favg^2 Eavg / (1 - Favg (1 - Eavg)):
//!
//! Hill 2018, "A Multi-Faceted Exploration (Part 2)", with one power of Favg more than the course notes,
//! in which light that is reflected twice has the colour of one reflection.

use super::energy::{Energy, Row};
use super::fresnel::{Facets, Fresnel};
use crate::error::Error;
use crate::film::Film;
use crate::lobe::precision::Precision;
use crate::math::{Element, Rgb, Vec3, warp};

/// Least divisor 1 - Eavg, a tenth of the table's error: of smoother surfaces there is nothing to give
/// back.
const LEAST_LOSS: f64 = 1e-4;

/// The part that is the same for all calls.
pub(super) struct Compensation<T> {
    pub energy: Energy<T>,
    pub average: Average<T>,
}

/// The lobe for one call.
#[derive(Clone, Copy)]
pub(super) struct Returned<'a, T: Element> {
    energy: &'a Energy<T>,
    row: Row<T>,
    /// Colour over 1 - Eavg.
    color: Rgb<T>,
}

impl<T: Precision> Compensation<T> {
    #[inline(always)]
    pub fn returned(&self, alpha: T, fresnel: &Fresnel<'_, T>) -> Returned<'_, T> {
        let one = T::new(1.0);
        let row = self.energy.row(alpha);
        let escaping = row.mean.whole;
        let lost = one - escaping;
        let divisor = lost.max(T::new(LEAST_LOSS));
        let color = self.average.of(fresnel).map(|mean| {
            let sum = mean.squared() * escaping / (one - mean * lost);
            sum / divisor
        });
        Returned {
            energy: &self.energy,
            row,
            color,
        }
    }
}

impl<T: Precision> Returned<'_, T> {
    /// E for F = 1.
    #[inline(always)]
    pub fn albedo(&self, cos_theta: T) -> T {
        self.energy.albedo(&self.row, cos_theta).whole
    }

    /// f(wo, wi) |wi.z|
    #[inline(always)]
    pub fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        let lost = |w: Vec3<T>| T::new(1.0) - self.albedo(w.z);
        let factor = lost(wo) * lost(wi) * warp::cosine_hemisphere_pdf(wi.z);
        self.color.map(|color| color * factor)
    }

    /// Its albedo for that viewer, but for the divisor's bound.
    #[inline(always)]
    pub fn share(&self, wo: Vec3<T>) -> T {
        let escaping = self.row.mean.whole;
        let lost = (T::new(1.0) - self.albedo(wo.z)) * (T::new(1.0) - escaping);
        crate::lobe::power_lobe::mean(self.color) * lost
    }
}

/// The mean of F over the hemisphere, 2 integral F(mu) mu dmu.
pub(super) enum Average<T> {
    /// F0 + (F90 - F0) / 21, since 2 integral (1 - mu)^5 mu dmu = 1 / 21.
    Schlick,
    /// Of what does not vary.
    Constant(Rgb<T>),
    /// Over the film's thickness.
    Film(Thicknesses),
}

impl<T: Precision> Average<T> {
    /// Fails for want of memory.
    pub fn new(facets: &Facets<T>, is_film_varying: bool) -> Result<Self, Error> {
        Ok(match facets {
            Facets::Bare(Fresnel::Schlick { .. }) => Self::Schlick,
            Facets::Film { film, .. } if is_film_varying => Self::Film(Thicknesses::new(film)?),
            _ => Self::Constant(mean_reflectance(&facets.fresnel())),
        })
    }

    #[inline(always)]
    fn of(&self, fresnel: &Fresnel<'_, T>) -> Rgb<T> {
        match (self, fresnel) {
            (Self::Constant(mean), _) => *mean,
            (Self::Film(table), Fresnel::Film { thickness_nm, .. }) => table
                .at(*thickness_nm)
                .map(|channel| T::new(f64::from(channel))),
            (_, Fresnel::Schlick { f0, f90 }) => {
                T::channels(*f0 + (*f90 - *f0) * T::new(1.0 / 21.0).gray())
            }
            // No other pair is ever made.
            _ => [T::new(0.0); 3],
        }
    }
}

/// Midpoints in mu^2, whose measure 2 mu dmu is.
const COSINES: u32 = 64;

fn mean_reflectance<T: Precision>(fresnel: &Fresnel<'_, T>) -> Rgb<T> {
    let mut sum = [T::new(0.0); 3];
    for i in 0..COSINES {
        let squared = (f64::from(i) + 0.5) / f64::from(COSINES);
        let reflectance = fresnel.reflectance(T::new(squared.sqrt()));
        for channel in 0..3 {
            sum[channel] = sum[channel] + reflectance[channel];
        }
    }
    sum.map(|sum| sum * T::new(1.0 / f64::from(COSINES)))
}

/// Distance of the table's nodes, nm, if it does not get too long: a fringe of the mean is more than
/// 100 nm, which leaves an error of 1e-3 of its amplitude.
const STEP_NM: f64 = 5.0;
/// The most nodes: fringes of films that are 20 um thick have faded to 1e-2 in the mean.
const MOST_NODES: f64 = 4096.0;

/// The mean reflectance at equally spaced thicknesses of the film's varying layer.
pub(super) struct Thicknesses {
    from: f32,
    per_nm: f32,
    nodes: Box<[Rgb<f32>]>,
}

impl Thicknesses {
    fn new(film: &Film) -> Result<Self, Error> {
        let [from, to] = film.varying_thickness_nm().unwrap_or_default();
        let pieces = ((to - from) / STEP_NM).ceil().clamp(1.0, MOST_NODES - 1.0);
        let count = pieces as usize + 1;
        let mut nodes = Error::reserve(count, "a film's mean reflectance")?;
        nodes.extend((0..count).map(|i| {
            let thickness_nm = (from + (to - from) * i as f64 / pieces) as f32;
            mean_reflectance::<f32>(&Fresnel::Film { film, thickness_nm })
        }));
        Ok(Self {
            from: from as f32,
            per_nm: (pieces / (to - from)) as f32,
            nodes: nodes.into(),
        })
    }

    /// Linear between the nodes; a thickness outside the range counts as its end.
    #[inline(always)]
    fn at(&self, thickness_nm: f32) -> Rgb<f32> {
        let last = self.nodes.len() - 2;
        let position = ((thickness_nm - self.from) * self.per_nm).max(0.0);
        let node = (position as usize).min(last);
        let part = (position - node as f32).min(1.0);
        let [a, b] = [self.nodes[node], self.nodes[node + 1]];
        std::array::from_fn(|channel| a[channel] + (b[channel] - a[channel]) * part)
    }
}
