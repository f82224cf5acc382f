//! Writes the chart and the picture of the environment's reflection into docs/.

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    pellicle_studies::chart::run(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs"))
}
