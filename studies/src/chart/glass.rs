//! Films with transmittance, from both sides: on glass with and without dispersion, and a wall of soap in air.

use super::contest::{PlanNote, Summary};
use super::errors::Errors;
use super::suite::{MIRROR_NM, Point, Range, points};
use super::timing;
use crate::shared::habit::Habit;
use crate::shared::peer::{Compiled, Peer, harmonics, method_of};
use crate::shared::stack::Stack;
use pellicle::film::{Film, FilmDescription, OneLayerMethod as Kind};
use pellicle::optics::Medium;
use pellicle::optics::stack::Side;
use rayon::prelude::*;
use std::time::Instant;

/// Points per stack at which errors are counted.
pub const POINTS: usize = 1000;
const SEEDS: [u64; 2] = [2019, 2023];
pub const SIDES: [Side; 2] = [Side::Ambient, Side::Base];

/// A stack, and the range of its outermost layer's thickness.
pub struct Named {
    pub name: &'static str,
    pub stack: Stack,
    pub range: Range,
}

/// Everyone. Methods for one layer take the others for nothing; renderers that have them turn the stack round for the
/// base's side and let through what is not reflected.
pub fn peers() -> Vec<Peer> {
    let mut peers = vec![Peer::Method(Kind::TwoBeam), Peer::Method(Kind::AiryRgb)];
    peers.extend([8, 16, 32].map(|n| Peer::Method(Kind::Quadrature(n))));
    peers.extend([16, 32].map(|n| Peer::Method(Kind::Bands(n))));
    peers.extend([2, 3].map(|n| Peer::Method(harmonics(n))));
    peers.extend(Habit::ALL.map(Peer::Habit));
    peers.push(Peer::Forced("series", 2e-3));
    peers.extend([1e-2, 2e-3, 2e-4].map(Peer::Planned));
    peers.push(Peer::Reference);
    peers
}

/// The stacks, those of one layer first.
pub fn stacks() -> Vec<Named> {
    let named = |name, stack, nm| Named {
        name,
        stack,
        range: Range {
            name,
            nm,
            has_mirror: true,
        },
    };
    let constant = |film: f64, base: f64| Stack::constant([[1.0, 0.0], [film, 0.0], [base, 0.0]]);
    let between = |ambient: &str, film: &str, base: &str| Stack {
        ambient: Medium::named(ambient).unwrap(),
        ..Stack::named(film, base)
    };
    let coat = |film: &str, fixed: &[(&str, f64)]| Stack {
        fixed: fixed
            .iter()
            .map(|(name, nm)| (Medium::named(name).unwrap(), *nm))
            .collect(),
        ..between("air", film, "BK7")
    };
    // A mirror for red: ten quarter waves of it.
    const RED_NM: f64 = 1.2 * MIRROR_NM;
    let quarter = |name: &'static str| {
        (
            name,
            RED_NM / (4.0 * Medium::named(name).unwrap().index(RED_NM).re),
        )
    };
    let dichroic: Vec<_> = (1..10)
        .map(|i| quarter(if i % 2 == 0 { "TiO2" } else { "SiO2" }))
        .collect();
    vec![
        named("1/1.38/1.52", constant(1.38, 1.52), [0.0, 300.0]),
        named("1/2.4/1.5", constant(2.4, 1.5), [0.0, 300.0]),
        named("soap in air", between("air", "H2O", "air"), [0.0, 1000.0]),
        named("MgF2/BK7", between("air", "MgF2", "BK7"), [0.0, 300.0]),
        named("TiO2/BK7", between("air", "TiO2", "BK7"), [0.0, 300.0]),
        named(
            "air gap in BK7",
            between("BK7", "air", "BK7"),
            [0.0, 1000.0],
        ),
        named("V coat", coat("MgF2", &[("Ta2O5", 14.0)]), [110.0, 140.0]),
        named(
            "broad-band coat",
            coat("MgF2", &[("Ta2O5", 111.0), ("Al2O3", 52.0)]),
            [76.0, 96.0],
        ),
        named(
            "dichroic of 10 layers",
            coat("TiO2", &dichroic),
            [50.0, 70.0],
        ),
    ]
}

/// Reflectance and transmittance, not clipped.
type Pair<T> = [[T; 3]; 2];

/// A peer on a stack.
enum Ready {
    Film(Box<Film>),
    /// One for each side.
    OneLayer(Box<[Compiled; 2]>),
    Reference,
}

/// One peer on one stack, for each side.
pub struct Cell {
    pub peer: Peer,
    pub stack: &'static str,
    pub layers: usize,
    pub errors: [Errors; 2],
    /// Median of the repetitions; none for what is no method.
    pub ns: [Option<f64>; 2],
    pub note: Option<PlanNote>,
    ready: Ready,
}

/// Runs everything: errors, then times.
pub fn run(stacks: &[Named]) -> Vec<Cell> {
    eprintln!("films on glass");
    let mut cells: Vec<Cell> = stacks.par_iter().flat_map_iter(cells).collect();
    for cell in &mut cells {
        let stack = stacks.iter().find(|s| s.name == cell.stack).unwrap();
        time(cell, stack);
    }
    cells
}

fn cells(named: &Named) -> Vec<Cell> {
    let points = points(named.range, POINTS, SEEDS[0]);
    let of_sides = [Some(named.stack.clone()), named.stack.turned()];
    let truths = SIDES.map(|side| truth(&named.stack, side, &points));
    let cell = |peer: Peer| {
        let start = Instant::now();
        let ready = ready(peer, named)?;
        let compile_ms = start.elapsed().as_secs_f64() * 1e3;
        let note = match &ready {
            Ready::Film(film) => Some(PlanNote {
                method: method_of(film),
                measured_max: film.plan().measured_max,
                bytes: film.plan().bytes,
                compile_ms,
            }),
            _ => None,
        };
        let errors = [0, 1].map(|side| {
            let mut errors = Errors::default();
            for (point, truth) in points.iter().zip(&truths[side]) {
                match (peer, &ready) {
                    (_, Ready::Reference) if peer == Peer::Reference => {
                        errors.add_exact();
                        errors.add_exact();
                    }
                    (Peer::Habit(habit), _) => {
                        let [c, d] = point.map(f64::from);
                        let stack = of_sides[side].as_ref();
                        let changed = stack.and_then(|stack| habit.changed(stack, c, d));
                        let found = changed.map_or(*truth, |r| [r, r.map(|r| 1.0 - r)]);
                        add(&mut errors, found.map(|rgb| rgb.map(|x| x as f32)), *truth);
                    }
                    _ => add(&mut errors, ready.at(SIDES[side], *point), *truth),
                }
            }
            errors
        });
        Some(Cell {
            peer,
            stack: named.name,
            layers: 1 + named.stack.fixed.len(),
            errors,
            ns: [None; 2],
            note,
            ready,
        })
    };
    peers().into_iter().filter_map(cell).collect()
}

fn add(errors: &mut Errors, found: Pair<f32>, truth: Pair<f64>) {
    for (found, truth) in found.into_iter().zip(truth) {
        errors.add(found, truth);
    }
}

fn truth(stack: &Stack, side: Side, points: &[Point]) -> Vec<Pair<f64>> {
    let truth = stack.truth().unwrap();
    let at = |[c, d]: &Point| truth.colors(side, (*c).into(), (*d).into());
    points.iter().map(at).collect()
}

/// None: the peer cannot do it.
fn ready(peer: Peer, named: &Named) -> Option<Ready> {
    let (stack, nm) = (&named.stack, named.range.nm);
    let film = |description: FilmDescription| {
        let description = FilmDescription {
            transmittance: true,
            ..description
        };
        Film::new(&description)
            .ok()
            .map(|film| Ready::Film(Box::new(film)))
    };
    match peer {
        Peer::Planned(tolerance) => film(stack.description(nm, tolerance)),
        Peer::Forced(method, tolerance) => film(FilmDescription {
            method: Some(method.into()),
            ..stack.description(nm, tolerance)
        }),
        Peer::Reference => Some(Ready::Reference),
        Peer::Habit(_) => stack.is_one_layer().then_some(Ready::Reference),
        _ => {
            let sides = [stack.clone(), stack.turned()?].map(|stack| peer.compile(&stack, nm));
            let is_refused = sides
                .iter()
                .any(|side| matches!(side, Compiled::Refused(_)));
            (!is_refused).then(|| Ready::OneLayer(Box::new(sides)))
        }
    }
}

impl Ready {
    fn at(&self, side: Side, [cos_theta, thickness_nm]: Point) -> Pair<f32> {
        match self {
            Self::Film(film) => {
                let found = film.colors(side, cos_theta, thickness_nm).unwrap();
                [found.reflectance, found.transmittance]
            }
            Self::OneLayer(sides) => {
                let compiled = &sides[usize::from(side == Side::Base)];
                let reflected = compiled.single(cos_theta, thickness_nm).unwrap();
                [reflected, reflected.map(|r| 1.0 - r)]
            }
            Self::Reference => unreachable!("it is asked by itself"),
        }
    }
}

fn time(cell: &mut Cell, named: &Named) {
    let points = points(named.range, timing::ALL_POINTS, SEEDS[1]);
    let truth = named.stack.truth().unwrap();
    cell.ns = SIDES.map(|side| {
        let once = |repetition: usize| match (&cell.ready, cell.peer) {
            (Ready::Reference, Peer::Reference) => timing::calls(&points, repetition, |[c, d]| {
                truth.colors(side, c.into(), d.into())
            }),
            (Ready::Film(film), _) => {
                timing::calls(&points, repetition, |[c, d]| film.colors(side, c, d))
            }
            (ready, _) => timing::calls(&points, repetition, |point| ready.at(side, point)),
        };
        let is_method = !matches!(cell.peer, Peer::Habit(_));
        is_method.then(|| timing::median((0..timing::REPETITIONS).map(once).collect()))
    });
}

/// Each peer over the cells, from one side; `of` chooses cells.
pub fn summaries(cells: &[Cell], side: usize, of: impl Fn(&Cell) -> bool) -> Vec<Summary> {
    let summary = |peer: Peer| {
        let own = cells.iter().filter(|cell| cell.peer == peer && of(cell));
        let (mut errors, mut ns, mut notes) = (Errors::default(), Vec::new(), Vec::new());
        for cell in own {
            errors.join(&cell.errors[side]);
            ns.extend(cell.ns[side]);
            notes.extend(cell.note.clone());
        }
        (errors.count() > 0).then(|| Summary {
            peer,
            errors,
            slowest_ns: ns.iter().copied().fold(f64::NAN, f64::max),
            ns: if ns.is_empty() {
                f64::NAN
            } else {
                timing::median(ns)
            },
            batch_ns: Vec::new(),
            notes,
        })
    };
    peers().into_iter().filter_map(summary).collect()
}

#[test]
fn a_turned_stack_is_the_other_side() {
    for named in stacks() {
        let Some(turned) = named.stack.turned() else {
            continue;
        };
        for c in [0.1, 0.7, 0.83] {
            let d = 0.7 * named.range.nm[1];
            let turned = turned.truth().unwrap().colors(Side::Ambient, c, d);
            let back = named.stack.truth().unwrap().colors(Side::Base, c, d);
            let pairs = turned.as_flattened().iter().zip(back.as_flattened());
            let most = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(most < 2e-5, "{}: {most:e}", named.name);
        }
    }
}
