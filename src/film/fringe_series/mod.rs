//! Any stack in double precision, with all harmonics of one layer's fringes summed in closed form: what
//! tables are filled with and methods are measured by.

mod angle;
mod cells;
pub(super) mod series;
mod spectrum;
mod terms;

#[cfg(test)]
mod tests;
