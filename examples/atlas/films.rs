//! Every interference method over every scene.

use crate::atlas::contender::{Contender, FORCED};
use crate::atlas::map::{Found, Map};
use crate::atlas::scene::{Across, Scene, Truth};
use crate::atlas::{jump, parallel, precision, scene};
use pellicle::Error;

/// Cells on either side of a map.
pub const CELLS: usize = 28;
/// What methods asked for by name must hold; the default.
pub const TOLERANCE: f64 = 2e-3;

/// A scene, and what each contender does on it, in the order of [`contenders`].
pub struct Swept {
    pub scene: Scene,
    pub maps: Vec<Map>,
    /// Discontinuities: where the thickness is across, of what is quick enough to look for them.
    pub jumps: Vec<Option<Found>>,
    /// Colours with NaN or infinity from inputs that no formula expects.
    pub not_finite: Vec<usize>,
}

/// One scene of single against double precision.
pub struct Precision {
    pub scene: Scene,
    /// None of those that have one precision.
    pub maps: Vec<Option<Map>>,
}

/// A method asked for by name.
pub struct Forced {
    pub method: &'static str,
    /// Of the scenes of [`Films::thicknesses`], how many it was refused for.
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
    /// Colours asked for, the reference's apart.
    pub evaluations: usize,
    /// The reference's.
    pub references: usize,
}

/// All, those of the pictures first.
pub fn contenders() -> Vec<Contender> {
    Contender::DRAWN
        .into_iter()
        .chain(Contender::FURTHER)
        .collect()
}

impl Films {
    /// All maps against the reference.
    pub fn all(&self) -> impl Iterator<Item = &Swept> {
        self.thicknesses
            .iter()
            .chain(&self.corners)
            .chain(&self.indices)
    }
}

/// Sweeps everything.
pub fn sweep() -> Result<Films, Error> {
    let mut films = Films {
        thicknesses: Vec::new(),
        corners: Vec::new(),
        indices: Vec::new(),
        precisions: precisions(),
        forced: Vec::new(),
        evaluations: 0,
        references: 0,
    };
    let mut truths = Vec::new();
    let mut group = |scenes: Vec<Scene>, films: &mut Films, keep: bool| {
        let mut swept = Vec::new();
        for scene in scenes {
            eprintln!("        {}", scene.name);
            let truth = scene.truth(CELLS)?;
            films.references += truth.colors.len();
            swept.push(over(scene, &truth, &mut films.evaluations)?);
            if keep {
                truths.push(truth);
            }
        }
        Ok::<_, Error>(swept)
    };
    films.thicknesses = group(scene::thicknesses(), &mut films, true)?;
    films.corners = group(scene::corners(), &mut films, false)?;
    films.indices = group(scene::indices(), &mut films, false)?;
    eprintln!("        methods asked for by name");
    films.forced = forced(&films.thicknesses, &truths);
    let maps = films
        .precisions
        .iter()
        .flat_map(|p| p.maps.iter().flatten());
    films.evaluations += maps.map(|map| map.evaluations).sum::<usize>();
    Ok(films)
}

fn over(scene: Scene, truth: &Truth, evaluations: &mut usize) -> Result<Swept, Error> {
    let reference = scene.stack.reference()?;
    let is_film = scene.across == Across::Thickness;
    let found = parallel::map(&contenders(), |contender| {
        if !is_film && Contender::FURTHER.contains(contender) {
            // Compiled anew in every column, they would take longer than all the rest.
            return (Map::blank(CELLS), None, 0, 0);
        }
        let (map, compiled) = Map::with_last(*contender, &scene, truth);
        let (bad, mut count) = precision::not_finite(&compiled);
        let is_slow = |method: &String| ["series", "reference"].contains(&method.as_str());
        let mut jump = None;
        if is_film && map.evaluations > 0 && !map.methods.iter().any(is_slow) {
            let (found, more) = jump::greatest_jump(&compiled, &scene, &reference);
            jump = Some(found);
            count += more;
        }
        (map, jump, bad, count)
    });
    let mut swept = Swept {
        scene,
        maps: Vec::new(),
        jumps: Vec::new(),
        not_finite: Vec::new(),
    };
    for (map, jump, bad, count) in found {
        *evaluations += map.evaluations + count;
        swept.maps.push(map);
        swept.jumps.push(jump);
        swept.not_finite.push(bad);
    }
    Ok(swept)
}

fn precisions() -> Vec<Precision> {
    let over = |scene: Scene| {
        let map = |contender: &Contender| precision::map(*contender, &scene, CELLS);
        let maps = parallel::map(&contenders(), map);
        Precision { scene, maps }
    };
    precision::scenes().into_iter().map(over).collect()
}

fn forced(swept: &[Swept], truths: &[Truth]) -> Vec<Forced> {
    let jobs: Vec<(&str, usize)> = FORCED
        .iter()
        .flat_map(|method| (0..swept.len()).map(move |i| (*method, i)))
        .collect();
    let worst = parallel::map(&jobs, |(method, i)| {
        let map = Map::new(
            Contender::Forced(method, TOLERANCE),
            &swept[*i].scene,
            &truths[*i],
        );
        map.refusal.is_none().then_some(map.worst.value)
    });
    let of = |method: &'static str| {
        let own = || {
            jobs.iter()
                .zip(&worst)
                .filter(move |(job, _)| job.0 == method)
        };
        Forced {
            method,
            refused: own().filter(|(_, worst)| worst.is_none()).count(),
            worst: own().filter_map(|(_, worst)| *worst).fold(0.0, f64::max),
        }
    };
    FORCED.map(of).into()
}
