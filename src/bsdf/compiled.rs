//! The kernel of models whose lobes all reflect and have a density.

use super::call::Transport;
use super::job::{Direction, EvalJob, SampleJob, choices, eval_pdf, sample, with_overrides};
use super::kernel::{Kernel, eval_each, sample_each};
use super::lobes::{LobeSet, MAX_LOBES, PerLobe};
use super::precision::Precision;
use super::quadrature;
use super::surface::Surface;
use super::varying::VaryingValues;
use super::wavelengths::{SpectralCall, SpectralValues, splat_vector};
use crate::film::Film;
use crate::num::{Lane, Level, Real, Rgb, Vec3, Work};

/// A compiled model whose lobes all reflect and have a density: its numbers and tables, from which each job
/// makes a [`Surface`].
pub trait Compiled<T: Precision>: Send + Sync + 'static {
    /// The surface that is evaluated.
    type Surface<'a, L: Lane<Scalar = T>>: Surface<L>;

    /// The surface with the values of the description. The caller must call [`Surface::finish_vary`] before
    /// evaluating it.
    fn surface<L: Lane<Scalar = T>>(&self) -> Self::Surface<'_, L>;

    /// The parts of the plan in words, see [`Kernel::plan`].
    fn plan(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// The film whose media decide which wavelengths spectral calls take.
    fn film(&self) -> Option<&Film> {
        None
    }

    /// Runs an evaluation job. A model may override this to run a copy specialised for its most frequent
    /// case; each copy lengthens the build.
    #[inline(always)]
    fn evaluate<L: Lane<Scalar = T>>(&self, job: &mut EvalJob<T>) {
        job.run(self.surface::<L>());
    }
}

struct Evaluate<'a, 'b, 'c, C, T> {
    compiled: &'a C,
    job: &'b mut EvalJob<'c, T>,
}

impl<T: Precision, C: Compiled<T>> Work<T> for Evaluate<'_, '_, '_, C, T> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = T>>(self) {
        self.compiled.evaluate::<L>(self.job);
    }
}

struct Draw<'a, 'b, 'c, C, T> {
    compiled: &'a C,
    job: &'b mut SampleJob<'c, T>,
}

impl<T: Precision, C: Compiled<T>> Work<T> for Draw<'_, '_, '_, C, T> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = T>>(self) {
        self.job.run(self.compiled.surface::<L>());
    }
}

/// The kernel of a compiled model.
pub fn kernel<T: Precision>(compiled: impl Compiled<T>) -> Box<dyn Kernel<T>> {
    Box::new(LobeKernel(compiled))
}

struct LobeKernel<C>(C);

/// What restricts the surface of a call: the lobes that take part, and the wavelength of a spectral call, nm.
#[derive(Clone, Copy)]
struct Restriction<T> {
    lobes: LobeSet,
    lambda_nm: Option<T>,
}

impl<T> Restriction<T> {
    /// That of an RGB call.
    fn to(lobes: LobeSet) -> Self {
        Self {
            lobes,
            lambda_nm: None,
        }
    }
}

impl<C> LobeKernel<C> {
    /// Calls `f` with the surface of a call that sets parameters or leaves lobes out; `None` if a value is
    /// unusable. It is not inlined, because calls that do neither need no surface in memory.
    #[inline(never)]
    fn with_varied<T: Precision, R>(
        &self,
        varying: &VaryingValues<T>,
        restriction: Restriction<T>,
        f: impl FnOnce(&C::Surface<'_, T>) -> R,
    ) -> Option<R>
    where
        C: Compiled<T>,
    {
        with_overrides(
            varying,
            #[inline(always)]
            |overrides| {
                let mut surface = self.0.surface::<T>();
                if !restriction.lobes.is_all() {
                    surface.retain(restriction.lobes);
                }
                for (param, value) in overrides {
                    surface.vary(*param, *value);
                }
                if let Some(lambda_nm) = restriction.lambda_nm {
                    surface.set_wavelength(lambda_nm);
                }
                surface.finish_vary();
                f(&surface)
            },
        )
    }

    /// [`LobeKernel::with_varied`] in one copy for all calls that take long by themselves. `f` is not called if a
    /// value is unusable.
    #[inline(never)]
    fn with_varied_slowly<T: Precision>(
        &self,
        varying: &VaryingValues<T>,
        lobes: LobeSet,
        f: &mut dyn FnMut(&C::Surface<'_, T>),
    ) where
        C: Compiled<T>,
    {
        self.with_varied(varying, Restriction::to(lobes), f);
    }

    /// Samples the surface of a call that is not plain.
    #[inline(never)]
    fn sample_varied<T: Precision>(
        &self,
        wo: Vec3<T>,
        u: [T; 3],
        varying: &VaryingValues<T>,
        restriction: Restriction<T>,
    ) -> Direction<T>
    where
        C: Compiled<T>,
    {
        self.with_varied(
            varying,
            restriction,
            #[inline(always)]
            |surface| sample(surface, restriction.lobes, true, wo, u),
        )
        .unwrap_or(Direction::none())
    }

    /// The kernel for loops without lanes, which run at the level "scalar" alone. With the formulas of every
    /// model inlined once more these loops were 22 kB, a hundredth of the library.
    fn behind_pointer<T: Precision>(&self) -> &dyn Kernel<T>
    where
        C: Compiled<T>,
    {
        self
    }

    /// The surface with the values of the description, ready for evaluation.
    #[inline(always)]
    fn settled<T: Precision>(&self) -> C::Surface<'_, T>
    where
        C: Compiled<T>,
    {
        let mut surface = self.0.surface::<T>();
        surface.finish_vary();
        surface
    }
}

#[inline(always)]
fn is_plain<T: Precision>(varying: &VaryingValues<T>, lobes: LobeSet) -> bool {
    varying.is_empty() && lobes.is_all()
}

impl<T: Precision, C: Compiled<T>> Kernel<T> for LobeKernel<C> {
    fn eval(&self, wo: Vec3<T>, wi: Vec3<T>, varying: &VaryingValues<T>, lobes: LobeSet) -> Rgb<T> {
        if is_plain(varying, lobes) {
            return self.settled::<T>().eval(wo, wi);
        }
        self.with_varied(
            varying,
            Restriction::to(lobes),
            #[inline(always)]
            |surface| surface.eval(wo, wi),
        )
        .unwrap_or([T::new(0.0); 3])
    }

    fn eval_pdf(
        &self,
        wo: Vec3<T>,
        wi: Vec3<T>,
        varying: &VaryingValues<T>,
        lobes: LobeSet,
    ) -> (Rgb<T>, T) {
        if is_plain(varying, lobes) {
            return eval_pdf(&self.settled::<T>(), lobes, wo, wi);
        }
        self.with_varied(
            varying,
            Restriction::to(lobes),
            #[inline(always)]
            |surface| eval_pdf(surface, lobes, wo, wi),
        )
        .unwrap_or(([T::new(0.0); 3], T::new(0.0)))
    }

    fn sample(
        &self,
        wo: Vec3<T>,
        u: [T; 3],
        varying: &VaryingValues<T>,
        lobes: LobeSet,
        _transport: Transport,
    ) -> Direction<T> {
        if is_plain(varying, lobes) {
            return sample(&self.settled::<T>(), lobes, true, wo, u);
        }
        self.sample_varied(wo, u, varying, Restriction::to(lobes))
    }

    fn eval_job(&self, level: Level, job: &mut EvalJob<T>) {
        if level.is_scalar() {
            return eval_each(self.behind_pointer(), job);
        }
        T::dispatch(
            level,
            Evaluate {
                compiled: &self.0,
                job,
            },
        );
    }

    fn sample_job(&self, level: Level, job: &mut SampleJob<T>) {
        if level.is_scalar() {
            return sample_each(self.behind_pointer(), job);
        }
        T::dispatch(
            level,
            Draw {
                compiled: &self.0,
                job,
            },
        );
    }

    fn eval_spectral(
        &self,
        wo: Vec3<T>,
        wi: Vec3<T>,
        call: &SpectralCall<T>,
        found: &mut SpectralValues<T>,
    ) {
        let (wo, wi) = (splat_vector(wo), splat_vector(wi));
        let zero = T::Wavelengths::new(0.0);
        for used in call.blocks(T::Wavelengths::COUNT) {
            let mut surface = self.0.surface::<T::Wavelengths>();
            if !call.lobes.is_all() {
                surface.retain(call.lobes);
            }
            let is_usable = call.varying.clamp_inputs::<T::Wavelengths>(
                used.start,
                #[inline(always)]
                |param, value| surface.vary(param, value),
            );
            surface.set_wavelength(T::Wavelengths::load(&call.lambda_nm[used.clone()]));
            surface.finish_vary();
            let ([value, ..], pdf) = eval_pdf(&surface, call.lobes, wo, wi);
            T::Wavelengths::select(is_usable, value, zero).store(&mut found.value[used.clone()]);
            T::Wavelengths::select(is_usable, pdf, zero).store(&mut found.pdf[used]);
        }
    }

    fn sample_spectral(
        &self,
        wo: Vec3<T>,
        u: [T; 3],
        call: &SpectralCall<T>,
        found: &mut SpectralValues<T>,
    ) -> (Direction<T>, bool) {
        let restriction = Restriction {
            lobes: call.lobes,
            lambda_nm: Some(call.lambda_nm[call.hero]),
        };
        let drawn = self.sample_varied(wo, u, &call.varying.element(call.hero), restriction);
        if drawn.pdf > T::new(0.0) {
            self.eval_spectral(wo, drawn.wi, call, found);
            found.weigh(call.count);
        }
        (drawn, false)
    }

    fn film(&self) -> Option<&Film> {
        self.0.film()
    }

    fn albedo(&self, wo: Vec3<T>, varying: &VaryingValues<T>, lobes: LobeSet) -> Rgb<T> {
        let mut albedo = [T::new(0.0); 3];
        self.with_varied_slowly(varying, lobes, &mut |surface| {
            let closed = surface.closed_albedo();
            albedo = closed.unwrap_or_else(|| quadrature::albedo(surface, lobes, wo));
        });
        albedo
    }

    fn lobes(
        &self,
        wo: Vec3<T>,
        wi: Vec3<T>,
        varying: &VaryingValues<T>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        let mut found = [[T::new(0.0); MAX_LOBES]; 2];
        self.with_varied_slowly(varying, LobeSet::ALL, &mut |surface| {
            let (_, densities) = quadrature::eval_outlined(surface, wo, wi);
            found = [choices(surface, wo, LobeSet::ALL), densities];
        });
        let [selection, densities] = found;
        (selection, densities)
    }

    fn plan(&self) -> Vec<&'static str> {
        self.0.plan()
    }
}
