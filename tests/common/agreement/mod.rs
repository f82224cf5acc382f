//! Batches in single precision against the f64 instance of the same formulas, at every level of
//! instructions and by single calls, over the whole registry and films of every method. Shared by the short
//! test (tests/agreement.rs) and the long run (examples/agreement, `./x check`). Needs `crate::common`.
//!
//! Both instances get the same single-precision numbers, so that what a narrow lobe makes of the rounding
//! of its inputs does not count, and what it makes of the rounding within the formulas does.

#![allow(dead_code)] // each program uses a part

pub mod batch;
pub mod bounds;
pub mod drawn;
pub mod elements;
pub mod films;
pub mod row;
pub mod run;
pub mod surface;
pub mod tally;
pub mod variants;
