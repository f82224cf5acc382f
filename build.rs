//! Generates the C header and the table of functions into OUT_DIR, and sets the shared library's SONAME.
//!
//! The header that users include is the checked-in `include/pellicle.h`; a test compares the two,
//! so that the source tree is never written during a build.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The files that hold the C interface, in the order in which the header presents them. The functions of
/// the table stand in the same order. Once PELLICLE_ABI_VERSION is not 0, the table only grows at its end.
const INTERFACE: [&str; 14] = [
    "types.rs",
    "film_types.rs",
    "bsdf_types.rs",
    "version.rs",
    "catalogue.rs",
    "film.rs",
    "film_saving.rs",
    "film_calls.rs",
    "film_spectra.rs",
    "bsdf.rs",
    "bsdf_calls.rs",
    "bsdf_spectral.rs",
    "batch.rs",
    "api.rs",
];

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=cbindgen.toml");
    println!("cargo:rerun-if-changed=src/capi");
    println!(
        "cargo:rustc-env=PELLICLE_FINGERPRINT={:016x}",
        fingerprint(&root)
    );

    let text = declarations(&root);
    let functions = Function::all(&text);
    let header = with_table(&text, &functions);
    let path = out.join("pellicle.h");
    fs::write(&path, &header).unwrap();
    println!(
        "cargo:rustc-env=PELLICLE_GENERATED_HEADER={}",
        path.display()
    );
    fs::write(out.join("api_table.rs"), addresses(&functions)).unwrap();

    if env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        let soname = format!("libpellicle.so.{}", abi_version(&header));
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,{soname}");
        link_soname(&out, &soname);
    }
}

/// The folders of `src` that decide what a film evaluates to.
const OF_FILMS: [&str; 3] = ["num", "optics", "film"];

/// A number of all that decides which bits a saved film evaluates to: the sources of films, the compiler and the
/// platform, whose elementary functions differ. FNV-1a, 64 bits (Fowler, Noll and Vo).
fn fingerprint(root: &Path) -> u64 {
    let mut files = Vec::new();
    for folder in OF_FILMS {
        let folder = root.join("src").join(folder);
        println!("cargo:rerun-if-changed={}", folder.display());
        add_files(&folder, &mut files);
    }
    files.sort();
    let compiler = Command::new(env::var_os("RUSTC").unwrap())
        .arg("--version")
        .output();
    let target = env::var("TARGET").unwrap().into_bytes();
    let mut parts = vec![compiler.unwrap().stdout, target];
    for file in files {
        let name = file.strip_prefix(root).unwrap().to_string_lossy();
        parts.push(name.into_owned().into_bytes());
        parts.push(fs::read(&file).unwrap());
    }
    let bytes = parts.iter().flatten();
    bytes.fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3)
    })
}

fn add_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            add_files(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// What cbindgen makes of the sources.
fn declarations(root: &Path) -> String {
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    let preamble = fs::read_to_string(root.join("src/capi/preamble.h")).unwrap();
    let preamble = preamble.replace("@VERSION@", env!("CARGO_PKG_VERSION"));
    let mut builder = cbindgen::Builder::new()
        .with_config(config)
        .with_header(preamble);
    for file in INTERFACE {
        builder = builder.with_src(root.join("src/capi").join(file));
    }
    let mut text = Vec::new();
    builder
        .generate()
        .expect("cbindgen failed")
        .write(&mut text);
    // Rust's customary heading reads better in C as a plain word, and every struct has a typedef.
    let text = String::from_utf8(text).unwrap();
    let lines = text.lines().map(|line| match line {
        "// # Safety" => "// Preconditions:\n".to_owned(),
        line if line.starts_with("typedef struct") => format!("{line}\n"),
        line => format!("{}\n", line.replace("struct Pellicle", "Pellicle")),
    });
    lines.collect()
}

/// A function of the header.
struct Function {
    /// Without the prefix.
    name: String,
    /// Return type, with the blank or asterisk that ends it.
    result: String,
    /// Between the parentheses, in one line.
    arguments: String,
}

impl Function {
    /// All but pellicle_get_api(), which is looked up by its symbol.
    fn all(header: &str) -> Vec<Self> {
        let start = header.find("extern \"C\" {").expect("declarations");
        let code: Vec<&str> = header[start..]
            .lines()
            .filter(|line| !line.starts_with("//") && !line.starts_with('#'))
            .collect();
        let code = code.join(" ");
        let declaration = |text: &str| {
            let (before, arguments) = text.split_once('(')?;
            let (result, name) = before.split_once("pellicle_")?;
            let arguments = arguments.trim_end().strip_suffix(')')?;
            Some(Self {
                name: name.to_owned(),
                result: result
                    .trim_start_matches("extern \"C\" {")
                    .trim_start()
                    .to_owned(),
                arguments: arguments.split_whitespace().collect::<Vec<_>>().join(" "),
            })
        };
        let all = code.split(';').filter_map(declaration);
        all.filter(|function| function.name != "get_api").collect()
    }
}

/// The longest line of the struct.
const LINE: usize = 100;

/// The header with the struct of all functions before the declarations.
fn with_table(header: &str, functions: &[Function]) -> String {
    let mut table = "// Every function of this header, by its name without the prefix. It grows by appending: \
                     before using\n// a member that was added later, check that it lies within `size`.\n\
                     struct PellicleApi {\n    // Bytes in this table.\n    size_t size;\n"
        .to_owned();
    for Function {
        name,
        result,
        arguments,
    } in functions
    {
        let in_one_line = format!("    {result}(*{name})({arguments});");
        if in_one_line.len() <= LINE {
            table.push_str(&in_one_line);
        } else {
            let arguments = arguments.replace(", ", ",\n        ");
            write!(table, "    {result}(*{name})(\n        {arguments});").unwrap();
        }
        table.push('\n');
    }
    table.push_str("};\n\n");
    let place = header.find("#ifdef __cplusplus\nextern \"C\" {").unwrap();
    format!("{}{table}{}", &header[..place], &header[place..])
}

/// The addresses of the functions, for `src/capi/api.rs`.
fn addresses(functions: &[Function]) -> String {
    let mut text = format!(
        "const FUNCTION_COUNT: usize = {};\nconst FUNCTIONS: [Function; FUNCTION_COUNT] = [\n",
        functions.len()
    );
    for Function { name, .. } in functions {
        writeln!(text, "    Function(super::pellicle_{name} as *const ()),").unwrap();
    }
    text.push_str("];\n");
    text
}

/// The number that the header states.
fn abi_version(header: &str) -> &str {
    let line = header
        .lines()
        .find_map(|line| line.strip_prefix("#define PELLICLE_ABI_VERSION "));
    line.expect("the header states its version").trim()
}

/// Gives the shared library its run-time name where cargo puts it, so that a program linked there starts:
/// a link in the folder of the profile, three above OUT_DIR.
fn link_soname(out: &Path, soname: &str) {
    #[cfg(unix)]
    if let Some(folder) = out.ancestors().nth(3) {
        let link = folder.join(soname);
        if fs::symlink_metadata(&link).is_err() {
            // A folder that cannot be written to is no reason to fail a build.
            let _ = std::os::unix::fs::symlink("libpellicle.so", &link);
        }
    }
}
