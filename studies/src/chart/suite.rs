//! The films that every method is judged on, and the points.

use crate::shared::directions::rng;
use crate::shared::stack::Stack;
use pellicle::optics::Medium;
use rand::RngExt;

/// Thicknesses to compare over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    pub name: &'static str,
    /// The least and the greatest, nm.
    pub nm: [f64; 2],
    /// Whether the mirror takes part. On thick ones its truth, and films compiled from it, would take longer than
    /// everything else.
    pub has_mirror: bool,
}

impl Range {
    const fn new(name: &'static str, nm: [f64; 2], has_mirror: bool) -> Self {
        Self {
            name,
            nm,
            has_mirror,
        }
    }
}

/// From the thinnest to the thickest.
pub const RANGES: [Range; 4] = [
    Range::new("0 to 400 nm", [0.0, 400.0], true),
    Range::new("0 to 1000 nm", [0.0, 1000.0], true),
    Range::new("0 to 3000 nm", [0.0, 3000.0], false),
    Range::new("3 to 100 um", [3e3, 1e5], false),
];

/// The wavelength that the mirror's fixed layers are a quarter of, nm.
pub const MIRROR_NM: f64 = 550.0;

/// A stack and its name: film/base, or ambient/film/base by indices.
pub type Named = (&'static str, Stack);

/// The stacks, those of one film first.
pub fn stacks() -> Vec<Named> {
    let constant =
        |name, film: f64, base: [f64; 2]| (name, Stack::constant([[1.0, 0.0], [film, 0.0], base]));
    let lacquer = |name, base| {
        let film = Medium::rgb([1.5; 3], [0.0; 3]).unwrap();
        (
            name,
            Stack {
                film,
                ..Stack::named(base, base)
            },
        )
    };
    let quarter = |name| {
        let medium = Medium::named(name).unwrap();
        let nm = MIRROR_NM / (4.0 * medium.index(MIRROR_NM).re);
        (medium, nm)
    };
    let [high, low] = ["TiO2", "SiO2"].map(quarter);
    let mirror = Stack {
        fixed: vec![low.clone(), high.clone(), low, high],
        ..Stack::named("TiO2", "BK7")
    };
    vec![
        constant("1/1.33/1", 1.33, [1.0, 0.0]),
        constant("1/1.5/1.33", 1.5, [1.33, 0.0]),
        constant("1/1.38/1.52", 1.38, [1.52, 0.0]),
        constant("1/2.4/1.5", 2.4, [1.5, 0.0]),
        constant("1/1.5/(1.5+3i)", 1.5, [1.5, 3.0]),
        constant("1/2.4/(2.9+3.1i)", 2.4, [2.9, 3.1]),
        lacquer("lacquer/Au", "Au"),
        lacquer("lacquer/Cu", "Cu"),
        ("SiO2/Si", Stack::named("SiO2", "Si")),
        ("TiO2/Ti", Stack::named("TiO2", "Ti")),
        ("mirror of 5 layers", mirror),
    ]
}

/// Cosine and thickness (nm), in single precision so that every method gets the same numbers.
pub type Point = [f32; 2];

/// Every point of this number has a cosine with a uniform logarithm: grazing angles, where most methods fail, would
/// hardly occur otherwise.
const GRAZING_STRIDE: usize = 5;
const LEAST_COSINE: f32 = 1e-3;

/// Random points of a range, the same for the same seed.
pub fn points(range: Range, count: usize, seed: u64) -> Vec<Point> {
    let mut rng = rng(seed);
    let [least, greatest] = range.nm.map(|nm| nm as f32);
    let point = |i: usize| {
        let u: f32 = rng.random();
        let cos_theta = if i.is_multiple_of(GRAZING_STRIDE) {
            LEAST_COSINE.powf(u)
        } else {
            LEAST_COSINE + (1.0 - LEAST_COSINE) * u
        };
        [cos_theta, rng.random_range(least..greatest)]
    };
    (0..count).map(point).collect()
}
