//! docs/chart.svg: a large panel, four small ones, and what the markers mean.

use super::contest::{Cell, Summary, constant, shared, summaries};
use super::glass;
use super::suite::{RANGES, Range};
use crate::shared::peer::{Peer, size};
use crate::shared::svg::{
    Area, FONT, Failure, Panel, Pixel, beside, diamond, line, picture, style, width,
};
use pellicle::film::OneLayerMethod as Kind;
use pellicle::num::Level;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const SIZE: (u32, u32) = (1000, 990);
/// The left edges of the legend's columns, and its first line.
const COLUMNS: [i32; 3] = [26, 310, 720];
const LEGEND_TOP: i32 = 92;
const LEGEND_LINE: i32 = 21;

const TITLE: &str = "Colour of a thin film: time against error";
const EXPLANATION: [&str; 2] = [
    "Marker: RMS error of linear RGB in [0, 1], and ns per colour on one core, one call at a time, \
     median of the films.",
    "Whiskers: greatest error, slowest film. Random thicknesses, and angles down to grazing. \
     The grey line joins those that none beats in both.",
];

const GLASS_SIZE: (u32, u32) = (1000, 905);
const GLASS_TITLE: &str =
    "Films on glass, reflected and transmitted: time against error from both sides";
const GLASS_EXPLANATION: [&str; 2] = [
    "Marker: RMS error of reflectance and transmittance, and ns of a call for both, median of the stacks. Whiskers: the \
     greatest, the slowest.",
    "Methods for one layer take no coats of more; for the base's side they are turned round, and they let through what \
     they do not reflect.",
];

/// The ends of the error axis, and where a peer without error is drawn.
const ERRORS: [f64; 2] = [1e-6, 1.0];
const FLOOR: f64 = 1.5e-6;
/// Half the width of a marker.
const RADIUS: i32 = 5;

/// Peers that differ only in their setting have a shape and a colour in common. The shape alone is enough in grey
/// print.
#[derive(Clone, Copy, PartialEq)]
enum Family {
    TwoBeam,
    AiryRgb,
    Quadrature,
    Bands,
    Harmonics,
    Planned,
    Reference,
}

impl Family {
    const ALL: [Self; 7] = [
        Self::TwoBeam,
        Self::AiryRgb,
        Self::Quadrature,
        Self::Bands,
        Self::Harmonics,
        Self::Planned,
        Self::Reference,
    ];

    fn of(peer: Peer) -> Self {
        match peer {
            Peer::Method(Kind::TwoBeam) => Self::TwoBeam,
            Peer::Method(Kind::AiryRgb) => Self::AiryRgb,
            Peer::Method(Kind::Quadrature(_)) => Self::Quadrature,
            Peer::Method(Kind::Bands(_)) => Self::Bands,
            Peer::Method(Kind::Harmonics(_)) => Self::Harmonics,
            Peer::Planned(_) => Self::Planned,
            _ => Self::Reference,
        }
    }

    /// In words, with the source; its colour; and where its labels stand.
    fn look(self) -> (&'static str, RGBColor, (Pixel, HPos, VPos)) {
        let right = ((9, 0), HPos::Left, VPos::Center);
        let left = ((-9, 0), HPos::Right, VPos::Center);
        let above = ((4, -4), HPos::Left, VPos::Bottom);
        match self {
            Self::TwoBeam => (
                "two beams (Granier & Heidrich 2002)",
                RGBColor(0, 0, 0),
                ((-9, -3), HPos::Right, VPos::Bottom),
            ),
            Self::AiryRgb => ("all beams at 3 wavelengths", RGBColor(90, 90, 90), left),
            Self::Quadrature => {
                let below = ((-5, 6), HPos::Right, VPos::Top);
                ("all beams at N wavelengths", RGBColor(0, 114, 178), below)
            }
            Self::Bands => {
                let below = ((6, 4), HPos::Left, VPos::Top);
                (
                    "all beams over K bands (ours)",
                    RGBColor(0, 140, 100),
                    below,
                )
            }
            Self::Harmonics => (
                "harmonics, 1 to 5 terms (Belcour & Barla 2017)",
                RGBColor(190, 70, 0),
                above,
            ),
            Self::Planned => (
                "planned film (ours), by its tolerance",
                RGBColor(190, 20, 120),
                right,
            ),
            Self::Reference => (
                "reference: error 0, drawn at the floor",
                RGBColor(0, 0, 0),
                right,
            ),
        }
    }

    fn color(self) -> RGBColor {
        self.look().1
    }

    fn draw(self, area: &Area, (x, y): Pixel) -> Result<(), Failure> {
        let (r, color) = (RADIUS, self.color());
        let stroke = |points: Vec<Pixel>| line(area, points, color.stroke_width(2));
        let fill = |points: Vec<Pixel>| area.draw(&Polygon::new(points, color.filled()));
        match self {
            Self::TwoBeam => {
                stroke(vec![(x - r, y - r), (x + r, y + r)])?;
                stroke(vec![(x - r, y + r), (x + r, y - r)])
            }
            Self::AiryRgb => {
                stroke(vec![(x - r - 1, y), (x + r + 1, y)])?;
                stroke(vec![(x, y - r - 1), (x, y + r + 1)])
            }
            Self::Quadrature => {
                let corners = [(x, y - r - 1), (x + r, y + r - 1), (x - r, y + r - 1)];
                area.draw(&Polygon::new(corners.to_vec(), WHITE.filled()))?;
                stroke(corners.iter().chain(&corners[..2]).copied().collect())
            }
            Self::Bands => area.draw(&Rectangle::new(
                [(x - r + 1, y - r + 1), (x + r - 1, y + r - 1)],
                color.filled(),
            )),
            Self::Harmonics => area.draw(&Circle::new((x, y), r, color.filled())),
            Self::Planned => fill(diamond((x, y), r + 2)),
            Self::Reference => fill(star(x, y)),
        }
    }
}

/// A star with five points.
fn star(x: i32, y: i32) -> Vec<Pixel> {
    let corner = |i: i32| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::PI / 5.0).sin_cos();
        let radius = if i % 2 == 0 { 9.0 } else { 3.8 };
        (
            x + (radius * sin).round() as i32,
            y - (radius * cos).round() as i32,
        )
    };
    (0..10).map(corner).collect()
}

/// Draws the marker of a batch at a level of instructions. It is smaller for wider lanes, so that levels that are
/// equally fast show inside one another.
fn draw_level(area: &Area, level: Level, at: Pixel) -> Result<(), Failure> {
    let color = Family::Planned.color();
    match level.name() {
        "avx512" => area.draw(&Polygon::new(diamond(at, 3), color.filled())),
        "avx2" => line(area, diamond(at, 6), color),
        _ => line(area, diamond(at, 9), color),
    }
}

/// The chart as SVG.
pub fn svg(cells: &[Cell]) -> Result<String, Failure> {
    let [thin, common, thick, thickest] = RANGES;
    let titled = |summaries, range: Range, films| (summaries, format!("{}, {films}", range.name));
    let of_ten = |range| titled(summaries(shared(cells, range)), range, "ten films");
    let constant = titled(summaries(constant(cells, common)), common, "no dispersion");
    picture(SIZE, TITLE, &EXPLANATION, |area| {
        legend(area, true)?;
        panel(area, &of_ten(common), [52, 182, 933, 436], 1e5, true)?;
        let small = [of_ten(thin), of_ten(thick), of_ten(thickest), constant];
        for (i, contents) in small.iter().enumerate() {
            let frame = [52 + 237 * i as i32, 690, 222, 260];
            panel(area, contents, frame, 1e7, false)?;
        }
        Ok(())
    })
}

/// Both sides of films on glass as SVG: of one layer above, of more below.
pub fn glass_svg(cells: &[glass::Cell]) -> Result<String, Failure> {
    picture(GLASS_SIZE, GLASS_TITLE, &GLASS_EXPLANATION, |area| {
        legend(area, false)?;
        for (row, (of, title, most)) in [
            (true, "one layer, six stacks", 9e5),
            (false, "coats of 2, 3 and 10 layers", 9e5),
        ]
        .into_iter()
        .enumerate()
        {
            for (side, from) in ["from the ambient", "from the base"]
                .into_iter()
                .enumerate()
            {
                let summaries = glass::summaries(cells, side, |cell| (cell.layers == 1) == of);
                // Habits have no time, and the series is a truth of its own.
                let is_drawn =
                    |s: &Summary| s.ns.is_finite() && !matches!(s.peer, Peer::Forced(..));
                let contents = (
                    summaries.into_iter().filter(is_drawn).collect(),
                    format!("{title}, {from}"),
                );
                let frame = [52 + 477 * side as i32, 182 + 370 * row as i32, 456, 310];
                panel(area, &contents, frame, most, true)?;
            }
        }
        Ok(())
    })
}

fn legend(area: &Area, has_batches: bool) -> Result<(), Failure> {
    let place = |i: usize| (COLUMNS[i / 3], LEGEND_TOP + LEGEND_LINE * (i % 3) as i32);
    for (i, family) in Family::ALL.into_iter().enumerate() {
        let at = place(i);
        family.draw(area, at)?;
        beside(area, family.look().0, (at.0 + 13, at.1))?;
    }
    if !has_batches {
        return Ok(());
    }
    let (mut x, y) = place(Family::ALL.len());
    const IN_BATCHES: &str = "in batches:";
    beside(area, IN_BATCHES, (x - 5, y))?;
    x += width(IN_BATCHES) + 8;
    for level in Level::all() {
        draw_level(area, level, (x, y))?;
        beside(area, level.name(), (x + 12, y))?;
        x += width(level.name()) + 28;
    }
    Ok(())
}

/// Every peer's time and error. All have labels in the large panel, in small ones the planned films alone.
fn panel(
    area: &Area,
    (summaries, title): &(Vec<Summary>, String),
    frame: [i32; 4],
    slowest_ns: f64,
    is_large: bool,
) -> Result<(), Failure> {
    let panel = Panel {
        title,
        frame,
        errors: ERRORS,
        has_error_labels: is_large || frame[0] == 52,
    };
    let labels = if is_large { 10 } else { 4 };
    let times = (2.0..slowest_ns).log_scale();
    let at = panel.axes(area, times, labels, &|ns| duration(*ns))?;
    let place = |summary: &Summary| at(summary.ns, summary.errors.rms().max(FLOOR));

    let front = front(summaries).into_iter().map(place).collect();
    line(area, front, RGBColor(205, 205, 205).stroke_width(7))?;
    for family in Family::ALL {
        let own = summaries.iter().filter(|s| Family::of(s.peer) == family);
        line(
            area,
            own.map(place).collect(),
            family.color().mix(0.6).stroke_width(1),
        )?;
    }
    for summary in summaries {
        let ((x, y), color) = (place(summary), Family::of(summary.peer).color().mix(0.45));
        let (right, top) = at(summary.slowest_ns, summary.errors.max().max(FLOOR));
        if top < y {
            line(area, vec![(x, y), (x, top)], color)?;
            line(area, vec![(x - 3, top), (x + 3, top)], color)?;
        }
        if right > x + RADIUS {
            line(area, vec![(x, y), (right, y)], color)?;
            line(area, vec![(right, y - 3), (right, y + 3)], color)?;
        }
    }
    for summary in summaries {
        for (level, ns) in Level::all().into_iter().zip(&summary.batch_ns) {
            draw_level(area, level, (at(*ns, 1.0).0, place(summary).1))?;
        }
    }
    for summary in summaries {
        let (place, family) = (place(summary), Family::of(summary.peer));
        family.draw(area, place)?;
        if is_large || family == Family::Planned {
            let (_, color, ((dx, dy), horizontal, vertical)) = family.look();
            let style = style(FONT, color, horizontal, vertical);
            area.draw_text(&label(summary.peer), &style, (place.0 + dx, place.1 + dy))?;
        }
    }
    Ok(())
}

/// The text beside a marker.
fn label(peer: Peer) -> String {
    match peer {
        Peer::Method(Kind::TwoBeam) => "two beams".into(),
        Peer::Method(Kind::AiryRgb) => "3 wavelengths".into(),
        Peer::Method(kind @ Kind::Quadrature(_)) => format!("N={}", size(kind)),
        Peer::Method(kind @ Kind::Bands(_)) => format!("K={}", size(kind)),
        _ => peer.setting(),
    }
}

fn duration(ns: f64) -> String {
    match ns {
        1e6.. => format!("{} ms", ns / 1e6),
        1e3.. => format!("{} us", ns / 1e3),
        _ => format!("{ns} ns"),
    }
}

/// The Pareto front: the peers that no other beats in both time and error, quickest first.
fn front(summaries: &[Summary]) -> Vec<&Summary> {
    let mut order: Vec<&Summary> = summaries.iter().collect();
    order.sort_by(|a, b| {
        a.ns.total_cmp(&b.ns)
            .then(a.errors.rms().total_cmp(&b.errors.rms()))
    });
    let mut least = f64::INFINITY;
    order.retain(|summary| {
        let is_better = summary.errors.rms() < least;
        least = least.min(summary.errors.rms());
        is_better
    });
    order
}

#[test]
fn the_front_keeps_whom_nobody_beats() {
    let summary = |[ns, error]: [f32; 2]| {
        let mut errors = super::errors::Errors::default();
        errors.add([error; 3], [0.0; 3]);
        let (peer, ns) = (Peer::Reference, f64::from(ns));
        let (batch_ns, notes) = (Vec::new(), Vec::new());
        Summary {
            peer,
            errors,
            ns,
            slowest_ns: ns,
            batch_ns,
            notes,
        }
    };
    let points = [[3.0, 0.1], [1.0, 0.3], [2.0, 0.4], [2.5, 0.2], [3.0, 0.2]];
    let summaries = points.map(summary);
    let times: Vec<f64> = front(&summaries).iter().map(|s| s.ns).collect();
    assert_eq!(times, [1.0, 2.5, 3.0]);
}
