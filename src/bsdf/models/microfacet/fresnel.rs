//! The Fresnel factor F: the reflectance of a facet.

use super::params::{F0, THICKNESS_NM, THICKNESS_SPREAD_NM};
use crate::bsdf::precision::Precision;
use crate::error::Error;
use crate::film::{Film, FilmDescription, Ray};
use crate::num::{Lane, Real, Rgb, each};
use crate::optics::stack::Side;
use crate::optics::{
    ConductorPolynomial, Medium, conductor_reflectance, dielectric_reflectance, index_between,
    schlick_between, schlick_falling,
};
use std::sync::Arc;

/// The Fresnel factor for one call.
#[derive(Clone, Copy)]
pub(super) enum Fresnel<'a, T: Lane> {
    /// Schlick's approximation. `falls` tells that f90 may be less than f0.
    Schlick {
        f0: T::Rgb,
        f90: T::Rgb,
        falls: bool,
    },
    /// The exact reflectance of a dielectric. `is_gray` tells that all channels have the same index.
    Dielectric { eta: T::Rgb, is_gray: bool },
    /// The exact reflectance of a conductor with one index eta + i k per channel.
    Conductor { eta: T::Rgb, k: T::Rgb },
    /// The same by a polynomial, to within rounding.
    Polynomial(&'a ConductorPolynomial<<T::Scalar as Lane>::Rgb>),
    /// The reflectance of a film.
    Film {
        film: &'a Film,
        thickness_nm: T,
        /// The standard deviation of the thickness; `None` if it is always 0.
        spread_nm: Option<T>,
    },
    /// The reflectance of a film at one wavelength, by wave optics.
    Wave {
        film: &'a Film,
        thickness_nm: T,
        lambda_nm: T,
    },
}

/// The complex index of facets at 645, 525 and 445 nm.
pub(super) struct ThreeIndices<T> {
    pub eta: [T; 3],
    pub k: [T; 3],
}

impl<T: Precision, L: Lane<Scalar = T>> Fresnel<'_, L> {
    /// The reflectance in \[0, 1\] at the cosine <wo, h>. The colours of unclipped films are clipped here.
    #[inline(always)]
    pub fn reflectance(&self, cos_theta: L) -> Rgb<L> {
        let cosines = cos_theta.gray();
        match *self {
            Self::Schlick {
                f0,
                f90,
                falls: false,
            } => L::channels(schlick_between(f0, f90, cosines)),
            Self::Schlick { f0, f90, .. } => L::channels(schlick_falling(f0, f90, cosines)),
            // In lanes, equal channels are computed once. In single calls the channels share a register, so
            // that there is nothing to save.
            Self::Dielectric { eta, is_gray: true } if L::COUNT > 1 => {
                let [eta, ..] = L::channels(eta);
                L::channels(dielectric_reflectance(cosines, eta.gray()))
            }
            Self::Dielectric { eta, .. } => L::channels(dielectric_reflectance(cosines, eta)),
            Self::Conductor { eta, k } => {
                let reflectance = conductor_reflectance(cosines, eta, k);
                L::channels(reflectance.min(L::Rgb::new(1.0)))
            }
            Self::Polynomial(polynomial) => {
                let reflectance = polynomial.reflectance(cos_theta);
                L::channels(reflectance.min(L::Rgb::new(1.0)))
            }
            Self::Film {
                film,
                thickness_nm,
                spread_nm,
            } => {
                let reflectance = match spread_nm {
                    None => T::reflectance(film, cos_theta, thickness_nm),
                    Some(spread_nm) => {
                        T::reflectance_spread(film, cos_theta, thickness_nm, spread_nm)
                    }
                };
                each!(reflectance, |channel| {
                    channel.max(L::new(0.0)).min(L::new(1.0))
                })
            }
            // Spectral calls alone get here, in few lanes.
            Self::Wave { .. } if L::COUNT > <T::Wavelengths as Lane>::COUNT => [L::new(0.0); 3],
            Self::Wave {
                film,
                thickness_nm,
                lambda_nm,
            } => [wave_reflectance(film, cos_theta, thickness_nm, lambda_nm); 3],
        }
    }

    /// The Fresnel factor at one vacuum wavelength, nm. `indices` are those of a dielectric or of a conductor without a
    /// measured spectrum. Schlick's f0 and f90 are what the call gives for the wavelength.
    #[inline(always)]
    pub fn at_wavelength(&self, indices: &ThreeIndices<T>, lambda_nm: L) -> Self {
        let between = |numbers: [T; 3]| {
            index_between(each!(numbers, |number| L::splat(number)), lambda_nm).gray()
        };
        match *self {
            Self::Dielectric { .. } => Self::Dielectric {
                eta: between(indices.eta),
                is_gray: true,
            },
            Self::Conductor { .. } | Self::Polynomial(_) => Self::Conductor {
                eta: between(indices.eta),
                k: between(indices.k),
            },
            Self::Film {
                film, thickness_nm, ..
            } => Self::Wave {
                film,
                thickness_nm,
                lambda_nm,
            },
            other => other,
        }
    }

    /// Replaces the value of a parameter that varies per call. Parameters of other Fresnel factors have no
    /// effect.
    #[inline(always)]
    pub fn vary(&mut self, param: usize, value: [L; 3]) {
        match self {
            Self::Schlick { f0, .. } if param == F0 => *f0 = L::rgb(value),
            Self::Film { thickness_nm, .. } if param == THICKNESS_NM => *thickness_nm = value[0],
            Self::Film { spread_nm, .. } if param == THICKNESS_SPREAD_NM => {
                *spread_nm = Some(value[0]);
            }
            _ => {}
        }
    }
}

/// The reflectance of a film for unpolarised light in each lane, which has a cosine, a thickness and a wavelength.
#[inline(always)]
fn wave_reflectance<L: Lane>(film: &Film, cos_theta: L, thickness_nm: L, lambda_nm: L) -> L
where
    L::Scalar: Precision,
{
    let mut rays = [[L::Scalar::new(0.0); MOST_WAVES]; 3];
    for (numbers, row) in [cos_theta, thickness_nm, lambda_nm]
        .into_iter()
        .zip(&mut rays)
    {
        numbers.store(&mut row[..L::COUNT]);
    }
    let mut found = [L::Scalar::new(0.0); MOST_WAVES];
    film.each_response(
        Side::Ambient,
        L::COUNT,
        |i| Ray {
            cos_theta: rays[0][i].into(),
            thickness_nm: rays[1][i].into(),
            wavelength_nm: rays[2][i].into(),
        },
        |i, response| found[i] = L::Scalar::new(response.unpolarized_reflectance()),
    );
    L::load(&found[..L::COUNT])
}

/// The most lanes of a spectral call.
const MOST_WAVES: usize = 4;

/// The compiled Fresnel factor, which owns the film.
pub(super) enum CompiledFresnel<T: Lane> {
    /// [`Fresnel::Schlick`]
    Schlick {
        f0: T::Rgb,
        f90: T::Rgb,
        falls: bool,
    },
    /// [`Fresnel::Dielectric`]
    Dielectric { eta: T::Rgb, is_gray: bool },
    /// [`Fresnel::Conductor`]
    Conductor { eta: T::Rgb, k: T::Rgb },
    /// [`Fresnel::Polynomial`]
    Polynomial(ConductorPolynomial<T::Rgb>),
    /// [`Fresnel::Film`]
    Film {
        film: Arc<Film>,
        thickness_nm: T,
        spread_nm: Option<T>,
    },
}

impl<T: Precision> CompiledFresnel<T> {
    /// The Fresnel factor of a named medium without a coating.
    pub fn of_metal(name: &str) -> Result<Self, Error> {
        let film = Film::new(&FilmDescription::new(Medium::named(name)?))?;
        Ok(Self::Film {
            film: Arc::new(film),
            thickness_nm: T::new(0.0),
            spread_nm: None,
        })
    }

    /// The film, which may be a bare metal.
    pub fn film(&self) -> Option<&Film> {
        match self {
            Self::Film { film, .. } => Some(film),
            _ => None,
        }
    }

    /// The parts of the plan in words, see [`Kernel::plan`](crate::bsdf::kernel::Kernel::plan).
    pub fn plan(&self) -> Vec<&'static str> {
        const LOST_IN_BASE: &str =
            "what enters the facets is absorbed, as this model only reflects";
        match self {
            Self::Dielectric { is_gray: true, .. } => {
                vec!["one index for all channels", LOST_IN_BASE]
            }
            Self::Dielectric { .. } => vec![LOST_IN_BASE],
            Self::Polynomial(_) => vec!["conductor by polynomials"],
            Self::Film { film, .. } if !film.is_base_opaque() => vec![LOST_IN_BASE],
            _ => Vec::new(),
        }
    }

    /// The Fresnel factor for one call.
    #[inline(always)]
    pub fn fresnel<L: Lane<Scalar = T>>(&self) -> Fresnel<'_, L> {
        let splat = L::splat_rgb;
        match *self {
            Self::Schlick { f0, f90, falls } => Fresnel::Schlick {
                f0: splat(f0),
                f90: splat(f90),
                falls,
            },
            Self::Dielectric { eta, is_gray } => Fresnel::Dielectric {
                eta: splat(eta),
                is_gray,
            },
            Self::Conductor { eta, k } => Fresnel::Conductor {
                eta: splat(eta),
                k: splat(k),
            },
            Self::Polynomial(ref polynomial) => Fresnel::Polynomial(polynomial),
            Self::Film {
                ref film,
                thickness_nm,
                spread_nm,
            } => Fresnel::Film {
                film,
                thickness_nm: L::splat(thickness_nm),
                spread_nm: spread_nm.map(L::splat),
            },
        }
    }
}
