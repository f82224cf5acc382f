//! Tables in Markdown.

/// A table. Headings are divided by `|`; one that begins with `>` is of a column of numbers, aligned to the right.
pub fn table(headings: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let headings: Vec<&str> = headings.split('|').map(str::trim).collect();
    let names = headings
        .iter()
        .map(|h| h.trim_start_matches('>').to_owned());
    let rules = headings
        .iter()
        .map(|h| if h.starts_with('>') { "---:" } else { "---" });
    let head = [names.collect(), rules.map(str::to_owned).collect()];
    let lines = head.into_iter().chain(rows);
    lines
        .map(|cells: Vec<String>| format!("| {} |\n", cells.join(" | ")))
        .collect()
}
