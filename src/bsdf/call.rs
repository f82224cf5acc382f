//! The options of a call.

use super::info::Flags;

/// The quantity that is transported along the path that a sample extends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transport {
    /// Radiance, along paths from the camera. The weight of a refracted sample has the factor (eta_o /
    /// eta_i)^2 (Veach 1997, section 5.2).
    #[default]
    Radiance,
    /// Importance, along paths from a light. That factor is left out.
    Importance,
}

/// The options of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Call {
    /// The quantity that is transported along the path. Only samples depend on it.
    pub transport: Transport,
    /// The lobes that take part: a lobe does if all its flags are in this set. Values, densities and
    /// samples are those of these lobes alone.
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
