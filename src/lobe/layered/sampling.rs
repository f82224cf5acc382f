//! Importance sampling of the layered model: the mirror lobe, one refracted lobe per channel, and
//! the diffuse part, chosen in proportion to their estimated shares.
//!
//! Interference needs no lobe of its own: (R + T + 2 cos sqrt(R T)) / 2 <= R + T, so a mixture of
//! the lobes of R and of T bounds it.

use super::super::power_lobe::{estimated_integral, mean, sample_about, smooth_cosine};
use super::super::scattering::{MAX_LOBES, PerLobe, Scattering, normalized};
use super::prepared::{Prepared, Shapes};
use super::{DIFFUSE_LOBE, MIRROR_LOBE, REFRACTED_LOBE};
use crate::math::{PI, Real, Rgb, Vec3, warp};
use crate::optics::schlick;

impl<T: Real> Scattering<T> for Prepared<T> {
    #[inline(always)]
    fn vary(&mut self, param: usize, value: [T; 3]) {
        self.set(param, value);
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.value(wo, wi, &self.shapes(wo, wi))
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let shapes = self.shapes(wo, wi);
        (self.value(wo, wi, &shapes), self.densities(wi, &shapes))
    }

    #[inline(always)]
    fn selection(&self, wo: Vec3<T>) -> PerLobe<T> {
        let mut shares = [T::new(0.0); MAX_LOBES];
        shares[MIRROR_LOBE] = self.specular_weight * self.mirror_share(wo);
        for c in 0..3 {
            shares[REFRACTED_LOBE + c] = self.specular_weight * self.refracted_share(c, wo);
        }
        let scale = self.diffuse_scale() * T::new(PI);
        shares[DIFFUSE_LOBE] = self.diffuse_weight * scale * mean(self.rho_d());
        normalized(shares)
    }

    #[inline(always)]
    fn sample(&self, lobe: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        match lobe {
            MIRROR_LOBE => self.sample_mirror(wo, u),
            DIFFUSE_LOBE => warp::cosine_hemisphere(u[0], u[1]),
            _ => self.sample_refracted(lobe - REFRACTED_LOBE, wo, u),
        }
    }
}

impl<T: Real> Prepared<T> {
    /// The density of each lobe at wi.
    #[inline(always)]
    fn densities(&self, wi: Vec3<T>, shapes: &Shapes<T>) -> PerLobe<T> {
        let mut densities = [T::new(0.0); MAX_LOBES];
        let diffuse = warp::cosine_hemisphere_pdf(wi.z);
        let mirror = shapes.mirror * warp::power_cosine_normalization(self.exponent_reflection);
        densities[DIFFUSE_LOBE] = diffuse;
        densities[MIRROR_LOBE] = T::select(self.is_hemispherical(), diffuse, mirror);
        let normalization = warp::power_cosine_normalization(self.exponent_transmission);
        for c in 0..3 {
            // cos_i dw_i = (r1 / r0)^2 cos_ii dw_ii turns the density inside into the one outside.
            let jacobian = self.channels[c].compression * wi.z / shapes.cos_ii[c];
            let density = shapes.refracted[c] * normalization * jacobian;
            let possible = shapes.refracted[c].gt(T::new(0.0));
            densities[REFRACTED_LOBE + c] = T::select(possible, density, T::new(0.0));
        }
        densities
    }

    #[inline(always)]
    fn is_hemispherical(&self) -> T::Mask {
        self.exponent_reflection.equals(T::new(0.0))
    }

    /// About the mirror direction of wo, or over the whole hemisphere for exponent 0.
    #[inline(always)]
    fn sample_mirror(&self, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let lobe = sample_about(wo.mirrored(), self.exponent_reflection, u);
        Vec3::select(self.is_hemispherical(), warp::cosine_hemisphere(u[0], u[1]), lobe)
    }

    /// The viewer's ray enters the layer, is mirrored at the lower boundary, spreads by the lobe
    /// inside, and is refracted out again.
    #[inline(always)]
    fn sample_refracted(&self, c: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let zero = T::new(0.0);
        let interface = &self.channels[c].interface;
        let axis = interface.inside(wo).mirrored_about(self.base_normal);
        let a = sample_about(axis, self.exponent_transmission, u);
        let possible = a.z.gt(zero) & a.dot(self.base_normal).gt(zero);
        Vec3::select(possible, interface.outside(a), Vec3::zero())
    }

    /// Estimated albedo of R (without the weight and the division by 2, which all lobes but the
    /// diffuse one share; that one competes with R + T at constructive interference).
    #[inline(always)]
    fn mirror_share(&self, wo: Vec3<T>) -> T {
        let e0 = self.exponent_reflection;
        // A broad lobe sees other incidences than the mirror's: 1/21 is the mean of Schlick's
        // (1 - cos)^5 over the hemisphere (GH02 eq. 12).
        let spread = T::new(1.0 / 21.0) / (e0 + T::new(1.0));
        let fresnel: Rgb<T> = std::array::from_fn(|c| {
            let f0 = self.channels[c].f0;
            schlick(f0, wo.z) + (T::new(1.0) - f0) * spread
        });
        self.scale_reflection * mean(fresnel) * estimated_integral(e0, wo.z)
    }

    /// Estimated albedo of T in one channel, a third of which is the channel's share.
    #[inline(always)]
    fn refracted_share(&self, c: usize, wo: Vec3<T>) -> T {
        let zero = T::new(0.0);
        let channel = &self.channels[c];
        let e1 = self.exponent_transmission;
        let b = channel.interface.inside(wo);
        let axis = b.mirrored_about(self.base_normal);
        // Part of the lobe inside the critical cone: a sigmoid of the axis' distance from it in
        // units of the lobe's spread, with tails heavy enough never to starve what remains.
        let critical = channel.interface.critical_cosine_squared().sqrt();
        let distance = (axis.z - critical) * (e1 + T::new(2.0)).sqrt();
        let inside = T::new(0.5)
            + T::new(0.5) * distance / (T::new(1.0) + distance.squared()).sqrt();
        let exit = smooth_cosine(e1, channel.interface.outside(axis).z).min(T::new(1.0));
        let crossings = (T::new(1.0) - schlick(channel.f0, wo.z))
            * (T::new(1.0) - schlick(channel.f0, exit));
        let lobe = estimated_integral(e1, axis.z.max(critical)) * inside;
        // In `paper` the lobe is measured inside, where directions are denser than outside.
        let density = if self.is_paper { T::new(1.0) / channel.compression } else { T::new(1.0) };
        let share = T::new(1.0 / 3.0) * self.scale_transmission * channel.base * crossings * lobe * density;
        T::select(b.z.gt(zero) & b.dot(self.base_normal).gt(zero), share, zero)
    }
}
