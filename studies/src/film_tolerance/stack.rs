//! A stack in the single-precision numbers that a caller in C would give, so that the printed numbers reproduce it.

use super::kind::Kind;
use super::points::Point;
use pellicle::film::FilmDescription;
use pellicle::optics::stack::Side;
use pellicle::optics::{ColorSpace, Medium, Reference, TOLERANCE, VISIBLE_NM, White};
use std::fmt::{Display, Formatter, Result};

/// The index of a medium.
#[derive(Clone, Debug, PartialEq)]
pub enum Index {
    /// eta and k at 645, 525 and 445 nm.
    Rgb([f32; 3], [f32; 3]),
    /// A medium of the library.
    Named(&'static str),
    /// A table.
    Lines(Lines),
}

/// A transparent medium with lines: its index goes straight from `around` to `top` at the centres and back.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// eta beside the lines.
    pub around: f32,
    /// eta and k at the centres.
    pub top: [f32; 2],
    /// Ascending, and further apart than twice the half width.
    pub centers_nm: Vec<f32>,
    pub half_width_nm: f32,
}

impl Lines {
    fn medium(&self) -> Medium {
        let around = [self.around, 0.0];
        let mut rows = vec![(VISIBLE_NM[0], around)];
        for center in &self.centers_nm {
            let (center, half) = (f64::from(*center), f64::from(self.half_width_nm));
            rows.extend([
                (center - half, around),
                (center, self.top),
                (center + half, around),
            ]);
        }
        rows.push((VISIBLE_NM[1], around));
        let nm: Vec<f64> = rows.iter().map(|row| row.0).collect();
        let [eta, k] = [0, 1].map(|i| rows.iter().map(|row| row.1[i].into()).collect::<Vec<f64>>());
        Medium::table(&nm, &eta, &k).unwrap()
    }
}

impl Index {
    pub const VACUUM: Self = Self::constant(1.0, 0.0);

    pub const fn constant(eta: f32, k: f32) -> Self {
        Self::Rgb([eta; 3], [k; 3])
    }

    pub fn medium(&self) -> Medium {
        match self {
            Self::Rgb(eta, k) => Medium::rgb(eta.map(f64::from), k.map(f64::from)).unwrap(),
            Self::Named(name) => Medium::named(name).unwrap(),
            Self::Lines(lines) => lines.medium(),
        }
    }
}

/// Layers between an ambient medium and a base, and the colours wanted of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Stack {
    pub kind: Kind,
    pub ambient: Index,
    /// Index; least and greatest thickness, nm.
    pub layers: Vec<(Index, [f32; 2])>,
    pub base: Index,
    pub white: White,
    pub space: ColorSpace,
    /// Whether transmittance and the base's side are wanted and checked.
    pub both_sides: bool,
}

impl Stack {
    pub fn description(&self, tolerance: f64) -> FilmDescription {
        let mut description = FilmDescription::new(self.base.medium());
        description.ambient = self.ambient.medium();
        description.tolerance = tolerance;
        description.white = self.white;
        description.color_space = self.space;
        description.transmittance = self.both_sides;
        for (index, thickness_nm) in &self.layers {
            description = description.layer(index.medium(), thickness_nm.map(f64::from));
        }
        description
    }

    pub fn reference(&self) -> Reference {
        let layers = self.layers.iter().map(|(index, _)| index.medium());
        Reference::new(
            self.ambient.medium(),
            layers.collect(),
            self.base.medium(),
            self.white,
            self.space,
        )
        .unwrap()
    }

    /// The range of the thickness that varies, nm, if one does.
    pub fn varying_nm(&self) -> Option<[f32; 2]> {
        let mut ranges = self.layers.iter().map(|layer| layer.1);
        ranges.find(|[min, max]| min != max)
    }

    /// The least and the greatest cosine, in the denser half-space, beyond which light of some wavelength is reflected
    /// totally; none if the half-spaces have the same index.
    pub fn critical_interval(&self) -> Option<[f64; 2]> {
        let [ambient, base] = [&self.ambient, &self.base].map(Index::medium);
        let cosines = (0..=400).filter_map(|i| {
            let nm = VISIBLE_NM[0] + f64::from(i);
            let [a, b] = [&ambient, &base].map(|medium| medium.index(nm).re);
            let ratio = a.min(b) / a.max(b);
            (ratio < 1.0).then(|| ((1.0 - ratio) * (1.0 + ratio)).sqrt())
        });
        cosines.fold(None, |found: Option<[f64; 2]>, c| {
            let [least, greatest] = found.unwrap_or([c; 2]);
            Some([least.min(c), greatest.max(c)])
        })
    }

    /// The converged colours at points, not clipped. Panics if they do not converge.
    pub fn truth(&self, points: &[Point]) -> Vec<Truth> {
        let reference = self.reference();
        let at = |(i, [cos_theta, varying_nm]): (usize, &Point)| {
            let thickness =
                |(_, [min, max]): &(Index, [f32; 2])| varying_nm.clamp(*min, *max).into();
            let thicknesses: Vec<f64> = self.layers.iter().map(thickness).collect();
            let from = |side| {
                let found = reference.evaluate(side, f64::from(*cos_theta), &thicknesses);
                assert!(
                    found.change <= TOLERANCE,
                    "{self}, {side:?}, {:?}: {found:?}",
                    points[i]
                );
                found
            };
            let ambient = from(Side::Ambient);
            let has_sides = self.both_sides && i.is_multiple_of(self.kind.both_sides_stride());
            let sides = has_sides.then(|| {
                let base = from(Side::Base);
                [ambient.transmittance, base.reflectance, base.transmittance]
            });
            Truth {
                reflectance: ambient.reflectance,
                sides,
            }
        };
        points.iter().enumerate().map(at).collect()
    }
}

/// The colours at one point, not clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// From the ambient's side.
    pub reflectance: [f64; 3],
    /// Where both sides are checked: transmittance, and reflectance and transmittance from the base.
    pub sides: Option<[[f64; 3]; 3]>,
}

impl Display for Index {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Named(name) => write!(f, "{name}"),
            Self::Lines(lines) => {
                let Lines {
                    around,
                    top: [eta, k],
                    centers_nm,
                    half_width_nm,
                } = lines;
                write!(
                    f,
                    "({around}; {eta}+{k}i at {centers_nm:?} +- {half_width_nm} nm)"
                )
            }
            Self::Rgb([eta, rest @ ..], [k, k_rest @ ..])
                if *rest == [*eta; 2] && *k_rest == [*k; 2] =>
            {
                write!(f, "{eta}")?;
                if *k > 0.0 { write!(f, "+{k}i") } else { Ok(()) }
            }
            Self::Rgb(eta, k) => {
                write!(f, "{eta:?}")?;
                if *k == [0.0; 3] {
                    Ok(())
                } else {
                    write!(f, "+{k:?}i")
                }
            }
        }
    }
}

/// Ambient / layers with their thickness / base; white, space.
impl Display for Stack {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{}", self.ambient)?;
        for (index, [min, max]) in &self.layers {
            write!(f, " / {index} {min}")?;
            if min != max {
                write!(f, "..{max}")?;
            }
            write!(f, " nm")?;
        }
        write!(f, " / {}; {:?}, {:?}", self.base, self.white, self.space)?;
        if self.both_sides {
            write!(f, ", both sides")?;
        }
        Ok(())
    }
}
