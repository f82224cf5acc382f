//! The coordinates of a table, in which the reflectance of a film is smooth and which are cheap to
//! compute.

use crate::error::Error;
use crate::num::Lane;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};

/// Maps (cosine, thickness) to the unit square. With d the thickness above the least one:
///
/// ```text
/// x = cos (1 + gamma) / (cos + gamma)     gamma = scale (d + least) / (d + half)
/// y = (1 + 1 / fade) (1 - 1 / (1 + fade p))     p = d upright(cos) / range
/// ```
///
/// x makes (cos - gamma) / (cos + gamma), the shape of Fresnel's amplitudes near grazing incidence,
/// linear. A thin film between like media shows all its colours at cosines in proportion to its
/// thickness: for such a film `least` is almost 0.
///
/// y makes fringes parallel to the x axis' lines, because the phase depends on d cos(angle in the film)
/// alone: `upright` approximates that cosine by a parabola in cos^2 through three of its values. Any
/// function is correct; a closer one needs fewer columns. The rows are dense where the film is thin,
/// because fringes fade where paths are long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::film) struct Axes {
    scale: f64,
    least: f64,
    half: f64,
    upright: [f64; 3],
    /// The least thickness, nm.
    from: f64,
    /// Per nm.
    fade: f64,
    /// 1 + 1 / fade, with the fade per range.
    stretch: f64,
    params: AxisParams,
}

/// Thickness, nm: if `least` is below this, colours at thickness 0 are the limit of those of ever
/// thinner films. A thousandth of an atom.
pub(in crate::film) const LEAST_NM: f64 = 1e-3;

/// The free parameters of [`Axes`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::film) struct AxisParams {
    /// gamma for thick films.
    pub scale: f64,
    /// Thickness, nm. If it equals `half`, gamma does not depend on the thickness.
    pub least: f64,
    /// Thickness at which gamma has half its greatest value, nm.
    pub half: f64,
    /// (n0 / n1)^2, less than 1. At 0, y does not depend on the angle.
    pub tilt: f64,
    /// The shape of y, > 0: the rows at the least thickness are (1 + fade)^2 times as dense as at the
    /// greatest one.
    pub fade: f64,
}

impl AxisParams {
    /// The least and the greatest scale, least, half, tilt and fade of axes that are loaded. Within them no position
    /// leaves the table.
    const ACCEPTED: [[f64; 2]; 5] = [
        [1e-4, 1e4],
        [1e-12, 1e6],
        [1e-12, 1e6],
        [0.0, 0.95],
        [1e-4, 1e6],
    ];

    pub(in crate::film) fn save(&self, block: &mut ByteWriter) {
        let Self {
            scale,
            least,
            half,
            tilt,
            fade,
        } = *self;
        block.numbers(&[scale, least, half, tilt, fade]);
    }

    /// Reads parameters with which coordinates neither overflow nor vanish.
    pub(in crate::film) fn load(block: &mut ByteReader<'_>) -> Result<Self, Error> {
        let [scale, least, half, tilt, fade] = Self::ACCEPTED;
        let loaded = Self {
            scale: block.number_within("the scale of an axis", scale)?,
            least: block.number_within("the least thickness of an axis", least)?,
            half: block.number_within("the half thickness of an axis", half)?,
            tilt: block.number_within("the tilt of an axis", tilt)?,
            fade: block.number_within("the fade of an axis", fade)?,
        };
        if loaded.least > loaded.half {
            return Err(unusable("the thicknesses of an axis are reversed"));
        }
        Ok(loaded)
    }
}

impl Axes {
    /// For thicknesses in a range, nm.
    pub(in crate::film) fn new(params: AxisParams, [min, max]: [f64; 2]) -> Self {
        let range = (max - min).max(f64::MIN_POSITIVE);
        let cosine = |u: f64| (1.0 - params.tilt * (1.0 - u)).sqrt();
        let [a, b, c] = [0.0, 0.5, 1.0].map(cosine);
        Self {
            scale: params.scale,
            least: params.least,
            half: params.half,
            upright: [a, 4.0 * b - 3.0 * a - c, 2.0 * (a + c) - 4.0 * b],
            from: min,
            fade: params.fade / range,
            stretch: 1.0 + 1.0 / params.fade,
            params,
        }
    }

    pub(in crate::film) fn params(&self) -> AxisParams {
        self.params
    }

    fn upright(&self, cos_theta: f64) -> f64 {
        let u = cos_theta * cos_theta;
        self.upright[0] + (self.upright[1] + self.upright[2] * u) * u
    }

    /// The cosine and the thickness (nm) at a point of the unit square. The thickness may exceed its
    /// range.
    pub(in crate::film) fn point(&self, x: f64, y: f64) -> (f64, f64) {
        // Thickness and cosine depend weakly on each other, so that a fixed-point iteration finds both.
        let path = (1.0 / (1.0 - y / self.stretch) - 1.0) / self.fade;
        let (mut cos_theta, mut d) = (x, path);
        let floor = if self.least < LEAST_NM { LEAST_NM } else { 0.0 };
        for _ in 0..30 {
            let before = cos_theta;
            let gamma = self.scale * (d + self.least) / (d + self.half);
            cos_theta = x * gamma / (1.0 + gamma - x);
            d = (path / self.upright(cos_theta)).max(floor);
            if (cos_theta - before).abs() <= 1e-15 * cos_theta {
                break;
            }
        }
        (cos_theta, self.from + d)
    }

    /// The map from a cosine and a thickness to coordinates that count steps, `steps` of them along x
    /// and along y.
    pub(in crate::film) fn coordinates(&self, steps: [usize; 2]) -> Coordinates {
        let [across, along] = steps.map(|steps| steps as f64);
        let stretch = self.stretch * along;
        let [u, v, w] = self.upright;
        let pair = |x: f64, y: f64| f32::rgb([x, y, y].map(|number| number as f32));
        let linear = |slope: [f64; 2], constant: [f64; 2]| Linear {
            slope: pair(slope[0], slope[1]),
            constant: pair(constant[0], constant[1]),
        };
        Coordinates {
            from: self.from as f32,
            numerator: linear(
                [across * (1.0 + self.scale), self.fade * stretch],
                [across * (self.half + self.scale * self.least), 0.0],
            ),
            denominator: linear([1.0, self.fade], [self.half, 0.0]),
            rest: linear([self.scale, 0.0], [self.scale * self.least, 1.0]),
            cosine: [pair(0.0, u), pair(1.0, 0.0), pair(0.0, v), pair(0.0, w)],
        }
    }
}

/// The inverse of [`Axes::point`]. Both coordinates are of one form,
///
/// ```text
/// numerator(d) f(cos) / (denominator(d) f(cos) + rest(d))
/// x: (d + half + scale (d + least)) cos / ((d + half) cos + scale (d + least))
/// y: stretch fade d upright(cos) / (fade d upright(cos) + 1)
/// ```
///
/// with the numbers of steps as factors of the numerators. So they are computed side by side like the
/// channels of a colour, x in the first, y in the second and third: for a single call in one register,
/// with one division.
#[derive(Clone, Debug)]
pub(in crate::film) struct Coordinates {
    from: f32,
    numerator: Linear,
    denominator: Linear,
    rest: Linear,
    /// The coefficients of cos^0, cos, cos^2 and cos^4 in f.
    cosine: [AxisPair; 4],
}

/// A number for x, and one for y twice.
type AxisPair = <f32 as Lane>::Rgb;

/// A linear function of the thickness, for x and y.
#[derive(Clone, Debug)]
struct Linear {
    slope: AxisPair,
    constant: AxisPair,
}

impl Linear {
    #[inline(always)]
    fn at<L: Lane<Scalar = f32>>(&self, d: L::Rgb) -> L::Rgb {
        L::splat_rgb(self.slope) * d + L::splat_rgb(self.constant)
    }
}

impl Coordinates {
    /// x at a cosine in [0, 1], for a table over the cosine alone: the formula at d = 0, where f is the cosine.
    #[inline(always)]
    pub(in crate::film) fn over_cosine<L: Lane<Scalar = f32>>(&self, cos_theta: L) -> L {
        let [factor, slope, rest] = [&self.numerator, &self.denominator, &self.rest]
            .map(|linear| L::splat(f32::channels(linear.constant)[0]));
        factor * cos_theta / (slope * cos_theta + rest)
    }

    /// x, y and y at a cosine in [0, 1] and a thickness within the range, nm.
    #[inline(always)]
    pub(in crate::film) fn at<L: Lane<Scalar = f32>>(
        &self,
        cos_theta: L,
        thickness_nm: L,
    ) -> L::Rgb {
        let d = (thickness_nm - L::splat(self.from)).gray();
        let cosine = cos_theta.gray();
        let square = cosine * cosine;
        let [constant, first, second, fourth] = &self.cosine;
        let f = (L::splat_rgb(*fourth) * square + L::splat_rgb(*second)) * square
            + (L::splat_rgb(*constant) + L::splat_rgb(*first) * cosine);
        let divisor = self.denominator.at::<L>(d) * f + self.rest.at::<L>(d);
        self.numerator.at::<L>(d) * f / divisor
    }
}

#[cfg(test)]
mod tests {
    use super::super::spline::MOST_LOADED;
    use super::*;

    /// Against a loaded axis that leads beyond the table, whose look-up would then panic: whatever its parameters are, a
    /// position is at most a quarter of a step outside, for every cosine and thickness of ranges up to the widest.
    #[test]
    fn positions_stay_within_the_table() {
        let accepted = AxisParams::ACCEPTED;
        let mut count = 0;
        for choice in 0..3usize.pow(5) {
            let number = |i: usize| {
                let [least, greatest] = accepted[i];
                match choice / 3usize.pow(i as u32) % 3 {
                    0 => least,
                    1 => (least.max(1e-3) * greatest).sqrt(),
                    _ => greatest,
                }
            };
            let [scale, least, half, tilt, fade] = std::array::from_fn(number);
            if least > half {
                continue;
            }
            let params = AxisParams {
                scale,
                least,
                half,
                tilt,
                fade,
            };
            for range in [[0.0, 1e-3], [0.0, 1e8], [1e8 - 8.0, 1e8], [100.0, 900.0]] {
                let range = range.map(|nm| f64::from(nm as f32));
                for steps in [4, MOST_LOADED] {
                    let coordinates = Axes::new(params, range).coordinates([steps; 2]);
                    for c in [0.0, 1e-9, 1e-3, 0.3, 0.8, 1.0 - f32::EPSILON, 1.0] {
                        let alone = coordinates.over_cosine(c);
                        assert!((-0.25..=steps as f32 + 0.25).contains(&alone), "{params:?}");
                        for part in [0.0, 1e-6, 0.5, 1.0] {
                            let d = (range[0] + part * (range[1] - range[0])) as f32;
                            for position in f32::channels(coordinates.at(c, d)) {
                                let allowed = -0.25..=steps as f32 + 0.25;
                                assert!(
                                    allowed.contains(&position),
                                    "{params:?}, {range:?}: {position} of {steps} at {c}, {d} nm"
                                );
                                count += 1;
                            }
                        }
                    }
                }
            }
        }
        assert!(count > 100_000);
    }

    /// Against a wrong inverse: the coordinates of the point at (x, y) are (x, y).
    #[test]
    fn coordinates_invert_points() {
        for (tilt, fade) in [(0.0, 0.3), (0.6, 1.0), (0.9, 10.0)] {
            for (least, half) in [(1.0, 1.0), (1e-4, 150.0)] {
                let scale = 0.3;
                let params = AxisParams {
                    scale,
                    least,
                    half,
                    tilt,
                    fade,
                };
                let axes = Axes::new(params, [20.0, 900.0]);
                let coordinates = axes.coordinates([1000, 500]);
                for (x, y) in [
                    (1.0, 1.0),
                    (0.7, 0.02),
                    (0.3, 0.9),
                    (1e-3, 0.4),
                    (0.5, 0.01),
                ] {
                    let (c, d) = axes.point(x, y);
                    assert!((0.0..=1.0 + 1e-9).contains(&c) && d >= 20.0, "{c} {d}");
                    let found = f32::channels(coordinates.at(c as f32, d as f32)).map(f64::from);
                    assert!((found[0] / 1000.0 - x).abs() < 1e-5, "{x}: {found:?}");
                    assert!((found[1] / 500.0 - y).abs() < 1e-5, "{y}: {found:?}");
                }
            }
        }
    }
}
