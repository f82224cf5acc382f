//! Writes the atlas of errors into docs/.

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    pellicle_studies::atlas::run(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs"))
}
