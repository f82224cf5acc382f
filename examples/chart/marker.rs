//! A shape and a colour for each family: the shape alone must do in grey print.

use crate::entry::Family;
use pellicle::num::Level;
use plotters::prelude::*;

/// Where everything is drawn.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
/// How drawing fails.
pub type Failure = DrawingAreaErrorKind<std::io::Error>;

/// Half the width of a marker.
pub const RADIUS: i32 = 5;

impl Family {
    pub fn color(self) -> RGBColor {
        match self {
            Self::TwoBeam => RGBColor(0, 0, 0),
            Self::AiryRgb => RGBColor(90, 90, 90),
            Self::Quadrature => RGBColor(0, 114, 178),
            Self::Bands => RGBColor(0, 140, 100),
            Self::Harmonics => RGBColor(190, 70, 0),
            Self::Planned => RGBColor(190, 20, 120),
            Self::Reference => RGBColor(0, 0, 0),
        }
    }

    /// Draws the family's marker.
    pub fn draw(self, area: &Area, (x, y): (i32, i32)) -> Result<(), Failure> {
        let r = RADIUS;
        let color = self.color();
        let line = color.stroke_width(2);
        let stroke = |points: Vec<(i32, i32)>| area.draw(&PathElement::new(points, line));
        let fill = |points: Vec<(i32, i32)>| area.draw(&Polygon::new(points, color.filled()));
        match self {
            Self::TwoBeam => {
                stroke(vec![(x - r, y - r), (x + r, y + r)])?;
                stroke(vec![(x - r, y + r), (x + r, y - r)])
            }
            Self::AiryRgb => {
                stroke(vec![(x - r - 1, y), (x + r + 1, y)])?;
                stroke(vec![(x, y - r - 1), (x, y + r + 1)])
            }
            Self::Quadrature => {
                let corners = vec![(x, y - r - 1), (x + r, y + r - 1), (x - r, y + r - 1)];
                let outline = corners.iter().chain(&corners[..2]).copied().collect();
                area.draw(&Polygon::new(corners, WHITE.filled()))?;
                stroke(outline)
            }
            Self::Bands => area.draw(&Rectangle::new(
                [(x - r + 1, y - r + 1), (x + r - 1, y + r - 1)],
                color.filled(),
            )),
            Self::Harmonics => area.draw(&Circle::new((x, y), r, color.filled())),
            Self::Planned => fill(diamond((x, y), r + 2)),
            Self::Reference => fill(star(x, y)),
        }
    }
}

/// Draws the marker of a batch at a level of instructions: the wider the lanes, the smaller, so that levels
/// that are equally fast show inside one another.
pub fn draw_level(
    area: &Area,
    level: Level,
    color: RGBColor,
    at: (i32, i32),
) -> Result<(), Failure> {
    match level.name() {
        "avx512" => area.draw(&Polygon::new(diamond(at, 3), color.filled())),
        "avx2" => outline(area, diamond(at, 6), color),
        _ => outline(area, diamond(at, 9), color),
    }
}

/// How a level is written.
pub fn level_title(level: Level) -> &'static str {
    match level.name() {
        "avx512" => "AVX-512",
        "avx2" => "AVX2",
        "sse2" => "SSE2",
        "neon" => "NEON",
        other => other,
    }
}

fn outline(area: &Area, corners: Vec<(i32, i32)>, color: RGBColor) -> Result<(), Failure> {
    let closed: Vec<_> = corners.iter().chain(&corners[..1]).copied().collect();
    area.draw(&PathElement::new(closed, color.stroke_width(1)))
}

/// Standing on a corner, from its middle so far to each.
fn diamond((x, y): (i32, i32), reach: i32) -> Vec<(i32, i32)> {
    vec![
        (x, y - reach),
        (x + reach, y),
        (x, y + reach),
        (x - reach, y),
    ]
}

/// A star with five points.
fn star(x: i32, y: i32) -> Vec<(i32, i32)> {
    (0..10)
        .map(|i| {
            let angle = f64::from(i) * std::f64::consts::PI / 5.0;
            let radius = if i % 2 == 0 { 9.0 } else { 3.8 };
            let (sin, cos) = angle.sin_cos();
            (
                x + (radius * sin).round() as i32,
                y - (radius * cos).round() as i32,
            )
        })
        .collect()
}
