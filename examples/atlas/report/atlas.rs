//! docs/atlas.md.

use super::words::number;
use crate::atlas::contender::Contender;
use crate::atlas::map::{Found, Map};
use crate::atlas::scene::{POINTS_PER_SIDE, Scene};
use crate::films::{self, CELLS, Films, TOLERANCE};
use crate::models::{Law, Models};
use pellicle::film::OneLayerMethod;
use std::fmt::Write;

/// Less than this above 1, or below 0, is rounding.
const ROUNDING: f64 = 1e-5;
/// Jumps that cannot be seen, and differences of precision that do not matter, are left out.
const SMALL: f64 = 1e-4;

/// The page.
pub fn atlas(films: &Films, models: &Models) -> String {
    let points = CELLS * POINTS_PER_SIDE;
    let mut out = format!(
        "# Atlas of errors\n\
         \n\
         Where every interference method and every shading model fails, and how badly. `./x atlas` writes\n\
         this page, its pictures and [accuracy.md](accuracy.md), which has the same figures by method.\n\
         `tests/atlas.rs` crosses the maps with the plan: it never chooses a method where its map shows an\n\
         error beyond the tolerance.\n\
         \n\
         **How to read the maps.** A cell is the greatest error at four points; each map has {points} by {points}\n\
         points. One scale for all, each step darker by a factor of ten; the black line is the contour at {TOLERANCE:e},\n\
         the default tolerance. Hatched: refused, or nothing to compare. Errors are those of a channel of linear RGB (Rec.709, white E)\n\
         clipped to [0, 1], in single precision, against the converged reference.\n\
         \n\
         ## Methods over thickness and angle\n\
         \n\
         ![Ten methods on twelve stacks](atlas-thickness.svg)\n\
         \n\
         - `layered, paper`: the shading model of Granier & Heidrich 2002 as printed, in the mirror direction.\n  \
           Its base is given what Fresnel's equations say at normal incidence. It halves what it adds up, so it\n  \
           is off everywhere: it convinces, it does not predict.\n\
         - `two_beam`: the same interference with exact Fresnel amplitudes and without the half.\n\
         - `airy_rgb`: all beams at three wavelengths, as in Adobe's openpbr-bsdf.\n\
         - `harmonics 3`: Belcour & Barla 2017, as in Cycles.\n\
         - `quadrature`, `bands`, `series`, and films as the plan compiles them for a tolerance: ours.\n\
         \n\
         Below, both axes by their logarithm: what is worst for cut series is thin and grazing.\n\
         \n\
         ![Very thin films at grazing angles](atlas-grazing.svg)\n\
         \n\
         ## Methods over index and extinction\n\
         \n\
         ![Index and extinction of film and base](atlas-index.svg)\n\
         \n\
         ## Methods in single precision\n\
         \n\
         ![float32 against float64](atlas-float32.svg)\n\
         \n"
    );
    out += &what_goes_wrong(films);
    out += &forced(films);
    out += "\n## Shading models\n\n\
            Each model over the parameter that is hardest on it, times the viewer's angle. Single against double\n\
            precision: values and densities over value + pdf + 0.001. Reciprocity: both directions in double\n\
            precision. Energy: by what the albedo exceeds 1. Sampling: a lobe's density times the area that its\n\
            sampler stretches the unit square to, which must be 1. The dark maps of `layered, paper`, of\n\
            `oren_nayar` and `disney_diffuse`, and of `abc` with `schlick` are laws that these models declare\n\
            to break.\n\n\
            ![Diffuse, phong, layered, film, metallic_roughness](atlas-models.svg)\n\n\
            ![microfacet](atlas-microfacet.svg)\n\n";
    out += &laws(models);
    write!(
        out,
        "\n## How much was tried\n\n\
         {} colours by {} methods and settings, {} by the reference; {} values, densities, samples and albedos\n\
         of {} models and choices.\n",
        grouped(films.evaluations),
        films::contenders().len(),
        grouped(films.references),
        grouped(models.evaluations),
        models.swept.len(),
    )
    .unwrap();
    out
}

/// Digits in threes.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let group = |(i, digit): (usize, char)| {
        let is_start = i > 0 && (digits.len() - i).is_multiple_of(3);
        is_start
            .then_some(',')
            .into_iter()
            .chain([digit])
            .collect::<String>()
    };
    digits.chars().enumerate().map(group).collect()
}

/// The greatest of something over all maps of a contender, with the scene.
pub fn worst(
    films: &Films,
    contender: usize,
    what: impl Fn(&Map) -> Found,
) -> Option<(Found, &Scene)> {
    let all = films
        .all()
        .filter(|swept| swept.maps[contender].evaluations > 0);
    let found = all.map(|swept| (what(&swept.maps[contender]), &swept.scene));
    found.max_by(|a, b| a.0.value.total_cmp(&b.0.value))
}

/// The greatest jump of a contender.
fn worst_jump(films: &Films, contender: usize) -> Option<(Found, &Scene)> {
    let found = films
        .all()
        .filter_map(|swept| Some((swept.jumps[contender]?, &swept.scene)));
    found.max_by(|a, b| a.0.value.total_cmp(&b.0.value))
}

/// The greatest difference of precisions of a contender.
pub fn worst_precision(films: &Films, contender: usize) -> Option<(Found, &Scene)> {
    let precisions = films.precisions.iter();
    let found = precisions.filter_map(|p| Some((p.maps[contender].as_ref()?.worst, &p.scene)));
    found.max_by(|a, b| a.0.value.total_cmp(&b.0.value))
}

fn what_goes_wrong(films: &Films) -> String {
    let mut out = String::from(
        "## What goes wrong\n\n\
         The worst of each kind over all maps above. Jumps are differences that do not shrink with the\n\
         distance, found by halving along lines of constant angle and thickness. Inputs that no formula\n\
         expects (0, denormals, negative numbers, infinity, NaN) gave no NaN and no infinity unless a line says so.\n\n\
         | method | what | how much | where | what the library does |\n\
         |---|---|---:|---|---|\n",
    );
    for (i, contender) in films::contenders().into_iter().enumerate() {
        let mut line = |what: &str, found: Option<(Found, &Scene)>, least: f64, answer: &str| {
            let Some((found, scene)) = found.filter(|(found, _)| found.value > least) else {
                return;
            };
            let place = scene.place(found.x, found.cos_theta);
            writeln!(
                out,
                "| {} | {what} | {} | {}; {place} | {answer} |",
                contender.name(),
                number(found.value),
                scene.name
            )
            .unwrap();
        };
        line(
            "error",
            worst(films, i, |map| map.worst),
            0.0,
            answer(contender),
        );
        let clipped = "colours are clipped last";
        let missed = "never chosen unasked; by name only where it holds the tolerance, at critical angles too";
        line(
            "above 1 by",
            worst(films, i, |map| map.above),
            ROUNDING,
            clipped,
        );
        line(
            "below 0 by",
            worst(films, i, |map| map.below),
            ROUNDING,
            clipped,
        );
        line("jump", worst_jump(films, i), SMALL, missed);
        line(
            "float32",
            worst_precision(films, i),
            SMALL,
            answer(contender),
        );
        let bad: usize = films.all().map(|swept| swept.not_finite[i]).sum();
        if bad > 0 {
            let name = contender.name();
            writeln!(
                out,
                "| {name} | NaN or infinite | {bad} colours | hard inputs | |"
            )
            .unwrap();
        }
    }
    out
}

fn answer(contender: Contender) -> &'static str {
    match contender {
        Contender::Layered => "says so; a shading model, which no film uses",
        Contender::Kind(OneLayerMethod::Bands(_)) => {
            "the plan takes as many bands as hold the tolerance"
        }
        Contender::Kind(_) => "never chosen unasked; by name only where it holds the tolerance",
        Contender::Forced(..) | Contender::Planned(_) => "within the tolerance",
    }
}

fn forced(films: &Films) -> String {
    let count = films.thicknesses.len();
    let mut out = format!(
        "\nMethods may be asked for by name. At the default tolerance, {TOLERANCE:e}, in the best of their sizes:\n\n\
         | asked for | refused for | greatest error where not |\n\
         |---|---:|---:|\n"
    );
    for forced in &films.forced {
        let refused = format!("{} of {count} stacks", forced.refused);
        let is_taken = forced.refused < count;
        let worst = if is_taken {
            number(forced.worst)
        } else {
            String::new()
        };
        writeln!(out, "| `{}` | {refused} | {worst} |", forced.method).unwrap();
    }
    out
}

fn laws(models: &Models) -> String {
    let mut out = String::from(
        "The worst of each map. *Declared*: the model's description says so, and the README.\n\n\
         | model | over | float32 | not reciprocal by | albedo above 1 by | sample against pdf |\n\
         |---|---|---:|---:|---:|---:|\n",
    );
    for swept in &models.swept {
        let cell = |law: Law| {
            let map = &swept.maps[law as usize];
            if map.errors.iter().all(Option::is_none) {
                return String::new();
            }
            let found = map.worst;
            let is_declared = match law {
                Law::Reciprocity => swept.declared[0],
                Law::Energy => swept.declared[1],
                Law::Precision | Law::Sampling => false,
            };
            if found.value == 0.0 {
                return "0".into();
            }
            let angle = found.cos_theta.acos().to_degrees();
            let declared = if is_declared { ", declared" } else { "" };
            format!(
                "{} ({:.1e}, {angle:.0} deg{declared})",
                number(found.value),
                found.x
            )
        };
        let cells = Law::ALL.map(cell).join(" | ");
        writeln!(
            out,
            "| {} | {} | {cells} |",
            swept.case.name(),
            swept.case.x.name
        )
        .unwrap();
    }
    out
}
