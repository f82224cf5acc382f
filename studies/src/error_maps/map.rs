//! A peer's errors over a scene.

use super::scene::{Across, POINTS_PER_SIDE, Scene, Truth};
use crate::shared::peer::{Compiled, Peer, method_of};
use crate::shared::stack::{clipped, clipped_errors};
use pellicle::num::Rgb;

/// A number, and where it was found.
#[derive(Clone, Copy, Debug, Default)]
pub struct Found {
    pub value: f64,
    /// The place across: thickness (nm), index or k.
    pub x: f64,
    pub cos_theta: f64,
}

impl Found {
    /// The greater of two.
    pub fn or(self, value: f64, x: f64, cos_theta: f32) -> Self {
        let cos_theta = f64::from(cos_theta);
        if value > self.value {
            Self {
                value,
                x,
                cos_theta,
            }
        } else {
            self
        }
    }
}

/// The errors over a scene.
#[derive(Clone, Debug)]
pub struct Map {
    /// The number of cells on either side.
    pub cells: usize,
    /// Row by row from normal incidence: the greatest error of a channel at a cell's points, both colours clipped to
    /// \[0, 1\]; none where the peer refused the stack.
    pub errors: Vec<Option<f64>>,
    /// The greatest error, and the root of the mean square over the channels of all points.
    pub worst: Found,
    pub rms: f64,
    /// The excess of a channel over 1, or over the true one if that is greater.
    pub above: Found,
    /// How far a channel lies below 0, or below the true one if that is less.
    pub below: Found,
    /// The number of colours with a channel that is NaN or infinite.
    pub not_finite: usize,
    /// The number of colours.
    pub evaluations: usize,
    /// The methods of the films that were compiled, each once.
    pub methods: Vec<String>,
    /// Why the peer refused, if it did anywhere.
    pub refusal: Option<String>,
}

impl Map {
    /// A map without errors.
    pub fn blank(cells: usize) -> Self {
        Self {
            cells,
            errors: vec![None; cells * cells],
            worst: Found::default(),
            rms: 0.0,
            above: Found::default(),
            below: Found::default(),
            not_finite: 0,
            evaluations: 0,
            methods: Vec::new(),
            refusal: None,
        }
    }

    /// Sweeps a peer, in single precision, over the points of a scene.
    pub fn new(peer: Peer, scene: &Scene, truth: &Truth) -> Self {
        Self::with_last(peer, scene, truth).0
    }

    /// The same, with the compiled peer: for the whole scene if the thickness is across, else for its last column.
    pub fn with_last(peer: Peer, scene: &Scene, truth: &Truth) -> (Self, Compiled) {
        let [width, _] = truth.size;
        let cells = width / POINTS_PER_SIDE;
        let mut map = Self::blank(cells);
        let xs = Scene::places(scene.x, cells);
        let ys = Scene::places(scene.y, cells);
        let mut squares = 0.0;
        let mut compiled = map.compile(peer, scene, xs[0]);
        for (column, x) in xs.into_iter().enumerate() {
            if column > 0 && scene.across != Across::Thickness {
                compiled = map.compile(peer, scene, x);
            }
            let thickness_nm = scene.thickness_nm(x);
            for (row, y) in ys.iter().enumerate() {
                let cos_theta = scene.cos_theta(*y);
                let truth = truth.colors[row * width + column];
                let Some(color) = compiled.beside(truth, cos_theta, thickness_nm) else {
                    continue;
                };
                let error = map.add(color, truth, x, cos_theta, &mut squares);
                map.worsen(column, row, error);
            }
        }
        map.rms = (squares / (3 * map.evaluations.max(1)) as f64).sqrt();
        (map, compiled)
    }

    /// Adds an error to the cell of a point.
    pub fn worsen(&mut self, column: usize, row: usize, error: f64) {
        let cell = &mut self.errors[row / POINTS_PER_SIDE * self.cells + column / POINTS_PER_SIDE];
        *cell = Some(cell.map_or(error, |other| other.max(error)));
    }

    /// The part of the cells with errors that are within a bound.
    pub fn share_within(&self, bound: f64) -> f64 {
        let known: Vec<f64> = self.errors.iter().flatten().copied().collect();
        let within = known.iter().filter(|error| **error <= bound).count();
        within as f64 / known.len().max(1) as f64
    }

    fn compile(&mut self, peer: Peer, scene: &Scene, x: f64) -> Compiled {
        let compiled = scene.compile(peer, x);
        match &compiled {
            Compiled::Film(film) => {
                let method = method_of(film);
                if !self.methods.contains(&method) {
                    self.methods.push(method);
                }
            }
            Compiled::Refused(why) => self.refusal = Some(why.clone()),
            _ => {}
        }
        compiled
    }

    /// Counts one colour and returns its error.
    fn add(
        &mut self,
        color: Rgb<f32>,
        truth: Rgb<f64>,
        x: f64,
        cos_theta: f32,
        squares: &mut f64,
    ) -> f64 {
        self.evaluations += 1;
        self.not_finite += usize::from(!color.iter().all(|channel| channel.is_finite()));
        let errors = clipped_errors(clipped(color), truth);
        *squares += errors.map(|error| error * error).iter().sum::<f64>();
        let greatest = errors.into_iter().fold(0.0, f64::max);
        for (found, truth) in color.map(f64::from).into_iter().zip(truth) {
            self.above = self.above.or(found - truth.max(1.0), x, cos_theta);
            self.below = self.below.or(truth.min(0.0) - found, x, cos_theta);
        }
        self.worst = self.worst.or(greatest, x, cos_theta);
        greatest
    }
}
