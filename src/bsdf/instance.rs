//! A BSDF: a model with validated parameters, compiled, immutable, ready to be called.

use super::description::Description;
use super::varying::Varying;
use crate::bsdf::{self, Flags, Kernel, LobeInfo, ModelInfo, Override, PerLobe, Precision, Values};
use crate::error::Error;
use crate::num::{Level, Rgb, Vec3};

/// The precisions that a BSDF exists in: `f32` with `glam::Vec3` for renderers, `f64` with
/// `glam::DVec3` as the oracle.
pub trait Scalar: Precision {
    /// The public vector type.
    type Vector: Into<[Self; 3]> + From<[Self; 3]> + Copy;
    #[doc(hidden)]
    fn prepare(
        entry: &bsdf::RegisteredModel,
        values: &Values<Self>,
    ) -> Result<Box<dyn Kernel<Self>>, Error>;
}

impl Scalar for f32 {
    type Vector = glam::Vec3;
    fn prepare(
        entry: &bsdf::RegisteredModel,
        values: &Values<f32>,
    ) -> Result<Box<dyn Kernel<f32>>, Error> {
        (entry.prepare_f32)(values)
    }
}

impl Scalar for f64 {
    type Vector = glam::DVec3;
    fn prepare(
        entry: &bsdf::RegisteredModel,
        values: &Values<f64>,
    ) -> Result<Box<dyn Kernel<f64>>, Error> {
        (entry.prepare_f64)(values)
    }
}

/// A sampled direction; all 0: no valid sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<T: Scalar = f32> {
    /// To the light, unit.
    pub wi: T::Vector,
    /// Density of wi over all lobes, per solid angle; 0 for a DELTA lobe.
    pub pdf: T,
    /// value / pdf, RGB; for a DELTA lobe what it passes on over the probability of choosing it.
    pub weight: Rgb<T>,
    /// Index on wi's side over the index on wo's side.
    pub eta: T,
    /// Flags of the chosen lobe.
    pub flags: Flags,
    /// Number of the chosen lobe.
    pub lobe: usize,
}

impl<T: Scalar> Sample<T> {
    /// No valid sample.
    fn none() -> Self {
        let zero = T::new(0.0);
        Self {
            wi: [zero; 3].into(),
            pdf: zero,
            weight: [zero; 3],
            eta: zero,
            flags: Flags(0),
            lobe: 0,
        }
    }
}

/// A compiled BSDF. Share it between threads as you like; no call but [`Bsdf::new`] allocates.
///
/// `varying` holds the components of the parameters that [`Description::vary`] declared, one after
/// another, [`Bsdf::varying_floats`] in all; with `None` they keep the values set in the description.
/// A finite number outside its declared range is clamped to it; NaN, infinity, a wrong length or a
/// direction with z <= 0 gives 0. So do directions that are not unit to 1e-3, and directions with
/// z <= 0; with TRANSMISSION among [`Bsdf::flags`], z < 0 is the base's side and z = 0 gives 0.
pub struct Bsdf<T: Scalar = f32> {
    info: &'static ModelInfo,
    /// Those that this instance has.
    pub(super) lobes: &'static [LobeInfo],
    /// Whether there is a base's side.
    is_two_sided: bool,
    pub(super) kernel: Box<dyn Kernel<T>>,
    pub(super) varying: Varying<T>,
    plan: String,
}

impl<T: Scalar> Bsdf<T> {
    /// Validates and compiles a description.
    ///
    /// # Errors
    /// `UnknownName`, `OutOfRange`, `InvalidArgument` or `Unsupported`, with a message that names
    /// the parameter, its value and what is allowed; `OutOfMemory` if a model's tables find no room.
    pub fn new(description: &Description) -> Result<Self, Error> {
        let entry = bsdf::find(description.model())?;
        let resolved = description.resolve(entry)?;
        let values = resolved.values_in::<T>(entry.info);
        let lobes = (entry.lobes)(&resolved.values);
        let kernel = T::prepare(entry, &values)?;
        Ok(Self {
            plan: plan_in_words(&*kernel),
            info: entry.info,
            lobes,
            is_two_sided: Flags::of(lobes).contains(Flags::TRANSMISSION),
            kernel,
            varying: Varying::new(entry.info, &values, &resolved.varying),
        })
    }

    /// What the model says about itself.
    pub fn info(&self) -> &'static ModelInfo {
        self.info
    }

    /// What this BSDF was specialised to: terms that its values leave out and formulas that are shorter for
    /// them, separated by commas; and what batches run with.
    pub fn plan(&self) -> &str {
        &self.plan
    }

    /// The flags of the lobes that this BSDF has, together: those of the model, or fewer.
    pub fn flags(&self) -> Flags {
        Flags::of(self.lobes)
    }

    /// The lobes that this BSDF has: those of the model, or some of them. A sample's lobe is an index
    /// into them.
    pub fn lobe_infos(&self) -> &'static [LobeInfo] {
        self.lobes
    }

    /// How many parameters vary per call.
    pub fn varying_count(&self) -> usize {
        self.varying.count()
    }

    /// How many numbers the varying parameters have together.
    pub fn varying_floats(&self) -> usize {
        self.varying.floats()
    }

    /// The varying parameters' own values, in the form of a `varying` argument.
    pub fn varying_defaults(&self) -> &[T] {
        self.varying.defaults()
    }

    /// How many components each varying parameter has, in declared order.
    pub fn varying_components(&self) -> impl Iterator<Item = usize> + '_ {
        self.varying.components()
    }

    /// f(wo, wi) |wi.z|.
    pub fn eval(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> Rgb<T> {
        self.at_pair(wo, wi, varying, |kernel, overrides, wo, wi| {
            kernel.eval(overrides, wo, wi)
        })
        .unwrap_or([T::new(0.0); 3])
    }

    /// [`Bsdf::eval`] and the density with which [`Bsdf::sample`] finds wi, per solid angle.
    pub fn eval_pdf(&self, wo: T::Vector, wi: T::Vector, varying: Option<&[T]>) -> (Rgb<T>, T) {
        self.at_pair(wo, wi, varying, |kernel, overrides, wo, wi| {
            kernel.eval_pdf(overrides, wo, wi)
        })
        .unwrap_or(([T::new(0.0); 3], T::new(0.0)))
    }

    /// The probability of choosing each lobe, and each lobe's own density at wi.
    pub fn lobes(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
    ) -> (PerLobe<T>, PerLobe<T>) {
        let none = [T::new(0.0); bsdf::MAX_LOBES];
        self.at_pair(wo, wi, varying, |kernel, overrides, wo, wi| {
            kernel.lobes(overrides, wo, wi)
        })
        .unwrap_or((none, none))
    }

    /// A direction for three uniform numbers in [0, 1).
    pub fn sample(&self, wo: T::Vector, u: T::Vector, varying: Option<&[T]>) -> Sample<T> {
        let u: [T; 3] = u.into();
        let sampled = self.direction(wo).and_then(|wo| {
            if !u.into_iter().all(bsdf::is_uniform) {
                return None;
            }
            self.varying
                .with(varying, |overrides| self.kernel.sample(overrides, wo, u))?
        });
        sampled.map_or(Sample::none(), |sampled| Sample {
            wi: sampled.wi.to_array().into(),
            pdf: sampled.pdf,
            weight: sampled.weight,
            eta: sampled.eta,
            flags: self.lobes[sampled.lobe].flags,
            lobe: sampled.lobe,
        })
    }

    /// Directional albedo, the integral of the value over wi: how bright the surface looks from wo in
    /// a white furnace. By quadrature (some milliseconds) unless the model has a closed form. What is
    /// transmitted counts as radiance, (eta_o / eta_i)^2 times its power: seen from within a dense
    /// base the albedo exceeds 1.
    pub fn albedo(&self, wo: T::Vector, varying: Option<&[T]>) -> Rgb<T> {
        self.direction(wo)
            .and_then(|wo| {
                self.varying
                    .with(varying, |overrides| self.kernel.albedo(overrides, wo))
            })
            .unwrap_or([T::new(0.0); 3])
    }

    /// Calls `f` if both directions and the varying values are valid.
    #[inline(always)]
    fn at_pair<R>(
        &self,
        wo: T::Vector,
        wi: T::Vector,
        varying: Option<&[T]>,
        f: impl FnOnce(&dyn Kernel<T>, &[Override<T>], Vec3<T>, Vec3<T>) -> R,
    ) -> Option<R> {
        let (wo, wi) = (self.direction(wo)?, self.direction(wi)?);
        self.varying
            .with(varying, |overrides| f(&*self.kernel, overrides, wo, wi))
    }

    /// The direction, if it is unit to 1e-3 and on a side that there is.
    #[inline(always)]
    fn direction(&self, w: T::Vector) -> Option<Vec3<T>> {
        let w = Vec3::from_array(w.into());
        let is_valid = if self.is_two_sided {
            bsdf::is_unit(w) && w.z != T::new(0.0)
        } else {
            bsdf::is_above(w)
        };
        is_valid.then_some(w)
    }
}

fn plan_in_words<T: Precision>(kernel: &dyn Kernel<T>) -> String {
    let mut words = kernel.plan().join(", ");
    if words.is_empty() {
        words.push_str("all terms");
    }
    let batches = match kernel.tiles() {
        Some(_) => Level::chosen().name(),
        None => "single calls",
    };
    format!("{words}; batches by {batches}")
}
