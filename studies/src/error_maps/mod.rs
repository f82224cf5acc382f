//! Maps of errors: every interference method over the regions where methods break, against the converged reference.
//! The atlas draws them; the tests cross them with what plans choose.

pub mod axis;
pub mod jump;
pub mod map;
pub mod precision;
pub mod scene;
#[cfg(test)]
mod tests;
