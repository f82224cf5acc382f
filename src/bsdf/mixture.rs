//! Models whose lobes all have a density: overrides, mixture and choice of lobe are the same for all.

use super::kernel::{Direction, Kernel, Override};
use super::model::{MAX_LOBES, PerLobe, Scattering};
use super::precision::Precision;
use super::quadrature::mixture;
use super::tile::{Eval, EvalTile, Sample, SampleTile, Tiles};
use crate::num::{Lane, Level, Mask, Rgb, Vec3, each};

/// The kernel of a model all of whose lobes reflect and have a density.
pub struct Mixture<M>(pub M);

/// A compiled model: its numbers and tables, each once. What is evaluated is made of it for each call, or
/// for as many calls as there are lanes.
pub trait Surfaces<T: Precision>: Send + Sync + 'static {
    /// What is evaluated.
    type Surface<'a, L: Lane<Scalar = T>>: Scattering<L>;

    /// With the parameters' own values; [`Scattering::settle`] is still to be called.
    fn surface<L: Lane<Scalar = T>>(&self) -> Self::Surface<'_, L>;

    /// See [`Kernel::plan`].
    fn plan(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// Does work with the surface. A model that is evaluated in many ways has code of its own for the most
    /// frequent ones, so that what is known of them is not asked again for every element; each such copy
    /// takes its time to compile.
    #[inline(always)]
    fn with_surface<L: Lane<Scalar = T>, W: SurfaceWork<L>>(&self, work: W) {
        work.run_swiftly(self.surface::<L>());
    }
}

/// Work with a surface. Must be `#[inline(always)]`.
pub trait SurfaceWork<L: Lane>: Sized {
    /// Whether it is so short that copies of it for kinds of surfaces are worth their code.
    const IS_SHORT: bool;
    /// Does it.
    fn run<S: Scattering<L>>(self, surface: S);
    /// Does it as fast as possible, with more code.
    #[inline(always)]
    fn run_swiftly<S: Scattering<L>>(self, surface: S) {
        self.run(surface);
    }
}

/// Calls `$body` with `$surface` being that of `$self` under `$overrides`: by a path of its own if
/// nothing varies.
macro_rules! with_surface {
    ($self:ident, $overrides:ident, |$surface:ident| $body:expr) => {
        if $overrides.is_empty() {
            let $surface = &$self.varied(&[]);
            $body
        } else {
            let $surface = &$self.varied($overrides);
            $body
        }
    };
}

impl<M> Mixture<M> {
    #[inline(always)]
    fn varied<T: Precision>(&self, overrides: &[Override<T>]) -> M::Surface<'_, T>
    where
        M: Surfaces<T>,
    {
        let mut surface = self.0.surface::<T>();
        for change in overrides {
            surface.vary(change.param, change.value);
        }
        surface.settle();
        surface
    }
}

impl<T: Precision, M: Surfaces<T>> Kernel<T> for Mixture<M> {
    fn eval(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        with_surface!(self, overrides, |surface| surface.eval(wo, wi))
    }

    fn eval_pdf(&self, overrides: &[Override<T>], wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, T) {
        with_surface!(self, overrides, |surface| eval_pdf(surface, wo, wi))
    }

    fn lobes(
        &self,
        overrides: &[Override<T>],
        wo: Vec3<T>,
        wi: Vec3<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        let surface = Outlined(self.varied(overrides));
        let densities = surface.eval_with_densities(wo, wi).1;
        (surface.selection(wo), densities)
    }

    fn sample(&self, overrides: &[Override<T>], wo: Vec3<T>, u: [T; 3]) -> Option<Direction<T>> {
        let sampled = with_surface!(self, overrides, |surface| sample(surface, wo, u));
        (sampled.pdf > T::new(0.0)).then(|| Direction {
            wi: sampled.wi,
            pdf: sampled.pdf,
            weight: sampled.weight,
            eta: T::new(1.0),
            lobe: sampled.lobe.to_f32() as usize,
        })
    }

    fn albedo(&self, overrides: &[Override<T>], wo: Vec3<T>) -> Rgb<T> {
        Outlined(self.varied(overrides)).albedo(wo)
    }

    fn plan(&self) -> Vec<&'static str> {
        self.0.plan()
    }

    fn tiles(&self) -> Option<&dyn Tiles> {
        T::tiles(self)
    }
}

impl<M: Surfaces<f32>> Tiles for Mixture<M> {
    fn eval(&self, level: Level, tile: EvalTile) {
        level.run(Eval {
            model: &self.0,
            tile,
        });
    }

    fn sample(&self, level: Level, tile: SampleTile) {
        level.run(Sample {
            model: &self.0,
            tile,
        });
    }
}

/// A surface whose evaluation is a call: for what is not so hot that it needs a copy of its own, which takes
/// long to compile.
struct Outlined<S>(S);

impl<T: Precision, S: Scattering<T>> Scattering<T> for Outlined<S> {
    fn vary(&mut self, param: usize, value: [T; 3]) {
        self.0.vary(param, value);
    }

    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>) -> Rgb<T> {
        self.eval_with_densities(wo, wi).0
    }

    #[inline(never)]
    fn eval_with_densities(&self, wo: Vec3<T>, wi: Vec3<T>) -> (Rgb<T>, PerLobe<T>) {
        self.0.eval_with_densities(wo, wi)
    }

    #[inline(always)]
    fn selection(&self, wo: Vec3<T>) -> PerLobe<T> {
        self.0.selection(wo)
    }

    #[inline(always)]
    fn sample(&self, lobe: usize, wo: Vec3<T>, u: [T; 2]) -> Vec3<T> {
        self.0.sample(lobe, wo, u)
    }

    fn closed_albedo(&self) -> Option<Rgb<T>> {
        self.0.closed_albedo()
    }
}

/// Value, and the density of all lobes together.
#[inline(always)]
pub(super) fn eval_pdf<T: Lane, S: Scattering<T>>(
    surface: &S,
    wo: Vec3<T>,
    wi: Vec3<T>,
) -> (Rgb<T>, T) {
    let (value, densities) = surface.eval_with_densities(wo, wi);
    (value, mixture(&surface.selection(wo), &densities))
}

/// A sampled direction; all 0: none.
pub(super) struct Sampled<T> {
    pub wi: Vec3<T>,
    /// Over all lobes.
    pub pdf: T,
    /// value / pdf.
    pub weight: Rgb<T>,
    /// Number of the chosen lobe.
    pub lobe: T,
}

/// A direction of a lobe chosen by the first number.
#[inline(always)]
pub(super) fn sample<T: Lane, S: Scattering<T>>(surface: &S, wo: Vec3<T>, u: [T; 3]) -> Sampled<T> {
    let zero = T::new(0.0);
    let selection = surface.selection(wo);
    let (mut wi, mut number) = (Vec3::zero(), zero);
    let chosen = choose(&selection, u[0]);
    if T::COUNT == 1 {
        // One lobe at most, which need not be known to the compiler.
        if let Some(lobe) = only(&chosen) {
            wi = surface.sample(lobe, wo, [u[1], u[2]]);
            number = T::new(lobe as f64);
        }
    } else {
        for (lobe, is_chosen) in chosen.into_iter().enumerate() {
            if is_chosen.any() {
                let direction = surface.sample(lobe, wo, [u[1], u[2]]);
                wi = Vec3::select(is_chosen, direction, wi);
                number = T::select(is_chosen, T::new(lobe as f64), number);
            }
        }
    }
    let is_above = wi.z.gt(zero);
    // Where there is no direction the viewer's own does no harm.
    wi = Vec3::select(is_above, wi, wo);
    let (value, densities) = surface.eval_with_densities(wo, wi);
    let pdf = mixture(&selection, &densities);
    let is_found = is_above & pdf.gt(zero) & pdf.is_finite();
    Sampled {
        wi: Vec3::from_array(each!(wi.to_array(), |number| T::select(
            is_found, number, zero
        ))),
        pdf: T::select(is_found, pdf, zero),
        weight: each!(value, |value| T::select(is_found, value / pdf, zero)),
        lobe: T::select(is_found, number, zero),
    }
}

/// The chosen lobe, where there is but one number.
#[inline(always)]
pub(super) fn only<M: Mask>(chosen: &[M; MAX_LOBES]) -> Option<usize> {
    chosen.iter().position(|is_chosen| is_chosen.any())
}

/// Which lobe's share of [0, 1) the number lies in; none if all shares are 0.
#[inline(always)]
pub(super) fn choose<T: Lane>(selection: &PerLobe<T>, u: T) -> [T::Mask; MAX_LOBES] {
    let zero = T::new(0.0);
    let never = zero.lt(zero);
    let (mut chosen, mut is_open, mut below) = ([never; MAX_LOBES], !never, zero);
    for (chosen, share) in chosen.iter_mut().zip(selection) {
        below = below + *share;
        *chosen = is_open & share.gt(zero) & u.lt(below);
        is_open = is_open & !*chosen;
    }
    // Rounding may leave the sum of all shares below u: then the last lobe is meant.
    for (chosen, share) in chosen.iter_mut().zip(selection).rev() {
        let is_last = is_open & share.gt(zero);
        *chosen = *chosen | is_last;
        is_open = is_open & !is_last;
    }
    chosen
}
