//! pellicle: layered, thin-film and microfacet reflectance and the classic shading models as eval, sample and
//! pdf, for renderers. This page is about the Rust interface; `include/pellicle.h` is the C interface of the same
//! library.
//!
//! # A BSDF
//!
//! A [`Description`] names a model and sets its parameters, [`Bsdf::new`] checks and compiles it, and calls
//! evaluate it. [`model_infos`] lists the models and their parameters.
//!
//! ```
//! use pellicle::glam::Vec3;
//! use pellicle::{Bsdf, Call, Description};
//!
//! let description = Description::new("layered")
//!     .set("eta", &[1.4, 1.45, 1.6])
//!     .set("exponent_reflection", &[90.0])
//!     .vary("thickness_nm", 66.0, 76.0);
//! let bsdf: Bsdf = Bsdf::new(&description)?;
//!
//! let wo = Vec3::new(0.0, 0.6, 0.8);
//! let wi = Vec3::new(0.0, -0.6, 0.8);
//! let thickness_nm = [70.0];
//! let call = Call::default();
//! let [r, g, b] = bsdf.eval(wo, wi, Some(&thickness_nm), &call); // f(wo, wi) |wi.z|
//! assert!(r > g && g > b);
//!
//! let u = Vec3::new(0.2, 0.5, 0.7); // uniform random numbers in [0, 1)
//! let sample = bsdf.sample(wo, u, Some(&thickness_nm), &call);
//! assert!(sample.pdf > 0.0 && sample.weight[0] > 0.0);
//! # Ok::<(), pellicle::Error>(())
//! ```
//!
//! # A film
//!
//! A [`FilmDescription`] names media and thicknesses; [`Film::new`] chooses the cheapest method that holds its
//! tolerance and compiles it. The models `film` and `microfacet` take films.
//!
//! ```
//! use pellicle::{Bsdf, Description, Film, FilmDescription, Medium};
//! use std::sync::Arc;
//!
//! let oxide = FilmDescription::new(Medium::named("Ti")?).layer(Medium::named("TiO2")?, [20.0, 60.0]);
//! let film = Arc::new(Film::new(&oxide)?);
//! let [r, _, b] = film.reflectance(0.8, 45.0); // cosine of incidence, thickness in nm
//! assert!(b > r); // blue anodised titanium
//!
//! let rough = Description::new("microfacet")
//!     .choose("fresnel", "film")
//!     .set("alpha", &[0.1])
//!     .vary("thickness_nm", 20.0, 60.0)
//!     .film(film);
//! let bsdf: Bsdf = Bsdf::new(&rough)?;
//! # Ok::<(), pellicle::Error>(())
//! ```
//!
//! # Conventions
//!
//! Directions have unit length, point away from the surface and are given in the local shading frame: +Z is the
//! shading normal and +X the tangent; `wo` goes to the viewer and `wi` to the light. `value` is
//! f(wo, wi) |wi.z|, `pdf` is the density of wi per solid angle, and `weight` is value / pdf. Lengths are in
//! nanometres, colours in linear Rec.709 unless a film asks for another space. Directions whose length is 1 to
//! within 1e-3 are accepted and normalised; others, NaN and infinity give 0. Sampled directions are unit to 1e-6.

#[cfg(not(any(target_pointer_width = "64", target_family = "wasm")))]
compile_error!(
    "pellicle needs a 64-bit target: the C structs have one layout, with 8 bytes a pointer, and batches equal single \
     calls bit for bit, which the x87 registers of 32-bit x86 do not allow"
);

#[doc(hidden)]
pub mod batch;
#[doc(hidden)]
pub mod bsdf;
#[doc(hidden)]
pub mod capi;
mod error;
#[doc(hidden)]
pub mod film;
#[doc(hidden)]
pub mod num;
#[doc(hidden)]
pub mod optics;

pub use bsdf::{
    AtWavelengths, Bsdf, Call, Choice, Description, Evaluation, Exception, Flags, LobeInfo,
    MAX_WAVELENGTHS, ModelInfo, ParamInfo, ParamKind, Precision, Sample, SpectralSample, Transport,
    Varying, model_infos,
};
pub use error::{Error, Status};
pub use film::{BaseOpacity, Colors, Film, FilmDescription, FilmLayer, FilmPlan, METHODS};
/// The vectors of calls are [`glam::Vec3`], and [`glam::DVec3`] in double precision.
pub use glam;
pub use num::Rgb;
pub use optics::stack::Side;
pub use optics::{ColorSpace, Complex, Medium, NamedMedium, White};
