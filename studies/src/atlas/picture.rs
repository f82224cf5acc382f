//! Heat maps as small multiples: rows of panels under common headings, one colour scale for all.

use super::films::TOLERANCE;
use crate::error_maps::axis::Axis;
use crate::error_maps::map::Map;
use crate::shared::svg::{self, Area, Failure, INK, Pixel, line, style, written};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const FONT: i32 = 11;
const LINE: i32 = 15;
const MARGIN: i32 = 20;
/// The side of a cell.
const CELL: i32 = 3;
/// The width of the rows' names and the vertical axis.
const LABELS: i32 = 156;
const GAP: i32 = 7;
/// The legend's top, and the room above the headings.
const LEGEND_TOP: i32 = 78;
const HEAD: i32 = 108;
const LEGEND_WIDTH: i32 = 860;
/// The height of the values and the name of a horizontal axis.
const AXIS: i32 = 36;
/// The greatest number of characters in a line of a heading, and of a row's name.
const HEADING: usize = 13;
const NAME: usize = 17;

/// The greatest error of each class but the last. The third is the default tolerance of films.
const BOUNDS: [f64; 5] = [2e-5, 2e-4, TOLERANCE, 2e-2, 0.2];

/// The class of an error; the last for what is not a number.
fn class(error: f64) -> usize {
    let is_within = |bound: &f64| error <= *bound;
    BOUNDS.iter().position(is_within).unwrap_or(BOUNDS.len())
}

/// Viridis (Smith and van der Walt 2015) from its light end: lightness alone distinguishes the classes.
fn color(class: usize) -> RGBColor {
    ViridisRGB.get_color(1.0 - class as f64 / BOUNDS.len() as f64)
}

/// A map.
#[derive(Clone, Debug)]
pub struct Cells {
    /// The horizontal axis.
    pub x: Axis,
    /// The number of cells along either side.
    pub count: usize,
    /// Row by row from below; none where there is nothing to show.
    pub errors: Vec<Option<f64>>,
    /// Written into the corner.
    pub note: String,
}

/// A row of panels, one per heading.
pub struct Row {
    pub name: String,
    pub y: Axis,
    pub panels: Vec<Cells>,
}

/// A picture.
pub struct Picture {
    pub title: &'static str,
    /// Lines under the title.
    pub explanation: [&'static str; 2],
    /// Of the columns.
    pub headings: Vec<String>,
    pub rows: Vec<Row>,
}

impl Picture {
    pub fn svg(&self) -> Result<String, Failure> {
        let side = CELL * self.rows[0].panels[0].count as i32;
        let left = |column: usize| LABELS + (side + GAP) * column as i32;
        let lines = self
            .headings
            .iter()
            .map(|heading| wrapped(heading, HEADING).len());
        let top = HEAD + LINE * lines.max().unwrap_or(0) as i32;
        // The axis is written once below rows that share it.
        let is_last = |i: usize| {
            !self
                .rows
                .get(i + 1)
                .is_some_and(|next| next.has_axes_of(&self.rows[i]))
        };
        let below = |i: usize| side + if is_last(i) { AXIS } else { GAP };
        let height = top + (0..self.rows.len()).map(below).sum::<i32>() + 4;
        let width = LEGEND_WIDTH.max(left(self.headings.len()) + MARGIN);
        let size = (width as u32, height as u32);
        svg::picture(size, self.title, &self.explanation, |area| {
            legend(area)?;
            let heading = style(FONT, INK, HPos::Left, VPos::Bottom);
            for (i, text) in self.headings.iter().enumerate() {
                for (up, part) in wrapped(text, HEADING).iter().rev().enumerate() {
                    area.draw_text(part, &heading, (left(i), top - 4 - LINE * up as i32))?;
                }
            }
            let mut top = top;
            for (i, row) in self.rows.iter().enumerate() {
                row.labels(area, top, side, is_last(i))?;
                for (column, cells) in row.panels.iter().enumerate() {
                    cells.draw(area, (left(column), top), is_last(i))?;
                }
                top += below(i);
            }
            Ok(())
        })
    }
}

/// What the colours, the contour and the hatching mean.
fn legend(area: &Area) -> Result<(), Failure> {
    const BOX: (i32, i32) = (24, 16);
    const STEP: i32 = 92;
    let top = LEGEND_TOP;
    let beside = |text: &str, left| svg::beside(area, text, (left, top + BOX.1 / 2));
    let mut left = MARGIN;
    for class in 0..=BOUNDS.len() {
        let corners = [(left, top), (left + BOX.0, top + BOX.1)];
        area.draw(&Rectangle::new(corners, color(class).filled()))?;
        area.draw(&Rectangle::new(corners, INK))?;
        let bound = BOUNDS
            .get(class)
            .map(|bound| format!("to {}", written(*bound)));
        beside(&bound.unwrap_or("beyond".into()), left + 30)?;
        left += STEP;
    }
    let middle = top + BOX.1 / 2;
    line(
        area,
        vec![(left, middle), (left + BOX.0, middle)],
        INK.stroke_width(2),
    )?;
    beside(&format!("contour at {}", written(TOLERANCE)), left + 30)?;
    left += 140;
    hatch(area, (left, top), BOX)?;
    beside("refused, or none", left + 30)
}

impl Row {
    /// Whether axes written below this row serve the other, too.
    fn has_axes_of(&self, other: &Self) -> bool {
        let mut pairs = self.panels.iter().zip(&other.panels);
        self.y == other.y && pairs.all(|(a, b)| a.x == b.x)
    }

    fn labels(&self, area: &Area, top: i32, side: i32, has_axis: bool) -> Result<(), Failure> {
        let bottom = top + side;
        let name = style(FONT, INK, HPos::Left, VPos::Top);
        for (i, part) in wrapped(&self.name, NAME).iter().enumerate() {
            area.draw_text(part, &name, (MARGIN, top + LINE * i as i32))?;
        }
        let beside = style(FONT - 1, INK, HPos::Right, VPos::Center);
        for tick in self.y.ticks {
            let y = bottom - (self.y.part(*tick) * f64::from(side)).round() as i32;
            line(area, vec![(LABELS - 4, y), (LABELS, y)], INK)?;
            let y = y.clamp(top + 5, bottom - 5);
            area.draw_text(&written(*tick), &beside, (LABELS - 6, y))?;
        }
        if has_axis {
            let vertical = style(FONT - 1, INK, HPos::Left, VPos::Bottom);
            for (i, part) in wrapped(self.y.name, 12).iter().enumerate() {
                area.draw_text(part, &vertical, (MARGIN, bottom - 11 + 13 * i as i32))?;
            }
        }
        Ok(())
    }
}

impl Cells {
    pub fn new(x: Axis, map: &Map) -> Self {
        Self {
            x,
            count: map.cells,
            errors: map.errors.clone(),
            note: String::new(),
        }
    }

    fn draw(&self, area: &Area, (left, top): Pixel, has_axis: bool) -> Result<(), Failure> {
        let side = CELL * self.count as i32;
        let (right, bottom) = (left + side, top + side);
        let corner = |[x, y]: [usize; 2]| (left + CELL * x as i32, bottom - CELL * y as i32);
        if self.errors.iter().any(Option::is_none) {
            hatch(area, (left, top), (side, side))?;
        }
        for (class, [from, to]) in self.rectangles() {
            let corners = [corner(from), corner(to)];
            area.draw(&Rectangle::new(corners, color(class).filled()))?;
        }
        for ends in self.contour_lines() {
            line(area, ends.map(corner).to_vec(), INK.stroke_width(2))?;
        }
        area.draw(&Rectangle::new([(left, top), (right, bottom)], INK))?;
        if !self.note.is_empty() {
            // On a ground of its own, because the map below may be light or dark.
            let width = 6 * self.note.chars().count() as i32 + 6;
            let ground = [(left + 1, bottom - 14), (left + width, bottom - 1)];
            area.draw(&Rectangle::new(ground, WHITE.filled()))?;
            let small = style(FONT - 1, INK, HPos::Left, VPos::Center);
            area.draw_text(&self.note, &small, (left + 4, bottom - 7))?;
        }
        if has_axis {
            self.axis(area, left, bottom, side)?;
        }
        Ok(())
    }

    fn axis(&self, area: &Area, left: i32, bottom: i32, side: i32) -> Result<(), Failure> {
        for tick in self.x.ticks {
            let along = (self.x.part(*tick) * f64::from(side)).round() as i32;
            let x = left + along;
            line(area, vec![(x, bottom), (x, bottom + 3)], INK)?;
            let at = match (along < 8, side - along < 8) {
                (true, _) => HPos::Left,
                (_, true) => HPos::Right,
                _ => HPos::Center,
            };
            area.draw_text(
                &written(*tick),
                &style(FONT - 1, INK, at, VPos::Top),
                (x, bottom + 4),
            )?;
        }
        let below = style(FONT - 1, INK, HPos::Center, VPos::Top);
        area.draw_text(self.x.name, &below, (left + side / 2, bottom + 17))
    }

    /// Cells of one class side by side as few rectangles: runs along a row, joined with like ones of the rows below.
    /// Each has two opposite corners.
    fn rectangles(&self) -> Vec<(usize, [[usize; 2]; 2])> {
        let mut done: Vec<(usize, [[usize; 2]; 2])> = Vec::new();
        for (y, row) in self.errors.chunks(self.count).enumerate() {
            let mut x = 0;
            for run in row.chunk_by(|a, b| a.map(class) == b.map(class)) {
                let end = x + run.len();
                if let Some(class) = run[0].map(class) {
                    let is_below = |(other, [from, to]): &&mut (usize, [[usize; 2]; 2])| {
                        *other == class && from[0] == x && *to == [end, y]
                    };
                    match done.iter_mut().find(is_below) {
                        Some((_, [_, to])) => to[1] = y + 1,
                        None => done.push((class, [[x, y], [end, y + 1]])),
                    }
                }
                x = end;
            }
        }
        done
    }

    /// The edges between cells within and beyond the contour, in straight lines.
    fn contour_lines(&self) -> Vec<[[usize; 2]; 2]> {
        let beyond = |[x, y]: [usize; 2]| {
            let error = self.errors[y * self.count + x]?;
            Some(error.is_nan() || error > TOLERANCE)
        };
        let mut lines = Vec::new();
        for is_upright in [true, false] {
            let place = |fixed, along| {
                if is_upright {
                    [fixed, along]
                } else {
                    [along, fixed]
                }
            };
            for fixed in 1..self.count {
                let is_edge = |along: &usize| {
                    let sides = [fixed - 1, fixed].map(|fixed| beyond(place(fixed, *along)));
                    matches!(sides, [Some(a), Some(b)] if a != b)
                };
                let edges: Vec<usize> = (0..self.count).filter(is_edge).collect();
                for run in edges.chunk_by(|a, b| a + 1 == *b) {
                    lines.push([place(fixed, run[0]), place(fixed, run[run.len() - 1] + 1)]);
                }
            }
        }
        lines
    }
}

/// Slanting lines: nothing to show.
fn hatch(area: &Area, (left, top): Pixel, (width, height): Pixel) -> Result<(), Failure> {
    let gray = RGBColor(150, 150, 150);
    for offset in (0..width + height).step_by(7) {
        let from = (left + (offset - height).max(0), top + offset.min(height));
        let to = (left + offset.min(width), top + (offset - width).max(0));
        line(area, vec![from, to], gray)?;
    }
    area.draw(&Rectangle::new(
        [(left, top), (left + width, top + height)],
        INK,
    ))
}

/// In lines of at most that number of characters, broken at spaces and underscores.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_inclusive([' ', '_']) {
        let last = lines.last_mut().unwrap();
        if last.is_empty() || last.len() + word.trim_end().len() <= most {
            last.push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
        .iter()
        .map(|line| line.trim_end().to_owned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::errors::lab;

    #[test]
    fn texts_are_broken_between_words() {
        assert_eq!(wrapped("lacquer on metal", 10), ["lacquer on", "metal"]);
        let broken = ["metallic_", "roughness,", "metal"];
        assert_eq!(wrapped("metallic_roughness, metal", 13), broken);
        assert_eq!(wrapped("", 10), [""]);
    }

    /// Printed in grey, a greater error is darker, and by enough to be seen: the lightness L* of CIE 1976.
    #[test]
    fn greater_errors_are_darker() {
        // The transfer function of sRGB (IEC 61966-2-1) beyond its linear part.
        let linear = |x: u8| ((f64::from(x) / 255.0 + 0.055) / 1.055).powf(2.4);
        let lightness = |class| {
            let RGBColor(r, g, b) = color(class);
            lab([r, g, b].map(linear)).l
        };
        let along: Vec<f32> = (0..=BOUNDS.len()).map(lightness).collect();
        assert!(
            along.windows(2).all(|pair| pair[0] - pair[1] > 10.0),
            "{along:?}"
        );
        assert_eq!(
            [0.0, 2e-3, 2.1e-3, 1.0, f64::NAN].map(class),
            [0, 2, 3, 5, 5]
        );
    }

    /// Every cell is in one rectangle of its class, and the contour runs between 1e-3 and 1e-1.
    #[test]
    fn rectangles_cover_the_cells_and_lines_part_them() {
        let [low, high] = [Some(1e-3), Some(0.1)];
        let cells = Cells {
            x: crate::error_maps::axis::ANGLE,
            count: 3,
            errors: vec![low, low, high, low, low, high, None, low, high],
            note: String::new(),
        };
        let area = |[from, to]: [[usize; 2]; 2]| (to[0] - from[0]) * (to[1] - from[1]);
        let rectangles = cells.rectangles();
        for (class_here, [[x, y], _]) in &rectangles {
            assert_eq!(cells.errors[y * 3 + x].map(class), Some(*class_here));
        }
        let areas = rectangles.iter().map(|(_, corners)| area(*corners));
        assert_eq!((areas.sum::<usize>(), rectangles.len()), (8, 3));
        assert_eq!(cells.contour_lines(), [[[2, 0], [2, 3]]]);
    }
}
