//! Batches: calls for many elements of strided arrays.

#![allow(unsafe_code)]

mod amplitudes;
mod chunk;
mod film;
mod job;
mod spectral;
mod varying;
mod view;

pub use amplitudes::{AmplitudeArgs, film_amplitudes};
pub use film::{FilmArgs, film_reflectance};
pub use job::{EvalArgs, SampleArgs, eval, sample};
pub use spectral::{
    EvalSpectralArgs, SampleSpectralArgs, SpectralInputs, eval_spectral, sample_spectral,
};
pub use view::{ConstView, View};
