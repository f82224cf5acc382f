//! The distance of colours from the truth: in linear RGB and as the eye sees it.

use crate::shared::stack::{clipped, clipped_errors};
use palette::color_difference::Ciede2000;
use palette::white_point::D65;
use palette::{FromColor, Lab, LinSrgb};

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

/// CIEDE2000 of two linear Rec.709 colours, white being D65.
fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [a, b] = [a, b].map(|rgb| Lab::<D65, f64>::from_color(LinSrgb::from(rgb)));
    a.difference(b)
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
        let [a, b] =
            [(2.6772, -79.7751), (0.0, -82.7485)].map(|(a, b)| Lab::<D65, f64>::new(50.0, a, b));
        assert!((a.difference(b) - 2.0425).abs() < 1e-4);
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
