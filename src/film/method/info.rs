//! The description of a method, for the planner.

use super::compiled_method::{CompiledMethod, Ingredients};
use super::one_layer::OneLayer;
use crate::error::Error;
use crate::film::description::FilmDescription;
use crate::film::evaluator::MethodEvaluator;
use crate::film::plan::planner::{Candidate, Planner};
use crate::film::plan::points::critical_angles;
use crate::num::Rgb;
use crate::optics::stack::Side;

/// A method: its name, its sizes, its cost and how it is compiled.
pub(in crate::film) struct MethodInfo {
    /// The name that forces the method ([`FilmDescription::method`]) and that
    /// [`FilmPlan::method`](crate::film::FilmPlan::method) reports.
    pub name: &'static str,
    /// The sizes that are tried; a method without sizes has one, which it ignores.
    pub sizes: &'static [usize],
    /// The cost of a call in a size, ns: about the median of `./x chart` on one core of a 2024 server
    /// (docs/chart.csv). Costs only have to put the methods in order; they are constants, so that the order
    /// is the same on every machine.
    pub cost_ns: fn(usize) -> f64,
    /// Whether a plan may choose the method unasked.
    pub is_automatic: bool,
    /// Whether the method takes a film.
    pub takes: fn(&FilmDescription) -> bool,
    /// The films that it takes, in words.
    pub takes_words: &'static str,
    /// The greatest error that may be measured for a tolerance.
    pub allowed_error: fn(f64) -> f64,
    /// Why a plan chooses the method unasked.
    pub reason: &'static str,
    pub compile: Compile,
}

/// The constructor of a method.
pub(in crate::film) enum Compile {
    /// For a film of one layer.
    OneLayer(OneLayerCompile),
    /// For a bare base, of its reflectance at normal incidence; and the size in words.
    BareBase(fn(&FilmDescription, Rgb<f32>) -> MethodInWords),
    /// For any film that the method takes; `None` if it cannot hold the tolerance.
    Film(fn(&Planner<'_>) -> Result<Option<Candidate>, Error>),
}

/// A compiled method, and its size in words.
type MethodInWords = (Box<dyn CompiledMethod<f32>>, String);

/// A constructor for a film of one layer and a size. It fails if the size is out of range.
type Constructor<T> = fn(&OneLayer, usize) -> Result<Box<dyn CompiledMethod<T>>, Error>;

/// The constructors of a method for one layer.
pub(in crate::film) struct OneLayerCompile {
    pub single: Constructor<f32>,
    pub double: Constructor<f64>,
    /// The work of an evaluation in a size, in words.
    pub work: fn(usize) -> String,
}

/// The part of the tolerance that the error of a method for one layer may have at the points where it
/// is measured.
const MEASURED: f64 = 0.4;

impl MethodInfo {
    /// The common part of methods for one layer, which have one size and are not chosen unasked. The errors
    /// of fixed wavelengths and of truncated series jump, because they alias.
    pub(super) const fn one_layer(name: &'static str, compile: OneLayerCompile) -> Self {
        Self {
            name,
            sizes: &[1],
            cost_ns: |_| f64::INFINITY,
            is_automatic: false,
            takes: |description| description.layers.len() == 1 && !description.transmittance,
            takes_words: "one layer, and no transmittance",
            allowed_error: |tolerance| MEASURED * tolerance,
            reason: "the cheapest method that holds the tolerance",
            compile: Compile::OneLayer(compile),
        }
    }

    /// Compiles the method for the planner's film and measures it; `None` if it cannot hold the
    /// tolerance.
    pub(in crate::film) fn compile(
        &self,
        planner: &Planner<'_>,
        size: usize,
    ) -> Result<Option<Candidate>, Error> {
        let description = planner.description;
        let mut ingredients = Ingredients {
            size,
            normal: [0.0; 3],
        };
        if let Compile::BareBase(_) = self.compile {
            let thicknesses = description.thicknesses(0.0);
            let found = planner.reference.evaluate(Side::Ambient, 1.0, &thicknesses);
            ingredients.normal = found.reflectance.map(|channel| channel as f32);
        }
        let Some((method, size)) = self.made_from(description, ingredients)? else {
            return match &self.compile {
                Compile::Film(compile) => compile(planner),
                _ => Ok(None),
            };
        };
        let mut candidate = planner.measured(method, size);
        if self.is_automatic && matches!(self.compile, Compile::OneLayer(_)) {
            // Where few points are measured, none need lie where a line of a table shows.
            let unresolved = description.unresolved(ingredients.size)?;
            let max = &mut candidate.errors[0].max;
            *max = max.max(unresolved);
        }
        Ok(Some(candidate))
    }

    /// The method for a film that it takes, and its size in words; `None` if it takes more than ingredients.
    pub(in crate::film) fn made_from(
        &self,
        description: &FilmDescription,
        ingredients: Ingredients,
    ) -> Result<Option<(MethodEvaluator, String)>, Error> {
        let size = ingredients.size;
        let (compiled, size): MethodInWords = match &self.compile {
            Compile::OneLayer(compile) => (
                Box::new(OneLayerFilm::new(description, compile, size)?),
                (compile.work)(size),
            ),
            Compile::BareBase(make) => make(description, ingredients.normal),
            Compile::Film(_) => return Ok(None),
        };
        let method = MethodEvaluator {
            compiled,
            ingredients,
        };
        Ok(Some((method, size)))
    }
}

/// A method for a film of one layer, in the precision that the film needs.
struct OneLayerFilm {
    method: InPrecision,
    /// The thickness, nm, if it does not vary.
    fixed_nm: Option<f32>,
}

/// Double precision is for films that reflect some light totally: at a critical angle a wave is the
/// root of a difference of squares and has half of their digits. In single precision bands were off by
/// 5e-3 there.
enum InPrecision {
    Single(Box<dyn CompiledMethod<f32>>),
    Double(Box<dyn CompiledMethod<f64>>),
}

impl OneLayerFilm {
    fn new(
        description: &FilmDescription,
        compile: &OneLayerCompile,
        size: usize,
    ) -> Result<Self, Error> {
        let layer = OneLayer::new(
            description.ambient.clone(),
            description.layers[0].medium.clone(),
            description.base.clone(),
            description.white,
            description.color_space,
        )?;
        let critical = critical_angles(description, Side::Ambient).all();
        let is_fixed = description.varying().is_none();
        Ok(Self {
            method: if critical.is_empty() {
                InPrecision::Single((compile.single)(&layer, size)?)
            } else {
                InPrecision::Double((compile.double)(&layer, size)?)
            },
            fixed_nm: is_fixed.then_some(description.layers[0].thickness_nm[0] as f32),
        })
    }
}

impl CompiledMethod<f32> for OneLayerFilm {
    fn reflectance(&self, cos_theta: f32, thickness_nm: f32) -> Rgb<f32> {
        let thickness_nm = self.fixed_nm.unwrap_or(thickness_nm);
        match &self.method {
            InPrecision::Single(method) => method.reflectance(cos_theta, thickness_nm),
            InPrecision::Double(method) => method
                .reflectance(f64::from(cos_theta), f64::from(thickness_nm))
                .map(|channel| channel as f32),
        }
    }
}
