//! Single precision against double, over all thicknesses that are allowed; and numbers that no formula expects.

use super::axis::{ANGLE, Axis, GRAZING, Scale};
use super::map::Map;
use super::scene::{Across, Scene};
use crate::shared::peer::{Compiled, Peer};
use crate::shared::stack::Stack;

const ALL: Axis = Axis {
    name: "thickness (nm)",
    scale: Scale::Log,
    first: 1.0,
    last: 1e8,
    ticks: &[1.0, 1e4, 1e8],
};

/// Scenes to compare precisions over, two by angle and one by the cosine down to grazing.
pub fn scenes() -> Vec<Scene> {
    let scene = |name, stack, y| Scene {
        name,
        stack,
        across: Across::Thickness,
        x: ALL,
        y,
    };
    let soap = Stack::constant([[1.0, 0.0], [1.33, 0.0], [1.0, 0.0]]);
    vec![
        scene("soap: 1/1.33/1", soap.clone(), ANGLE),
        scene("soap, towards grazing", soap, GRAZING),
        scene("TiO2 on Ti", Stack::named("TiO2", "Ti"), ANGLE),
    ]
}

/// The greatest differences of a method's two instances; none for films, which have one.
pub fn map(peer: Peer, scene: &Scene, cells: usize) -> Option<Map> {
    let compiled = scene.compile(peer, scene.x.first);
    compiled.double(1.0, 1.0)?;
    let mut map = Map::blank(cells);
    for (row, y) in Scene::places(scene.y, cells).into_iter().enumerate() {
        let cos_theta = scene.cos_theta(y);
        for (column, x) in Scene::places(scene.x, cells).into_iter().enumerate() {
            let thickness_nm = scene.thickness_nm(x);
            let single = compiled.single(cos_theta, thickness_nm)?;
            let double = compiled.double(f64::from(cos_theta), f64::from(thickness_nm))?;
            let pairs = single.into_iter().zip(double);
            let errors = pairs.map(|(a, b)| (f64::from(a) - b).abs());
            let error = errors.fold(0.0, f64::max);
            map.evaluations += 2;
            map.not_finite += usize::from(!single.iter().all(|channel| channel.is_finite()));
            map.worst = map.worst.or(error, x, cos_theta);
            map.worsen(column, row, error);
        }
    }
    Some(map)
}

/// Cosines and thicknesses that no formula expects: ends, denormals, infinities, NaN.
const HARD: [f32; 14] = [
    0.0,
    -0.0,
    1e-45,
    1e-20,
    1e-9,
    1e-4,
    0.5,
    1.0,
    1.000_000_1,
    -1.0,
    1e8,
    f32::MAX,
    f32::INFINITY,
    f32::NAN,
];

/// The number of hard inputs that give a channel that is NaN or infinite.
pub fn not_finite(compiled: &Compiled) -> usize {
    let pairs = HARD.iter().flat_map(|c| HARD.iter().map(move |d| (*c, *d)));
    let bad = pairs.filter(|(cos_theta, thickness_nm)| {
        let color = compiled.single(*cos_theta, *thickness_nm);
        color.is_some_and(|color| !color.iter().all(|channel| channel.is_finite()))
    });
    bad.count()
}
