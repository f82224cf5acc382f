//! What a model says about itself: name, parameters, lobes, and which laws it breaks and why.
//!
//! The C interface keeps NUL-terminated copies of these texts.

/// A set of the `PELLICLE_REFLECTION`, ... bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flags(pub u32);

impl Flags {
    /// Light leaves on the side of the viewer.
    pub const REFLECTION: Self = Self(1);
    /// Light leaves on the other side.
    pub const TRANSMISSION: Self = Self(2);
    /// A broad lobe.
    pub const DIFFUSE: Self = Self(4);
    /// A lobe around a preferred direction.
    pub const GLOSSY: Self = Self(8);
    /// A perfectly specular lobe.
    pub const DELTA: Self = Self(16);

    /// Every flag.
    pub const ALL: Self = Self(31);

    /// Both sets together.
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Those of several lobes together.
    pub fn of(lobes: &[LobeInfo]) -> Self {
        lobes
            .iter()
            .fold(Self(0), |flags, lobe| flags.with(lobe.flags))
    }

    /// Whether every bit of `other` is set.
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
}

/// A model: everything that introspection, validation, tests and documentation need to know.
#[derive(Debug)]
pub struct ModelInfo {
    /// The name to create it by.
    pub name: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// Where the model comes from.
    pub source: &'static str,
    /// The parameters, in the order of their indices.
    pub params: &'static [ParamInfo],
    /// The lobes that sampling chooses from, in the order of their numbers.
    pub lobes: &'static [LobeInfo],
    /// Index of the parameter that is the thickness of the film's varying layer, for a model that
    /// takes a film.
    pub film_thickness: Option<usize>,
    /// The choice under which alone a model that takes a film uses it.
    pub film_choice: Option<Choice>,
    /// When and why value(wo, wi) wo.z differs from value(wi, wo) wi.z.
    pub not_reciprocal: Option<Exception>,
    /// When and why the directional albedo exceeds 1.
    pub not_conserving: Option<Exception>,
}

impl ModelInfo {
    /// No lobes, no film, and every law obeyed: what a model does not say.
    pub const PLAIN: Self = Self {
        name: "",
        summary: "",
        source: "",
        params: &[],
        lobes: &[],
        film_thickness: None,
        film_choice: None,
        not_reciprocal: None,
        not_conserving: None,
    };

    /// The flags of all lobes together.
    pub fn flags(&self) -> Flags {
        Flags::of(self.lobes)
    }

    /// The index of a parameter.
    pub fn param(&self, name: &str) -> Option<usize> {
        self.params.iter().position(|param| param.name == name)
    }
}

/// One choice of one parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Index of the parameter, a choice.
    pub param: usize,
    /// Index of what is chosen.
    pub choice: usize,
}

/// A law that a model breaks for some of its choices.
#[derive(Debug)]
pub struct Exception {
    /// The law is broken where all choices of one of these cases are made.
    pub cases: &'static [&'static [Choice]],
    /// The reason, naming the choices.
    pub reason: &'static str,
}

impl Exception {
    /// Whether the law is broken, given what is chosen for each parameter.
    pub fn applies(&self, chosen: impl Fn(usize) -> usize) -> bool {
        is_any_made(self.cases, chosen)
    }
}

/// Whether all choices of one of the cases are made.
fn is_any_made(cases: &[&[Choice]], chosen: impl Fn(usize) -> usize) -> bool {
    let is_made = |choice: &Choice| chosen(choice.param) == choice.choice;
    cases.iter().any(|case| case.iter().all(is_made))
}

/// A lobe that sampling may choose.
#[derive(Debug)]
pub struct LobeInfo {
    /// Its name in documentation and tests.
    pub name: &'static str,
    /// Side and breadth.
    pub flags: Flags,
}

impl LobeInfo {
    /// A broad lobe that reflects.
    pub const DIFFUSE: Self = Self {
        name: "diffuse",
        flags: Flags::REFLECTION.with(Flags::DIFFUSE),
    };
    /// A highlight.
    pub const SPECULAR: Self = Self {
        name: "specular",
        flags: Flags::REFLECTION.with(Flags::GLOSSY),
    };
}

/// A parameter.
#[derive(Debug)]
pub struct ParamInfo {
    /// The name it is set by.
    pub name: &'static str,
    /// "nm", or "" for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// What it holds.
    pub kind: ParamKind,
    /// Whether it may be given per call.
    pub can_vary: bool,
    /// The parameter has an effect where all choices of one of these cases are made; none: always. Where it
    /// has none, a description that gives it is refused.
    pub used_with: &'static [&'static [Choice]],
}

impl ParamInfo {
    const fn new(name: &'static str, summary: &'static str, kind: ParamKind) -> Self {
        let unit = "";
        let can_vary = !matches!(kind, ParamKind::Choice { .. });
        Self {
            name,
            unit,
            summary,
            kind,
            can_vary,
            used_with: &[],
        }
    }

    /// A number that may vary.
    pub const fn number(
        name: &'static str,
        summary: &'static str,
        range: [f32; 2],
        default: f32,
    ) -> Self {
        Self::numbers(name, summary, 1, range, default)
    }

    /// A number per colour channel that may vary.
    pub const fn rgb(
        name: &'static str,
        summary: &'static str,
        range: [f32; 2],
        default: f32,
    ) -> Self {
        Self::numbers(name, summary, 3, range, default)
    }

    const fn numbers(
        name: &'static str,
        summary: &'static str,
        components: usize,
        [min, max]: [f32; 2],
        default: f32,
    ) -> Self {
        let kind = ParamKind::Number {
            components,
            min,
            max,
            default,
        };
        Self::new(name, summary, kind)
    }

    /// A direction that may vary, whose z is at least `min_z` after normalisation.
    pub const fn direction(name: &'static str, summary: &'static str, min_z: f32) -> Self {
        Self::new(name, summary, ParamKind::Direction { min_z })
    }

    /// A choice, which may not.
    pub const fn choice(
        name: &'static str,
        summary: &'static str,
        choices: &'static [&'static str],
    ) -> Self {
        Self::new(name, summary, ParamKind::Choice { choices })
    }

    /// With a unit.
    pub const fn in_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// Has an effect only where all choices of one of the cases are made.
    pub const fn used_with(self, cases: &'static [&'static [Choice]]) -> Self {
        Self {
            used_with: cases,
            ..self
        }
    }

    /// Whether it has an effect, given what is chosen for each parameter.
    pub fn is_used(&self, chosen: impl Fn(usize) -> usize) -> bool {
        self.used_with.is_empty() || is_any_made(self.used_with, chosen)
    }

    /// May not be given per call.
    pub const fn fixed(self) -> Self {
        Self {
            can_vary: false,
            ..self
        }
    }

    /// Its name.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// How many numbers it has; 0 for a choice.
    pub fn components(&self) -> usize {
        match self.kind {
            ParamKind::Number { components, .. } => components,
            ParamKind::Direction { .. } => 3,
            ParamKind::Choice { .. } => 0,
        }
    }
}

/// What a parameter holds, what is allowed, and its default.
#[derive(Debug)]
pub enum ParamKind {
    /// Numbers, each within [min, max].
    Number {
        /// 1 or 3.
        components: usize,
        /// Least value of each component.
        min: f32,
        /// Greatest value of each component.
        max: f32,
        /// Default of each component.
        default: f32,
    },
    /// A direction in the shading frame, of any length but 0; +Z by default.
    Direction {
        /// Least z after normalisation.
        min_z: f32,
    },
    /// One name out of a list; the first by default.
    Choice {
        /// The names.
        choices: &'static [&'static str],
    },
}
