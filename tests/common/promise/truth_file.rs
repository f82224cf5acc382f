//! The truth of a stack, kept in a file, so that repeated runs cost only the films.
//!
//! The first line is the stack; then f64 follow: per point cosine, thickness and the reflectance,
//! and where both sides are checked the other three colours. A file of another stack is not used,
//! nor anything after the first other point. A file knows nothing of the library's version: delete
//! it when the reference or the media change.

use super::points::Point;
use super::stack::Stack;
use super::truth::{Sides, Truth, has_sides};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

fn path(folder: &Path, stack: &Stack) -> PathBuf {
    let mut hasher = DefaultHasher::new();
    stack.to_string().hash(&mut hasher);
    folder.join(format!("{:016x}.truth", hasher.finish()))
}

/// What is known of the first points: possibly nothing.
pub fn load(folder: &Path, stack: &Stack, points: &[Point]) -> Vec<Truth> {
    let file = fs::read(path(folder, stack)).unwrap_or_default();
    let Some(records) = file.strip_prefix(header(stack).as_bytes()) else {
        return Vec::new();
    };
    let (chunks, _) = records.as_chunks();
    let mut numbers = chunks.iter().map(|chunk| f64::from_le_bytes(*chunk));
    let mut known = Vec::new();
    for (i, point) in points.iter().enumerate() {
        match read(&mut numbers, point, has_sides(stack, i)) {
            Some(truth) => known.push(truth),
            None => break,
        }
    }
    known
}

/// Replaces the file.
pub fn save(folder: &Path, stack: &Stack, points: &[Point], known: &[Truth]) {
    let mut bytes = header(stack).into_bytes();
    for (point, truth) in points.iter().zip(known) {
        let mut numbers = arguments(point).to_vec();
        numbers.extend(truth.reflectance);
        if let Some(sides) = &truth.sides {
            numbers.extend(sides.transmittance);
            numbers.extend(sides.reflectance_from_base);
            numbers.extend(sides.transmittance_from_base);
        }
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    }
    let path = path(folder, stack);
    let unfinished = path.with_extension("unfinished");
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(&unfinished, bytes))
        .and_then(|()| fs::rename(&unfinished, &path))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

fn header(stack: &Stack) -> String {
    format!("{stack}\n")
}

fn arguments(point: &Point) -> [f64; 2] {
    [point.cos_theta.into(), point.thickness_nm.into()]
}

/// The next record, if it is complete and that of the point.
fn read(numbers: &mut impl Iterator<Item = f64>, point: &Point, both_sides: bool) -> Option<Truth> {
    if [numbers.next()?, numbers.next()?] != arguments(point) {
        return None;
    }
    let mut color = || Some([numbers.next()?, numbers.next()?, numbers.next()?]);
    let reflectance = color()?;
    let sides = if both_sides {
        Some(Sides {
            transmittance: color()?,
            reflectance_from_base: color()?,
            transmittance_from_base: color()?,
        })
    } else {
        None
    };
    Some(Truth { reflectance, sides })
}
