//! Colours averaged over a spread of thickness: a normal distribution around the thickness of a call, cut to the
//! range of the layer that varies, and renormalised.

pub(super) mod average;
mod calls;
pub(super) mod cut_normal;
