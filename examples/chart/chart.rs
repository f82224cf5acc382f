//! docs/chart.svg: a large panel, four small ones, and what the markers mean.

use crate::contest::{Cell, Summary, constant, shared, summaries};
use crate::entry::Family;
use crate::labels::Rect;
use crate::marker::{Area, Failure, draw_level, level_title};
use crate::panel::Panel;
use crate::suite::{RANGES, Range};
use crate::text::{INK, style, width};
use pellicle::num::Level;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const SIZE: (u32, u32) = (1000, 990);
const FONT: i32 = 12;
const SMALL_FONT: i32 = 11;
/// The left edges of the legend's columns, and its first line.
const COLUMNS: [i32; 3] = [26, 310, 720];
const LEGEND_TOP: i32 = 92;
const LEGEND_LINE: i32 = 21;

const IN_BATCHES: &str = "in batches:";
const TITLE: &str = "Colour of a thin film: time against error";
const EXPLANATION: [&str; 2] = [
    "Marker: RMS error of linear RGB in [0, 1], and ns per colour on one core, one call at a time, \
     median of the films.",
    "Whiskers: greatest error, slowest film. Random thicknesses, and angles down to grazing. \
     The grey line joins those that none beats in both.",
];

/// The chart as SVG.
pub fn svg(cells: &[Cell]) -> Result<String, Failure> {
    let mut out = String::new();
    {
        let area = SVGBackend::with_string(&mut out, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let title = style(20, INK, HPos::Left, VPos::Top);
        area.draw_text(TITLE, &title, (20, 10))?;
        let small = style(FONT, INK, HPos::Left, VPos::Top);
        for (i, line) in EXPLANATION.iter().enumerate() {
            area.draw_text(line, &small, (20, 40 + 17 * i as i32))?;
        }
        legend(&area)?;
        let title = format!("{}, ten films", RANGES[1].name);
        let large = Panel {
            title: &title,
            summaries: &summaries(shared(cells, RANGES[1])),
            frame: Rect {
                left: 52,
                top: 182,
                width: 933,
                height: 436,
            },
            beyond: 110,
            font: FONT,
            labels_all: true,
            has_error_axis: true,
        };
        large.draw(&area)?;
        for (i, (title, summaries)) in small_panels(cells).iter().enumerate() {
            let panel = Panel {
                title,
                summaries,
                frame: Rect {
                    left: 52 + 237 * i as i32,
                    top: 690,
                    width: 222,
                    height: 260,
                },
                beyond: 38,
                font: SMALL_FONT,
                labels_all: false,
                has_error_axis: i == 0,
            };
            panel.draw(&area)?;
        }
        area.present()?;
    }
    Ok(out)
}

/// Titles and contents of the small panels.
fn small_panels(cells: &[Cell]) -> [(String, Vec<Summary>); 4] {
    let [thin, common, thick, thickest] = RANGES;
    let all = |range: Range| {
        let title = format!("{}, ten films", range.name);
        (title, summaries(shared(cells, range)))
    };
    let title = format!("{}, no dispersion", common.name);
    let constant = (title, summaries(constant(cells, common)));
    [all(thin), all(thick), all(thickest), constant]
}

fn legend(area: &Area) -> Result<(), Failure> {
    for (i, family) in Family::ALL.into_iter().enumerate() {
        let (column, line) = (i / 3, i % 3);
        let at = (COLUMNS[column], LEGEND_TOP + LEGEND_LINE * line as i32);
        family.draw(area, at)?;
        let beside = style(FONT, INK, HPos::Left, VPos::Center);
        area.draw_text(family.title(), &beside, (at.0 + 13, at.1))?;
    }
    batch_legend(area)
}

/// What the levels' markers mean, in the place that families leave.
fn batch_legend(area: &Area) -> Result<(), Failure> {
    let mut at = (COLUMNS[2], LEGEND_TOP + LEGEND_LINE * 2);
    let beside = style(FONT, INK, HPos::Left, VPos::Center);
    area.draw_text(IN_BATCHES, &beside, (at.0 - 5, at.1))?;
    at.0 += width(IN_BATCHES, FONT) + 8;
    for level in Level::all() {
        draw_level(area, level, Family::Planned.color(), at)?;
        area.draw_text(level_title(level), &beside, (at.0 + 12, at.1))?;
        at.0 += width(level_title(level), FONT) + 28;
    }
    Ok(())
}
