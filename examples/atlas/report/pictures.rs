//! docs/atlas-*.svg.

use crate::atlas::contender::Contender;
use crate::atlas::map::Map;
use crate::atlas::scene::Scene;
use crate::films::{Films, Swept, TOLERANCE};
use crate::models::{self, Law, Models};
use crate::picture::{Cells, Failure, Picture, Row};

/// File names and contents.
pub fn pictures(films: &Films, models: &Models) -> Result<Vec<(&'static str, String)>, Failure> {
    let truth =
        "Greatest error of a channel of linear RGB in [0, 1] against converged wave optics.";
    let mut pictures = vec![
        (
            "atlas-thickness.svg",
            "Interference methods: error over thickness and angle",
            &films.thicknesses,
        ),
        (
            "atlas-grazing.svg",
            "Very thin films at grazing angles, both by their logarithm",
            &films.corners,
        ),
        (
            "atlas-index.svg",
            "Interference methods: error over index, extinction and angle",
            &films.indices,
        ),
    ]
    .into_iter()
    .map(|(file, title, swept)| {
        let picture = Picture {
            title: title.into(),
            explanation: vec![
                truth.into(),
                "Left to right: the paper's model and its two beams, three wavelengths, Belcour and \
                 Barla's harmonics, then ours. Words in a map: what the plan chose."
                    .into(),
            ],
            headings: headings(),
            rows: swept.iter().map(row).collect(),
            contour: TOLERANCE,
        };
        Ok((file, picture.svg()?))
    })
    .collect::<Result<Vec<_>, Failure>>()?;
    pictures.push(("atlas-float32.svg", precision(films).svg()?));
    for (file, of_model) in MODEL_PICTURES {
        pictures.push((file, model_picture(models, of_model).svg()?));
    }
    Ok(pictures)
}

fn headings() -> Vec<String> {
    let drawn = Contender::DRAWN.iter();
    drawn.map(|contender| contender.name()).collect()
}

fn row(swept: &Swept) -> Row {
    let panel = |(map, contender): (&Map, &Contender)| {
        let is_planned = matches!(contender, Contender::Planned(_));
        Some(Cells {
            x: swept.scene.x,
            count: map.cells,
            errors: map.errors.clone(),
            note: if is_planned {
                map.methods.join(", ")
            } else {
                String::new()
            },
        })
    };
    Row {
        name: swept.scene.name.into(),
        y: swept.scene.y,
        panels: swept
            .maps
            .iter()
            .zip(&Contender::DRAWN)
            .map(panel)
            .collect(),
    }
}

/// Single against double precision.
fn precision(films: &Films) -> Picture {
    let has_two = |column: &usize| {
        let mut precisions = films.precisions.iter();
        precisions.any(|precision| precision.maps[*column].is_some())
    };
    let columns: Vec<usize> = (0..Contender::DRAWN.len()).filter(has_two).collect();
    let panel = |scene: &Scene, map: &Map| Cells {
        x: scene.x,
        count: map.cells,
        errors: map.errors.clone(),
        note: String::new(),
    };
    let rows = films.precisions.iter().map(|precision| Row {
        name: precision.scene.name.into(),
        y: precision.scene.y,
        panels: columns
            .iter()
            .map(|i| Some(panel(&precision.scene, precision.maps[*i].as_ref()?)))
            .collect(),
    });
    Picture {
        title: "Interference methods: float32 against float64".into(),
        explanation: vec![
            "Greatest difference of a channel between the two instances of one formula, up to a film \
             of ten centimetres."
                .into(),
            "A phase of thousands of turns has few digits left: what integrates over it forgets it, \
             what samples it is wrong."
                .into(),
        ],
        headings: columns.iter().map(|i| Contender::DRAWN[*i].name()).collect(),
        rows: rows.collect(),
        contour: TOLERANCE,
    }
}

/// Whether a model of that name is shown.
type OfModel = fn(&str) -> bool;

/// Files, and which models each shows.
const MODEL_PICTURES: [(&str, OfModel); 2] = [
    ("atlas-models.svg", |model| model != "microfacet"),
    ("atlas-microfacet.svg", |model| model == "microfacet"),
];

/// Models in columns, laws in rows.
fn model_picture(models: &Models, is_shown: OfModel) -> Picture {
    let shown: Vec<&models::Swept> = models
        .swept
        .iter()
        .filter(|swept| is_shown(swept.case.model))
        .collect();
    let rows = Law::ALL.map(|law| {
        let panel = |swept: &&models::Swept| {
            Some(Cells {
                x: swept.case.x,
                count: models::CELLS,
                errors: swept.maps[law as usize].errors.clone(),
                note: String::new(),
            })
        };
        Row {
            name: law.title().into(),
            y: models::VIEW,
            panels: shown.iter().map(panel).collect(),
        }
    });
    Picture {
        title: "Shading models: how far each keeps the laws".into(),
        explanation: vec![
            "White surfaces. Relative to value + pdf + 0.001; to the greater of both directions; to 1; to \
             the density."
                .into(),
            "Albedos are integrated to 2e-3: what is below the contour there is within what can be told."
                .into(),
        ],
        headings: shown.iter().map(|swept| swept.case.name()).collect(),
        rows: rows.into(),
        contour: TOLERANCE,
    }
}
