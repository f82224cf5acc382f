//! The one list of methods, from which names and candidates derive.

use super::compiled_method::CompiledMethod;
use super::info::{Compile, MethodInfo, OneLayerCompile};
use super::one_layer::OneLayer;
use super::{
    airy_rgb, bands, fresnel, harmonics, quadrature, reference, schlick, series, table, two_beam,
};
use crate::error::Error;

/// All methods.
pub(in crate::film) const ALL: [&MethodInfo; 10] = [
    &schlick::INFO,
    &fresnel::INFO,
    &table::INFO,
    &two_beam::INFO,
    &airy_rgb::INFO,
    &quadrature::INFO,
    &harmonics::INFO,
    &bands::INFO,
    &series::INFO,
    &reference::INFO,
];

/// The names that a method is forced by ([`FilmDescription::method`](crate::film::FilmDescription)) and
/// reported with ([`FilmPlan::method`](crate::film::FilmPlan::method)).
pub const METHODS: [&str; ALL.len()] = {
    let mut names = [""; ALL.len()];
    let mut i = 0;
    while i < ALL.len() {
        names[i] = ALL[i].name;
        i += 1;
    }
    names
};

/// A method for one layer in a size, to be compiled alone: for tests, benchmarks and studies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OneLayerMethod {
    /// Two reflected beams at three wavelengths.
    TwoBeam,
    /// All beams at three wavelengths.
    AiryRgb,
    /// All beams at a number of wavelengths, 1 to 64.
    Quadrature(usize),
    /// All beams averaged over a number of bands, 1 to 256.
    Bands(usize),
    /// The Fourier series of the fringes up to an order, 1 to 16.
    Harmonics(usize),
}

impl OneLayerMethod {
    /// Each method in the sizes worth comparing.
    pub const ALL: [Self; 13] = [
        Self::TwoBeam,
        Self::AiryRgb,
        Self::Quadrature(4),
        Self::Quadrature(8),
        Self::Quadrature(16),
        Self::Quadrature(32),
        Self::Quadrature(64),
        Self::Bands(8),
        Self::Bands(16),
        Self::Bands(32),
        Self::Bands(64),
        Self::Harmonics(2),
        Self::Harmonics(3),
    ];

    /// The method's name, without its size.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// The work of an evaluation, in words.
    pub fn cost(self) -> String {
        (self.constructors().work)(self.size())
    }

    /// Compiles the method for a film in single precision.
    ///
    /// # Errors
    /// `OutOfRange`, if the size is.
    pub fn single(self, layer: &OneLayer) -> Result<Box<dyn CompiledMethod<f32>>, Error> {
        (self.constructors().single)(layer, self.size())
    }

    /// Compiles the method for a film in double precision.
    ///
    /// # Errors
    /// `OutOfRange`, if the size is.
    pub fn double(self, layer: &OneLayer) -> Result<Box<dyn CompiledMethod<f64>>, Error> {
        (self.constructors().double)(layer, self.size())
    }

    fn size(self) -> usize {
        match self {
            Self::TwoBeam | Self::AiryRgb => 1,
            Self::Quadrature(size) | Self::Bands(size) | Self::Harmonics(size) => size,
        }
    }

    fn constructors(self) -> &'static OneLayerCompile {
        match &self.info().compile {
            Compile::OneLayer(compile) => compile,
            Compile::BareBase(_) | Compile::Film(_) => {
                unreachable!("all of these are for one layer")
            }
        }
    }

    fn info(self) -> &'static MethodInfo {
        match self {
            Self::TwoBeam => &two_beam::INFO,
            Self::AiryRgb => &airy_rgb::INFO,
            Self::Quadrature(_) => &quadrature::INFO,
            Self::Bands(_) => &bands::INFO,
            Self::Harmonics(_) => &harmonics::INFO,
        }
    }
}
