//! Prints what was found.

use super::Outcome;
use super::suites::Suite;

/// A call slower than this is a cliff, ns.
pub const SLOW_NS: f64 = 1000.0;

/// The films of a suite, and a summary line.
pub fn print(name: &str, outcomes: &[Outcome]) {
    println!("\n## {name}\n");
    println!(
        "| film | create ms | method | error | KiB | front ns: median, worst (the plan's estimate) | back |"
    );
    println!("|---|---:|---|---:|---:|---:|---:|");
    for outcome in outcomes {
        let create = format!("{:.1}", outcome.create_ms);
        match &outcome.film {
            Ok(found) => {
                let pair = |side: usize, [median, worst]: [f64; 2]| {
                    let estimate = found.estimated_ns[side];
                    let estimate = estimate.map_or(String::new(), |ns| format!(" ({ns:.0})"));
                    format!("{median:.0}, {worst:.0}{estimate}")
                };
                println!(
                    "| {} | {create} | {} | {:.1e} | {} | {} | {} |",
                    outcome.name,
                    found.reason.split(':').next().unwrap_or(found.method),
                    found.measured_max,
                    found.bytes / 1024,
                    pair(0, found.front_ns),
                    found.back_ns.map_or(String::new(), |back| pair(1, back))
                );
            }
            Err(reason) => println!(
                "| {} | {create} | refused: {reason} | | | | |",
                outcome.name
            ),
        }
    }
    let mut create: Vec<f64> = outcomes.iter().map(|outcome| outcome.create_ms).collect();
    create.sort_by(f64::total_cmp);
    println!(
        "\n{} films: {} refused, {} with a call slower than {SLOW_NS} ns; create median {:.1} ms, worst {:.0} ms",
        outcomes.len(),
        outcomes
            .iter()
            .filter(|outcome| outcome.film.is_err())
            .count(),
        outcomes.iter().filter(|outcome| outcome.is_slow()).count(),
        create[create.len() / 2],
        create[create.len() - 1]
    );
}

/// What makes the check fail: refused films, and more slow ones than a suite may have.
pub fn failures(suite: &Suite, outcomes: &[Outcome]) -> Vec<String> {
    let refused = outcomes.iter().filter_map(|outcome| {
        let reason = outcome.film.as_ref().err()?;
        Some(format!("{}: refused: {reason}", outcome.name))
    });
    let slow: Vec<&Outcome> = outcomes
        .iter()
        .filter(|outcome| outcome.is_slow())
        .collect();
    let is_too_slow = slow.len() > suite.may_be_slow;
    let slow = slow.into_iter().filter(|_| is_too_slow);
    let slow = slow.map(|outcome| format!("{}: calls are slower than {SLOW_NS} ns", outcome.name));
    refused.chain(slow).collect()
}

impl Outcome {
    /// Whether a call is slower than [`SLOW_NS`].
    pub fn is_slow(&self) -> bool {
        self.film.as_ref().is_ok_and(|found| {
            let back = found.back_ns.map_or(0.0, |[median, _]| median);
            found.front_ns[0].max(back) > SLOW_NS
        })
    }
}
