//! The average over a cut normal distribution by many nodes: the truth that quick rules and levels are fitted to, and
//! the answer of methods that have none.

use crate::film::colors::Colors;
use crate::film::description::FilmDescription;

/// Deviations from the thickness beyond which the distribution is left out: 4e-8 of it.
const REACH: f64 = 5.5;
/// A thickness beyond the range, which tables are filled at but never looked up at, is at most this number of
/// deviations away from it.
const BEYOND: f64 = 3.0;
/// The greatest part of a deviation that a panel covers.
const PART: f64 = 0.7;
/// The number of panels to the shortest fringe.
const PANELS: f64 = 3.0;
/// Half the shortest visible wavelength, nm: the optical thickness from fringe to fringe.
const FRINGE_NM: f64 = 190.0;
/// The optical thickness up to which fringes are seen well, nm. Beyond it panels grow in proportion.
const COHERENT_NM: f64 = 4000.0;
/// At grazing angles the colours change within a small part of the thickness from 0 on, where a film begins to
/// reflect: a panel is at most this part of the thickness that it begins at, but not narrower than this, nm.
const THIN_PART: f64 = 0.7;
const THINNEST_NM: f64 = 0.3;
/// Panels grow where there would be more.
const MOST_PANELS: f64 = 4000.0;
/// Thicknesses at which colours are found at once, a multiple of a panel's.
pub(in crate::film) const AT_ONCE: usize = 64;
/// The Gauss rule of four nodes on [-1, 1] (Abramowitz and Stegun 1964, table 25.4).
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
];

/// Finds the colours at thicknesses, nm, and writes them to as many places.
pub(in crate::film) type ColorsOfMany<'a> = dyn FnMut(&[f64], &mut [Colors<f64>]) + 'a;

/// The range of a thickness, and the steps in which its fringes are resolved.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct Fringes {
    /// Least and greatest thickness, nm.
    pub range: [f64; 2],
    /// Distance of the closest fringes, nm.
    pub period: f64,
}

impl Fringes {
    pub fn new(description: &FilmDescription) -> Self {
        const MIDDLE_NM: f64 = 550.0;
        let index = description.varying().map_or(1.0, |layer| {
            let index = description.layers[layer].medium.index(MIDDLE_NM);
            index.re.hypot(index.im)
        });
        Self {
            range: description.varying_range(),
            period: FRINGE_NM / index.max(1.0),
        }
    }

    /// The average of colours over thicknesses, nm, normally distributed with a deviation above 0 around a thickness
    /// and cut to the range. With x the thickness,
    ///
    /// ```text
    /// integral of color(t) w(t) dt / integral of w(t) dt     w(t) = exp(-(t - x)^2 / (2 deviation^2)), t in the range
    /// ```
    pub fn average(
        &self,
        thickness_nm: f64,
        deviation_nm: f64,
        colors: &mut dyn FnMut(f64) -> Colors<f64>,
    ) -> Colors<f64> {
        self.average_of_many(thickness_nm, deviation_nm, &mut |thicknesses, found| {
            for (found, t) in found.iter_mut().zip(thicknesses) {
                *found = colors(*t);
            }
        })
    }

    /// [`Fringes::average`] of colours that are found for up to [`AT_ONCE`] thicknesses at once.
    pub fn average_of_many(
        &self,
        thickness_nm: f64,
        deviation_nm: f64,
        colors: &mut ColorsOfMany<'_>,
    ) -> Colors<f64> {
        let [least, greatest] = self.range;
        let beyond = BEYOND * deviation_nm;
        let centre = thickness_nm.clamp(least - beyond, greatest + beyond);
        let nearest = centre.clamp(least, greatest);
        let from = least.max(nearest - REACH * deviation_nm);
        let to = greatest.min(nearest + REACH * deviation_nm);
        let mut found = [Colors::default(); AT_ONCE];
        if from >= to {
            colors(&[nearest], &mut found[..1]);
            return found[0];
        }
        let exponent = |t: f64| {
            let distance = (t - centre) / deviation_nm;
            -0.5 * distance * distance
        };
        let top = exponent(nearest);
        let coherent = COHERENT_NM * self.period / FRINGE_NM;
        let shortest = (to - from) / MOST_PANELS;
        let (mut sum, mut total) = (Colors::<f64>::default(), 0.0);
        let (mut nodes, mut weights, mut count) = ([0.0; AT_ONCE], [0.0; AT_ONCE], 0);
        let mut start = from;
        while start < to {
            let fringe = self.period / PANELS * (start / coherent).max(1.0);
            let thin = (THIN_PART * start).max(THINNEST_NM);
            let width = fringe.min(PART * deviation_nm).min(thin).max(shortest);
            // A rest that is shorter than half a panel joins the last one.
            let end = if start + 1.5 * width >= to {
                to
            } else {
                start + width
            };
            let half = 0.5 * (end - start);
            for (x, weight) in GAUSS {
                let t = start + half * (1.0 + x);
                nodes[count] = t;
                weights[count] = half * weight * (exponent(t) - top).exp();
                count += 1;
            }
            start = end;
            if count == AT_ONCE || start >= to {
                colors(&nodes[..count], &mut found[..count]);
                for (found, weight) in found[..count].iter().zip(weights) {
                    for channel in 0..3 {
                        sum.reflectance[channel] += weight * found.reflectance[channel];
                        sum.transmittance[channel] += weight * found.transmittance[channel];
                    }
                    total += weight;
                }
                count = 0;
            }
        }
        Colors {
            reflectance: sum.reflectance.map(|channel| channel / total),
            transmittance: sum.transmittance.map(|channel| channel / total),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against nodes that miss what happens at once: at grazing angles a film reflects t^2 / (t^2 + w^2) of the light, with
    /// w in proportion to the cosine, and the distribution is cut at 0. The truth is a sum over steps of w / 50 or less.
    #[test]
    fn thin_films_at_grazing_angles_are_averaged() {
        let fringes = Fringes {
            range: [0.0, 1000.0],
            period: FRINGE_NM / 1.33,
        };
        for deviation_nm in [5.0, 50.0, 400.0] {
            for w in [0.3f64, 1.0, 3.0, 10.0, 30.0] {
                for d in [0.0, 40.0, 300.0] {
                    let reflected = |t: f64| t * t / (t * t + w * w);
                    let found = fringes.average(d, deviation_nm, &mut |t| Colors {
                        reflectance: [reflected(t); 3],
                        transmittance: [0.0; 3],
                    });
                    let steps = 200_000;
                    let (mut sum, mut total) = (0.0, 0.0);
                    for i in 0..steps {
                        let t = 1000.0 * (f64::from(i) + 0.5) / f64::from(steps);
                        let weight = (-0.5 * ((t - d) / deviation_nm).powi(2)).exp();
                        sum += weight * reflected(t);
                        total += weight;
                    }
                    let [found, ..] = found.reflectance;
                    let error = (found - sum / total).abs();
                    assert!(error < 1e-4, "{deviation_nm}, {w}, {d}: off by {error}");
                }
            }
        }
    }
}
