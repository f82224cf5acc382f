//! The report, in Markdown.

use crate::promise::comparison::{Difference, Outcome};
use crate::promise::draw;
use crate::promise::run::Settings;
use crate::promise::summary::{Summary, quantile};

/// The worst films are listed: at least so many, and so many of those that break their promise.
const LISTED: [usize; 2] = [3, 10];

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
    print_errors(summaries);
    print_methods(summaries);
    print_costs(summaries);
    for summary in summaries {
        print_worst(settings, summary);
    }
}

fn print_errors(summaries: &[Summary]) {
    println!(
        "| tolerance | films | points | exceptions | films with exceptions | error / tolerance: \
         99th percentile | max |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for summary in summaries {
        let ratios = summary.sorted(Outcome::ratio);
        println!(
            "| {:e} | {} | {} | {} | {} | {:.3} | {:.3} |",
            summary.promise.tolerance,
            summary.films.len(),
            summary.points(),
            summary.exceptions(),
            summary.broken_films(),
            quantile(&ratios, 0.99),
            quantile(&ratios, 1.0)
        );
    }
}

fn print_methods(summaries: &[Summary]) {
    println!("\n| tolerance | films | share of each method | falling back, all | allowed |");
    println!("|---|---|---|---:|---:|");
    for summary in summaries {
        for both_sides in [false, true] {
            let methods = summary.methods(both_sides);
            let films: usize = methods.iter().map(|(_, count)| count).sum();
            let share = |(method, count): &(&str, usize)| {
                format!("{method} {:.1} %", 100.0 * *count as f64 / films as f64)
            };
            let shares: Vec<String> = methods.iter().map(share).collect();
            println!(
                "| {:e} | {films} {} | {} | {:.1} % | {:.0} % |",
                summary.promise.tolerance,
                if both_sides { "with T" } else { "R only" },
                shares.join(", "),
                100.0 * summary.fallback_share(),
                100.0 * summary.promise.greatest_fallback
            );
        }
    }
}

fn print_costs(summaries: &[Summary]) {
    println!("\n| tolerance | KiB: median | 95th percentile | max | ms: median | 95th | max |");
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for summary in summaries {
        print!("| {:e} |", summary.promise.tolerance);
        let kib = summary.sorted(|film| film.bytes as f64 / 1024.0);
        let ms = summary.sorted(|film| 1e3 * film.compile_time.as_secs_f64());
        for part in [0.5, 0.95, 1.0] {
            print!(" {:.1} |", quantile(&kib, part));
        }
        for part in [0.5, 0.95, 1.0] {
            print!(" {:.1} |", quantile(&ms, part));
        }
        println!();
    }
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
            point.cos_theta,
            point.thickness_nm
        );
    }
}
