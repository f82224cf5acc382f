//! The wavelengths at which a film answers.

use super::description::FilmDescription;
use crate::error::Error;
use std::fmt::Display;

impl FilmDescription {
    /// The wavelengths that all media are known for, nm: the least and the greatest. If no wavelength is in the ranges
    /// of all, the first is the greater one.
    pub fn range_nm(&self) -> [f64; 2] {
        let ranges = self.media().map(|medium| medium.range_nm());
        ranges.fold([0.0, f64::INFINITY], |[min, max], range| {
            [range[0].max(min), range[1].min(max)]
        })
    }

    /// Refuses a wavelength (nm; `name` is the caller's name for it) that is not finite and above 0 and, unless the
    /// description says `extrapolate`, one outside the range of a medium.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn check_wavelength(&self, name: impl Display, wavelength_nm: f64) -> Result<(), Error> {
        if !(wavelength_nm.is_finite() && wavelength_nm > 0.0) {
            return Err(Error::out_of_range(format!(
                "{name} = {wavelength_nm} is not finite and above 0"
            )));
        }
        if self.extrapolate {
            return Ok(());
        }
        let is_outside = |[min, max]: [f64; 2]| !(min..=max).contains(&wavelength_nm);
        let Some(at) = self
            .media()
            .position(|medium| is_outside(medium.range_nm()))
        else {
            return Ok(());
        };
        let place = match at {
            0 => "ambient".to_owned(),
            1 => "base".to_owned(),
            _ => format!("layers[{}].medium", at - 2),
        };
        let [min, max] = self
            .media()
            .nth(at)
            .map_or([0.0; 2], |medium| medium.range_nm());
        Err(Error::out_of_range(format!(
            "{name} = {wavelength_nm} nm is outside [{min}, {max}], the range of the data of {place}: set extrapolate \
             in the film's description to have its index constant there"
        )))
    }
}
