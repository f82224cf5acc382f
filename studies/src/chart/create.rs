//! docs/create.svg: how long films take to create, over the random stacks of `./x check film_cliffs`.

use crate::film_cliffs::suites::random_suites;
use crate::film_cliffs::{self, Outcome};
use crate::shared::markdown::table;
use crate::shared::svg::{
    Area, FONT, Failure, INK, Panel, Pixel, beside, dashed, diamond, line, picture, style,
};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// The tolerance of the films: the default.
pub const TOLERANCE: f64 = 2e-3;

const SIZE: (u32, u32) = (1000, 580);
const TITLE: &str = "How long films take to create: random stacks, one core, tolerance 2e-3";
const EXPLANATION: [&str; 2] = [
    "Every marker is a stack of one to five layers; the stacks of a suite are sorted by their time. Filled markers: the \
     median and the worst.",
    "Upwards: processor time of create(), ms. To the right: share of the suite's stacks that take no longer, %.",
];
const FRAME: [i32; 4] = [60, 140, 920, 380];
/// The ends of the axis of times, ms.
const TIMES: [f64; 2] = [1.0, 3e4];
const RADIUS: i32 = 4;

/// The films of a suite, quickest first.
pub struct Sorted {
    pub name: &'static str,
    films: Vec<Outcome>,
}

/// Creates all films.
pub fn run() -> Vec<Sorted> {
    eprintln!("create() times");
    let suites = random_suites().into_iter().map(|suite| {
        let mut films = film_cliffs::run(&suite, TOLERANCE);
        films.sort_by(|a, b| a.create_ms.total_cmp(&b.create_ms));
        let name = suite.name;
        Sorted { name, films }
    });
    suites.collect()
}

impl Sorted {
    fn median(&self) -> usize {
        self.films.len() / 2
    }

    fn worst(&self) -> &Outcome {
        self.films.last().expect("a suite has films")
    }
}

/// How the suite of that number is drawn; stroke and shape are enough in grey print.
fn color(suite: usize) -> RGBColor {
    [
        RGBColor(0, 0, 0),
        RGBColor(0, 114, 178),
        RGBColor(190, 70, 0),
    ][suite % 3]
}

fn stroke(area: &Area, suite: usize, points: Vec<Pixel>) -> Result<(), Failure> {
    match suite {
        0 => line(area, points, color(suite).stroke_width(2)),
        1 => dashed(area, points, 6, color(suite)),
        _ => line(area, points, color(suite)),
    }
}

fn marker(area: &Area, suite: usize, (x, y): Pixel, is_filled: bool) -> Result<(), Failure> {
    let r = if is_filled { RADIUS + 2 } else { RADIUS };
    let color = color(suite);
    let inside = if is_filled { color } else { WHITE };
    let corners = match suite {
        0 => {
            area.draw(&Circle::new((x, y), r, inside.filled()))?;
            return area.draw(&Circle::new((x, y), r, color));
        }
        1 => vec![
            (x - r, y - r),
            (x + r, y - r),
            (x + r, y + r),
            (x - r, y + r),
            (x - r, y - r),
        ],
        _ => diamond((x, y), r + 2),
    };
    area.draw(&Polygon::new(corners.clone(), inside.filled()))?;
    line(area, corners, color)
}

/// The picture as SVG.
pub fn svg(suites: &[Sorted]) -> Result<String, Failure> {
    picture(SIZE, TITLE, &EXPLANATION, |area| {
        let panel = Panel {
            title: "create(), ms",
            frame: FRAME,
            errors: TIMES,
            has_error_labels: true,
        };
        let at = panel.axes(area, 0.0..112.0, 12, &|share| match share {
            0.0..=100.0 => format!("{share} %"),
            _ => String::new(),
        })?;
        for (i, suite) in suites.iter().enumerate() {
            let legend = ([32, 235, 600][i % 3], 94);
            stroke(
                area,
                i,
                vec![(legend.0 - 12, legend.1), (legend.0 + 12, legend.1)],
            )?;
            marker(area, i, legend, true)?;
            beside(area, suite.name, (legend.0 + 18, legend.1))?;

            let count = suite.films.len();
            let place = |rank: usize| {
                let share = 100.0 * (rank + 1) as f64 / count as f64;
                at(share, suite.films[rank].create_ms)
            };
            stroke(area, i, (0..count).map(place).collect())?;
            let named = [(suite.median(), "median"), (count - 1, "worst")];
            for rank in 0..count {
                marker(
                    area,
                    i,
                    place(rank),
                    named.iter().any(|(named, _)| *named == rank),
                )?;
            }
            for (rank, name) in named {
                let (x, y) = place(rank);
                let text = format!("{name} {}", milliseconds(suite.films[rank].create_ms));
                // The lines rise: below and to the right of a point is free.
                let (x, y) = match name {
                    "worst" => (x + 11, y),
                    _ => (x + 8, y + 12),
                };
                let style = style(FONT, color(i), HPos::Left, VPos::Center);
                area.draw_text(&text, &style, (x, y))?;
            }
        }
        let under = style(FONT, INK, HPos::Center, VPos::Top);
        let middle = (FRAME[0] + FRAME[2] / 2, FRAME[1] + FRAME[3] + 30);
        area.draw_text("share of the suite's stacks", &under, middle)
    })
}

/// The same in figures.
pub fn markdown(suites: &[Sorted]) -> String {
    let rows = suites.iter().map(|suite| {
        let refused = suite.films.iter().filter(|film| film.film.is_err()).count();
        let worst = suite.worst();
        vec![
            suite.name.to_owned(),
            suite.films.len().to_string(),
            refused.to_string(),
            milliseconds(suite.films[suite.median()].create_ms),
            milliseconds(worst.create_ms),
            worst.name.clone(),
        ]
    });
    table(
        "suite | >stacks | >refused | >median | >worst | the worst stack",
        rows,
    )
}

/// Two digits.
fn milliseconds(ms: f64) -> String {
    match ms {
        1e3.. => format!("{:.1} s", ms / 1e3),
        9.95.. => format!("{ms:.0} ms"),
        _ => format!("{ms:.1} ms"),
    }
}

#[test]
fn durations_have_two_digits() {
    assert_eq!(
        [0.42, 9.96, 21.4, 3210.0].map(milliseconds),
        ["0.4 ms", "10 ms", "21 ms", "3.2 s"]
    );
}
