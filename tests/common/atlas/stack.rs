//! One film on a base: the stacks of the atlas.

use pellicle::Error;
use pellicle::film::{FilmDescription, OneLayer};
use pellicle::optics::{ColorSpace, Medium, Reference, White};

const WHITE: White = White::E;
const SPACE: ColorSpace = ColorSpace::Rec709;

/// Ambient medium, film and base.
#[derive(Clone, Debug)]
pub struct Stack {
    pub ambient: Medium,
    pub film: Medium,
    pub base: Medium,
}

impl Stack {
    /// Of indices that do not depend on the wavelength: ambient, film and base, each eta and k.
    pub fn constant([ambient, film, base]: [[f64; 2]; 3]) -> Self {
        Self {
            ambient: constant(ambient),
            film: constant(film),
            base: constant(base),
        }
    }

    /// In vacuum.
    pub fn named(film: &str, base: &str) -> Self {
        let medium = |name| Medium::named(name).unwrap();
        Self {
            ambient: Medium::vacuum(),
            film: medium(film),
            base: medium(base),
        }
    }

    /// For methods that take one film on a base.
    pub fn one_layer(&self) -> OneLayer {
        let [ambient, film, base] = [&self.ambient, &self.film, &self.base].map(Medium::clone);
        OneLayer::new(ambient, film, base, WHITE, SPACE).unwrap()
    }

    /// For a film compiled over a range of thickness, nm.
    pub fn description(&self, thickness_nm: [f64; 2], tolerance: f64) -> FilmDescription {
        let description = FilmDescription::new(self.base.clone());
        FilmDescription {
            ambient: self.ambient.clone(),
            tolerance,
            white: WHITE,
            color_space: SPACE,
            ..description.layer(self.film.clone(), thickness_nm)
        }
    }

    /// Converged wave optics.
    pub fn reference(&self) -> Result<Reference, Error> {
        let layers = vec![self.film.clone()];
        let [ambient, base] = [&self.ambient, &self.base].map(Medium::clone);
        Reference::new(ambient, layers, base, WHITE, SPACE)
    }
}

fn constant([eta, k]: [f64; 2]) -> Medium {
    Medium::rgb([eta; 3], [k; 3]).unwrap()
}
