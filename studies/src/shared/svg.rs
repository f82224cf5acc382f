//! Pictures in SVG.

use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Where everything is drawn.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// Why drawing fails.
pub type Failure = DrawingAreaErrorKind<std::io::Error>;
/// Pixels, from the left upper corner.
pub type Pixel = (i32, i32);

/// The colour of text and frames.
pub const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(228, 228, 228);
/// The size of most texts, in pixels.
pub const FONT: i32 = 12;
/// The left margin, and the top of the first line below the title.
const MARGIN: i32 = 20;
const BELOW_TITLE: i32 = 40;
const LINE: i32 = 17;

/// A picture with a title and lines below it.
pub fn picture(
    size: (u32, u32),
    title: &str,
    explanation: &[&str],
    draw: impl FnOnce(&Area) -> Result<(), Failure>,
) -> Result<String, Failure> {
    let mut out = String::new();
    {
        let area = SVGBackend::with_string(&mut out, size).into_drawing_area();
        area.fill(&WHITE)?;
        area.draw_text(title, &style(20, INK, HPos::Left, VPos::Top), (MARGIN, 10))?;
        let small = style(FONT, INK, HPos::Left, VPos::Top);
        for (i, line) in explanation.iter().enumerate() {
            area.draw_text(line, &small, (MARGIN, BELOW_TITLE + LINE * i as i32))?;
        }
        draw(&area)?;
        area.present()?;
    }
    Ok(out)
}

/// Text of a size in pixels. The point at which it is drawn is its edge or middle.
pub fn style(size: i32, color: RGBColor, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    // The backend writes sizes divided by 1.24.
    let font = ("sans-serif", 1.24 * f64::from(size)).into_font();
    TextStyle {
        font,
        color: color.to_backend_color(),
        pos: Pos::new(horizontal, vertical),
    }
}

/// Draws text whose left end is at a point, in the middle of the line.
pub fn beside(area: &Area, text: &str, at: Pixel) -> Result<(), Failure> {
    area.draw_text(text, &style(FONT, INK, HPos::Left, VPos::Center), at)
}

/// The estimated width of a text, in pixels: there is no font to ask.
pub fn width(text: &str) -> i32 {
    (0.6 * f64::from(FONT) * text.chars().count() as f64).ceil() as i32
}

/// A line through points.
pub fn line(area: &Area, points: Vec<Pixel>, style: impl Into<ShapeStyle>) -> Result<(), Failure> {
    area.draw(&PathElement::new(points, style))
}

/// A line of dashes and gaps of the same length, in pixels.
pub fn dashed(
    area: &Area,
    points: Vec<Pixel>,
    length: i32,
    style: impl Into<ShapeStyle>,
) -> Result<(), Failure> {
    let style = style.into();
    area.draw(&DashedPathElement::new(points, length, length, style))
}

/// Standing on a corner, which is that far from the middle.
pub fn diamond((x, y): Pixel, reach: i32) -> Vec<Pixel> {
    vec![
        (x, y - reach),
        (x + reach, y),
        (x, y + reach),
        (x - reach, y),
        (x, y - reach),
    ]
}

/// A panel with axes: the error upwards by its logarithm.
pub struct Panel<'a> {
    pub title: &'a str,
    /// Left, top, width and height of its frame.
    pub frame: [i32; 4],
    pub errors: [f64; 2],
    pub has_error_labels: bool,
}

impl Panel<'_> {
    /// Draws grid, frame, labels and title. Returns where a pair of numbers is; those outside are at the ends.
    pub fn axes<'a, X>(
        &self,
        area: &Area<'a>,
        x: X,
        x_labels: usize,
        x_label: &dyn Fn(&f64) -> String,
    ) -> Result<impl Fn(f64, f64) -> Pixel + use<'a, X>, Failure>
    where
        X: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
    {
        const BESIDE: i32 = 44;
        const BELOW: i32 = 24;
        let [left, top, width, height] = self.frame;
        let outer = area
            .clone()
            .shrink((left - BESIDE, top), (width + BESIDE, height + BELOW));
        let [least, greatest] = self.errors;
        let mut chart = ChartBuilder::on(&outer)
            .x_label_area_size(BELOW)
            .y_label_area_size(BESIDE)
            .build_cartesian_2d(x, (least..greatest).log_scale())?;
        chart
            .configure_mesh()
            .bold_line_style(GRID)
            .light_line_style(GRID.mix(0.5))
            .axis_style(INK)
            .label_style(style(FONT, INK, HPos::Center, VPos::Center))
            .x_labels(x_labels)
            .x_label_formatter(&|value| x_label(value))
            .y_labels(8)
            .y_label_formatter(&|error| match self.has_error_labels {
                true => written(*error),
                false => String::new(),
            })
            .draw()?;
        area.draw(&Rectangle::new(
            [(left, top), (left + width, top + height)],
            INK,
        ))?;
        let above = style(FONT + 1, INK, HPos::Left, VPos::Bottom);
        area.draw_text(self.title, &above, (left, top - 5))?;
        Ok(move |x: f64, error: f64| chart.backend_coord(&(x, error.clamp(least, greatest))))
    }
}

/// A number as short as it can be.
pub fn written(value: f64) -> String {
    let [short, long] = [format!("{value:e}"), format!("{value}")];
    if long.len() <= 5 { long } else { short }
}

#[test]
fn numbers_are_short() {
    assert_eq!(
        [2e-4, 0.02, 1e6, 1e8, 0.0].map(written),
        ["2e-4", "0.02", "1e6", "1e8", "0"]
    );
}
