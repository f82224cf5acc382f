//! The task of fitting a table.

use crate::num::Rgb;

/// Colours at a cosine and a thickness (nm), exact compared with the tolerance. Calls at the same
/// cosine one after another are cheaper.
pub(in crate::film) type ColorSource<'a> = dyn FnMut(f64, f64) -> Rgb<f64> + 'a;

/// The colours over cosine and thickness that a table is fitted to.
pub(in crate::film) struct FitTask<'a> {
    pub source: &'a mut ColorSource<'a>,
    /// Least and greatest thickness, nm.
    pub range: [f64; 2],
    /// The square of the ratio of the rarer half-space's index and the layer's; 0 without fringes.
    pub tilt: f64,
    /// Whether a new cosine for every value is slow.
    pub is_costly: bool,
    pub limits: FitLimits,
}

/// The limits of a table.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct FitLimits {
    /// The greatest error of a channel.
    pub tolerance: f64,
    /// Whether colours outside [0, 1] count.
    pub unclipped: bool,
    /// The greatest number of values.
    pub size: usize,
}
