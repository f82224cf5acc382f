//! Time against error of every interference method: writes docs/chart.svg, docs/chart.csv and
//! docs/chart.md; with the argument `environment`, docs/environment.svg from docs/environment.csv.
//! `./x chart` runs both.

mod axis;
mod batch;
mod chart;
mod contest;
mod entry;
mod environment;
mod errors;
mod front;
mod labels;
mod marker;
mod panel;
#[path = "../../tests/common/parallel.rs"]
mod parallel;
mod report;
mod suite;
mod text;
mod timing;

use std::path::Path;
use std::{env, error, fs};

fn main() -> Result<(), Box<dyn error::Error>> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    if env::args().nth(1).as_deref() == Some("environment") {
        return environment::draw(&docs);
    }
    let stacks = suite::stacks()?;
    let cells = contest::run(&stacks)?;
    fs::write(docs.join("chart.csv"), report::csv(&cells))?;
    fs::write(docs.join("chart.svg"), chart::svg(&cells)?)?;
    fs::write(docs.join("chart.md"), report::markdown(&cells))?;
    Ok(())
}
