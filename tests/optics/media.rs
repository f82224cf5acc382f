//! The tables of docs/media.md are what the library computes.
//!
//! `PELLICLE_RENEW=1 cargo test --release --test optics media` rewrites them.

use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, NamedMedium, Reference, White};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// The lecture's F0 values, linear Rec.709 (Real-Time Rendering, 4th edition, table 9.2).
const F0: [(&str, [f64; 3]); 10] = [
    ("titanium", [0.542, 0.497, 0.449]),
    ("chromium", [0.549, 0.556, 0.554]),
    ("iron", [0.562, 0.565, 0.578]),
    ("nickel", [0.660, 0.609, 0.526]),
    ("platinum", [0.673, 0.637, 0.585]),
    ("copper", [0.955, 0.638, 0.538]),
    ("gold", [1.022, 0.782, 0.344]),
    ("aluminium", [0.913, 0.922, 0.924]),
    ("silver", [0.972, 0.960, 0.915]),
    ("silicon", [0.345, 0.369, 0.426]),
];

fn bare(name: &str, white: White) -> [f64; 3] {
    let base = Medium::named(name).unwrap();
    let space = ColorSpace::Rec709;
    let stack = Reference::new(Medium::vacuum(), vec![], base, white, space).unwrap();
    stack.evaluate(Side::Ambient, 1.0, &[]).reflectance
}

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

fn numbers(rgb: [f64; 3]) -> String {
    rgb.map(|channel| format!("{channel:.3}")).join(" ")
}

fn table_of_metals() -> String {
    let mut text = String::from(
        "| medium | table | ours, white E | difference | ours, D65 | difference |\n\
         |---|---|---|---|---|---|\n",
    );
    for (name, table) in F0 {
        let [e, d65] = [White::E, White::D65].map(|white| bare(name, white));
        writeln!(
            text,
            "| {name} | {} | {} | {:.3} | {} | {:.3} |",
            numbers(table),
            numbers(e),
            difference(table, e),
            numbers(d65),
            difference(table, d65)
        )
        .unwrap();
    }
    text
}

fn table_of_media() -> String {
    let mut text = String::from(
        "| name | also | n at 587.6 nm | k there | greatest k | source |\n|---|---|---|---|---|---|\n",
    );
    for named in NamedMedium::all() {
        let aliases = named.aliases.join(", ");
        let extinction = |k: f64| match k {
            0.0 => String::new(),
            k if k < 1e-6 => "< 1e-6".into(),
            k if k < 0.01 => format!("{k:.1e}"),
            k => format!("{k:.2}"),
        };
        let [min, max] = named.range_nm().map(|nm| nm.clamp(380.0, 780.0));
        let greatest = (0..=400).map(|i| min + (max - min) * f64::from(i) / 400.0);
        let greatest = greatest.map(|nm| named.index(nm).im).fold(0.0, f64::max);
        let at = named.index(587.56);
        writeln!(
            text,
            "| {} | {aliases} | {:.4} | {} | {} | {} |",
            named.name,
            at.re,
            extinction(at.im),
            extinction(greatest),
            named.source
        )
        .unwrap();
    }
    text
}

/// Replaces what stands between the markers of a section.
fn with_section(text: &str, name: &str, content: &str) -> String {
    let [begin, end] = ["begin", "end"].map(|edge| format!("<!-- {name}: {edge} -->\n"));
    let (before, rest) = text.split_once(&begin).expect("the section's begin");
    let (_, after) = rest.split_once(&end).expect("the section's end");
    format!("{before}{begin}{content}{end}{after}")
}

#[test]
fn the_tables_are_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/media.md");
    let text = fs::read_to_string(&path).unwrap();
    let renewed = with_section(&text, "media", &table_of_media());
    let renewed = with_section(&renewed, "f0", &table_of_metals());
    if std::env::var_os("PELLICLE_RENEW").is_some() {
        fs::write(&path, &renewed).unwrap();
    } else {
        assert!(
            text == renewed,
            "docs/media.md is out of date; PELLICLE_RENEW=1 cargo test --release --test optics media rewrites it"
        );
    }
}

#[test]
fn metals_whose_sources_agree_have_the_tables_colors() {
    for (name, table) in F0 {
        let found = difference(table, bare(name, White::E));
        let agrees = ["chromium", "platinum", "aluminium", "silicon"].contains(&name);
        let bound = if agrees { 0.007 } else { 0.1 };
        assert!(found < bound, "{name}: {found}");
    }
}
