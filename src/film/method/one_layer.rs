//! One layer on a base, which several methods are compiled for.

use crate::error::Error;
use crate::film::colors::clamp_inputs;
use crate::film::description::MAX_THICKNESS_NM;
use crate::num::Lane;
use crate::optics::{ColorSpace, Medium, White};

/// A film between an ambient medium and a base, and the colours wanted of it.
#[derive(Clone, Debug)]
pub struct OneLayer {
    pub(super) ambient: Medium,
    pub(super) film: Medium,
    pub(super) base: Medium,
    pub(super) white: White,
    pub(super) space: ColorSpace,
}

impl OneLayer {
    /// Film and base may absorb.
    ///
    /// # Errors
    /// If the ambient absorbs or its eta is below 1.
    pub fn new(
        ambient: Medium,
        film: Medium,
        base: Medium,
        white: White,
        space: ColorSpace,
    ) -> Result<Self, Error> {
        ambient.check_ambient()?;
        Ok(Self {
            ambient,
            film,
            base,
            white,
            space,
        })
    }

    /// Whether no index depends on the wavelength.
    pub(super) fn is_constant(&self) -> bool {
        [&self.ambient, &self.film, &self.base]
            .into_iter()
            .all(|medium| medium.constant().is_some())
    }
}

/// The cosine clamped to [0, 1] and the thickness to [0, [`MAX_THICKNESS_NM`]], for three wavelengths
/// side by side.
#[inline(always)]
pub(super) fn clamped<T: Lane>(cos_theta: T, thickness_nm: T) -> [T::Rgb; 2] {
    let range = |greatest: f64| [T::new(0.0), T::new(greatest)];
    let [cos_theta, thickness_nm] = clamp_inputs(
        [cos_theta, thickness_nm],
        range(1.0),
        range(MAX_THICKNESS_NM),
    );
    [cos_theta.gray(), thickness_nm.gray()]
}

/// Refuses a size (`what` names it) outside [1, greatest].
pub(super) fn check_size(what: &str, size: usize, greatest: usize) -> Result<(), Error> {
    if (1..=greatest).contains(&size) {
        return Ok(());
    }
    Err(Error::out_of_range(format!(
        "{what} = {size} is outside [1, {greatest}]"
    )))
}
