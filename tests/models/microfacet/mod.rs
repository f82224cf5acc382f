//! The `microfacet` model.

mod compensation;
mod create;
mod distributions;
mod fresnel;
mod lecture;
mod mitsuba;
mod precision;
mod rough;
mod tails;
