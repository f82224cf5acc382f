//! How long films take to create and to evaluate from either side: no call may be a thousand times slower than another.

pub mod report;
pub mod suites;

use pellicle::film::{Film, FilmDescription};
use pellicle::optics::stack::Side;
use rustix::time::{ClockId, clock_gettime};
use suites::Suite;

/// The points at which a film is evaluated.
const POINTS: u32 = 64;
/// A call that takes longer is timed once, ns; others are repeated.
const SLOW_NS: f64 = 5000.0;
const CALLS: u32 = 300;

/// What was found of one film.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub name: String,
    pub create_ms: f64,
    /// `None`: creation was refused, for this reason.
    pub film: Result<Found, String>,
}

/// A film that could be made.
#[derive(Clone, Debug)]
pub struct Found {
    pub method: &'static str,
    pub reason: String,
    pub measured_max: f64,
    pub bytes: usize,
    /// Median and greatest time of a call, ns, from the ambient's side and from the base's if light is asked for
    /// there.
    pub front_ns: [f64; 2],
    pub back_ns: Option<[f64; 2]>,
    /// The plan's estimates of the two, ns.
    pub estimated_ns: [Option<f64>; 2],
}

/// The films of a suite, in their order.
pub fn run(suite: &Suite, tolerance: f64) -> Vec<Outcome> {
    let films = suite.films.iter().map(|(name, description)| {
        let description = FilmDescription {
            tolerance,
            ..description.clone()
        };
        outcome(name, &description)
    });
    films.collect()
}

fn outcome(name: &str, description: &FilmDescription) -> Outcome {
    let start = thread_ns();
    let film = Film::new(description);
    let create_ms = (thread_ns() - start) * 1e-6;
    Outcome {
        name: name.to_owned(),
        create_ms,
        film: film
            .map(|film| found(&film))
            .map_err(|error| error.to_string()),
    }
}

fn found(film: &Film) -> Found {
    let plan = film.plan();
    let asks_for_sides = film.description().transmittance;
    let front = |c, d| {
        if asks_for_sides {
            film.colors(Side::Ambient, c, d)
                .expect("it keeps T")
                .reflectance[0]
        } else {
            film.reflectance(c, d)[0]
        }
    };
    let back = |c, d| {
        film.colors(Side::Base, c, d)
            .expect("it keeps T")
            .reflectance[0]
    };
    Found {
        method: plan.method,
        reason: plan.reason.clone(),
        measured_max: plan.measured_max,
        bytes: plan.bytes,
        front_ns: timed(film, front),
        back_ns: asks_for_sides.then(|| timed(film, back)),
        estimated_ns: plan.sides.map(|side| side.map(|side| side.cost_ns)),
    }
}

/// Median and greatest time of a call over scattered points, ns.
fn timed(film: &Film, call: impl Fn(f32, f32) -> f32) -> [f64; 2] {
    let [least, greatest] = film.varying_thickness_nm().unwrap_or([0.0; 2]);
    let mut times: Vec<f64> = (0..POINTS)
        .map(|i| {
            let part = |step: f64| (0.5 + step * f64::from(i)).fract();
            let c = part(0.754_877_666) as f32;
            let d = (least + part(0.569_840_291) * (greatest - least)) as f32;
            let call = || std::hint::black_box(call(std::hint::black_box(c), d));
            let start = thread_ns();
            call();
            let once = thread_ns() - start;
            if once > SLOW_NS {
                return once;
            }
            let start = thread_ns();
            for _ in 0..CALLS {
                call();
            }
            (thread_ns() - start) / f64::from(CALLS)
        })
        .collect();
    times.sort_by(f64::total_cmp);
    [times[times.len() / 2], times[times.len() - 1]]
}

/// The processor's time of this thread, ns.
fn thread_ns() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}
