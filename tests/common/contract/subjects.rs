//! Handles to call with arbitrary data: every model with all that can vary varying, and films. Each is
//! made once.

use super::super::common::films::{self, Kind};
use super::super::common::{Drawn, combinations};
use pellicle::Bsdf;
use pellicle::bsdf::models;
use pellicle::capi::*;
use pellicle::film::FilmDescription;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// A handle with what the interface tells of it.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    pub bsdf: *const PellicleBsdf,
    pub info: PellicleBsdfInfo,
    /// Of each varying parameter: how many components, and their range.
    pub varying: &'a [(usize, [f32; 2])],
}

/// A film's handle, which lives as long as the program.
struct Handle(*const PellicleFilm);

// SAFETY: handles are shared freely between threads.
unsafe impl Send for Handle {}

// SAFETY: handles are shared freely between threads.
unsafe impl Send for Subject<'_> {}

/// The handle of that number, which lives as long as the program.
pub fn subject(number: u16) -> Subject<'static> {
    static MADE: Mutex<BTreeMap<(usize, u64, bool), Subject<'static>>> =
        Mutex::new(BTreeMap::new());
    let number = usize::from(number);
    let model = number % models().len();
    let number = number / models().len();
    let combination = (number / 2) as u64 % combinations(&models()[model]);
    let key = (model, combination, number.is_multiple_of(2));
    *MADE.lock().unwrap().entry(key).or_insert_with(|| make(key))
}

fn make((model, combination, varies): (usize, u64, bool)) -> Subject<'static> {
    let entry = &models()[model];
    let (description, varying) = Drawn::new(entry, combination).varying(|| varies);
    let bsdf = bsdf_handle(Bsdf::new(&description).unwrap());
    // SAFETY: plain numbers and pointers, for which 0 is valid; the handle is alive.
    let info = unsafe {
        let mut info = std::mem::zeroed();
        let status = pellicle_bsdf_info(bsdf, &mut info, size_of::<PellicleBsdfInfo>());
        assert_eq!(status, PELLICLE_OK);
        info
    };
    Subject {
        bsdf,
        info,
        varying: varying.leak(),
    }
}

/// A film: tables, curves, methods for one layer, a bare base; none that the reference answers for, whose
/// colours take half a millisecond.
pub fn film(number: usize) -> *const PellicleFilm {
    static MADE: Mutex<BTreeMap<usize, Handle>> = Mutex::new(BTreeMap::new());
    let number = number % (Kind::QUICK.len() + 3);
    let mut made = MADE.lock().unwrap();
    let made = made.entry(number).or_insert_with(|| {
        let film = match number.checked_sub(Kind::QUICK.len()) {
            None => Kind::QUICK[number].film(),
            Some(0) => films::compiled(&films::bare(films::medium("Si"))),
            Some(1) => films::compiled(&FilmDescription {
                method: Some("bands".into()),
                tolerance: 0.1,
                ..films::soap()
            }),
            Some(_) => films::compiled(&FilmDescription {
                unclipped: true,
                ..films::tinted()
            }),
        };
        Handle(film_handle(film, None).unwrap())
    });
    made.0
}
