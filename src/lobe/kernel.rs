//! A compiled model behind a pointer: what is the same for all models and needs one virtual call.

use super::quadrature::mixture;
use super::scattering::{MAX_LOBES, PerLobe, Scattering};
use crate::math::{Element, Real, Rgb, Vec3};

/// A parameter's value for one call, in place of the one it was compiled with.
#[derive(Clone, Copy, Debug)]
pub struct Override<T> {
    /// Index of the parameter.
    pub param: usize,
    /// Its value; a scalar is in all three places, a direction is unit.
    pub value: [T; 3],
}

/// A sampled direction.
#[derive(Clone, Copy, Debug)]
pub struct Direction<T> {
    /// To the light.
    pub wi: Vec3<T>,
    /// Density of wi over all lobes.
    pub pdf: T,
    /// value / pdf.
    pub weight: Rgb<T>,
    /// Which lobe was chosen.
    pub lobe: usize,
}

/// [`Scattering`] with overrides and lobe mixture, callable without knowing the model.
pub trait Kernel<T: Element>: Send + Sync {
    /// f(wo, wi) |wi.z|.
    fn eval(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T>;
    /// Value and density.
    fn eval_pdf(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, T);
    /// Probability and density of each lobe.
    fn lobes(
        &self,
        overrides: &[Override<T>],
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>);
    /// A direction, from three uniform numbers in [0, 1): the first chooses the lobe.
    fn sample(&self, overrides: &[Override<T>], wo: Vec3<T>, u: [T; 3]) -> Option<Direction<T>>;
    /// Directional albedo.
    fn albedo(&self, overrides: &[Override<T>], wo: Vec3<T>) -> Rgb<T>;
}

/// Calls `$body` with `$scattering` being `$self` under `$overrides`. Nothing is copied when
/// nothing varies.
macro_rules! with_overrides {
    ($self:ident, $overrides:ident, |$scattering:ident| $body:expr) => {
        if $overrides.is_empty() {
            let $scattering = $self;
            $body
        } else {
            let mut copy = *$self;
            for change in $overrides {
                copy.vary(change.param, change.value);
            }
            let $scattering = &copy;
            $body
        }
    };
}

impl<T: Element<Mask = bool> + PartialOrd, S: Scattering<T>> Kernel<T> for S {
    fn eval(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        with_overrides!(self, overrides, |scattering| Scattering::eval(
            scattering, wo, wi
        ))
    }

    fn eval_pdf(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, T) {
        with_overrides!(self, overrides, |scattering| {
            let (value, densities) = scattering.eval_with_densities(wo, wi);
            (value, mixture(&scattering.selection(wo), &densities))
        })
    }

    fn lobes(
        &self,
        overrides: &[Override<T>],
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        with_overrides!(self, overrides, |scattering| {
            (
                scattering.selection(wo),
                scattering.eval_with_densities(wo, wi).1,
            )
        })
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

#[inline(always)]
fn sample<T: Element<Mask = bool> + PartialOrd, S: Scattering<T>>(
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
        lobe,
    })
}

/// The lobe in whose share of [0, 1) the number lies; none if all shares are 0.
#[inline(always)]
fn choose<T: Real + PartialOrd>(selection: &PerLobe<T>, u: T) -> Option<usize> {
    let zero = T::new(0.0);
    let mut chosen = None;
    let mut below = zero;
    for lobe in (0..MAX_LOBES).filter(|&lobe| selection[lobe] > zero) {
        // Rounding may leave the sum of all shares below u: then the last lobe is meant.
        chosen = Some(lobe);
        below = below + selection[lobe];
        if u < below {
            break;
        }
    }
    chosen
}
