//! The films that are timed.

use crate::film_tolerance::draw;
use crate::film_tolerance::kind::{self, Kind};
use pellicle::film::FilmDescription;
use pellicle::optics::Medium;

/// Films of one kind.
pub struct Suite {
    pub name: &'static str,
    /// Name and description.
    pub films: Vec<(String, FilmDescription)>,
    /// How many may have calls slower than [`SLOW_NS`](super::report::SLOW_NS).
    pub may_be_slow: usize,
}

const RANDOM: usize = 40;
/// Real coatings: base, and layers with their thickness, nm; from the ambient's side, which is air.
const COATINGS: [(&str, &[Coating]); 10] = [
    ("BK7", &[("MgF2", [99.6; 2])]),
    ("SiO2", &[("MgF2", [99.6; 2])]),
    ("PMMA", &[("SiO2", [95.0; 2])]),
    ("BK7", &[("MgF2", [99.6; 2]), ("Al2O3", [78.0; 2])]),
    (
        "BK7",
        &[
            ("MgF2", [92.0; 2]),
            ("TiO2", [118.0; 2]),
            ("Al2O3", [80.0; 2]),
        ],
    ),
    (
        "BK7",
        &[
            ("SiO2", [93.0; 2]),
            ("TiO2", [112.0; 2]),
            ("SiO2", [35.0; 2]),
            ("TiO2", [12.0; 2]),
        ],
    ),
    (
        "BK7",
        &[
            ("TiO2", [57.0; 2]),
            ("SiO2", [94.0; 2]),
            ("TiO2", [57.0; 2]),
            ("SiO2", [94.0; 2]),
            ("TiO2", [57.0; 2]),
        ],
    ),
    ("BK7", &[("SiO2", [0.0, 400.0])]),
    ("SiO2", &[("TiO2", [0.0, 300.0])]),
    ("BK7", &[("Ag", [0.0, 60.0])]),
];

type Coating = (&'static str, [f64; 2]);

/// Random stacks: of reflectance alone, and with transmittance.
pub fn random_suites() -> [Suite; 3] {
    [
        Suite {
            name: "random stacks, R only",
            films: random(false),
            may_be_slow: 0,
        },
        Suite {
            name: "random stacks with T, constant transparent base",
            films: random(true),
            // A stack with gaps of vacuum, whose resonances no series follows.
            may_be_slow: 1,
        },
        Suite {
            name: "random stacks with T, dispersing half-spaces",
            films: dispersing(),
            // Layers of 0.7 to 2.8 um on ZnS, on MgF2 and on a base given by three numbers: no table holds the tolerance.
            may_be_slow: 3,
        },
    ]
}

/// All suites.
pub fn suites() -> Vec<Suite> {
    let mut suites = Vec::from(random_suites());
    suites.extend([
        Suite {
            name: "real coatings on real glass, with T",
            films: coatings(),
            may_be_slow: 0,
        },
        Suite {
            name: "single films",
            films: single(),
            may_be_slow: 0,
        },
    ]);
    suites
}

fn random(both_sides: bool) -> Vec<(String, FilmDescription)> {
    let stacks = (0..).map(|number| draw::general(7, number));
    let wanted = stacks.filter(|stack| {
        let base = stack.base.medium();
        !both_sides || base.constant().is_some_and(|index| index.im == 0.0)
    });
    let films = wanted.take(RANDOM).map(|mut stack| {
        stack.both_sides = both_sides;
        (stack.to_string(), stack.description(2e-3))
    });
    films.collect()
}

fn dispersing() -> Vec<(String, FilmDescription)> {
    let numbers = (0..).filter(|number| Kind::of(*number) == Kind::Dispersing);
    let films = numbers.take(RANDOM).map(|number| {
        let stack = kind::stack(7, number);
        (stack.to_string(), stack.description(2e-3))
    });
    films.collect()
}

fn medium(name: &str) -> Medium {
    Medium::named(name).expect("a named medium")
}

fn film(ambient: &str, layers: &[Coating], base: &str) -> (String, FilmDescription) {
    let mut description = FilmDescription::new(medium(base));
    description.ambient = medium(ambient);
    description.transmittance = true;
    for (name, thickness_nm) in layers {
        description = description.layer(medium(name), *thickness_nm);
    }
    (format!("{ambient} / {layers:?} / {base}"), description)
}

fn coatings() -> Vec<(String, FilmDescription)> {
    COATINGS
        .iter()
        .map(|(base, layers)| film("vacuum", layers, base))
        .collect()
}

fn single() -> Vec<(String, FilmDescription)> {
    vec![
        film("vacuum", &[], "BK7"),
        film("vacuum", &[("H2O", [100.0, 900.0])], "vacuum"),
        film("air", &[("H2O", [100.0, 900.0])], "air"),
        film("vacuum", &[("MgF2", [0.0, 140.0])], "BK7"),
        film("vacuum", &[("MgF2", [0.0, 300.0])], "BK7"),
        film("BK7", &[("MgF2", [0.0, 300.0])], "vacuum"),
        film("BK7", &[("air", [0.0, 3000.0])], "BK7"),
        film("H2O", &[("TiO2", [0.0, 300.0])], "BK7"),
    ]
}
