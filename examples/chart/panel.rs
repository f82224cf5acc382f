//! One panel: every entry's time and error over some of the cells.

use crate::axis::{Axis, written};
use crate::contest::Summary;
use crate::entry::{Entry, Family};
use crate::front::front;
use crate::labels::{Rect, Tag, along, place};
use crate::marker::{Area, Failure, RADIUS, draw_level};
use crate::text::{INK, style, width};
use pellicle::film::OneLayerMethod;
use pellicle::num::Level;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// The ends of the error axis.
const ERRORS: [f64; 2] = [1e-6, 1.0];
/// Where the marker of an entry without error is.
const FLOOR: f64 = 1.5e-6;
/// Methods slower than this, ns, lie beyond the axis with their time beside them.
const LAST_NS: f64 = 4000.0;
/// The quickest that the axis has room for, ns.
const FIRST_NS: f64 = 2.0;

const GRID: RGBColor = RGBColor(228, 228, 228);
const FRONT: RGBColor = RGBColor(205, 205, 205);

/// What a panel shows, and where.
pub struct Panel<'a> {
    pub title: &'a str,
    pub summaries: &'a [Summary],
    /// Of the frame.
    pub frame: Rect,
    /// The width of the part beyond the axis, at the right of the frame.
    pub beyond: i32,
    pub font: i32,
    /// Whether all entries have labels, or planned films and the front alone.
    pub labels_all: bool,
    pub has_error_axis: bool,
}

impl Panel<'_> {
    /// Draws it.
    pub fn draw(&self, area: &Area) -> Result<(), Failure> {
        self.axes(area)?;
        let places: Vec<(i32, i32)> = self.summaries.iter().map(|s| self.place(s)).collect();
        for (line, style) in self.lines(&places) {
            area.draw(&PathElement::new(line, style))?;
        }
        for summary in self.summaries {
            let color = summary.entry.family().color().mix(0.45);
            for line in self.whiskers(summary) {
                area.draw(&PathElement::new(line, color))?;
            }
        }
        for summary in self.summaries {
            let color = summary.entry.family().color();
            for (level, place) in self.batches(summary) {
                draw_level(area, level, color, place)?;
            }
        }
        for (summary, place) in self.summaries.iter().zip(&places) {
            summary.entry.family().draw(area, *place)?;
        }
        self.labels(area, &places)
    }

    fn time_axis(&self) -> Axis {
        let Rect { left, width, .. } = self.frame;
        Axis {
            values: [FIRST_NS, LAST_NS],
            pixels: [left, left + width - self.beyond],
        }
    }

    fn error_axis(&self) -> Axis {
        let Rect { top, height, .. } = self.frame;
        Axis {
            values: ERRORS,
            pixels: [top + height, top],
        }
    }

    fn place(&self, summary: &Summary) -> (i32, i32) {
        let error = summary.errors.rms().max(FLOOR);
        (self.time(summary.ns), self.error_axis().at(error))
    }

    /// Where its batches are, whose errors are the same: at every level, but for those beyond the axis.
    fn batches(&self, summary: &Summary) -> Vec<(Level, (i32, i32))> {
        let (_, y) = self.place(summary);
        let all = Level::all().into_iter().zip(&summary.batch_ns);
        let shown = all.filter(|(_, ns)| **ns <= LAST_NS);
        shown
            .map(|(level, ns)| (level, (self.time(*ns), y)))
            .collect()
    }

    /// Where a time is, perhaps beyond the axis.
    fn time(&self, ns: f64) -> i32 {
        if ns > LAST_NS {
            self.frame.left + self.frame.width - self.beyond / 2
        } else {
            self.time_axis().at(ns)
        }
    }

    /// From the marker to the greatest error and to the slowest film's time.
    fn whiskers(&self, summary: &Summary) -> Vec<[(i32, i32); 2]> {
        let (x, y) = self.place(summary);
        let mut lines = Vec::new();
        let top = self.error_axis().at(summary.errors.max().max(FLOOR));
        if top < y {
            lines.push([(x, y), (x, top)]);
            lines.push([(x - 3, top), (x + 3, top)]);
        }
        let right = self.time(summary.slowest_ns);
        if right > x + RADIUS {
            lines.push([(x, y), (right, y)]);
            lines.push([(right, y - 3), (right, y + 3)]);
        }
        lines
    }

    fn axes(&self, area: &Area) -> Result<(), Failure> {
        let Rect {
            left,
            top,
            width,
            height,
        } = self.frame;
        let (times, errors) = (self.time_axis(), self.error_axis());
        let (right, bottom) = (left + width, top + height);
        let line = |from, to, color: RGBColor| area.draw(&PathElement::new(vec![from, to], color));
        for x in times.lines().into_iter().map(|v| times.at(v)) {
            line((x, top), (x, bottom), GRID)?;
        }
        for y in errors.ticks(true).into_iter().map(|v| errors.at(v)) {
            line((left, y), (right, y), GRID)?;
        }
        let [_, end] = times.pixels;
        line((end, top), (end, bottom), INK)?;
        line((end + 3, top), (end + 3, bottom), INK)?;
        area.draw(&Rectangle::new([(left, top), (right, bottom)], INK))?;
        let below = style(self.font, INK, HPos::Center, VPos::Top);
        for value in times.ticks(width < 500) {
            let label = format!("{} ns", written(value));
            area.draw_text(&label, &below, (times.at(value), bottom + 5))?;
        }
        area.draw_text("slower", &below, (right - self.beyond / 2, bottom + 5))?;
        if self.has_error_axis {
            let beside = style(self.font, INK, HPos::Right, VPos::Center);
            for value in errors.ticks(true) {
                area.draw_text(&written(value), &beside, (left - 6, errors.at(value)))?;
            }
        }
        let above = style(self.font + 1, INK, HPos::Left, VPos::Bottom);
        area.draw_text(self.title, &above, (left, top - 5))
    }

    /// The front, a broad line behind everything, and one line through each family.
    fn lines(&self, places: &[(i32, i32)]) -> Vec<(Vec<(i32, i32)>, ShapeStyle)> {
        let front = self.on_front().into_iter().map(|i| places[i]).collect();
        let mut lines = vec![(front, FRONT.stroke_width(7))];
        for family in Family::ALL {
            let of = |(s, p): (&Summary, &(i32, i32))| (s.entry.family() == family).then_some(*p);
            let members = self.summaries.iter().zip(places).filter_map(of).collect();
            lines.push((members, family.color().mix(0.6).stroke_width(1)));
        }
        lines
    }

    fn on_front(&self) -> Vec<usize> {
        let points: Vec<_> = self
            .summaries
            .iter()
            .map(|s| [s.ns, s.errors.rms()])
            .collect();
        front(&points)
    }

    fn labels(&self, area: &Area, places: &[(i32, i32)]) -> Result<(), Failure> {
        let front = self.on_front();
        let labelled = (0..places.len()).filter(|i| {
            let is_planned = self.summaries[*i].entry.family() == Family::Planned;
            self.labels_all || is_planned || front.contains(i)
        });
        let labels: Vec<(usize, String)> =
            labelled.map(|i| (i, label(&self.summaries[i]))).collect();
        let tag = |(i, label): &(usize, String)| Tag {
            anchor: places[*i],
            width: width(label, self.font),
            height: self.font,
        };
        let tags: Vec<Tag> = labels.iter().map(tag).collect();
        let size = 2 * RADIUS + 2;
        let batches = self.summaries.iter().flat_map(|s| self.batches(s));
        let all = places
            .iter()
            .copied()
            .chain(batches.map(|(_, place)| place));
        let markers = all.map(|p| Rect::around(p, size, size));
        let lines = self.lines(places);
        let steps = lines.iter().flat_map(|(line, _)| along(line));
        let whiskers = self.summaries.iter().flat_map(|s| self.whiskers(s));
        let obstacles = markers
            .chain(steps)
            .chain(whiskers.flat_map(|line| along(&line)));
        let obstacles: Vec<Rect> = obstacles.collect();
        let rects = place(&tags, &obstacles, &self.frame);
        for ((i, label), rect) in labels.iter().zip(rects) {
            let color = self.summaries[*i].entry.family().color();
            let centered = style(self.font, color, HPos::Center, VPos::Center);
            let middle = (rect.left + rect.width / 2, rect.top + rect.height / 2);
            area.draw_text(label, &centered, middle)?;
        }
        Ok(())
    }
}

/// What stands beside a marker.
fn label(summary: &Summary) -> String {
    let setting = match summary.entry {
        Entry::Method(OneLayerMethod::TwoBeam) => "two beams".into(),
        Entry::Method(OneLayerMethod::AiryRgb) => "3 wavelengths".into(),
        Entry::Method(OneLayerMethod::Harmonics(order)) => order.to_string(),
        entry => entry.setting(),
    };
    match summary.ns {
        ns if ns > 1e6 => format!("{setting} {:.1} ms", ns / 1e6),
        ns if ns > LAST_NS => format!("{setting} {:.0} us", ns / 1e3),
        _ => setting,
    }
    .trim()
    .to_owned()
}
