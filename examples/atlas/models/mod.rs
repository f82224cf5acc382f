//! Every shading model over the parameter that is hardest on it.

mod case;
mod film;
mod laws;

pub use case::Case;
pub use laws::Law;

use crate::atlas::axis::{ANGLE, Axis};
use crate::atlas::map::Found;
use crate::atlas::parallel;
use laws::Measured;
use pellicle::Error;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// Cells on either side of a map.
pub const CELLS: usize = 28;

/// One model and parameter.
pub struct Swept {
    pub case: Case,
    /// One per law.
    pub maps: [ModelMap; Law::ALL.len()],
    pub not_finite: usize,
    /// Whether the model's description says that it is not reciprocal, or not conserving, here.
    pub declared: [bool; 2],
}

/// How far a law is broken.
pub struct ModelMap {
    /// Row by row from normal incidence; none: it does not apply.
    pub errors: Vec<Option<f64>>,
    pub worst: Found,
}

/// All models.
pub struct Models {
    pub swept: Vec<Swept>,
    /// Values, densities and samples asked for, in either precision; albedos count as one.
    pub evaluations: usize,
}

/// The vertical axis: the viewer's angle.
pub const VIEW: Axis = Axis {
    name: "viewer's angle",
    ..ANGLE
};

/// Sweeps everything.
pub fn sweep() -> Result<Models, Error> {
    let cases = case::all();
    let jobs: Vec<(usize, usize)> = (0..cases.len())
        .flat_map(|case| (0..CELLS).map(move |column| (case, column)))
        .collect();
    let columns = parallel::map(&jobs, |(case, column)| column_of(&cases[*case], *column));
    let columns: Vec<Column> = columns.into_iter().collect::<Result<_, Error>>()?;
    let evaluations = columns.iter().map(|column| column.evaluations).sum();
    let mut columns = columns.into_iter();
    let mut swept = Vec::new();
    for case in cases {
        let own: Vec<Column> = columns.by_ref().take(CELLS).collect();
        swept.push(gathered(case, &own)?);
    }
    Ok(Models { swept, evaluations })
}

/// What one value of the parameter gives, from normal incidence to grazing.
struct Column {
    x: f64,
    cells: Vec<(f64, Measured)>,
    evaluations: usize,
}

fn column_of(case: &Case, column: usize) -> Result<Column, Error> {
    let x = case.x.at((column as f64 + 0.5) / CELLS as f64);
    let mut rng = Pcg64Mcg::seed_from_u64(column as u64);
    let subject = laws::Subject::new(case, x)?;
    let cells = (0..CELLS).map(|row| {
        let angle = VIEW.at((row as f64 + 0.5) / CELLS as f64);
        (angle.to_radians().cos(), subject.measure(angle, &mut rng))
    });
    let cells: Vec<(f64, Measured)> = cells.collect();
    Ok(Column {
        x,
        evaluations: cells.iter().map(|(_, measured)| measured.evaluations).sum(),
        cells,
    })
}

fn gathered(case: Case, columns: &[Column]) -> Result<Swept, Error> {
    let map = |law: usize| {
        let cells = (0..CELLS).flat_map(|row| columns.iter().map(move |c| (c.x, &c.cells[row])));
        let mut worst = Found::default();
        let errors = cells.map(|(x, (cos_theta, measured))| {
            let error = measured.errors[law];
            worst = worst.or(error.unwrap_or(0.0), x, *cos_theta as f32);
            error
        });
        let errors = errors.collect();
        ModelMap { errors, worst }
    };
    let measured = columns.iter().flat_map(|column| &column.cells);
    Ok(Swept {
        maps: std::array::from_fn(map),
        not_finite: measured.map(|(_, measured)| measured.not_finite).sum(),
        declared: case.declared()?,
        case,
    })
}
