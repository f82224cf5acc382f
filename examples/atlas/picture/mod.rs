//! Heat maps as small multiples: rows of panels under common headings, one colour scale for all.

mod panel;
mod scale;

pub use panel::Cells;

use crate::atlas::axis::Axis;
use crate::text::{INK, style};
use panel::{CELL_PIXELS, Panel};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use scale::{BOUNDS, CLASSES, color};

/// Where everything is drawn.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// How drawing fails.
pub type Failure = DrawingAreaErrorKind<std::io::Error>;

const FONT: i32 = 11;
const TITLE_FONT: i32 = 18;
const LINE: i32 = 15;
const MARGIN: i32 = 12;
/// For the rows' names and the vertical axis.
const LABELS: i32 = 148;
const GAP: i32 = 7;
/// What the legend takes.
const LEGEND: i32 = 840;
/// Below a row, for the values and the name of its horizontal axis.
const AXIS: i32 = 36;
/// The greatest number of characters in a line of a heading, and of a row's name.
const HEADING: usize = 13;
const NAME: usize = 17;

/// A row of panels.
pub struct Row {
    pub name: String,
    pub y: Axis,
    /// One per heading; none stays blank.
    pub panels: Vec<Option<Cells>>,
}

/// A picture.
pub struct Picture {
    pub title: String,
    /// Lines under the title.
    pub explanation: Vec<String>,
    /// Of the columns.
    pub headings: Vec<String>,
    pub rows: Vec<Row>,
    /// Where the contour is; one of the scale's bounds.
    pub contour: f64,
}

impl Picture {
    /// As SVG.
    pub fn svg(&self) -> Result<String, Failure> {
        let mut out = String::new();
        {
            let size = (self.width() as u32, self.height() as u32);
            let area = SVGBackend::with_string(&mut out, size).into_drawing_area();
            area.fill(&WHITE)?;
            self.head(&area)?;
            let mut top = self.top();
            for (i, row) in self.rows.iter().enumerate() {
                // The axis is written once below rows that share it.
                let next = self.rows.get(i + 1);
                let is_last = next.is_none_or(|next| !next.shares_axes(row));
                self.row(&area, row, top, is_last)?;
                top += self.side() + if is_last { AXIS } else { GAP };
            }
            area.present()?;
        }
        Ok(out)
    }

    /// Of a panel, in pixels.
    fn side(&self) -> i32 {
        let panels = self.rows.iter().flat_map(|row| &row.panels);
        let cells = panels.flatten().map(|cells| cells.count).max();
        CELL_PIXELS * cells.unwrap_or(0) as i32
    }

    fn heading_lines(&self) -> i32 {
        let lines = self.headings.iter().map(|h| wrapped(h, HEADING).len());
        lines.max().unwrap_or(0) as i32
    }

    fn top(&self) -> i32 {
        let legend = 30;
        let above = 40 + LINE * self.explanation.len() as i32 + legend;
        above + LINE * self.heading_lines() + 8
    }

    fn width(&self) -> i32 {
        let panels = LABELS + (self.side() + GAP) * self.headings.len() as i32 + MARGIN;
        panels.max(LEGEND)
    }

    fn height(&self) -> i32 {
        let axes = self.rows.windows(2).map(|pair| {
            if pair[0].shares_axes(&pair[1]) {
                GAP
            } else {
                AXIS
            }
        });
        let between: i32 = axes.sum();
        self.top() + self.side() * self.rows.len() as i32 + between + AXIS + 4
    }

    fn head(&self, area: &Area) -> Result<(), Failure> {
        let title = style(TITLE_FONT, INK, HPos::Left, VPos::Top);
        area.draw_text(&self.title, &title, (MARGIN, 10))?;
        let small = style(FONT + 1, INK, HPos::Left, VPos::Top);
        for (i, line) in self.explanation.iter().enumerate() {
            area.draw_text(line, &small, (MARGIN, 38 + LINE * i as i32))?;
        }
        let legend = 38 + LINE * self.explanation.len() as i32 + 6;
        self.legend(area, legend)?;
        let heading = style(FONT, INK, HPos::Left, VPos::Bottom);
        for (i, text) in self.headings.iter().enumerate() {
            let lines = wrapped(text, HEADING);
            for (j, line) in lines.iter().enumerate() {
                let up = LINE * (lines.len() - 1 - j) as i32;
                area.draw_text(line, &heading, (self.left(i), self.top() - 4 - up))?;
            }
        }
        Ok(())
    }

    /// What the colours, the contour and the hatching mean.
    fn legend(&self, area: &Area, top: i32) -> Result<(), Failure> {
        const BOX: i32 = 16;
        const STEP: i32 = 92;
        let beside = style(FONT, INK, HPos::Left, VPos::Center);
        let middle = top + BOX / 2;
        for class in 0..CLASSES {
            let left = MARGIN + STEP * class as i32;
            let corners = [(left, top), (left + BOX + 8, top + BOX)];
            area.draw(&Rectangle::new(corners, color(class).filled()))?;
            area.draw(&Rectangle::new(corners, INK))?;
            let meaning = match (class.checked_sub(1), BOUNDS.get(class)) {
                (None, _) => format!("to {}", written(BOUNDS[0])),
                (_, Some(bound)) => format!("to {}", written(*bound)),
                (_, None) => "beyond".to_owned(),
            };
            area.draw_text(&meaning, &beside, (left + BOX + 14, middle))?;
        }
        let left = MARGIN + STEP * CLASSES as i32;
        let line = PathElement::new(
            vec![(left, middle), (left + 24, middle)],
            INK.stroke_width(2),
        );
        area.draw(&line)?;
        let contour = format!("contour at {}", written(self.contour));
        area.draw_text(&contour, &beside, (left + 30, middle))?;
        let left = left + 132;
        panel::hatch(area, (left, top), (BOX + 8, BOX))?;
        area.draw_text("refused, or none", &beside, (left + BOX + 14, middle))
    }

    fn left(&self, column: usize) -> i32 {
        LABELS + (self.side() + GAP) * column as i32
    }

    fn row(&self, area: &Area, row: &Row, top: i32, has_axis: bool) -> Result<(), Failure> {
        let name = style(FONT, INK, HPos::Left, VPos::Top);
        for (i, line) in wrapped(&row.name, NAME).iter().enumerate() {
            area.draw_text(line, &name, (MARGIN, top + LINE * i as i32))?;
        }
        let bottom = top + self.side();
        let beside = style(FONT - 1, INK, HPos::Right, VPos::Center);
        for tick in row.y.ticks {
            let y = bottom - (row.y.part(*tick) * f64::from(self.side())).round() as i32;
            let y_text = y.clamp(top + 5, bottom - 5);
            let ends = vec![(LABELS - 4, y), (LABELS, y)];
            area.draw(&PathElement::new(ends, INK))?;
            area.draw_text(&written(*tick), &beside, (LABELS - 6, y_text))?;
        }
        if has_axis {
            let vertical = style(FONT - 1, INK, HPos::Left, VPos::Bottom);
            for (i, line) in wrapped(row.y.name, 12).iter().enumerate() {
                let up = 2 - i as i32;
                area.draw_text(line, &vertical, (MARGIN, bottom + 2 - 13 * up + 13))?;
            }
        }
        for (i, cells) in row.panels.iter().enumerate() {
            let Some(cells) = cells else { continue };
            let panel = Panel {
                left: self.left(i),
                top,
                side: self.side(),
                cells,
                contour: self.contour,
            };
            panel.draw(area)?;
            if has_axis {
                self.horizontal(area, cells.x, self.left(i), bottom)?;
            }
        }
        Ok(())
    }

    fn horizontal(&self, area: &Area, axis: Axis, left: i32, bottom: i32) -> Result<(), Failure> {
        let right = left + self.side();
        for tick in axis.ticks {
            let x = left + (axis.part(*tick) * f64::from(self.side())).round() as i32;
            area.draw(&PathElement::new(vec![(x, bottom), (x, bottom + 3)], INK))?;
            let at = if x - left < 8 {
                HPos::Left
            } else if right - x < 8 {
                HPos::Right
            } else {
                HPos::Center
            };
            let below = style(FONT - 1, INK, at, VPos::Top);
            area.draw_text(&written(*tick), &below, (x, bottom + 4))?;
        }
        let below = style(FONT - 1, INK, HPos::Center, VPos::Top);
        area.draw_text(axis.name, &below, ((left + right) / 2, bottom + 17))
    }
}

impl Row {
    /// Whether axes written below the other row serve this one, too.
    fn shares_axes(&self, other: &Self) -> bool {
        let mut pairs = self.panels.iter().zip(&other.panels);
        let is_same = |a: &Cells, b: &Cells| a.x == b.x;
        self.y == other.y
            && pairs.all(|(a, b)| {
                a.as_ref()
                    .zip(b.as_ref())
                    .is_some_and(|(a, b)| is_same(a, b))
            })
    }
}

/// In lines of so many characters, broken at spaces and underscores.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_inclusive([' ', '_']) {
        let length = |text: &str| text.trim_end().chars().count();
        match lines.last_mut() {
            Some(line) if line.is_empty() || line.chars().count() + length(word) <= most => {
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
        .iter()
        .map(|line| line.trim_end().to_owned())
        .collect()
}

/// A number as short as it can be.
pub fn written(value: f64) -> String {
    let [short, long] = [format!("{value:e}"), format!("{value}")];
    if long.len() <= 4 { long } else { short }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_broken_between_words() {
        assert_eq!(wrapped("lacquer on metal", 10), ["lacquer on", "metal"]);
        assert_eq!(
            wrapped("metallic_roughness, metal", 13),
            ["metallic_", "roughness,", "metal"]
        );
        assert_eq!(wrapped("", 10), [""]);
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [2e-4, 0.02, 1e4, 1e8, 0.0].map(written),
            ["2e-4", "0.02", "1e4", "1e8", "0"]
        );
    }
}
