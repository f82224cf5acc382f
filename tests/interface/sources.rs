//! The library's sources as text: files, their modules, and what is left without comments and tests.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of `src/`.
pub struct Source {
    /// Its path below `src/`.
    pub path: String,
    /// The module that it is, from the crate's root: `["bsdf", "models", "phong"]`.
    pub module: Vec<String>,
    /// Its text without comments, string literals and unit tests.
    pub code: String,
}

/// All files of `src/` but those that hold unit tests alone, in the order of their paths.
pub fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut paths = rust_files(&root);
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let path = path.strip_prefix(&root).unwrap().to_str().unwrap();
        Source::new(path, &text)
    };
    let all: Vec<Source> = paths.into_iter().map(read).collect();
    let test_modules: Vec<Vec<String>> = all.iter().flat_map(Source::test_modules).collect();
    let is_tested = |source: &Source| !test_modules.contains(&source.module);
    let mut kept: Vec<Source> = all.into_iter().filter(is_tested).collect();
    for source in &mut kept {
        source.code = without_tests(&source.code);
    }
    kept
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .flat_map(|path| match path.extension() {
            _ if path.is_dir() => rust_files(&path),
            Some(extension) if extension == "rs" => vec![path],
            _ => vec![],
        })
        .collect()
}

impl Source {
    /// A file from its path below `src/` and its text.
    pub fn new(path: &str, text: &str) -> Self {
        let mut module: Vec<String> = path
            .trim_end_matches(".rs")
            .split('/')
            .map(str::to_owned)
            .collect();
        if ["mod", "lib"].contains(&module.last().unwrap().as_str()) {
            module.pop();
        }
        Self {
            path: path.to_owned(),
            module,
            code: without_comments(text),
        }
    }

    /// The child modules that are compiled for unit tests alone.
    fn test_modules(&self) -> Vec<Vec<String>> {
        let after = self.code.split("#[cfg(test)]").skip(1);
        let names = after.filter_map(|rest| {
            let rest = rest.trim_start().strip_prefix("mod ")?;
            rest.split_once(';').map(|(name, _)| name.trim())
        });
        let is_name = |name: &&str| name.chars().all(is_identifier);
        names
            .filter(is_name)
            .map(|name| [&self.module[..], &[name.to_owned()]].concat())
            .collect()
    }
}

pub fn is_identifier(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Leaves out comments and the insides of string literals. Character literals that hold a quotation mark
/// are not told from its beginning: the sources have none.
fn without_comments(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(['/', '"']) {
        code += &rest[..at];
        rest = &rest[at..];
        if rest.starts_with("//") {
            rest = &rest[rest.find('\n').unwrap_or(rest.len())..];
        } else if rest.starts_with("/*") {
            rest = &rest[rest.find("*/").map_or(rest.len(), |end| end + 2)..];
        } else if rest.starts_with('"') {
            let bytes = rest.as_bytes();
            let mut end = 1;
            while end < bytes.len() && bytes[end] != b'"' {
                end += if bytes[end] == b'\\' { 2 } else { 1 };
            }
            code += "\"\"";
            rest = &rest[(end + 1).min(rest.len())..];
        } else {
            code.push('/');
            rest = &rest[1..];
        }
    }
    code + rest
}

/// Leaves out the modules in braces that are compiled for unit tests alone.
fn without_tests(code: &str) -> String {
    let mut kept = String::new();
    let mut rest = code;
    while let Some(at) = rest.find("#[cfg(test)]") {
        let (before, item) = rest.split_at(at);
        kept += before;
        let is_block = item["#[cfg(test)]".len()..]
            .trim_start()
            .starts_with("mod ");
        let end = match (item.find('{'), item.find(';')) {
            (Some(open), semicolon) if is_block && semicolon.is_none_or(|s| open < s) => {
                closing(item, open)
            }
            (_, Some(semicolon)) => semicolon,
            _ => item.len() - 1,
        };
        rest = &item[end + 1..];
    }
    kept + rest
}

/// Where the brace closes that opens at `open`.
pub fn closing(code: &str, open: usize) -> usize {
    let mut depth = 0;
    for (at, c) in code[open..].char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return open + at;
        }
    }
    code.len() - 1
}
