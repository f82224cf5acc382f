//! What a caller may ask of an evaluation beyond its directions.

use super::info::Flags;

/// What travels along the path that a sample extends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transport {
    /// Radiance, from a camera: refraction carries (eta_o / eta_i)^2 (Veach 1997, section 5.2).
    #[default]
    Radiance,
    /// Importance, from a light: it does not.
    Importance,
}

/// Options of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Call {
    /// What travels along the path.
    pub transport: Transport,
    /// The lobes that take part: those all of whose flags are in this set. Values, densities and samples
    /// are those of these lobes alone.
    pub lobes: Flags,
}

impl Default for Call {
    fn default() -> Self {
        Self {
            transport: Transport::Radiance,
            lobes: Flags::ALL,
        }
    }
}
