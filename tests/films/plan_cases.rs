//! Films to plan, and how what was planned is measured.

use crate::common::films::{bare, constant};
use crate::common::rng;
use pellicle::Status;
use pellicle::film::{Film, FilmDescription};
use pellicle::num::Rgb;
use rand::RngExt;

pub const METHODS: [&str; 10] = [
    "schlick",
    "fresnel",
    "table",
    "two_beam",
    "airy_rgb",
    "quadrature",
    "harmonics",
    "bands",
    "series",
    "reference",
];
/// The methods that take one layer.
pub const ONE_LAYER: [&str; 5] = ["two_beam", "airy_rgb", "quadrature", "harmonics", "bands"];

/// Index of film, index and k of base: the stacks that other renderers were measured on.
pub const STACKS: [(f64, f64, f64); 6] = [
    (1.33, 1.0, 0.0),
    (1.5, 1.33, 0.0),
    (1.38, 1.52, 0.0),
    (2.4, 1.5, 0.0),
    (1.5, 1.5, 3.0),
    (2.4, 2.9, 3.1),
];

pub fn stack((film, base, k): (f64, f64, f64), thickness_nm: [f64; 2]) -> FilmDescription {
    bare(constant(base, k)).layer(constant(film, 0.0), thickness_nm)
}

/// Magnesium fluoride on glass.
pub fn lens() -> FilmDescription {
    stack(STACKS[2], [0.0, 1000.0])
}

pub fn with(method: &str, tolerance: f64, description: &FilmDescription) -> FilmDescription {
    FilmDescription {
        method: Some(method.into()),
        tolerance,
        ..description.clone()
    }
}

pub fn film(description: &FilmDescription) -> Film {
    Film::new(description).unwrap()
}

pub fn method(film: &Film) -> &'static str {
    film.plan().method
}

/// The status and the message of a film that must not be created.
pub fn refusal(description: &FilmDescription) -> (Status, String) {
    let error = Film::new(description).err().expect("this film is refused");
    (error.status, error.message.into_owned())
}

/// The greatest difference of channels held in \[0, 1\].
pub fn difference(a: Rgb<f64>, b: Rgb<f64>) -> f64 {
    let pairs = a.into_iter().zip(b);
    pairs
        .map(|(a, b)| (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).abs())
        .fold(0.0, f64::max)
}

/// `count` pairs of cosine and thickness, the corners of both ranges first, and a third of the others towards
/// grazing angles and thin films. The corner where both are 0 is left out; it has a test of its own.
pub fn points(film: &Film, count: usize) -> Vec<(f32, f32)> {
    let [least, greatest] = film.varying_thickness_nm().unwrap_or([0.0; 2]);
    let corners = [0.0f32, 1e-3, 1.0].map(|c| [(c.max(1e-6), 0.0), (c, 1e-3), (c, 1.0)]);
    let mut rng = rng(311);
    let random = (0..count).map(|i| {
        let power = if i % 3 == 0 { 3 } else { 1 };
        [(); 2].map(|()| rng.random::<f32>().powi(power)).into()
    });
    let unit = corners.into_iter().flatten().chain(random).take(count);
    let at = |(c, part): (f32, f32)| (c, least as f32 + part * (greatest - least) as f32);
    unit.map(at).collect()
}

/// Greatest error against the reference and root of the mean square, from the ambient's side.
pub fn errors(film: &Film, count: usize) -> (f64, f64) {
    let points = points(film, count);
    let (mut max, mut squares) = (0.0f64, 0.0);
    for (c, d) in &points {
        let truth = film.reference(f64::from(*c), f64::from(*d));
        let found = film.reflectance(*c, *d).map(f64::from);
        max = max.max(difference(found, truth));
        for channel in 0..3 {
            squares += (found[channel] - truth[channel].clamp(0.0, 1.0)).powi(2);
        }
    }
    (max, (squares / (3 * points.len()) as f64).sqrt())
}
