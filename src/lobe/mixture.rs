//! Models whose lobes all have a density: overrides, mixture and choice of lobe are the same for all.

use super::kernel::{Direction, Kernel, Override, choose};
use super::precision::Precision;
use super::quadrature::mixture;
use super::scattering::{PerLobe, Scattering};
use crate::math::{Rgb, Vec3};

/// The kernel of a [`Scattering`] model that owns all it needs.
pub struct Mixture<S>(pub S);

/// The kernel of a model with tables: what is evaluated is made for each call and borrows them.
pub(super) struct PerCall<M>(pub M);

/// A compiled model with tables.
pub(super) trait Surfaces<T: Precision>: Send + Sync {
    /// What is evaluated.
    type Surface<'a>: Scattering<T>
    where
        Self: 'a;

    /// With the parameters of one call.
    fn surface(&self, overrides: &[Override<T>]) -> Self::Surface<'_>;
}

/// Calls `$body` with `$scattering` being `$self` under `$overrides`. Nothing is copied when
/// nothing varies.
macro_rules! with_overrides {
    ($self:ident, $overrides:ident, |$scattering:ident| $body:expr) => {
        if $overrides.is_empty() {
            let $scattering = &$self.0;
            $body
        } else {
            let mut copy = $self.0;
            for change in $overrides {
                copy.vary(change.param, change.value);
            }
            let $scattering = &copy;
            $body
        }
    };
}

impl<T: Precision, S: Scattering<T> + 'static> Kernel<T> for Mixture<S> {
    fn eval(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        with_overrides!(self, overrides, |scattering| Scattering::eval(
            scattering, wo, wi
        ))
    }

    fn eval_pdf(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, T) {
        with_overrides!(self, overrides, |scattering| eval_pdf(scattering, wo, wi))
    }

    fn lobes(
        &self,
        overrides: &[Override<T>],
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        with_overrides!(self, overrides, |scattering| lobes(scattering, wo, wi))
    }

    fn sample(&self, overrides: &[Override<T>], wo: Vec3<T>, u: [T; 3]) -> Option<Direction<T>> {
        with_overrides!(self, overrides, |scattering| sample(scattering, wo, u))
    }

    fn albedo(&self, overrides: &[Override<T>], wo: Vec3<T>) -> Rgb<T> {
        with_overrides!(self, overrides, |scattering| Scattering::albedo(
            scattering, wo
        ))
    }
}

impl<T: Precision, M: Surfaces<T> + 'static> Kernel<T> for PerCall<M> {
    fn eval(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.0.surface(overrides).eval(wo, wi)
    }

    fn eval_pdf(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, T) {
        eval_pdf(&self.0.surface(overrides), wo, wi)
    }

    fn lobes(
        &self,
        overrides: &[Override<T>],
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        lobes(&self.0.surface(overrides), wo, wi)
    }

    fn sample(&self, overrides: &[Override<T>], wo: Vec3<T>, u: [T; 3]) -> Option<Direction<T>> {
        sample(&self.0.surface(overrides), wo, u)
    }

    fn albedo(&self, overrides: &[Override<T>], wo: Vec3<T>) -> Rgb<T> {
        self.0.surface(overrides).albedo(wo)
    }
}

/// Value, and the density of all lobes together.
#[inline(always)]
fn eval_pdf<T: Precision, S: Scattering<T>>(
    scattering: &S,
    wo: Vec3<T>,
    wi: Vec3<T>,
) -> (Rgb<T>, T) {
    let (value, densities) = scattering.eval_with_densities(wo, wi);
    (value, mixture(&scattering.selection(wo), &densities))
}

/// Probability and density of each lobe.
#[inline(always)]
fn lobes<T: Precision, S: Scattering<T>>(
    scattering: &S,
    wo: Vec3<T>,
    wi: Vec3<T>,
) -> (PerLobe<T>, PerLobe<T>) {
    (
        scattering.selection(wo),
        scattering.eval_with_densities(wo, wi).1,
    )
}

/// A direction of a lobe chosen by the first number.
#[inline(always)]
fn sample<T: Precision, S: Scattering<T>>(
    scattering: &S,
    wo: Vec3<T>,
    u: [T; 3],
) -> Option<Direction<T>> {
    let selection = scattering.selection(wo);
    let lobe = choose(&selection, u[0])?;
    let wi = scattering.sample(lobe, wo, [u[1], u[2]]);
    if wi.z <= T::new(0.0) {
        return None;
    }
    let (value, densities) = scattering.eval_with_densities(wo, wi);
    let pdf = mixture(&selection, &densities);
    if pdf <= T::new(0.0) || !pdf.is_finite() {
        return None;
    }
    let weight = value.map(|value| value / pdf);
    Some(Direction {
        wi,
        pdf,
        weight,
        eta: T::new(1.0),
        lobe,
    })
}
