//! Approximate colours of one thin film: from (cosine, thickness) to linear RGB, by methods that
//! trade accuracy for time. The reference they approximate is [`crate::optics::Reference`].
//!
//! Every method is compiled from a [`OneLayer`] and can be called alone through its own type; code
//! that iterates over methods goes through [`Kind`] and [`Method`]. What depends on neither cosine
//! nor thickness is computed at compilation, in double precision.
//!
//! Results are not clipped: channels are normalised so that a perfect mirror is (1, 1, 1), and real
//! films leave \[0, 1\]. Cosines are held in \[0, 1\] and thicknesses in \[0, [`MAX_THICKNESS_NM`]\];
//! NaN counts as 0 in both. Results are finite.

mod airy_rgb;
mod axes;
mod bands;
mod candidate;
mod compiled;
mod converge;
mod description;
mod direct;
mod fit;
mod harmonics;
mod layer;
mod plan;
mod points;
mod quadrature;
mod series;
mod sheets;
mod table;
mod tile;
mod two_beam;

pub use airy_rgb::AiryRgb;
pub use bands::Bands;
pub use candidate::METHODS;
pub use compiled::{Colors, Film};
pub use description::{DEFAULT_TOLERANCE, FilmDescription, FilmLayer, LEAST_TOLERANCE, MAX_LAYERS};
pub use harmonics::{Harmonics, MAX_ORDER, Sensitivity};
pub use plan::Plan;
pub use quadrature::Quadrature;
pub use two_beam::TwoBeam;

use crate::error::Error;
use crate::num::{Lane, Rgb};
use crate::optics::{ColorSpace, Medium, White};

/// The greatest thickness of a film, nm: ten centimetres.
pub const MAX_THICKNESS_NM: f64 = 1e8;

/// A film between an ambient medium and a base, and the colours wanted of it.
#[derive(Clone, Debug)]
pub struct OneLayer {
    ambient: Medium,
    film: Medium,
    base: Medium,
    white: White,
    space: ColorSpace,
}

impl OneLayer {
    /// The ambient must be transparent with eta >= 1; film and base may absorb.
    pub fn new(
        ambient: Medium,
        film: Medium,
        base: Medium,
        white: White,
        space: ColorSpace,
    ) -> Result<Self, Error> {
        ambient.check_ambient()?;
        Ok(Self {
            ambient,
            film,
            base,
            white,
            space,
        })
    }

    /// Whether no index depends on the wavelength.
    fn is_constant(&self) -> bool {
        [&self.ambient, &self.film, &self.base]
            .into_iter()
            .all(|medium| medium.constant().is_some())
    }
}

/// Numbers that methods are evaluated in: f32, and f64 as the oracle.
pub trait Number: Lane {
    /// The whole number at or below a number in [0, 2^24].
    fn floor_to_index(self) -> usize;
}

impl Number for f32 {
    #[inline(always)]
    fn floor_to_index(self) -> usize {
        self as usize
    }
}

impl Number for f64 {
    #[inline(always)]
    fn floor_to_index(self) -> usize {
        self as usize
    }
}

/// A compiled method.
pub trait Method<T: Lane>: Send + Sync {
    /// Reflectance of unpolarised light per channel, linear and not clipped, at the cosine of
    /// incidence in the ambient medium and a thickness (nm). Both are held in their ranges.
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T>;
}

/// Which method, and how fine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// [`TwoBeam`].
    TwoBeam,
    /// [`AiryRgb`].
    AiryRgb,
    /// [`Quadrature`] with so many wavelengths, 1 to 64.
    Quadrature(usize),
    /// [`Bands`] with so many bands, 1 to 256.
    Bands(usize),
    /// [`Harmonics`] up to an order, 1 to [`MAX_ORDER`].
    Harmonics(Sensitivity, usize),
}

impl Kind {
    /// Each method in the sizes worth comparing.
    pub const ALL: [Self; 14] = [
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
        Self::Harmonics(Sensitivity::Gaussian, 2),
        Self::Harmonics(Sensitivity::Tabulated, 2),
        Self::Harmonics(Sensitivity::Tabulated, 3),
    ];

    /// The method's name, without its size.
    pub fn name(self) -> &'static str {
        match self {
            Self::TwoBeam => "two_beam",
            Self::AiryRgb => "airy_rgb",
            Self::Quadrature(_) => "quadrature",
            Self::Bands(_) => "bands",
            Self::Harmonics(Sensitivity::Gaussian, _) => "harmonics_gaussian",
            Self::Harmonics(Sensitivity::Tabulated, _) => "harmonics_tabulated",
        }
    }

    /// What an evaluation consists of.
    pub fn cost(self) -> String {
        match self {
            Self::TwoBeam => "two reflected beams at 3 wavelengths".into(),
            Self::AiryRgb => "all reflected beams at 3 wavelengths".into(),
            Self::Quadrature(count) => format!("all reflected beams at {count} wavelengths"),
            Self::Bands(count) => {
                format!("all reflected beams over {count} bands, 2 arctangents each")
            }
            Self::Harmonics(Sensitivity::Gaussian, order) => {
                format!("{order} harmonics, 4 Gaussians each")
            }
            Self::Harmonics(Sensitivity::Tabulated, order) => {
                format!("{order} harmonics, a table look-up each")
            }
        }
    }

    /// Compiles the method for a film. Fails if the size is outside its range.
    pub fn compile<T: Number>(self, layer: &OneLayer) -> Result<Box<dyn Method<T>>, Error> {
        Ok(match self {
            Self::TwoBeam => Box::new(TwoBeam::new(layer)),
            Self::AiryRgb => Box::new(AiryRgb::new(layer)),
            Self::Quadrature(count) => Box::new(Quadrature::new(layer, count)?),
            Self::Bands(count) => Box::new(Bands::new(layer, count)?),
            Self::Harmonics(sensitivity, order) => {
                Box::new(Harmonics::new(layer, sensitivity, order)?)
            }
        })
    }
}

/// Cosine and thickness within their ranges, in every channel.
#[inline(always)]
fn held<T: Lane>(cos_theta: T, thickness_nm: T) -> (T::Rgb, T::Rgb) {
    let hold = |x: T, greatest: f64| x.max(T::new(0.0)).min(T::new(greatest)).gray();
    (hold(cos_theta, 1.0), hold(thickness_nm, MAX_THICKNESS_NM))
}

fn check_size(what: &str, size: usize, greatest: usize) -> Result<(), Error> {
    if (1..=greatest).contains(&size) {
        return Ok(());
    }
    Err(Error::out_of_range(format!(
        "{what} = {size} is outside [1, {greatest}]"
    )))
}
