//! The terms of the layered model: the upper boundary, lobe shapes, and the parts that interfere.

use crate::num::{Lane, Real};
use crate::optics::{Interface, normal_reflectance};

/// Which terms and which special cases the values that do not vary lead to.
#[derive(Clone, Copy, Debug)]
pub(super) struct TermsUsed {
    /// Whether the layer has one index for all channels. Then only the phase differs between the channels.
    pub is_gray: bool,
    /// Whether the lower boundary is always parallel to the upper one.
    pub is_parallel: bool,
    /// Whether the specular weight is above 0.
    pub specular: bool,
    /// Whether the diffuse weight is above 0.
    pub diffuse: bool,
}

/// The upper boundary.
#[derive(Clone, Copy)]
pub(super) struct Upper<C> {
    pub interface: Interface<C>,
    /// Reflectance at normal incidence, f of eq. 8.
    pub f0: C,
    /// (r0 / r1)^2.
    pub compression: C,
}

impl<C: Real> Upper<C> {
    /// The boundary between media of the indices r0 and r1.
    #[inline(always)]
    pub fn new(r0: C, r1: C) -> Self {
        let interface = Interface::new(r0, r1);
        Self {
            interface,
            f0: normal_reflectance(r0, r1),
            compression: interface.ratio_squared(),
        }
    }

    /// The boundary of the first channel in all channels. Where all channels are equal, the compiler then
    /// computes one.
    #[inline(always)]
    pub fn gray<T: Lane<Rgb = C>>(&self) -> Self {
        let [f0, ..] = T::channels(self.f0);
        let [compression, ..] = T::channels(self.compression);
        Self {
            interface: self.interface.gray::<T>(),
            f0: f0.gray(),
            compression: compression.gray(),
        }
    }
}

/// The terms of the specular part, without the weights.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpecularTerms<C> {
    /// R of eq. 6, or f_R.
    pub reflected: C,
    /// T of eq. 10, or f_T.
    pub transmitted: C,
    /// sqrt(R T)
    pub amplitude: C,
    /// 2 Phi of eq. 3 (the phase difference of eq. 5), in turns: Phi / pi.
    pub turns: C,
}

impl<C: Real> SpecularTerms<C> {
    /// (R + T + 2 cos(2 Phi) sqrt(R T)) / 2: eq. 5.
    #[inline(always)]
    pub fn interference(&self) -> C {
        C::new(0.5) * (self.reflected + self.transmitted) + self.turns.cos_turns() * self.amplitude
    }
}

/// The shapes of both lobes at a pair of directions, which value and density share.
#[derive(Clone, Copy)]
pub(super) struct Shapes<T: Lane> {
    /// The square root of max(0, <r_i, wo>)^e0.
    pub mirror_root: T,
    /// The square root of max(0, <r_ii, -i_o>)^e1; 0 under the null conditions.
    pub refracted_root: T::Rgb,
    /// The cosines of the light's and the viewer's ray inside the layer.
    pub cos_ii: T::Rgb,
    pub cos_io: T::Rgb,
}

impl<T: Lane> Shapes<T> {
    /// max(0, <r_i, wo>)^e0.
    #[inline(always)]
    pub fn mirror(&self) -> T {
        self.mirror_root.squared()
    }

    /// max(0, <r_ii, -i_o>)^e1; 0 under the null conditions.
    #[inline(always)]
    pub fn refracted(&self) -> T::Rgb {
        self.refracted_root.squared()
    }
}

/// 2 sqrt(T_d (1 - T_d)) of eq. 16.
#[inline(always)]
pub(super) fn diffuse_contrast<T: Real>(r0: T, r1: T) -> T {
    let average = average_transmittance(r0, r1);
    T::new(2.0) * (average * (T::new(1.0) - average)).sqrt_positive()
}

/// T_d = 80/21 r0 r1 / (r1 + r0)^2: eq. 13, the complement of eq. 12.
#[inline(always)]
pub(super) fn average_transmittance<T: Real>(r0: T, r1: T) -> T {
    T::new(80.0 / 21.0) * r0 * r1 / (r1 + r0).squared()
}
