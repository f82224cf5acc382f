//! Reflectances of a film in lanes, for arrays of arguments.

use super::compiled::{Compiled, Film};
use super::table::{Curve, Table};
use crate::num::{Lane, Level, Work};

/// Elements between whose stages positions wait in the processor's first cache.
const BLOCK: usize = 256;

/// What is looked up, in two stages.
trait Tabulated {
    /// Steps along the table's axes for arguments within their ranges.
    fn position<L: Lane<Scalar = f32>>(&self, cos_theta: L, thickness_nm: L) -> [L; 2];
    /// The colours there.
    fn around<L: Lane<Scalar = f32>>(&self, position: [L; 2]) -> L::Rgb;
}

impl Tabulated for Table {
    #[inline(always)]
    fn position<L: Lane<Scalar = f32>>(&self, cos_theta: L, thickness_nm: L) -> [L; 2] {
        self.position(cos_theta, thickness_nm)
    }
    #[inline(always)]
    fn around<L: Lane<Scalar = f32>>(&self, position: [L; 2]) -> L::Rgb {
        self.around(position)
    }
}

impl Tabulated for Curve {
    #[inline(always)]
    fn position<L: Lane<Scalar = f32>>(&self, cos_theta: L, _thickness_nm: L) -> [L; 2] {
        self.position(cos_theta)
    }
    #[inline(always)]
    fn around<L: Lane<Scalar = f32>>(&self, position: [L; 2]) -> L::Rgb {
        self.around(position)
    }
}

/// [`Film::reflectance_lanes`] of arrays, for a film compiled to `tabulated`.
///
/// A position is a long chain of operations that wait for each other; were it followed by its look-up, a
/// processor would have no room left in which to begin the next one. So all positions of a block are found
/// before its first look-up.
struct Tile<'a, T> {
    film: &'a Film,
    tabulated: &'a T,
    cos_theta: &'a [f32],
    thickness_nm: &'a [f32],
    reflectance: [&'a mut [f32]; 3],
}

impl<T: Tabulated> Work<f32> for Tile<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) {
        let [r, g, b] = self.reflectance;
        let arguments = self
            .cos_theta
            .chunks(BLOCK)
            .zip(self.thickness_nm.chunks(BLOCK));
        let results = r
            .chunks_mut(BLOCK)
            .zip(g.chunks_mut(BLOCK))
            .zip(b.chunks_mut(BLOCK));
        let mut positions = [[0.0; BLOCK]; 2];
        for ((cos_theta, thickness_nm), ((r, g), b)) in arguments.zip(results) {
            find_positions::<L, T>(
                self.film,
                self.tabulated,
                cos_theta,
                thickness_nm,
                &mut positions,
            );
            look_up::<L, T>(
                self.film,
                self.tabulated,
                cos_theta,
                thickness_nm,
                &positions,
                [r, g, b],
            );
        }
    }
}

/// The positions of a block.
#[inline(always)]
fn find_positions<L: Lane<Scalar = f32>, T: Tabulated>(
    film: &Film,
    tabulated: &T,
    cos_theta: &[f32],
    thickness_nm: &[f32],
    [x, y]: &mut [[f32; BLOCK]; 2],
) {
    let arguments = cos_theta
        .chunks_exact(L::COUNT)
        .zip(thickness_nm.chunks_exact(L::COUNT));
    let positions = x
        .chunks_exact_mut(L::COUNT)
        .zip(y.chunks_exact_mut(L::COUNT));
    for ((cos_theta, thickness_nm), (x, y)) in arguments.zip(positions) {
        let [cos_theta, thickness_nm] = film.held_lanes(L::load(cos_theta), L::load(thickness_nm));
        let position = tabulated.position(cos_theta, thickness_nm);
        position[0].store(x);
        position[1].store(y);
    }
}

/// The colours of a block.
#[inline(always)]
fn look_up<L: Lane<Scalar = f32>, T: Tabulated>(
    film: &Film,
    tabulated: &T,
    cos_theta: &[f32],
    thickness_nm: &[f32],
    [x, y]: &[[f32; BLOCK]; 2],
    [r, g, b]: [&mut [f32]; 3],
) {
    let arguments = cos_theta
        .chunks_exact(L::COUNT)
        .zip(thickness_nm.chunks_exact(L::COUNT));
    let positions = x.chunks_exact(L::COUNT).zip(y.chunks_exact(L::COUNT));
    let results = r
        .chunks_exact_mut(L::COUNT)
        .zip(g.chunks_exact_mut(L::COUNT))
        .zip(b.chunks_exact_mut(L::COUNT));
    for (((cos_theta, thickness_nm), (x, y)), ((r, g), b)) in arguments.zip(positions).zip(results)
    {
        let (cos_theta, thickness_nm) = (L::load(cos_theta), L::load(thickness_nm));
        let is_number = cos_theta.equals(cos_theta) & thickness_nm.equals(thickness_nm);
        let rgb = L::channels(tabulated.around([L::load(x), L::load(y)]));
        let rgb = film.finished_lanes(is_number, rgb);
        rgb[0].store(r);
        rgb[1].store(g);
        rgb[2].store(b);
    }
}

impl Film {
    /// [`Film::reflectance`] of arrays, equal bit for bit. All are of one length, a multiple of 16.
    pub(crate) fn reflectance_tile(
        &self,
        level: Level,
        cos_theta: &[f32],
        thickness_nm: &[f32],
        reflectance: [&mut [f32]; 3],
    ) {
        match &self.compiled {
            Compiled::Table(table) if !level.is_scalar() => level.run(Tile {
                film: self,
                tabulated: table,
                cos_theta,
                thickness_nm,
                reflectance,
            }),
            Compiled::Curve(curve) if !level.is_scalar() => level.run(Tile {
                film: self,
                tabulated: curve,
                cos_theta,
                thickness_nm,
                reflectance,
            }),
            _ => {
                let [r, g, b] = reflectance;
                for (i, cos_theta) in cos_theta.iter().enumerate() {
                    [r[i], g[i], b[i]] = self.reflectance(*cos_theta, thickness_nm[i]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::FilmDescription;
    use crate::optics::Medium;

    fn constant(eta: f64, k: f64) -> Medium {
        Medium::rgb([eta; 3], [k; 3]).unwrap()
    }

    /// Every result of a tile is that of a single call, to the bit, with all sets of instructions: at
    /// ordinary arguments, beyond the ranges of both, and where they are no numbers.
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
        let films = [
            ("table", coated([50.0, 700.0])),
            ("table", metal.layer(constant(1.33, 0.0), [0.0, 1000.0])),
            ("curve", coated([300.0; 2])),
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
            let is_expected = match &film.compiled {
                Compiled::Table(_) => what == "table",
                Compiled::Curve(_) => what == "curve",
                _ => what == "bands",
            };
            assert!(is_expected, "{what} is compiled to something else");
            // 704 is no multiple of a block.
            for count in [0, 16, 32, 256, 704] {
                let [cos_theta, thickness_nm] = arguments(count, &odd);
                for level in Level::all() {
                    let mut found = [(); 3].map(|()| vec![-1.0; count]);
                    let [r, g, b] = &mut found;
                    film.reflectance_tile(level, &cos_theta, &thickness_nm, [r, g, b]);
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
