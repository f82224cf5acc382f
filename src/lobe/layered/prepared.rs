//! The formulas of the layered model, eq. 1-16, in both variants.

use super::super::power_lobe::power_of_cosine;
use super::super::values::Values;
use super::{
    AMBIENT_ETA, BASE, BASE_NORMAL, DIFFUSE_WEIGHT, ETA, EXPONENT_REFLECTION,
    EXPONENT_TRANSMISSION, PHASE_SHIFT, PHASE_SHIFT_HALF_WAVE, SPECULAR_WEIGHT, THICKNESS_NM,
    VARIANT, VARIANT_PAPER,
};
use crate::math::{PI, Real, Rgb, Vec3};
use crate::optics::{
    Interface, RGB_WAVELENGTHS_NM, normal_reflectance, schlick, schlick_transmittance,
};

/// The compiled model.
#[derive(Clone, Copy)]
pub struct Prepared<T> {
    pub(super) channels: [Channel<T>; 3],
    pub(super) exponent_reflection: T,
    pub(super) exponent_transmission: T,
    pub(super) base_normal: Vec3<T>,
    pub(super) specular_weight: T,
    pub(super) diffuse_weight: T,
    pub(super) is_paper: bool,
    thickness_nm: T,
    /// Added to 2 Phi, in turns.
    phase_shift: T,
    /// Factors of R and of T: 1 and 1 in `paper`, the lobes' normalisations in `energy`.
    pub(super) scale_reflection: T,
    pub(super) scale_transmission: T,
}

/// What depends on the wavelength.
#[derive(Clone, Copy)]
pub(super) struct Channel<T> {
    pub interface: Interface<T>,
    /// Reflectance of the upper boundary at normal incidence, f of eq. 8.
    pub f0: T,
    /// Reflectance of the lower boundary.
    pub base: T,
    /// (r0 / r1)^2.
    pub compression: T,
    /// r1 / lambda, turns of phase per nanometre.
    turns_per_nm: T,
    /// 2 sqrt(T_d (1 - T_d)) of eq. 16.
    diffuse_contrast: T,
    /// rho_d of eq. 16, at the present thickness.
    pub rho_d: T,
}

/// The three terms of the specular part in one channel, before the weights.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms<T> {
    /// R of eq. 6, or f_R.
    pub reflected: T,
    /// T of eq. 10, or f_T.
    pub transmitted: T,
    /// 2 Phi of eq. 3 (the phase difference of eq. 5), in turns: Phi / pi.
    pub turns: T,
}

impl<T: Real> Terms<T> {
    /// (R + T + 2 cos(2 Phi) sqrt(R T)) / 2: eq. 5.
    #[inline(always)]
    pub(super) fn interference(&self) -> T {
        let amplitude = (self.reflected * self.transmitted).sqrt();
        let half = T::new(0.5);
        half * (self.reflected + self.transmitted) + self.turns.cos_turns() * amplitude
    }
}

/// Both lobes' shapes at a pair of directions: what value and density share.
#[derive(Clone, Copy)]
pub(super) struct Shapes<T> {
    /// max(0, <r_i, wo>)^e0.
    pub mirror: T,
    /// max(0, <r_ii, -i_o>)^e1 per channel, 0 under the null conditions.
    pub refracted: Rgb<T>,
    /// Cosines inside the layer of the light's and the viewer's ray, per channel.
    pub cos_ii: Rgb<T>,
    pub cos_io: Rgb<T>,
}

impl<T: Real> Prepared<T> {
    pub(super) fn new(values: &Values<T>) -> Self {
        let one = T::new(1.0);
        let r0 = values.number(AMBIENT_ETA);
        let e0 = values.number(EXPONENT_REFLECTION);
        let e1 = values.number(EXPONENT_TRANSMISSION);
        let is_paper = values.choice(VARIANT) == VARIANT_PAPER;
        let is_shifted = values.choice(PHASE_SHIFT) == PHASE_SHIFT_HALF_WAVE;
        let channels = std::array::from_fn(|c| {
            let r1 = values.rgb(ETA)[c];
            let interface = Interface::new(r0, r1);
            let average = average_transmittance(r0, r1);
            Channel {
                interface,
                f0: normal_reflectance(r0, r1),
                base: values.rgb(BASE)[c],
                compression: interface.ratio_squared(),
                turns_per_nm: r1 * T::new(1.0 / RGB_WAVELENGTHS_NM[c]),
                diffuse_contrast: T::new(2.0) * (average * (one - average)).sqrt_positive(),
                rho_d: one,
            }
        });
        let normalization = |exponent: T| (exponent + T::new(2.0)) * T::new(0.5 / PI);
        let mut prepared = Self {
            channels,
            exponent_reflection: e0,
            exponent_transmission: e1,
            base_normal: Vec3::from_array(values.rgb(BASE_NORMAL)),
            specular_weight: values.number(SPECULAR_WEIGHT),
            diffuse_weight: values.number(DIFFUSE_WEIGHT),
            is_paper,
            thickness_nm: one,
            phase_shift: T::new(if is_shifted { 0.5 } else { 0.0 }),
            scale_reflection: if is_paper { one } else { normalization(e0) },
            scale_transmission: if is_paper { one } else { normalization(e1) },
        };
        prepared.set_thickness(values.number(THICKNESS_NM));
        prepared
    }

    /// The diffuse part depends on the thickness alone, so it is kept with it: eq. 16,
    /// 1 + 2 cos(4 pi r1 d / lambda) sqrt(T_d (1 - T_d)).
    fn set_thickness(&mut self, thickness_nm: T) {
        self.thickness_nm = thickness_nm;
        for channel in &mut self.channels {
            let turns = T::new(2.0) * channel.turns_per_nm * thickness_nm + self.phase_shift;
            channel.rho_d = T::new(1.0) + channel.diffuse_contrast * turns.cos_turns();
        }
    }

    #[inline(always)]
    pub(super) fn set(&mut self, param: usize, value: [T; 3]) {
        match param {
            THICKNESS_NM => self.set_thickness(value[0]),
            BASE_NORMAL => self.base_normal = Vec3::from_array(value),
            _ => {
                for (channel, base) in self.channels.iter_mut().zip(value) {
                    channel.base = base;
                }
            }
        }
    }

    /// Lobe shapes of eq. 6 and 10.
    #[inline(always)]
    pub(super) fn shapes(&self, wo: Vec3<T>, wi: Vec3<T>) -> Shapes<T> {
        let zero = T::new(0.0);
        let power = power_of_cosine(wi.mirrored(), wo, self.exponent_reflection);
        // Exponent 0 reflects to the whole hemisphere, also where <r_i, wo> <= 0: eq. 12 averages
        // that case.
        let whole = self.exponent_reflection.equals(zero);
        let mirror = T::select(whole, T::new(1.0), power);
        let n1 = self.base_normal;
        let mut shapes = Shapes { mirror, refracted: [zero; 3], cos_ii: [zero; 3], cos_io: [zero; 3] };
        for (c, channel) in self.channels.iter().enumerate() {
            // a = -i_i and b = -i_o: both rays inside, pointing up. r_ii is the mirror of a at n1.
            let a = channel.interface.inside(wi);
            let b = channel.interface.inside(wo);
            let power = power_of_cosine(a.mirrored_about(n1), b, self.exponent_transmission);
            // Null conditions after eq. 10 (the third is in the power), and total reflection.
            let possible = a.dot(n1).gt(zero) & b.dot(n1).gt(zero) & a.z.gt(zero) & b.z.gt(zero);
            shapes.refracted[c] = T::select(possible, power, zero);
            shapes.cos_ii[c] = a.z;
            shapes.cos_io[c] = b.z;
        }
        shapes
    }

    /// R, T and phase of one channel: eq. 3, 6, 7, 8, 9, 10 (`paper`), f_R and f_T (`energy`).
    #[inline(always)]
    pub(super) fn terms_of(&self, c: usize, wo: Vec3<T>, wi: Vec3<T>, shapes: &Shapes<T>) -> Terms<T> {
        let one = T::new(1.0);
        let channel = &self.channels[c];
        let fresnel_i = schlick(channel.f0, wi.z);
        let fresnel_o = schlick(channel.f0, wo.z);
        let (fresnel, crossings) = if self.is_paper {
            let out = schlick_transmittance(channel.f0, shapes.cos_io[c]);
            (fresnel_i, (one - fresnel_i) * out)
        } else {
            let both = (one - fresnel_i) * (one - fresnel_o) * channel.compression;
            (fresnel_i.min(fresnel_o), both)
        };
        let path = self.thickness_nm * (shapes.cos_ii[c] + shapes.cos_io[c]);
        Terms {
            reflected: self.scale_reflection * fresnel * shapes.mirror,
            transmitted: self.scale_transmission * channel.base * crossings * shapes.refracted[c],
            turns: channel.turns_per_nm * path + self.phase_shift,
        }
    }

    /// rho_d of eq. 16 per channel: 0 to 2.
    pub(super) fn rho_d(&self) -> Rgb<T> {
        self.channels.map(|channel| channel.rho_d)
    }

    /// Factor of rho_d in f: 1 / pi in `paper`, 1 / (2 pi) in `energy`.
    #[inline(always)]
    pub(super) fn diffuse_scale(&self) -> T {
        T::new(if self.is_paper { 1.0 } else { 0.5 }) * T::new(1.0 / PI)
    }

    /// (ks rho + kd rho_d / pi) wi.z, or its counterpart in `energy`.
    #[inline(always)]
    pub(super) fn value(&self, wo: Vec3<T>, wi: Vec3<T>, shapes: &Shapes<T>) -> Rgb<T> {
        let diffuse = self.diffuse_weight * self.diffuse_scale();
        std::array::from_fn(|c| {
            let specular = self.terms_of(c, wo, wi, shapes).interference();
            // Full extinction may round below 0.
            let specular = specular.max(T::new(0.0));
            (self.specular_weight * specular + diffuse * self.channels[c].rho_d) * wi.z
        })
    }
}

/// T_d = 80/21 r0 r1 / (r1 + r0)^2: eq. 13, the complement of eq. 12.
fn average_transmittance<T: Real>(r0: T, r1: T) -> T {
    T::new(80.0 / 21.0) * r0 * r1 / (r1 + r0).squared()
}
