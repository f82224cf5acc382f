//! Who takes part: every interference method, films as the plan compiles them, and the reference.

use crate::suite::{Point, Range, Stack, Truth};
use pellicle::Error;
use pellicle::film::{Film, Kind, Method, Sensitivity};
use std::time::Instant;

/// One method with one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry {
    /// A method for one film.
    Method(Kind),
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
    Gaussian,
    Tabulated,
    Planned,
    Reference,
}

/// Tolerances of the planned films, coarsest first.
const TOLERANCES: [f64; 3] = [1e-2, 2e-3, 2e-4];

/// What times are compared with: three harmonics, the best that renderers use.
pub const BASELINE: Entry = Entry::Method(Kind::Harmonics(Sensitivity::Tabulated, 3));

impl Family {
    pub const ALL: [Self; 8] = [
        Self::TwoBeam,
        Self::AiryRgb,
        Self::Quadrature,
        Self::Bands,
        Self::Gaussian,
        Self::Tabulated,
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
            Self::Gaussian => "harmonics, 2 terms, Gaussians (Belcour & Barla 2017)",
            Self::Tabulated => "harmonics, 1 to 5 terms, table (Belcour & Barla 2017)",
            Self::Planned => "planned film (ours), by its tolerance",
            Self::Reference => "reference: error 0, drawn at the floor",
        }
    }
}

impl Entry {
    /// Everyone, each family together and from coarse to fine.
    pub fn all() -> Vec<Self> {
        let mut kinds = Kind::ALL.to_vec();
        for order in [1, 4, 5] {
            kinds.push(Kind::Harmonics(Sensitivity::Tabulated, order));
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
            Self::Method(Kind::TwoBeam) => Family::TwoBeam,
            Self::Method(Kind::AiryRgb) => Family::AiryRgb,
            Self::Method(Kind::Quadrature(_)) => Family::Quadrature,
            Self::Method(Kind::Bands(_)) => Family::Bands,
            Self::Method(Kind::Harmonics(Sensitivity::Gaussian, _)) => Family::Gaussian,
            Self::Method(Kind::Harmonics(Sensitivity::Tabulated, _)) => Family::Tabulated,
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
            Self::Method(Kind::Quadrature(count)) => format!("N={count}"),
            Self::Method(Kind::Bands(count)) => format!("K={count}"),
            Self::Method(Kind::Harmonics(_, 1)) => "1 term".into(),
            Self::Method(Kind::Harmonics(_, order)) => format!("{order} terms"),
            Self::Planned(tolerance) => format!("{tolerance:e}"),
            Self::Method(Kind::TwoBeam | Kind::AiryRgb) | Self::Reference => String::new(),
        }
    }
}

fn size(kind: Kind) -> usize {
    match kind {
        Kind::TwoBeam | Kind::AiryRgb => 0,
        Kind::Quadrature(size) | Kind::Bands(size) | Kind::Harmonics(_, size) => size,
    }
}

/// An entry, ready for one stack and range.
pub enum Compiled {
    Method(Box<dyn Method<f32>>),
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
                Some(layer) => Self::Method(kind.compile(&layer)?),
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
