//! Logarithmic axes in pixels.

/// Values from `first` to `last`, at the pixels `from` and `to`.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    pub values: [f64; 2],
    pub pixels: [i32; 2],
}

impl Axis {
    /// Where a value is; those outside are at the ends.
    pub fn at(&self, value: f64) -> i32 {
        let [first, last] = self.values;
        let t = (value.max(first).min(last) / first).ln() / (last / first).ln();
        let [from, to] = self.pixels.map(f64::from);
        (from + t * (to - from)).round() as i32
    }

    /// Values to write, 1, 2 and 5 times powers of ten, or powers of ten alone.
    pub fn ticks(&self, only_powers: bool) -> Vec<f64> {
        let factors: &[f64] = if only_powers {
            &[1.0]
        } else {
            &[1.0, 2.0, 5.0]
        };
        self.marks(factors)
    }

    /// Values of faint lines.
    pub fn lines(&self) -> Vec<f64> {
        self.marks(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0])
    }

    fn marks(&self, factors: &[f64]) -> Vec<f64> {
        let [first, last] = self.values;
        let powers = first.log10().floor() as i32..=last.log10().ceil() as i32;
        let slack = 1.0 + 1e-9; // for ends that are marks themselves
        powers
            .flat_map(|power| factors.iter().map(move |f| f * 10f64.powi(power)))
            .filter(|v| *v >= first / slack && *v <= last * slack)
            .collect()
    }
}

/// A value without zeros that say nothing.
pub fn written(value: f64) -> String {
    if value >= 1e-3 {
        let text = format!("{value:.3}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_in_powers() {
        let axis = Axis {
            values: [1e-2, 10.0],
            pixels: [300, 0],
        };
        assert_eq!(
            [1e-3, 1e-2, 1.0, 20.0].map(|v| axis.at(v)),
            [300, 300, 100, 0]
        );
        let ticks: Vec<String> = axis.ticks(true).into_iter().map(written).collect();
        assert_eq!(ticks, ["0.01", "0.1", "1", "10"]);
        assert_eq!(written(1e-5), "1e-5");
    }
}
