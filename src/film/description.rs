//! The description of a film, and the checks that it must pass.

use crate::error::Error;
use crate::optics::stack::Side;
use crate::optics::{ColorSpace, Medium, VISIBLE_NM, White};

/// The tolerance where none is stated.
pub const DEFAULT_TOLERANCE: f64 = 2e-3;
/// The least tolerance: the error that the reference itself is converged to.
pub const LEAST_TOLERANCE: f64 = 1e-5;
/// The greatest number of layers.
pub const MAX_LAYERS: usize = 64;
/// The greatest thickness of a layer, nm: ten centimetres.
pub const MAX_THICKNESS_NM: f64 = 1e8;

/// A base whose k at 550 nm is greater is opaque unless the description says otherwise: light of 550 nm falls to
/// 1 / e within 44 um of it.
pub const OPAQUE_K: f64 = 1e-3;
/// The wavelength at which [`OPAQUE_K`] is meant, nm.
const OPAQUE_NM: f64 = 550.0;

/// Whether light that has entered the base is followed there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BaseOpacity {
    /// Unless its extinction k at 550 nm is more than [`OPAQUE_K`].
    #[default]
    ByExtinction,
    /// Never: what enters is absorbed.
    Opaque,
    /// Always, whatever its extinction is.
    Transparent,
}

/// One layer: its medium and the range of its thickness.
#[derive(Clone, Debug)]
pub struct FilmLayer {
    /// The medium, which may absorb.
    pub medium: Medium,
    /// Least and greatest thickness, nm, within \[0, [`MAX_THICKNESS_NM`]\]; equal for a fixed thickness.
    pub thickness_nm: [f64; 2],
}

/// A coating: layers between an ambient medium and a base, and the colours wanted of it. Nothing is
/// checked before [`Film::new`](super::Film::new).
#[derive(Clone, Debug)]
pub struct FilmDescription {
    /// The medium above the layers: transparent, eta >= 1.
    pub ambient: Medium,
    /// The layers, the ambient's neighbour first; at most 64. The thickness of at most one may vary.
    pub layers: Vec<FilmLayer>,
    /// The medium below the layers; may absorb.
    pub base: Medium,
    /// The greatest error allowed of a channel of the clipped colours, in \[1e-5, 1\].
    pub tolerance: f64,
    /// The illuminant in which a perfect mirror is (1, 1, 1).
    pub white: White,
    /// The colour space of the results.
    pub color_space: ColorSpace,
    /// One of [`METHODS`](super::METHODS); `None` lets the plan choose.
    pub method: Option<String>,
    /// Leave colours outside \[0, 1\] as they are.
    pub unclipped: bool,
    /// Also keep the transmittance, and the reflectance from the base's side.
    pub transmittance: bool,
    /// Whether light that has entered the base is followed there. What is reflected and what enters, from the
    /// ambient's side, do not depend on it.
    pub base_opacity: BaseOpacity,
    /// Answer at single wavelengths outside the ranges of the media ([`Medium::range_nm`]) too, where their indices
    /// are taken to be constant. Colours always are those of 380-780 nm.
    pub extrapolate: bool,
    /// The greatest standard deviation of the thickness that varies which calls may give, nm, in \[0,
    /// [`MAX_THICKNESS_NM`]\]; 0 if none. Where averages of up to
    /// 64 look-ups do not suffice, tables of averages are made, which `bytes` of the plan counts.
    pub thickness_spread_max_nm: f64,
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
            base_opacity: BaseOpacity::ByExtinction,
            extrapolate: false,
            thickness_spread_max_nm: 0.0,
        }
    }

    /// Adds a layer below the others. `thickness_nm`: least and greatest, nm.
    #[must_use]
    pub fn layer(mut self, medium: Medium, thickness_nm: [f64; 2]) -> Self {
        self.layers.push(FilmLayer {
            medium,
            thickness_nm,
        });
        self
    }

    /// The index of the layer whose thickness varies, if one does.
    pub fn varying(&self) -> Option<usize> {
        let varies = |layer: &FilmLayer| layer.thickness_nm[0] != layer.thickness_nm[1];
        self.layers.iter().position(varies)
    }

    /// The range of the thickness that varies, nm; 0 to 0 if none does.
    pub(super) fn varying_range(&self) -> [f64; 2] {
        self.varying()
            .map_or([0.0; 2], |layer| self.layers[layer].thickness_nm)
    }

    /// Whether light that has entered the base stays there, and none comes from it.
    pub fn is_base_opaque(&self) -> bool {
        match self.base_opacity {
            // C callers give k in single precision.
            BaseOpacity::ByExtinction => self.base.index(OPAQUE_NM).im > OPAQUE_K * (1.0 + 1e-6),
            BaseOpacity::Opaque => true,
            BaseOpacity::Transparent => false,
        }
    }

    /// Whether a base that is not opaque absorbs enough for tables to tell the sides apart: from the ambient's the
    /// base has its complex index, from its own the real part. What is reflected and what enters differ by 2 k at
    /// most, but beside a denser ambient, where light begins to go along the base, by 5 times the root of k.
    pub(super) fn is_base_tinted(&self) -> bool {
        const PART: f64 = 0.1;
        if self.is_base_opaque() {
            return false;
        }
        let [ambient, base] = [&self.ambient, &self.base].map(|medium| medium.index(OPAQUE_NM).re);
        let k = self.base.greatest_extinction();
        let error = if ambient > base {
            5.0 * k.sqrt()
        } else {
            2.0 * k
        };
        error > PART * self.tolerance
    }

    /// The sides from which light is asked for.
    pub(super) fn sides(&self) -> &'static [Side] {
        if self.transmittance && !self.is_base_opaque() {
            &[Side::Ambient, Side::Base]
        } else {
            &[Side::Ambient]
        }
    }

    /// Whether the relative index of the half-spaces depends on the wavelength. Then every wavelength has its own
    /// critical angle.
    pub(super) fn disperses(&self) -> bool {
        if self.ambient.constant().is_some() && self.base.constant().is_some() {
            return false;
        }
        let [least, greatest] = VISIBLE_NM;
        let steps = (greatest - least) / 5.0;
        let ratio = |nm: f64| self.base.index(nm).re / self.ambient.index(nm).re;
        let first = ratio(least);
        (1..=steps as u32).any(|i| {
            let ratio = ratio(least + 5.0 * f64::from(i));
            (ratio / first - 1.0).abs() > 1e-9
        })
    }

    /// The half-space that light from a side is in, and the other one.
    pub(super) fn near_and_far(&self, side: Side) -> [&Medium; 2] {
        match side {
            Side::Ambient => [&self.ambient, &self.base],
            Side::Base => [&self.base, &self.ambient],
        }
    }

    /// One thickness per layer, nm; the varying one is clamped to its range.
    pub(super) fn thicknesses(&self, varying_nm: f64) -> Vec<f64> {
        let thickness = |layer: &FilmLayer| {
            let [min, max] = layer.thickness_nm;
            varying_nm.clamp(min, max)
        };
        self.layers.iter().map(thickness).collect()
    }

    /// Refuses what [`Film::new`](super::Film::new) documents, but for the method's name.
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
        self.check_tables()?;
        self.check_spread()?;
        // C callers give the tolerance in single precision.
        let least = LEAST_TOLERANCE * (1.0 - 1e-6);
        if !(least..=1.0).contains(&self.tolerance) {
            return Err(Error::out_of_range(format!(
                "tolerance = {} is outside [{LEAST_TOLERANCE}, 1]",
                self.tolerance
            )));
        }
        Ok(())
    }

    fn check_spread(&self) -> Result<(), Error> {
        let most = self.thickness_spread_max_nm;
        if !(0.0..=MAX_THICKNESS_NM).contains(&most) {
            return Err(Error::out_of_range(format!(
                "thickness_spread_max_nm = {most} is outside [0, {MAX_THICKNESS_NM}]"
            )));
        }
        if most > 0.0 && self.varying().is_none() {
            return Err(Error::invalid(format!(
                "thickness_spread_max_nm = {most}, but no layer's thickness varies"
            )));
        }
        Ok(())
    }
}

fn check_thickness(layer: usize, [min, max]: [f64; 2]) -> Result<(), Error> {
    for (name, thickness) in [("thickness_min_nm", min), ("thickness_max_nm", max)] {
        if !(0.0..=MAX_THICKNESS_NM).contains(&thickness) {
            return Err(Error::out_of_range(format!(
                "layers[{layer}].{name} = {thickness} is outside [0, {MAX_THICKNESS_NM}]"
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
