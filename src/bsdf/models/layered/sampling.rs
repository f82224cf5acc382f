//! Importance sampling of the layered model. The lobes are the mirror lobe, one refracted lobe per channel,
//! and the diffuse part; they are chosen in proportion to their estimated shares.
//!
//! Interference needs no lobe of its own: (R + T + 2 cos sqrt(R T)) / 2 <= R + T, so that a mixture of the
//! lobes of R and T bounds it.

use super::super::power_lobe::{estimated_integral, mean, sample_about, smooth_cosine};
use super::formulas::LayeredSurface;
use super::params::{DIFFUSE_LOBE, MIRROR_LOBE, REFRACTED_LOBE};
use super::terms::Shapes;
use crate::bsdf::lobes::{LobeSet, MAX_LOBES, PerLobe, normalized};
use crate::bsdf::surface::Surface;
use crate::num::{Lane, PI, Real, Rgb, Vec3, warp};
use crate::optics::{schlick, schlick_transmittance};

impl<T: Lane> Surface<T> for LayeredSurface<T> {
    #[inline(always)]
    fn vary(&mut self, param: usize, value: [T; 3]) {
        self.set(param, value);
    }

    #[inline(always)]
    fn set_wavelength(&mut self, lambda_nm: T) {
        self.move_to(lambda_nm);
    }

    /// The lobes of the specular part interfere and have the same flags, so they are kept or removed
    /// together.
    #[inline(always)]
    fn retain(&mut self, lobes: LobeSet) {
        if !lobes.contains(MIRROR_LOBE) {
            self.specular_weight = T::new(0.0);
            self.terms_used.specular = false;
        }
        if !lobes.contains(DIFFUSE_LOBE) {
            self.diffuse_weight = T::new(0.0);
            self.terms_used.diffuse = false;
        }
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.eval_shapes(wo, wi).0
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let (value, shapes) = self.eval_shapes(wo, wi);
        (value, self.densities(wi, shapes.as_ref()))
    }

    #[inline(always)]
    fn choose(&self, wo: Vec3<T>) -> PerLobe<T> {
        let diffuse = self.diffuse_weight * self.diffuse_scale() * T::new(PI);
        let refracted = T::channels(self.refracted_shares(wo));
        let mut shares = [T::new(0.0); MAX_LOBES];
        shares[MIRROR_LOBE] = self.specular_weight * self.mirror_share(wo);
        for (c, share) in refracted.into_iter().enumerate() {
            shares[REFRACTED_LOBE + c] = self.specular_weight * share;
        }
        shares[DIFFUSE_LOBE] = diffuse * mean(T::channels(self.rho_d));
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

impl<T: Lane> LayeredSurface<T> {
    /// The density of each lobe at wi.
    #[inline(always)]
    fn densities(&self, wi: Vec3<T>, shapes: Option<&Shapes<T>>) -> PerLobe<T> {
        let mut densities = [T::new(0.0); MAX_LOBES];
        let diffuse = warp::cosine_hemisphere_pdf(wi.z);
        densities[DIFFUSE_LOBE] = diffuse;
        let Some(shapes) = shapes else {
            return densities;
        };
        let mirror = shapes.mirror() * warp::power_cosine_normalization(self.exponent_reflection);
        densities[MIRROR_LOBE] = T::select(self.is_hemispherical(), diffuse, mirror);
        // cos_i dw_i = (r1 / r0)^2 cos_ii dw_ii turns the density inside into the one outside.
        let zero = T::Rgb::new(0.0);
        let normalization = warp::power_cosine_normalization(self.exponent_transmission);
        let jacobian = self.upper.compression * wi.z.gray() / shapes.cos_ii;
        let refracted = shapes.refracted();
        let refracted = T::Rgb::select(
            refracted.gt(zero),
            refracted * normalization.gray() * jacobian,
            zero,
        );
        densities[REFRACTED_LOBE..][..3].copy_from_slice(&T::channels(refracted));
        densities
    }

    #[inline(always)]
    fn is_hemispherical(&self) -> T::Mask {
        self.exponent_reflection.equals(T::new(0.0))
    }

    /// Samples about the mirror direction of wo, or over the whole hemisphere for exponent 0.
    #[inline(always)]
    fn sample_mirror(&self, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let lobe = sample_about(wo.mirrored(), self.exponent_reflection, u);
        Vec3::select(
            self.is_hemispherical(),
            warp::cosine_hemisphere(u[0], u[1]),
            lobe,
        )
    }

    /// The viewer's ray enters the layer, is mirrored at the lower boundary, spreads by the lobe
    /// inside, and is refracted out again with the index of channel c.
    #[inline(always)]
    fn sample_refracted(&self, c: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        let zero = T::new(0.0);
        let interface = self.upper.interface.channel(c);
        let axis = interface.inside(wo).mirrored_about(self.base_normal);
        let a = sample_about(axis, self.exponent_transmission, u);
        let is_possible = a.z.gt(zero) & a.dot(self.base_normal).gt(zero);
        Vec3::select(is_possible, interface.outside(a), Vec3::zero())
    }

    /// The estimated albedo of R. Like that of T it is neither weighted nor divided by 2, because
    /// constructive interference reaches R + T.
    #[inline(always)]
    fn mirror_share(&self, wo: Vec3<T>) -> T {
        let e0 = self.exponent_reflection;
        // A broad lobe includes other angles of incidence than that of the mirror direction: 1/21 is the
        // mean of Schlick's (1 - cos)^5 over the hemisphere (GH02 eq. 12).
        let spread = T::new(1.0 / 21.0) / (e0 + T::new(1.0));
        let fresnel = schlick(self.upper.f0, wo.z.gray())
            + (T::Rgb::new(1.0) - self.upper.f0) * spread.gray();
        self.scale_reflection * mean(T::channels(fresnel)) * estimated_integral(e0, wo.z)
    }

    /// The estimated albedo of T, divided by 3: what each channel contributes to the mean.
    #[inline(always)]
    fn refracted_shares(&self, wo: Vec3<T>) -> T::Rgb {
        let (zero, one, half) = (T::Rgb::new(0.0), T::Rgb::new(1.0), T::Rgb::new(0.5));
        let e1 = self.exponent_transmission.gray();
        let n1 = self.base_normal.gray();
        let b = self.upper.interface.inside(wo.gray());
        let axis = b.mirrored_about(n1);
        // The part of the lobe inside the critical cone, estimated by a sigmoid of the axis' distance from
        // the cone in units of the lobe's width. Its tails are heavy, so that a small part is still
        // sampled.
        let critical = self.upper.interface.critical_cosine_squared().sqrt();
        let distance = (axis.z - critical) * (e1 + T::Rgb::new(2.0)).sqrt();
        let inside = half + half * distance / (one + distance.squared()).sqrt();
        let exit = smooth_cosine(e1, self.exit_cosine(wo, &b, &n1)).min(one);
        let crossings = schlick_transmittance(self.upper.f0, wo.z.gray())
            * schlick_transmittance(self.upper.f0, exit);
        let lobe = estimated_integral(e1, axis.z.max(critical)) * inside;
        // In `paper` the lobe is a density of directions inside the layer, where they are denser than
        // outside.
        let density = if self.is_paper {
            one / self.upper.compression
        } else {
            one
        };
        let scale = (self.scale_transmission * T::new(1.0 / 3.0)).gray();
        let shares = scale * self.base * crossings * lobe * density;
        T::Rgb::select(b.z.gt(zero) & b.dot(n1).gt(zero), shares, zero)
    }

    /// The cosine outside of the ray b that n1 mirrors; 0 if it is totally reflected. With z = b.z + rise after the
    /// mirroring it follows from z^2 - b.z^2 = rise (2 b.z + rise) and b.z^2 - complement = (ratio wo.z)^2, so that
    /// nothing cancels where the boundaries are parallel and wo is at the horizon.
    #[inline(always)]
    fn exit_cosine(&self, wo: Vec3<T>, b: &Vec3<T::Rgb>, n1: &Vec3<T::Rgb>) -> T::Rgb {
        let two = T::Rgb::new(2.0);
        let along = n1.x * b.x + n1.y * b.y;
        let tilt_squared = n1.x.squared() + n1.y.squared();
        let rise = two * (n1.z * along - b.z * tilt_squared);
        let ratio = self.upper.interface.ratio();
        let squared = (ratio * wo.z.gray()).squared() + rise * (two * b.z + rise);
        squared.sqrt_positive() / ratio
    }
}
