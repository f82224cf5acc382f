//! Tables in Markdown.

use std::fmt::Display;

/// A table. A heading that begins with `>` is of a column of numbers, aligned to the right.
pub fn table<T: Display>(headings: &[&str], rows: impl IntoIterator<Item = Vec<T>>) -> String {
    let mut out = String::new();
    let mut line = |cells: Vec<String>| out += &format!("| {} |\n", cells.join(" | "));
    line(
        headings
            .iter()
            .map(|h| h.trim_start_matches('>').to_owned())
            .collect(),
    );
    let rule = |heading: &&str| {
        if heading.starts_with('>') {
            "---:"
        } else {
            "---"
        }
    };
    line(headings.iter().map(|h| rule(h).to_owned()).collect());
    for row in rows {
        line(row.iter().map(T::to_string).collect());
    }
    out
}
