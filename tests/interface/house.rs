//! Rules that the sources follow, so that a reader finds each thing once and in one place.

use super::imports::{circles, graph};
use super::sources::{Source, is_identifier, sources};
use std::collections::BTreeMap;
use std::fmt::Write;

/// With more traits than this, the way of a call is hard to follow.
const MOST_TRAITS: usize = 12;

/// The types of each name that a keyword of the list defines, and the files that define them.
fn definitions<'a>(sources: &'a [Source], keywords: &[&str]) -> BTreeMap<String, Vec<&'a str>> {
    let mut found: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for source in sources {
        for line in source.code.lines() {
            let mut words = line
                .split_whitespace()
                .skip_while(|word| word.starts_with("pub"));
            let Some(keyword) = words.next().filter(|word| keywords.contains(word)) else {
                continue;
            };
            let rest = words.next().unwrap_or_default();
            let name: String = rest.chars().take_while(|c| is_identifier(*c)).collect();
            assert!(
                !name.is_empty() || rest.starts_with('$'),
                "{}: no name after {keyword} in {line}",
                source.path
            );
            if !name.is_empty() {
                found.entry(name).or_default().push(&source.path);
            }
        }
    }
    found
}

#[test]
fn no_type_name_means_two_things() {
    let sources = sources();
    let all = definitions(&sources, &["struct", "enum", "trait", "union"]);
    assert!(
        all.len() > 50,
        "only {} types: the scan itself is broken",
        all.len()
    );
    let mut report = String::new();
    for (name, files) in all.iter().filter(|(_, files)| files.len() > 1) {
        writeln!(report, "{name}: {}", files.join(", ")).unwrap();
    }
    assert!(report.is_empty(), "types of one name:\n{report}");
}

#[test]
fn there_are_few_traits() {
    let sources = sources();
    let traits = definitions(&sources, &["trait"]);
    assert!(!traits.is_empty(), "no trait: the scan itself is broken");
    let mut report = String::new();
    for (name, files) in &traits {
        writeln!(report, "{name}: {}", files.join(", ")).unwrap();
    }
    let count: usize = traits.values().map(Vec::len).sum();
    assert!(
        count <= MOST_TRAITS,
        "{count} traits, at most {MOST_TRAITS} are wanted:\n{report}"
    );
}

#[test]
fn no_files_import_in_a_circle() {
    let graph = graph(&sources());
    let edges: usize = graph.values().map(BTreeMap::len).sum();
    assert!(
        edges > 100,
        "only {edges} imports: the scan itself is broken"
    );
    let mut report = String::new();
    for circle in circles(&graph) {
        report += "\n";
        for file in &circle {
            for (other, item) in graph[file]
                .iter()
                .filter(|(other, _)| circle.contains(*other))
            {
                writeln!(report, "{file} imports {item} from {other}").unwrap();
            }
        }
    }
    assert!(report.is_empty(), "circles of imports:\n{report}");
}

/// The scan itself, on sources with a circle through a re-exported name, one between a child and an item of its
/// parent, and imports that are no circle.
#[test]
fn circles_are_found_and_passing_on_is_none() {
    let sources = [
        ("lib.rs", "pub mod a;\npub mod b;\npub use a::Deep;"),
        (
            "a/mod.rs",
            "mod deep;\nmod leaf;\npub use deep::Deep;\npub(crate) use leaf::*;",
        ),
        (
            "a/deep.rs",
            "use super::Leaf;\nuse crate::b::{self, Parent};\nstruct Deep; fn f() { b::g() }",
        ),
        (
            "a/leaf.rs",
            "use crate::Deep as D;\n// use crate::b::Parent;\nstruct Leaf;",
        ),
        (
            "b/mod.rs",
            "mod child;\nuse child::Child;\nstruct Parent(Child);\nfn g() {}",
        ),
        ("b/child.rs", "struct Child; fn f(p: super::Parent) {}"),
    ]
    .map(|(path, text)| Source::new(path, text));
    let found: Vec<Vec<String>> = circles(&graph(&sources))
        .into_iter()
        .map(|circle| circle.into_iter().collect())
        .collect();
    assert_eq!(
        found,
        [["a/deep.rs", "a/leaf.rs"], ["b/child.rs", "b/mod.rs"]]
    );
}
