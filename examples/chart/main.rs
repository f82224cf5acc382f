//! Time against error of every interference method: writes docs/chart.svg, docs/chart.csv and
//! docs/chart.md. `./x chart` runs it.

mod axis;
mod batch;
mod chart;
mod contest;
mod entry;
mod errors;
mod front;
mod labels;
mod marker;
mod panel;
mod parallel;
mod report;
mod suite;
mod text;
mod timing;

use std::path::Path;
use std::{error, fs};

fn main() -> Result<(), Box<dyn error::Error>> {
    let stacks = suite::stacks()?;
    let cells = contest::run(&stacks)?;
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    fs::write(docs.join("chart.csv"), report::csv(&cells))?;
    fs::write(docs.join("chart.svg"), chart::svg(&cells)?)?;
    fs::write(docs.join("chart.md"), report::markdown(&cells))?;
    Ok(())
}
