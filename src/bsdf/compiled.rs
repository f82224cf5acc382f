//! The kernel of a model all of whose lobes reflect and have a density.

use super::job::{EvalJob, SampleJob, choices, vary};
use super::kernel::Kernel;
use super::lobes::{LobeSet, PerLobe};
use super::precision::Precision;
use super::quadrature;
use super::surface::Surface;
use super::varying::VaryingValues;
use crate::num::{Lane, Level, Rgb, Vec3, Work};

/// A compiled model all of whose lobes reflect and have a density: its numbers and tables, from which a
/// [`Surface`] is made for each job.
pub trait Compiled<T: Precision>: Send + Sync + 'static {
    /// The surface that is evaluated.
    type Surface<'a, L: Lane<Scalar = T>>: Surface<L>;

    /// The surface with the description's values; [`Surface::finish_vary`] is still to be called.
    fn surface<L: Lane<Scalar = T>>(&self) -> Self::Surface<'_, L>;

    /// See [`Kernel::plan`].
    fn plan(&self) -> Vec<&'static str> {
        Vec::new()
    }

    /// Runs an evaluation. A model may run a surface whose type is specialised for the most frequent case;
    /// each such copy takes its time to compile.
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

impl<T: Precision, C: Compiled<T>> Kernel<T> for LobeKernel<C> {
    fn evaluate(&self, level: Level, job: &mut EvalJob<T>) {
        T::dispatch(
            level,
            Evaluate {
                compiled: &self.0,
                job,
            },
        );
    }

    fn sample(&self, level: Level, job: &mut SampleJob<T>) {
        T::dispatch(
            level,
            Draw {
                compiled: &self.0,
                job,
            },
        );
    }

    fn albedo(&self, wo: Vec3<T>, varying: &VaryingValues<T>, lobes: LobeSet) -> Option<Rgb<T>> {
        let mut surface = self.0.surface::<T>();
        if !lobes.is_all() {
            surface.retain(lobes);
        }
        vary(&mut surface, varying, 0).then(|| {
            let closed = surface.closed_albedo();
            closed.unwrap_or_else(|| quadrature::albedo(&surface, lobes, wo))
        })
    }

    fn lobes(
        &self,
        wo: Vec3<T>,
        wi: Vec3<T>,
        varying: &VaryingValues<T>,
    ) -> Option<(PerLobe<T>, PerLobe<T>)> {
        let mut surface = self.0.surface::<T>();
        vary(&mut surface, varying, 0).then(|| {
            let (_, densities) = quadrature::eval_outlined(&surface, wo, wi);
            (choices(&surface, wo, LobeSet::ALL), densities)
        })
    }

    fn plan(&self) -> Vec<&'static str> {
        self.0.plan()
    }
}
