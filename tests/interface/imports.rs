//! Which file of the library imports which: the graph, and its circles.

use super::sources::{Source, closing, is_identifier};
use std::collections::{BTreeMap, BTreeSet};

/// A name that a file brings in.
struct Import {
    /// The path from the crate's root; its last segment is `*` for all names of a module.
    path: Vec<String>,
    /// What it is called in the file.
    name: String,
    /// Whether the file re-exports it.
    is_public: bool,
}

/// For every file the files that it imports from, and the name that it imports.
pub type Graph = BTreeMap<String, BTreeMap<String, String>>;

/// The graph of all imports. A name that a module re-exports comes from the file that defines it, and a re-export
/// is no import: a `mod.rs` that only declares and re-exports has no edges.
pub fn graph(sources: &[Source]) -> Graph {
    let crate_files = Files::new(sources);
    let mut graph = Graph::new();
    for source in sources {
        let edges = graph.entry(source.path.clone()).or_default();
        for path in crate_files.used_paths(source) {
            let Some(file) = crate_files.definition(&path, 0) else {
                continue;
            };
            if file.path != source.path {
                edges
                    .entry(file.path.clone())
                    .or_insert_with(|| path.join("::"));
            }
        }
    }
    graph
}

/// The groups of files in which every file imports from every other one, directly or through others.
pub fn circles(graph: &Graph) -> Vec<BTreeSet<String>> {
    let reached: BTreeMap<&String, BTreeSet<&String>> = graph
        .keys()
        .map(|file| (file, reach(graph, file)))
        .collect();
    let mut circles = BTreeSet::new();
    for (file, others) in &reached {
        let mut circle: BTreeSet<String> = others
            .iter()
            .filter(|other| reached[*other].contains(file))
            .map(|other| (*other).clone())
            .collect();
        if !circle.is_empty() {
            circle.insert((*file).clone());
            circles.insert(circle);
        }
    }
    circles.into_iter().collect()
}

/// The files that `file` imports from, and those that they import from.
fn reach<'a>(graph: &'a Graph, file: &String) -> BTreeSet<&'a String> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&String> = graph[file].keys().collect();
    while let Some(next) = open.pop() {
        if reached.insert(next) {
            open.extend(graph[next].keys());
        }
    }
    reached
}

struct Files<'a> {
    by_module: BTreeMap<&'a [String], &'a Source>,
    imports: BTreeMap<&'a [String], Vec<Import>>,
}

impl<'a> Files<'a> {
    fn new(sources: &'a [Source]) -> Self {
        let by_module: BTreeMap<_, _> = sources
            .iter()
            .map(|source| (&source.module[..], source))
            .collect();
        let imports = sources
            .iter()
            .map(|source| (&source.module[..], imports(source, &by_module)))
            .collect();
        Self { by_module, imports }
    }

    /// The paths of all items that a file uses, from the crate's root.
    fn used_paths(&self, source: &Source) -> Vec<Vec<String>> {
        let body = without_imports(&source.code);
        let mut used = Vec::new();
        for import in &self.imports[&source.module[..]] {
            if import.is_public && !mentions(&body, &import.name) {
                continue;
            }
            if self.by_module.contains_key(&import.path[..]) {
                // A module is no item: the items that are used through its name count.
                let items = items_of(&body, &import.name);
                used.extend(items.into_iter().map(|item| {
                    let mut path = import.path.clone();
                    path.push(item);
                    path
                }));
            } else {
                used.push(import.path.clone());
            }
        }
        for root in ["crate", "super", "self"] {
            for path in qualified(&body, root) {
                used.extend(absolute(&source.module, &path, &self.by_module));
            }
        }
        // A child module can be named without an import.
        for child in self.children(source) {
            used.extend(items_of(&body, child).into_iter().map(|item| {
                let mut path = source.module.clone();
                path.extend([child.to_owned(), item]);
                path
            }));
        }
        used
    }

    fn children(&self, source: &'a Source) -> impl Iterator<Item = &'a str> {
        let depth = source.module.len();
        self.by_module
            .keys()
            .filter(move |module| module.len() == depth + 1 && module.starts_with(&source.module))
            .map(move |module| module[depth].as_str())
    }

    /// The file that defines the item of that path.
    fn definition(&self, path: &[String], depth: usize) -> Option<&'a Source> {
        let longest = (0..=path.len())
            .rev()
            .find(|length| self.by_module.contains_key(&path[..*length]))?;
        let source = self.by_module[&path[..longest]];
        let Some(item) = path.get(longest).filter(|_| depth < 8) else {
            return Some(source);
        };
        if defines(&source.code, item) {
            return Some(source);
        }
        let imports = &self.imports[&source.module[..]];
        if let Some(import) = imports.iter().find(|import| import.name == *item) {
            return self.definition(&import.path, depth + 1);
        }
        for import in imports.iter().filter(|import| import.name == "*") {
            let mut path = import.path.clone();
            *path.last_mut().unwrap() = item.clone();
            if let Some(file) = self.definition(&path, depth + 1)
                && defines(&file.code, item)
            {
                return Some(file);
            }
        }
        Some(source)
    }
}

/// Whether code has an item of that name.
fn defines(code: &str, item: &str) -> bool {
    const KEYWORDS: [&str; 9] = [
        "struct ",
        "enum ",
        "trait ",
        "union ",
        "fn ",
        "const ",
        "static ",
        "type ",
        "macro_rules! ",
    ];
    KEYWORDS.iter().any(|keyword| {
        let definition = format!("{keyword}{item}");
        code.match_indices(&definition).any(|(at, _)| {
            let after = code[at + definition.len()..].chars().next();
            !after.is_some_and(is_identifier)
        })
    })
}

/// Whether a word occurs in code.
fn mentions(code: &str, word: &str) -> bool {
    code.match_indices(word).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + word.len()..].chars().next();
        !before.is_some_and(is_identifier) && !after.is_some_and(is_identifier)
    })
}

/// The names that follow `module::` in code.
fn items_of(code: &str, module: &str) -> BTreeSet<String> {
    let paths = qualified(code, module);
    paths.into_iter().map(|path| path[1].clone()).collect()
}

/// The paths in code that begin with that segment and have another.
fn qualified(code: &str, root: &str) -> Vec<Vec<String>> {
    let start = format!("{root}::");
    let mut paths = Vec::new();
    for (at, _) in code.match_indices(&start) {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| is_identifier(c) || c == ':') {
            continue;
        }
        let is_part = |c: char| is_identifier(c) || c == ':';
        let path = code[at..].split(|c| !is_part(c)).next().unwrap();
        let segments: Vec<String> = path
            .split("::")
            .filter(|segment| !segment.is_empty())
            .map(str::to_owned)
            .collect();
        if segments.len() > 1 {
            paths.push(segments);
        }
    }
    paths
}

fn imports(source: &Source, modules: &BTreeMap<&[String], &Source>) -> Vec<Import> {
    let mut found = Vec::new();
    for (start, end) in statements(&source.code) {
        let statement = &source.code[start..end];
        let (visibility, tree) = statement.split_once("use ").unwrap();
        let is_public = visibility.contains("pub");
        for (path, name) in leaves(tree.trim()) {
            found.extend(absolute(&source.module, &path, modules).map(|path| Import {
                path,
                name,
                is_public,
            }));
        }
    }
    found
}

/// Begin and end of every `use` statement, with its visibility.
fn statements(code: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("use ") {
        let line = code[..at].rfind('\n').map_or(0, |newline| newline + 1);
        let before = code[line..at].trim();
        if before.is_empty() || before.starts_with("pub") {
            found.push((line, at + code[at..].find(';').unwrap_or(0)));
        }
    }
    found
}

fn without_imports(code: &str) -> String {
    let mut body = String::new();
    let mut from = 0;
    for (start, end) in statements(code) {
        body += &code[from..start];
        from = end;
    }
    body + &code[from..]
}

/// The paths in a tree of imports, each with the name that it is given.
fn leaves(tree: &str) -> Vec<(Vec<String>, String)> {
    let tree = tree.trim();
    if let Some(open) = tree.find('{') {
        let prefix: Vec<String> = segments(&tree[..open]);
        let inner = &tree[open + 1..closing(tree, open)];
        return split_at_commas(inner)
            .into_iter()
            .flat_map(leaves)
            .map(|(path, name)| {
                if path == ["self"] {
                    let own = if name == "self" {
                        prefix.last().unwrap()
                    } else {
                        &name
                    };
                    (prefix.clone(), own.clone())
                } else {
                    ([&prefix[..], &path[..]].concat(), name)
                }
            })
            .collect();
    }
    let (path, name) = match tree.split_once(" as ") {
        Some((path, name)) => (segments(path), name.trim().to_owned()),
        None => (segments(tree), segments(tree).pop().unwrap_or_default()),
    };
    if path.is_empty() {
        vec![]
    } else {
        vec![(path, name)]
    }
}

fn segments(path: &str) -> Vec<String> {
    path.split("::")
        .map(|segment| segment.trim().to_owned())
        .filter(|segment| !segment.is_empty())
        .collect()
}

fn split_at_commas(list: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut from) = (Vec::new(), 0, 0);
    for (at, c) in list.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&list[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&list[from..]);
    parts
}

/// A path from the crate's root; `None` if it leads to another crate.
fn absolute(
    module: &[String],
    path: &[String],
    modules: &BTreeMap<&[String], &Source>,
) -> Option<Vec<String>> {
    let (mut base, mut rest) = match path.first()?.as_str() {
        "crate" => (vec![], &path[1..]),
        "self" => (module.to_vec(), &path[1..]),
        "super" => (module.to_vec(), path),
        child => {
            let own = [module, &[child.to_owned()]].concat();
            return modules
                .contains_key(&own[..])
                .then(|| [module, path].concat());
        }
    };
    while rest.first().is_some_and(|segment| segment == "super") {
        base.pop();
        rest = &rest[1..];
    }
    base.extend_from_slice(rest);
    Some(base)
}
