//! # `film`: a smooth surface with a thin-film coating
//!
//! A perfect mirror whose colour is computed by wave optics: the compiled [`Film`] gives R and T, and the
//! law of reflection and Snell's law give the directions. Both lobes are Dirac, so that value and density
//! are 0 everywhere and only sampling finds them. Use it for soap bubbles, coated lenses and oil on still
//! water; for brushed or worn surfaces use `microfacet` with a film.
//!
//! **Reflection**: wi mirrors wo, weight R.
//!
//! **Transmission**, for a film that keeps its transmittance on a base that is not opaque (k of at most 1e-3 at
//! 550 nm, unless the film's description says otherwise): wi is refracted by Snell's law between ambient and base. The weight is T (eta_o / eta_i)^2, because refraction
//! compresses the solid angle of radiance (Veach 1997, "Robust Monte Carlo Methods for Light Transport
//! Simulation", section 5.2). Layers shift a ray but do not turn it, so that directions pass unchanged if
//! base and ambient have the same index, as for a soap bubble. All colours take the direction of 550 nm,
//! near the peak of the eye's sensitivity: the dispersion of directions is left out. Where light of 550 nm
//! is totally reflected nothing is transmitted. In both directions T is that from the ambient's side, at
//! the angle there, so that it is the same both ways. Beside a dispersing base the transmittances of the
//! two sides would belong to different angles and differ by up to 0.3 at grazing angles.
//!
//! **Thickness**: `thickness_nm` is the thickness of the film's layer that varies, within the range of that
//! layer. If a layer varies, it must be set or declared varying; if none does, it must not. A varying
//! thickness without a value of its own has the least value of its range as default.
//!
//! **Spread**: `thickness_spread_nm` is the standard deviation of that thickness within a pixel or a real layer. R and
//! T are averages over a normal distribution cut to the layer's range ([`Film::colors_spread`]).
//!
//! **Energy**: T is clipped to \[0, 1\] and R to \[0, 1 - T\], for unclipped films too. Power is conserved
//! at every wavelength but not in every channel, because the weights of the channels have negative parts:
//! the red of R and of T may each be below 1 and their sum above. R is the one that is reduced, because T
//! must be the same from both sides.
//!
//! Films are evaluated in single precision, so that in double precision only the directions are more exact.

use super::power_lobe::mean;
use crate::bsdf::call::Transport;
use crate::bsdf::info::{Flags, LobeInfo, ModelInfo, ParamInfo};
use crate::bsdf::job::{Direction, chosen_lobe, only, with_overrides};
use crate::bsdf::kernel::Kernel;
use crate::bsdf::lobes::{LobeSet, MAX_LOBES, PerLobe, normalized};
use crate::bsdf::model::{KernelResult, Model};
use crate::bsdf::precision::Precision;
use crate::bsdf::values::Values;
use crate::bsdf::varying::VaryingValues;
use crate::bsdf::wavelengths::{MAX_WAVELENGTHS, PerWavelength, SpectralCall, SpectralValues};
use crate::film::{DIRECTION_NM, Film, MAX_THICKNESS_NM, Ray};
use crate::num::{Real, Rgb, Vec3};
use crate::optics::Interface;
use crate::optics::stack::Side;
use std::sync::Arc;

/// The model; see the module's documentation.
pub struct ThinFilm;

const THICKNESS_NM: usize = 0;
const THICKNESS_SPREAD_NM: usize = 1;

const REFLECTION_LOBE: usize = 0;
const TRANSMISSION_LOBE: usize = 1;

impl Model for ThinFilm {
    const INFO: ModelInfo = ModelInfo {
        name: "film",
        summary: "Needs a film: a smooth surface coated with it, which reflects and, if the film keeps its transmittance and its base is not opaque, transmits.",
        source: "Abeles 1950 and Macleod, Thin-Film Optical Filters, chapter 2; directions by Snell's law",
        params: &[
            ParamInfo::number("thickness_nm", "Thickness of the film's layer that varies, within its range: needed if one varies, refused if none does.", [0.0, MAX_THICKNESS_NM as f32], 0.0).in_unit("nm"),
            ParamInfo::number("thickness_spread_nm", "Standard deviation of that thickness within a pixel or a real layer: colours are averaged over a normal distribution cut to the layer's range. At most the thickness_spread_max_nm of the film, refused if no layer varies.", [0.0, MAX_THICKNESS_NM as f32], 0.0).in_unit("nm"),
        ],
        lobes: &[
            LobeInfo {
                name: "reflection",
                flags: Flags::REFLECTION.with(Flags::DELTA),
            },
            LobeInfo {
                name: "transmission",
                flags: Flags::TRANSMISSION.with(Flags::DELTA),
            },
        ],
        film_thickness: Some(THICKNESS_NM),
        film_thickness_spread: Some(THICKNESS_SPREAD_NM),
        ..ModelInfo::PLAIN
    };

    fn lobes(values: &Values<f32>) -> &'static [LobeInfo] {
        let transmits = values.film().is_some_and(|film| transmits(film));
        &Self::INFO.lobes[..if transmits { 2 } else { 1 }]
    }

    fn prepare<T: Precision>(values: &Values<T>) -> KernelResult<T> {
        let film = values.film().expect("validation refuses a lack of it");
        Ok(Box::new(SmoothFilm {
            film: Arc::clone(film),
            thickness_nm: values.number(THICKNESS_NM),
            spread_nm: values.number(THICKNESS_SPREAD_NM),
            refraction: transmits(film).then(|| Refraction::through(film)),
        }))
    }
}

/// The note in the plan of a BSDF whose base is not opaque although its film keeps no transmittance.
const LOST_IN_BASE: &str = "what enters the base is absorbed, as the film keeps no transmittance";

/// Whether the BSDF has transmission.
fn transmits(film: &Film) -> bool {
    film.description().transmittance && !film.is_base_opaque()
}

/// The refraction of directions between the half-spaces.
#[derive(Clone, Copy)]
struct Refraction<T> {
    interface: Interface<T>,
    /// The index of the base over that of the ambient.
    eta: T,
    /// Whether the indices are equal. Then directions pass without rounding.
    is_straight: bool,
}

impl<T: Precision> Refraction<T> {
    fn through(film: &Film) -> Self {
        Self::at(film, DIRECTION_NM)
    }

    /// The refraction of a vacuum wavelength, nm.
    fn at(film: &Film, lambda_nm: f64) -> Self {
        let [ambient, base] = film.half_spaces().map(|medium| medium.index(lambda_nm).re);
        Self {
            interface: Interface::new(T::new(ambient), T::new(base)),
            eta: T::new(base / ambient),
            is_straight: ambient == base,
        }
    }

    /// The direction of the light that leaves along wo after refraction, and the index on its side over
    /// that on wo's side; `None` beyond the critical angle. The direction is normalised, because refraction
    /// out of a dense base magnifies what rounding has left of the length of wo.
    #[inline(always)]
    fn behind(&self, wo: Vec3<T>) -> Option<(Vec3<T>, T)> {
        let back = wo.scaled(T::new(-1.0));
        if self.is_straight {
            return Some((back, T::new(1.0)));
        }
        let (wi, eta) = if wo.z > T::new(0.0) {
            (self.interface.inside(wo).scaled(T::new(-1.0)), self.eta)
        } else {
            (self.interface.outside(back), T::new(1.0) / self.eta)
        };
        (wi.z != T::new(0.0)).then(|| (wi.normalized(), eta))
    }
}

/// The compiled model.
pub struct SmoothFilm<T> {
    film: Arc<Film>,
    thickness_nm: T,
    /// The standard deviation of the thickness.
    spread_nm: T,
    /// `None` if nothing is transmitted.
    refraction: Option<Refraction<T>>,
}

/// The split of the light of one direction into reflection and transmission.
struct Split<T> {
    /// The reflected fraction of the power.
    reflected: Rgb<T>,
    /// The transmitted fraction of the power.
    transmitted: Rgb<T>,
    /// [`Refraction::behind`]; `None` if nothing is transmitted.
    behind: Option<(Vec3<T>, T)>,
}

impl<T: Precision> SmoothFilm<T> {
    #[inline(always)]
    fn split(&self, overrides: &[(usize, [T; 3])], wo: Vec3<T>) -> Split<T> {
        let number = |param: usize, own: T| {
            let varied = overrides.iter().find(|(varied, _)| *varied == param);
            varied.map_or(own, |(_, value)| value[0]).to_f32()
        };
        let thickness = number(THICKNESS_NM, self.thickness_nm);
        let spread = number(THICKNESS_SPREAD_NM, self.spread_nm);
        let cos_theta = wo.z.abs().to_f32();
        let Some(refraction) = &self.refraction else {
            let reflectance = if spread == 0.0 {
                self.film.reflectance(cos_theta, thickness)
            } else {
                self.film.spread_or_plain(cos_theta, thickness, spread)
            };
            return Split::new(reflectance, [0.0; 3], None);
        };
        let behind = refraction.behind(wo);
        // They cannot fail, because there is a refraction only if the film keeps its transmittance, and creation
        // refuses a spread that the film has no averages for.
        let from = |side, cos| {
            let colors = if spread == 0.0 {
                self.film.colors(side, cos, thickness)
            } else {
                self.film.colors_spread(side, cos, thickness, spread)
            };
            colors.unwrap_or_default()
        };
        if wo.z > T::new(0.0) {
            let colors = from(Side::Ambient, cos_theta);
            let transmittance = behind.map_or([0.0; 3], |_| colors.transmittance);
            return Split::new(colors.reflectance, transmittance, behind);
        }
        let reflectance = from(Side::Base, cos_theta).reflectance;
        let transmittance = behind.map_or([0.0; 3], |(wi, _)| {
            from(Side::Ambient, wi.z.to_f32()).transmittance
        });
        Split::new(reflectance, transmittance, behind)
    }
}

impl<T: Precision> SmoothFilm<T> {
    /// The reflected and the transmitted part of the power at each wavelength of a call, by wave optics.
    fn powers(
        &self,
        thickness_nm: T,
        wo: Vec3<T>,
        call: &SpectralCall<T>,
    ) -> [PerWavelength<T>; 2] {
        let side = if wo.z > T::new(0.0) {
            Side::Ambient
        } else {
            Side::Base
        };
        let ray = |j: usize| Ray {
            cos_theta: wo.z.abs().into(),
            thickness_nm: thickness_nm.into(),
            wavelength_nm: call.lambda_nm[j].into(),
        };
        let [mut reflected, mut transmitted] = [[T::new(0.0); MAX_WAVELENGTHS]; 2];
        self.film.each_response(side, call.count, ray, |j, found| {
            reflected[j] = T::new(found.unpolarized_reflectance());
            if self.refraction.is_some() {
                transmitted[j] = T::new(found.unpolarized_transmittance());
            }
        });
        [reflected, transmitted]
    }
}

impl<T: Precision> Split<T> {
    #[inline(always)]
    fn new(reflectance: Rgb<f32>, transmittance: Rgb<f32>, behind: Option<(Vec3<T>, T)>) -> Self {
        let t = transmittance.map(|channel| channel.clamp(0.0, 1.0));
        let r = std::array::from_fn(|channel| reflectance[channel].min(1.0 - t[channel]).max(0.0));
        Self {
            reflected: in_precision(r),
            transmitted: in_precision(t),
            behind,
        }
    }

    /// The probability of choosing each lobe that takes part, in proportion to the mean of its power over
    /// the channels.
    #[inline(always)]
    fn choose(&self, lobes: LobeSet) -> PerLobe<T> {
        let mut shares = [T::new(0.0); MAX_LOBES];
        for (lobe, power) in [
            (REFLECTION_LOBE, self.reflected),
            (TRANSMISSION_LOBE, self.transmitted),
        ] {
            if lobes.contains(lobe) {
                shares[lobe] = mean(power);
            }
        }
        normalized(shares)
    }

    /// The throughput of a lobe for radiance or importance.
    #[inline(always)]
    fn throughput(&self, lobe: usize, transport: Transport) -> Rgb<T> {
        if lobe == REFLECTION_LOBE {
            return self.reflected;
        }
        let factor = match (self.behind, transport) {
            (Some((_, eta)), Transport::Radiance) => T::new(1.0) / eta.squared(),
            (Some(_), Transport::Importance) => T::new(1.0),
            (None, _) => T::new(0.0),
        };
        self.transmitted.map(|channel| channel * factor)
    }
}

fn in_precision<T: Real>(rgb: Rgb<f32>) -> Rgb<T> {
    rgb.map(|channel| T::new(f64::from(channel)))
}

impl<T: Precision> Kernel<T> for SmoothFilm<T> {
    fn sample(
        &self,
        wo: Vec3<T>,
        u: [T; 3],
        varying: &VaryingValues<T>,
        lobes: LobeSet,
        transport: Transport,
    ) -> Direction<T> {
        let draw = |split: Split<T>| {
            let shares = split.choose(lobes);
            let lobe = only(&chosen_lobe(&shares, u[0]))?;
            let (wi, eta) = if lobe == REFLECTION_LOBE {
                (wo.mirrored(), T::new(1.0))
            } else {
                split.behind?
            };
            let throughput = split.throughput(lobe, transport);
            Some(Direction {
                wi,
                pdf: T::new(0.0),
                weight: throughput.map(|channel| channel / shares[lobe]),
                eta,
                lobe: T::new(lobe as f64),
                lobe_probability: shares[lobe],
            })
        };
        with_overrides(varying, |overrides| self.split(overrides, wo))
            .and_then(draw)
            .unwrap_or(Direction::none())
    }

    /// A lobe is chosen by the hero's split. The direction of refraction is the hero's too, which the other wavelengths
    /// share only where neither half-space disperses.
    fn sample_spectral(
        &self,
        wo: Vec3<T>,
        u: [T; 3],
        call: &SpectralCall<T>,
        found: &mut SpectralValues<T>,
    ) -> (Direction<T>, bool) {
        let nothing = (Direction::none(), false);
        // Nothing that varies is a colour, so that all wavelengths have the same values.
        let thickness_nm = with_overrides(&call.varying, |overrides| {
            let varied = overrides.iter().find(|(param, _)| *param == THICKNESS_NM);
            varied.map_or(self.thickness_nm, |(_, value)| value[0])
        });
        let Some(thickness_nm) = thickness_nm else {
            return nothing;
        };
        let [reflected, mut transmitted] = self.powers(thickness_nm, wo, call);
        let refraction = |j: usize| Refraction::<T>::at(&self.film, call.lambda_nm[j].into());
        let behind = self
            .refraction
            .and_then(|_| refraction(call.hero).behind(wo));
        if behind.is_none() {
            // A base that absorbs a little takes light at angles of total reflection, which has no direction.
            transmitted[call.hero] = T::new(0.0);
        }
        let split = |j: usize| Split {
            reflected: [reflected[j]; 3],
            transmitted: [transmitted[j]; 3],
            behind,
        };
        let shares = split(call.hero).choose(call.lobes);
        let Some(lobe) = only(&chosen_lobe(&shares, u[0])) else {
            return nothing;
        };
        let (wi, eta) = match (lobe, behind) {
            (REFLECTION_LOBE, _) => (wo.mirrored(), T::new(1.0)),
            (_, Some(behind)) => behind,
            _ => return nothing,
        };
        let hero_index = refraction(call.hero).eta;
        let is_hero_only =
            lobe == TRANSMISSION_LOBE && (0..call.count).any(|j| refraction(j).eta != hero_index);
        for j in (0..call.count).filter(|j| !is_hero_only || *j == call.hero) {
            let split = split(j);
            found.value[j] = split.throughput(lobe, call.transport)[0];
            found.pdf[j] = split.choose(call.lobes)[lobe];
        }
        found.weigh(call.count);
        let drawn = Direction {
            wi,
            pdf: T::new(0.0),
            weight: [found.value[call.hero]; 3],
            eta,
            lobe: T::new(lobe as f64),
            lobe_probability: shares[lobe],
        };
        (drawn, is_hero_only)
    }

    fn film(&self) -> Option<&Film> {
        Some(&self.film)
    }

    fn albedo(&self, wo: Vec3<T>, varying: &VaryingValues<T>, lobes: LobeSet) -> Rgb<T> {
        let sum = |split: Split<T>| {
            let [r, t] = [REFLECTION_LOBE, TRANSMISSION_LOBE].map(|lobe| {
                if lobes.contains(lobe) {
                    split.throughput(lobe, Transport::Radiance)
                } else {
                    [T::new(0.0); 3]
                }
            });
            std::array::from_fn(|channel| r[channel] + t[channel])
        };
        with_overrides(varying, |overrides| self.split(overrides, wo)).map_or([T::new(0.0); 3], sum)
    }

    fn lobes(
        &self,
        wo: Vec3<T>,
        _wi: Vec3<T>,
        varying: &VaryingValues<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        let none = [T::new(0.0); MAX_LOBES];
        let split = with_overrides(varying, |overrides| self.split(overrides, wo));
        (split.map_or(none, |split| split.choose(LobeSet::ALL)), none)
    }

    fn is_two_sided(&self) -> bool {
        self.refraction.is_some()
    }

    fn plan(&self) -> Vec<&'static str> {
        let is_lost = self.refraction.is_none() && !self.film.is_base_opaque();
        is_lost.then_some(LOST_IN_BASE).into_iter().collect()
    }
}
