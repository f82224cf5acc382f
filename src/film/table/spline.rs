//! Tables of colours: quadratic splines over one or two coordinates.

use super::axes::{Axes, AxisParams, Coordinates};
use crate::error::Error;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
use crate::num::spline::{LEAST_VALUES, controls, weights};
use crate::num::{INDEX_BIAS, Lane, Real, Rgb, TableBlock, TableEntry, each};

/// Colours over the cosine alone (a film of fixed thickness, or none) or over cosine and thickness.
///
/// Cost: a division and 3 control points; over both coordinates two divisions, side by side, and 9
/// control points.
#[derive(Clone, Debug)]
pub(in crate::film) struct SplineTable {
    coordinates: Coordinates,
    /// Control points: rows of equal y, two longer than the values are.
    points: Box<[TableEntry<f32>]>,
    /// The length of a row; 0 for a table over the cosine alone.
    row: usize,
    /// What the coordinates are made from, besides the range of the thickness.
    params: AxisParams,
}

/// The greatest number of values along a coordinate of a table that is loaded: positions in single precision are
/// exact enough to stay within it.
pub(super) const MOST_LOADED: usize = 1 << 17;

impl SplineTable {
    /// Over the cosine alone, through values at equal steps of x, at least
    /// [`LEAST_VALUES`](crate::num::spline::LEAST_VALUES). Fails if there is no memory.
    pub(in crate::film) fn over_cosine(axes: &Axes, values: &[Rgb<f64>]) -> Result<Self, Error> {
        let mut fitted = reserve(values.len() + 2)?;
        controls(values, &mut fitted);
        let mut points = reserve(fitted.len())?;
        points.extend(fitted.into_iter().map(packed));
        Ok(Self {
            coordinates: axes.coordinates([values.len() - 1, 0]),
            points: points.into(),
            row: 0,
            params: axes.params(),
        })
    }

    /// Over cosine and thickness, through values at equal steps of x and y, rows of equal y, `width`
    /// values to a row; at least [`LEAST_VALUES`](crate::num::spline::LEAST_VALUES) along either. Fails
    /// if there is no memory.
    pub(in crate::film) fn over_both(
        axes: &Axes,
        values: &[Rgb<f64>],
        width: usize,
    ) -> Result<Self, Error> {
        let height = values.len() / width;
        Ok(Self {
            coordinates: axes.coordinates([width - 1, height - 1]),
            points: control_points(values, width)?.into(),
            row: width + 2,
            params: axes.params(),
        })
    }

    pub(in crate::film) fn save(&self, block: &mut ByteWriter) {
        let Self {
            coordinates: _,
            points,
            row,
            params,
        } = self;
        params.save(block);
        block.count(points.len() / row.max(&1));
        block.count(*row);
        block.colors(points);
    }

    /// Reads a table whose thickness has that range, nm.
    pub(in crate::film) fn load(
        block: &mut ByteReader<'_>,
        range: [f64; 2],
    ) -> Result<Self, Error> {
        let params = AxisParams::load(block)?;
        let [rows, row] = [block.count(1, MOST_LOADED)?, block.count(0, MOST_LOADED)?];
        let is_over_cosine = row == 0;
        let least = LEAST_VALUES + 2;
        if rows < least || (row < least && !is_over_cosine) {
            return Err(unusable("a table is too small"));
        }
        let (axes, steps) = if is_over_cosine {
            (Axes::new(params, [0.0; 2]), [rows - 3, 0])
        } else {
            (Axes::new(params, range), [row - 3, rows - 3])
        };
        Ok(Self {
            coordinates: axes.coordinates(steps),
            points: block.colors(rows * row.max(1))?.into(),
            row,
            params,
        })
    }

    /// The colours at cosines in [0, 1] and thicknesses within the range, nm; 0 for a table over the
    /// cosine alone.
    #[inline(always)]
    pub(in crate::film) fn at<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
    ) -> L::Rgb {
        self.around::<L>(self.position(cos_theta, thickness_nm))
    }

    /// Steps along x, and along y twice; along x alone for a table over the cosine alone.
    #[inline(always)]
    pub(in crate::film) fn position<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
    ) -> L::Rgb {
        if self.is_over_cosine() {
            return self.coordinates.over_cosine(cos_theta).gray();
        }
        self.coordinates.at(cos_theta, thickness_nm)
    }

    /// The colours at a [`SplineTable::position`].
    #[inline(always)]
    pub(in crate::film) fn around<L: Lane<Scalar = f32>>(&self, position: L::Rgb) -> L::Rgb {
        if self.is_over_cosine() {
            let ([column, _], [across, _]) = nearest::<L>(position);
            return L::weighted_row(&self.points, column, across);
        }
        look_up::<L>(&self.points, self.row, position)
    }

    /// Whether the table is over the cosine alone.
    #[inline(always)]
    pub(in crate::film) fn is_over_cosine(&self) -> bool {
        self.row == 0
    }

    /// Bytes of the control points.
    pub(in crate::film) fn bytes(&self) -> usize {
        size_of_val(&*self.points)
    }

    /// The number of values and where they are, in words.
    pub(in crate::film) fn size(&self) -> String {
        if self.is_over_cosine() {
            return format!("{} values over the cosine", self.points.len() - 2);
        }
        let [width, height] = [self.row - 2, self.points.len() / self.row - 2];
        format!("{width} x {height} values over cosine and thickness")
    }
}

/// The colours at a position in steps along x, and along y twice, in rows of control points.
#[inline(always)]
pub(super) fn look_up<L: Lane<Scalar = f32>>(
    points: &[TableEntry<f32>],
    row: usize,
    position: L::Rgb,
) -> L::Rgb {
    let (first, [across, along]) = nearest::<L>(position);
    let block = TableBlock {
        first,
        across,
        along,
    };
    L::weighted_block(points, row, block)
}

/// The values nearest to a position, biased, and the weights of the control points around them, along x and y.
#[inline(always)]
fn nearest<L: Lane<Scalar = f32>>(position: L::Rgb) -> ([L; 2], [[L; 3]; 2]) {
    let bias = L::Rgb::new(INDEX_BIAS);
    let biased = position + bias;
    let distance = position - (biased - bias);
    let weights = each!(weights(distance), |weight| L::channels(weight));
    let [column, row, _] = L::channels(biased);
    let across = each!(weights, |[x, ..]| x);
    let along = each!(weights, |[_, y, _]| y);
    ([column, row], [across, along])
}

/// The control points of the spline through values in rows of `width`: rows of `width` + 2, two more than there
/// are rows of values. Fails if there is no memory.
pub(super) fn control_points(
    values: &[Rgb<f64>],
    width: usize,
) -> Result<Vec<TableEntry<f32>>, Error> {
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
    points.resize(row * (height + 2), TableEntry::default());
    let mut column = Vec::new();
    for i in 0..row {
        column.clear();
        column.extend((0..height).map(|j| along_x[j * row + i]));
        controls(&column, &mut fitted);
        for (j, point) in fitted.iter().enumerate() {
            points[j * row + i] = packed(*point);
        }
    }
    Ok(points)
}

fn packed(rgb: Rgb<f64>) -> TableEntry<f32> {
    TableEntry::new(rgb.map(|channel| channel as f32))
}

/// An empty vector with room for `count` elements; fails if there is no memory.
pub(in crate::film) fn reserve<T>(count: usize) -> Result<Vec<T>, Error> {
    Error::reserve(count, "a film's table")
}
