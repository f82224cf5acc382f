//! Films to try models with, each compiled once per program.

use pellicle::film::{Film, FilmDescription};
use pellicle::num::Rgb;
use pellicle::optics::Medium;
use std::sync::{Arc, OnceLock};

/// A medium whose index is the same at every wavelength.
pub fn constant(eta: f64, k: f64) -> Medium {
    Medium::rgb([eta; 3], [k; 3]).unwrap()
}

pub fn medium(name: &str) -> Medium {
    Medium::named(name).unwrap()
}

pub fn compiled(description: &FilmDescription) -> Arc<Film> {
    Arc::new(Film::new(description).unwrap())
}

/// A base without layers.
pub fn bare(base: Medium) -> FilmDescription {
    FilmDescription::new(base)
}

/// Water between vacuum and vacuum.
pub fn soap() -> FilmDescription {
    bare(constant(1.0, 0.0)).layer(constant(1.33, 0.0), [0.0, 1000.0])
}

/// The inner face of a prism.
pub fn prism() -> FilmDescription {
    FilmDescription {
        ambient: constant(1.5, 0.0),
        ..bare(Medium::vacuum()).layer(constant(1.38, 0.0), [0.0, 400.0])
    }
}

/// Absorbing glass on glass: the sides differ.
pub fn tinted() -> FilmDescription {
    let base = bare(constant(1.5, 0.0));
    base.layer(constant(1.8, 0.1), [0.0, 500.0])
}

/// The film with its transmittance, seen from both sides.
pub fn two_sided(description: FilmDescription) -> FilmDescription {
    FilmDescription {
        transmittance: true,
        ..description
    }
}

/// Range of the thickness that varies, nm; [0, 0] if none does.
pub fn range(film: &Film) -> [f32; 2] {
    film.varying_thickness_nm()
        .unwrap_or([0.0; 2])
        .map(|d| d as f32)
}

/// The greatest difference of a channel.
pub fn difference(a: Rgb<f32>, b: Rgb<f32>) -> f64 {
    let pairs = a.into_iter().zip(b);
    pairs
        .map(|(a, b)| (f64::from(a) - f64::from(b)).abs())
        .fold(0.0, f64::max)
}

/// A colour as a film returns it: clipped to [0, 1], in single precision.
pub fn rounded(rgb: Rgb<f64>) -> Rgb<f32> {
    rgb.map(|x| x.clamp(0.0, 1.0) as f32)
}

/// Films that stand for what they are used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A coated lens, 0-600 nm, nothing disperses.
    Lens,
    /// The same on a metal, of fixed thickness.
    Metal,
    /// Water between vacuum and vacuum, 50-900 nm.
    Bubble,
    /// Two layers, one of which absorbs, on glass; everything disperses; 100-300 nm.
    Sunglasses,
    /// The inner face of a prism, 0-300 nm: light comes from the denser side, which disperses.
    Prism,
}

impl Kind {
    /// The films that are quick to evaluate. The prism's inner face is not: its critical angles allow no table,
    /// so that a colour takes half a millisecond.
    pub const QUICK: [Self; 4] = [Self::Lens, Self::Metal, Self::Bubble, Self::Sunglasses];

    pub const ALL: [Self; 5] = [
        Self::Lens,
        Self::Metal,
        Self::Bubble,
        Self::Sunglasses,
        Self::Prism,
    ];

    /// The film, always the same one.
    pub fn film(self) -> Arc<Film> {
        static FILMS: [OnceLock<Arc<Film>>; Kind::ALL.len()] =
            [const { OnceLock::new() }; Kind::ALL.len()];
        let film = FILMS[self as usize].get_or_init(|| compiled(&self.description()));
        Arc::clone(film)
    }

    pub fn description(self) -> FilmDescription {
        match self {
            Self::Lens => {
                let lens = two_sided(bare(constant(1.5, 0.0)));
                FilmDescription {
                    thickness_spread_max_nm: 300.0,
                    ..lens.layer(constant(1.38, 0.0), [0.0, 600.0])
                }
            }
            Self::Metal => two_sided(bare(medium("Au"))).layer(constant(1.38, 0.0), [300.0; 2]),
            Self::Bubble => FilmDescription {
                thickness_spread_max_nm: 200.0,
                ..two_sided(bare(Medium::vacuum())).layer(medium("water"), [50.0, 900.0])
            },
            Self::Sunglasses => FilmDescription {
                ambient: medium("air"),
                thickness_spread_max_nm: 100.0,
                ..two_sided(bare(medium("BK7")))
            }
            .layer(medium("TiO2"), [100.0, 300.0])
            .layer(medium("Au"), [10.0; 2]),
            Self::Prism => FilmDescription {
                ambient: medium("BK7"),
                ..two_sided(bare(Medium::vacuum()))
            }
            .layer(medium("MgF2"), [0.0, 300.0]),
        }
    }
}
