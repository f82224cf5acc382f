//! The complex index of a medium as a function of wavelength.

use super::color::VISIBLE_NM;
use super::media::NamedMedium;
use super::{Complex, RGB_WAVELENGTHS_NM};
use crate::error::Error;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
use crate::num::{F64x4, Real};

/// The range of eta that a caller may give. The least value is far below that of any metal and keeps the
/// permittivity away from 0, where p-polarised fields are unbounded.
const ETA_RANGE: [f64; 2] = [1e-3, 1e3];
/// The range of k that a caller may give.
const K_RANGE: [f64; 2] = [0.0, 1e3];
/// The range of eta of an ambient medium.
const AMBIENT_ETA_RANGE: [f64; 2] = [1.0, 1e3];

/// A homogeneous medium with the complex index eta + i k, k >= 0, relative to vacuum.
#[derive(Clone, Debug)]
pub struct Medium(Kind);

#[derive(Clone, Debug)]
enum Kind {
    Named(&'static NamedMedium),
    /// The indices at [`RGB_WAVELENGTHS_NM`].
    Rgb([Complex<f64>; 3]),
    Table {
        lambda_nm: Box<[f64]>,
        index: Box<[Complex<f64>]>,
    },
}

/// How a saved medium begins, by its kind.
const NAMED: u8 = 0;
const RGB: u8 = 1;
const TABLE: u8 = 2;

impl Medium {
    /// Vacuum: eta = 1, k = 0.
    pub fn vacuum() -> Self {
        Self(Kind::Rgb([Complex::real(1.0); 3]))
    }

    /// The medium of that name or alias, such as "Au" or "gold"; upper and lower case are alike.
    /// [`NamedMedium::all`] lists the media and the sources of their data.
    pub fn named(name: &str) -> Result<Self, Error> {
        let names = || {
            NamedMedium::all()
                .iter()
                .flat_map(|m| std::iter::once(m.name).chain(m.aliases.iter().copied()))
        };
        NamedMedium::find(name)
            .map(|named| Self(Kind::Named(named)))
            .ok_or_else(|| Error::unknown("medium", name, names()))
    }

    /// A medium given by eta in [1e-3, 1e3] and k in [0, 1e3] at 645, 525 and 445 nm.
    ///
    /// Between these wavelengths the index is linear in 1 / lambda^2, the first two terms of Cauchy's
    /// formula; outside it is constant.
    pub fn rgb(eta: [f64; 3], k: [f64; 3]) -> Result<Self, Error> {
        check("eta", &eta, ETA_RANGE)?;
        check("k", &k, K_RANGE)?;
        Ok(Self(Kind::Rgb(std::array::from_fn(|c| {
            Complex::new(eta[c], k[c])
        }))))
    }

    /// A medium given by eta and k, in the ranges of [`Medium::rgb`], at ascending wavelengths in [1, 1e6]
    /// nm. Between these wavelengths the index is linear; outside it is constant.
    pub fn table(lambda_nm: &[f64], eta: &[f64], k: &[f64]) -> Result<Self, Error> {
        let (count, counts) = (lambda_nm.len(), [eta.len(), k.len()]);
        if count == 0 || counts != [count; 2] {
            return Err(Error::invalid(format!(
                "a table of measured indices needs equally many table_nm, table_eta and table_k, \
                 at least 1, not {count}, {} and {}",
                counts[0], counts[1]
            )));
        }
        check("table_nm", lambda_nm, [1.0, 1e6])?;
        check("table_eta", eta, ETA_RANGE)?;
        check("table_k", k, K_RANGE)?;
        if let Some(at) = lambda_nm.windows(2).position(|pair| pair[0] >= pair[1]) {
            return Err(Error::out_of_range(format!(
                "table_nm[{}] = {} does not ascend from {}",
                at + 1,
                lambda_nm[at + 1],
                lambda_nm[at]
            )));
        }
        let index = eta
            .iter()
            .zip(k)
            .map(|(&eta, &k)| Complex::new(eta, k))
            .collect();
        Ok(Self(Kind::Table {
            lambda_nm: lambda_nm.into(),
            index,
        }))
    }

    /// The complex index at a vacuum wavelength, nm.
    pub fn index(&self, wavelength_nm: f64) -> Complex<f64> {
        self.index_with(wavelength_nm, |lambda_nm, index| {
            look_up(lambda_nm, index, wavelength_nm)
        })
    }

    /// The complex index at a vacuum wavelength (nm) in each lane: formulas are evaluated in all lanes at once.
    #[inline(always)]
    pub(crate) fn index_lanes(&self, wavelength_nm: F64x4) -> Complex<F64x4> {
        self.index_with(
            wavelength_nm,
            #[inline(always)]
            |lambda_nm: &[f64], index: &[Complex<f64>]| {
                let nm = wavelength_nm.to_array();
                let [mut re, mut im] = [[0.0; F64x4::COUNT]; 2];
                for lane in 0..F64x4::COUNT {
                    let found = look_up(lambda_nm, index, nm[lane]);
                    (re[lane], im[lane]) = (found.re, found.im);
                }
                Complex::new(
                    F64x4::from_fn(|lane| re[lane]),
                    F64x4::from_fn(|lane| im[lane]),
                )
            },
        )
    }

    #[inline(always)]
    fn index_with<T: Real>(
        &self,
        wavelength_nm: T,
        look_up: impl FnOnce(&[f64], &[Complex<f64>]) -> Complex<T>,
    ) -> Complex<T> {
        match &self.0 {
            Kind::Named(named) => named.index(wavelength_nm),
            Kind::Rgb([a, b, c]) if a == b && b == c => constant(*a),
            Kind::Rgb([a, b, c]) => {
                let of = |number: fn(&Complex<f64>) -> f64| [a, b, c].map(|n| T::new(number(n)));
                Complex::new(
                    index_between(of(|n| n.re), wavelength_nm),
                    index_between(of(|n| n.im), wavelength_nm),
                )
            }
            Kind::Table { lambda_nm, index } => look_up(lambda_nm, index),
        }
    }

    /// Whether both media have the same indices, because they are given by the same name or the same numbers.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Kind::Named(one), Kind::Named(other)) => std::ptr::eq(*one, *other),
            (Kind::Rgb(one), Kind::Rgb(other)) => one == other,
            (
                Kind::Table { lambda_nm, index },
                Kind::Table {
                    lambda_nm: other_nm,
                    index: other,
                },
            ) => lambda_nm == other_nm && index == other,
            _ => false,
        }
    }

    /// The index, if it is the same at every wavelength.
    pub fn constant(&self) -> Option<Complex<f64>> {
        match &self.0 {
            Kind::Named(named) => named.constant(),
            Kind::Rgb(index) => all_equal(index),
            Kind::Table { index, .. } => all_equal(index),
        }
    }

    /// Whether k > 0 at some visible wavelength or, for a medium that a caller gave, in any of the numbers.
    pub fn absorbs(&self) -> bool {
        match &self.0 {
            Kind::Named(named) => named.absorbs(),
            Kind::Rgb(index) => index.iter().any(|index| index.im > 0.0),
            Kind::Table { index, .. } => index.iter().any(|index| index.im > 0.0),
        }
    }

    /// The greatest k within 380-780 nm: of a named medium that at steps of 5 nm.
    pub fn greatest_extinction(&self) -> f64 {
        let [first, last] = VISIBLE_NM;
        let steps = match self.0 {
            Kind::Named(_) => 80,
            Kind::Rgb(_) | Kind::Table { .. } => 1,
        };
        let even = (0..=steps).map(|i| first + (last - first) * f64::from(i) / f64::from(steps));
        let bends = self.nodes_nm().iter().copied().chain(RGB_WAVELENGTHS_NM);
        even.chain(bends)
            .map(|nm| self.index(nm).im)
            .fold(0.0, f64::max)
    }

    /// The wavelengths of a table's entries between 380 and 780 nm, ascending: the index bends there. None for a
    /// medium that is no table.
    pub fn nodes_nm(&self) -> &[f64] {
        let Kind::Table { lambda_nm, .. } = &self.0 else {
            return &[];
        };
        let [first, last] = VISIBLE_NM;
        let from = lambda_nm.partition_point(|nm| *nm <= first);
        let to = lambda_nm.partition_point(|nm| *nm < last);
        &lambda_nm[from..to.max(from)]
    }

    /// The range of wavelengths that the medium is known for, nm. Outside, the index is constant, which is a guess:
    /// a named medium has the range of its data ([`NamedMedium::range_nm`]), a table that of its entries, a constant
    /// given by eta and k all wavelengths, and one that disperses the visible ones, 380-780 nm.
    pub fn range_nm(&self) -> [f64; 2] {
        match &self.0 {
            Kind::Named(named) => named.range_nm(),
            Kind::Rgb(index) if all_equal(index).is_some() => [0.0, f64::INFINITY],
            Kind::Rgb(_) => VISIBLE_NM,
            Kind::Table { lambda_nm, .. } => [lambda_nm[0], lambda_nm[lambda_nm.len() - 1]],
        }
    }

    /// Writes the medium for [`Medium::load`] of the same build: a named one is its number in the list.
    pub(crate) fn save(&self, block: &mut ByteWriter) {
        match &self.0 {
            Kind::Named(named) => {
                let number = NamedMedium::all().iter().position(|m| m.name == named.name);
                block.byte(NAMED);
                block.byte(number.unwrap_or_default() as u8);
            }
            Kind::Rgb(index) => {
                block.byte(RGB);
                block.numbers(&index.map(|index| index.re));
                block.numbers(&index.map(|index| index.im));
            }
            Kind::Table { lambda_nm, index } => {
                block.byte(TABLE);
                block.count(lambda_nm.len());
                for (nm, index) in lambda_nm.iter().zip(index) {
                    block.numbers(&[*nm, index.re, index.im]);
                }
            }
        }
    }

    /// Reads a medium. Fails as [`Medium::rgb`] and [`Medium::table`] do, and if there is no memory.
    pub(crate) fn load(block: &mut ByteReader<'_>) -> Result<Self, Error> {
        match block.choice(&[NAMED, RGB, TABLE])? {
            NAMED => {
                let named = NamedMedium::all().get(usize::from(block.byte()?));
                let named = named.ok_or_else(|| unusable("a medium is unknown"))?;
                Ok(Self(Kind::Named(named)))
            }
            RGB => Self::rgb(block.numbers()?, block.numbers()?),
            _ => {
                let count = block.count(size_of::<[f64; 3]>(), usize::MAX)?;
                let column = || Error::reserve(count, "a table of measured indices");
                let mut columns = [column()?, column()?, column()?];
                for _ in 0..count {
                    for (column, number) in columns.iter_mut().zip(block.numbers::<3>()?) {
                        column.push(number);
                    }
                }
                let [nm, eta, k] = columns;
                Self::table(&nm, &eta, &k)
            }
        }
    }

    /// Checks that the medium can be an ambient medium: k = 0 and eta >= 1.
    pub fn check_ambient(&self) -> Result<(), Error> {
        if self.absorbs() {
            return Err(Error::out_of_range(
                "the ambient medium absorbs; it must have k = 0",
            ));
        }
        match &self.0 {
            Kind::Named(_) => Ok(()), // every transparent named medium has eta >= 1
            Kind::Rgb(index) => check_ambient_eta(index),
            Kind::Table { index, .. } => check_ambient_eta(index),
        }
    }
}

fn check_ambient_eta(index: &[Complex<f64>]) -> Result<(), Error> {
    let eta: Vec<f64> = index.iter().map(|index| index.re).collect();
    check("eta of the ambient medium", &eta, AMBIENT_ETA_RANGE)
}

fn check(name: &str, values: &[f64], [min, max]: [f64; 2]) -> Result<(), Error> {
    let Some(at) = values.iter().position(|value| !(min..=max).contains(value)) else {
        return Ok(());
    };
    let value = values[at];
    Err(Error::out_of_range(format!(
        "{name}[{at}] = {value} is outside [{min}, {max}]"
    )))
}

/// A number given at [`RGB_WAVELENGTHS_NM`], at a vacuum wavelength in nm: linear in 1 / lambda^2, the first two terms
/// of Cauchy's formula, and constant outside.
#[inline(always)]
pub fn index_between<T: Real>([a, b, c]: [T; 3], wavelength_nm: T) -> T {
    let [u0, u1, u2] = RGB_INVERSE_SQUARES;
    let u = T::new(1.0) / wavelength_nm.squared();
    let part = |t: T| t.max(T::new(0.0)).min(T::new(1.0));
    let below = part((u - T::new(u0)) * T::new(1.0 / (u1 - u0)));
    let above = part((u - T::new(u1)) * T::new(1.0 / (u2 - u1)));
    T::select(u.lt(T::new(u1)), a + (b - a) * below, b + (c - b) * above)
}

/// Linear between the wavelengths of a table, constant outside.
fn look_up(lambda_nm: &[f64], index: &[Complex<f64>], wavelength_nm: f64) -> Complex<f64> {
    let above = lambda_nm.partition_point(|&nm| nm <= wavelength_nm);
    let (Some(below), true) = (above.checked_sub(1), above < index.len()) else {
        return index[above.min(index.len() - 1)];
    };
    let t = (wavelength_nm - lambda_nm[below]) / (lambda_nm[above] - lambda_nm[below]);
    mix(index[below], index[above], t)
}

/// 1 / lambda^2 of [`RGB_WAVELENGTHS_NM`].
const RGB_INVERSE_SQUARES: [f64; 3] = {
    let [red, green, blue] = RGB_WAVELENGTHS_NM;
    [
        1.0 / (red * red),
        1.0 / (green * green),
        1.0 / (blue * blue),
    ]
};

#[inline(always)]
fn constant<T: Real>(index: Complex<f64>) -> Complex<T> {
    Complex::new(T::new(index.re), T::new(index.im))
}

/// a + (b - a) t with t clamped to [0, 1]; exactly a for a = b.
#[inline(always)]
fn mix<T: Real>(a: Complex<T>, b: Complex<T>, t: T) -> Complex<T> {
    a + (b - a).scaled(t.max(T::new(0.0)).min(T::new(1.0)))
}

fn all_equal(index: &[Complex<f64>]) -> Option<Complex<f64>> {
    index
        .iter()
        .all(|other| *other == index[0])
        .then_some(index[0])
}
