//! The description of a model: name, parameters, lobes, and which laws it breaks and why.
//!
//! The C interface keeps NUL-terminated copies of these texts.

/// A set of flags of lobes. The bits are those of the C interface (`PELLICLE_REFLECTION` and so on).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flags(pub u32);

impl Flags {
    /// Light leaves on the side of the viewer.
    pub const REFLECTION: Self = Self(1);
    /// Light leaves on the other side.
    pub const TRANSMISSION: Self = Self(2);
    /// The lobe is broad and has no preferred direction.
    pub const DIFFUSE: Self = Self(4);
    /// The lobe lies around a preferred direction.
    pub const GLOSSY: Self = Self(8);
    /// The lobe is perfectly specular: its value and density are 0, and only sampling finds it.
    pub const DELTA: Self = Self(16);

    /// Every flag.
    pub const ALL: Self = Self(31);

    /// The union of both sets.
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The union of the flags of several lobes.
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

/// A model as validation, introspection, tests and documentation see it.
#[derive(Debug)]
pub struct ModelInfo {
    /// The name, for [`Description::new`](super::Description::new).
    pub name: &'static str,
    /// What the model is, in one sentence.
    pub summary: &'static str,
    /// The publications of the model.
    pub source: &'static str,
    /// The parameters. Other fields refer to them by their index in this list.
    pub params: &'static [ParamInfo],
    /// The lobes that sampling chooses from. A BSDF may have fewer, see
    /// [`Bsdf::lobe_infos`](super::Bsdf::lobe_infos).
    pub lobes: &'static [LobeInfo],
    /// For a model that takes a film: the index of the parameter that is the thickness of the film's
    /// varying layer.
    pub film_thickness: Option<usize>,
    /// For a model that takes a film: the index of the parameter that is the standard deviation of that thickness.
    pub film_thickness_spread: Option<usize>,
    /// For a model that takes a film only under one choice: that choice.
    pub film_choice: Option<Choice>,
    /// When and why value(wo, wi) wo.z differs from value(wi, wo) wi.z; `None` if it never does.
    pub not_reciprocal: Option<Exception>,
    /// When and why the directional albedo exceeds 1; `None` if it never does.
    pub not_conserving: Option<Exception>,
}

impl ModelInfo {
    /// The defaults of the fields: no parameters, no lobes, no film, and every law obeyed.
    pub(super) const PLAIN: Self = Self {
        name: "",
        summary: "",
        source: "",
        params: &[],
        lobes: &[],
        film_thickness: None,
        film_thickness_spread: None,
        film_choice: None,
        not_reciprocal: None,
        not_conserving: None,
    };

    /// The union of the flags of all lobes.
    pub fn flags(&self) -> Flags {
        Flags::of(self.lobes)
    }

    /// The index of the parameter with that name.
    pub fn param(&self, name: &str) -> Option<usize> {
        self.params.iter().position(|param| param.name == name)
    }
}

/// One choice of one parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The index of the parameter, whose kind is [`ParamKind::Choice`].
    pub param: usize,
    /// The index of the chosen name.
    pub choice: usize,
}

/// A [`Choice`] from the indices of the parameter and of the chosen name.
pub(super) const fn chosen(param: usize, choice: usize) -> Choice {
    Choice { param, choice }
}

/// A law that a model breaks for some of its choices.
#[derive(Debug)]
pub struct Exception {
    /// The cases in which the law is broken: in each, all of its choices are made.
    pub cases: &'static [&'static [Choice]],
    /// When and why, in words that name the choices.
    pub reason: &'static str,
}

impl Exception {
    /// Whether the law is broken. `chosen` gives the choice made for each parameter.
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
    /// The name, for documentation and tests.
    pub name: &'static str,
    /// The side and the breadth of the lobe.
    pub flags: Flags,
}

impl LobeInfo {
    /// A diffuse lobe that reflects.
    pub(super) const DIFFUSE: Self = Self {
        name: "diffuse",
        flags: Flags::REFLECTION.with(Flags::DIFFUSE),
    };
    /// A glossy lobe that reflects.
    pub(super) const SPECULAR: Self = Self {
        name: "specular",
        flags: Flags::REFLECTION.with(Flags::GLOSSY),
    };
}

/// A parameter of a model.
#[derive(Debug)]
pub struct ParamInfo {
    /// The name, for [`Description::set`](super::Description::set) or
    /// [`choose`](super::Description::choose).
    pub name: &'static str,
    /// "nm", "radians" or "turns", or "" for a pure number.
    pub unit: &'static str,
    /// What the parameter means, in one sentence.
    pub summary: &'static str,
    /// Its kind, range and default.
    pub kind: ParamKind,
    /// Whether it may vary per call.
    pub can_vary: bool,
    /// Whether its three numbers are refractive indices or extinction coefficients at 645, 525 and 445 nm, which
    /// spectral calls interpolate. Colours have no value at other wavelengths.
    pub is_index: bool,
    /// The cases in which the parameter has an effect: in each, all of its choices are made. Without cases
    /// it always has one. A description that gives a parameter without effect is refused.
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
            is_index: false,
            used_with: &[],
        }
    }

    /// One number, which may vary.
    pub(super) const fn number(
        name: &'static str,
        summary: &'static str,
        range: [f32; 2],
        default: f32,
    ) -> Self {
        Self::numbers(name, summary, 1, range, default)
    }

    /// One number per colour channel, which may vary.
    pub(super) const fn rgb(
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

    /// A direction whose z is at least `min_z` after normalisation; it may vary.
    pub(super) const fn direction(name: &'static str, summary: &'static str, min_z: f32) -> Self {
        Self::new(name, summary, ParamKind::Direction { min_z })
    }

    /// A choice, which may not vary.
    pub(super) const fn choice(
        name: &'static str,
        summary: &'static str,
        choices: &'static [&'static str],
    ) -> Self {
        Self::new(name, summary, ParamKind::Choice { choices })
    }

    /// The same parameter with a unit.
    pub(super) const fn in_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// The same parameter with an effect only where all choices of one of the cases are made.
    pub(super) const fn used_with(self, cases: &'static [&'static [Choice]]) -> Self {
        Self {
            used_with: cases,
            ..self
        }
    }

    /// Whether the parameter has an effect. `chosen` gives the choice made for each parameter.
    pub fn is_used(&self, chosen: impl Fn(usize) -> usize) -> bool {
        self.used_with.is_empty() || is_any_made(self.used_with, chosen)
    }

    /// The same parameter, which is an index at three wavelengths.
    pub(super) const fn index(self) -> Self {
        Self {
            is_index: true,
            ..self
        }
    }

    /// The number of values that a spectral call with `count` wavelengths takes: one per wavelength for a colour.
    pub fn spectral_components(&self, count: usize) -> usize {
        if self.is_color() {
            count
        } else {
            self.components()
        }
    }

    /// Whether it is a colour, of which spectral calls take one number per wavelength.
    pub fn is_color(&self) -> bool {
        matches!(self.kind, ParamKind::Number { components: 3, .. }) && !self.is_index
    }

    /// The same parameter, which may not vary.
    pub(super) const fn fixed(self) -> Self {
        Self {
            can_vary: false,
            ..self
        }
    }

    /// The name.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The number of its components; 0 for a choice.
    pub fn components(&self) -> usize {
        match self.kind {
            ParamKind::Number { components, .. } => components,
            ParamKind::Direction { .. } => 3,
            ParamKind::Choice { .. } => 0,
        }
    }
}

/// The kind of a parameter, the values allowed and the default.
#[derive(Debug)]
pub enum ParamKind {
    /// One or three numbers, each within [min, max].
    Number {
        /// The number of components: 1 or 3.
        components: usize,
        /// Least value of each component.
        min: f32,
        /// Greatest value of each component.
        max: f32,
        /// Default of each component.
        default: f32,
    },
    /// A direction in the shading frame, of any length but 0. The default is +Z.
    Direction {
        /// Least z after normalisation.
        min_z: f32,
    },
    /// One name out of a list. The first is the default.
    Choice {
        /// The names.
        choices: &'static [&'static str],
    },
}
