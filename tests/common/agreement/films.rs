//! Films of every method, against the f64 instance of the method, or, where a method evaluates a table or
//! in double precision already, against the reference.

use super::batch::reflectances;
use super::row::{Quantity, Row};
use crate::common::films::{bare, constant, medium, soap};
use pellicle::film::{CompiledMethod, Film, FilmDescription, METHODS, OneLayer, OneLayerMethod};
use pellicle::num::Level;
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
    Method(Box<dyn CompiledMethod<f64>>),
    /// Converged wave optics, which is slow: at one in so many elements.
    Reference(usize),
}

/// Of all methods.
pub fn names() -> [&'static str; METHODS.len()] {
    METHODS
}

/// Films of every method.
pub fn subjects() -> Vec<Subject> {
    let of = |method| {
        let descriptions = descriptions(method).into_iter();
        let all: Vec<Subject> = descriptions
            .filter_map(|description| Subject::new(method, description))
            .collect();
        assert!(all.len() >= 2, "few films can be had by {method}");
        all
    };
    names().into_iter().flat_map(of).collect()
}

/// Soap, a dielectric, a metal, and two films so thick that their phase is hundreds of turns.
fn one_layer() -> [FilmDescription; 5] {
    let metal = bare(constant(2.9, 3.1)).layer(constant(2.4, 0.0), [0.0, 1000.0]);
    let lens = bare(constant(1.52, 0.0)).layer(constant(1.38, 0.0), [0.0, 600.0]);
    let thick = bare(medium("Au")).layer(constant(1.5, 0.0), [3e3, 1e5]);
    let thick_lens = bare(constant(1.52, 0.0)).layer(constant(1.38, 0.0), [3e3, 1e5]);
    [soap(), lens, metal, thick, thick_lens]
}

fn descriptions(method: &'static str) -> Vec<FilmDescription> {
    let forced = |description: FilmDescription, tolerance| FilmDescription {
        method: Some(method.to_owned()),
        tolerance,
        ..description
    };
    // As coarse as the method comes: here it is held against itself.
    let coarsest = || one_layer().map(|film| forced(film, 1.0)).to_vec();
    match method {
        "schlick" => [bare(medium("Au")), bare(constant(1.5, 0.0))]
            .map(|film| forced(film, 1.0))
            .to_vec(),
        "fresnel" => {
            let inside = FilmDescription {
                ambient: constant(1.5, 0.0),
                ..bare(constant(1.0, 0.0))
            };
            vec![forced(bare(constant(1.5, 0.0)), 1e-3), forced(inside, 1e-3)]
        }
        "table" => {
            let [soap, lens, metal, ..] = one_layer();
            let fixed = bare(medium("Au")).layer(constant(1.5, 0.0), [250.0; 2]);
            [(soap, 2e-3), (lens, 2e-4), (metal, 1e-2), (fixed, 2e-3)]
                .map(|(film, tolerance)| forced(film, tolerance))
                .to_vec()
        }
        "quadrature" | "harmonics" | "bands" => {
            let [_, lens, metal, ..] = one_layer();
            let mut all = coarsest();
            all.push(forced(lens, 1e-3));
            all.push(forced(metal, 5e-2));
            all
        }
        "series" | "reference" => {
            let [soap, lens, ..] = one_layer();
            vec![forced(soap, 2e-3), forced(lens, 2e-3)]
        }
        _ => coarsest(),
    }
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
            _ => Truth::Method(kind(&film).double(&layer(&description)).unwrap()),
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

    /// What the table's bound is made of: 0 where the truth is the same formula.
    pub fn tolerance(&self) -> f64 {
        match self.truth {
            Truth::Reference(_) => self.film.description().tolerance,
            _ => 0.0,
        }
    }

    /// How many times as many elements of other films take as long.
    pub fn slowness(&self) -> usize {
        match self.truth {
            Truth::Reference(1) => 1000,
            Truth::Reference(_) => 8,
            _ => 4,
        }
    }

    fn place(&self, cos_theta: f32, thickness_nm: f32, what: String) -> String {
        let description = self.film.description();
        let media = description.layers.iter().map(|layer| &layer.medium);
        let indices = [&description.ambient]
            .into_iter()
            .chain(media)
            .chain([&description.base]);
        let indices: Vec<String> = indices
            .map(|medium| {
                let index = medium.index(550.0);
                format!("{:.4}+{:.4}i", index.re, index.im)
            })
            .collect();
        format!(
            "indices {} at 550 nm, cosine {cos_theta:e}, {thickness_nm} nm, {}: {what}",
            indices.join(" / "),
            self.film.plan().reason
        )
    }

    /// So many elements.
    pub fn check(&self, count: usize, rng: &mut impl Rng, row: &mut Row) {
        let [min, max] = self.film.varying_thickness_nm().unwrap_or([0.0, 1.0]);
        let (mut cos_theta, mut thickness_nm) = (Vec::new(), Vec::new());
        for _ in 0..count {
            cos_theta.push(cosine(rng));
            thickness_nm.push(thickness(rng, min as f32, max as f32));
        }
        let levels = Level::all();
        let found = |level| reflectances(&self.film, level, &cos_theta, &thickness_nm);
        let first = found(levels[0]);
        let add = |i: usize, found: [f32; 3], row: &mut Row| {
            let Some(truth) = self.truth(i, cos_theta[i], thickness_nm[i]) else {
                return;
            };
            let errors = found.into_iter().zip(truth).map(|(found, truth)| {
                if found.is_finite() {
                    (f64::from(found) - truth.clamp(0.0, 1.0)).abs()
                } else {
                    f64::INFINITY
                }
            });
            row.add(Quantity::Reflectance, errors.fold(0.0, f64::max), || {
                let what = format!("{found:?}, not {truth:?}");
                self.place(cos_theta[i], thickness_nm[i], what)
            });
        };
        for (i, found) in first.iter().enumerate() {
            add(i, *found, row);
        }
        let single = |i: usize| self.film.reflectance(cos_theta[i], thickness_nm[i]);
        let more = levels[1..].iter();
        let mut others: Vec<_> = more.map(|level| (level.name(), found(*level))).collect();
        others.push(("single call", (0..count).map(single).collect()));
        for (name, found) in others {
            for (i, (first, found)) in first.iter().zip(&found).enumerate() {
                if first.map(f32::to_bits) == found.map(f32::to_bits) {
                    continue;
                }
                let differences = first
                    .iter()
                    .zip(found)
                    .map(|(a, b)| f64::from((a - b).abs()));
                row.add_difference(differences.fold(0.0, f64::max), || {
                    let what = format!("{name}: {found:?}, not {first:?}");
                    self.place(cos_theta[i], thickness_nm[i], what)
                });
                add(i, *found, row);
            }
        }
        row.evaluations += count as u64;
    }

    fn truth(&self, i: usize, cos_theta: f32, thickness_nm: f32) -> Option<[f64; 3]> {
        // Films take smaller cosines for this.
        let cosine = f64::from(cos_theta.max(1e-9));
        let thickness = f64::from(thickness_nm);
        Some(match &self.truth {
            Truth::Schlick => self
                .film
                .reflectance(1.0, 0.0)
                .map(|f0| schlick(f64::from(f0), cosine)),
            Truth::Fresnel(eta) => [dielectric_reflectance(cosine, *eta); 3],
            Truth::Method(method) => method.reflectance(cosine, thickness),
            Truth::Reference(every) if i.is_multiple_of(*every) => {
                self.film.reference(cosine, thickness)
            }
            Truth::Reference(_) => return None,
        })
    }
}

/// The method and size that a plan's reason begins with.
fn kind(film: &Film) -> OneLayerMethod {
    let reason = film.plan().reason.as_str();
    let sizes = 1..=256;
    let sized = sizes.flat_map(|n| {
        [
            OneLayerMethod::Quadrature(n),
            OneLayerMethod::Bands(n),
            OneLayerMethod::Harmonics(n),
        ]
    });
    let mut kinds = [OneLayerMethod::TwoBeam, OneLayerMethod::AiryRgb]
        .into_iter()
        .chain(sized);
    let found = kinds.find(|kind| reason.starts_with(&format!("{}:", kind.cost())));
    found.unwrap_or_else(|| panic!("no method is '{reason}'"))
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

/// Evenly, at the ends, and close to them.
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

fn thickness(rng: &mut impl Rng, min: f32, max: f32) -> f32 {
    let u = rng.random::<f32>();
    match rng.random_range(0..10) {
        0 => min,
        1 => max,
        2 => min + (max - min) * 1e-6f32.powf(u),
        _ => min + (max - min) * u,
    }
}
