//! The films that every method is judged on, and where.

use pellicle::Error;
use pellicle::film::{FilmDescription, OneLayer};
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, White};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Every colour of the suite is in this white and space.
const WHITE: White = White::E;
const SPACE: ColorSpace = ColorSpace::Rec709;

/// The wavelength that the mirror's fixed layers are a quarter of, nm.
const MIRROR_NM: f64 = 550.0;

/// One in so many points has its cosine spread evenly in the logarithm: grazing angles, where most
/// methods fail, would else hardly occur.
const GRAZING_SHARE: usize = 5;
/// The least cosine.
const LEAST_COSINE: f32 = 1e-3;

/// Thicknesses to compare over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// For headings.
    pub name: &'static str,
    /// Least and greatest, nm.
    pub nm: [f64; 2],
    /// Whether stacks of more than one layer take part: on thick ones the truth, and films compiled
    /// from it, would take longer than all the rest.
    pub has_mirror: bool,
}

/// From the thinnest to the thickest.
pub const RANGES: [Range; 4] = [
    Range {
        name: "0 to 400 nm",
        nm: [0.0, 400.0],
        has_mirror: true,
    },
    Range {
        name: "0 to 1000 nm",
        nm: [0.0, 1000.0],
        has_mirror: true,
    },
    Range {
        name: "0 to 3000 nm",
        nm: [0.0, 3000.0],
        has_mirror: false,
    },
    Range {
        name: "3 to 100 um",
        nm: [3e3, 1e5],
        has_mirror: false,
    },
];

/// A film of varying thickness in vacuum, perhaps fixed layers, and a base.
pub struct Stack {
    /// Film/base, or ambient/film/base by indices.
    pub name: &'static str,
    film: Medium,
    /// Outermost first, with their thicknesses in nm.
    fixed: Vec<(Medium, f64)>,
    base: Medium,
}

impl Stack {
    fn one_film(name: &'static str, film: Medium, base: Medium) -> Self {
        let fixed = Vec::new();
        Self {
            name,
            film,
            fixed,
            base,
        }
    }

    /// Whether it is one film on a base.
    pub fn is_one_layer(&self) -> bool {
        self.fixed.is_empty()
    }

    /// Whether an index depends on the wavelength.
    pub fn has_dispersion(&self) -> bool {
        let fixed = self.fixed.iter().map(|(medium, _)| medium);
        let mut media = fixed.chain([&self.film, &self.base]);
        media.any(|medium| medium.constant().is_none())
    }

    /// For methods that take one film on a base; none if there are more layers.
    pub fn one_layer(&self) -> Option<OneLayer> {
        if !self.is_one_layer() {
            return None;
        }
        let (film, base) = (self.film.clone(), self.base.clone());
        OneLayer::new(Medium::vacuum(), film, base, WHITE, SPACE).ok()
    }

    /// For a planned film.
    pub fn description(&self, range: Range, tolerance: f64) -> FilmDescription {
        let film = FilmDescription::new(self.base.clone()).layer(self.film.clone(), range.nm);
        let add = |film: FilmDescription, (medium, nm): &(Medium, f64)| {
            film.layer(medium.clone(), [*nm, *nm])
        };
        let mut film = self.fixed.iter().fold(film, add);
        (film.white, film.color_space) = (WHITE, SPACE);
        film.tolerance = tolerance;
        film
    }

    /// Converged wave optics.
    pub fn truth(&self) -> Result<Truth, Error> {
        let media = self.fixed.iter().map(|(medium, _)| medium.clone());
        let layers = std::iter::once(self.film.clone()).chain(media).collect();
        let base = self.base.clone();
        Ok(Truth {
            reference: Reference::new(Medium::vacuum(), layers, base, WHITE, SPACE)?,
            fixed_nm: self.fixed.iter().map(|(_, nm)| *nm).collect(),
        })
    }
}

/// What methods are compared with.
pub struct Truth {
    reference: Reference,
    fixed_nm: Vec<f64>,
}

impl Truth {
    /// The converged reflectance, not clipped.
    pub fn reflectance(&self, [cos_theta, thickness_nm]: Point) -> [f64; 3] {
        let varying = std::iter::once(f64::from(thickness_nm));
        let thickness_nm: Vec<f64> = varying.chain(self.fixed_nm.iter().copied()).collect();
        let cos_theta = f64::from(cos_theta);
        let found = self
            .reference
            .evaluate(Side::Ambient, cos_theta, &thickness_nm);
        found.reflectance
    }
}

/// The stacks, those of one film first.
pub fn stacks() -> Result<Vec<Stack>, Error> {
    let medium = |eta: f64, k: f64| Medium::rgb([eta; 3], [k; 3]);
    let named = Medium::named;
    let constant = |name, film: f64, base: f64, k: f64| {
        Ok::<_, Error>(Stack::one_film(name, medium(film, 0.0)?, medium(base, k)?))
    };
    let quarter = |name| {
        let medium = named(name)?;
        let nm = MIRROR_NM / (4.0 * medium.index(MIRROR_NM).re);
        Ok::<_, Error>((medium, nm))
    };
    let (high, low) = (quarter("TiO2")?, quarter("SiO2")?);
    let mirror = Stack {
        name: "mirror of 5 layers",
        film: high.0.clone(),
        fixed: vec![low.clone(), high.clone(), low, high],
        base: named("BK7")?,
    };
    Ok(vec![
        constant("1/1.33/1", 1.33, 1.0, 0.0)?,
        constant("1/1.5/1.33", 1.5, 1.33, 0.0)?,
        constant("1/1.38/1.52", 1.38, 1.52, 0.0)?,
        constant("1/2.4/1.5", 2.4, 1.5, 0.0)?,
        constant("1/1.5/(1.5+3i)", 1.5, 1.5, 3.0)?,
        constant("1/2.4/(2.9+3.1i)", 2.4, 2.9, 3.1)?,
        Stack::one_film("lacquer/Au", medium(1.5, 0.0)?, named("Au")?),
        Stack::one_film("lacquer/Cu", medium(1.5, 0.0)?, named("Cu")?),
        Stack::one_film("SiO2/Si", named("SiO2")?, named("Si")?),
        Stack::one_film("TiO2/Ti", named("TiO2")?, named("Ti")?),
        mirror,
    ])
}

/// Cosine and thickness (nm), in single precision so that every method gets the same numbers.
pub type Point = [f32; 2];

/// Random points of a range, the same for the same seed.
pub fn points(range: Range, count: usize, seed: u64) -> Vec<Point> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let [least, greatest] = range.nm.map(|nm| nm as f32);
    (0..count)
        .map(|i| {
            let u: f32 = rng.random();
            let cos_theta = if i % GRAZING_SHARE == 0 {
                LEAST_COSINE.powf(u)
            } else {
                LEAST_COSINE + (1.0 - LEAST_COSINE) * u
            };
            [cos_theta, rng.random_range(least..greatest)]
        })
        .collect()
}
