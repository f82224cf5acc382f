//! Dependencies go one way: a module may name those to its left, never one to its right.

use std::fs;
use std::path::{Path, PathBuf};

const ORDER: [&str; 6] = ["num", "optics", "film", "bsdf", "batch", "capi"];

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries
        .flat_map(|path| {
            if path.is_dir() {
                files(&path)
            } else {
                vec![path]
            }
        })
        .collect()
}

/// The place in the order of the module that a file belongs to; none for the crate's root and the
/// error type, which stand outside.
fn rank(source: &Path, root: &Path) -> Option<usize> {
    let first = source.strip_prefix(root).unwrap().iter().next()?.to_str()?;
    ORDER
        .iter()
        .position(|module| *module == first.trim_end_matches(".rs"))
}

/// Modules named by `crate::module` or, inside braces, `crate::{module, ...}`.
fn named_modules(text: &str) -> Vec<&'static str> {
    let mut named = Vec::new();
    for (at, _) in text.match_indices("crate::") {
        let rest = &text[at + "crate::".len()..];
        let rest = rest
            .strip_prefix('{')
            .map_or(rest, |inner| &inner[..inner.find('}').unwrap()]);
        named.extend(ORDER.iter().filter(|module| {
            rest.split(|c: char| !c.is_alphanumeric() && c != '_')
                .next()
                == Some(module)
                || text[at..].starts_with("crate::{") && rest.contains(*module)
        }));
    }
    named
}

#[test]
fn no_module_names_one_to_its_right() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut back_edges = Vec::new();
    let mut edges = 0;
    for file in files(&root)
        .iter()
        .filter(|file| file.extension().is_some_and(|e| e == "rs"))
    {
        let Some(own) = rank(file, &root) else {
            continue;
        };
        for module in named_modules(&fs::read_to_string(file).unwrap()) {
            edges += 1;
            if ORDER.iter().position(|other| *other == module).unwrap() > own {
                back_edges.push(format!("{} names {module}", file.display()));
            }
        }
    }
    assert!(back_edges.is_empty(), "{back_edges:#?}");
    assert!(
        edges > 20,
        "found only {edges} edges: the scan itself is broken"
    );
}
