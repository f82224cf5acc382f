//! docs/atlas.md.

use super::films::{Films, PEERS, TOLERANCE, Worst};
use super::models::Models;
use super::{CELLS, number};
use crate::error_maps::map::Map;
use crate::error_maps::scene::POINTS_PER_SIDE;
use crate::shared::markdown::table;
use crate::shared::peer::Peer;
use pellicle::film::OneLayerMethod as Kind;

/// Less than this above 1, or below 0, is rounding.
const ROUNDING: f64 = 1e-5;
/// Jumps that cannot be seen, and differences of precision that do not matter, are left out.
const SMALL: f64 = 1e-4;

/// The page.
pub fn page(films: &Films, models: &Models) -> String {
    let points = CELLS * POINTS_PER_SIDE;
    let maps = films.all().flat_map(|swept| &swept.maps);
    let precisions = films
        .precisions
        .iter()
        .flat_map(|p| p.maps.iter().flatten());
    let colors: usize = maps
        .chain(precisions)
        .map(|map: &Map| map.evaluations)
        .sum();
    format!(
        "# Atlas of errors\n\
         \n\
         Where every interference method and every shading model fails, and how badly. `./x atlas` writes\n\
         this page, its pictures and [accuracy.md](accuracy.md), which has the figures by method and model.\n\
         A test (`studies/src/error_maps/tests.rs`) crosses the maps with the plan: it never chooses a method\n\
         where its map shows an error beyond the tolerance.\n\
         \n\
         **How to read the maps.** A cell is the greatest error at four points; each map has {points} by {points}\n\
         points. One scale for all, each step darker by a factor of ten; the black line is the contour at\n\
         {TOLERANCE:e}, the default tolerance. Hatched: refused, or nothing to compare. Errors are those of a\n\
         channel of linear RGB (Rec.709, white E) clipped to [0, 1], in single precision, against the\n\
         converged reference.\n\
         \n\
         ## Methods over thickness and angle\n\
         \n\
         ![Ten methods on twelve stacks](atlas-thickness.svg)\n\
         \n\
         - `layered, paper`: the shading model of Granier & Heidrich 2002 as printed, in the mirror direction.\n  \
           Its base gets what Fresnel's equations say at normal incidence. It halves the sum of its beams, so\n  \
           it is off everywhere: its colours convince, but predict nothing.\n\
         - `two_beam`: the same interference with exact Fresnel amplitudes and without the half.\n\
         - `airy_rgb`: all beams at three wavelengths, as in Adobe's openpbr-bsdf.\n\
         - `harmonics`: Belcour & Barla 2017, 3 as in Cycles.\n\
         - `quadrature`, `bands`, `series`, and films as the plan compiles them for a tolerance: ours.\n\
         - The tables have two habits of Cycles besides, each applied to the truth, which shows the error of the\n  \
           habit alone: a film whose upper interface reflects totally is a mirror; films fade below 1 nm.\n\
         \n\
         Below, both axes are logarithmic: thin films at grazing angles are worst for cut series.\n\
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
         \n\
         ## What goes wrong\n\
         \n\
         The worst of each kind over all maps above. Jumps are differences that do not shrink with the\n\
         distance, found by halving along lines of constant angle and thickness. Inputs that no formula\n\
         expects (0, denormals, negative numbers, infinity, NaN) gave neither NaN nor infinity unless a line\n\
         says so.\n\
         \n\
         {}\n\
         Methods may be asked for by name. At the default tolerance, {TOLERANCE:e}, in the best of their sizes:\n\
         \n\
         {}\n\
         ## Two habits of Cycles\n\
         \n\
         Each is the truth, but for the habit: R = 1 where the film's upper interface reflects totally (no light\n\
         tunnels to the base), and the film's index fades to the ambient's below 1 nm. Maps where neither\n\
         changes anything by more than {SMALL:e} are left out.\n\
         \n\
         {}\n\
         ## Shading models\n\
         \n\
         Each model over the parameter that is hardest on it, times the viewer's angle. Single against double\n\
         precision: values and densities over value + pdf + 0.001. Reciprocity: both directions in double\n\
         precision. Energy: the excess of the albedo over 1. Sampling: a lobe's density times the area to which\n\
         its sampler stretches the unit square; the product must be 1. The dark maps of `layered, paper`, of\n\
         `oren_nayar` and `disney_diffuse`, and of `abc` with `schlick` are laws that these models declare\n\
         to break.\n\
         \n\
         ![Diffuse, phong, layered, film, metallic_roughness](atlas-models.svg)\n\
         \n\
         ![microfacet](atlas-microfacet.svg)\n\
         \n\
         {} colours by {} methods and settings were compared, and {} values, densities, samples and albedos of\n\
         {} models and choices.\n",
        what_goes_wrong(films),
        forced(films),
        habits(films),
        grouped(colors),
        PEERS.len(),
        grouped(models.evaluations),
        models.swept.len(),
    )
}

/// Digits in threes.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let groups = digits.as_bytes().rchunks(3).rev();
    let groups: Vec<String> = groups
        .map(|group| String::from_utf8_lossy(group).into())
        .collect();
    groups.join(",")
}

fn what_goes_wrong(films: &Films) -> String {
    let mut rows = Vec::new();
    for (i, peer) in PEERS.into_iter().enumerate() {
        let mut line = |what: &str, found: Worst, least: f64, answer: &str| {
            if let Some((found, scene)) = found.filter(|(found, _)| found.value > least) {
                let place = format!("{}; {}", scene.name, scene.place(found.x, found.cos_theta));
                rows.push(
                    [
                        peer.title(),
                        what.into(),
                        number(found.value),
                        place,
                        answer.into(),
                    ]
                    .into(),
                );
            }
        };
        let clipped = "colours are clipped last";
        let missed = "never chosen unasked; by name only where it holds the tolerance, at critical angles too";
        line("error", films.worst(i, |map| map.worst), 0.0, answer(peer));
        line(
            "above 1 by",
            films.worst(i, |map| map.above),
            ROUNDING,
            clipped,
        );
        line(
            "below 0 by",
            films.worst(i, |map| map.below),
            ROUNDING,
            clipped,
        );
        line("jump", films.worst_jump(i), SMALL, missed);
        line("float32", films.worst_precision(i), SMALL, answer(peer));
        let bad: usize = films.all().map(|swept| swept.not_finite[i]).sum();
        if bad > 0 {
            let (what, many) = ("NaN or infinite".into(), format!("{bad} colours"));
            rows.push(
                [
                    peer.title(),
                    what,
                    many,
                    "hard inputs".into(),
                    String::new(),
                ]
                .into(),
            );
        }
    }
    let headings = "method | what | >how much | where | what the library does";
    table(headings, rows as Vec<Vec<String>>)
}

fn answer(peer: Peer) -> &'static str {
    match peer {
        Peer::Layered => "says so; a shading model, which no film uses",
        Peer::Method(Kind::Bands(_)) => "the plan takes enough bands for the tolerance",
        Peer::Habit(_) => "lets light tunnel, and keeps the film down to 0 nm",
        Peer::Method(_) => "never chosen unasked; by name only where it holds the tolerance",
        _ => "within the tolerance",
    }
}

fn forced(films: &Films) -> String {
    let count = films.thicknesses.len();
    let rows = films.forced.iter().map(|forced| {
        let is_taken = forced.refused < count;
        let worst = if is_taken {
            number(forced.worst)
        } else {
            String::new()
        };
        let refused = format!("{} of {count} stacks", forced.refused);
        vec![format!("`{}`", forced.method), refused, worst]
    });
    table("asked for | >refused for | >greatest error where not", rows)
}

/// Of both habits, the maps that they change.
fn habits(films: &Films) -> String {
    let habits = PEERS
        .into_iter()
        .enumerate()
        .filter(|(_, peer)| matches!(peer, Peer::Habit(_)));
    let rows = habits.flat_map(|(i, peer)| {
        let changed = films
            .all()
            .filter(move |swept| swept.maps[i].worst.value > SMALL);
        changed.map(move |swept| {
            let (map, scene) = (&swept.maps[i], &swept.scene);
            let beyond = 100.0 * (1.0 - map.share_within(TOLERANCE));
            vec![
                peer.title(),
                scene.name.into(),
                number(map.rms),
                number(map.worst.value),
                scene.place(map.worst.x, map.worst.cos_theta),
                format!("{beyond:.1} %"),
            ]
        })
    });
    let headings =
        format!("habit | map | >RMS | >greatest | where | >of the map beyond {TOLERANCE:e}");
    table(&headings, rows)
}

#[test]
fn digits_are_grouped() {
    assert_eq!(
        [0, 999, 1000, 1_234_567].map(grouped),
        ["0", "999", "1,000", "1,234,567"]
    );
}
