//! docs/environment.svg: error and time of three ways to the reflection of an environment, from the table that
//! `pellicle_environment` writes.

use crate::shared::svg::{
    Area, FONT, Failure, INK, Panel, Pixel, beside, dashed, diamond, line, picture, style,
};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::error::Error;
use std::fs;
use std::path::Path;

const SIZE: (u32, u32) = (1000, 765);
/// The left edges of the legend's columns, and its first line.
const COLUMNS: [i32; 3] = [26, 290, 560];
const LEGEND_TOP: i32 = 92;
const LEGEND_LINE: i32 = 21;
/// Half the width of a marker.
const RADIUS: i32 = 5;

const TITLE: &str = "Reflection of an environment by rough gold: error against roughness and time";
const EXPLANATION: [&str; 2] = [
    "Root mean square error over a sphere's pixels, relative to the truth's, linear RGB. The truth is \
     importance sampling with 2048 pairs.",
    "Below: the same over all roughnesses from 0.1 to 1, and ns per pixel on one thread; the maps and the \
     table of the split sum are made before.",
];

const HEADER: &str = "environment,roughness,method,samples,relative_rms,bias,truth_standard_error,\
                      ns_per_pixel,importance_ns_for_same_error";

/// A way to the reflection.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Method {
    Importance,
    Filtered,
    SplitSum,
}

impl Method {
    const ALL: [Self; 3] = [Self::Importance, Self::Filtered, Self::SplitSum];

    fn color(self) -> RGBColor {
        match self {
            Self::Importance => RGBColor(0, 0, 0),
            Self::Filtered => RGBColor(0, 114, 178),
            Self::SplitSum => RGBColor(190, 70, 0),
        }
    }
}

/// A row of the table: one way to the reflection of one environment at one roughness.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    environment: String,
    roughness: f64,
    series: Series,
    /// The root mean square of the differences over that of the truth.
    rms: f64,
    /// That of the truth's standard errors.
    truth: f64,
    /// Per pixel.
    ns: f64,
}

/// All rows; the message names a line that is not one.
fn parse(text: &str) -> Result<Vec<Row>, String> {
    let mut lines = text.lines();
    if lines.next() != Some(HEADER) {
        return Err(format!("the table does not begin with {HEADER}"));
    }
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells.get(i)?.parse::<f64>().ok();
        let method = match *cells.get(2)? {
            "importance" => Method::Importance,
            "filtered" => Method::Filtered,
            "split_sum" => Method::SplitSum,
            _ => return None,
        };
        Some(Row {
            environment: cells[0].to_owned(),
            roughness: number(1)?,
            series: Series(method, cells[3].parse().ok()?),
            rms: number(4)?,
            truth: number(6)?,
            ns: number(7)?,
        })
    };
    lines
        .map(|line| row(line).ok_or_else(|| format!("not a row: {line}")))
        .collect()
}

/// A way with its number of samples, or of pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Series(Method, u32);

/// The series whose error is drawn over the roughness.
const SHOWN: [Series; 5] = [
    Series(Method::Importance, 16),
    Series(Method::Importance, 256),
    Series(Method::Filtered, 16),
    Series(Method::Filtered, 64),
    Series(Method::SplitSum, 1),
];

impl Series {
    fn title(self) -> String {
        match self {
            Self(Method::Importance, count) => format!("importance sampling, {count} pairs"),
            Self(Method::Filtered, count) => format!("filtered sampling, {count} samples"),
            Self(Method::SplitSum, _) => "split sum".into(),
        }
    }

    /// Its line and markers. Stroke and shape alone are enough in grey print; markers are filled where there are more
    /// samples.
    fn line(self, area: &Area, points: Vec<Pixel>) -> Result<(), Failure> {
        let color = self.0.color();
        match self.0 {
            Method::SplitSum => line(area, points, color.stroke_width(2)),
            Method::Filtered => dashed(area, points, 6, color),
            Method::Importance => line(area, points, color),
        }
    }

    fn marker(self, area: &Area, (x, y): Pixel) -> Result<(), Failure> {
        let (r, color) = (RADIUS, self.0.color());
        let inside = if self.1 > 16 { color } else { WHITE };
        let outline = color.stroke_width(2);
        match self.0 {
            Method::Importance => {
                let corners = [(x - r + 1, y - r + 1), (x + r - 1, y + r - 1)];
                area.draw(&Rectangle::new(corners, inside.filled()))?;
                area.draw(&Rectangle::new(corners, outline))
            }
            Method::Filtered => {
                area.draw(&Circle::new((x, y), r, inside.filled()))?;
                area.draw(&Circle::new((x, y), r, outline))
            }
            Method::SplitSum => area.draw(&Polygon::new(diamond((x, y), r + 2), color.filled())),
        }
    }
}

/// Reads environment.csv in `docs` and writes environment.svg beside it.
pub fn draw(docs: &Path) -> Result<(), Box<dyn Error>> {
    let rows = parse(&fs::read_to_string(docs.join("environment.csv"))?)?;
    fs::write(docs.join("environment.svg"), svg(&rows)?)?;
    Ok(())
}

fn svg(rows: &[Row]) -> Result<String, Failure> {
    picture(SIZE, TITLE, &EXPLANATION, |area| {
        legend(area)?;
        let mut environments: Vec<&str> = rows.iter().map(|row| row.environment.as_str()).collect();
        environments.dedup();
        for (i, name) in environments.into_iter().enumerate() {
            let own = rows
                .iter()
                .filter(|row| row.environment == name && row.roughness > 0.0);
            let own: Vec<&Row> = own.collect();
            let panel = |title, top, height| Panel {
                title,
                frame: [52 + 477 * i as i32, top, 456, height],
                errors: [3e-3, 2.0],
                has_error_labels: i == 0,
            };
            let title = format!("{name}: error over roughness");
            by_roughness(area, &panel(&title, 160, 290), &own)?;
            let title = format!("{name}: error over time");
            by_time(area, &panel(&title, 515, 210), &own)?;
        }
        Ok(())
    })
}

fn legend(area: &Area) -> Result<(), Failure> {
    let place = |i: usize| (COLUMNS[i / 2], LEGEND_TOP + LEGEND_LINE * (i % 2) as i32);
    let ends = |(x, y): Pixel| vec![(x - 10, y), (x + 10, y)];
    for (i, series) in SHOWN.into_iter().enumerate() {
        let at = place(i);
        series.line(area, ends(at))?;
        series.marker(area, at)?;
        beside(area, &series.title(), (at.0 + 16, at.1))?;
    }
    let at = place(SHOWN.len());
    dashed(area, ends(at), 2, INK)?;
    beside(area, "standard error of the truth", (at.0 + 16, at.1))
}

/// Every series' error over the roughness, and the truth's.
fn by_roughness(area: &Area, panel: &Panel, rows: &[&Row]) -> Result<(), Failure> {
    let at = panel.axes(area, 0.05..1.05, 12, &|roughness| format!("{roughness:.1}"))?;
    let of = |series: Series| rows.iter().filter(move |row| row.series == series);
    let truth = of(Series(Method::SplitSum, 1)).map(|row| at(row.roughness, row.truth));
    dashed(area, truth.collect(), 2, INK)?;
    for series in SHOWN {
        let places: Vec<Pixel> = of(series).map(|row| at(row.roughness, row.rms)).collect();
        series.line(area, places.clone())?;
        for place in places {
            series.marker(area, place)?;
        }
    }
    Ok(())
}

/// Every way's error over its time, both over all roughnesses.
fn by_time(area: &Area, panel: &Panel, rows: &[&Row]) -> Result<(), Failure> {
    let times = (100.0..1e6).log_scale();
    // Labels at the ends would run into those of the panel beside.
    let at = panel.axes(area, times, 5, &|ns| match ns {
        1e3..=1e5 => format!("{} us", ns / 1e3),
        _ => String::new(),
    })?;
    for method in Method::ALL {
        let found = over_roughness(rows, method);
        let places = found.iter().map(|(_, [ns, rms])| at(*ns, *rms));
        let places: Vec<Pixel> = places.collect();
        found[0].0.line(area, places.clone())?;
        for ((series, _), (x, y)) in found.into_iter().zip(places) {
            series.marker(area, (x, y))?;
            let ((dx, dy), horizontal, vertical) = match method {
                Method::Importance => ((6, -4), HPos::Left, VPos::Bottom),
                Method::Filtered => ((-5, 5), HPos::Right, VPos::Top),
                Method::SplitSum => continue,
            };
            let style = style(FONT, method.color(), horizontal, vertical);
            area.draw_text(&series.1.to_string(), &style, (x + dx, y + dy))?;
        }
    }
    Ok(())
}

/// For each number of samples, fewest first: mean ns and root mean square error.
fn over_roughness(rows: &[&Row], method: Method) -> Vec<(Series, [f64; 2])> {
    let of_method = || rows.iter().filter(|row| row.series.0 == method);
    let mut counts: Vec<u32> = of_method().map(|row| row.series.1).collect();
    counts.sort_unstable();
    counts.dedup();
    let summary = |samples: u32| {
        let own: Vec<_> = of_method().filter(|row| row.series.1 == samples).collect();
        let count = own.len() as f64;
        let ns = own.iter().map(|row| row.ns).sum::<f64>() / count;
        let square = own.iter().map(|row| row.rms * row.rms).sum::<f64>() / count;
        (Series(method, samples), [ns, square.sqrt()])
    };
    counts.into_iter().map(summary).collect()
}

#[test]
fn the_table_is_read_and_averaged() {
    let text = format!(
        "{HEADER}\nstudio,0.1,filtered,16,0.6,-2e-2,9e-3,10,1\nstudio,0.2,filtered,16,0.8,0,0,30,1\n\
         studio,0.1,filtered,4,1,0,0,5,1\n"
    );
    let rows = parse(&text).unwrap();
    assert_eq!(
        (rows[0].series, rows[0].truth),
        (Series(Method::Filtered, 16), 9e-3)
    );
    let all = over_roughness(&rows.iter().collect::<Vec<&Row>>(), Method::Filtered);
    assert_eq!(all[0], (Series(Method::Filtered, 4), [5.0, 1.0]));
    assert_eq!((all.len(), all[1].1[0]), (2, 20.0));
    assert!((all[1].1[1] - 0.5f64.sqrt()).abs() < 1e-12);
    for wrong in ["roughness\n", "studio,0.3,guess,1,1,1,1,1,", "studio"] {
        assert!(parse(&format!("{HEADER}\n{wrong}\n")).is_err());
    }
    assert!(parse("roughness\n").is_err());
}
