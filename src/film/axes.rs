//! The coordinates of a table: where the reflectance of a film is smooth, and cheap to find.

use super::table::Lanes;
use crate::num::Lane;

/// Maps (cosine, thickness) to the unit square. With d the thickness above its least value:
///
/// ```text
/// x = cos (1 + gamma) / (cos + gamma)     gamma = scale (d + least) / (d + half)
/// y = (1 + 1 / fade) (1 - 1 / (1 + fade p))     p = d upright(cos) / range
/// ```
///
/// x makes (cos - gamma) / (cos + gamma), the shape of Fresnel's amplitudes near grazing, linear. A film
/// between like media shows all its colours at cosines in proportion to its thickness where that is
/// small: then `least` is almost 0.
///
/// y takes fringes upright, as the phase depends on d cos(angle in the film) alone: `upright` is that
/// cosine, a parabola in cos^2 through three of its values (any function would do; the closer, the
/// fewer columns). And it is dense where the film is thin, as fringes fade where paths are long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axes {
    scale: f64,
    least: f64,
    half: f64,
    upright: [f64; 3],
    /// The least thickness; the fade per nm; 1 + 1 / fade.
    from: f64,
    fade: f64,
    stretch: f64,
}

/// With `least` below this, colours at thickness 0 are those in the limit of such a film, nm: a thousandth
/// of an atom.
pub(super) const LEAST_NM: f64 = 1e-3;

/// What to choose of [`Axes`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Shape {
    /// gamma for thick films.
    pub scale: f64,
    /// nm; equal: gamma does not depend on the thickness.
    pub least: f64,
    pub half: f64,
    /// The square of n0 / n1, less than 1; 0: y does not depend on the angle.
    pub tilt: f64,
    /// How much denser thin films are than thick ones, > 0.
    pub fade: f64,
}

impl Axes {
    /// For thicknesses in a range, nm.
    pub(super) fn new(shape: Shape, [min, max]: [f64; 2]) -> Self {
        let range = (max - min).max(f64::MIN_POSITIVE);
        let cosine = |u: f64| (1.0 - shape.tilt * (1.0 - u)).sqrt();
        let [a, b, c] = [0.0, 0.5, 1.0].map(cosine);
        Self {
            scale: shape.scale,
            least: shape.least,
            half: shape.half,
            upright: [a, 4.0 * b - 3.0 * a - c, 2.0 * (a + c) - 4.0 * b],
            from: min,
            fade: shape.fade / range,
            stretch: 1.0 + 1.0 / shape.fade,
        }
    }

    fn upright(&self, cos_theta: f64) -> f64 {
        let u = cos_theta * cos_theta;
        self.upright[0] + (self.upright[1] + self.upright[2] * u) * u
    }

    /// The cosine and the thickness at a point of the unit square; the thickness may exceed its range.
    pub(super) fn point(&self, x: f64, y: f64) -> (f64, f64) {
        // The path, and the thickness and the cosine that belong to it: each depends weakly on the
        // other.
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

    /// From a cosine and a thickness to the numbers of steps along either coordinate, of which there are so
    /// many.
    pub(super) fn coordinates(&self, steps: [usize; 2]) -> Coordinates {
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

/// [`Axes`] the other way, for both coordinates at once: x and y are in the first two places of
///
/// ```text
/// numerator(d) f(cos) / (denominator(d) f(cos) + rest(d))
/// x: (d + half + scale (d + least)) cos / ((d + half) cos + scale (d + least))
/// y: stretch fade d upright(cos) / (fade d upright(cos) + 1)
/// ```
///
/// with the numbers of steps as factors of the numerators.
#[derive(Clone, Debug)]
pub(super) struct Coordinates {
    from: f32,
    numerator: Linear,
    denominator: Linear,
    rest: Linear,
    /// The coefficients of cos^0, cos, cos^2 and cos^4 in f.
    cosine: [Lanes; 4],
}

/// A linear function of the thickness.
#[derive(Clone, Debug)]
struct Linear {
    slope: Lanes,
    constant: Lanes,
}

impl Linear {
    #[inline(always)]
    fn at(&self, d: Lanes) -> Lanes {
        self.slope * d + self.constant
    }
}

impl Coordinates {
    /// At a cosine in [0, 1] and a thickness within the range; y is in the third place too.
    #[inline(always)]
    pub(super) fn at(&self, cos_theta: f32, thickness_nm: f32) -> Lanes {
        let d = f32::gray(thickness_nm - self.from);
        let cosine = f32::gray(cos_theta);
        let square = cosine * cosine;
        let [constant, first, second, fourth] = self.cosine;
        let f = (fourth * square + second) * square + (constant + first * cosine);
        let divisor = self.denominator.at(d) * f + self.rest.at(d);
        self.numerator.at(d) * f / divisor
    }
}

/// One of the numbers, everywhere.
#[inline(always)]
fn number<L: Lane<Scalar = f32>>(lanes: &Lanes, axis: usize) -> L {
    L::splat(f32::channels(*lanes)[axis])
}

impl Linear {
    /// Of one axis.
    #[inline(always)]
    fn lanes<L: Lane<Scalar = f32>>(&self, axis: usize, d: L) -> L {
        number::<L>(&self.slope, axis) * d + number(&self.constant, axis)
    }
}

impl Coordinates {
    /// [`Coordinates::at`] of as many as there are.
    #[inline(always)]
    pub(super) fn lanes<L: Lane<Scalar = f32>>(&self, cos_theta: L, thickness_nm: L) -> [L; 2] {
        [
            self.coordinate(0, cos_theta, thickness_nm),
            self.coordinate(1, cos_theta, thickness_nm),
        ]
    }

    #[inline(always)]
    fn coordinate<L: Lane<Scalar = f32>>(&self, axis: usize, cos_theta: L, thickness_nm: L) -> L {
        let d = thickness_nm - L::splat(self.from);
        let square = cos_theta * cos_theta;
        let [constant, first, second, fourth] = &self.cosine;
        let f = (number::<L>(fourth, axis) * square + number::<L>(second, axis)) * square
            + (number::<L>(constant, axis) + number::<L>(first, axis) * cos_theta);
        let divisor = self.denominator.lanes(axis, d) * f + self.rest.lanes(axis, d);
        self.numerator.lanes(axis, d) * f / divisor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        for (tilt, fade) in [(0.0, 0.3), (0.6, 1.0), (0.9, 10.0)] {
            for (least, half) in [(1.0, 1.0), (1e-4, 150.0)] {
                let scale = 0.3;
                let shape = Shape {
                    scale,
                    least,
                    half,
                    tilt,
                    fade,
                };
                let axes = Axes::new(shape, [20.0, 900.0]);
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
