//! The spectrum of a stack at one wavelength, and its integrals over the channels.

use super::Complex;

/// The stack's response and the weights of the channels at one wavelength.
#[derive(Clone, Copy)]
pub(super) struct SpectrumNode {
    pub weights: [f64; 3],
    pub reflectance: f64,
    pub transmittance: f64,
    pub poles: [Complex<f64>; 2],
}

/// Integrals of the weights, of the weights times R and of the weights times T.
#[derive(Clone, Copy, Default)]
pub(super) struct Sums {
    pub white: [f64; 3],
    pub reflectance: [f64; 3],
    pub transmittance: [f64; 3],
}

impl Sums {
    pub fn add(&mut self, sample: &SpectrumNode, width: f64) {
        for c in 0..3 {
            let weight = sample.weights[c] * width;
            self.white[c] += weight;
            self.reflectance[c] += weight * sample.reflectance;
            self.transmittance[c] += weight * sample.transmittance;
        }
    }

    /// The trapezoid rule after halving every interval: the mean of the trapezoid and the midpoint rule
    /// before.
    pub fn halved(&self, midpoints: &Self) -> Self {
        let mean = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|c| 0.5 * (a[c] + b[c]));
        Self {
            white: mean(self.white, midpoints.white),
            reflectance: mean(self.reflectance, midpoints.reflectance),
            transmittance: mean(self.transmittance, midpoints.transmittance),
        }
    }

    /// Simpson's rule, for the trapezoid rule with every interval halved and the one before (Richardson 1911).
    pub fn extrapolated(&self, before: &Self) -> Self {
        let third = |fine: [f64; 3], coarse: [f64; 3]| {
            std::array::from_fn(|c| fine[c] + (fine[c] - coarse[c]) / 3.0)
        };
        Self {
            white: third(self.white, before.white),
            reflectance: third(self.reflectance, before.reflectance),
            transmittance: third(self.transmittance, before.transmittance),
        }
    }

    /// Reflectance and transmittance per channel, normalised by the weights.
    pub fn colors(&self) -> [[f64; 3]; 2] {
        [self.reflectance, self.transmittance]
            .map(|sum| std::array::from_fn(|c| sum[c] / self.white[c]))
    }
}
