//! Handles to call with arbitrary data: every model with all parameters fixed or varying, and films. Each is made
//! once.

use crate::shared::directions::rng;
use crate::shared::draw::{Drawn, Variant, Varied, variants};
use crate::shared::films::{self, Kind};
use pellicle::capi::*;
use pellicle::film::FilmDescription;
use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock};

/// A handle, and what the interface says about it.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    pub bsdf: *const PellicleBsdf,
    pub info: PellicleBsdfInfo,
    /// The number of components of each varying parameter, and their range.
    pub varying: &'a [(usize, [f32; 2])],
}

// SAFETY: handles are shared freely between threads.
unsafe impl Send for Subject<'_> {}

/// The handle of that number, which lives as long as the program.
pub fn subject(number: u16) -> Subject<'static> {
    static VARIANTS: OnceLock<Vec<Variant>> = OnceLock::new();
    static MADE: Mutex<BTreeMap<(usize, bool), Subject<'static>>> = Mutex::new(BTreeMap::new());
    let variants = VARIANTS.get_or_init(variants);
    let number = usize::from(number);
    let (variant, varies) = (number / 2 % variants.len(), number.is_multiple_of(2));
    let mut made = MADE.lock().unwrap();
    *made
        .entry((variant, varies))
        .or_insert_with(|| make(&variants[variant], varies))
}

fn make(variant: &Variant, varies: bool) -> Subject<'static> {
    let (drawn, bsdf) = Drawn::new(variant, f64::from(u8::from(varies)), &mut rng(0));
    // Directions may have any length.
    let varying = |varied: &Varied| (varied.components, varied.range.unwrap_or([-1.0, 1.0]));
    let varying: Vec<(usize, [f32; 2])> = drawn.varied.iter().map(varying).collect();
    let bsdf: *const PellicleBsdf = bsdf_handle(bsdf);
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

/// A film's handle, which lives as long as the program.
#[derive(Clone, Copy)]
struct Handle(*const PellicleFilm);

// SAFETY: handles are shared freely between threads.
unsafe impl Send for Handle {}

/// A film: a table, a curve, a method for one layer, a bare base. None is evaluated by the reference, whose colours
/// take half a millisecond.
pub fn film(number: usize) -> *const PellicleFilm {
    static MADE: Mutex<BTreeMap<usize, Handle>> = Mutex::new(BTreeMap::new());
    let number = number % (Kind::QUICK.len() + 3);
    let make = || {
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
    };
    MADE.lock().unwrap().entry(number).or_insert_with(make).0
}
