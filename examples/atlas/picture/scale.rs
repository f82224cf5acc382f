//! The one colour scale of all maps: classes by powers of ten, from light to dark.

use plotters::prelude::*;

/// Errors up to the first bound are in class 0, those beyond the last in the last class. The third is
/// the tolerance of films by default.
pub const BOUNDS: [f64; 5] = [2e-5, 2e-4, 2e-3, 2e-2, 0.2];
pub const CLASSES: usize = BOUNDS.len() + 1;

/// The class of an error; the last for what is not a number.
pub fn class(error: f64) -> usize {
    let is_within = |bound: &f64| error <= *bound;
    BOUNDS.iter().position(is_within).unwrap_or(BOUNDS.len())
}

/// Viridis (Smith and van der Walt 2015) from its light end: lightness alone tells the classes apart.
pub fn color(class: usize) -> RGBColor {
    let dark = class as f64 / (CLASSES - 1) as f64;
    ViridisRGB.get_color(1.0 - dark)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Luminance of sRGB (IEC 61966-2-1) as lightness L* (CIE 1976).
    fn lightness(RGBColor(r, g, b): RGBColor) -> f64 {
        let linear = |x: u8| {
            let x = f64::from(x) / 255.0;
            if x <= 0.04045 {
                x / 12.92
            } else {
                ((x + 0.055) / 1.055).powf(2.4)
            }
        };
        let y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        if y > 216.0 / 24389.0 {
            116.0 * y.cbrt() - 16.0
        } else {
            y * 24389.0 / 27.0
        }
    }

    /// Printed in grey, a greater error is darker, and by enough to be seen.
    #[test]
    fn greater_errors_are_darker() {
        let along: Vec<f64> = (0..CLASSES).map(|class| lightness(color(class))).collect();
        assert!(
            along.windows(2).all(|pair| pair[0] - pair[1] > 10.0),
            "{along:?}"
        );
        assert_eq!(
            [0.0, 2e-3, 2.1e-3, 1.0, f64::NAN].map(class),
            [0, 2, 3, 5, 5]
        );
    }
}
