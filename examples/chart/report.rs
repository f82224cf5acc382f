//! The results as text: a row per cell for programs, tables for people.

use crate::contest::{Cell, POINTS, Summary, constant, shared, summaries};
use crate::entry::{BASELINE, Entry, PlanNote};
use crate::suite::{RANGES, Range};
use crate::timing::REPETITIONS;
use pellicle::num::Level;
use pellicle::optics::TOLERANCE as REFERENCE;
use std::collections::BTreeMap;
use std::fmt::Write;

/// One row per method, setting, stack and range.
pub fn csv(cells: &[Cell]) -> String {
    let levels = Level::all();
    let names: String = levels
        .iter()
        .map(|l| format!("batch_{}_ns,", l.name()))
        .collect();
    let mut out = format!(
        "method,setting,stack,thickness_min_nm,thickness_max_nm,points,ns,{names}rms,max,\
         delta_e_2000_mean,delta_e_2000_95,plan,plan_max,bytes,compile_ms\n",
    );
    for cell in cells {
        let ([min, max], errors) = (cell.range.nm, &cell.errors);
        let row = [
            cell.entry.name().to_owned(),
            cell.entry.setting(),
            cell.stack.to_owned(),
            min.to_string(),
            max.to_string(),
            POINTS.to_string(),
            format!("{:.1}", cell.ns),
            batches(&levels, &cell.batch_ns, |ns| format!("{ns:.1}")).join(","),
            format!("{:.3e}", errors.rms()),
            format!("{:.3e}", errors.max()),
            format!("{:.4}", errors.mean_delta_e()),
            format!("{:.4}", errors.delta_e_95()),
        ];
        let note = cell.note.as_ref();
        let plan = [
            note.map(|note| note.method.clone()),
            note.map(|note| format!("{:.3e}", note.measured_max)),
            note.map(|note| note.bytes.to_string()),
            note.map(|note| format!("{:.1}", note.compile_ms)),
        ];
        let plan = plan.map(Option::unwrap_or_default);
        writeln!(out, "{},{}", row.join(","), plan.join(",")).unwrap();
    }
    out
}

/// One text per level, empty where there are no batches.
fn batches(levels: &[Level], ns: &[f64], written: impl Fn(f64) -> String) -> Vec<String> {
    let text = |level: usize| ns.get(level).map_or(String::new(), |ns| written(*ns));
    (0..levels.len()).map(text).collect()
}

/// docs/chart.md.
pub fn markdown(cells: &[Cell]) -> String {
    let mut out = format!(
        "# Interference methods: time against error\n\
         \n\
         `./x chart` writes this page, [chart.svg](chart.svg) and [chart.csv](chart.csv), which has every\n\
         stack for itself.\n\
         \n\
         ![Time per colour against error](chart.svg)\n\
         \n\
         - Stacks: ten films on a base, six with constant indices (ambient/film/base), four with dispersion.\n\
         - Points: {POINTS} random ones per stack and range of thickness, the cosine uniform, in a fifth of\n  \
           them its logarithm, down to 0.001.\n\
         - Errors: of linear RGB clipped to [0, 1], over all channels; dE is CIEDE2000, the colours taken\n  \
           for linear sRGB. The truth is the converged reference, whose own error is 0 by definition.\n\
         - ns: per colour on one core, called singly at random points; the median of {REPETITIONS} repetitions, then\n  \
           of the stacks. Ratio: to three tabulated harmonics. Slowest: the slowest stack. Batch: through\n  \
           one batch call, at each level of the processor's instructions. Bytes: the largest film's tables.\n\
         - Methods: described in `src/film`. `two_beam` is the interference of Granier & Heidrich 2002 with\n  \
           exact Fresnel amplitudes at both interfaces, `harmonics` are Belcour & Barla 2017. These and\n  \
           `airy_rgb` know the indices at three wavelengths only: where a base has dispersion, more\n  \
           terms do not help.\n\
         - `planned` is what `film::Film` compiles for a tolerance, the greatest error that it allows. The\n  \
           reference is converged to {REFERENCE:e}: errors below mean as good as it.\n"
    );
    for range in RANGES {
        write!(out, "\n## {}\n\n", range.name).unwrap();
        out += &table(&summaries(shared(cells, range)));
    }
    let name = RANGES[1].name;
    write!(out, "\n## {name}, the six stacks without dispersion\n\n").unwrap();
    out += &table(&summaries(constant(cells, RANGES[1])));
    for range in RANGES.into_iter().filter(|range| range.has_mirror) {
        write!(
            out,
            "\n## Mirror of 5 layers, the outermost {}\n\n",
            range.name
        )
        .unwrap();
        let is_mirror = |cell: &&Cell| !cell.is_one_layer && cell.range == range;
        out += &table(&summaries(cells.iter().filter(is_mirror)));
    }
    out + &by_stack(cells, RANGES[1])
}

fn table(summaries: &[Summary]) -> String {
    let baseline = summaries.iter().find(|s| s.entry == BASELINE);
    let levels = Level::all();
    let names: String = levels
        .iter()
        .map(|l| format!(" batch, {} |", l.name()))
        .collect();
    let mut out = format!(
        "| method | setting | ns | ratio | slowest |{names} RMS | max | mean dE | 95 % dE | plan | bytes |\n\
         |---|---|---:|---:|---:|{}---:|---:|---:|---:|---|---:|\n",
        "---:|".repeat(levels.len())
    );
    for summary in summaries {
        let errors = &summary.errors;
        let ratio = baseline.map_or(String::new(), |base| format!("{:.2}", summary.ns / base.ns));
        let bytes = summary.notes.iter().map(|note| note.bytes).max();
        writeln!(
            out,
            "| `{}` | {} | {} | {ratio} | {} | {} | {:.1e} | {:.1e} | {:.3} | {:.3} | {} | {} |",
            summary.entry.name(),
            summary.entry.setting(),
            rounded(summary.ns),
            rounded(summary.slowest_ns),
            batches(&levels, &summary.batch_ns, rounded).join(" | "),
            errors.rms(),
            errors.max(),
            errors.mean_delta_e(),
            errors.delta_e_95(),
            plans(&summary.notes),
            bytes
                .filter(|b| *b > 0)
                .map_or(String::new(), |b| b.to_string()),
        )
        .unwrap();
    }
    out
}

/// Three digits are all that a clock is good for.
fn rounded(ns: f64) -> String {
    if ns < 100.0 {
        return format!("{ns:.1}");
    }
    let unit = 10f64.powf(ns.log10().floor() - 2.0);
    format!("{:.0}", (ns / unit).round() * unit)
}

/// Each method that was chosen, and how often if not always.
fn plans(notes: &[PlanNote]) -> String {
    let mut counts = BTreeMap::new();
    for note in notes {
        *counts.entry(note.method.as_str()).or_insert(0) += 1;
    }
    let part = |(method, count): (&&str, &usize)| {
        if *count == notes.len() {
            (*method).to_owned()
        } else {
            format!("{count} {method}")
        }
    };
    counts.iter().map(part).collect::<Vec<_>>().join(", ")
}

/// RMS of every method on every stack.
fn by_stack(cells: &[Cell], range: Range) -> String {
    let in_range = || cells.iter().filter(move |cell| cell.range == range);
    let mut stacks: Vec<&str> = in_range().map(|cell| cell.stack).collect();
    stacks.dedup();
    let mut out = format!("\n## RMS by stack, {}\n\n| method | setting |", range.name);
    for stack in &stacks {
        write!(out, " {stack} |").unwrap();
    }
    write!(out, "\n|---|---|{}\n", "---:|".repeat(stacks.len())).unwrap();
    for entry in Entry::all().into_iter().filter(|e| *e != Entry::Reference) {
        write!(out, "| `{}` | {} |", entry.name(), entry.setting()).unwrap();
        for stack in &stacks {
            let is_it = |cell: &&Cell| cell.stack == *stack && cell.entry == entry;
            match in_range().find(is_it) {
                Some(cell) => write!(out, " {:.1e} |", cell.errors.rms()).unwrap(),
                None => out += " n/a |",
            }
        }
        out.push('\n');
    }
    out
}
