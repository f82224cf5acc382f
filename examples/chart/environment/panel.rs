//! One panel: errors over roughness, or over time.

use super::series::{Method, Series};
use super::table::Row;
use crate::axis::{Axis, written};
use crate::labels::Rect;
use crate::marker::{Area, Failure};
use crate::text::{INK, style};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const FONT: i32 = 12;
/// The ends of the axes.
const ERRORS: [f64; 2] = [3e-3, 2.0];
const TIMES: [f64; 2] = [100.0, 1e6];
const ROUGHNESSES: [f64; 2] = [0.05, 1.05];

const GRID: RGBColor = RGBColor(228, 228, 228);

/// Whether a panel's errors are written beside it.
#[derive(Clone, Copy)]
pub struct ErrorAxis {
    pub has_labels: bool,
}

impl ErrorAxis {
    fn axis(frame: Rect) -> Axis {
        Axis {
            values: ERRORS,
            pixels: [frame.top + frame.height, frame.top],
        }
    }

    fn draw(self, area: &Area, frame: Rect) -> Result<(), Failure> {
        let axis = Self::axis(frame);
        for y in axis.lines().into_iter().map(|v| axis.at(v)) {
            let line = vec![(frame.left, y), (frame.left + frame.width, y)];
            area.draw(&PathElement::new(line, GRID))?;
        }
        let beside = style(FONT, INK, HPos::Right, VPos::Center);
        for value in axis.ticks(true).into_iter().filter(|_| self.has_labels) {
            area.draw_text(&written(value), &beside, (frame.left - 6, axis.at(value)))?;
        }
        Ok(())
    }
}

/// A line of the grid.
fn upright(area: &Area, frame: Rect, x: i32) -> Result<(), Failure> {
    let ends = vec![(x, frame.top), (x, frame.top + frame.height)];
    area.draw(&PathElement::new(ends, GRID))?;
    Ok(())
}

/// Every series' error over the roughness, and the truth's.
pub fn by_roughness(
    area: &Area,
    name: &str,
    rows: &[&Row],
    frame: Rect,
    errors: ErrorAxis,
) -> Result<(), Failure> {
    let x = |roughness: f64| {
        let t = (roughness - ROUGHNESSES[0]) / (ROUGHNESSES[1] - ROUGHNESSES[0]);
        frame.left + (t * f64::from(frame.width)).round() as i32
    };
    let y = |error: f64| ErrorAxis::axis(frame).at(error);
    let bottom = frame.top + frame.height;
    let below = style(FONT, INK, HPos::Center, VPos::Top);
    for roughness in (1..=10).map(|i| f64::from(i) / 10.0) {
        upright(area, frame, x(roughness))?;
        area.draw_text(&written(roughness), &below, (x(roughness), bottom + 5))?;
    }
    errors.draw(area, frame)?;
    close(area, frame, &format!("{name}: error over roughness"))?;

    let rough = || rows.iter().filter(|r| r.roughness > 0.0);
    let truth: Vec<(i32, i32)> = rough()
        .filter(|r| r.method == Method::SplitSum)
        .map(|r| (x(r.roughness), y(r.truth)))
        .collect();
    Method::truth_line(area, &truth)?;
    for series in Series::SHOWN {
        let places: Vec<(i32, i32)> = rough()
            .filter(|r| r.method == series.method && r.samples == series.samples)
            .map(|r| (x(r.roughness), y(r.rms)))
            .collect();
        series.line(area, &places)?;
        for place in places {
            series.marker(area, place)?;
        }
    }
    Ok(())
}

/// Every way's error over its time, both over all roughnesses.
pub fn by_time(
    area: &Area,
    name: &str,
    rows: &[&Row],
    frame: Rect,
    errors: ErrorAxis,
) -> Result<(), Failure> {
    let times = Axis {
        values: TIMES,
        pixels: [frame.left, frame.left + frame.width],
    };
    let bottom = frame.top + frame.height;
    for x in times.lines().into_iter().map(|v| times.at(v)) {
        upright(area, frame, x)?;
    }
    let below = style(FONT, INK, HPos::Center, VPos::Top);
    for (ns, label) in [(1e3, "1 us"), (1e4, "10 us"), (1e5, "100 us")] {
        area.draw_text(label, &below, (times.at(ns), bottom + 5))?;
    }
    errors.draw(area, frame)?;
    close(area, frame, &format!("{name}: error over time"))?;

    for method in Method::ALL {
        let places: Vec<(Series, (i32, i32))> = over_roughness(rows, method)
            .into_iter()
            .map(|(series, [ns, rms])| {
                let place = (times.at(ns), ErrorAxis::axis(frame).at(rms));
                (series, place)
            })
            .collect();
        let line: Vec<(i32, i32)> = places.iter().map(|(_, place)| *place).collect();
        if let Some((series, _)) = places.first() {
            series.line(area, &line)?;
        }
        for (series, (x, y)) in places {
            series.marker(area, (x, y))?;
            let samples = series.samples.to_string();
            match method {
                Method::Importance => {
                    let above = style(FONT, method.color(), HPos::Left, VPos::Bottom);
                    area.draw_text(&samples, &above, (x + 6, y - 4))?;
                }
                Method::Filtered => {
                    let below = style(FONT, method.color(), HPos::Right, VPos::Top);
                    area.draw_text(&samples, &below, (x - 5, y + 5))?;
                }
                Method::SplitSum => {}
            }
        }
    }
    Ok(())
}

/// For each number of samples, fewest first: mean ns and root mean square error.
fn over_roughness(rows: &[&Row], method: Method) -> Vec<(Series, [f64; 2])> {
    let of_method = || {
        rows.iter()
            .filter(move |r| r.method == method && r.roughness > 0.0)
    };
    let mut counts: Vec<u32> = of_method().map(|r| r.samples).collect();
    counts.sort_unstable();
    counts.dedup();
    let summary = |samples: u32| {
        let own: Vec<_> = of_method().filter(|r| r.samples == samples).collect();
        let count = own.len() as f64;
        let ns = own.iter().map(|r| r.ns).sum::<f64>() / count;
        let square = own.iter().map(|r| r.rms * r.rms).sum::<f64>() / count;
        (Series { method, samples }, [ns, square.sqrt()])
    };
    counts.into_iter().map(summary).collect()
}

/// The frame and its title.
fn close(area: &Area, frame: Rect, title: &str) -> Result<(), Failure> {
    let Rect {
        left,
        top,
        width,
        height,
    } = frame;
    area.draw(&Rectangle::new(
        [(left, top), (left + width, top + height)],
        INK,
    ))?;
    let above = style(FONT + 1, INK, HPos::Left, VPos::Bottom);
    area.draw_text(title, &above, (left, top - 5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_averaged_and_errors_squared_over_rough_rows() {
        let row = |roughness, samples, rms, ns| Row {
            environment: "studio".into(),
            roughness,
            method: Method::Filtered,
            samples,
            rms,
            truth: 0.0,
            ns,
        };
        let rows = [
            row(0.0, 16, 9.0, 9.0),
            row(0.1, 16, 0.6, 10.0),
            row(0.2, 16, 0.8, 30.0),
            row(0.1, 4, 1.0, 5.0),
        ];
        let rows: Vec<&Row> = rows.iter().collect();
        let all = over_roughness(&rows, Method::Filtered);
        assert_eq!(all.len(), 2);
        assert_eq!((all[0].0.samples, all[0].1), (4, [5.0, 1.0]));
        assert_eq!(all[1].1[0], 20.0);
        assert!((all[1].1[1] - 0.5f64.sqrt()).abs() < 1e-12);
    }
}
