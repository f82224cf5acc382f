//! docs/accuracy.md.

use super::atlas::{worst, worst_precision};
use super::words::{digits_lost, number, percent};
use crate::atlas::contender::Contender;
use crate::atlas::scene::{Across, Scene};
use crate::films::{self, Films, Swept, TOLERANCE};
use crate::models::{self, Law, Models};
use pellicle::bsdf;
use pellicle::film::OneLayerMethod;
use std::fmt::Write;

/// Angles up to which a method's reach is counted, degrees.
const REACH_ANGLE: f64 = 60.0;
/// The error up to which it is.
const REACH_ERROR: f64 = 1e-2;

/// The page.
pub fn accuracy(films: &Films, models: &Models) -> String {
    let mut out = format!(
        "# Accuracy, method by method\n\
         \n\
         `./x atlas` writes this page from the same run as [the atlas](atlas.md): {} methods and settings on\n\
         {} maps of thickness, index and extinction times angle, {} maps of shading models. Errors are of\n\
         linear RGB clipped to [0, 1] against the converged reference, itself converged to 1e-5.\n",
        films::contenders().len(),
        films.all().count(),
        models.swept.len(),
    );
    out += &methods(films);
    out += &by_stack(films);
    out += &shading(models);
    out
}

/// What a method is good for, in words.
fn validity(contender: Contender) -> &'static str {
    match contender {
        Contender::Layered => "pictures that need not be right; angles of reflection by its lobes",
        Contender::Kind(OneLayerMethod::TwoBeam) => {
            "film and base close in index, path below 500 nm"
        }
        Contender::Kind(OneLayerMethod::AiryRgb) => "path below 500 nm; exact at thickness 0",
        Contender::Kind(OneLayerMethod::Quadrature(_)) => {
            "2 n d below 900 nm times N less 4 um; not grazing soap"
        }
        Contender::Kind(OneLayerMethod::Bands(_)) => "any thickness; error as 1 / K^2",
        Contender::Kind(OneLayerMethod::Harmonics(..)) => {
            "weak bases, any thickness; neither dispersion nor absorption"
        }
        Contender::Forced("series", _) => "any one film; sums every harmonic, slow",
        Contender::Forced(..) => "where it fits; refused elsewhere",
        Contender::Planned(_) => "everything a film may be: promised",
    }
}

fn methods(films: &Films) -> String {
    let mut out = String::from(
        "\n## Interference methods\n\n\
         Digits lost: of single precision's seven, the worst difference of the two instances up to 1 um, and at\n\
         any thickness up to 10 cm. All are functions of the angle of incidence alone, hence reciprocal; films\n\
         with transmittance take both directions from one table. Energy: the greatest channel above 1 before\n\
         clipping, beyond the truth's own.\n\n\
         | method | good for | worst error | where | digits lost, to 1 um | any thickness | above 1 by |\n\
         |---|---|---:|---|---:|---:|---:|\n",
    );
    for (i, contender) in films::contenders().into_iter().enumerate() {
        let Some((found, scene)) = worst(films, i, |map| map.worst) else {
            continue;
        };
        let place = format!("{}; {}", scene.name, scene.place(found.x, found.cos_theta));
        let digits = worst_precision(films, i).map(|(found, _)| digits_lost(found.value));
        let thin = thin_precision(films, i).map(digits_lost);
        let above = worst(films, i, |map| map.above).map_or(0.0, |(found, _)| found.value);
        let above = if contender.tolerance().is_some() {
            "clipped".into()
        } else {
            number(above)
        };
        writeln!(
            out,
            "| {} | {} | {} | {place} | {} | {} | {above} |",
            contender.name(),
            validity(contender),
            number(found.value),
            thin.unwrap_or_default(),
            digits.unwrap_or_default(),
        )
        .unwrap();
    }
    out
}

/// The greatest difference of precisions at thicknesses to 1 um.
fn thin_precision(films: &Films, contender: usize) -> Option<f64> {
    let mut greatest = 0.0f64;
    for precision in &films.precisions {
        let map = precision.maps[contender].as_ref()?;
        let is_thin =
            |column: usize| precision.scene.x.at((column + 1) as f64 / map.cells as f64) <= 1e3;
        for (i, error) in map.errors.iter().enumerate() {
            if is_thin(i % map.cells) {
                greatest = greatest.max(error.unwrap_or(0.0));
            }
        }
    }
    Some(greatest)
}

fn by_stack(films: &Films) -> String {
    let mut out = format!(
        "\n## By stack\n\n\
         For each stack the greatest error, the share of the map (thickness times angle, as in the atlas)\n\
         within {TOLERANCE:e}, and the reach: the thickness in nm up to which every error below {REACH_ANGLE} degrees stays\n\
         within {REACH_ERROR:e}.\n"
    );
    for swept in films
        .thicknesses
        .iter()
        .filter(|s| s.scene.across == Across::Thickness)
    {
        write!(
            out,
            "\n{}:\n\n| method | greatest | within {TOLERANCE:e} | reach, nm | chosen |\n|---|---:|---:|---:|---|\n",
            swept.scene.name
        )
        .unwrap();
        for (i, contender) in films::contenders().into_iter().enumerate() {
            let map = &swept.maps[i];
            if map.evaluations == 0 {
                writeln!(out, "| {} | refused | | | |", contender.name()).unwrap();
                continue;
            }
            writeln!(
                out,
                "| {} | {} | {} | {} | {} |",
                contender.name(),
                number(map.worst.value),
                percent(map.share_within(TOLERANCE)),
                reach(swept, i),
                map.methods.join(", ")
            )
            .unwrap();
        }
    }
    out
}

/// The thickness up to which a contender's errors are small at all angles but grazing ones.
fn reach(swept: &Swept, contender: usize) -> String {
    let map = &swept.maps[contender];
    let (scene, cells): (&Scene, usize) = (&swept.scene, map.cells);
    let rows =
        (0..cells).take_while(|row| scene.y.at((row + 1) as f64 / cells as f64) <= REACH_ANGLE);
    let is_good = |column: usize| {
        let mut rows = rows.clone();
        rows.all(|row| map.errors[row * cells + column].is_some_and(|error| error <= REACH_ERROR))
    };
    match (0..cells).take_while(|column| is_good(*column)).count() {
        0 => "none".into(),
        count if count == cells => "all".into(),
        count => format!("{:.0}", scene.x.at(count as f64 / cells as f64)),
    }
}

fn shading(models: &Models) -> String {
    let mut out = String::from(
        "\n## Shading models\n\n\
         The worst over each model's maps, of white surfaces. Digits lost: of value and pdf over value + pdf +\n\
         0.001. Sampling: density against the sampler's Jacobian. NaN: values or densities that are not finite or\n\
         negative.\n\n\
         | model | over | digits lost | not reciprocal by | albedo above 1 by | sampling | NaN |\n\
         |---|---|---:|---:|---:|---:|---:|\n",
    );
    for swept in &models.swept {
        let worst = |law: Law| swept.maps[law as usize].worst.value;
        let declared = |law: Law, is_declared: bool| {
            let mark = if is_declared { ", declared" } else { "" };
            format!("{}{mark}", number(worst(law)))
        };
        let over = format!(
            "{} {} to {:.3}",
            swept.case.x.name, swept.case.x.first, swept.case.x.last
        );
        writeln!(
            out,
            "| {} | {over} | {} | {} | {} | {} | {} |",
            swept.case.name(),
            digits_lost(worst(Law::Precision)),
            declared(Law::Reciprocity, swept.declared[0]),
            declared(Law::Energy, swept.declared[1]),
            number(worst(Law::Sampling)),
            swept.not_finite
        )
        .unwrap();
    }
    out += "\nWhat the models declare:\n\n";
    for entry in bsdf::models() {
        let exceptions = [
            ("not reciprocal", &entry.info.not_reciprocal),
            ("not energy-conserving", &entry.info.not_conserving),
        ];
        for (law, exception) in exceptions {
            if let Some(exception) = exception {
                let reason = exception.reason;
                writeln!(out, "- `{}` is {law} for {reason}.", entry.name()).unwrap();
            }
        }
    }
    writeln!(
        out,
        "\nEach map has {} by {} cells, with 24 directions to the light and 6 samples per lobe.",
        models::CELLS,
        models::CELLS
    )
    .unwrap();
    out
}
