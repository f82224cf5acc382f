//! A coordinate that spreads the intervals of the cosine around critical angles.

use super::critical::{Centre, MOST_CENTRES};
use crate::error::Error;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
use crate::num::{Lane, Real};

/// The greatest number of centres of an axis, with [`Centre::GRAZING`].
const MOST: usize = MOST_CENTRES + 1;
/// The least cosine in a layer by which fringes are made upright.
const LEAST_UPRIGHT: f64 = 0.2;
const HALVINGS: usize = 60;

/// Maps cosines in [0, 1] to [0, 1]. Around a critical cosine c0 the colours change within a width w, and far from it
/// they are smooth functions of the root of v = c - c0, as Fresnel's amplitudes are. The coordinate is the sum of
///
/// ```text
/// sign(v) log(1 + t + t^2 / 2)     t = 4 |v| / w
/// ```
///
/// over all critical cosines: its steps are in proportion to v, and so to the root of v, from w on. Two derivatives are
/// continuous at v = 0, where the series of the logarithm is t - t^3 / 6. Its computation has neither a root nor a
/// division, see [`smooth_log2`].
#[derive(Clone, Debug)]
pub(super) struct CriticalAxis {
    centres: Box<[Centre]>,
    /// The sum at the cosine 0, and 1 over the difference from that at the cosine 1.
    first: f64,
    scale: f64,
    /// The square of the ratio of the near half-space's index and the varying layer's.
    tilt: f64,
    single: SinglePrecision,
}

/// The axis in single precision. The critical cosines are computed side by side like the channels of a colour, for a
/// single call in one register.
#[derive(Clone, Debug)]
struct SinglePrecision {
    trios: [Trio; MOST.div_ceil(3)],
    first: f32,
    scale: f32,
    tilt: f32,
}

/// Three critical cosines. One that is missing has the factor 0, and adds 0.
#[derive(Clone, Debug)]
struct Trio {
    cosine: <f32 as Lane>::Rgb,
    /// What is left of the cosine: differences from it keep their digits, however small they are.
    rest: <f32 as Lane>::Rgb,
    /// [`Centre::factor`].
    factor: <f32 as Lane>::Rgb,
}

/// A cosine in single precision and what is left of it.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct Cosine<L> {
    value: L,
    rest: L,
}

impl<L: Real> From<L> for Cosine<L> {
    #[inline(always)]
    fn from(value: L) -> Self {
        Self {
            value,
            rest: L::new(0.0),
        }
    }
}

impl Cosine<f32> {
    #[inline(always)]
    pub fn of_f64(cos_theta: f64) -> Self {
        let value = cos_theta as f32;
        Self {
            value,
            rest: (cos_theta - f64::from(value)) as f32,
        }
    }

    #[inline(always)]
    pub fn to_f64(self) -> f64 {
        f64::from(self.value) + f64::from(self.rest)
    }
}

impl<L: Real> Cosine<L> {
    /// The cosine, rounded.
    #[inline(always)]
    pub fn value(self) -> L {
        self.value
    }

    /// [`spread_out`] around a critical cosine.
    #[inline(always)]
    fn spread_out(self, value: L, rest: L, factor: L) -> L {
        spread_out((self.value - value) + (self.rest - rest), factor)
    }
}

/// The coordinate around a critical cosine at a distance from it.
#[inline(always)]
fn spread_out<T: Real>(v: T, factor: T) -> T {
    // Written so that few operations wait for each other, as in smooth_log2: t is sqrt(2) s.
    let s = (v * factor).abs();
    let log = smooth_log2(s * s + (s * T::new(std::f64::consts::SQRT_2) + T::new(1.0)));
    T::select(v.lt(T::new(0.0)), -log, log)
}

/// The logarithm to base 2 of a number of at least 1, with an error of 1.1e-4 and a slope that is off by 6e-4.
///
/// What counts is not the error, since tables are filled by the same function, but that it is as smooth as a logarithm:
/// the polynomial is the one of least squares whose value and first two derivatives meet at the powers of two, and whose
/// second derivative at 1 is minus the first.
#[inline(always)]
fn smooth_log2<T: Real>(x: T) -> T {
    let (mantissa, exponent) = x.split();
    let f = mantissa - T::new(1.0);
    let low = T::new(1.442_366_214_514_556_7) + T::new(-0.721_183_107_257_278_2) * f;
    let high = T::new(0.492_936_859_565_041_3) + T::new(-0.394_689_524_246_875_7) * f;
    let square = f * f;
    let high = high + T::new(0.226_996_163_933_671_3) * square;
    (exponent + f * low) + (f * square) * high
}

impl CriticalAxis {
    pub fn new(centres: &[Centre], tilt: f64) -> Self {
        let sum = |cos_theta: f64| -> f64 {
            let each = centres.iter();
            each.map(|centre| centre.coordinate(cos_theta)).sum()
        };
        let first = sum(0.0);
        let scale = 1.0 / (sum(1.0) - first);
        Self {
            centres: centres.into(),
            first,
            scale,
            tilt,
            single: SinglePrecision {
                trios: std::array::from_fn(|i| Trio::new(centres.get(3 * i..).unwrap_or(&[]))),
                first: first as f32,
                scale: scale as f32,
                tilt: tilt as f32,
            },
        }
    }

    /// Whether both axes have the same coordinates.
    pub fn is_like(&self, other: &Self) -> bool {
        self.centres == other.centres && self.tilt == other.tilt
    }

    /// The number of critical angles.
    pub fn centres(&self) -> usize {
        self.centres.len()
    }

    pub fn save(&self, block: &mut ByteWriter) {
        let Self {
            centres,
            first: _,
            scale: _,
            tilt,
            single: _,
        } = self;
        block.count(centres.len());
        for Centre { cosine, width } in centres {
            block.numbers(&[*cosine, *width]);
        }
        block.numbers(&[*tilt]);
    }

    /// Reads an axis.
    pub fn load(block: &mut ByteReader<'_>) -> Result<Self, Error> {
        let count = block.count(size_of::<[f64; 2]>(), MOST)?;
        if count == 0 {
            return Err(unusable("an axis has no centre"));
        }
        let mut centres = Error::reserve(count, "a film's axis")?;
        for _ in 0..count {
            centres.push(Centre {
                cosine: block.number_within("a critical cosine", [0.0, 1.0])?,
                width: block.number_within("the width of a critical angle", [1e-9, 1.0])?,
            });
        }
        // The square of a ratio of two indices.
        let tilt = block.number_within("the tilt of an axis", [0.0, 1e12])?;
        Ok(Self::new(&centres, tilt))
    }

    /// The coordinate of a cosine.
    pub fn coordinate(&self, cos_theta: f64) -> f64 {
        let each = self.centres.iter();
        let sum: f64 = each.map(|centre| centre.coordinate(cos_theta)).sum();
        (sum - self.first) * self.scale
    }

    /// The coordinate of a cosine, in single precision.
    #[inline(always)]
    pub fn coordinate_lanes<L: Lane<Scalar = f32>>(&self, cosine: Cosine<L>) -> L {
        let [first, second] = &self.single.trios;
        let mut sum = first.sum(cosine, self.centres.len());
        if let Some(others @ 1..) = self.centres.len().checked_sub(3) {
            sum = sum + second.sum(cosine, others);
        }
        (sum - L::splat(self.single.first)) * L::splat(self.single.scale)
    }

    /// The cosine of a coordinate.
    pub fn cosine(&self, x: f64) -> f64 {
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.coordinate(middle) < x {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The cosine in the layer that varies, at least [`LEAST_UPRIGHT`]: fringes lie along constant products of it and
    /// the thickness.
    pub fn upright(&self, cos_theta: f64) -> f64 {
        upright(cos_theta, self.tilt)
    }

    /// [`CriticalAxis::upright`], in single precision.
    #[inline(always)]
    pub fn upright_lanes<L: Lane<Scalar = f32>>(&self, cosine: Cosine<L>) -> L {
        upright(cosine.value, L::splat(self.single.tilt))
    }
}

#[inline(always)]
fn upright<T: Real>(cos_theta: T, tilt: T) -> T {
    let one = T::new(1.0);
    let squared = one - tilt * (one - cos_theta * cos_theta);
    squared.max(T::new(LEAST_UPRIGHT * LEAST_UPRIGHT)).sqrt()
}

impl Centre {
    /// t / sqrt(2) for a distance of 1.
    fn factor(&self) -> f64 {
        2.0 * std::f64::consts::SQRT_2 / self.width
    }

    fn coordinate(&self, cos_theta: f64) -> f64 {
        spread_out(cos_theta - self.cosine, self.factor())
    }
}

impl Trio {
    /// Of the first three centres.
    fn new(centres: &[Centre]) -> Self {
        let each = |number: &dyn Fn(&Centre) -> f64| {
            let numbers = std::array::from_fn(|i| centres.get(i).map_or(0.0, number) as f32);
            f32::rgb(numbers)
        };
        Self {
            cosine: each(&|centre| centre.cosine),
            rest: each(&|centre| centre.cosine - f64::from(centre.cosine as f32)),
            factor: each(&|centre| centre.factor()),
        }
    }

    /// The sum over the first `count` centres, of at most three.
    #[inline(always)]
    fn sum<L: Lane<Scalar = f32>>(&self, cosine: Cosine<L>, count: usize) -> L {
        let [value, rest, factor] = [
            L::splat_rgb(self.cosine),
            L::splat_rgb(self.rest),
            L::splat_rgb(self.factor),
        ];
        if L::COUNT == 1 {
            let v = (cosine.value.gray() - value) + (cosine.rest.gray() - rest);
            let [a, b, c] = L::channels(spread_out(v, factor));
            return (a + b) + c;
        }
        // In lanes centres follow each other, and missing ones are left out.
        let [values, rests, factors] = [L::channels(value), L::channels(rest), L::channels(factor)];
        let first = cosine.spread_out(values[0], rests[0], factors[0]);
        if count == 1 {
            return first;
        }
        let two = first + cosine.spread_out(values[1], rests[1], factors[1]);
        if count == 2 {
            return two;
        }
        two + cosine.spread_out(values[2], rests[2], factors[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a logarithm that has kinks: it is close to the true one, and so are two derivatives, by differences across
    /// the powers of two and between them.
    #[test]
    fn the_logarithm_is_smooth() {
        const STEP: f64 = 1e-4;
        for i in 0..4000 {
            let x = (f64::from(i) * 2e-3).exp2();
            let [before, here, after] = [-STEP, 0.0, STEP].map(|t| smooth_log2(x * (1.0 + t)));
            assert!((here - x.log2()).abs() < 1.2e-4, "{x}: {here}");
            let slope = (after - before) / (2.0 * STEP) * std::f64::consts::LN_2;
            assert!((slope - 1.0).abs() < 1e-3, "{x}: slope {slope}");
            let bend = (after + before - 2.0 * here) / STEP.powi(2) * std::f64::consts::LN_2;
            assert!((bend + 1.0).abs() < 2e-2, "{x}: second derivative {bend}");
        }
    }

    /// Against a wrong coordinate in single precision, and a wrong inverse: both coordinates agree at every cosine, also
    /// closer to a critical one than single precision tells cosines apart, and the cosine of a coordinate is the
    /// cosine.
    #[test]
    fn coordinates_agree() {
        let centre = |cosine: f64, width: f64| Centre { cosine, width };
        let all = [
            centre(0.75, 1e-3),
            centre(0.3, 1e-7),
            centre(1.0 / 3.0, 2e-2),
            centre(0.9, 1e-5),
            Centre::GRAZING,
        ];
        for count in 1..=all.len() {
            let axis = CriticalAxis::new(&all[..count], 0.5);
            let near = all[..count].iter().flat_map(|centre| {
                let distances = [0.0, 1e-9, 3e-8, 1e-6, 1e-4];
                distances.map(|v| [centre.cosine - v, centre.cosine + v])
            });
            let scattered = (0..=50).map(|i| f64::from(i) / 50.0);
            let mut last = (0.0, 0.0);
            let mut cosines: Vec<f64> = near.flatten().chain(scattered).collect();
            cosines.retain(|c| (0.0..=1.0).contains(c));
            cosines.sort_by(f64::total_cmp);
            for c in cosines {
                let x = axis.coordinate(c);
                assert!((-1e-12..=1.0 + 1e-12).contains(&x) && x >= last.1);
                let found = axis.coordinate_lanes(Cosine::<f32>::of_f64(c));
                assert!((f64::from(found) - x).abs() < 5e-7, "{c}: {found}, not {x}");
                assert!((axis.cosine(x) - c).abs() < 1e-9, "{c}: {}", axis.cosine(x));
                last = (c, x);
            }
        }
    }
}
