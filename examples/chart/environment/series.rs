//! A shape, a stroke and a colour for each way: shape and stroke alone must do in grey print.

use crate::marker::{Area, Failure};
use crate::text::INK;
use plotters::prelude::*;

/// A way to the reflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    Importance,
    Filtered,
    SplitSum,
}

/// A way with its number of samples, or of pairs.
#[derive(Clone, Copy, Debug)]
pub struct Series {
    pub method: Method,
    pub samples: u32,
}

/// Half the width of a marker.
const RADIUS: i32 = 5;

impl Method {
    pub const ALL: [Self; 3] = [Self::Importance, Self::Filtered, Self::SplitSum];

    /// By its name in the table.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "importance" => Some(Self::Importance),
            "filtered" => Some(Self::Filtered),
            "split_sum" => Some(Self::SplitSum),
            _ => None,
        }
    }

    pub fn color(self) -> RGBColor {
        match self {
            Self::Importance => RGBColor(0, 0, 0),
            Self::Filtered => RGBColor(0, 114, 178),
            Self::SplitSum => RGBColor(190, 70, 0),
        }
    }

    /// The line of the truth's standard error.
    pub fn truth_line(area: &Area, points: &[(i32, i32)]) -> Result<(), Failure> {
        dashed(area, points, 2, INK.stroke_width(1))
    }
}

impl Series {
    /// Those whose error is drawn over the roughness.
    pub const SHOWN: [Self; 5] = [
        Self::new(Method::Importance, 16),
        Self::new(Method::Importance, 256),
        Self::new(Method::Filtered, 16),
        Self::new(Method::Filtered, 64),
        Self::new(Method::SplitSum, 1),
    ];

    const fn new(method: Method, samples: u32) -> Self {
        Self { method, samples }
    }

    pub fn title(self) -> String {
        match self.method {
            Method::Importance => format!("importance sampling, {} pairs", self.samples),
            Method::Filtered => format!("filtered sampling, {} samples", self.samples),
            Method::SplitSum => "split sum".into(),
        }
    }

    /// Its line through some points.
    pub fn line(self, area: &Area, points: &[(i32, i32)]) -> Result<(), Failure> {
        let stroke = self.method.color().stroke_width(2);
        match self.method {
            Method::SplitSum => area.draw(&PathElement::new(points.to_vec(), stroke)),
            Method::Filtered => dashed(area, points, 6, self.method.color().stroke_width(1)),
            Method::Importance => {
                let thin = self.method.color().stroke_width(1);
                area.draw(&PathElement::new(points.to_vec(), thin))
            }
        }
    }

    /// Its marker: filled where there are more samples.
    pub fn marker(self, area: &Area, (x, y): (i32, i32)) -> Result<(), Failure> {
        let r = RADIUS;
        let color = self.method.color();
        let line = color.stroke_width(2);
        let inside = if self.samples > 16 { color } else { WHITE };
        match self.method {
            Method::Importance => {
                let corners = [(x - r + 1, y - r + 1), (x + r - 1, y + r - 1)];
                area.draw(&Rectangle::new(corners, inside.filled()))?;
                area.draw(&Rectangle::new(corners, line))
            }
            Method::Filtered => {
                area.draw(&Circle::new((x, y), r, inside.filled()))?;
                area.draw(&Circle::new((x, y), r, line))
            }
            Method::SplitSum => {
                let corners = vec![
                    (x, y - r - 2),
                    (x + r + 2, y),
                    (x, y + r + 2),
                    (x - r - 2, y),
                ];
                area.draw(&Polygon::new(corners, color.filled()))
            }
        }
    }
}

/// Dashes as long as the gaps between them, in pixels, along a line.
fn dashed(
    area: &Area,
    points: &[(i32, i32)],
    length: i32,
    style: ShapeStyle,
) -> Result<(), Failure> {
    for dash in dashes(points, f64::from(length)) {
        area.draw(&PathElement::new(dash.to_vec(), style))?;
    }
    Ok(())
}

/// Both ends of each dash; one that reaches a corner ends there and goes on after it.
fn dashes(points: &[(i32, i32)], length: f64) -> Vec<[(i32, i32); 2]> {
    let mut dashes = Vec::new();
    let mut before = 0.0; // along the line
    for ends in points.windows(2) {
        let [from, to] = [ends[0], ends[1]].map(|(x, y)| [f64::from(x), f64::from(y)]);
        let span = (to[0] - from[0]).hypot(to[1] - from[1]);
        let at = |s: f64| {
            let t = (s - before).clamp(0.0, span) / span;
            let [x, y] = [0, 1].map(|i| (from[i] + t * (to[i] - from[i])).round() as i32);
            (x, y)
        };
        let mut start = (before / (2.0 * length)).floor() * 2.0 * length;
        while start < before + span {
            if start + length > before {
                dashes.push([at(start), at(start + length)]);
            }
            start += 2.0 * length;
        }
        before += span;
    }
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_go_on_around_corners() {
        let found = dashes(&[(0, 0), (15, 0), (15, 20)], 10.0);
        assert_eq!(
            found,
            [[(0, 0), (10, 0)], [(15, 5), (15, 15)]],
            "dashes at 0 to 10 and 20 to 30 of 35"
        );
        let found = dashes(&[(0, 0), (5, 0), (5, 5)], 10.0);
        assert_eq!(found, [[(0, 0), (5, 0)], [(5, 0), (5, 5)]]);
    }
}
