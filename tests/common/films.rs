//! Films to try models with, each compiled once per program.

use pellicle::film::{Film, FilmDescription};
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

fn transmitting(base: Medium) -> FilmDescription {
    FilmDescription {
        transmittance: true,
        ..FilmDescription::new(base)
    }
}

/// What the films are good for.
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
    /// Those that are quick to evaluate: all but the prism's inner face, whose critical angles leave
    /// no table, so that a colour takes half a millisecond.
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
            Self::Lens => transmitting(constant(1.5, 0.0)).layer(constant(1.38, 0.0), [0.0, 600.0]),
            Self::Metal => transmitting(medium("Au")).layer(constant(1.38, 0.0), [300.0; 2]),
            Self::Bubble => transmitting(Medium::vacuum()).layer(medium("water"), [50.0, 900.0]),
            Self::Sunglasses => FilmDescription {
                ambient: medium("air"),
                ..transmitting(medium("BK7"))
            }
            .layer(medium("TiO2"), [100.0, 300.0])
            .layer(medium("Au"), [10.0; 2]),
            Self::Prism => FilmDescription {
                ambient: medium("BK7"),
                ..transmitting(Medium::vacuum())
            }
            .layer(medium("MgF2"), [0.0, 300.0]),
        }
    }
}
