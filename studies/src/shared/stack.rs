//! A film on a base, perhaps with layers of fixed thickness below it: the stacks of the atlas and of the chart.

use pellicle::Error;
use pellicle::film::{FilmDescription, OneLayer};
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};

const WHITE: White = White::E;
const SPACE: ColorSpace = ColorSpace::Rec709;

/// Media, from the viewer's side.
#[derive(Clone, Debug)]
pub struct Stack {
    pub ambient: Medium,
    /// Its thickness is the argument of the colours.
    pub film: Medium,
    /// Below the film, each with its thickness in nm.
    pub fixed: Vec<(Medium, f64)>,
    pub base: Medium,
}

impl Stack {
    /// Constant indices of ambient, film and base, each eta and k.
    pub fn constant(indices: [[f64; 2]; 3]) -> Self {
        let [ambient, film, base] = indices.map(|[eta, k]| Medium::rgb([eta; 3], [k; 3]).unwrap());
        Self {
            ambient,
            film,
            fixed: Vec::new(),
            base,
        }
    }

    /// Named media in vacuum.
    pub fn named(film: &str, base: &str) -> Self {
        let [film, base] = [film, base].map(|name| Medium::named(name).unwrap());
        Self {
            film,
            base,
            ..Self::constant([[1.0, 0.0]; 3])
        }
    }

    pub fn is_one_layer(&self) -> bool {
        self.fixed.is_empty()
    }

    /// Whether an index depends on the wavelength.
    pub fn has_dispersion(&self) -> bool {
        let fixed = self.fixed.iter().map(|(medium, _)| medium);
        let mut media = fixed.chain([&self.ambient, &self.film, &self.base]);
        media.any(|medium| medium.constant().is_none())
    }

    /// For methods that take one film on a base; none if there are more layers.
    pub fn one_layer(&self) -> Option<OneLayer> {
        let [ambient, film, base] = [&self.ambient, &self.film, &self.base].map(Medium::clone);
        let layer = || OneLayer::new(ambient, film, base, WHITE, SPACE).unwrap();
        self.is_one_layer().then(layer)
    }

    /// For a film compiled over a range of thickness, nm.
    pub fn description(&self, thickness_nm: [f64; 2], tolerance: f64) -> FilmDescription {
        let description = FilmDescription::new(self.base.clone());
        let description = FilmDescription {
            ambient: self.ambient.clone(),
            tolerance,
            white: WHITE,
            color_space: SPACE,
            ..description.layer(self.film.clone(), thickness_nm)
        };
        let add = |film: FilmDescription, (medium, nm): &(Medium, f64)| {
            film.layer(medium.clone(), [*nm; 2])
        };
        self.fixed.iter().fold(description, add)
    }

    /// One film seen from its base; none if there are more layers.
    pub fn turned(&self) -> Option<Self> {
        self.is_one_layer().then(|| Self {
            ambient: self.base.clone(),
            base: self.ambient.clone(),
            ..self.clone()
        })
    }

    pub fn truth(&self) -> Result<Truth, Error> {
        let fixed = self.fixed.iter().map(|(medium, _)| medium);
        let layers = [&self.film].into_iter().chain(fixed).cloned().collect();
        let [ambient, base] = [&self.ambient, &self.base].map(Medium::clone);
        Ok(Truth {
            reference: Reference::new(ambient, layers, base, WHITE, SPACE)?,
            fixed_nm: self.fixed.iter().map(|(_, nm)| *nm).collect(),
        })
    }
}

/// Converged wave optics.
pub struct Truth {
    reference: Reference,
    fixed_nm: Vec<f64>,
}

impl Truth {
    /// The reflectance, not clipped.
    pub fn reflectance(&self, cos_theta: f64, thickness_nm: f64) -> [f64; 3] {
        self.colors(Side::Ambient, cos_theta, thickness_nm)[0]
    }

    /// Reflectance and transmittance from a side, not clipped.
    pub fn colors(&self, side: Side, cos_theta: f64, thickness_nm: f64) -> [[f64; 3]; 2] {
        let mut thicknesses = vec![thickness_nm];
        thicknesses.extend(&self.fixed_nm);
        let found = self.reference.evaluate(side, cos_theta, &thicknesses);
        [found.reflectance, found.transmittance]
    }
}

/// The greatest error of a channel against a truth that is clipped to [0, 1]; infinite if one is not a number.
pub fn clipped_error(found: [f32; 3], truth: [f64; 3]) -> f64 {
    clipped_errors(found, truth).into_iter().fold(0.0, f64::max)
}

/// The same for each channel.
pub fn clipped_errors(found: [f32; 3], truth: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|c| {
        let error = (f64::from(found[c]) - truth[c].clamp(0.0, 1.0)).abs();
        if error.is_nan() { f64::INFINITY } else { error }
    })
}

/// A colour as films return it. What is not a number stays so.
pub fn clipped(rgb: [f32; 3]) -> [f32; 3] {
    rgb.map(|channel| channel.clamp(0.0, 1.0))
}

#[test]
fn errors_are_those_of_clipped_colours() {
    assert_eq!(clipped_error([1.0, 0.0, 0.5], [1.25, -0.5, 0.5]), 0.0);
    assert_eq!(clipped_error([1.0, 0.0, 0.5], [0.75, -0.5, 0.5]), 0.25);
    assert_eq!(clipped_error([1.25, 0.0, 0.5], [1.5, 0.0, 0.5]), 0.25);
    assert_eq!(clipped_error([f32::NAN, 0.0, 0.0], [0.0; 3]), f64::INFINITY);
}
