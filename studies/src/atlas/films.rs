//! Every interference method over every scene.

use super::CELLS;
use super::picture::{Cells, Picture, Row};
use crate::error_maps::map::{Found, Map};
use crate::error_maps::scene::{self, Across, Scene, Truth};
use crate::error_maps::{jump, precision};
use crate::shared::habit::Habit;
use crate::shared::peer::{FORCED, Peer, harmonics};
use pellicle::Error;
use pellicle::film::OneLayerMethod as Kind;
use rayon::prelude::*;

/// The tolerance of methods that are asked for by name: the default.
pub const TOLERANCE: f64 = 2e-3;

/// Everyone, from the paper's model to ours. The first are the columns of the pictures.
pub const PEERS: [Peer; 16] = [
    Peer::Layered,
    Peer::Method(Kind::TwoBeam),
    Peer::Method(Kind::AiryRgb),
    Peer::Method(harmonics(2)),
    Peer::Method(harmonics(3)),
    Peer::Method(Kind::Quadrature(16)),
    Peer::Method(Kind::Bands(32)),
    Peer::Forced("series", 2e-3),
    Peer::Planned(2e-3),
    Peer::Planned(2e-4),
    Peer::Method(Kind::Quadrature(64)),
    Peer::Method(harmonics(16)),
    Peer::Method(Kind::Bands(256)),
    Peer::Planned(1e-2),
    Peer::Habit(Habit::MirrorAtTotalReflection),
    Peer::Habit(Habit::FadeBelow1Nm),
];
const DRAWN: usize = 10;

/// A scene, and each peer on it.
pub struct Swept {
    pub scene: Scene,
    pub maps: Vec<Map>,
    /// Discontinuities: where the thickness is across, of peers that are quick enough to look for them.
    pub jumps: Vec<Option<Found>>,
    /// The number of inputs that no formula expects which give NaN or infinity.
    pub not_finite: Vec<usize>,
}

/// A scene of single against double precision: of the peers that have both.
pub struct Precision {
    pub scene: Scene,
    pub maps: Vec<Option<Map>>,
}

/// A method asked for by name.
pub struct Forced {
    pub method: &'static str,
    /// The number of scenes of [`Films::thicknesses`] for which it was refused.
    pub refused: usize,
    /// The greatest error where it was not.
    pub worst: f64,
}

/// Everything about films.
pub struct Films {
    pub thicknesses: Vec<Swept>,
    pub corners: Vec<Swept>,
    pub indices: Vec<Swept>,
    pub precisions: Vec<Precision>,
    pub forced: Vec<Forced>,
}

/// The greatest of some numbers, and its scene.
pub type Worst<'a> = Option<(Found, &'a Scene)>;

impl Films {
    /// All maps against the reference.
    pub fn all(&self) -> impl Iterator<Item = &Swept> {
        self.thicknesses
            .iter()
            .chain(&self.corners)
            .chain(&self.indices)
    }

    /// The greatest of something over all maps of a peer.
    pub fn worst(&self, peer: usize, what: impl Fn(&Map) -> Found) -> Worst<'_> {
        let swept = self.all().filter(|swept| swept.maps[peer].evaluations > 0);
        greatest(swept.map(|swept| (what(&swept.maps[peer]), &swept.scene)))
    }

    /// The greatest jump of a peer.
    pub fn worst_jump(&self, peer: usize) -> Worst<'_> {
        greatest(
            self.all()
                .filter_map(|swept| Some((swept.jumps[peer]?, &swept.scene))),
        )
    }

    /// The greatest difference of precisions of a peer.
    pub fn worst_precision(&self, peer: usize) -> Worst<'_> {
        let precisions = self.precisions.iter();
        greatest(precisions.filter_map(|p| Some((p.maps[peer].as_ref()?.worst, &p.scene))))
    }

    /// File names and pictures.
    pub fn pictures(&self) -> Vec<(&'static str, Picture)> {
        let truth =
            "Greatest error of a channel of linear RGB in [0, 1] against converged wave optics.";
        let order = "Left to right: the paper's model and its two beams, three wavelengths, Belcour and Barla's \
                     harmonics, then ours. Words in a map: what the plan chose.";
        let against_truth = |title, swept: &[Swept]| Picture {
            title,
            explanation: [truth, order],
            headings: PEERS[..DRAWN].iter().map(|peer| peer.title()).collect(),
            rows: swept.iter().map(row).collect(),
        };
        vec![
            (
                "atlas-thickness.svg",
                against_truth(
                    "Interference methods: error over thickness and angle",
                    &self.thicknesses,
                ),
            ),
            (
                "atlas-grazing.svg",
                against_truth(
                    "Very thin films at grazing angles, both by their logarithm",
                    &self.corners,
                ),
            ),
            (
                "atlas-index.svg",
                against_truth(
                    "Interference methods: error over index, extinction and angle",
                    &self.indices,
                ),
            ),
            ("atlas-float32.svg", self.precision_picture()),
        ]
    }

    fn precision_picture(&self) -> Picture {
        let has_two = |peer: &usize| self.precisions[0].maps[*peer].is_some();
        let peers: Vec<usize> = (0..DRAWN).filter(has_two).collect();
        let row = |precision: &Precision| Row {
            name: precision.scene.name.into(),
            y: precision.scene.y,
            panels: peers
                .iter()
                .map(|peer| Cells::new(precision.scene.x, precision.maps[*peer].as_ref().unwrap()))
                .collect(),
        };
        Picture {
            title: "Interference methods: float32 against float64",
            explanation: [
                "Greatest difference of a channel between the two instances of one formula, up to a film of ten \
                 centimetres.",
                "A phase of thousands of turns has few digits left: methods that integrate over it do not need \
                 them, methods that sample it are wrong.",
            ],
            headings: peers.iter().map(|peer| PEERS[*peer].title()).collect(),
            rows: self.precisions.iter().map(row).collect(),
        }
    }
}

fn greatest<'a>(found: impl Iterator<Item = (Found, &'a Scene)>) -> Worst<'a> {
    found.max_by(|a, b| a.0.value.total_cmp(&b.0.value))
}

fn row(swept: &Swept) -> Row {
    let panel = |(map, peer): (&Map, &Peer)| {
        let mut cells = Cells::new(swept.scene.x, map);
        if matches!(peer, Peer::Planned(_)) {
            cells.note = map.methods.join(", ");
        }
        cells
    };
    Row {
        name: swept.scene.name.into(),
        y: swept.scene.y,
        panels: swept.maps.iter().zip(&PEERS[..DRAWN]).map(panel).collect(),
    }
}

/// Sweeps everything.
pub fn sweep() -> Result<Films, Error> {
    let (thicknesses, truths) = over_all(scene::thicknesses())?;
    Ok(Films {
        corners: over_all(scene::corners())?.0,
        indices: over_all(scene::indices())?.0,
        precisions: precision::scenes().into_iter().map(precision).collect(),
        forced: FORCED
            .map(|method| forced(method, &thicknesses, &truths))
            .into(),
        thicknesses,
    })
}

fn over_all(scenes: Vec<Scene>) -> Result<(Vec<Swept>, Vec<Truth>), Error> {
    let over = |scene: Scene| {
        eprintln!("        {}", scene.name);
        let truth = scene.truth(CELLS)?;
        Ok((over(scene, &truth)?, truth))
    };
    let swept = scenes
        .into_iter()
        .map(over)
        .collect::<Result<Vec<_>, Error>>()?;
    Ok(swept.into_iter().unzip())
}

fn over(scene: Scene, truth: &Truth) -> Result<Swept, Error> {
    let reference = scene.stack.truth()?;
    let is_film = scene.across == Across::Thickness;
    let found = PEERS.par_iter().enumerate().map(|(i, peer)| {
        if !is_film && i >= DRAWN {
            // Compiled anew in every column, they would take longer than everything else.
            return (Map::blank(CELLS), None, 0);
        }
        let (map, compiled) = Map::with_last(*peer, &scene, truth);
        let is_slow = |method: &String| ["series", "reference"].contains(&method.as_str());
        let is_habit = matches!(peer, Peer::Habit(_));
        let is_quick =
            is_film && !is_habit && map.evaluations > 0 && !map.methods.iter().any(is_slow);
        let jump = is_quick.then(|| jump::greatest_jump(&compiled, &scene, &reference));
        (map, jump, precision::not_finite(&compiled))
    });
    let mut swept = Swept {
        scene: scene.clone(),
        maps: Vec::new(),
        jumps: Vec::new(),
        not_finite: Vec::new(),
    };
    for (map, jump, bad) in found.collect::<Vec<_>>() {
        swept.maps.push(map);
        swept.jumps.push(jump);
        swept.not_finite.push(bad);
    }
    Ok(swept)
}

fn precision(scene: Scene) -> Precision {
    let maps = PEERS
        .par_iter()
        .map(|peer| precision::map(*peer, &scene, CELLS));
    let maps = maps.collect();
    Precision { scene, maps }
}

fn forced(method: &'static str, swept: &[Swept], truths: &[Truth]) -> Forced {
    let worst = swept.par_iter().zip(truths).map(|(swept, truth)| {
        let map = Map::new(Peer::Forced(method, TOLERANCE), &swept.scene, truth);
        map.refusal.is_none().then_some(map.worst.value)
    });
    let worst: Vec<Option<f64>> = worst.collect();
    Forced {
        method,
        refused: worst.iter().filter(|worst| worst.is_none()).count(),
        worst: worst.into_iter().flatten().fold(0.0, f64::max),
    }
}
