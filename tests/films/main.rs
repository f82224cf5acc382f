//! Films: their methods, plans and tables, and the smooth `film` model that shows them.

mod absorbing_base;
mod accuracy;
mod amplitudes;
mod bsdf;
mod bsdf_create;
mod bsdf_directions;
#[path = "../common/mod.rs"]
mod common;
mod compiled;
mod film_lobes;
mod limits;
mod measured_tables;
mod narrow_ranges;
mod plan;
mod plan_cases;
mod plan_refusals;
mod precision;
mod saving;
mod sides;
mod spectral;
mod spread;
mod table_limit;
