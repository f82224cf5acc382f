//! A table in patches: where colours change within narrow regions, the patches are small.

use super::errors::Errors;
use super::spline::{control_points, look_up, reserve};
use super::task::FitLimits;
use crate::error::Error;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
use crate::num::spline::FARTHEST;
use crate::num::{Lane, Rgb, TableEntry};

/// The values of a patch along each coordinate.
const VALUES: usize = 9;
const ROW: usize = VALUES + 2;
/// The part of the tolerance that the error found may have.
const FOUND: f64 = 0.5;
/// A patch is not divided further than this, as a part of the whole.
const LEAST_EXTENT: f64 = 1e-5;
/// A saved node that is no halving along an axis.
const LEAF: u8 = 2;

/// Colours over the unit square. A tree of halvings leads to the patch of a point, each a spline through 9 x 9 values.
#[derive(Clone, Debug)]
pub(super) struct Patches {
    nodes: Vec<Node>,
    patches: Vec<Patch>,
    /// [`ROW`] rows of as many control points for each patch.
    points: Vec<TableEntry<f32>>,
}

/// A node of the tree.
#[derive(Clone, Copy, Debug)]
enum Node {
    /// The square is halved at a coordinate, x (0) or y (1): the lower half is the next node, the upper one is `upper`.
    Halved {
        axis: usize,
        at: f64,
        upper: usize,
    },
    Leaf(usize),
}

/// Where a patch begins, and its values per unit of the coordinates.
#[derive(Clone, Copy, Debug)]
struct Patch {
    from: [f64; 2],
    steps: [f64; 2],
}

impl Patch {
    fn between(from: [f64; 2], to: [f64; 2]) -> Self {
        let steps = [0, 1].map(|axis| (VALUES - 1) as f64 / (to[axis] - from[axis]));
        Self { from, steps }
    }
}

/// Where a rectangle is halved along an axis, the greatest corner of its lower half and the least one of its upper half.
fn halves(from: [f64; 2], to: [f64; 2], axis: usize) -> (f64, [[f64; 2]; 2]) {
    let middle = 0.5 * (from[axis] + to[axis]);
    let (mut lower, mut upper) = (to, from);
    (lower[axis], upper[axis]) = (middle, middle);
    (middle, [lower, upper])
}

/// The colours at a point of the unit square, whether they are ever looked up there, and whether they have a tolerance
/// there. What is seen may be a sliver of a patch in which no point is measured, so that errors count wherever there is
/// a tolerance.
pub(super) struct PatchSource<'a> {
    pub color: &'a mut dyn FnMut(f64, f64) -> Rgb<f64>,
    pub is_seen: &'a dyn Fn(f64, f64) -> bool,
    pub has_tolerance: &'a dyn Fn(f64, f64) -> bool,
}

impl Patches {
    /// Fits patches to a source; `None` if the limits cannot be met.
    pub fn fit(
        source: PatchSource<'_>,
        limits: FitLimits,
    ) -> Result<Option<(Self, Errors)>, Error> {
        let mut fit = PatchFit {
            source,
            limits,
            errors: Errors::default(),
            patches: Self {
                nodes: Vec::new(),
                patches: Vec::new(),
                points: Vec::new(),
            },
        };
        let fits = fit.divide([0.0; 2], [1.0; 2])?;
        Ok(fits.then_some((fit.patches, fit.errors)))
    }

    /// The colours at a point of the unit square.
    #[inline(always)]
    pub fn at(&self, point: [f64; 2]) -> Rgb<f32> {
        let mut node = 0;
        let patch = loop {
            match self.nodes[node] {
                Node::Halved { axis, at, upper } => {
                    node = if point[axis] < at { node + 1 } else { upper };
                }
                Node::Leaf(patch) => break patch,
            }
        };
        let Patch { from, steps } = self.patches[patch];
        let [x, y] = [0, 1].map(|axis| {
            let position = (point[axis] - from[axis]) * steps[axis];
            position.clamp(0.0, (VALUES - 1) as f64) as f32
        });
        let points = &self.points[patch * ROW * ROW..][..ROW * ROW];
        f32::channels(look_up::<f32>(points, ROW, f32::rgb([x, y, y])))
    }

    /// Writes the halvings, from which nodes and patches follow, and the control points.
    pub fn save(&self, block: &mut ByteWriter) {
        let Self {
            nodes,
            patches: _,
            points,
        } = self;
        for node in nodes {
            block.byte(match node {
                Node::Halved { axis, .. } => *axis as u8,
                Node::Leaf(_) => LEAF,
            });
        }
        block.colors(points);
    }

    pub fn load(block: &mut ByteReader<'_>) -> Result<Self, Error> {
        let mut loaded = Self {
            nodes: Vec::new(),
            patches: Vec::new(),
            points: Vec::new(),
        };
        loaded.load_nodes(block, [0.0; 2], [1.0; 2])?;
        loaded.points = block.colors(loaded.patches.len() * ROW * ROW)?;
        Ok(loaded)
    }

    /// Reads the nodes of a rectangle. Rectangles are halved no further than when patches are fitted, which bounds
    /// the depth.
    fn load_nodes(
        &mut self,
        block: &mut ByteReader<'_>,
        from: [f64; 2],
        to: [f64; 2],
    ) -> Result<(), Error> {
        let node = self.nodes.len();
        Error::reserve_more(&mut self.nodes, 1, "a film's table")?;
        let axis = block.choice(&[0, 1, LEAF])?;
        if axis == LEAF {
            self.nodes.push(Node::Leaf(self.patches.len()));
            Error::reserve_more(&mut self.patches, 1, "a film's table")?;
            self.patches.push(Patch::between(from, to));
            return Ok(());
        }
        let axis = usize::from(axis);
        if to[axis] - from[axis] < LEAST_EXTENT {
            return Err(unusable("a patch is too small"));
        }
        self.nodes.push(Node::Leaf(0));
        let (middle, [lower, upper]) = halves(from, to, axis);
        self.load_nodes(block, from, lower)?;
        self.nodes[node] = Node::Halved {
            axis,
            at: middle,
            upper: self.nodes.len(),
        };
        self.load_nodes(block, upper, to)
    }

    /// The number of values.
    pub fn len(&self) -> usize {
        self.patches.len() * VALUES * VALUES
    }

    /// Bytes of the tree and the control points.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.patches) + size_of_val(&*self.points)
    }
}

/// The state of a fit.
struct PatchFit<'a> {
    source: PatchSource<'a>,
    limits: FitLimits,
    errors: Errors,
    patches: Patches,
}

impl PatchFit<'_> {
    /// Fits one patch to a rectangle, or halves it. Returns whether the limits are met.
    fn divide(&mut self, from: [f64; 2], to: [f64; 2]) -> Result<bool, Error> {
        if (self.patches.patches.len() + 1) * ROW * ROW > self.limits.size {
            return Ok(false);
        }
        let extent = [to[0] - from[0], to[1] - from[1]];
        let patch = Patch::between(from, to);
        let at = |i: f64, j: f64| {
            let part = [i, j].map(|i| i / (VALUES - 1) as f64);
            [0, 1].map(|axis| from[axis] + part[axis] * extent[axis])
        };
        let mut values = reserve(VALUES * VALUES)?;
        values.resize(VALUES * VALUES, [0.0; 3]);
        // What is seen ends at a greatest y, which grows with x.
        let [x, y] = at((VALUES - 1) as f64, 0.0);
        let is_seen = (self.source.is_seen)(x, y);
        if is_seen {
            for i in 0..VALUES {
                for j in 0..VALUES {
                    let [x, y] = at(i as f64, j as f64);
                    values[j * VALUES + i] = (self.source.color)(x, y);
                }
            }
        }
        let points = control_points(&values, VALUES)?;
        let (errors, worst) = if is_seen {
            self.measured(&points, at)
        } else {
            Default::default()
        };
        let allowed = FOUND * self.limits.tolerance;
        if !is_seen || errors.max <= allowed {
            self.errors.merge(&errors);
            self.patches
                .nodes
                .push(Node::Leaf(self.patches.patches.len()));
            self.patches.patches.push(patch);
            Error::reserve_more(&mut self.patches.points, points.len(), "a film's table")?;
            self.patches.points.extend(points);
            return Ok(true);
        }
        if extent.iter().all(|x| *x < LEAST_EXTENT) {
            return Ok(false);
        }
        let axis = self.worse_axis(&points, at, worst, extent);
        let node = self.patches.nodes.len();
        self.patches.nodes.push(Node::Leaf(0));
        let (middle, [lower, upper]) = halves(from, to, axis);
        if !self.divide(from, lower)? {
            return Ok(false);
        }
        self.patches.nodes[node] = Node::Halved {
            axis,
            at: middle,
            upper: self.patches.nodes.len(),
        };
        self.divide(upper, to)
    }

    /// The errors between the values of a patch, and the worst point.
    fn measured(
        &mut self,
        points: &[TableEntry<f32>],
        at: impl Fn(f64, f64) -> [f64; 2],
    ) -> (Errors, [f64; 2]) {
        let mut errors = Errors::default();
        let (mut worst, mut greatest) = ([0.0; 2], -1.0);
        for i in 0..VALUES - 1 {
            // The two points of an interval at which the error is greatest take turns.
            let side = |i: usize| {
                let part = if i.is_multiple_of(2) {
                    FARTHEST
                } else {
                    1.0 - FARTHEST
                };
                i as f64 + part
            };
            for j in 0..VALUES - 1 {
                let place = [side(i), side(j)];
                if let Some(error) = self.error(points, &at, place, &mut errors)
                    && error > greatest
                {
                    (greatest, worst) = (error, place);
                }
            }
        }
        (errors, worst)
    }

    fn error(
        &mut self,
        points: &[TableEntry<f32>],
        at: impl Fn(f64, f64) -> [f64; 2],
        [i, j]: [f64; 2],
        errors: &mut Errors,
    ) -> Option<f64> {
        let [x, y] = at(i, j);
        if !(self.source.has_tolerance)(x, y) {
            return None;
        }
        let truth = (self.source.color)(x, y);
        let [i, j] = [i, j].map(|i| i as f32);
        let found = f32::channels(look_up::<f32>(points, ROW, f32::rgb([i, j, j])));
        Some(errors.add(found.map(f64::from), truth, self.limits.unclipped))
    }

    /// The axis along which the error at the worst point is greater; never one that has been divided enough.
    fn worse_axis(
        &mut self,
        points: &[TableEntry<f32>],
        at: impl Fn(f64, f64) -> [f64; 2],
        [i, j]: [f64; 2],
        extent: [f64; 2],
    ) -> usize {
        let mut aside = Errors::default();
        let across = self.error(points, &at, [i, j.round()], &mut aside);
        let along = self.error(points, &at, [i.round(), j], &mut aside);
        match (extent[0] < LEAST_EXTENT, extent[1] < LEAST_EXTENT) {
            (true, _) => 1,
            (_, true) => 0,
            _ => usize::from(along > across),
        }
    }
}
