//! Axes of the maps.

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    Linear,
    /// Evenly in the square root.
    Root,
    /// Evenly in the logarithm.
    Log,
}

/// Values from `first` to `last`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// With its unit.
    pub name: &'static str,
    pub scale: Scale,
    pub first: f64,
    pub last: f64,
    /// Values to write.
    pub ticks: &'static [f64],
}

impl Axis {
    /// The value at a part of the axis, 0 to 1.
    pub fn at(&self, part: f64) -> f64 {
        let between = |a: f64, b: f64| a + part * (b - a);
        match self.scale {
            Scale::Linear => between(self.first, self.last),
            Scale::Root => between(self.first.sqrt(), self.last.sqrt()).powi(2),
            Scale::Log => between(self.first.ln(), self.last.ln()).exp(),
        }
    }

    /// The part of the axis that a value is at.
    pub fn part(&self, value: f64) -> f64 {
        let part = |f: fn(f64) -> f64| (f(value) - f(self.first)) / (f(self.last) - f(self.first));
        match self.scale {
            Scale::Linear => part(|x| x),
            Scale::Root => part(f64::sqrt),
            Scale::Log => part(f64::ln),
        }
    }
}

/// The angle of incidence, from normal to grazing.
pub const ANGLE: Axis = Axis {
    name: "angle of incidence",
    scale: Scale::Linear,
    first: 0.0,
    last: 90.0,
    ticks: &[0.0, 45.0, 90.0],
};

/// The cosine of incidence at grazing angles.
pub const GRAZING: Axis = Axis {
    name: "cosine of incidence",
    scale: Scale::Log,
    first: 1.0,
    last: 1e-4,
    ticks: &[1.0, 1e-2, 1e-4],
};
