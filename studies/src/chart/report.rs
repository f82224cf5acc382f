//! The results as text: a row per cell for programs, tables for people.

use super::contest::{
    BASELINE, Cell, POINTS, PlanNote, Summary, constant, peers, shared, summaries,
};
use super::glass;
use super::suite::{RANGES, Range};
use super::timing::REPETITIONS;
use crate::shared::markdown::table;
use crate::shared::peer::Peer;
use pellicle::num::Level;
use pellicle::optics::TOLERANCE as REFERENCE;
use std::collections::BTreeMap;

/// One row per method, setting, stack and range.
pub fn csv(cells: &[Cell]) -> String {
    let names = Level::all()
        .into_iter()
        .map(|l| format!("batch_{}_ns", l.name()));
    let mut out = format!(
        "method,setting,stack,thickness_min_nm,thickness_max_nm,points,ns,{},rms,max,delta_e_2000_mean,\
         delta_e_2000_95,plan,plan_max,bytes,compile_ms\n",
        names.collect::<Vec<_>>().join(",")
    );
    for cell in cells {
        let ([min, max], errors) = (cell.range.nm, &cell.errors);
        let mut row = vec![
            cell.peer.name().to_owned(),
            cell.peer.setting(),
            cell.stack.to_owned(),
            min.to_string(),
            max.to_string(),
            POINTS.to_string(),
            format!("{:.1}", cell.ns),
        ];
        row.extend(batches(&cell.batch_ns, |ns| format!("{ns:.1}")));
        row.extend([errors.rms(), errors.max()].map(|error| format!("{error:.3e}")));
        row.extend(
            [errors.mean_delta_e(), errors.delta_e_95()]
                .map(|difference| format!("{difference:.4}")),
        );
        row.extend(match &cell.note {
            Some(note) => [
                note.method.clone(),
                format!("{:.3e}", note.measured_max),
                note.bytes.to_string(),
                format!("{:.1}", note.compile_ms),
            ],
            None => Default::default(),
        });
        out += &(row.join(",") + "\n");
    }
    out
}

/// One text per level, empty where there are no batches.
fn batches(ns: &[f64], written: impl Fn(f64) -> String) -> Vec<String> {
    let text = |level: usize| ns.get(level).map_or(String::new(), |ns| written(*ns));
    (0..Level::all().len()).map(text).collect()
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
           of the stacks. Ratio: to three harmonics. Slowest: the slowest stack. Batch: through one batch\n  \
           call, at each level of the processor's instructions. Bytes: the largest film's tables.\n\
         - Settings: wavelengths of `quadrature`, bands, terms of `harmonics`, tolerances.\n\
         - Methods: described in `src/film`. `two_beam` is the interference of Granier & Heidrich 2002 with\n  \
           exact Fresnel amplitudes at both interfaces, `harmonics` are Belcour & Barla 2017. These and\n  \
           `airy_rgb` know the indices at three wavelengths only: where a base has dispersion, more\n  \
           terms do not help.\n\
         - `plan` is what `film::Film` compiles for a tolerance, the greatest error that it allows. The\n  \
           reference is converged to {REFERENCE:e}: errors below mean as good as it.\n"
    );
    let mut section =
        |title: String, contents: String| out += &format!("\n## {title}\n\n{contents}");
    for range in RANGES {
        section(
            range.name.into(),
            comparison(&summaries(shared(cells, range))),
        );
    }
    let common = RANGES[1];
    let title = format!("{}, the six stacks without dispersion", common.name);
    section(title, comparison(&summaries(constant(cells, common))));
    for range in RANGES.into_iter().filter(|range| range.has_mirror) {
        let of_mirror = cells
            .iter()
            .filter(|cell| !cell.is_one_layer && cell.range == range);
        let title = format!("Mirror of 5 layers, the outermost {}", range.name);
        section(title, comparison(&summaries(of_mirror)));
    }
    section(
        format!("RMS by stack, {}", common.name),
        by_stack(cells, common),
    );
    out
}

/// The part of docs/chart.md about films on glass.
pub fn glass(cells: &[glass::Cell]) -> String {
    let by = |of: fn(&glass::Cell) -> bool| {
        let [front, back] = [0, 1].map(|side| glass::summaries(cells, side, of));
        both_sides(&front, &back)
    };
    format!(
        "\n## Films on glass, reflected and transmitted\n\
         \n\
         ![Time per colour against error, from both sides](chart-glass.svg)\n\
         \n\
         - Errors are those of reflectance and transmittance together, at {} points per stack; ns of a call that\n  \
           returns both, from the ambient's side (front) and from the base's (back), the median of the stacks\n  \
           and the slowest.\n\
         - Methods for one layer are turned round for the back, and let through what they do not reflect, as\n  \
           renderers do.\n\
         - Two rows are Cycles' habits, each applied to the truth, which shows the error of the habit alone:\n  \
           R = 1 where the film's upper interface reflects totally, as of an air gap in glass, and films that\n  \
           fade below 1 nm.\n\
         \n\
         One layer, six stacks:\n\
         \n\
         {}\n\
         Coats of 2, 3 and 10 layers on BK7:\n\
         \n\
         {}\n\
         By stack, `harmonics` with 3 terms, `plan` at 2e-3 and the reference; `create` is wall time:\n\
         \n\
         {}",
        glass::POINTS,
        by(|cell| cell.layers == 1),
        by(|cell| cell.layers > 1),
        glass_by_stack(cells)
    )
}

fn both_sides(front: &[Summary], back: &[Summary]) -> String {
    let headings = "method | setting | >front, ns | >slowest | >back, ns | >slowest | >front, RMS | >max | \
                    >back, RMS | >max | plan | >bytes";
    let row =
        |peer: Peer| {
            let mut row = vec![format!("`{}`", peer.name()), peer.setting()];
            let sides = [front, back].map(|side| side.iter().find(|summary| summary.peer == peer));
            let [Some(front), Some(back)] = sides else {
                return None;
            };
            let sides = [front, back];
            row.extend(sides.iter().flat_map(|s| [s.ns, s.slowest_ns]).map(time));
            row.extend(sides.iter().flat_map(|s| {
                [s.errors.rms(), s.errors.max()].map(|error| format!("{error:.1e}"))
            }));
            let bytes = front.notes.iter().map(|note| note.bytes).max();
            row.push(plans(&front.notes));
            row.push(bytes.map(|bytes| bytes.to_string()).unwrap_or_default());
            Some(row)
        };
    let is_able = |peer: &Peer| front.iter().any(|summary| summary.peer == *peer);
    let peers = glass::peers();
    let is_method = |peer: &&Peer| !matches!(peer, Peer::Habit(_));
    let unable = peers.iter().filter(is_method).filter(|peer| !is_able(peer));
    let mut unable: Vec<String> = unable.map(|peer| format!("`{}`", peer.name())).collect();
    unable.dedup();
    let mut note = String::new();
    if !unable.is_empty() {
        note = format!("\nToo many layers for {}.\n", unable.join(", "));
    }
    table(headings, peers.into_iter().filter_map(row)) + &note
}

/// Empty for what has no time.
fn time(ns: f64) -> String {
    if ns.is_nan() {
        String::new()
    } else {
        rounded(ns)
    }
}

fn glass_by_stack(cells: &[glass::Cell]) -> String {
    let shown = [BASELINE, Peer::Planned(2e-3), Peer::Reference];
    let headings = "stack | method | >front, ns | >back, ns | >front, max | >back, max | plan | >KiB | >create, ms";
    let rows = cells.iter().filter(|cell| shown.contains(&cell.peer));
    let row = |cell: &glass::Cell| {
        let mut row = vec![cell.stack.to_owned(), format!("`{}`", cell.peer.title())];
        row.extend(cell.ns.map(|ns| ns.map(rounded).unwrap_or_default()));
        row.extend(
            cell.errors
                .iter()
                .map(|errors| format!("{:.1e}", errors.max())),
        );
        row.extend(match &cell.note {
            Some(note) => [
                note.method.clone(),
                (note.bytes / 1024).to_string(),
                format!("{:.0}", note.compile_ms),
            ],
            None => Default::default(),
        });
        row
    };
    table(headings, rows.map(row))
}

/// The part of docs/chart.md about create().
pub fn created(figures: &str) -> String {
    format!(
        "\n## How long films take to create\n\
         \n\
         ![create() times over random stacks](create.svg)\n\
         \n\
         The random stacks of `./x check film_cliffs`, at tolerance {:e}: processor time of create(), and the worst\n\
         stack of each suite, its layers from the ambient to the base.\n\
         \n\
         {figures}",
        super::create::TOLERANCE
    )
}

fn comparison(summaries: &[Summary]) -> String {
    let levels = Level::all();
    let names: String = levels
        .iter()
        .map(|l| format!(">batch, {} | ", l.name()))
        .collect();
    let headings = format!(
        "method | setting | >ns | >ratio | >slowest | {names}>RMS | >max | >mean dE | >95 % dE | plan | >bytes"
    );
    let baseline = summaries.iter().find(|s| s.peer == BASELINE);
    let row = |summary: &Summary| {
        let errors = &summary.errors;
        let ratio = baseline.map(|base| format!("{:.2}", summary.ns / base.ns));
        let bytes = summary.notes.iter().map(|note| note.bytes).max();
        let bytes = bytes
            .filter(|bytes| *bytes > 0)
            .map(|bytes| bytes.to_string());
        let mut row = vec![
            format!("`{}`", summary.peer.name()),
            summary.peer.setting(),
            rounded(summary.ns),
            ratio.unwrap_or_default(),
            rounded(summary.slowest_ns),
        ];
        row.extend(batches(&summary.batch_ns, rounded));
        row.extend([errors.rms(), errors.max()].map(|error| format!("{error:.1e}")));
        row.extend(
            [errors.mean_delta_e(), errors.delta_e_95()]
                .map(|difference| format!("{difference:.3}")),
        );
        row.extend([plans(&summary.notes), bytes.unwrap_or_default()]);
        row
    };
    table(&headings, summaries.iter().map(row))
}

/// Three digits: a clock gives no more.
fn rounded(ns: f64) -> String {
    if ns < 100.0 {
        return format!("{ns:.1}");
    }
    let unit = 10f64.powf(ns.log10().floor() - 2.0);
    format!("{:.0}", (ns / unit).round() * unit)
}

/// Each method that was chosen, and its number if it was not always chosen.
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

/// The RMS of every method on every stack.
fn by_stack(cells: &[Cell], range: Range) -> String {
    let in_range = || cells.iter().filter(|cell| cell.range == range);
    let mut stacks: Vec<&str> = in_range().map(|cell| cell.stack).collect();
    stacks.dedup();
    let headings = format!("method | setting | >{}", stacks.join(" | >"));
    let row = |peer: Peer| {
        let mut row = vec![format!("`{}`", peer.name()), peer.setting()];
        row.extend(stacks.iter().map(|stack| {
            let cell = in_range().find(|cell| cell.stack == *stack && cell.peer == peer);
            cell.map_or("n/a".into(), |cell| format!("{:.1e}", cell.errors.rms()))
        }));
        row
    };
    let peers = peers().into_iter().filter(|peer| *peer != Peer::Reference);
    table(&headings, peers.map(row))
}
