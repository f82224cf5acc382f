//! The long checks of the library: progress goes to stderr, a report in Markdown to stdout. The exit status is 1 if a
//! check fails.

use lexopt::prelude::*;
use pellicle_studies::shared::progress::Progress;
use pellicle_studies::{f32_vs_f64, film_cliffs, film_tolerance, random_bounds};
use std::process::ExitCode;

const USAGE: &str = "\
usage: check f32_vs_f64     [--evaluations N, 1e8] [--seed N]
       check random_bounds  [--evaluations N, 1e9] [--seed N]
       check film_cliffs    [--tolerance X, 2e-3]
       check film_tolerance [--stacks N, 1000] [--points N of each, 10000] [--seed N]
                            [--stack I: only that one] [--tolerance X: only that one]
                            [--kind general|constant|dispersing|lines|thick: only that one]";

fn main() -> ExitCode {
    let arguments = match Arguments::parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            eprintln!("{error}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    let clock = Progress::new();
    let failures = match arguments.check.as_str() {
        "f32_vs_f64" => {
            let settings = f32_vs_f64::Settings {
                seed: arguments.seed,
                evaluations: arguments.evaluations.unwrap_or(100_000_000),
                surface_elements: 2043,
            };
            let rows = f32_vs_f64::run(&settings);
            f32_vs_f64::report::print(&settings, &rows);
            rows.iter().flat_map(|row| row.failures()).collect()
        }
        "random_bounds" => {
            let tally = random_bounds::run(&random_bounds::Settings {
                seed: arguments.seed,
                evaluations: arguments.evaluations.unwrap_or(1_000_000_000),
                elements: 1024,
                batches: 64,
            });
            random_bounds::report::print(&tally);
            tally.failures
        }
        "film_cliffs" => {
            let tolerance = arguments.tolerance.unwrap_or(2e-3);
            let mut failures = Vec::new();
            for suite in film_cliffs::suites::suites() {
                let outcomes = film_cliffs::run(&suite, tolerance);
                film_cliffs::report::print(suite.name, &outcomes);
                failures.extend(film_cliffs::report::failures(&suite, &outcomes));
            }
            failures
        }
        _ => film_tolerance(arguments),
    };
    println!("\n{:.0} s in all.", clock.start.elapsed().as_secs_f64());
    for failure in &failures {
        eprintln!("{failure}");
    }
    ExitCode::from(u8::from(!failures.is_empty()))
}

fn film_tolerance(arguments: Arguments) -> Vec<String> {
    use film_tolerance::summary::{PROMISES, Summary};
    let promises = PROMISES.into_iter().filter(|promise| {
        arguments
            .tolerance
            .is_none_or(|only| only == promise.tolerance)
    });
    let promises: Vec<_> = promises.collect();
    let settings = film_tolerance::Settings {
        seed: arguments.seed,
        stacks: arguments.stacks,
        kind: arguments.kind,
        points: arguments.points,
        tolerances: promises.iter().map(|promise| promise.tolerance).collect(),
    };
    let outcomes = film_tolerance::run(&settings);
    let summaries = promises
        .into_iter()
        .map(|promise| Summary::new(promise, outcomes.iter()));
    let summaries: Vec<Summary> = summaries.collect();
    film_tolerance::report::print(&settings, &summaries);
    summaries.iter().flat_map(Summary::failures).collect()
}

/// The command line.
struct Arguments {
    check: String,
    evaluations: Option<u64>,
    seed: u64,
    stacks: std::ops::Range<usize>,
    points: usize,
    tolerance: Option<f64>,
    kind: Option<film_tolerance::kind::Kind>,
}

const CHECKS: [&str; 4] = [
    "f32_vs_f64",
    "random_bounds",
    "film_cliffs",
    "film_tolerance",
];

impl Arguments {
    fn parse() -> Result<Self, lexopt::Error> {
        let mut parser = lexopt::Parser::from_env();
        let mut arguments = Self {
            check: String::new(),
            evaluations: None,
            seed: 1,
            stacks: 0..1000,
            points: 10_000,
            tolerance: None,
            kind: None,
        };
        while let Some(argument) = parser.next()? {
            let is_films = ["film_tolerance", "film_cliffs"].contains(&arguments.check.as_str());
            match argument {
                Value(name) if arguments.check.is_empty() => {
                    let name = name.string()?;
                    if !CHECKS.contains(&name.as_str()) {
                        return Err(format!("unknown check '{name}'").into());
                    }
                    arguments.check = name;
                }
                Long("seed") => arguments.seed = parser.value()?.parse()?,
                Long("evaluations") if !is_films => {
                    arguments.evaluations = Some(count(parser.value()?.parse()?)?);
                }
                Long("stacks") if is_films => arguments.stacks = 0..parser.value()?.parse()?,
                Long("stack") if is_films => {
                    let only = parser.value()?.parse()?;
                    arguments.stacks = only..only + 1;
                }
                Long("points") if is_films => arguments.points = parser.value()?.parse()?,
                Long("kind") if is_films => {
                    let name = parser.value()?.string()?;
                    let mut kinds = film_tolerance::kind::KINDS.into_iter();
                    let found = kinds.find(|(_, known)| *known == name);
                    let (kind, _) = found.ok_or_else(|| format!("unknown kind '{name}'"))?;
                    arguments.kind = Some(kind);
                }
                Long("tolerance") if is_films => {
                    let only: f64 = parser.value()?.parse()?;
                    let mut promises = film_tolerance::summary::PROMISES.iter();
                    if !promises.any(|promise| promise.tolerance == only) {
                        return Err(
                            format!("--tolerance {only} is none of 1e-2, 2e-3, 2e-4").into()
                        );
                    }
                    arguments.tolerance = Some(only);
                }
                _ => return Err(argument.unexpected()),
            }
        }
        if arguments.check.is_empty() {
            return Err("which check?".into());
        }
        Ok(arguments)
    }
}

/// A whole number, perhaps written as 1e8.
fn count(number: f64) -> Result<u64, lexopt::Error> {
    if number >= 0.0 && number.fract() == 0.0 {
        Ok(number as u64)
    } else {
        Err(format!("{number} is not a whole number").into())
    }
}
