//! Generates the C header into OUT_DIR and sets the shared library's SONAME.
//!
//! The header that users include is the checked-in `include/pellicle.h`; a test compares the two,
//! so that the source tree is never written during a build.

use std::path::PathBuf;
use std::{env, fs};

/// The files that hold the C interface, in the order in which the header presents them.
const INTERFACE: [&str; 8] = [
    "src/capi/types.rs",
    "src/capi/args.rs",
    "src/capi/version.rs",
    "src/capi/model.rs",
    "src/capi/film.rs",
    "src/capi/bsdf.rs",
    "src/capi/batch.rs",
    "src/capi/api.rs",
];

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=cbindgen.toml");
    println!("cargo:rerun-if-changed=src/capi");

    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    let mut builder = cbindgen::Builder::new().with_config(config);
    let preamble = fs::read_to_string(root.join("src/capi/preamble.h")).unwrap();
    builder = builder.with_header(preamble.replace("@VERSION@", env!("CARGO_PKG_VERSION")));
    for file in INTERFACE {
        builder = builder.with_src(root.join(file));
    }
    let header = out.join("pellicle.h");
    let mut text = Vec::new();
    builder
        .generate()
        .expect("cbindgen failed")
        .write(&mut text);
    // Rust's customary heading reads better in C as a plain word.
    let text = String::from_utf8(text)
        .unwrap()
        .replace("// # Safety\n", "// Preconditions:\n");
    fs::write(&header, text).unwrap();
    println!(
        "cargo:rustc-env=PELLICLE_GENERATED_HEADER={}",
        header.display()
    );

    if env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        // ABI version, not crate version: it changes only when linked programs must be rebuilt.
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libpellicle.so.1");
    }
}
