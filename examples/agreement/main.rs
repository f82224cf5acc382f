//! The long check that single precision agrees with double, at every level of instructions: progress goes to
//! stderr, one table in Markdown to stdout. The exit status is 1 if an error is beyond its bound.

#[path = "../../tests/common/agreement/mod.rs"]
mod agreement;
mod arguments;
#[path = "../../tests/common/mod.rs"]
mod common;
mod report;

use agreement::row::Row;
use agreement::run::run;
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
    let last = Mutex::new(start);
    let rows = run(&settings, |done| {
        let mut last = last.lock().unwrap();
        if last.elapsed() >= PAUSE {
            *last = Instant::now();
            let part = 100.0 * done as f64 / settings.evaluations as f64;
            eprintln!("{part:.0} %, {:.0} s", start.elapsed().as_secs_f64());
        }
    });
    report::print(&settings, &rows);
    println!("\n{:.0} s in all.", start.elapsed().as_secs_f64());
    let failures: Vec<String> = rows.iter().flat_map(Row::failures).collect();
    for failure in &failures {
        eprintln!("{failure}");
    }
    ExitCode::from(u8::from(!failures.is_empty()))
}
