//! The README's table of models and parameters is what the registry says.
//!
//! `PELLICLE_RENEW=1 cargo test --release --test interface readme` rewrites it.

use pellicle::bsdf::{Exception, ParamInfo, ParamKind, RegisteredModel, models};
use std::fmt::Write;
use std::fs;
use std::path::Path;

const BEGIN: &str = "<!-- models: begin (tests/readme.rs keeps this table) -->\n";
const END: &str = "<!-- models: end -->";

fn range(param: &ParamInfo) -> (String, String) {
    match param.kind {
        ParamKind::Number {
            min, max, default, ..
        } => (format!("{min} .. {max}"), format!("{default}")),
        ParamKind::Direction { min_z } => (format!("z >= {min_z}"), "(0, 0, 1)".to_owned()),
        ParamKind::Choice { choices } => (choices.join(", "), choices[0].to_owned()),
    }
}

fn section(entry: &RegisteredModel) -> String {
    let info = entry.info;
    let text = str::to_owned;
    let mut out = format!("### `{}`\n\n", entry.name());
    writeln!(out, "{} Source: {}.", text(info.summary), text(info.source)).unwrap();
    let mut exception = |law: &str, exception: &Option<Exception>| {
        if let Some(exception) = exception {
            writeln!(out, "Not {law} for {}.", text(exception.reason)).unwrap();
        }
    };
    exception("reciprocal", &info.not_reciprocal);
    exception("energy-conserving", &info.not_conserving);
    out += "\n| parameter | numbers | unit | range | default | may vary | meaning |\n";
    out += "|---|---|---|---|---|---|---|\n";
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
            "| `{}` | {components} | {} | {range} | {default} | {vary} | {} |",
            param.name(),
            text(param.unit),
            text(param.summary)
        )
        .unwrap();
    }
    out
}

#[test]
fn the_table_of_models_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let readme = fs::read_to_string(&path).unwrap();
    let (before, rest) = readme
        .split_once(BEGIN)
        .expect("README.md has lost its models marker");
    let (table, after) = rest
        .split_once(END)
        .expect("README.md has lost its end marker");
    let sections: Vec<String> = models().iter().map(section).collect();
    let current = format!("\n{}\n", sections.join("\n"));
    if std::env::var_os("PELLICLE_RENEW").is_some() {
        fs::write(&path, format!("{before}{BEGIN}{current}{END}{after}")).unwrap();
        return;
    }
    assert!(
        table == current,
        "README.md's models are out of date; PELLICLE_RENEW=1 cargo test --release --test interface readme rewrites them"
    );
}
