//! Tables of a film's colours: their coordinates, how they are fitted, and their look-up.

mod axes;
mod axis_choice;
mod constant_sides;
mod critical;
pub(super) mod critical_axis;
mod dispersing_sides;
pub(super) mod errors;
mod film_table;
pub(super) mod fit;
pub(super) mod lane_table;
mod level_fit;
pub(super) mod levelled;
pub(super) mod levels;
mod nodes;
mod patches;
mod series_sampler;
pub(super) mod spline;
pub(super) mod task;
pub(super) mod two_sided;
mod warped;
