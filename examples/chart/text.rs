//! Text: its style and its estimated width.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Of text and frames.
pub const INK: RGBColor = RGBColor(40, 40, 40);

/// Of a size in pixels; the point it is drawn at is at `horizontal` and `vertical` on it.
pub fn style(size: i32, color: RGBColor, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    // The backend writes sizes divided by 1.24.
    let font = ("sans-serif", 1.24 * f64::from(size)).into_font();
    TextStyle {
        font,
        color: color.to_backend_color(),
        pos: Pos::new(horizontal, vertical),
    }
}

/// About how wide a text is, in pixels: no font is at hand.
pub fn width(content: &str, size: i32) -> i32 {
    (0.6 * f64::from(size) * content.chars().count() as f64).ceil() as i32
}
