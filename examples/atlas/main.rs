//! Where every method and model fails, and how badly: writes docs/atlas.md, docs/accuracy.md and the
//! heat maps docs/atlas-*.svg. `./x atlas` runs it.

#[path = "../../tests/common/atlas/mod.rs"]
mod atlas;
mod films;
mod models;
mod picture;
mod report;
#[allow(dead_code)] // the chart uses all of it
#[path = "../chart/text.rs"]
mod text;

use std::path::Path;
use std::time::Instant;
use std::{error, fs};

fn main() -> Result<(), Box<dyn error::Error>> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let start = Instant::now();
    let progress = |what: &str| eprintln!("{:4.0} s: {what}", start.elapsed().as_secs_f64());
    progress("films");
    let films = films::sweep()?;
    progress("models");
    let models = models::sweep()?;
    progress("pictures and tables");
    for (name, svg) in report::pictures(&films, &models)? {
        fs::write(docs.join(name), svg)?;
    }
    fs::write(docs.join("atlas.md"), report::atlas(&films, &models))?;
    fs::write(docs.join("accuracy.md"), report::accuracy(&films, &models))?;
    progress("done");
    Ok(())
}
