//! One heat map.

use super::scale::{class, color};
use super::{Area, Failure};
use crate::atlas::axis::Axis;
use crate::text::{INK, style};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// The side of a cell.
pub const CELL_PIXELS: i32 = 3;

/// What a map shows.
#[derive(Clone, Debug)]
pub struct Cells {
    /// The horizontal axis.
    pub x: Axis,
    /// Along either side.
    pub count: usize,
    /// Row by row from below; none where there is nothing to show.
    pub errors: Vec<Option<f64>>,
    /// Written into its corner.
    pub note: String,
}

/// A map at its place.
pub struct Panel<'a> {
    pub left: i32,
    pub top: i32,
    pub side: i32,
    pub cells: &'a Cells,
    pub contour: f64,
}

impl Panel<'_> {
    pub fn draw(&self, area: &Area) -> Result<(), Failure> {
        let size = (self.side, self.side);
        if self.cells.errors.iter().any(Option::is_none) {
            hatch(area, (self.left, self.top), size)?;
        }
        for (class, [from, to]) in self.rectangles() {
            let [left, top] = self.corner([from[0], to[1] + 1]);
            let [right, bottom] = self.corner([to[0] + 1, from[1]]);
            let corners = [(left, top), (right, bottom)];
            area.draw(&Rectangle::new(corners, color(class).filled()))?;
        }
        for [from, to] in self.contour_lines() {
            let [a, b] = [from, to].map(|corner| self.corner(corner).into());
            area.draw(&PathElement::new(vec![a, b], INK.stroke_width(2)))?;
        }
        let corners = [
            (self.left, self.top),
            (self.left + self.side, self.top + self.side),
        ];
        area.draw(&Rectangle::new(corners, INK))?;
        if !self.cells.note.is_empty() {
            self.note(area)?;
        }
        Ok(())
    }

    /// On a ground of its own, as the map below may be light or dark.
    fn note(&self, area: &Area) -> Result<(), Failure> {
        let bottom = self.top + self.side;
        let width = 6 * self.cells.note.chars().count() as i32 + 6;
        let ground = [
            (self.left + 1, bottom - 14),
            (self.left + width, bottom - 1),
        ];
        area.draw(&Rectangle::new(ground, WHITE.filled()))?;
        let small = style(10, INK, HPos::Left, VPos::Center);
        area.draw_text(&self.cells.note, &small, (self.left + 4, bottom - 7))
    }

    fn class_at(&self, x: usize, y: usize) -> Option<usize> {
        self.cells.errors[y * self.cells.count + x].map(class)
    }

    /// Cells of one class side by side, as few rectangles as is easy: runs along a row, joined with like
    /// ones of the rows above. Each has its first and its last cell.
    fn rectangles(&self) -> Vec<(usize, [[usize; 2]; 2])> {
        let count = self.cells.count;
        let mut done: Vec<(usize, [[usize; 2]; 2])> = Vec::new();
        for y in 0..count {
            let mut x = 0;
            while x < count {
                let here = self.class_at(x, y);
                let length = (x..count)
                    .take_while(|x| self.class_at(*x, y) == here)
                    .count();
                let last = x + length - 1;
                if let Some(class) = here {
                    let continued = done.iter_mut().find(|(other, [from, to])| {
                        *other == class && from[0] == x && *to == [last, y.wrapping_sub(1)]
                    });
                    match continued {
                        Some((_, [_, to])) => to[1] = y,
                        None => done.push((class, [[x, y], [last, y]])),
                    }
                }
                x += length;
            }
        }
        done
    }

    /// Edges of cells between errors within and beyond the contour, in straight lines.
    fn contour_lines(&self) -> Vec<[[usize; 2]; 2]> {
        let count = self.cells.count;
        let beyond = |x: usize, y: usize| {
            let error = self.cells.errors[y * count + x];
            error.map(|error| error.is_nan() || error > self.contour)
        };
        let differ = |a: Option<bool>, b: Option<bool>| a.is_some() && b.is_some() && a != b;
        let mut lines = Vec::new();
        for fixed in 1..count {
            for is_upright in [true, false] {
                let is_edge = |along: usize| {
                    if is_upright {
                        differ(beyond(fixed - 1, along), beyond(fixed, along))
                    } else {
                        differ(beyond(along, fixed - 1), beyond(along, fixed))
                    }
                };
                let place = |along: usize| {
                    if is_upright {
                        [fixed, along]
                    } else {
                        [along, fixed]
                    }
                };
                let mut along = 0;
                while along < count {
                    let length = (along..count).take_while(|i| is_edge(*i)).count();
                    if length > 0 {
                        lines.push([place(along), place(along + length)]);
                    }
                    along += length + 1;
                }
            }
        }
        lines
    }

    /// The corner of cells, in pixels.
    fn corner(&self, [x, y]: [usize; 2]) -> [i32; 2] {
        let [x, y] = [x, y].map(|i| CELL_PIXELS * i as i32);
        [self.left + x, self.top + self.side - y]
    }
}

/// Slanting lines: nothing to show.
pub fn hatch(
    area: &Area,
    (left, top): (i32, i32),
    (width, height): (i32, i32),
) -> Result<(), Failure> {
    let gray = RGBColor(150, 150, 150);
    for offset in (0..width + height).step_by(7) {
        let from = (left + (offset - height).max(0), top + offset.min(height));
        let to = (left + offset.min(width), top + (offset - width).max(0));
        area.draw(&PathElement::new(vec![from, to], gray))?;
    }
    area.draw(&Rectangle::new(
        [(left, top), (left + width, top + height)],
        INK,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every cell is in one rectangle of its class, and the contour runs between 1e-3 and 1e-1.
    #[test]
    fn rectangles_cover_the_cells_and_lines_part_them() {
        let cells = Cells {
            x: crate::atlas::axis::ANGLE,
            count: 3,
            errors: vec![
                Some(1e-3),
                Some(1e-3),
                Some(0.1),
                Some(1e-3),
                Some(1e-3),
                Some(0.1),
                None,
                Some(1e-3),
                Some(0.1),
            ],
            note: String::new(),
        };
        let panel = Panel {
            left: 0,
            top: 0,
            side: 9,
            cells: &cells,
            contour: 2e-3,
        };
        let mut area = 0;
        for (class, [from, to]) in panel.rectangles() {
            area += (to[0] + 1 - from[0]) * (to[1] + 1 - from[1]);
            assert_eq!(panel.class_at(from[0], from[1]), Some(class));
        }
        assert_eq!((area, panel.rectangles().len()), (8, 3));
        assert_eq!(panel.contour_lines(), [[[2, 0], [2, 3]]]);
    }
}
