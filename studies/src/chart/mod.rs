//! Time against error of every interference method: docs/chart.svg, docs/chart.csv and docs/chart.md; of films on glass
//! from both sides: docs/chart-glass.svg; create() times: docs/create.svg; and of three ways to an environment's
//! reflection: docs/environment.svg.

mod contest;
mod create;
mod environment;
pub mod errors;
mod glass;
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
    let glass = glass::run(&glass::stacks());
    let created = create::run();
    fs::write(docs.join("chart.csv"), report::csv(&cells))?;
    fs::write(docs.join("chart.svg"), picture::svg(&cells)?)?;
    fs::write(docs.join("chart-glass.svg"), picture::glass_svg(&glass)?)?;
    fs::write(docs.join("create.svg"), create::svg(&created)?)?;
    let page = [
        report::markdown(&cells),
        report::glass(&glass),
        report::created(&create::markdown(&created)),
    ];
    fs::write(docs.join("chart.md"), page.concat())?;
    Ok(())
}
