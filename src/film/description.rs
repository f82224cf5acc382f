//! What film to create, and the checks that it must pass.

use crate::error::Error;
use crate::optics::stack::Side;
use crate::optics::{ColorSpace, Medium, White};

/// The error that is allowed where none is stated.
pub const DEFAULT_TOLERANCE: f64 = 2e-3;
/// The least error that may be asked for: what the reference itself is converged to.
pub const LEAST_TOLERANCE: f64 = 1e-5;
/// The most layers.
pub const MAX_LAYERS: usize = 64;

/// One layer: its medium and the range of its thickness.
#[derive(Clone, Debug)]
pub struct FilmLayer {
    /// What it consists of.
    pub medium: Medium,
    /// Least and greatest thickness, nm, within \[0, [`MAX_THICKNESS_NM`](super::MAX_THICKNESS_NM)\];
    /// equal: fixed.
    pub thickness_nm: [f64; 2],
}

/// A coating: layers between an ambient medium and a base, and the colours wanted of it. Nothing is
/// checked before [`Film::new`](super::Film::new).
#[derive(Clone, Debug)]
pub struct FilmDescription {
    /// Where the light comes from: transparent, eta >= 1.
    pub ambient: Medium,
    /// The layers, the ambient's neighbour first; at most 64. The thickness of at most one may vary.
    pub layers: Vec<FilmLayer>,
    /// What they lie on.
    pub base: Medium,
    /// The greatest error of a channel of the clipped colours, at least 1e-5.
    pub tolerance: f64,
    /// The illuminant in which a perfect mirror is (1, 1, 1).
    pub white: White,
    /// The space of the colours.
    pub color_space: ColorSpace,
    /// One of [`METHODS`](super::METHODS); `None` lets the plan choose.
    pub method: Option<String>,
    /// Leave colours outside \[0, 1\] as they are.
    pub unclipped: bool,
    /// Also keep the transmittance, and the reflectance from the base's side.
    pub transmittance: bool,
}

impl FilmDescription {
    /// A bare base in vacuum with every other field at its default.
    pub fn new(base: Medium) -> Self {
        Self {
            ambient: Medium::vacuum(),
            layers: Vec::new(),
            base,
            tolerance: DEFAULT_TOLERANCE,
            white: White::E,
            color_space: ColorSpace::Rec709,
            method: None,
            unclipped: false,
            transmittance: false,
        }
    }

    /// Adds a layer below those that are there. `thickness_nm`: least and greatest.
    #[must_use]
    pub fn layer(mut self, medium: Medium, thickness_nm: [f64; 2]) -> Self {
        self.layers.push(FilmLayer {
            medium,
            thickness_nm,
        });
        self
    }

    /// The layer whose thickness varies.
    pub fn varying(&self) -> Option<usize> {
        let varies = |layer: &FilmLayer| layer.thickness_nm[0] != layer.thickness_nm[1];
        self.layers.iter().position(varies)
    }

    /// The range of the thickness that varies, nm; 0 to 0 if none does.
    pub(super) fn varying_range(&self) -> [f64; 2] {
        self.varying()
            .map_or([0.0; 2], |layer| self.layers[layer].thickness_nm)
    }

    /// The sides that light is asked for from.
    pub(super) fn sides(&self) -> &'static [Side] {
        if self.transmittance && !self.base.absorbs() {
            &[Side::Ambient, Side::Base]
        } else {
            &[Side::Ambient]
        }
    }

    /// Whether a half-space disperses: then every wavelength has a critical angle of its own.
    pub(super) fn disperses(&self) -> bool {
        self.ambient.constant().is_none() || self.base.constant().is_none()
    }

    /// One thickness per layer, the varying one held in its range.
    pub(super) fn thicknesses(&self, varying_nm: f64) -> Vec<f64> {
        let thickness = |layer: &FilmLayer| {
            let [min, max] = layer.thickness_nm;
            varying_nm.clamp(min, max)
        };
        self.layers.iter().map(thickness).collect()
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        self.ambient.check_ambient()?;
        if self.layers.len() > MAX_LAYERS {
            let count = self.layers.len();
            return Err(Error::out_of_range(format!(
                "layer_count = {count} is outside [0, {MAX_LAYERS}]"
            )));
        }
        for (i, layer) in self.layers.iter().enumerate() {
            check_thickness(i, layer.thickness_nm)?;
        }
        let varies = |layer: &&FilmLayer| layer.thickness_nm[0] != layer.thickness_nm[1];
        let varying = self.layers.iter().filter(varies).count();
        if varying > 1 {
            return Err(Error::invalid(format!(
                "{varying} layers vary in thickness; at most 1 may, the others need \
                 thickness_min_nm = thickness_max_nm"
            )));
        }
        let least = LEAST_TOLERANCE * (1.0 - 1e-6); // as a single-precision number
        if !(least..=1.0).contains(&self.tolerance) {
            return Err(Error::out_of_range(format!(
                "tolerance = {} is outside [{LEAST_TOLERANCE}, 1]",
                self.tolerance
            )));
        }
        Ok(())
    }
}

fn check_thickness(layer: usize, [min, max]: [f64; 2]) -> Result<(), Error> {
    let greatest = super::MAX_THICKNESS_NM;
    for (name, thickness) in [("thickness_min_nm", min), ("thickness_max_nm", max)] {
        if !(0.0..=greatest).contains(&thickness) {
            return Err(Error::out_of_range(format!(
                "layers[{layer}].{name} = {thickness} is outside [0, {greatest}]"
            )));
        }
    }
    if min > max {
        return Err(Error::out_of_range(format!(
            "layers[{layer}] has its thickness reversed: [{min}, {max}]"
        )));
    }
    Ok(())
}
