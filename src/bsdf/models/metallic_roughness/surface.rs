//! The compiled model and its surface.

use super::params::{
    BASE_COLOR, DIELECTRIC_FROM, DIFFUSE_FORM, DIFFUSE_LOBE, DIFFUSE_ROUGHNESS, DISNEY, ETA, F0,
    FROM_ETA, METALLIC, OREN_NAYAR, ROUGHNESS, SIGMA_RADIANS, SPECULAR_LOBE,
};
use crate::bsdf::compiled::Compiled;
use crate::bsdf::lobes::{LobeSet, MAX_LOBES, PerLobe, normalized};
use crate::bsdf::models::disney_diffuse;
use crate::bsdf::models::microfacet::energy::{Albedo, Energy, LEAST_ALPHA, Reflected, Row};
use crate::bsdf::models::microfacet::ggx::Ggx;
use crate::bsdf::models::microfacet::half_vector::HalfVector;
use crate::bsdf::models::microfacet::masking::Masking;
use crate::bsdf::models::microfacet::ndf::Ndf;
use crate::bsdf::models::oren_nayar::Grooves;
use crate::bsdf::models::power_lobe::mean;
use crate::bsdf::precision::Precision;
use crate::bsdf::surface::Surface;
use crate::bsdf::values::Values;
use crate::num::{Lane, PI, Real, Rgb, Vec3, warp};
use crate::optics::{normal_reflectance, schlick};

/// The least divisor 1 - E_avg, which is the error of the table. With F0 within 1e-3 of 1, where the
/// divisor would be less, the diffuse part is darker than energy conservation requires.
const LEAST_REMAINDER: f64 = 1e-3;

/// The least share of the highlight in sampling, so that it is sampled even where the error of the table is
/// greater than its albedo.
const LEAST_SHARE: f64 = 1e-3;

/// The compiled model.
pub(super) struct CompiledMaterial<T: Lane> {
    energy: Energy<T>,
    settings: Settings<T>,
}

/// The form of the diffuse part, with its coefficients.
#[derive(Clone, Copy)]
enum DiffuseForm<T> {
    Lambert,
    OrenNayar(Grooves<T>),
    Disney(T),
}

#[derive(Clone, Copy)]
struct Settings<T: Lane> {
    base_color: T::Rgb,
    metallic: T,
    alpha: T,
    row: Row<T>,
    /// Whether `f0` follows from `eta`.
    is_by_index: bool,
    /// F0 of the dielectric.
    f0: T,
    diffuse: DiffuseForm<T>,
}

impl<T: Precision> CompiledMaterial<T> {
    pub(super) fn new(values: &Values<T>) -> Self {
        let lobe = |alpha, wo, u| {
            let ndf = Ggx::isotropic(alpha);
            Reflected::by_ndf(&ndf, Masking::Smith, [alpha; 2], wo, u)
        };
        let alpha: T = alpha_of(values.number(ROUGHNESS));
        let energy = if values.varies(ROUGHNESS) {
            Energy::over_alpha(lobe)
        } else {
            let alpha = alpha.into();
            Energy::of_alpha(alpha, |wo, u| lobe(alpha, wo, u))
        };
        let energy = energy.rounded::<T>();
        let is_by_index = values.choice(DIELECTRIC_FROM) == FROM_ETA;
        let settings = Settings {
            base_color: T::rgb(values.rgb(BASE_COLOR)),
            metallic: values.number(METALLIC),
            alpha,
            row: energy.row(alpha),
            is_by_index,
            f0: if is_by_index {
                normal_reflectance(T::new(1.0), values.number(ETA))
            } else {
                values.number(F0)
            },
            diffuse: match values.choice(DIFFUSE_FORM) {
                OREN_NAYAR => DiffuseForm::OrenNayar(Grooves::new(values.number(SIGMA_RADIANS))),
                DISNEY => DiffuseForm::Disney(values.number(DIFFUSE_ROUGHNESS)),
                _ => DiffuseForm::Lambert,
            },
        };
        Self { energy, settings }
    }
}

impl<T: Precision> Compiled<T> for CompiledMaterial<T> {
    type Surface<'a, L: Lane<Scalar = T>> = MaterialSurface<'a, L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> MaterialSurface<'_, L> {
        let settings = &self.settings;
        MaterialSurface {
            has_diffuse: true,
            has_highlight: true,
            energy: &self.energy,
            settings: Settings {
                base_color: L::splat_rgb(settings.base_color),
                metallic: L::splat(settings.metallic),
                alpha: L::splat(settings.alpha),
                row: settings.row.splat(),
                is_by_index: settings.is_by_index,
                f0: L::splat(settings.f0),
                diffuse: match &settings.diffuse {
                    DiffuseForm::Lambert => DiffuseForm::Lambert,
                    DiffuseForm::OrenNayar(grooves) => DiffuseForm::OrenNayar(grooves.splat()),
                    DiffuseForm::Disney(roughness) => DiffuseForm::Disney(L::splat(*roughness)),
                },
            },
        }
    }
}

#[inline(always)]
fn alpha_of<T: Real>(roughness: T) -> T {
    roughness.squared().max(T::new(LEAST_ALPHA))
}

/// The surface for one call, or one in each lane.
pub(super) struct MaterialSurface<'a, T: Lane> {
    /// Whether each of the two lobes takes part.
    has_diffuse: bool,
    has_highlight: bool,
    energy: &'a Energy<T::Scalar>,
    settings: Settings<T>,
}

impl<P: Precision, T: Lane<Scalar = P>> MaterialSurface<'_, T> {
    /// F0 of the highlight, interpolated from that of the dielectric to the base colour.
    #[inline(always)]
    fn specular_f0(&self) -> T::Rgb {
        let Settings {
            base_color,
            metallic,
            f0,
            ..
        } = self.settings;
        (f0 * (T::new(1.0) - metallic)).gray() + base_color * metallic.gray()
    }

    #[inline(always)]
    fn albedo_at(&self, w: Vec3<T>) -> Albedo<T> {
        self.energy.albedo(&self.settings.row, w.z)
    }

    /// 1 - E of the dielectric.
    #[inline(always)]
    fn remainder(&self, albedo: &Albedo<T>) -> T {
        let one = T::new(1.0);
        one - albedo.under_schlick(self.settings.f0, one)
    }

    /// The factor of the diffuse part: (1 - metallic) (1 - E(wo)) (1 - E(wi)) / (1 - E_avg).
    #[inline(always)]
    fn coupling(&self, wo: Vec3<T>, wi: Vec3<T>) -> T {
        let remainders = self.remainder(&self.albedo_at(wo)) * self.remainder(&self.albedo_at(wi));
        let mean = self.remainder(&self.settings.row.mean);
        let is_dielectric = T::new(1.0) - self.settings.metallic;
        is_dielectric * remainders / mean.max(T::new(LEAST_REMAINDER))
    }

    /// f_d |wi.z|, divided by an upper bound of its albedo where that exceeds 1.
    #[inline(always)]
    fn diffuse(&self, wo: Vec3<T>, wi: Vec3<T>) -> T::Rgb {
        let base_color = self.settings.base_color;
        let (value, greatest) = match self.settings.diffuse {
            DiffuseForm::Lambert => return base_color * (wi.z * T::new(1.0 / PI)).gray(),
            DiffuseForm::OrenNayar(grooves) => (
                grooves.full(base_color, wo, wi),
                grooves.albedo_at_horizon(base_color),
            ),
            DiffuseForm::Disney(roughness) => (
                base_color * disney_diffuse::value(roughness, wo, wi).gray(),
                base_color * disney_diffuse::greatest_albedo(roughness).gray(),
            ),
        };
        // With F0 near 1 the remainder 1 - E is at grazing angles, where these forms are brightest. The
        // bound is our own, and tested over the whole range of parameters.
        let steep = T::new(0.0035) / (T::new(1.002) - self.settings.f0);
        value / (greatest + base_color * steep.gray()).max(T::Rgb::new(1.0))
    }
}

impl<P: Precision, T: Lane<Scalar = P>> Surface<T> for MaterialSurface<'_, T> {
    #[inline(always)]
    fn vary(&mut self, param: usize, value: [T; 3]) {
        let settings = &mut self.settings;
        let number = value[0];
        match param {
            BASE_COLOR => settings.base_color = T::rgb(value),
            METALLIC => settings.metallic = number,
            ROUGHNESS => {
                settings.alpha = alpha_of(number);
                settings.row = self.energy.row(settings.alpha);
            }
            ETA => settings.f0 = normal_reflectance(T::new(1.0), number),
            F0 => settings.f0 = number,
            SIGMA_RADIANS => settings.diffuse = DiffuseForm::OrenNayar(Grooves::new(number)),
            DIFFUSE_ROUGHNESS => settings.diffuse = DiffuseForm::Disney(number),
            _ => {}
        }
    }

    #[inline(always)]
    fn retain(&mut self, lobes: LobeSet) {
        self.has_diffuse = lobes.contains(DIFFUSE_LOBE);
        self.has_highlight = lobes.contains(SPECULAR_LOBE);
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.eval_with_densities(wo, wi).0
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let alpha = self.settings.alpha;
        let ndf = Ggx::isotropic(alpha);
        let pair = HalfVector::new(wo, wi);
        let masking = ndf.smith(&pair);
        let d = ndf.density_between(&pair);
        let highlight = d * masking;
        let fresnel = schlick(self.specular_f0(), pair.cos_half.gray());
        let diffuse = self.diffuse(wo, wi) * self.coupling(wo, wi).gray();
        let mut value = fresnel * highlight.gray() + diffuse;
        if !(self.has_diffuse && self.has_highlight) {
            value = match (self.has_diffuse, self.has_highlight) {
                (true, _) => diffuse,
                (_, true) => fresnel * highlight.gray(),
                _ => T::Rgb::new(0.0),
            };
        }
        let value = T::channels(value);
        let mut densities = [T::new(0.0); MAX_LOBES];
        densities[DIFFUSE_LOBE] = warp::cosine_hemisphere_pdf(wi.z);
        densities[SPECULAR_LOBE] = ndf.reflected_density(&pair, d);
        (value, densities)
    }

    /// The lobes are chosen in proportion to their albedos, which for the highlight come from the table.
    #[inline(always)]
    fn choose(&self, wo: Vec3<T>) -> PerLobe<T> {
        let one = T::new(1.0);
        let albedo = self.albedo_at(wo);
        let f0 = mean(T::channels(self.specular_f0()));
        let reflectance = mean(T::channels(self.settings.base_color));
        let mut shares = [T::new(0.0); MAX_LOBES];
        shares[DIFFUSE_LOBE] =
            (one - self.settings.metallic) * reflectance * self.remainder(&albedo);
        shares[SPECULAR_LOBE] = albedo.under_schlick(f0, one).max(T::new(LEAST_SHARE));
        normalized(shares)
    }

    #[inline(always)]
    fn sample(&self, lobe: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        if lobe == DIFFUSE_LOBE {
            warp::cosine_hemisphere(u[0], u[1])
        } else {
            let h = Ggx::isotropic(self.settings.alpha).sample(wo, u);
            wo.mirrored_about(h)
        }
    }
}
