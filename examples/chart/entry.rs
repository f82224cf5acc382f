//! Who takes part: every interference method, films as the plan compiles them, and the reference.

use crate::suite::{Point, Range, Stack, Truth};
use pellicle::Error;
use pellicle::film::{CompiledMethod, Film, OneLayerMethod};
use std::time::Instant;

/// One method with one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry {
    /// A method for one film.
    Method(OneLayerMethod),
    /// What the plan compiles for a tolerance.
    Planned(f64),
    /// Converged wave optics.
    Reference,
}

/// Entries that differ only in their setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    TwoBeam,
    AiryRgb,
    Quadrature,
    Bands,
    Harmonics,
    Planned,
    Reference,
}

/// Tolerances of the planned films, coarsest first.
const TOLERANCES: [f64; 3] = [1e-2, 2e-3, 2e-4];

/// What times are compared with: three harmonics, the best that renderers use.
pub const BASELINE: Entry = Entry::Method(OneLayerMethod::Harmonics(3));

impl Family {
    pub const ALL: [Self; 7] = [
        Self::TwoBeam,
        Self::AiryRgb,
        Self::Quadrature,
        Self::Bands,
        Self::Harmonics,
        Self::Planned,
        Self::Reference,
    ];

    /// In words, with whom it is from.
    pub fn title(self) -> &'static str {
        match self {
            Self::TwoBeam => "two beams (Granier & Heidrich 2002)",
            Self::AiryRgb => "all beams at 3 wavelengths",
            Self::Quadrature => "all beams at N wavelengths",
            Self::Bands => "all beams over K bands (ours)",
            Self::Harmonics => "harmonics, 1 to 5 terms, table (Belcour & Barla 2017)",
            Self::Planned => "planned film (ours), by its tolerance",
            Self::Reference => "reference: error 0, drawn at the floor",
        }
    }
}

impl Entry {
    /// Everyone, each family together and from coarse to fine.
    pub fn all() -> Vec<Self> {
        let mut kinds = OneLayerMethod::ALL.to_vec();
        for order in [1, 4, 5] {
            kinds.push(OneLayerMethod::Harmonics(order));
        }
        kinds.sort_by_key(|kind| {
            let family = Self::Method(*kind).family();
            (Family::ALL.iter().position(|f| *f == family), size(*kind))
        });
        let methods = kinds.into_iter().map(Self::Method);
        let planned = TOLERANCES.map(Self::Planned);
        methods.chain(planned).chain([Self::Reference]).collect()
    }

    pub fn family(self) -> Family {
        match self {
            Self::Method(OneLayerMethod::TwoBeam) => Family::TwoBeam,
            Self::Method(OneLayerMethod::AiryRgb) => Family::AiryRgb,
            Self::Method(OneLayerMethod::Quadrature(_)) => Family::Quadrature,
            Self::Method(OneLayerMethod::Bands(_)) => Family::Bands,
            Self::Method(OneLayerMethod::Harmonics(_)) => Family::Harmonics,
            Self::Planned(_) => Family::Planned,
            Self::Reference => Family::Reference,
        }
    }

    /// The method's name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Method(kind) => kind.name(),
            Self::Planned(_) => "planned",
            Self::Reference => "reference",
        }
    }

    /// Its size or tolerance; empty if it has none.
    pub fn setting(self) -> String {
        match self {
            Self::Method(OneLayerMethod::Quadrature(count)) => format!("N={count}"),
            Self::Method(OneLayerMethod::Bands(count)) => format!("K={count}"),
            Self::Method(OneLayerMethod::Harmonics(1)) => "1 term".into(),
            Self::Method(OneLayerMethod::Harmonics(order)) => format!("{order} terms"),
            Self::Planned(tolerance) => format!("{tolerance:e}"),
            Self::Method(OneLayerMethod::TwoBeam | OneLayerMethod::AiryRgb) | Self::Reference => {
                String::new()
            }
        }
    }
}

fn size(kind: OneLayerMethod) -> usize {
    match kind {
        OneLayerMethod::TwoBeam | OneLayerMethod::AiryRgb => 0,
        OneLayerMethod::Quadrature(size)
        | OneLayerMethod::Bands(size)
        | OneLayerMethod::Harmonics(size) => size,
    }
}

/// An entry, ready for one stack and range.
pub enum Compiled {
    Method(Box<dyn CompiledMethod<f32>>),
    Film(Box<Film>),
    Reference(Box<Truth>),
}

/// What the plan says about a film.
#[derive(Clone, Debug)]
pub struct PlanNote {
    pub method: String,
    pub measured_max: f64,
    pub bytes: usize,
    /// Wall time of the compilation.
    pub compile_ms: f64,
}

impl Compiled {
    /// None if the method does not take such a stack.
    pub fn new(entry: Entry, stack: &Stack, range: Range) -> Result<Option<Self>, Error> {
        Ok(Some(match entry {
            Entry::Method(kind) => match stack.one_layer() {
                Some(layer) => Self::Method(kind.single(&layer)?),
                None => return Ok(None),
            },
            Entry::Planned(tolerance) => {
                Self::Film(Box::new(Film::new(&stack.description(range, tolerance))?))
            }
            Entry::Reference => Self::Reference(Box::new(stack.truth()?)),
        }))
    }

    /// As [`Compiled::new`], with what the plan says.
    pub fn with_note(
        entry: Entry,
        stack: &Stack,
        range: Range,
    ) -> Result<Option<(Self, Option<PlanNote>)>, Error> {
        let start = Instant::now();
        let compiled = Self::new(entry, stack, range)?;
        let compile_ms = start.elapsed().as_secs_f64() * 1e3;
        Ok(compiled.map(|compiled| {
            let note = match &compiled {
                Self::Film(film) => Some(PlanNote {
                    method: film.plan().method.to_owned(),
                    measured_max: film.plan().measured_max,
                    bytes: film.plan().bytes,
                    compile_ms,
                }),
                Self::Method(_) | Self::Reference(_) => None,
            };
            (compiled, note)
        }))
    }

    /// Whether it is the reference itself, also by the plan's choice: asking it again would only
    /// take time.
    pub fn is_exact(&self) -> bool {
        match self {
            Self::Method(_) => false,
            Self::Film(film) => film.plan().method == "reference",
            Self::Reference(_) => true,
        }
    }

    /// Linear RGB.
    pub fn reflectance(&self, point: Point) -> [f32; 3] {
        match self {
            Self::Method(method) => method.reflectance(point[0], point[1]),
            Self::Film(film) => film.reflectance(point[0], point[1]),
            Self::Reference(truth) => truth.reflectance(point).map(|x| x as f32),
        }
    }
}
