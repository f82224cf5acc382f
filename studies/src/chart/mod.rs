//! Time against error of every interference method: docs/chart.svg, docs/chart.csv and docs/chart.md; and of three
//! ways to an environment's reflection: docs/environment.svg.

mod contest;
mod environment;
pub mod errors;
mod picture;
mod report;
mod suite;
mod timing;

use std::error::Error;
use std::fs;
use std::path::Path;

/// Writes everything into the folder `docs`, where environment.csv is read.
pub fn run(docs: &Path) -> Result<(), Box<dyn Error>> {
    environment::draw(docs)?;
    let cells = contest::run(&suite::stacks());
    fs::write(docs.join("chart.csv"), report::csv(&cells))?;
    fs::write(docs.join("chart.svg"), picture::svg(&cells)?)?;
    fs::write(docs.join("chart.md"), report::markdown(&cells))?;
    Ok(())
}
