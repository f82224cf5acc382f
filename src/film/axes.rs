//! The coordinates of a table: where the reflectance of a film is smooth, and cheap to find.

use crate::math::Real;

/// Maps (cosine, thickness) to the unit square, or to as many steps as a table has, and back. With d the thickness above its least value:
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
pub(super) struct Axes<T> {
    /// The greatest value of x.
    last: T,
    scale: T,
    least: T,
    half: T,
    upright: [T; 3],
    /// The least thickness; the fade per nm; 1 + 1 / fade, times the greatest value of y.
    from: T,
    fade: T,
    stretch: T,
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

impl Axes<f64> {
    /// For thicknesses in a range, nm.
    pub(super) fn new(shape: Shape, [min, max]: [f64; 2]) -> Self {
        let range = (max - min).max(f64::MIN_POSITIVE);
        let cosine = |u: f64| (1.0 - shape.tilt * (1.0 - u)).sqrt();
        let [a, b, c] = [0.0, 0.5, 1.0].map(cosine);
        Self {
            last: 1.0,
            scale: shape.scale,
            least: shape.least,
            half: shape.half,
            upright: [a, 4.0 * b - 3.0 * a - c, 2.0 * (a + c) - 4.0 * b],
            from: min,
            fade: shape.fade / range,
            stretch: 1.0 + 1.0 / shape.fade,
        }
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

    /// In single precision, counting so many steps along either coordinate.
    pub(super) fn rounded(&self, steps: [usize; 2]) -> Axes<f32> {
        Axes {
            last: steps[0] as f32,
            scale: self.scale as f32,
            least: self.least as f32,
            half: self.half as f32,
            upright: self.upright.map(|c| c as f32),
            from: self.from as f32,
            fade: self.fade as f32,
            stretch: (self.stretch * steps[1] as f64) as f32,
        }
    }
}

impl<T: Real> Axes<T> {
    #[inline(always)]
    fn upright(&self, cos_theta: T) -> T {
        let u = cos_theta * cos_theta;
        (self.upright[0] + self.upright[1] * u) + (self.upright[2] * u) * u
    }

    /// The first coordinate at a cosine in [0, 1] and a thickness within the range.
    #[inline(always)]
    pub(super) fn x(&self, cos_theta: T, thickness_nm: T) -> T {
        let d = thickness_nm - self.from;
        let below = d + self.half;
        let gamma = self.scale * (d + self.least);
        (cos_theta * self.last) * (below + gamma) / (cos_theta * below + gamma)
    }

    /// The second.
    #[inline(always)]
    pub(super) fn y(&self, cos_theta: T, thickness_nm: T) -> T {
        let path = (thickness_nm - self.from) * self.fade * self.upright(cos_theta);
        self.stretch * path / (T::new(1.0) + path)
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
                for cos_theta in [1.0, 0.6, 0.02] {
                    for thickness in [20.5, 130.0, 900.0] {
                        let (x, y) = (axes.x(cos_theta, thickness), axes.y(cos_theta, thickness));
                        assert!((0.0..=1.0 + 1e-12).contains(&x));
                        assert!((-1e-12..=1.0 + 1e-12).contains(&y));
                        let (c, d) = axes.point(x, y);
                        assert!((c - cos_theta).abs() < 1e-9, "{c} {cos_theta}");
                        assert!((d / thickness - 1.0).abs() < 1e-9, "{d} {thickness}");
                    }
                }
            }
        }
    }
}
