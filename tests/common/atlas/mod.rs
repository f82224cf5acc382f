//! The atlas: every interference method over the regions where methods break, against the converged
//! reference. Shared by the program that draws it (examples/atlas, `./x atlas`) and the test that
//! crosses it with what plans choose (tests/atlas.rs), which sweeps it coarsely.

#![allow(dead_code)] // each program uses a part

pub mod axis;
pub mod contender;
pub mod jump;
pub mod map;
#[path = "../parallel.rs"]
pub mod parallel;
pub mod precision;
pub mod scene;
pub mod stack;
