//! The Fresnel factor: how much a facet reflects.

use super::{F0, THICKNESS_NM};
use crate::error::Error;
use crate::film::{Film, FilmDescription};
use crate::lobe::precision::Precision;
use crate::math::{Element, Real, Rgb};
use crate::optics::{Medium, conductor_reflectance, dielectric_reflectance, schlick_between};
use std::sync::Arc;

/// What facets consist of, with the parameters set; borrows the film.
#[derive(Clone, Copy)]
pub(super) enum Fresnel<'a, T: Element> {
    /// Schlick's approximation.
    Schlick { f0: T::Rgb, f90: T::Rgb },
    /// Exact, transparent.
    Dielectric { eta: T::Rgb },
    /// Exact, at one index eta + i k per channel.
    Conductor { eta: T::Rgb, k: T::Rgb },
    /// By wave optics, spectrally integrated.
    Film { film: &'a Film, thickness_nm: f32 },
}

impl<T: Precision> Fresnel<'_, T> {
    /// The reflectance in \[0, 1\] at the cosine <wo, h>. Colours of films that were asked for
    /// unclipped are clipped here.
    #[inline(always)]
    pub fn reflectance(&self, cos_theta: T) -> Rgb<T> {
        let cosines = cos_theta.gray();
        match *self {
            Self::Schlick { f0, f90 } => T::channels(schlick_between(f0, f90, cosines)),
            Self::Dielectric { eta } => T::channels(dielectric_reflectance(cosines, eta)),
            Self::Conductor { eta, k } => {
                let reflectance = conductor_reflectance(cosines, eta, k);
                T::channels(reflectance.min(T::Rgb::new(1.0)))
            }
            Self::Film { film, thickness_nm } => film
                .reflectance(cos_theta.to_f32(), thickness_nm)
                .map(|channel| T::new(f64::from(channel.clamp(0.0, 1.0)))),
        }
    }

    /// Replaces the value of a parameter that varies per call; those of other kinds have no effect.
    #[inline(always)]
    pub fn vary(&mut self, param: usize, value: [T; 3]) {
        match self {
            Self::Schlick { f0, .. } if param == F0 => *f0 = T::rgb(value),
            Self::Film { thickness_nm, .. } if param == THICKNESS_NM => {
                *thickness_nm = value[0].to_f32();
            }
            _ => {}
        }
    }
}

/// What facets consist of, as compiled.
pub(super) enum Facets<T: Element> {
    /// Numbers only.
    Bare(Fresnel<'static, T>),
    /// [`Fresnel::Film`], owning the film.
    Film { film: Arc<Film>, thickness_nm: f32 },
}

impl<T: Precision> Facets<T> {
    /// Of a named medium without a coating.
    pub fn of_metal(name: &str) -> Result<Self, Error> {
        let film = Film::new(&FilmDescription::new(Medium::named(name)?))?;
        Ok(Self::Film {
            film: Arc::new(film),
            thickness_nm: 0.0,
        })
    }

    /// For one call.
    #[inline(always)]
    pub fn fresnel(&self) -> Fresnel<'_, T> {
        match self {
            Self::Bare(fresnel) => *fresnel,
            Self::Film { film, thickness_nm } => Fresnel::Film {
                film,
                thickness_nm: *thickness_nm,
            },
        }
    }
}
