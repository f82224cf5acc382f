//! The checked-in C header is what the sources generate.
//!
//! `PELLICLE_RENEW=1 cargo test --test header` rewrites it.

use std::fs;
use std::path::Path;

#[test]
fn the_header_is_current() {
    let generated = fs::read_to_string(env!("PELLICLE_GENERATED_HEADER")).unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/pellicle.h");
    if std::env::var_os("PELLICLE_RENEW").is_some() {
        fs::write(&path, &generated).unwrap();
    }
    let checked_in = fs::read_to_string(&path).unwrap();
    assert!(
        checked_in == generated,
        "include/pellicle.h is out of date; PELLICLE_RENEW=1 cargo test --test header rewrites it"
    );
}
