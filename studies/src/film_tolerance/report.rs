//! The report, in Markdown.

use super::Settings;
use super::comparison::{Difference, Outcome};
use super::kind::{self, KINDS, Kind};
use super::summary::{Summary, quantile};
use crate::shared::markdown::table;

/// The least and the greatest number of the worst films that are listed: those beyond their tolerance, if possible.
const LISTED: [usize; 2] = [3, 10];

/// The methods that take less than a microsecond.
const FAST: [&str; 6] = [
    "two_beam",
    "airy_rgb",
    "quadrature",
    "harmonics",
    "bands",
    "table",
];
/// The greatest number of other films that are listed.
const MOST_SLOW: usize = 40;

const ERRORS: &str = "tolerance | >films | >points | >exceptions | >films with exceptions | >error / tolerance: 99th percentile | >max";
const METHODS: &str = "tolerance | kind | films of each method | >falling back, all | >allowed";
const COSTS: &str =
    "tolerance | >KiB: median | >95th percentile | >max | >ms: median | >95th percentile | >max";

pub fn print(settings: &Settings, summaries: &[Summary]) {
    let points = KINDS.map(|(kind, name)| format!("{name} {}", kind.points(settings.points)));
    println!("# Films against the reference\n");
    println!(
        "Random stacks {} to {} of seed {}{}. Points of each: {}. Films that fall back to the reference are compared \
         at every hundredth point; transmittance and the base's side of general stacks at every tenth, of others at \
         every point, a quarter of which is at the critical angles of the half-spaces.\n",
        settings.stacks.start,
        settings.stacks.end.saturating_sub(1),
        settings.seed,
        settings
            .kind
            .map_or(String::new(), |kind| format!(", {} only", kind.name())),
        points.join(", ")
    );
    println!("{}", table(ERRORS, summaries.iter().map(errors)));
    println!("{}", table(METHODS, summaries.iter().flat_map(methods)));
    print!("{}", table(COSTS, summaries.iter().map(costs)));
    for summary in summaries {
        print_worst(settings, summary);
        print_slow(settings, summary);
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
    let row = |kind: Kind, both_sides| {
        let methods = summary.methods(kind, both_sides);
        let films: usize = methods.iter().map(|(_, count)| count).sum();
        let counts = methods
            .iter()
            .map(|(method, count)| format!("{method} {count}"));
        let counts: Vec<String> = counts.collect();
        let sides = if both_sides { "with T" } else { "R only" };
        (films > 0).then(|| {
            vec![
                format!("{:e}", summary.promise.tolerance),
                format!("{}, {sides}", kind.name()),
                format!("{films}: {}", counts.join(", ")),
                format!("{:.1} %", 100.0 * summary.fallback_share()),
                format!("{:.0} %", 100.0 * summary.promise.greatest_fallback),
            ]
        })
    };
    let rows = KINDS
        .iter()
        .flat_map(|(kind, _)| [row(*kind, false), row(*kind, true)]);
    rows.flatten().collect()
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
        println!("- {}", line(settings.seed, film));
    }
}

/// A film and its greatest error.
pub fn line(seed: u64, film: &Outcome) -> String {
    let stack = kind::stack(seed, film.number);
    let mut line = format!(
        "{:.3} tolerances of {:e}, {} points beyond of {}, method {}, stack {}, {}: `{stack}`",
        film.ratio(),
        film.tolerance,
        film.exceptions,
        film.points,
        film.method,
        film.number,
        film.kind.name(),
    );
    if let Some(worst) = &film.worst {
        let Difference {
            what,
            point: [cosine, nm],
            found,
            truth,
            error,
        } = worst;
        line += &format!(
            "; {what} at cosine {cosine}, {nm} nm: {found:?}, not {truth:?}; error {error:e}"
        );
    }
    line
}

/// Films for which there is no fast method, and films that are refused.
fn print_slow(settings: &Settings, summary: &Summary) {
    let is_slow = |film: &&&Outcome| !FAST.contains(&film.method.as_str());
    let slow: Vec<_> = summary.films.iter().filter(is_slow).collect();
    println!(
        "\n## Slow or refused at {:e}: {}\n",
        summary.promise.tolerance,
        slow.len()
    );
    for film in slow.into_iter().take(MOST_SLOW) {
        let stack = kind::stack(settings.seed, film.number);
        let why = film.refusal.as_deref().unwrap_or_default();
        println!(
            "- {} {why}, {:.0} ms to create, stack {}, {}: `{stack}`",
            film.method,
            1e3 * film.compile_time.as_secs_f64(),
            film.number,
            film.kind.name()
        );
    }
}
