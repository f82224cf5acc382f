//! Chooses how a film is evaluated: the cheapest method whose measured error holds the tolerance.

pub(super) mod choose;
pub(super) mod converge;
pub(super) mod film_plan;
pub(super) mod planner;
pub(super) mod points;
