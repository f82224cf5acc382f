//! Films saved and loaded, by kind: bytes of the block, time of creation, median time to load one, and time to load 500.

use pellicle::film::{Film, FilmDescription};
use pellicle::optics::Medium;
use std::hint::black_box;
use std::time::{Duration, Instant};

const COATINGS: usize = 500;
/// Films that take longer to load are not loaded that often, ms.
const SLOW_MS: f64 = 10.0;

fn named(name: &str) -> Medium {
    Medium::named(name).expect("a known name")
}

fn constant(eta: f64) -> Medium {
    Medium::rgb([eta; 3], [0.0; 3]).expect("a valid index")
}

fn with(method: &str, tolerance: f64, description: FilmDescription) -> FilmDescription {
    FilmDescription {
        method: Some(method.into()),
        tolerance,
        ..description
    }
}

fn both_sides(description: FilmDescription) -> FilmDescription {
    FilmDescription {
        transmittance: true,
        ..description
    }
}

fn films() -> Vec<(&'static str, FilmDescription)> {
    let glass = || FilmDescription::new(constant(1.5));
    let lens = || glass().layer(constant(1.38), [0.0, 1000.0]);
    let measured: Vec<f64> = (0..4000).map(|i| 380.0 + 0.1 * f64::from(i)).collect();
    let eta: Vec<f64> = measured.iter().map(|nm| 1.4 + 1e4 / (nm * nm)).collect();
    let measured = Medium::table(&measured, &eta, &[0.0; 4000]).expect("a valid table");
    let alternating = |mut description: FilmDescription, count| {
        for i in 0..count {
            description = description.layer(named(["SiO2", "TiO2"][i % 2]), [80.0; 2]);
        }
        description
    };
    let metal = || FilmDescription::new(named("Ti")).layer(named("TiO2"), [0.0, 300.0]);
    vec![
        ("bare glass, fresnel", glass()),
        (
            "bare gold, over the cosine",
            FilmDescription::new(named("Au")),
        ),
        ("anodised titanium, table", metal()),
        (
            "soap, table",
            FilmDescription::new(Medium::vacuum()).layer(constant(1.33), [0.0, 1000.0]),
        ),
        (
            "MgF2 on BK7, both sides, tables",
            both_sides(FilmDescription::new(named("BK7"))).layer(named("MgF2"), [0.0, 300.0]),
        ),
        (
            "10 um of water on BK7, both sides, patches",
            both_sides(FilmDescription::new(named("BK7"))).layer(named("H2O"), [0.0, 1e4]),
        ),
        (
            "mirror of 20 layers, over the cosine",
            alternating(FilmDescription::new(named("SiO2")), 20),
        ),
        (
            "layer of 4,000 measurements, table",
            glass().layer(measured, [0.0, 300.0]),
        ),
        ("airy_rgb", with("airy_rgb", 0.5, lens())),
        ("quadrature", with("quadrature", 1e-2, lens())),
        ("harmonics", with("harmonics", 0.1, lens())),
        ("bands", with("bands", 5e-4, lens())),
        ("series at 2e-3", with("series", 2e-3, lens())),
        (
            "series of 21 layers at 1e-2",
            with(
                "series",
                1e-2,
                alternating(
                    both_sides(FilmDescription::new(named("BK7"))).layer(named("Ag"), [20.0; 2]),
                    20,
                ),
            ),
        ),
        ("reference", with("reference", 2e-3, metal())),
    ]
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let made = work();
    (made, milliseconds(start.elapsed()))
}

fn main() {
    println!("| film | size | bytes | create, ms | load, ms (median) | 500 at once, ms |");
    println!("|---|---|---|---|---|---|");
    for (name, description) in films() {
        let (film, created) = timed(|| Film::new(&description));
        let film = match film {
            Ok(film) => film,
            Err(error) => {
                println!("| {name} | {error} | | | | |");
                continue;
            }
        };
        let block = film.to_bytes().expect("memory");
        let load = || black_box(Film::from_bytes(black_box(&block)).expect("the same build"));
        let mut times: Vec<f64> = (0..101).map(|_| timed(load).1).collect();
        times.sort_by(f64::total_cmp);
        let median = times[times.len() / 2];
        let together = if median < SLOW_MS {
            let (all, together) = timed(|| (0..COATINGS).map(|_| load()).collect::<Vec<_>>());
            drop(all);
            format!("{together:.1}")
        } else {
            "not tried".to_owned()
        };
        let size = film.plan().reason.split(':').next().unwrap_or_default();
        println!(
            "| {name} | {size} | {} | {created:.1} | {median:.4} | {together} |",
            block.len()
        );
    }
}
