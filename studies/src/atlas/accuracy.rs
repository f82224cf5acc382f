//! docs/accuracy.md.

use super::films::{Films, PEERS, Swept, TOLERANCE};
use super::laws::Law;
use super::models::{self, Models};
use super::{CELLS, number};
use crate::shared::habit::Habit;
use crate::shared::markdown::table;
use crate::shared::peer::Peer;
use pellicle::bsdf;
use pellicle::film::OneLayerMethod as Kind;

/// The angle up to which a method's reach is counted, degrees, and the error.
const REACH_ANGLE: f64 = 60.0;
const REACH_ERROR: f64 = 1e-2;

/// The page.
pub fn page(films: &Films, models: &Models) -> String {
    format!(
        "# Accuracy, method by method\n\
         \n\
         `./x atlas` writes this page from the same run as [the atlas](atlas.md): {} methods and settings on\n\
         {} maps of thickness, index and extinction times angle, {} maps of shading models. Errors are of\n\
         linear RGB clipped to [0, 1] against the converged reference, itself converged to 1e-5.\n\
         \n\
         ## Interference methods\n\
         \n\
         Digits lost: of single precision's seven, the worst difference of the two instances up to 1 um, and at\n\
         any thickness up to 10 cm. All are functions of the angle of incidence alone, hence reciprocal; films\n\
         with transmittance take both directions from one table. Energy: the greatest channel above 1 before\n\
         clipping, beyond the truth's own.\n\
         \n\
         {}\n\
         ## By stack\n\
         \n\
         For each stack the greatest error, the share of the map (thickness times angle, as in the atlas)\n\
         within {TOLERANCE:e}, and the reach: the thickness in nm up to which every error below {REACH_ANGLE} degrees stays\n\
         within {REACH_ERROR:e}.\n\
         \n\
         {}\
         ## Shading models\n\
         \n\
         The worst over each model's map, of white surfaces, with the parameter and the viewer's angle. float32: of\n\
         value and pdf over value + pdf + 0.001, and the digits of seven that are lost. Sampling: density against\n\
         the sampler's Jacobian. NaN: values or densities that are not finite or negative. *Declared*: the model's\n\
         description says so. Each map has {CELLS} by {CELLS} cells, with 24 directions to the light and 6 samples\n\
         per lobe.\n\
         \n\
         {}\n\
         What the models declare:\n\
         \n\
         {}",
        PEERS.len(),
        films.all().count(),
        models.swept.len(),
        methods(films),
        films.thicknesses.iter().map(by_stack).collect::<String>(),
        shading(models),
        declared(),
    )
}

/// The uses of a method, in words.
fn validity(peer: Peer) -> &'static str {
    match peer {
        Peer::Layered => "pictures that need not be right; angles of reflection by its lobes",
        Peer::Method(Kind::TwoBeam) => "film and base close in index, path below 500 nm",
        Peer::Method(Kind::AiryRgb) => "path below 500 nm; exact at thickness 0",
        Peer::Method(Kind::Quadrature(_)) => {
            "2 n d below 900 nm times N less 4 um; not grazing soap"
        }
        Peer::Method(Kind::Bands(_)) => "any thickness; error as 1 / K^2",
        Peer::Method(Kind::Harmonics(_)) => {
            "weak bases, any thickness; neither dispersion nor absorption"
        }
        Peer::Habit(Habit::MirrorAtTotalReflection) => "films of a higher index than the ambient's",
        Peer::Habit(Habit::FadeBelow1Nm) => "all but grazing angles",
        Peer::Forced("series", _) => "any one film; sums every harmonic, slow",
        _ => "everything a film may be: promised",
    }
}

fn methods(films: &Films) -> String {
    let rows = PEERS.into_iter().enumerate().map(|(i, peer)| {
        let (found, scene) = films.worst(i, |map| map.worst).unwrap();
        let above = films
            .worst(i, |map| map.above)
            .map_or(0.0, |(found, _)| found.value);
        let digits = films
            .worst_precision(i)
            .map(|(found, _)| digits_lost(found.value));
        vec![
            peer.title(),
            validity(peer).into(),
            number(found.value),
            format!("{}; {}", scene.name, scene.place(found.x, found.cos_theta)),
            thin_precision(films, i)
                .map(digits_lost)
                .unwrap_or_default(),
            digits.unwrap_or_default(),
            if peer.tolerance().is_some() {
                "clipped".into()
            } else {
                number(above)
            },
        ]
    });
    let headings = "method | good for | >worst error | where | >digits lost, to 1 um | >any thickness | >above 1 by";
    table(headings, rows)
}

/// The greatest difference of precisions at thicknesses to 1 um.
fn thin_precision(films: &Films, peer: usize) -> Option<f64> {
    let mut greatest = 0.0f64;
    for precision in &films.precisions {
        let map = precision.maps[peer].as_ref()?;
        for (i, error) in map.errors.iter().enumerate() {
            let right = (i % map.cells + 1) as f64 / map.cells as f64;
            if precision.scene.x.at(right) <= 1e3 {
                greatest = greatest.max(error.unwrap_or(0.0));
            }
        }
    }
    Some(greatest)
}

fn by_stack(swept: &Swept) -> String {
    let rows = PEERS.into_iter().enumerate().map(|(i, peer)| {
        let map = &swept.maps[i];
        if map.evaluations == 0 {
            let mut row = vec![String::new(); 5];
            (row[0], row[1]) = (peer.title(), "refused".into());
            return row;
        }
        // Rounded down, so that only all is 100 %.
        let within = format!("{:.0} %", (100.0 * map.share_within(TOLERANCE)).floor());
        vec![
            peer.title(),
            number(map.worst.value),
            within,
            reach(swept, i),
            map.methods.join(", "),
        ]
    });
    let headings = format!("method | >greatest | >within {TOLERANCE:e} | >reach, nm | chosen");
    format!("{}:\n\n{}\n", swept.scene.name, table(&headings, rows))
}

/// The thickness up to which a peer's errors are small at all angles but grazing ones.
fn reach(swept: &Swept, peer: usize) -> String {
    let (map, scene) = (&swept.maps[peer], &swept.scene);
    let end = |i: usize| (i + 1) as f64 / map.cells as f64;
    let rows = (0..map.cells)
        .take_while(|row| scene.y.at(end(*row)) <= REACH_ANGLE)
        .count();
    let is_good = |column: &usize| {
        let error = |row: usize| map.errors[row * map.cells + column];
        (0..rows).all(|row| error(row).is_some_and(|error| error <= REACH_ERROR))
    };
    match (0..map.cells).take_while(is_good).count() {
        0 => "none".into(),
        count if count == map.cells => "all".into(),
        count => format!("{:.0}", scene.x.at(end(count - 1))),
    }
}

fn shading(models: &Models) -> String {
    let row = |swept: &models::Swept| {
        let axis = &swept.case.x;
        let mut row = vec![
            swept.case.name(),
            format!("{} {} to {:.3}", axis.name, axis.first, axis.last),
        ];
        row.extend(Law::ALL.map(|law| {
            let map = &swept.maps[law as usize];
            let found = map.worst;
            if found.value == 0.0 {
                let is_tried = map.errors.iter().any(Option::is_some);
                return if is_tried { "0".into() } else { String::new() };
            }
            let note = match law {
                Law::Precision => format!(", {} digits", digits_lost(found.value)),
                Law::Reciprocity if swept.declared[0] => ", declared".into(),
                Law::Energy if swept.declared[1] => ", declared".into(),
                _ => String::new(),
            };
            let (value, angle) = (number(found.value), found.cos_theta.acos().to_degrees());
            format!("{value} ({:.1e}, {angle:.0} deg{note})", found.x)
        }));
        row.push(swept.not_finite.to_string());
        row
    };
    let laws = Law::ALL.map(|law| format!(">{}", law.title())).join(" | ");
    let headings = format!("model | over | {laws} | >NaN");
    table(&headings, models.swept.iter().map(row))
}

fn declared() -> String {
    let lines = bsdf::models().iter().flat_map(|entry| {
        let exceptions = [
            ("not reciprocal", &entry.info.not_reciprocal),
            ("not energy-conserving", &entry.info.not_conserving),
        ];
        exceptions.map(|(law, exception)| {
            let reason = exception.as_ref()?.reason;
            Some(format!("- `{}` is {law} for {reason}.\n", entry.name()))
        })
    });
    lines.flatten().collect()
}

/// The number of single precision's seven digits that an error takes, from 2^-24.
fn digits_lost(error: f64) -> String {
    let lost = (error / f64::from(f32::EPSILON / 2.0)).log10().max(0.0);
    format!("{lost:.1}")
}

#[test]
fn digits_count_from_the_last() {
    assert_eq!([6e-8, 6e-5, 0.0].map(digits_lost), ["0.0", "3.0", "0.0"]);
}
