//! The distance of colours from the truth: in linear RGB and as the eye sees it.

use crate::shared::stack::{clipped, clipped_errors};
use deltae::{DE2000, DeltaE, LabValue};

/// Differences of many colours from the truth, both clipped to [0, 1].
#[derive(Clone, Debug, Default)]
pub struct Errors {
    squares: f64,
    greatest: f64,
    /// CIEDE2000 of each colour.
    delta_e: Vec<f64>,
}

impl Errors {
    /// Adds one colour.
    pub fn add(&mut self, found: [f32; 3], truth: [f64; 3]) {
        let found = clipped(found);
        let errors = clipped_errors(found, truth);
        self.squares += errors.map(|error| error * error).iter().sum::<f64>();
        self.greatest = errors.into_iter().fold(self.greatest, f64::max);
        let truth = truth.map(|channel| channel.clamp(0.0, 1.0));
        self.delta_e.push(difference(found.map(f64::from), truth));
    }

    /// Adds one colour that is right by definition.
    pub fn add_exact(&mut self) {
        self.delta_e.push(0.0);
    }

    /// Adds all of another's.
    pub fn join(&mut self, other: &Self) {
        self.squares += other.squares;
        self.greatest = self.greatest.max(other.greatest);
        self.delta_e.extend(&other.delta_e);
    }

    /// The number of colours.
    pub fn count(&self) -> usize {
        self.delta_e.len()
    }

    /// Root of the mean square over all channels.
    pub fn rms(&self) -> f64 {
        (self.squares / (3 * self.delta_e.len().max(1)) as f64).sqrt()
    }

    /// Of any channel.
    pub fn max(&self) -> f64 {
        self.greatest
    }

    /// Mean CIEDE2000.
    pub fn mean_delta_e(&self) -> f64 {
        self.delta_e.iter().sum::<f64>() / self.delta_e.len().max(1) as f64
    }

    /// The CIEDE2000 that 95 % of the colours stay within.
    pub fn delta_e_95(&self) -> f64 {
        let mut sorted = self.delta_e.clone();
        sorted.sort_by(f64::total_cmp);
        let rank = (0.95 * sorted.len() as f64).ceil() as usize;
        sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0)
    }
}

/// CIEDE2000 of two linear Rec.709 colours.
fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    f64::from(*DeltaE::new(lab(a), lab(b), DE2000).value())
}

/// CIE 1976 L*a*b* of a linear Rec.709 colour (IEC 61966-2-1, table of primaries), white being D65.
pub fn lab(rgb: [f64; 3]) -> LabValue {
    const TO_XYZ: [[f64; 3]; 3] = [
        [0.4124, 0.3576, 0.1805],
        [0.2126, 0.7152, 0.0722],
        [0.0193, 0.1192, 0.9505],
    ];
    let [x, y, z] = TO_XYZ.map(|[r, g, b]| {
        let t = (r * rgb[0] + g * rgb[1] + b * rgb[2]) / (r + g + b);
        if t > 216.0 / 24389.0 {
            t.cbrt()
        } else {
            (t * 24389.0 / 27.0 + 16.0) / 116.0
        }
    });
    LabValue {
        l: (116.0 * y - 16.0) as f32,
        a: (500.0 * (x - y)) as f32,
        b: (200.0 * (y - z)) as f32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_clipped_channels() {
        let mut errors = Errors::default();
        errors.add([1.5, 0.5, -1.0], [1.2, 0.3, -0.2]);
        assert!((errors.max() - 0.2).abs() < 1e-7);
        assert!((errors.rms() - 0.2 / 3f64.sqrt()).abs() < 1e-7);
    }

    /// Black and white are 100 apart; a pair of Sharma, Wu and Dalal 2005, table 1, guards the
    /// formula itself.
    #[test]
    fn sees_as_the_standard_does() {
        assert!((difference([0.0; 3], [1.0; 3]) - 100.0).abs() < 1e-2);
        let lab = |a, b| LabValue { l: 50.0, a, b };
        let [a, b] = [lab(2.6772, -79.7751), lab(0.0, -82.7485)];
        assert!((DeltaE::new(a, b, DE2000).value() - 2.0425).abs() < 1e-4);
    }

    #[test]
    fn takes_the_value_that_95_of_100_stay_within() {
        let errors = Errors {
            delta_e: (1..=100).rev().map(f64::from).collect(),
            ..Errors::default()
        };
        assert_eq!(errors.delta_e_95(), 95.0);
        assert_eq!(errors.mean_delta_e(), 50.5);
    }
}
