//! Optics: one interface (Fresnel reflectance, refraction), media and their complex indices, stacks of
//! layers by wave optics, and colours from spectra.

mod amplitudes;
mod color;
mod complex;
mod conductor;
mod dispersion;
mod fresnel;
mod fringes;
mod media;
mod reference;
mod refraction;
mod spectral_grid;
mod spectral_sums;
pub mod stack;
mod waves;

pub use amplitudes::Amplitudes;
pub(crate) use amplitudes::Propagation;
pub use color::{ChannelWeights, ColorSpace, VISIBLE_NM, White, matching_functions};
pub use complex::Complex;
pub use conductor::ConductorPolynomial;
pub use dispersion::{Medium, index_between};
pub use fresnel::{
    conductor_reflectance, dielectric_reflectance, normal_reflectance, schlick, schlick_between,
    schlick_falling, schlick_transmittance,
};
pub use media::NamedMedium;
pub use reference::{Converged, Reference, TOLERANCE};
pub use refraction::{Interface, critical_cosine};
pub use spectral_grid::{attenuation_per_mm, branches_nm};

/// The wavelengths that stand for red, green and blue, nm (GH02 section 1).
pub const RGB_WAVELENGTHS_NM: [f64; 3] = [645.0, 525.0, 445.0];
