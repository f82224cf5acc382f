//! Reflectances of a film for arrays of arguments.

use super::colors::has_nan;
use super::evaluator::Evaluator;
use super::film::{Film, one_by_one};
use super::table::critical_axis::Cosine;
use super::table::lane_table::LaneTable;
use crate::num::{ColumnsMut, Lane, Level, Work};

/// Positions of this number of elements wait in the processor's first cache.
const BLOCK: usize = 256;

/// [`Film::reflectance_lanes`] of arrays, for a film whose table on the ambient's side is one spline.
///
/// The operations that find a position depend on each other. If each were followed by its look-up, a
/// processor's window would have no room left to begin the next position meanwhile. So all positions of
/// a block are found before its first look-up.
struct TileLookUp<'a, 'b> {
    film: &'a Film,
    table: LaneTable<'a>,
    cos_theta: &'a [f32],
    thickness_nm: &'a [f32],
    reflectance: &'a mut ColumnsMut<'b, f32>,
}

impl Work<f32> for TileLookUp<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) {
        let Self { film, table, .. } = self;
        let inputs = self
            .cos_theta
            .chunks(BLOCK)
            .zip(self.thickness_nm.chunks(BLOCK));
        let mut positions = [[0.0; BLOCK]; 2];
        let mut first = 0;
        for (cos_theta, thickness_nm) in inputs {
            let inputs = [cos_theta, thickness_nm];
            find_positions::<L>(film, table, inputs, &mut positions);
            look_up::<L>(film, table, inputs, &positions, first, self.reflectance);
            first += BLOCK;
        }
    }
}

/// The positions of a block; those along the thickness only if the table has it.
#[inline(always)]
fn find_positions<L: Lane<Scalar = f32>>(
    film: &Film,
    table: LaneTable<'_>,
    [cos_theta, thickness_nm]: [&[f32]; 2],
    [x, y]: &mut [[f32; BLOCK]; 2],
) {
    let inputs = cos_theta
        .chunks_exact(L::COUNT)
        .zip(thickness_nm.chunks_exact(L::COUNT));
    let positions = x
        .chunks_exact_mut(L::COUNT)
        .zip(y.chunks_exact_mut(L::COUNT));
    for ((cos_theta, thickness_nm), (x, y)) in inputs.zip(positions) {
        let [cos_theta, thickness_nm] =
            film.clamp_inputs([L::load(cos_theta), L::load(thickness_nm)]);
        let [along_x, along_y, _] =
            L::channels(table.position(Cosine::from(cos_theta), thickness_nm));
        along_x.store(x);
        if !table.spline().is_over_cosine() {
            along_y.store(y);
        }
    }
}

/// The colours of a block.
#[inline(always)]
fn look_up<L: Lane<Scalar = f32>>(
    film: &Film,
    table: LaneTable<'_>,
    [cos_theta, thickness_nm]: [&[f32]; 2],
    [x, y]: &[[f32; BLOCK]; 2],
    first: usize,
    reflectance: &mut ColumnsMut<f32>,
) {
    let inputs = cos_theta
        .chunks_exact(L::COUNT)
        .zip(thickness_nm.chunks_exact(L::COUNT));
    let positions = x.chunks_exact(L::COUNT).zip(y.chunks_exact(L::COUNT));
    let mut element = first;
    for ((cos_theta, thickness_nm), (x, y)) in inputs.zip(positions) {
        let inputs = [L::load(cos_theta), L::load(thickness_nm)];
        let rgb = if has_nan(inputs) {
            one_by_one(inputs, |c, d| film.reflectance_or_zero(c, d))
        } else {
            let y = L::load(y);
            let rgb = table.spline().around::<L>(L::rgb([L::load(x), y, y]));
            L::channels(film.clip::<L>(rgb))
        };
        reflectance.store(element, rgb);
        element += L::COUNT;
    }
}

impl Film {
    /// [`Film::reflectance`] of arrays, with exactly the bits of single calls. All arrays have the same
    /// length, a multiple of 16.
    pub(crate) fn reflectance_tile(
        &self,
        level: Level,
        cos_theta: &[f32],
        thickness_nm: &[f32],
        reflectance: &mut ColumnsMut<f32>,
    ) {
        let table = match &self.evaluator {
            Evaluator::Tables(tables) if !level.is_scalar() => tables.in_lanes(),
            _ => None,
        };
        if let Some(table) = table {
            level.run(TileLookUp {
                film: self,
                table,
                cos_theta,
                thickness_nm,
                reflectance,
            });
            return;
        }
        for (i, cos_theta) in cos_theta.iter().enumerate() {
            reflectance.store(i, self.reflectance(*cos_theta, thickness_nm[i]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::description::FilmDescription;
    use crate::optics::Medium;

    fn constant(eta: f64, k: f64) -> Medium {
        Medium::rgb([eta; 3], [k; 3]).unwrap()
    }

    /// A tile gives exactly the bits of single calls, with all sets of instructions: at ordinary arguments,
    /// beyond the ranges of both, and where they are NaN.
    #[test]
    fn equal_to_single_calls() {
        let glass = || FilmDescription::new(constant(1.5, 0.0));
        let coated = |range| glass().layer(constant(1.38, 0.0), range);
        let bands = FilmDescription {
            method: Some("bands".into()),
            tolerance: 2e-2,
            ..coated([50.0, 700.0])
        };
        let metal = FilmDescription::new(constant(1.5, 3.0));
        let from_glass = FilmDescription {
            ambient: constant(1.5, 0.0),
            ..FilmDescription::new(constant(1.0, 0.0))
        };
        let window = FilmDescription {
            transmittance: true,
            ..coated([50.0, 700.0])
        };
        let named = |name: &str| Medium::named(name).unwrap();
        let from_bk7 = FilmDescription {
            ambient: named("BK7"),
            ..FilmDescription::new(Medium::vacuum())
        };
        let films = [
            ("table", coated([50.0, 700.0])),
            ("table", metal.layer(constant(1.33, 0.0), [0.0, 1000.0])),
            ("table", window),
            ("table over the cosine", coated([300.0; 2])),
            (
                "table from glass",
                from_glass.layer(constant(1.38, 0.0), [50.0, 700.0]),
            ),
            (
                "table over critical angles",
                from_bk7.clone().layer(named("MgF2"), [0.0, 300.0]),
            ),
            (
                "table over critical angles",
                from_bk7.layer(named("MgF2"), [100.0; 2]),
            ),
            ("bands", bands),
        ];
        let odd = [
            f32::NAN,
            f32::INFINITY,
            f32::NEG_INFINITY,
            -1.0,
            -0.0,
            0.0,
            1e-30,
            1e-9,
            1.0,
            1.000_001,
            1e30,
            49.9,
            700.1,
        ];
        for (what, description) in films {
            let film = Film::new(&description).unwrap();
            let is_expected = match &film.evaluator {
                Evaluator::Tables(tables) => match tables.over_ambient_cosine() {
                    Some(table) if table.is_over_cosine() => what == "table over the cosine",
                    Some(_) => what == "table",
                    None if tables.in_lanes().is_some() => what == "table over critical angles",
                    None => what == "table from glass",
                },
                _ => what == "bands",
            };
            assert!(is_expected, "{what} is compiled to something else");
            // 704 is no multiple of a block's length.
            for count in [0, 16, 32, 256, 704] {
                let [cos_theta, thickness_nm] = arguments(count, &odd);
                for level in Level::all() {
                    let mut room = vec![-1.0; 3 * count];
                    let mut columns = ColumnsMut::of_slice(&mut room);
                    film.reflectance_tile(level, &cos_theta, &thickness_nm, &mut columns);
                    let found: Vec<&[f32]> = room.chunks(count.max(1)).collect();
                    for i in 0..count {
                        let single = film.reflectance(cos_theta[i], thickness_nm[i]);
                        let found = [found[0][i], found[1][i], found[2][i]];
                        assert_eq!(
                            found.map(f32::to_bits),
                            single.map(f32::to_bits),
                            "{what}, {}, {i} of {count}: {} at {} nm",
                            level.name(),
                            cos_theta[i],
                            thickness_nm[i]
                        );
                    }
                }
            }
        }
    }

    /// Cosines and thicknesses; every third pair has one or two odd numbers.
    fn arguments(count: usize, odd: &[f32]) -> [Vec<f32>; 2] {
        // Fractions of multiples of the golden ratio and of sqrt(2) fill the unit square evenly.
        let spread = |i: usize, by: f32| (i as f32 * by).fract();
        let cosine = |i: usize| match i % 9 {
            3 | 6 => odd[i / 9 % odd.len()],
            _ => spread(i, 0.618_034),
        };
        let thickness = |i: usize| match i % 9 {
            0 | 6 => odd[i / 7 % odd.len()],
            _ => 1100.0 * spread(i, 0.414_214),
        };
        [
            (0..count).map(cosine).collect(),
            (0..count).map(thickness).collect(),
        ]
    }
}
