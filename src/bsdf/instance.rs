//! A BSDF: a model compiled for validated parameters.

use super::call::Call;
use super::description::Description;
use super::info::{Flags, LobeInfo, ModelInfo, ParamInfo};
use super::job::{Direction, EvalJob, SampleJob, are_uniform, unit};
use super::kernel::Kernel;
use super::lobes::{LobeSet, MAX_LOBES, PerLobe};
use super::precision::Precision;
use super::registry::find;
use super::resolve::resolve;
use super::varying::{VaryingParams, VaryingRange, VaryingValues};
use super::wavelengths::refusal;
use crate::error::Error;
use crate::num::{Level, Rgb, Vec3};

/// Value and densities at a pair of directions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evaluation<T = f32> {
    /// f(wo, wi) |wi.z|.
    pub value: Rgb<T>,
    /// The density with which [`Bsdf::sample`] finds wi from wo, per solid angle of wi.
    pub pdf: T,
    /// The density with which it finds wo from wi, per solid angle of wo.
    pub pdf_reverse: T,
}

/// A sampled direction. Without a valid sample every field is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<T: Precision = f32> {
    /// The direction to the light, of unit length.
    pub wi: T::Vector,
    /// The density of wi over all lobes of the call, per solid angle; 0 for a DELTA lobe.
    pub pdf: T,
    /// value / pdf, RGB; for a DELTA lobe its throughput over the probability of choosing it.
    pub weight: Rgb<T>,
    /// The refractive index on wi's side over that on wo's side; 1 for a reflection.
    pub eta: T,
    /// The flags of the chosen lobe.
    pub flags: Flags,
    /// The number of the chosen lobe, an index into [`Bsdf::lobe_infos`].
    pub lobe: usize,
    /// The probability with which that lobe was chosen among the lobes of the call.
    pub lobe_probability: T,
}

/// A parameter that varies per call.
#[derive(Clone, Copy, Debug)]
pub struct Varying<'a, T: Precision = f32> {
    /// The parameter.
    pub param: &'static ParamInfo,
    /// Least value of each component; 0 for a direction.
    pub min: f32,
    /// Greatest value of each component; 0 for a direction.
    pub max: f32,
    /// The values that calls without `varying` use, one per component: those of the description or, without
    /// them, the model's defaults clamped to the range.
    pub defaults: &'a [T],
}

/// A compiled BSDF. It is immutable, threads may share it, and calls of it do not allocate.
///
/// Calls take directions, the values of the varying parameters and the options of the [`Call`]. `varying`
/// has the components of the parameters that [`Description::vary`] declared, one parameter after another,
/// [`Bsdf::varying_floats`] numbers in all; with `None` they have their defaults, see
/// [`Varying::defaults`]. A finite number outside its declared range is clamped to it.
///
/// Invalid input gives 0: NaN or infinity, a `varying` of a wrong length, a varying direction with z <= 0,
/// random numbers outside [0, 1), directions whose length is not 1 to within 1e-3, and directions with z <= 0.
/// Other directions are normalised unless they are unit to rounding.
/// A BSDF with TRANSMISSION among its [`Bsdf::flags`] also takes directions with z < 0, on the side of the base.
pub struct Bsdf<T: Precision = f32> {
    info: &'static ModelInfo,
    /// The lobes of this BSDF.
    lobes: &'static [LobeInfo],
    /// Whether light reaches the other side of the surface, where z < 0.
    is_two_sided: bool,
    pub(super) kernel: Box<dyn Kernel<T>>,
    varying: VaryingParams<T>,
    /// Why spectral calls are refused, if they are.
    pub(super) spectral_refusal: Option<String>,
    ranges: Box<[VaryingRange]>,
    level: Level,
    plan: String,
}

impl<T: Precision> Bsdf<T> {
    /// Validates and compiles a description.
    ///
    /// # Errors
    /// `UnknownName` (model, parameter, choice, level), `OutOfRange` (numbers, ranges, sums),
    /// `InvalidArgument` (a wrong count, something given twice, a parameter without effect, a film that is
    /// missing or not used) or `Unsupported` (a parameter that cannot vary, a combination that the model
    /// does not offer), with a message that names the parameter, its value and what is allowed;
    /// `OutOfMemory` if there is no memory for tables.
    pub fn new(description: &Description) -> Result<Self, Error> {
        let model = find(description.model())?;
        let level = description.level()?;
        let resolved = resolve(description, model)?;
        let values = resolved.values_in::<T>(model.info);
        let lobes = (model.lobes)(&resolved.values);
        let kernel = T::prepare(|| model.prepare, || model.oracle(), &values)?;
        Ok(Self {
            plan: plan_in_words(kernel.plan(), level),
            info: model.info,
            lobes,
            is_two_sided: Flags::of(lobes).contains(Flags::TRANSMISSION),
            kernel,
            varying: VaryingParams::new(model.info, &values, &resolved.varying),
            spectral_refusal: refusal(model.info, &values),
            ranges: resolved.varying.into(),
            level,
        })
    }

    /// The model.
    pub fn info(&self) -> &'static ModelInfo {
        self.info
    }

    /// The plan in words: the terms that are left out and the formulas that are shorter for the values of
    /// this BSDF, separated by commas, and the instructions that batches use.
    pub fn plan(&self) -> &str {
        &self.plan
    }

    /// The union of the flags of the lobes of this BSDF.
    pub fn flags(&self) -> Flags {
        Flags::of(self.lobes)
    }

    /// The lobes of this BSDF: those of the model, or some of them. [`Sample::lobe`] is an index into this
    /// list.
    pub fn lobe_infos(&self) -> &'static [LobeInfo] {
        self.lobes
    }

    /// The parameters that vary per call, in the order of their declaration.
    pub fn varying(&self) -> impl ExactSizeIterator<Item = Varying<'_, T>> {
        let mut rest = self.varying.defaults();
        self.ranges.iter().map(move |range| {
            let param = &self.info.params[range.param];
            let (defaults, after) = rest.split_at(param.components());
            rest = after;
            Varying {
                param,
                min: range.min,
                max: range.max,
                defaults,
            }
        })
    }

    /// The number of parameters that vary per call.
    pub fn varying_count(&self) -> usize {
        self.ranges.len()
    }

    /// The number of components of all varying parameters together.
    pub fn varying_floats(&self) -> usize {
        self.varying.defaults().len()
    }

    /// The instructions that batches use.
    pub(crate) fn level(&self) -> Level {
        self.level
    }

    /// f(wo, wi) |wi.z|.
    #[inline(always)]
    pub fn eval(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>, call: &Call) -> Rgb<T> {
        self.at_pair(wo, wi, varying, call, |wo, wi, varying, lobes| {
            self.kernel.eval(wo, wi, varying, lobes)
        })
        .unwrap_or([T::new(0.0); 3])
    }

    /// [`Bsdf::eval`] and the density with which [`Bsdf::sample`] finds wi, per solid angle.
    #[inline(always)]
    pub fn eval_pdf(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
        call: &Call,
    ) -> (Rgb<T>, T) {
        self.at_pair(wo, wi, varying, call, |wo, wi, varying, lobes| {
            self.kernel.eval_pdf(wo, wi, varying, lobes)
        })
        .unwrap_or(([T::new(0.0); 3], T::new(0.0)))
    }

    /// Value, density and reverse density.
    #[inline(never)] // so that the frequent calls are inlined at the C boundary
    pub fn evaluate(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
        call: &Call,
    ) -> Evaluation<T> {
        let (value, pdf) = self.eval_pdf(wo, wi, varying, call);
        let (_, pdf_reverse) = self.eval_pdf(wi, wo, varying, call);
        Evaluation {
            value,
            pdf,
            pdf_reverse,
        }
    }

    /// Calls `f` if both directions and the number of varying values are valid and at least one lobe takes
    /// part.
    #[inline(always)]
    fn at_pair<R>(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
        call: &Call,
        f: impl FnOnce(Vec3<T>, Vec3<T>, &VaryingValues<T>, LobeSet) -> R,
    ) -> Option<R> {
        let (wo, wi) = (self.direction(wo)?, self.direction(wi)?);
        let lobes = LobeSet::wanted(self.lobes, call.lobes);
        let varying = self.varying.of_one(varying)?;
        (!lobes.is_empty()).then(|| f(wo, wi, &varying, lobes))
    }

    /// The probability of choosing each lobe, and the density of each lobe at wi.
    #[doc(hidden)]
    pub fn lobes(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        let none = [T::new(0.0); MAX_LOBES];
        self.at_pair(wo, wi, varying, &Call::default(), |wo, wi, varying, _| {
            self.kernel.lobes(wo, wi, varying)
        })
        .unwrap_or((none, none))
    }

    /// Samples a direction from three uniform numbers in [0, 1). The first one chooses the lobe.
    #[inline(always)]
    pub fn sample(
        &self,
        wo: T::Vector,
        u: T::Vector,
        varying: Option<&[T]>,
        call: &Call,
    ) -> Sample<T> {
        let u: [T; 3] = u.into();
        let lobes = LobeSet::wanted(self.lobes, call.lobes);
        let drawn = self.direction(wo).and_then(|wo| {
            let varying = self.varying.of_one(varying)?;
            let sample = || self.kernel.sample(wo, u, &varying, lobes, call.transport);
            (are_uniform(u) && !lobes.is_empty()).then(sample)
        });
        let drawn = drawn.unwrap_or(Direction::none());
        let lobe = drawn.lobe.to_f32() as usize;
        Sample {
            wi: drawn.wi.to_array().into(),
            pdf: drawn.pdf,
            weight: drawn.weight,
            eta: drawn.eta,
            flags: self.sampled_flags(lobe, drawn.lobe_probability > T::new(0.0)),
            lobe,
            lobe_probability: drawn.lobe_probability,
        }
    }

    /// The directional albedo, which is the integral of the value over wi, DELTA lobes included. It is
    /// found by quadrature, which takes some milliseconds, unless the model has a closed form. Transmitted
    /// light counts as radiance, (eta_o / eta_i)^2 times its power, so that the albedo exceeds 1 for light
    /// that comes from within a dense base.
    pub fn albedo(&self, wo: T::Vector, varying: Option<&[T]>, call: &Call) -> Rgb<T> {
        let lobes = LobeSet::wanted(self.lobes, call.lobes);
        let found = || {
            let (wo, varying) = (self.direction(wo)?, self.varying.of_one(varying)?);
            (!lobes.is_empty()).then(|| self.kernel.albedo(wo, &varying, lobes))
        };
        found().unwrap_or([T::new(0.0); 3])
    }

    /// Evaluates a job. Without lobes the results are 0.
    pub(crate) fn eval_job(&self, level: Level, job: &mut EvalJob<T>) {
        if job.lobes.is_empty() {
            job.clear();
        } else {
            self.kernel.eval_job(level, job);
        }
    }

    /// Samples a job. Without lobes the results are 0.
    pub(crate) fn sample_job(&self, level: Level, job: &mut SampleJob<T>) {
        if job.lobes.is_empty() {
            job.run_each(|_, _, _| Direction::none());
        } else {
            self.kernel.sample_job(level, job);
        }
    }

    /// The lobes that take part in a call.
    pub(crate) fn wanted_lobes(&self, call: &Call) -> LobeSet {
        LobeSet::wanted(self.lobes, call.lobes)
    }

    /// The varying values of many elements: one column per component, or no columns.
    pub(crate) fn varying_columns<'a>(&'a self, columns: &'a [&'a [T]]) -> VaryingValues<'a, T> {
        self.varying.of_many(columns)
    }

    /// The flags of a sampled lobe; none without a sample.
    #[inline(always)]
    pub(crate) fn sampled_flags(&self, lobe: usize, is_found: bool) -> Flags {
        if is_found {
            self.lobes[lobe].flags
        } else {
            Flags(0)
        }
    }

    /// The direction with unit length, if its length is 1 to within 1e-3 and it is on a side that light reaches.
    #[inline(always)]
    pub(super) fn direction(&self, w: T::Vector) -> Option<Vec3<T>> {
        let (w, is_accepted) = unit(Vec3::from_array(w.into()));
        let zero = T::new(0.0);
        let is_seen = w.z > zero || self.is_two_sided && w.z < zero;
        (is_accepted && is_seen).then_some(w)
    }
}

fn plan_in_words(terms: Vec<&'static str>, level: Level) -> String {
    let words = if terms.is_empty() {
        "all terms".to_owned()
    } else {
        terms.join(", ")
    };
    format!("{words}; batches by {}", level.name())
}
