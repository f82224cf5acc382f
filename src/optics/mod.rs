//! Optics of one interface: Fresnel reflectance and refraction.

mod fresnel;
mod refraction;

pub use fresnel::{normal_reflectance, schlick, schlick_transmittance};
pub use refraction::Interface;

/// The wavelengths that stand for red, green and blue, nm (GH02 section 1).
pub const RGB_WAVELENGTHS_NM: [f64; 3] = [645.0, 525.0, 445.0];
