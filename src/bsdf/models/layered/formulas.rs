//! The formulas of the layered model, eq. 1-16, in both variants.

use super::super::power_lobe::{Power, conserving_normalization};
use super::params::{
    AMBIENT_ETA, BASE, BASE_NORMAL, DIFFUSE_WEIGHT, ETA, EXPONENT_REFLECTION,
    EXPONENT_TRANSMISSION, PHASE_SHIFT, PHASE_SHIFT_HALF_WAVE, SPECULAR_WEIGHT, THICKNESS_NM,
    VARIANT, VARIANT_PAPER,
};
use super::terms::{Shapes, SpecularTerms, TermsUsed, Upper, diffuse_contrast};
use crate::bsdf::compiled::Compiled;
use crate::bsdf::precision::Precision;
use crate::bsdf::values::Values;
use crate::num::{Lane, PI, Real, Rgb, Vec3, each};
use crate::optics::{RGB_WAVELENGTHS_NM, index_between, schlick, schlick_transmittance};

/// The values of the parameters and what follows from them, for one surface or for one in each lane.
///
/// Quantities that depend on the wavelength have the type [`Lane::Rgb`]: the formulas are written for one
/// channel and evaluated for three at once.
#[derive(Clone, Copy)]
pub struct LayeredSurface<T: Lane> {
    pub(super) upper: Upper<T::Rgb>,
    /// Reflectance of the lower boundary.
    pub(super) base: T::Rgb,
    pub(super) exponent_reflection: T,
    pub(super) exponent_transmission: T,
    power_reflection: Power<T>,
    power_transmission: Power<T>,
    pub(super) base_normal: Vec3<T>,
    pub(super) specular_weight: T,
    pub(super) diffuse_weight: T,
    pub(super) is_paper: bool,
    /// The factors of R and T: 1 in `paper`, the normalisations of the lobes in `energy`.
    pub(super) scale_reflection: T,
    pub(super) scale_transmission: T,
    /// rho_d of eq. 16 at `thickness_nm`.
    pub(super) rho_d: T::Rgb,
    /// Turns of phase per nanometre of path in the layer, r1 / lambda.
    turns_per_nm: T::Rgb,
    /// 2 sqrt(T_d (1 - T_d)) of eq. 16.
    diffuse_contrast: T::Rgb,
    thickness_nm: T,
    /// Added to 2 Phi, in turns.
    phase_shift: T,
    pub(super) terms_used: TermsUsed,
}

impl<T: Precision> Compiled<T> for LayeredSurface<T> {
    type Surface<'a, L: Lane<Scalar = T>> = LayeredSurface<L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> LayeredSurface<L> {
        let [nx, ny, nz] = each!(self.base_normal.to_array(), |number| L::splat(number));
        LayeredSurface {
            upper: Upper {
                interface: self.upper.interface.map(L::splat_rgb),
                f0: L::splat_rgb(self.upper.f0),
                compression: L::splat_rgb(self.upper.compression),
            },
            base: L::splat_rgb(self.base),
            exponent_reflection: L::splat(self.exponent_reflection),
            exponent_transmission: L::splat(self.exponent_transmission),
            power_reflection: self.power_reflection.splat(),
            power_transmission: self.power_transmission.splat(),
            base_normal: Vec3::new(nx, ny, nz),
            specular_weight: L::splat(self.specular_weight),
            diffuse_weight: L::splat(self.diffuse_weight),
            is_paper: self.is_paper,
            scale_reflection: L::splat(self.scale_reflection),
            scale_transmission: L::splat(self.scale_transmission),
            rho_d: L::splat_rgb(self.rho_d),
            turns_per_nm: L::splat_rgb(self.turns_per_nm),
            diffuse_contrast: L::splat_rgb(self.diffuse_contrast),
            thickness_nm: L::splat(self.thickness_nm),
            phase_shift: L::splat(self.phase_shift),
            terms_used: self.terms_used,
        }
    }

    fn plan(&self) -> Vec<&'static str> {
        let used = &self.terms_used;
        let plan = [
            (!used.specular, "no specular part"),
            (!used.diffuse, "no diffuse part"),
            (used.is_gray, "one index for all channels"),
            (used.is_parallel, "parallel boundaries"),
            (
                self.power_reflection.is_multiplied(),
                "exponent_reflection by products",
            ),
            (
                self.power_transmission.is_multiplied(),
                "exponent_transmission by products",
            ),
        ];
        plan.into_iter().filter_map(chosen).collect()
    }
}

fn chosen((is_used, words): (bool, &'static str)) -> Option<&'static str> {
    is_used.then_some(words)
}

impl<T: Lane> LayeredSurface<T> {
    pub(super) fn new(values: &Values<T>) -> Self
    where
        T: Precision,
    {
        let (zero, one) = (T::new(0.0), T::Rgb::new(1.0));
        let r0 = values.number(AMBIENT_ETA).gray();
        let eta = values.rgb(ETA);
        let r1 = T::rgb(eta);
        let e0 = values.number(EXPONENT_REFLECTION);
        let e1 = values.number(EXPONENT_TRANSMISSION);
        let is_paper = values.choice(VARIANT) == VARIANT_PAPER;
        let is_shifted = values.choice(PHASE_SHIFT) == PHASE_SHIFT_HALF_WAVE;
        let wavelengths = T::rgb(RGB_WAVELENGTHS_NM.map(T::new));
        let scale = |exponent: T| {
            if is_paper {
                T::new(1.0)
            } else {
                conserving_normalization(exponent)
            }
        };
        let base_normal = values.rgb(BASE_NORMAL);
        let (specular_weight, diffuse_weight) = (
            values.number(SPECULAR_WEIGHT),
            values.number(DIFFUSE_WEIGHT),
        );
        let mut surface = Self {
            upper: Upper::new(r0, r1),
            base: T::rgb(values.rgb(BASE)),
            exponent_reflection: e0,
            exponent_transmission: e1,
            power_reflection: Power::of(e0),
            power_transmission: Power::of(e1),
            base_normal: Vec3::from_array(base_normal),
            specular_weight,
            diffuse_weight,
            is_paper,
            scale_reflection: scale(e0),
            scale_transmission: scale(e1),
            rho_d: one,
            turns_per_nm: r1 / wavelengths,
            diffuse_contrast: diffuse_contrast(r0, r1),
            thickness_nm: zero,
            phase_shift: T::new(if is_shifted { 0.5 } else { 0.0 }),
            terms_used: TermsUsed {
                is_gray: eta[0] == eta[1] && eta[0] == eta[2],
                is_parallel: base_normal[0] == zero
                    && base_normal[1] == zero
                    && !values.varies(BASE_NORMAL),
                specular: specular_weight > zero,
                diffuse: diffuse_weight > zero,
            },
        };
        surface.set_thickness(values.number(THICKNESS_NM));
        surface
    }

    /// Sets the thickness and rho_d, which depends on it alone: eq. 16, 1 + 2 cos(4 pi r1 d / lambda)
    /// sqrt(T_d (1 - T_d)).
    #[inline(always)]
    fn set_thickness(&mut self, thickness_nm: T) {
        self.thickness_nm = thickness_nm;
        let path = (T::new(2.0) * thickness_nm).gray();
        let turns = self.turns_per_nm * path + self.phase_shift.gray();
        self.rho_d = T::Rgb::new(1.0) + self.diffuse_contrast * turns.cos_turns();
    }

    /// Takes the index and the phase of one wavelength, nm, in all channels, instead of those of the three wavelengths.
    #[inline(always)]
    pub(super) fn move_to(&mut self, lambda_nm: T) {
        let wavelengths = T::rgb(RGB_WAVELENGTHS_NM.map(T::new));
        let eta = self.turns_per_nm * wavelengths;
        let [ambient_eta, ..] = T::channels(eta * self.upper.interface.ratio());
        let (r0, r1) = (
            ambient_eta.gray(),
            index_between(T::channels(eta), lambda_nm).gray(),
        );
        self.upper = Upper::new(r0, r1);
        self.turns_per_nm = r1 / lambda_nm.gray();
        self.diffuse_contrast = diffuse_contrast(r0, r1);
        self.terms_used.is_gray = true;
        self.set_thickness(self.thickness_nm);
    }

    #[inline(always)]
    pub(super) fn set(&mut self, param: usize, value: [T; 3]) {
        match param {
            THICKNESS_NM => self.set_thickness(value[0]),
            BASE_NORMAL => self.base_normal = Vec3::from_array(value),
            _ => self.base = T::rgb(value),
        }
    }

    /// The value, and the shapes of the lobes for densities; no shapes without a specular part.
    #[inline(always)]
    pub(super) fn eval_shapes(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, Option<Shapes<T>>) {
        if !self.terms_used.specular {
            return (self.value(None, wi), None);
        }
        // In lanes, equal channels are computed once. In single calls the channels share a register, so
        // that there is nothing to save.
        if T::COUNT > 1 && self.terms_used.is_gray {
            return self.eval_with(&self.upper.gray::<T>(), wo, wi);
        }
        self.eval_with(&self.upper, wo, wi)
    }

    #[inline(always)]
    fn eval_with(
        &self,
        upper: &Upper<T::Rgb>,
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (Rgb<T>, Option<Shapes<T>>) {
        let shapes = self.shapes(upper, wo, wi);
        let terms = self.terms(upper, wo, wi, &shapes);
        (self.value(Some(&terms), wi), Some(shapes))
    }

    /// Lobe shapes of eq. 6 and 10.
    #[inline(always)]
    pub(super) fn shapes(&self, upper: &Upper<T::Rgb>, wo: Vec3<T>, wi: Vec3<T>) -> Shapes<T> {
        let half = T::new(0.5);
        // <r_i, wo> = 1 - |r_i - wo|^2 / 2 with r_i - wo = (-across, wi.z - wo.z).
        let across = [wo.x + wi.x, wo.y + wi.y];
        let across_squared = across[0].squared() + across[1].squared();
        let complement = half * (across_squared + (wi.z - wo.z).squared());
        let root = self.power_reflection.root(complement);
        // Exponent 0 reflects to the whole hemisphere, also where <r_i, wo> <= 0: eq. 12 is the mean for
        // that case.
        let is_hemispherical = self.exponent_reflection.equals(T::new(0.0));
        let mirror_root = T::select(is_hemispherical, T::new(1.0), root);
        // The rays inside, a = -i_i and b = -i_o, point up.
        let zero = T::Rgb::new(0.0);
        let ratio = upper.interface.ratio();
        let cos_ii = upper.interface.cosine_inside(wi.z.gray());
        let cos_io = upper.interface.cosine_inside(wo.z.gray());
        let is_inside = cos_ii.gt(zero) & cos_io.gt(zero);
        // The difference of r_ii, which is a mirrored about n1, and b.
        let (distance_squared, is_possible) = if self.terms_used.is_parallel {
            let refracted_squared = ratio.squared() * across_squared.gray();
            (refracted_squared + (cos_ii - cos_io).squared(), is_inside)
        } else {
            let n1 = self.base_normal;
            let a_dot_n1 = ratio * (n1.x * wi.x + n1.y * wi.y).gray() + n1.z.gray() * cos_ii;
            let b_dot_n1 = ratio * (n1.x * wo.x + n1.y * wo.y).gray() + n1.z.gray() * cos_io;
            let twice = T::Rgb::new(2.0) * a_dot_n1;
            let difference = Vec3::new(
                n1.x.gray() * twice - ratio * across[0].gray(),
                n1.y.gray() * twice - ratio * across[1].gray(),
                n1.z.gray() * twice - (cos_ii + cos_io),
            );
            let is_seen = is_inside & a_dot_n1.gt(zero) & b_dot_n1.gt(zero);
            (difference.length_squared(), is_seen)
        };
        let root = self
            .power_transmission
            .gray()
            .root(half.gray() * distance_squared);
        Shapes {
            mirror_root,
            // The null conditions after eq. 10 (the third one is in the power), and total reflection.
            refracted_root: T::Rgb::select(is_possible, root, zero),
            cos_ii,
            cos_io,
        }
    }

    /// R, T and the phase: eq. 3 and 6 to 10 (`paper`), or f_R and f_T (`energy`).
    #[inline(always)]
    pub(super) fn terms(
        &self,
        upper: &Upper<T::Rgb>,
        wo: Vec3<T>,
        wi: Vec3<T>,
        shapes: &Shapes<T>,
    ) -> SpecularTerms<T::Rgb> {
        let one = T::Rgb::new(1.0);
        let fresnel_i = schlick(upper.f0, wi.z.gray());
        let (fresnel, crossings) = if self.is_paper {
            let out = schlick_transmittance(upper.f0, shapes.cos_io);
            (fresnel_i, (one - fresnel_i) * out)
        } else {
            let fresnel_o = schlick(upper.f0, wo.z.gray());
            let crossings = (one - fresnel_i) * (one - fresnel_o) * upper.compression;
            (fresnel_i.min(fresnel_o), crossings)
        };
        let reflected = self.scale_reflection.gray() * fresnel;
        let transmitted = self.scale_transmission.gray() * crossings;
        let path = self.thickness_nm.gray() * (shapes.cos_ii + shapes.cos_io);
        // sqrt(R T) is computed from the roots of the lobes, because the product R T may underflow.
        let roots = shapes.mirror_root.gray() * shapes.refracted_root;
        let transmitted = self.base * transmitted;
        SpecularTerms {
            reflected: reflected * shapes.mirror().gray(),
            transmitted: transmitted * shapes.refracted(),
            amplitude: roots * (reflected * transmitted).sqrt(),
            turns: self.turns_per_nm * path + self.phase_shift.gray(),
        }
    }

    /// Factor of rho_d in f: 1 / pi in `paper`, 1 / (2 pi) in `energy`.
    #[inline(always)]
    pub(super) fn diffuse_scale(&self) -> T {
        T::new(if self.is_paper { 1.0 } else { 0.5 }) * T::new(1.0 / PI)
    }

    /// (ks rho + kd rho_d / pi) wi.z, or its counterpart in `energy`.
    #[inline(always)]
    fn value(&self, terms: Option<&SpecularTerms<T::Rgb>>, wi: Vec3<T>) -> Rgb<T> {
        let mut value = T::Rgb::new(0.0);
        if let Some(terms) = terms {
            // At full extinction, rounding may give less than 0.
            value = self.specular_weight.gray() * terms.interference().max(value);
        }
        if self.terms_used.diffuse {
            value = value + (self.diffuse_weight * self.diffuse_scale()).gray() * self.rho_d;
        }
        T::channels(value * wi.z.gray())
    }
}
