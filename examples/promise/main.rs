//! The long check that a film's error stays within its tolerance: random stacks, three tolerances,
//! many points each. Progress goes to stderr, a report in Markdown to stdout. The exit status is 1 if
//! a film breaks its promise or too many films fall back to the reference.

mod arguments;
#[path = "../../tests/common/promise/mod.rs"]
mod promise;
mod report;

use promise::comparison::Outcome;
use promise::run::{Checked, run};
use promise::summary::{PROMISES, Summary};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Between two lines of progress.
const PAUSE: Duration = Duration::from_secs(10);

fn main() -> ExitCode {
    let settings = match arguments::parse(std::env::args().skip(1)) {
        Ok(settings) => settings,
        Err(message) => {
            eprintln!("{message}");
            return ExitCode::from(2);
        }
    };
    let start = Instant::now();
    let broken = Mutex::new((0, start));
    let checked = run(&settings, |done, checked| {
        let mut broken = broken.lock().unwrap();
        broken.0 += checked.outcomes.iter().filter(|o| o.exceptions > 0).count();
        if broken.1.elapsed() >= PAUSE || done == settings.stacks.len() {
            broken.1 = Instant::now();
            eprintln!(
                "{done} of {} stacks, {} films beyond their tolerance, {:.0} s",
                settings.stacks.len(),
                broken.0,
                start.elapsed().as_secs_f64()
            );
        }
    });
    let outcomes: Vec<Outcome> = checked.iter().flat_map(|c| c.outcomes.clone()).collect();
    let promises = PROMISES
        .into_iter()
        .filter(|promise| settings.tolerances.contains(&promise.tolerance));
    let summaries: Vec<Summary> = promises
        .map(|promise| Summary::new(promise, outcomes.iter()))
        .collect();
    report::print(&settings, &summaries);
    report_costs(&checked, start.elapsed());
    let failures: Vec<String> = summaries.iter().flat_map(Summary::failures).collect();
    for failure in &failures {
        eprintln!("{failure}");
    }
    ExitCode::from(u8::from(!failures.is_empty()))
}

fn report_costs(checked: &[Checked], elapsed: Duration) {
    let points: usize = checked.iter().map(|c| c.truth_points).sum();
    let time: Duration = checked.iter().map(|c| c.truth_time).sum();
    println!("\n{:.0} s in all.", elapsed.as_secs_f64());
    if points > 0 {
        let microseconds = 1e6 * time.as_secs_f64() / points as f64;
        println!("The truth cost {microseconds:.0} us at each of {points} points.");
    }
}
