//! Where every method and model fails, and how badly: docs/atlas.md, docs/accuracy.md and the heat maps
//! docs/atlas-*.svg.

mod accuracy;
mod case;
mod films;
mod laws;
mod models;
mod picture;
mod report;
mod smooth;

use std::fs;
use std::path::Path;
use std::time::Instant;

/// Cells on either side of a map.
const CELLS: usize = 28;

/// Writes everything into the folder `docs`.
pub fn run(docs: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let start = Instant::now();
    let progress = |what: &str| eprintln!("{:4.0} s: {what}", start.elapsed().as_secs_f64());
    progress("films");
    let films = films::sweep()?;
    progress("models");
    let models = models::sweep()?;
    progress("pictures and tables");
    for (name, picture) in films.pictures().into_iter().chain(models.pictures()) {
        fs::write(docs.join(name), picture.svg()?)?;
    }
    fs::write(docs.join("atlas.md"), report::page(&films, &models))?;
    fs::write(docs.join("accuracy.md"), accuracy::page(&films, &models))?;
    progress("done");
    Ok(())
}

/// Two digits.
fn number(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else {
        format!("{value:.1e}")
    }
}
