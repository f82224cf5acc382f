//! Kinds of stacks, each with a part of the numbers: most are as they are drawn, others are made of such a stack.

use super::draw::{self, ETA, GREATEST_K, dispersive, one_in, pick};
use super::rng;
use super::stack::{Index, Lines, Stack};
use crate::shared::directions::log_uniform;
use pellicle::optics::NamedMedium;
use rand::{Rng, RngExt};

/// What is special about a stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing: R only, or with T where the draw says so.
    General,
    /// With T, between half-spaces whose indices are constant.
    Constant,
    /// With T, between half-spaces of which at least one disperses.
    Dispersing,
    /// A layer or the base is given by a table of lines, down to 0.1 nm wide.
    Lines,
    /// The thickness varies up to between 30 um and 1 mm.
    Thick,
}

/// Every kind, and its name.
pub const KINDS: [(Kind, &str); 5] = [
    (Kind::General, "general"),
    (Kind::Constant, "constant"),
    (Kind::Dispersing, "dispersing"),
    (Kind::Lines, "lines"),
    (Kind::Thick, "thick"),
];

/// Thicknesses up to which those of [`Kind::Thick`] vary, nm.
const THICK_NM: [f32; 2] = [3e4, 1e6];
/// Distances of a line's centre and its ends, nm.
const HALF_WIDTH_NM: [f32; 2] = [0.1, 3.0];
/// The greatest number of lines of a medium: neighbours are then further apart than their ends.
const MOST_LINES: usize = 40;

impl Kind {
    /// The kind of the stack of that number: of 1000 a quarter each are constant and dispersing, 10 have lines, 10 are
    /// thick.
    pub fn of(number: usize) -> Self {
        match (number % 100, number % 4) {
            (5, _) => Self::Lines,
            (9, _) => Self::Thick,
            (_, 2) => Self::Constant,
            (_, 3) => Self::Dispersing,
            _ => Self::General,
        }
    }

    pub fn name(self) -> &'static str {
        let named = KINDS.iter().find(|(kind, _)| *kind == self);
        named.expect("every kind has a name").1
    }

    /// Of a number of points asked for, this part is compared: both sides of a point take twice as long, and the
    /// reference of a thick film takes milliseconds.
    pub fn points(self, count: usize) -> usize {
        let divisor = match self {
            Self::General => 1,
            Self::Constant | Self::Dispersing => 2,
            Self::Lines => 10,
            Self::Thick => 100,
        };
        count.div_ceil(divisor)
    }

    /// Of a stack that is checked from both sides, every point of this number is.
    pub fn both_sides_stride(self) -> usize {
        if self == Self::General { 10 } else { 1 }
    }
}

/// The stack of that number in the series that a seed begins.
pub fn stack(seed: u64, number: usize) -> Stack {
    let stack = draw::general(seed, number);
    let rng = &mut rng(seed, number, 2);
    match Kind::of(number) {
        Kind::General => stack,
        Kind::Constant => constant(stack, rng),
        Kind::Dispersing => dispersing(stack, number, rng),
        Kind::Lines => lines(stack, rng),
        Kind::Thick => thick(stack, rng),
    }
}

/// Keeps a base that is constant and transparent.
fn constant(mut stack: Stack, rng: &mut impl Rng) -> Stack {
    let eta = rng.random_range(ETA[0]..=ETA[1]);
    let index = stack.base.medium().constant();
    if index.is_none_or(|index| index.im > 0.0) {
        stack.base = Index::constant(eta, 0.0);
    }
    Stack {
        kind: Kind::Constant,
        both_sides: true,
        ..stack
    }
}

/// The base is named, in turn, or given by three numbers, or the ambient's; every second ambient disperses too.
fn dispersing(stack: Stack, number: usize, rng: &mut impl Rng) -> Stack {
    let ambient = match rng.random_range(0..8) {
        0 | 1 => Index::Named("air"),
        2 => Index::Named(pick(&transparent(), rng)),
        3 => rgb(rng.random_range(1.0..=1.6), rng),
        _ => stack.ambient,
    };
    let base = match rng.random_range(0..8) {
        0 | 1 => rgb(rng.random_range(ETA[0]..=ETA[1]), rng),
        2 if ambient.medium().constant().is_none() => ambient.clone(),
        3 if ambient.medium().constant().is_none() => Index::VACUUM,
        _ => {
            let bases = not_opaque();
            Index::Named(bases[number / 4 % bases.len()])
        }
    };
    Stack {
        kind: Kind::Dispersing,
        both_sides: true,
        ambient,
        base,
        ..stack
    }
}

/// Disperses and is transparent.
fn rgb(eta: f32, rng: &mut impl Rng) -> Index {
    dispersive(eta, 0.0, rng)
}

/// Named media that disperse and do not absorb.
pub fn transparent() -> Vec<&'static str> {
    let media = NamedMedium::all().iter();
    let found = media.filter(|medium| !medium.absorbs() && medium.constant().is_none());
    found.map(|medium| medium.name).collect()
}

/// Named media that disperse and through which light goes.
pub fn not_opaque() -> Vec<&'static str> {
    let media = NamedMedium::all().iter();
    let found = media.filter(|medium| {
        let description = pellicle::film::FilmDescription::new(Index::Named(medium.name).medium());
        !description.is_base_opaque() && medium.constant().is_none()
    });
    found.map(|medium| medium.name).collect()
}

/// A layer, or the base, of lines of absorption or of the index.
fn lines(mut stack: Stack, rng: &mut impl Rng) -> Stack {
    let count = rng.random_range(1..=MOST_LINES);
    let cell = 400.0 / count as f32;
    let centers = (0..count).map(|i| 380.0 + cell * (i as f32 + rng.random_range(0.35..=0.65)));
    let centers_nm = centers.collect();
    let eta = rng.random_range(1.0..=2.5);
    let top = if one_in(2, rng) {
        [eta, log_uniform(rng, 0.02, GREATEST_K)]
    } else {
        [eta + rng.random_range(0.1..=1.0), 0.0]
    };
    let lines = Index::Lines(Lines {
        around: eta,
        top,
        centers_nm,
        half_width_nm: log_uniform(rng, HALF_WIDTH_NM[0], HALF_WIDTH_NM[1]),
    });
    if one_in(2, rng) {
        stack.base = lines;
    } else {
        let layer = rng.random_range(0..stack.layers.len());
        stack.layers[layer].0 = lines;
    }
    stack.both_sides = !stack.base.medium().absorbs();
    stack.kind = Kind::Lines;
    stack
}

/// A thick transparent layer among two others at most.
fn thick(mut stack: Stack, rng: &mut impl Rng) -> Stack {
    stack.layers.truncate(3);
    for (_, range) in &mut stack.layers {
        range[0] = range[1];
    }
    let layer = rng.random_range(0..stack.layers.len());
    let greatest = log_uniform(rng, THICK_NM[0], THICK_NM[1]);
    let least = if one_in(2, rng) { 0.0 } else { 0.3 * greatest };
    let index = Index::constant(rng.random_range(1.0..=2.5), 0.0);
    stack.layers[layer] = (index, [least, greatest]);
    stack.both_sides = !stack.base.medium().absorbs();
    stack.kind = Kind::Thick;
    stack
}
