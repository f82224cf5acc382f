//! The report, in Markdown.

use super::comparison::{Difference, Outcome};
use super::summary::{Summary, quantile};
use super::{Settings, draw};
use crate::shared::markdown::table;

/// The least and the greatest number of the worst films that are listed: those beyond their tolerance, if possible.
const LISTED: [usize; 2] = [3, 10];

const ERRORS: &str = "tolerance | >films | >points | >exceptions | >films with exceptions | >error / tolerance: 99th percentile | >max";
const METHODS: &str = "tolerance | films | share of each method | >falling back, all | >allowed";
const COSTS: &str =
    "tolerance | >KiB: median | >95th percentile | >max | >ms: median | >95th percentile | >max";

pub fn print(settings: &Settings, summaries: &[Summary]) {
    println!("# Films against the reference\n");
    println!(
        "Random stacks {} to {} of seed {}, {} points each; films that fall back to the reference \
         are compared at every hundredth point, transmittance and the base's side at every tenth.\n",
        settings.stacks.start,
        settings.stacks.end.saturating_sub(1),
        settings.seed,
        settings.points
    );
    println!("{}", table(ERRORS, summaries.iter().map(errors)));
    println!("{}", table(METHODS, summaries.iter().flat_map(methods)));
    print!("{}", table(COSTS, summaries.iter().map(costs)));
    for summary in summaries {
        print_worst(settings, summary);
    }
}

fn errors(summary: &Summary) -> Vec<String> {
    let ratios = summary.sorted(Outcome::ratio);
    vec![
        format!("{:e}", summary.promise.tolerance),
        summary.films.len().to_string(),
        summary.points().to_string(),
        summary.exceptions().to_string(),
        summary.broken_films().to_string(),
        format!("{:.3}", quantile(&ratios, 0.99)),
        format!("{:.3}", quantile(&ratios, 1.0)),
    ]
}

fn methods(summary: &Summary) -> Vec<Vec<String>> {
    let row = |both_sides| {
        let methods = summary.methods(both_sides);
        let films: usize = methods.iter().map(|(_, count)| count).sum();
        let share = |(method, count): &(&str, usize)| {
            format!("{method} {:.1} %", 100.0 * *count as f64 / films as f64)
        };
        let shares: Vec<String> = methods.iter().map(share).collect();
        vec![
            format!("{:e}", summary.promise.tolerance),
            format!("{films} {}", if both_sides { "with T" } else { "R only" }),
            shares.join(", "),
            format!("{:.1} %", 100.0 * summary.fallback_share()),
            format!("{:.0} %", 100.0 * summary.promise.greatest_fallback),
        ]
    };
    [false, true].map(row).into()
}

fn costs(summary: &Summary) -> Vec<String> {
    let kib = summary.sorted(|film| film.bytes as f64 / 1024.0);
    let ms = summary.sorted(|film| 1e3 * film.compile_time.as_secs_f64());
    let parts =
        |numbers: &[f64]| [0.5, 0.95, 1.0].map(|part| format!("{:.1}", quantile(numbers, part)));
    let mut row = vec![format!("{:e}", summary.promise.tolerance)];
    row.extend([kib, ms].iter().flat_map(|numbers| parts(numbers)));
    row
}

fn print_worst(settings: &Settings, summary: &Summary) {
    println!("\n## Worst at {:e}\n", summary.promise.tolerance);
    let listed = summary.broken_films().clamp(LISTED[0], LISTED[1]);
    for film in summary.worst().into_iter().take(listed) {
        let Some(worst) = &film.worst else { continue };
        let Difference {
            what,
            point,
            found,
            truth,
            error,
        } = worst;
        println!(
            "- {:.3} tolerances, {} points beyond, method {}, stack {}: `{}`; {what} at cosine {}, \
             {} nm: {found:?}, not {truth:?}; error {error:e}",
            film.ratio(),
            film.exceptions,
            film.method,
            film.number,
            draw::stack(settings.seed, film.number),
            point[0],
            point[1]
        );
    }
}
