//! Random evaluations of all models and of random films: none may be NaN, infinite, negative or above
//! its bound. Progress goes to stderr, a report in Markdown to stdout. The exit status is 1 if one is.

#![allow(unsafe_code)] // batches go by addresses

#[path = "../../tests/common/mod.rs"]
mod common;
#[path = "../../tests/common/evaluations/mod.rs"]
mod evaluations;
#[path = "../../tests/common/promise/mod.rs"]
mod promise;

use evaluations::{Settings, Tally, run};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

const USAGE: &str = "usage: evaluations [count, 1e9] [seed, 1]";

/// Between two lines of progress.
const PAUSE: Duration = Duration::from_secs(10);

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some(settings) = settings(&arguments) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    let start = Instant::now();
    let latest = Mutex::new(start);
    let tally = run(&settings, |tally| {
        let mut latest = latest.lock().unwrap();
        if latest.elapsed() >= PAUSE {
            *latest = Instant::now();
            let (total, failures) = (tally.total(), tally.failures.len());
            eprintln!("{total} of {}, {failures} failures", settings.evaluations);
        }
    });
    report(&tally, start.elapsed());
    for failure in &tally.failures {
        eprintln!("{failure}");
    }
    ExitCode::from(u8::from(!tally.failures.is_empty()))
}

fn settings(arguments: &[String]) -> Option<Settings> {
    if arguments.len() > 2 {
        return None;
    }
    let number = |index: usize, default: f64| {
        arguments
            .get(index)
            .map_or(Some(default), |text| text.parse().ok())
    };
    Some(Settings {
        seed: number(1, 1.0)? as u64,
        evaluations: number(0, 1e9)? as u64,
        batches: 512,
    })
}

fn report(tally: &Tally, elapsed: Duration) {
    println!("| call | elements |\n|---|---:|");
    for (call, elements) in &tally.evaluated {
        println!("| {call} | {elements} |");
    }
    println!(
        "| all, of {} descriptions | {} |",
        tally.units,
        tally.total()
    );
    println!("\n| model | greatest weight over its bound | where |\n|---|---:|---|");
    for (model, (ratio, place)) in &tally.weights {
        println!("| {model} | {ratio:.3} | {place} |");
    }
    println!(
        "\n{} failures, {:.0} s.",
        tally.failures.len(),
        elapsed.as_secs_f64()
    );
}
