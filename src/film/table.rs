//! Compiled tables: a quadratic spline in one or two coordinates.

use super::axes::{Axes, Coordinates};
use crate::error::Error;
use crate::num::spline::{controls, weights};
use crate::num::{Lane, Rgb, TableBlock, TableEntry, load_block, weighted};

/// Three channels in one register.
pub(super) type Lanes = <f32 as Lane>::Rgb;

/// A control point.
type Control = TableEntry<f32>;

/// Adding it rounds a number in [0, 2^22] to a whole one, which is then in the lowest bits.
const WHOLE: f32 = 8_388_608.0;

/// Colours over the cosine alone: a film of fixed thickness, or none.
///
/// Cost: one division, 3 control points.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    coordinates: Coordinates,
    points: Box<[Control]>,
}

/// Colours over cosine and thickness.
///
/// Cost: two divisions, side by side, and 9 control points.
#[derive(Clone, Debug)]
pub(super) struct Table {
    coordinates: Coordinates,
    /// Rows of equal y, two longer than the values were.
    points: Box<[Control]>,
    row: usize,
}

impl Curve {
    /// Through values at equal steps of the first coordinate, at least
    /// [`LEAST_VALUES`](crate::num::spline::LEAST_VALUES).
    pub(super) fn new(axes: &Axes, values: &[Rgb<f64>]) -> Result<Self, Error> {
        let mut fitted = reserve(values.len() + 2)?;
        controls(values, &mut fitted);
        let mut points = reserve(fitted.len())?;
        points.extend(fitted.into_iter().map(packed));
        Ok(Self {
            coordinates: axes.coordinates([values.len() - 1, 0]),
            points: points.into(),
        })
    }

    /// At a cosine in [0, 1].
    #[inline(always)]
    pub(super) fn at(&self, cos_theta: f32) -> Lanes {
        let [position, ..] = f32::channels(self.coordinates.at(cos_theta, 0.0));
        let whole = position + WHOLE;
        let index = (whole.to_bits() & 0x007f_ffff) as usize;
        let [points, ..] = load_block(&self.points, index, 0);
        let w = weights(f32::gray(position - (whole - WHOLE)));
        weighted(points, w)
    }

    /// [`Curve::at`] of as many as there are.
    #[inline(always)]
    pub(super) fn lanes<L: Lane<Scalar = f32>>(&self, cos_theta: L) -> L::Rgb {
        self.around(self.position(cos_theta))
    }

    /// Steps along the cosine, and 0.
    #[inline(always)]
    pub(super) fn position<L: Lane<Scalar = f32>>(&self, cos_theta: L) -> [L; 2] {
        let [position, _] = self.coordinates.lanes(cos_theta, L::new(0.0));
        [position, L::new(0.0)]
    }

    /// The colours at what [`Curve::position`] found.
    #[inline(always)]
    pub(super) fn around<L: Lane<Scalar = f32>>(&self, [position, _]: [L; 2]) -> L::Rgb {
        let first = position.round();
        L::weighted_row(&self.points, first, weights(position - first))
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.points)
    }

    /// How many values it goes through.
    pub(super) fn count(&self) -> usize {
        self.points.len() - 2
    }
}

impl Table {
    /// Through values at equal steps of both coordinates, rows of equal y, `width` to a row; at least
    /// [`LEAST_VALUES`](crate::num::spline::LEAST_VALUES) either way.
    pub(super) fn new(axes: &Axes, values: &[Rgb<f64>], width: usize) -> Result<Self, Error> {
        let height = values.len() / width;
        let row = width + 2;
        // Control points of each row first, then of each column of those.
        let mut along_x = reserve(row * height)?;
        let mut fitted = Vec::new();
        for values in values.chunks(width) {
            controls(values, &mut fitted);
            along_x.extend_from_slice(&fitted);
        }
        let mut points = reserve(row * (height + 2))?;
        points.resize(row * (height + 2), Control::default());
        let mut column = Vec::new();
        for i in 0..row {
            column.clear();
            column.extend((0..height).map(|j| along_x[j * row + i]));
            controls(&column, &mut fitted);
            for (j, point) in fitted.iter().enumerate() {
                points[j * row + i] = packed(*point);
            }
        }
        Ok(Self {
            coordinates: axes.coordinates([width - 1, height - 1]),
            points: points.into(),
            row,
        })
    }

    /// At a cosine in [0, 1] and a thickness within the range.
    #[inline(always)]
    pub(super) fn at(&self, cos_theta: f32, thickness_nm: f32) -> Lanes {
        let position = self.coordinates.at(cos_theta, thickness_nm);
        let offset = f32::gray(WHOLE);
        let whole = position + offset;
        let [i, j, _] = f32::channels(whole).map(|whole| (whole.to_bits() & 0x007f_ffff) as usize);
        let both = weights(position - (whole - offset));
        let across = both.map(|weight| f32::gray(f32::channels(weight)[0]));
        let along = both.map(|weight| f32::gray(f32::channels(weight)[1]));
        let rows = load_block(&self.points, j * self.row + i, self.row);
        let sums = rows.map(|row| weighted(row, across));
        weighted(sums, along)
    }

    /// [`Table::at`] of as many as there are.
    #[inline(always)]
    pub(super) fn lanes<L: Lane<Scalar = f32>>(&self, cos_theta: L, thickness_nm: L) -> L::Rgb {
        self.around(self.position(cos_theta, thickness_nm))
    }

    /// Steps along the cosine and the thickness.
    #[inline(always)]
    pub(super) fn position<L: Lane<Scalar = f32>>(&self, cos_theta: L, thickness_nm: L) -> [L; 2] {
        self.coordinates.lanes(cos_theta, thickness_nm)
    }

    /// The colours at what [`Table::position`] found.
    #[inline(always)]
    pub(super) fn around<L: Lane<Scalar = f32>>(&self, position: [L; 2]) -> L::Rgb {
        let first = [position[0].round(), position[1].round()];
        let [across, along] = [
            weights(position[0] - first[0]),
            weights(position[1] - first[1]),
        ];
        let block = TableBlock {
            first,
            across,
            along,
        };
        L::weighted_block(&self.points, self.row, block)
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.points)
    }

    /// How many values it goes through along either coordinate.
    pub(super) fn counts(&self) -> [usize; 2] {
        [self.row - 2, self.points.len() / self.row - 2]
    }
}

fn packed(rgb: Rgb<f64>) -> Control {
    Control::new(rgb.map(|channel| channel as f32))
}

/// [`Error::reserve`]
pub(super) fn reserve<T>(count: usize) -> Result<Vec<T>, Error> {
    Error::reserve(count, "a film's table")
}
