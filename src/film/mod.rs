//! Colours of a film: from (cosine, thickness) to linear RGB, by methods that trade accuracy for time. The
//! exact colours that they approximate are those of [`crate::optics::Reference`].
//!
//! [`Film::new`] takes a [`FilmDescription`], has the cheapest method chosen whose measured error holds
//! the tolerance (`plan/`), and compiles it. A method is one file in `method/`. Most films become tables
//! (`table/`), filled with the series of `fringe_series/`. What depends on neither cosine nor thickness
//! is computed at compilation, in double precision.
//!
//! Channels are normalised so that a perfect mirror is (1, 1, 1); methods do not clip, and real films
//! leave \[0, 1\].

mod colors;
mod description;
mod evaluator;
#[allow(clippy::module_inception)]
mod film;
mod fringe_series;
mod method;
mod plan;
mod repeated_media;
mod saving;
mod spectra;
mod spread;
mod table;
mod tabulated;
mod tile;
mod wavelengths;
mod wavenumbers;

pub use colors::Colors;
pub use description::{
    BaseOpacity, DEFAULT_TOLERANCE, FilmDescription, FilmLayer, LEAST_TOLERANCE, MAX_LAYERS,
    MAX_THICKNESS_NM, OPAQUE_K,
};
pub use film::Film;
#[doc(hidden)]
pub use method::compiled_method::CompiledMethod;
#[doc(hidden)]
pub use method::one_layer::OneLayer;
pub use method::registry::METHODS;
#[doc(hidden)]
pub use method::registry::OneLayerMethod;
pub use plan::film_plan::{DIRECTION_NM, FilmPlan, SidePlan};
#[doc(hidden)]
pub use saving::resealed;
pub(crate) use spectra::Ray;
