//! docs/environment.svg: error and time of three ways to the reflection of an environment, from the
//! table that `pellicle_environment` writes.

mod panel;
mod series;
mod table;

use crate::labels::Rect;
use crate::marker::{Area, Failure};
use crate::text::{INK, style};
use panel::{ErrorAxis, by_roughness, by_time};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use series::{Method, Series};
use std::path::Path;
use std::{error, fs};
use table::Row;

const SIZE: (u32, u32) = (1000, 765);
const FONT: i32 = 12;
/// The left edges of the legend's columns, and its first line.
const COLUMNS: [i32; 3] = [26, 290, 560];
const LEGEND_TOP: i32 = 92;
const LEGEND_LINE: i32 = 21;

const TITLE: &str = "Reflection of an environment by rough gold: error against roughness and time";
const EXPLANATION: [&str; 2] = [
    "Root mean square error over a sphere's pixels, relative to the truth's, linear RGB. The truth is \
     importance sampling with 2048 pairs.",
    "Below: the same over all roughnesses from 0.1 to 1, and ns per pixel on one thread; the maps and the \
     table of the split sum are made before.",
];

/// Reads environment.csv in `docs` and writes environment.svg beside it.
pub fn draw(docs: &Path) -> Result<(), Box<dyn error::Error>> {
    let rows = table::parse(&fs::read_to_string(docs.join("environment.csv"))?)?;
    fs::write(docs.join("environment.svg"), svg(&rows)?)?;
    Ok(())
}

fn svg(rows: &[Row]) -> Result<String, Failure> {
    let mut out = String::new();
    {
        let area = SVGBackend::with_string(&mut out, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        area.draw_text(TITLE, &style(20, INK, HPos::Left, VPos::Top), (20, 10))?;
        let small = style(FONT, INK, HPos::Left, VPos::Top);
        for (i, line) in EXPLANATION.iter().enumerate() {
            area.draw_text(line, &small, (20, 40 + 17 * i as i32))?;
        }
        legend(&area)?;
        for (i, name) in table::environments(rows).iter().enumerate() {
            let rows: Vec<&Row> = rows.iter().filter(|r| r.environment == *name).collect();
            let errors = ErrorAxis { has_labels: i == 0 };
            let frame = |top, height| Rect {
                left: 52 + 477 * i as i32,
                top,
                width: 456,
                height,
            };
            by_roughness(&area, name, &rows, frame(160, 290), errors)?;
            by_time(&area, name, &rows, frame(515, 210), errors)?;
        }
        area.present()?;
    }
    Ok(out)
}

fn legend(area: &Area) -> Result<(), Failure> {
    let beside = style(FONT, INK, HPos::Left, VPos::Center);
    for (i, series) in Series::SHOWN.iter().enumerate() {
        let at = (COLUMNS[i / 2], LEGEND_TOP + LEGEND_LINE * (i % 2) as i32);
        series.line(area, &[(at.0 - 10, at.1), (at.0 + 10, at.1)])?;
        series.marker(area, at)?;
        area.draw_text(&series.title(), &beside, (at.0 + 16, at.1))?;
    }
    let at = (COLUMNS[2], LEGEND_TOP + LEGEND_LINE);
    Method::truth_line(area, &[(at.0 - 10, at.1), (at.0 + 10, at.1)])?;
    area.draw_text("standard error of the truth", &beside, (at.0 + 16, at.1))
}
