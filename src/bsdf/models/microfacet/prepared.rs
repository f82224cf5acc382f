//! What the model is compiled to: a mirror or a rough surface.

use super::compensation::{Compensation, Returned};
use super::distribution::Normals;
use super::fresnel::{Facets, Fresnel};
use super::masking::{Masking, Pair, turned};
use super::roughness::{Family, Normalized, Shape, with_normals};
use super::{ALPHA, ANISOTROPY, REFLECTION_LOBE, RETURNED_LOBE, ROTATION};
use crate::bsdf::kernel::{Direction, Kernel, Override};
use crate::bsdf::mixture::{SurfaceWork, Surfaces};
use crate::bsdf::model::{MAX_LOBES, PerLobe, Scattering, normalized};
use crate::bsdf::models::power_lobe::mean;
use crate::bsdf::precision::Precision;
use crate::num::{Lane, Rgb, Vec3, each, warp};

/// One facet.
pub(super) struct Mirror<T: Lane> {
    pub(super) facets: Facets<T>,
    pub(super) masking: Masking,
}

impl<T: Precision> Kernel<T> for Mirror<T> {
    fn plan(&self) -> Vec<&'static str> {
        let mut plan = vec!["perfect mirror"];
        plan.extend(self.facets.plan());
        plan
    }

    fn lobes(
        &self,
        _overrides: &[Override<T>],
        _wo: Vec3<T>,
        _wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        (only_first(T::new(1.0)), [T::new(0.0); MAX_LOBES])
    }

    fn sample(&self, overrides: &[Override<T>], wo: Vec3<T>, _u: [T; 3]) -> Option<Direction<T>> {
        Some(Direction {
            wi: wo.mirrored(),
            pdf: T::new(0.0),
            weight: self.albedo(overrides, wo),
            eta: T::new(1.0),
            lobe: REFLECTION_LOBE,
        })
    }

    fn albedo(&self, overrides: &[Override<T>], wo: Vec3<T>) -> Rgb<T> {
        let mut fresnel = self.facets.fresnel::<T>();
        for change in overrides {
            fresnel.vary(change.param, change.value);
        }
        let cos_theta = wo.z.min(T::new(1.0));
        let masking = self.masking.of_mirror(cos_theta);
        let reflectance = fresnel.reflectance(cos_theta);
        reflectance.map(|reflectance| reflectance * masking)
    }
}

/// Many facets.
pub(super) struct Rough<T: Lane> {
    pub(super) normals: Normalized<T>,
    pub(super) shape: Shape<T>,
    pub(super) facets: Facets<T>,
    pub(super) masking: Masking,
    pub(super) compensation: Option<Compensation<T>>,
}

impl<T: Precision> Surfaces<T> for Rough<T> {
    type Surface<'a, L: Lane<Scalar = T>> = Surface<'a, L>;

    #[inline(always)]
    fn surface<L: Lane<Scalar = T>>(&self) -> Surface<'_, L> {
        Surface {
            family: self.normals.family(),
            shape: self.shape.splat(),
            fresnel: self.facets.fresnel(),
            masking: self.masking,
            compensation: self.compensation.as_ref(),
            returned: None,
        }
    }

    fn plan(&self) -> Vec<&'static str> {
        let is_round = self.shape.is_round.then_some("isotropic");
        is_round.into_iter().chain(self.facets.plan()).collect()
    }

    #[inline(always)]
    fn with_surface<L: Lane<Scalar = T>, W: SurfaceWork<L>>(&self, work: W) {
        let surface = self.surface::<L>();
        if !(W::IS_SHORT && surface.is_plain_ggx()) {
            return work.run(surface);
        }
        match surface.fresnel {
            Fresnel::Polynomial(metal) => {
                work.run_swiftly(surface.plain_ggx(Fresnel::Polynomial(metal)));
            }
            fresnel => work.run_swiftly(surface.plain_ggx(fresnel)),
        }
    }
}

/// A rough surface for one call, or as many as there are lanes.
pub(super) struct Surface<'a, T: Lane> {
    family: Family<'a, T::Scalar>,
    shape: Shape<T>,
    fresnel: Fresnel<'a, T>,
    masking: Masking,
    compensation: Option<&'a Compensation<T::Scalar>>,
    /// With energy compensation.
    returned: Option<Returned<'a, T>>,
}

impl<'a, T: Lane> Surface<'a, T> {
    /// Whether it is GGX's and the same all around, with Smith's masking and nothing given back.
    #[inline(always)]
    fn is_plain_ggx(&self) -> bool {
        matches!(self.family, Family::Ggx)
            && self.shape.is_round
            && self.masking == Masking::Smith
            && self.compensation.is_none()
    }

    /// The same, where that is known when the code is compiled.
    #[inline(always)]
    fn plain_ggx(self, fresnel: Fresnel<'a, T>) -> Self {
        Self {
            family: Family::Ggx,
            shape: self.shape.round(),
            fresnel,
            masking: Masking::Smith,
            compensation: None,
            returned: None,
        }
    }
}

impl<T: Lane> Surface<'_, T> {
    /// From the shading frame into that of the long axis.
    #[inline(always)]
    fn turn_back(&self) -> [T; 2] {
        let [cos, sin] = self.shape.turn;
        [cos, -sin]
    }
}

impl<P: Precision, T: Lane<Scalar = P>> Scattering<T> for Surface<'_, T> {
    #[inline(always)]
    fn vary(&mut self, param: usize, value: [T; 3]) {
        match param {
            ALPHA | ANISOTROPY | ROTATION => self.shape.vary(param, value[0]),
            _ => self.fresnel.vary(param, value),
        }
    }

    #[inline(always)]
    fn settle(&mut self) {
        if let Some(compensation) = self.compensation {
            self.returned = Some(compensation.returned(self.shape.alpha, &self.fresnel));
        }
    }

    #[inline(always)]
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.eval_with_densities(wo, wi).0
    }

    #[inline(always)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        let mut pair = Pair::new(wo, wi);
        if !self.shape.is_round {
            pair = pair.turned(self.turn_back());
        }
        let (normals, smith, density) = with_normals!(self.family, self.shape, |normals| (
            normals.density_between(&pair),
            self.masking.of_normals(&normals, &pair),
            normals.reflected_density(&pair),
        ));
        let highlight = normals * self.masking.factor(smith, self.shape.axes, &pair);
        let reflectance = self.fresnel.reflectance(pair.cos_half);
        let mut value = each!(reflectance, |reflectance| reflectance * highlight);
        let mut densities = only_first(density);
        if let Some(returned) = &self.returned {
            let more = returned.eval(wo, wi);
            value = each!([0, 1, 2], |channel| value[channel] + more[channel]);
            densities[RETURNED_LOBE] = warp::cosine_hemisphere_pdf(wi.z);
        }
        (value, densities)
    }

    /// With energy compensation in proportion to the estimated albedos, F being that of the viewer.
    #[inline(always)]
    fn selection(&self, wo: Vec3<T>) -> PerLobe<T> {
        let Some(returned) = &self.returned else {
            return only_first(T::new(1.0));
        };
        let cos_theta = wo.z.min(T::new(1.0));
        let reflectance = mean(self.fresnel.reflectance(cos_theta));
        let mut shares = only_first(reflectance * returned.albedo(cos_theta));
        shares[RETURNED_LOBE] = returned.share(wo);
        normalized(shares)
    }

    #[inline(always)]
    fn sample(&self, lobe: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        if lobe == RETURNED_LOBE {
            return warp::cosine_hemisphere(u[0], u[1]);
        }
        let (is_round, mut view) = (self.shape.is_round, wo);
        if !is_round {
            view = turned(wo, self.turn_back());
        }
        let mut h = with_normals!(self.family, self.shape, |normals| normals.sample(view, u));
        if !is_round {
            h = turned(h, self.shape.turn);
        }
        wo.mirrored_about(h)
    }
}

#[inline(always)]
fn only_first<T: Lane>(number: T) -> PerLobe<T> {
    let mut numbers = [T::new(0.0); MAX_LOBES];
    numbers[REFLECTION_LOBE] = number;
    numbers
}
