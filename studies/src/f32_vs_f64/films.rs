//! Films of every method, against the f64 instance of the method, or, where a method evaluates a table or computes
//! in double precision already, against the reference.

use super::at_every_level;
use super::row::{Quantity, Row};
use crate::shared::batch::reflectances;
use crate::shared::films::{bare, constant, medium, soap};
use crate::shared::peer::{TwoPrecisions, all_kinds, uses};
use crate::shared::stack::clipped_error;
use pellicle::film::{Film, FilmDescription, METHODS, OneLayer};
use pellicle::optics::{dielectric_reflectance, schlick};
use rand::{Rng, RngExt};

/// A film whose method is known.
pub struct Subject {
    pub method: &'static str,
    pub film: Film,
    truth: Truth,
}

/// What a film should return, not clipped.
enum Truth {
    /// Schlick's approximation from the colour at normal incidence.
    Schlick,
    /// Fresnel's equations for this relative index.
    Fresnel(f64),
    /// The method in double precision.
    Method(Box<TwoPrecisions>),
    /// Converged wave optics, which is slow: of this many elements the first is compared.
    Reference(usize),
}

/// The names of all methods.
pub fn names() -> [&'static str; METHODS.len()] {
    METHODS
}

/// Films of every method.
pub fn subjects() -> Vec<Subject> {
    let of = |method| {
        let new = |description| Subject::new(method, description);
        let all: Vec<Subject> = descriptions(method).into_iter().filter_map(new).collect();
        assert!(all.len() >= 2, "{method} takes too few of the films");
        all
    };
    names().into_iter().flat_map(of).collect()
}

/// Soap, a dielectric, a metal, and two films so thick that their phase is hundreds of turns.
fn one_layer() -> [FilmDescription; 5] {
    let on = |base, eta, nm| bare(base).layer(constant(eta, 0.0), nm);
    [
        soap(),
        on(constant(1.52, 0.0), 1.38, [0.0, 600.0]),
        on(constant(2.9, 3.1), 2.4, [0.0, 1000.0]),
        on(medium("Au"), 1.5, [3e3, 1e5]),
        on(constant(1.52, 0.0), 1.38, [3e3, 1e5]),
    ]
}

fn descriptions(method: &'static str) -> Vec<FilmDescription> {
    let [soap, lens, metal, ..] = one_layer();
    let glass = bare(constant(1.5, 0.0));
    let films = match method {
        "schlick" => vec![(bare(medium("Au")), 1.0), (glass, 1.0)],
        "fresnel" => {
            let inside = FilmDescription {
                ambient: constant(1.5, 0.0),
                ..bare(constant(1.0, 0.0))
            };
            vec![(glass, 1e-3), (inside, 1e-3)]
        }
        "table" => {
            let fixed = bare(medium("Au")).layer(constant(1.5, 0.0), [250.0; 2]);
            vec![(soap, 2e-3), (lens, 2e-4), (metal, 1e-2), (fixed, 2e-3)]
        }
        "series" | "reference" => vec![(soap, 2e-3), (lens, 2e-3)],
        _ => {
            // A tolerance of 1 chooses the coarsest size: here a method is compared with itself.
            let mut all = one_layer().map(|film| (film, 1.0)).to_vec();
            if ["quadrature", "harmonics", "bands"].contains(&method) {
                all.extend([(lens, 1e-3), (metal, 5e-2)]);
            }
            all
        }
    };
    let forced = |(film, tolerance): (FilmDescription, f64)| FilmDescription {
        method: Some(method.to_owned()),
        tolerance,
        ..film
    };
    films.into_iter().map(forced).collect()
}

impl Subject {
    /// None if the method is too coarse for the film.
    fn new(method: &'static str, description: FilmDescription) -> Option<Self> {
        let film = Film::new(&description).ok()?;
        let truth = match method {
            "schlick" => Truth::Schlick,
            "fresnel" => {
                let [ambient, base] = film.half_spaces().map(|medium| medium.index(550.0).re);
                Truth::Fresnel(base / ambient)
            }
            "table" => Truth::Reference(50),
            "series" | "reference" => Truth::Reference(1),
            _ => {
                let kind = all_kinds().into_iter().find(|kind| uses(&film, *kind));
                let kind = kind.unwrap_or_else(|| panic!("unknown method: {:?}", film.plan()));
                Truth::Method(Box::new(
                    TwoPrecisions::new(kind, layer(&description)).unwrap(),
                ))
            }
        };
        Some(Self {
            method,
            film,
            truth,
        })
    }

    /// The method, and the tolerance if it counts.
    pub fn name(&self) -> String {
        match self.tolerance() {
            0.0 => format!("films by {}", self.method),
            tolerance => format!("films by {}, {tolerance:e}", self.method),
        }
    }

    /// The tolerance where the film is compared with the reference; 0 where the truth is the same formula.
    pub fn tolerance(&self) -> f64 {
        match self.truth {
            Truth::Reference(_) => self.film.description().tolerance,
            _ => 0.0,
        }
    }

    /// The time of an element, in those of surfaces.
    pub fn slowness(&self) -> usize {
        match self.truth {
            Truth::Reference(1) => 1000,
            Truth::Reference(_) => 8,
            _ => 4,
        }
    }

    fn place(&self, [cos_theta, thickness_nm]: [f32; 2], what: String) -> String {
        let description = self.film.description();
        let media = description.layers.iter().map(|layer| &layer.medium);
        let indices = [&description.ambient]
            .into_iter()
            .chain(media)
            .chain([&description.base])
            .map(|medium| medium.index(550.0));
        let indices: Vec<String> = indices
            .map(|n| format!("{:.4}+{:.4}i", n.re, n.im))
            .collect();
        format!(
            "indices {} at 550 nm, cosine {cos_theta:e}, {thickness_nm} nm, {}: {what}",
            indices.join(" / "),
            self.film.plan().reason
        )
    }

    /// Checks that number of elements.
    pub fn check(&self, count: usize, rng: &mut impl Rng, row: &mut Row) {
        let range = self.film.varying_thickness_nm().unwrap_or([0.0, 1.0]);
        let points = (0..count).map(|_| [cosine(rng), thickness(rng, range.map(|nm| nm as f32))]);
        let points: Vec<[f32; 2]> = points.collect();
        at_every_level(
            |level| reflectances(&self.film, level, &points).unwrap(),
            |i| self.film.reflectance(points[i][0], points[i][1]),
            |first, found| first.map(f32::to_bits) == found.map(f32::to_bits),
            |i, found, other| {
                if let Some((name, first)) = other {
                    let differences = first
                        .iter()
                        .zip(found)
                        .map(|(a, b)| f64::from((a - b).abs()));
                    row.add_difference(differences.fold(0.0, f64::max), || {
                        self.place(points[i], format!("{name}: {found:?}, not {first:?}"))
                    });
                }
                if let Some(truth) = self.truth(i, points[i]) {
                    let is_finite = found.iter().all(|channel| channel.is_finite());
                    let error = if is_finite {
                        clipped_error(*found, truth)
                    } else {
                        f64::INFINITY
                    };
                    row.add(Quantity::Reflectance, error, || {
                        self.place(points[i], format!("{found:?}, not {truth:?}"))
                    });
                }
            },
        );
        row.evaluations += count as u64;
    }

    fn truth(&self, i: usize, point: [f32; 2]) -> Option<[f64; 3]> {
        let [cos_theta, thickness_nm] = point.map(f64::from);
        // Films take smaller cosines for this.
        let cos_theta = cos_theta.max(f64::from(1e-9f32));
        Some(match &self.truth {
            Truth::Schlick => {
                let normal = self.film.reflectance(1.0, 0.0);
                normal.map(|f0| schlick(f64::from(f0), cos_theta))
            }
            Truth::Fresnel(eta) => [dielectric_reflectance(cos_theta, *eta); 3],
            Truth::Method(method) => method.double(cos_theta, thickness_nm),
            Truth::Reference(every) if i.is_multiple_of(*every) => {
                self.film.reference(cos_theta, thickness_nm)
            }
            Truth::Reference(_) => return None,
        })
    }
}

fn layer(description: &FilmDescription) -> OneLayer {
    let FilmDescription {
        ambient,
        layers,
        base,
        white,
        color_space,
        ..
    } = description.clone();
    OneLayer::new(ambient, layers[0].medium.clone(), base, white, color_space).unwrap()
}

/// Uniform, at the ends, and close to them.
fn cosine(rng: &mut impl Rng) -> f32 {
    let u = rng.random::<f32>();
    match rng.random_range(0..10) {
        0 => 1.0,
        1 => 1.0 - 1e-7f32.powf(u),
        2 | 3 => 1e-3f32.powf(u),
        4 => 1e-38f32.powf(u),
        _ => u,
    }
}

fn thickness(rng: &mut impl Rng, [min, max]: [f32; 2]) -> f32 {
    let u = rng.random::<f32>();
    match rng.random_range(0..10) {
        0 => min,
        1 => max,
        2 => min + (max - min) * 1e-6f32.powf(u),
        _ => min + (max - min) * u,
    }
}
