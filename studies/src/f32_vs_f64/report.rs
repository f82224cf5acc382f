//! The report, in Markdown.

use super::Settings;
use super::bounds::Between;
use super::row::{HORIZON, Quantity, Row};
use super::tally::FLOOR;
use crate::shared::markdown::table;
use pellicle::num::Level;

/// The second number of a cell is the error that this part of all errors does not exceed.
const PART: f64 = 0.9999;

const HEADINGS: &str = "model and variant | >elements | value | pdf | weight | direction | at the horizon | reflectance | >excused | other lobe | between levels";

pub fn print(settings: &Settings, rows: &[Row]) {
    let levels: Vec<&str> = Level::all().iter().map(|level| level.name()).collect();
    println!("# Single precision against double\n");
    println!(
        "{} random elements of seed {}, at the levels {} and by single calls, against the f64 instance at the \
         same single-precision inputs. Errors: worst / 99.99th percentile / bound. Values, densities and weights: \
         |error| / ({FLOOR:e} + |truth|), the worst channel; directions: distance of the ends of unit vectors; \
         films: of clipped colours. At the horizon: where a cosine is below {HORIZON:e}. Excused: beyond the bound, \
         but the last digits of the inputs' components explain as much. Where a density has a pole, a few elements \
         may be beyond a bound: f32_vs_f64/bounds.rs says where, and why bounds are what they are.\n",
        rows.iter().map(|row| row.evaluations).sum::<u64>(),
        settings.seed,
        levels.join(", "),
    );
    let cells = |row: &Row| {
        let mut cells = vec![row.name.clone(), row.evaluations.to_string()];
        cells.extend(Quantity::ALL.map(|quantity| cell(row, quantity)));
        cells.extend([row.excused.count.to_string(), switched(row), between(row)]);
        cells
    };
    print!("{}", table(HEADINGS, rows.iter().map(cells)));
    println!("\n## Worst elements\n");
    for row in rows {
        for quantity in Quantity::ALL {
            if let Some(worst) = row.tally(quantity).worst.as_ref().filter(|w| w.error > 0.0) {
                let (name, error, place) = (quantity.name(), worst.error, &worst.place);
                println!("- {}, {name} {error:.2e}: `{place}`", row.name);
            }
        }
        if let Some(place) = &row.switched_place {
            println!("- {}, another lobe: `{place}`", row.name);
        }
    }
}

fn cell(row: &Row, quantity: Quantity) -> String {
    let tally = row.tally(quantity);
    if tally.count == 0 {
        return String::new();
    }
    let [worst, most] = [tally.greatest(), tally.quantile(PART)];
    format!("{worst:.1e} / {most:.1e} / {:e}", row.bounds.of(quantity))
}

fn switched(row: &Row) -> String {
    if row.samples == 0 {
        return String::new();
    }
    format!("{:.1e} / {:e}", row.switched_share(), row.bounds.switched)
}

fn between(row: &Row) -> String {
    let bound = match row.bounds.between {
        Between::SameBits => "same bits".to_owned(),
        Between::Within(bound) => format!("bound {bound:e}"),
    };
    match (row.differing, row.between.greatest()) {
        (0, _) => "same bits".to_owned(),
        (differing, greatest) => format!("{differing} differ, by {greatest:.1e}; {bound}"),
    }
}
