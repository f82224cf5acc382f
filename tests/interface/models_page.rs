//! The tables of models and parameters in docs/models.md are what the registry says.
//!
//! `PELLICLE_RENEW=1 cargo test --release --test interface models` rewrites them.

use pellicle::bsdf::{Choice, Exception, ModelInfo, ParamInfo, ParamKind, RegisteredModel, models};
use std::fmt::Write;
use std::fs;
use std::path::Path;

const BEGIN: &str = "<!-- models: begin (tests/interface/models_page.rs keeps these tables) -->\n";
const END: &str = "<!-- models: end -->";

/// What is allowed, and the default.
fn range(param: &ParamInfo) -> (String, String) {
    match param.kind {
        ParamKind::Number {
            min, max, default, ..
        } => (format!("{min} .. {max}"), format!("{default}")),
        ParamKind::Direction { min_z } => (format!("z >= {min_z}"), "(0, 0, 1)".to_owned()),
        ParamKind::Choice { choices } => (choices.join(", "), choices[0].to_owned()),
    }
}

/// The choices with which a parameter has an effect; empty if it always has. A film's thickness has one
/// where the model takes a film.
fn used_with(info: &ModelInfo, index: usize) -> String {
    let with_film = info.film_choice.as_slice();
    let film_cases = [with_film];
    let of_film = [info.film_thickness, info.film_thickness_spread].contains(&Some(index));
    let cases = if of_film && !with_film.is_empty() {
        &film_cases
    } else {
        info.params[index].used_with
    };
    let made = |made: &Choice| {
        let decider = &info.params[made.param];
        let ParamKind::Choice { choices } = decider.kind else {
            panic!("{} of {} is no choice", decider.name, info.name);
        };
        format!("`{}` {}", decider.name, choices[made.choice])
    };
    let cases = cases
        .iter()
        .map(|case| case.iter().map(made).collect::<Vec<_>>().join(" and "));
    cases.collect::<Vec<_>>().join("; or ")
}

fn section(entry: &RegisteredModel) -> String {
    let info = entry.info;
    let mut out = format!("## `{}`\n\n", info.name);
    writeln!(out, "{} Source: {}.", info.summary, info.source).unwrap();
    let mut exception = |law: &str, exception: &Option<Exception>| {
        if let Some(exception) = exception {
            writeln!(out, "Not {law} for {}.", exception.reason).unwrap();
        }
    };
    exception("reciprocal", &info.not_reciprocal);
    exception("energy-conserving", &info.not_conserving);
    out += "\n| parameter | numbers | unit | range | default | may vary | used with | meaning |\n";
    out += "|---|---|---|---|---|---|---|---|\n";
    for (index, param) in info.params.iter().enumerate() {
        let (range, default) = if info.film_thickness == Some(index) {
            ("the layer's".to_owned(), String::new())
        } else {
            range(param)
        };
        let components = match param.components() {
            0 => "choice".to_owned(),
            count => count.to_string(),
        };
        let vary = if param.can_vary { "yes" } else { "" };
        writeln!(
            out,
            "| `{}` | {components} | {} | {range} | {default} | {vary} | {} | {} |",
            param.name,
            param.unit,
            used_with(info, index),
            param.summary
        )
        .unwrap();
    }
    out
}

#[test]
fn the_tables_of_models_are_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/models.md");
    let page = fs::read_to_string(&path).unwrap();
    let (before, rest) = page
        .split_once(BEGIN)
        .expect("docs/models.md has lost its models marker");
    let (tables, after) = rest
        .split_once(END)
        .expect("docs/models.md has lost its end marker");
    let sections: Vec<String> = models().iter().map(section).collect();
    let current = format!("\n{}\n", sections.join("\n"));
    if std::env::var_os("PELLICLE_RENEW").is_some() {
        fs::write(&path, format!("{before}{BEGIN}{current}{END}{after}")).unwrap();
        return;
    }
    assert!(
        tables == current,
        "docs/models.md is out of date; PELLICLE_RENEW=1 cargo test --release --test interface models rewrites it"
    );
}
