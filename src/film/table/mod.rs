//! Tables of a film's colours: their coordinates, how they are fitted, and their look-up.

mod axes;
mod axis_choice;
pub(super) mod errors;
pub(super) mod fit;
pub(super) mod spline;
pub(super) mod task;
pub(super) mod two_sided;
