//! The scenes that are swept: a quantity across, the angle of incidence up.

use super::axis::{ANGLE, Axis, GRAZING, Scale};
use crate::shared::peer::{Compiled, Peer};
use crate::shared::stack::Stack;
use pellicle::Error;
use pellicle::num::Rgb;
use pellicle::optics::Medium;
use rayon::prelude::*;

/// Points along each side of a cell, which has the greatest error of them.
pub const POINTS_PER_SIDE: usize = 2;

/// What changes along the horizontal axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Across {
    Thickness,
    /// Of the film; the thickness is fixed.
    FilmIndex(f64),
    /// k of the film.
    FilmExtinction(f64),
    /// k of the base.
    BaseExtinction(f64),
}

/// A stack and the axes of its map.
#[derive(Clone, Debug)]
pub struct Scene {
    pub name: &'static str,
    pub stack: Stack,
    pub across: Across,
    pub x: Axis,
    pub y: Axis,
}

/// A scene's points and what the reference finds there.
pub struct Truth {
    /// Points along each axis.
    pub size: [usize; 2],
    /// Row by row, not clipped.
    pub colors: Vec<Rgb<f64>>,
}

impl Scene {
    /// With the thickness across.
    fn over(name: &'static str, stack: Stack, x: Axis) -> Self {
        Self {
            name,
            stack,
            across: Across::Thickness,
            x,
            y: ANGLE,
        }
    }

    /// The stack at a place on the horizontal axis.
    fn stack_at(&self, x: f64) -> Stack {
        let with = |medium: &Medium, eta: Option<f64>, k: Option<f64>| {
            let index = medium.constant().unwrap();
            let [eta, k] = [eta.unwrap_or(index.re), k.unwrap_or(index.im)];
            Medium::rgb([eta; 3], [k; 3]).unwrap()
        };
        let mut stack = self.stack.clone();
        match self.across {
            Across::Thickness => {}
            Across::FilmIndex(_) => stack.film = with(&stack.film, Some(x), None),
            Across::FilmExtinction(_) => stack.film = with(&stack.film, None, Some(x)),
            Across::BaseExtinction(_) => stack.base = with(&stack.base, None, Some(x)),
        }
        stack
    }

    /// The thickness there, nm, as methods get it.
    pub fn thickness_nm(&self, x: f64) -> f32 {
        (match self.across {
            Across::Thickness => x,
            Across::FilmIndex(nm) | Across::FilmExtinction(nm) | Across::BaseExtinction(nm) => nm,
        }) as f32
    }

    /// The range of thickness that a film is compiled for at a place on the horizontal axis, nm.
    fn range_nm(&self, x: f64) -> [f64; 2] {
        match self.across {
            Across::Thickness => [self.x.first, self.x.last],
            _ => [f64::from(self.thickness_nm(x)); 2],
        }
    }

    /// The cosine at a place on the vertical axis, as methods get it.
    pub fn cos_theta(&self, y: f64) -> f32 {
        self.exact_cos_theta(y) as f32
    }

    /// The cosine there.
    pub fn exact_cos_theta(&self, y: f64) -> f64 {
        let is_angle = self.y.scale == Scale::Linear;
        if is_angle { y.to_radians().cos() } else { y }
    }

    /// A peer for the stack at a place on the horizontal axis.
    pub fn compile(&self, peer: Peer, x: f64) -> Compiled {
        peer.compile(&self.stack_at(x), self.range_nm(x))
    }

    /// A place on the map in words.
    pub fn place(&self, x: f64, cos_theta: f64) -> String {
        let across = match self.across {
            Across::Thickness if x < 10.0 => format!("{x:.2} nm"),
            Across::Thickness if x < 1e4 => format!("{x:.0} nm"),
            Across::Thickness => format!("{:.4} um", x / 1e3),
            Across::FilmIndex(_) => format!("index {x:.2}"),
            Across::FilmExtinction(_) | Across::BaseExtinction(_) => format!("k {x:.2}"),
        };
        let angle = cos_theta.acos().to_degrees();
        if cos_theta < 0.02 {
            format!("{across}, cosine {cos_theta:.1e}")
        } else {
            format!("{across}, {angle:.0} degrees")
        }
    }

    /// The positions of the points along an axis that is divided into `cells` cells.
    pub fn places(axis: Axis, cells: usize) -> Vec<f64> {
        let count = cells * POINTS_PER_SIDE;
        let at = |i: usize| axis.at((i as f64 + 0.5) / count as f64);
        (0..count).map(at).collect()
    }

    /// Asks the reference at every point of a map with `cells` cells along each axis.
    pub fn truth(&self, cells: usize) -> Result<Truth, Error> {
        let xs = Self::places(self.x, cells);
        let ys = Self::places(self.y, cells);
        let columns = xs.par_iter().map(|x| {
            let truth = self.stack_at(*x).truth()?;
            let thickness_nm = f64::from(self.thickness_nm(*x));
            let color = |y: &f64| truth.reflectance(f64::from(self.cos_theta(*y)), thickness_nm);
            Ok(ys.iter().map(color).collect::<Vec<_>>())
        });
        let columns: Vec<Vec<Rgb<f64>>> = columns.collect::<Result<_, Error>>()?;
        let rows = 0..ys.len();
        let colors = rows.flat_map(|row| columns.iter().map(move |column| column[row]));
        Ok(Truth {
            size: [xs.len(), ys.len()],
            colors: colors.collect(),
        })
    }
}

const THIN: Axis = Axis {
    name: "thickness (nm)",
    scale: Scale::Root,
    first: 0.0,
    last: 1000.0,
    ticks: &[0.0, 200.0, 1000.0],
};

const THICK: Axis = Axis {
    name: "thickness (nm)",
    scale: Scale::Log,
    first: 1e3,
    last: 1e5,
    ticks: &[1e3, 1e4, 1e5],
};

const CORNER: Axis = Axis {
    name: "thickness (nm)",
    scale: Scale::Log,
    first: 1e-2,
    last: 1e3,
    ticks: &[1e-2, 1.0, 100.0],
};

const INDEX: Axis = Axis {
    name: "index",
    scale: Scale::Linear,
    first: 1.0,
    last: 4.0,
    ticks: &[1.0, 2.0, 3.0, 4.0],
};

const EXTINCTION: Axis = Axis {
    name: "extinction k",
    scale: Scale::Log,
    first: 1e-3,
    last: 20.0,
    ticks: &[1e-3, 0.1, 10.0],
};

/// Transparent media without dispersion.
fn clear(ambient: f64, film: f64, base: f64) -> Stack {
    Stack::constant([[ambient, 0.0], [film, 0.0], [base, 0.0]])
}

/// Thickness across, angle up.
pub fn thicknesses() -> Vec<Scene> {
    let lacquer = |k: f64| Stack::constant([[1.0, 0.0], [1.5, k], [1.5, 3.0]]);
    let from_glass = |film: f64, base: f64| clear(1.5, film, base);
    vec![
        Scene::over("soap: 1/1.33/1", clear(1.0, 1.33, 1.0), THIN),
        Scene::over("MgF2 on glass: 1/1.38/1.52", clear(1.0, 1.38, 1.52), THIN),
        Scene::over("oil on water: 1/1.47/1.33", clear(1.0, 1.47, 1.33), THIN),
        Scene::over("lacquer on metal: 1/1.5/(1.5+3i)", lacquer(0.0), THIN),
        Scene::over("tinted lacquer, k 0.1, on metal", lacquer(0.1), THIN),
        Scene::over("TiO2 on Ti", Stack::named("TiO2", "Ti"), THIN),
        Scene::over("SiO2 on Si", Stack::named("SiO2", "Si"), THIN),
        Scene::over(
            "high index: 1/4/(1.4+7.5i)",
            Stack::constant([[1.0, 0.0], [4.0, 0.0], [1.4, 7.5]]),
            THIN,
        ),
        Scene::over("seen from glass: 1.5/1.38/1", from_glass(1.38, 1.0), THIN),
        Scene::over("air gap in glass: 1.5/1/1.5", from_glass(1.0, 1.5), THIN),
        Scene::over("soap, very thick", clear(1.0, 1.33, 1.0), THICK),
        Scene::over("lacquer on metal, very thick", lacquer(0.0), THICK),
    ]
}

/// Grazing angles times very thin films.
pub fn corners() -> Vec<Scene> {
    let corner = |name, stack| Scene {
        y: GRAZING,
        ..Scene::over(name, stack, CORNER)
    };
    vec![
        corner("soap: 1/1.33/1", clear(1.0, 1.33, 1.0)),
        corner("oil on water: 1/1.47/1.33", clear(1.0, 1.47, 1.33)),
        corner("lacquer on gold", gold()),
    ]
}

fn gold() -> Stack {
    Stack {
        film: Medium::rgb([1.5; 3], [0.0; 3]).unwrap(),
        ..Stack::named("SiO2", "Au")
    }
}

/// Indices and extinctions across, angle up.
pub fn indices() -> Vec<Scene> {
    let across = |name, stack, across, x| Scene {
        across,
        ..Scene::over(name, stack, x)
    };
    let metal = Stack::constant([[1.0, 0.0], [1.5, 0.0], [1.5, 3.0]]);
    vec![
        across(
            "index of 400 nm on glass, 1.5",
            clear(1.0, 1.5, 1.5),
            Across::FilmIndex(400.0),
            INDEX,
        ),
        across(
            "index of 400 nm on metal, 1.5+3i",
            metal.clone(),
            Across::FilmIndex(400.0),
            INDEX,
        ),
        across(
            "k of 400 nm, 1.5+ki on glass, 1.33",
            clear(1.0, 1.5, 1.33),
            Across::FilmExtinction(400.0),
            EXTINCTION,
        ),
        across(
            "k of the base, 1.5+ki, under 400 nm, 1.5",
            metal,
            Across::BaseExtinction(400.0),
            EXTINCTION,
        ),
    ]
}
