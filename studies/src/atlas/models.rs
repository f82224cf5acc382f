//! Every shading model over the parameter that is hardest on it.

use super::CELLS;
use super::case::{self, Case};
use super::laws::{Law, Measured, Subject};
use super::picture::{Cells, Picture, Row};
use crate::error_maps::axis::{ANGLE, Axis};
use crate::error_maps::map::Found;
use crate::shared::directions::rng;
use pellicle::Error;
use rayon::prelude::*;

/// The vertical axis.
const VIEW: Axis = Axis {
    name: "viewer's angle",
    ..ANGLE
};

/// One model and parameter.
pub struct Swept {
    pub case: Case,
    /// One per law.
    pub maps: [ModelMap; Law::ALL.len()],
    pub not_finite: usize,
    /// Whether the model declares that it is not reciprocal, or does not conserve energy, here.
    pub declared: [bool; 2],
}

/// The errors of a law.
pub struct ModelMap {
    /// Row by row from normal incidence; none where the law does not apply.
    pub errors: Vec<Option<f64>>,
    pub worst: Found,
}

/// All models.
pub struct Models {
    pub swept: Vec<Swept>,
    /// The number of values, densities and samples in either precision, and of albedos.
    pub evaluations: usize,
}

/// Sweeps everything.
pub fn sweep() -> Result<Models, Error> {
    let (mut swept, mut evaluations) = (Vec::new(), 0);
    for case in case::all() {
        let columns = (0..CELLS)
            .into_par_iter()
            .map(|column| column_of(&case, column));
        let columns = columns.collect::<Result<Vec<Column>, Error>>()?;
        let measured = || columns.iter().flat_map(|column| &column.cells);
        evaluations += measured()
            .map(|(_, measured)| measured.evaluations)
            .sum::<usize>();
        swept.push(Swept {
            maps: std::array::from_fn(|law| map(&columns, law)),
            not_finite: measured().map(|(_, measured)| measured.not_finite).sum(),
            declared: case.declared()?,
            case,
        });
    }
    Ok(Models { swept, evaluations })
}

/// The results at one value of the parameter, from normal incidence to grazing: cosines and errors.
struct Column {
    x: f64,
    cells: Vec<(f64, Measured)>,
}

fn column_of(case: &Case, column: usize) -> Result<Column, Error> {
    let x = case.x.at((column as f64 + 0.5) / CELLS as f64);
    let mut rng = rng(column as u64);
    let subject = Subject::new(case, x)?;
    let cells = (0..CELLS).map(|row| {
        let angle = VIEW.at((row as f64 + 0.5) / CELLS as f64);
        (angle.to_radians().cos(), subject.measure(angle, &mut rng))
    });
    let cells = cells.collect();
    Ok(Column { x, cells })
}

fn map(columns: &[Column], law: usize) -> ModelMap {
    let cells = (0..CELLS).flat_map(|row| columns.iter().map(move |c| (c.x, &c.cells[row])));
    let mut worst = Found::default();
    let errors = cells.map(|(x, (cos_theta, measured))| {
        let error = measured.errors[law];
        worst = worst.or(error.unwrap_or(0.0), x, *cos_theta as f32);
        error
    });
    let errors = errors.collect();
    ModelMap { errors, worst }
}

impl Models {
    /// File names and pictures: models in columns, laws in rows.
    pub fn pictures(&self) -> Vec<(&'static str, Picture)> {
        let is_microfacet = |swept: &&Swept| swept.case.model == "microfacet";
        let (microfacet, others) = self.swept.iter().partition(is_microfacet);
        vec![
            ("atlas-models.svg", picture(others)),
            ("atlas-microfacet.svg", picture(microfacet)),
        ]
    }
}

fn picture(shown: Vec<&Swept>) -> Picture {
    let row = |law: Law| {
        let panel = |swept: &&Swept| Cells {
            x: swept.case.x,
            count: CELLS,
            errors: swept.maps[law as usize].errors.clone(),
            note: String::new(),
        };
        Row {
            name: law.title().into(),
            y: VIEW,
            panels: shown.iter().map(panel).collect(),
        }
    };
    Picture {
        title: "Shading models: how far each keeps the laws",
        explanation: [
            "White surfaces. Relative to value + pdf + 0.001; to the greater of both directions; to 1; to the density.",
            "Albedos are integrated to 2e-3: errors below the contour there mean nothing.",
        ],
        headings: shown.iter().map(|swept| swept.case.name()).collect(),
        rows: Law::ALL.map(row).into(),
    }
}
