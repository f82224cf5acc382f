//! Energy compensation: light that facets reflect onto other facets, which masking alone would lose.
//!
//! Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks": with E(mu) the albedo for
//! F = 1 and Eavg its mean 2 integral E(mu) mu dmu, the lobe
//!
//! f = (1 - E(n.v)) (1 - E(n.l)) / (pi (1 - Eavg))
//!
//! has the albedo that a white surface lacks: the sum of both lobes has the albedo 1. Let Favg be the mean
//! of F over the hemisphere of a facet. Light that is reflected k more times gets the colour Favg^k, and
//! the share (1 - Eavg)^k of it has not left before. The sum of this series from k = 1 on, times the colour
//! Favg of the first reflection and the share Eavg that leaves after the last one, divided by 1 - Eavg,
//! which is the albedo of the lobe, is
//!
//! Favg^2 Eavg / (1 - Favg (1 - Eavg)).
//!
//! This is from Hill 2018, "A Multi-Faceted Exploration (Part 2)". It has one power of Favg more than the
//! course notes, in which light that is reflected twice has the colour of one reflection.

use super::energy::{Albedo, Energy, Row};
use super::fresnel::{CompiledFresnel, Fresnel};
use crate::bsdf::precision::Precision;
use crate::error::Error;
use crate::film::Film;
use crate::num::{Lane, Rgb, Vec3, each, warp};

/// The least divisor 1 - Eavg, a tenth of the error of the table. Surfaces that lose less need no
/// compensation.
const LEAST_LOSS: f64 = 1e-4;

/// The tables of energy compensation, which are the same for all calls.
pub(super) struct Compensation<T> {
    pub energy: Energy<T>,
    pub average: Average<T>,
}

/// The lobe of multiple scattering for one call.
#[derive(Clone, Copy)]
pub(super) struct MultipleScattering<'a, T: Lane> {
    energy: &'a Energy<T::Scalar>,
    row: Row<T>,
    /// The colour of the lobe over 1 - Eavg.
    color: Rgb<T>,
}

impl<T: Precision> Compensation<T> {
    #[inline(always)]
    pub fn multiple_scattering<L: Lane<Scalar = T>>(
        &self,
        alpha: L,
        fresnel: &Fresnel<'_, L>,
        is_spectral: bool,
    ) -> MultipleScattering<'_, L> {
        let one = L::new(1.0);
        let row = self.energy.row(alpha);
        let Albedo {
            whole: escaping,
            lost,
            ..
        } = row.mean;
        let divisor = lost.max(L::new(LEAST_LOSS));
        let average = if is_spectral && !matches!(fresnel, Fresnel::Schlick { .. }) {
            mean_at_wavelength(fresnel)
        } else {
            self.average.of(fresnel)
        };
        let color = each!(average, |mean| {
            let sum = mean.squared() * escaping / (one - mean * lost);
            sum / divisor
        });
        MultipleScattering {
            energy: &self.energy,
            row,
            color,
        }
    }
}

impl<T: Precision, L: Lane<Scalar = T>> MultipleScattering<'_, L> {
    /// E(cos_theta), the albedo of the single-scattering lobe for F = 1.
    #[inline(always)]
    pub fn albedo(&self, cos_theta: L) -> L {
        self.energy.albedo(&self.row, cos_theta).whole
    }

    /// 1 - E
    #[inline(always)]
    fn lost(&self, w: Vec3<L>) -> L {
        self.energy.albedo(&self.row, w.z).lost
    }

    /// f(wo, wi) |wi.z|
    #[inline(always)]
    pub fn eval(&self, wo: Vec3<L>, wi: Vec3<L>) -> Rgb<L> {
        let factor = self.lost(wo) * self.lost(wi) * warp::cosine_hemisphere_pdf(wi.z);
        each!(self.color, |color| color * factor)
    }

    /// The mean of its albedo over the channels for that viewer, apart from the bound of the divisor.
    #[inline(always)]
    pub fn share(&self, wo: Vec3<L>) -> L {
        let lost = self.lost(wo) * self.row.mean.lost;
        crate::bsdf::models::power_lobe::mean(self.color) * lost
    }
}

/// The mean of F over the hemisphere, 2 integral F(mu) mu dmu.
pub(super) enum Average<T> {
    /// F0 + (F90 - F0) / 21, since 2 integral (1 - mu)^5 mu dmu = 1 / 21.
    Schlick,
    /// The mean of a Fresnel factor that does not vary.
    Constant(Rgb<T>),
    /// The means over the thickness of the film.
    Film(Thicknesses<T>),
}

impl<T: Precision> Average<T> {
    /// Fails if there is no memory for the table of a film.
    pub fn new(facets: &CompiledFresnel<T>, is_film_varying: bool) -> Result<Self, Error> {
        Ok(match facets {
            CompiledFresnel::Schlick { .. } => Self::Schlick,
            CompiledFresnel::Film { film, .. } if is_film_varying => {
                Self::Film(Thicknesses::new(film)?)
            }
            _ => Self::Constant(mean_reflectance(&facets.fresnel())),
        })
    }

    #[inline(always)]
    fn of<L: Lane<Scalar = T>>(&self, fresnel: &Fresnel<'_, L>) -> Rgb<L> {
        match (self, fresnel) {
            (Self::Constant(mean), _) => each!(*mean, |channel| L::splat(channel)),
            (
                Self::Film(table),
                Fresnel::Film {
                    thickness_nm,
                    spread_nm,
                    ..
                },
            ) => match spread_nm {
                None => table.at(*thickness_nm),
                Some(spread_nm) => table.averaged(*thickness_nm, *spread_nm),
            },
            (_, Fresnel::Schlick { f0, f90, .. }) => {
                L::channels(*f0 + (*f90 - *f0) * L::new(1.0 / 21.0).gray())
            }
            // No other pair exists.
            _ => [L::new(0.0); 3],
        }
    }
}

/// The number of midpoints in mu^2, because 2 mu dmu = d(mu^2).
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

/// The mean at the wavelength of a spectral call, by a rule of Gauss in the cosine (Abramowitz and Stegun 1964, table 25.4,
/// n = 8).
#[inline(always)]
fn mean_at_wavelength<T: Precision, L: Lane<Scalar = T>>(fresnel: &Fresnel<'_, L>) -> Rgb<L> {
    const GAUSS: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_361_98),
        (0.525_532_409_916_328_99, 0.313_706_645_877_887_29),
        (0.796_666_477_413_626_74, 0.222_381_034_453_374_47),
        (0.960_289_856_497_536_23, 0.101_228_536_290_376_26),
    ];
    let mut sum = L::new(0.0);
    for i in 0..2 * GAUSS.len() {
        let (x, weight) = GAUSS[i / 2];
        let cosine = 0.5 + if i % 2 == 0 { 0.5 * x } else { -0.5 * x };
        let [reflectance, ..] = fresnel.reflectance(L::new(cosine));
        sum = sum + L::new(weight * cosine) * reflectance;
    }
    [sum; 3]
}

/// The distance of the nodes of the table, nm, for ranges of up to 20 um. A fringe of the mean is wider
/// than 100 nm, so that the error is 1e-3 of its amplitude.
const STEP_NM: f64 = 5.0;
/// The greatest number of nodes. The fringes of films thicker than 20 um are below 1e-2 in the mean.
const MOST_NODES: f64 = 4096.0;

/// The mean reflectance at equally spaced thicknesses of the film's varying layer.
pub(super) struct Thicknesses<T> {
    from: T,
    to: T,
    per_nm: T,
    nodes: Box<[Rgb<T>]>,
}

impl<T: Precision> Thicknesses<T> {
    fn new(film: &Film) -> Result<Self, Error> {
        let [from, to] = film.varying_thickness_nm().unwrap_or_default();
        let pieces = ((to - from) / STEP_NM).ceil().clamp(1.0, MOST_NODES - 1.0);
        let count = pieces as usize + 1;
        let mut nodes = Error::reserve(count, "a film's mean reflectance")?;
        nodes.extend((0..count).map(|i| {
            let thickness_nm = T::new(from + (to - from) * i as f64 / pieces);
            mean_reflectance(&Fresnel::Film {
                film,
                thickness_nm,
                spread_nm: None,
            })
        }));
        Ok(Self {
            from: T::new(from),
            to: T::new(to),
            per_nm: T::new(pieces / (to - from)),
            nodes: nodes.into(),
        })
    }

    /// The mean under the normal distribution of a spread, cut to the range, by midpoints within 3.5 deviations. They
    /// are at most a fifth of a deviation apart: the density of a cut distribution does not vanish at its end, so that
    /// the error is of the order of the square of their distance. With 12 of them a BSDF was off by a hundredth.
    #[inline(always)]
    fn averaged<L: Lane<Scalar = T>>(&self, thickness_nm: L, spread_nm: L) -> Rgb<L> {
        const POINTS: u32 = 36;
        const LEAST_NM: f64 = 1e-3;
        let spread = spread_nm.max(L::new(LEAST_NM));
        let centre = thickness_nm.max(L::splat(self.from)).min(L::splat(self.to));
        let reach = L::new(3.5) * spread;
        let from = (centre - reach).max(L::splat(self.from));
        let to = (centre + reach).min(L::splat(self.to));
        let (mut sum, mut total) = ([L::new(0.0); 3], L::new(0.0));
        for i in 0..POINTS {
            let part = L::new((f64::from(i) + 0.5) / f64::from(POINTS));
            let at = from + (to - from) * part;
            let distance = (at - centre) / spread;
            let weight = (L::new(-0.5) * distance * distance).exp();
            let mean = self.at(at);
            sum = each!([0, 1, 2], |channel| sum[channel] + weight * mean[channel]);
            total = total + weight;
        }
        each!(sum, |channel| channel / total)
    }

    /// The mean at a thickness, linear between the nodes. A thickness outside the range is clamped to it.
    #[inline(always)]
    fn at<L: Lane<Scalar = T>>(&self, thickness_nm: L) -> Rgb<L> {
        let (zero, half, one) = (L::new(0.0), L::new(0.5), L::new(1.0));
        let last = L::new((self.nodes.len() - 2) as f64);
        let position = ((thickness_nm - L::splat(self.from)) * L::splat(self.per_nm)).max(zero);
        // At a node the pieces on both sides have the same value.
        let node = (position - half).round().max(zero).min(last);
        let part = (position - node).min(one);
        let [a, b] = [
            L::load_entry(&self.nodes, node),
            L::load_entry(&self.nodes, node + one),
        ];
        each!([0, 1, 2], |channel| a[channel]
            + (b[channel] - a[channel]) * part)
    }
}
