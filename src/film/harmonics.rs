//! Fourier series of the fringes.

use super::layer::{Line, pack, pack_lines, phasor};
use super::{Method, Number, OneLayer, check_size, held};
use crate::error::Error;
use crate::num::{Lane, Mask, PI, Real, Rgb};
use crate::optics::stack::{P, S};
use crate::optics::{
    ChannelWeights, ColorSpace, Complex, RGB_WAVELENGTHS_NM, VISIBLE_NM, matching_functions,
};

/// The greatest order of the series.
pub const MAX_ORDER: usize = 16;
/// The step of the table, nm of path difference: sixty to the fastest turn of the demodulated
/// transform, (1 / 380 - 1 / 780) / 2 per nm.
const TABLE_STEP_NM: f64 = 24.0;
/// From here on the transform counts as 0: fringes finer than 1 / 40 of the visible range.
const TABLE_END_NM: f64 = 36_000.0;
/// Steps of the integrals over the visible range.
const STEPS: usize = 2000;
/// With |r01 r12 E|^2 above this the series does not converge.
const RESONANT: f64 = 0.9999;

/// |C(1)|^2 of a function between 0 and 1 is at most 1 / pi^2, here with room for rounding. Films
/// that exceed it absorb so much that E's phase and modulus are not independent.
const GREATEST_FIRST_SQUARED: f64 = 1.01 / (PI * PI);

/// How the Fourier transform of the sensitivity curves is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sensitivity {
    /// One Gaussian in wavenumber each for y and z, two for x, parted at its minimum, with the
    /// moments of the curves under the white.
    Gaussian,
    /// A table of the transform, with cubic interpolation.
    Tabulated,
}

/// Belcour & Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying
/// Iridescence", eq. 6-10: the reflectance as a Fourier series in the phase of the film, whose terms
/// are integrated over the spectrum by the Fourier transform S of the channels' sensitivities,
///
/// ```text
/// R = C0 + 2 Re sum over m = 1, 2, ... of C(m) S(m path)      path = 2 q d
/// C0 = |r01|^2 + |h|^2 / (1 - |g|^2)                          h = (1 - r01^2) r12 |E|
/// C(m) = (-g)^(m - 1) (conj(r01) h - g |h|^2 / (1 - |g|^2))   g = r01 r12 |E|
/// ```
///
/// per polarisation, with complex amplitudes, so that the phases of metals and of total reflection
/// are in C(m), and absorbing films damp E. Indices (and damping) are those at 645, 525 and 445 nm,
/// one for each channel: dispersion within a channel is left out.
///
/// Cost: Fresnel amplitudes for three channels; per order one phase and a table look-up or four
/// Gaussians, shared by the polarisations.
///
/// Fails where |g| is large, at grazing angles and on metals: the series is cut off. At
/// thickness 0 it is not the bare base, but off by the terms left out, 2 |C(1)| |g|^N / (1 - |g|).
/// Gaussians add their misfit, a few per cent of the fringes. Evaluated at the three wavelengths
/// instead, as [`AiryRgb`](super::AiryRgb) does: a film in which waves decay faster than they
/// oscillate, one that equals a neighbour (the bare base), and absorbing films with |g| near 1 or
/// |C(1)| above 1 / pi (metals).
#[derive(Clone, Debug)]
pub struct Harmonics<T: Lane> {
    line: Line<T::Rgb>,
    order: usize,
    transform: Transform<T>,
}

/// The transform of the channels' sensitivities.
#[derive(Clone, Debug)]
enum Transform<T: Lane> {
    Gaussian([Gaussian<T::Rgb>; 4]),
    /// Per path difference the three channels, demodulated by `CARRIER`.
    Table(Box<[Rgb<Complex<T>>]>),
}

/// The transform of a normal distribution: exp(-falloff path^2) exp(2 pi i mean path).
#[derive(Clone, Copy, Debug)]
struct Gaussian<R> {
    /// Its part in each channel.
    parts: R,
    /// Per nm.
    mean: R,
    /// 2 pi^2 variance, per nm^2.
    falloff: R,
}

/// The wavenumber that the table is demodulated by: the middle of the visible range, per nm.
const CARRIER: f64 = 0.5 * (1.0 / VISIBLE_NM[0] + 1.0 / VISIBLE_NM[1]);

impl<T: Number> Harmonics<T> {
    /// For a film, up to an order of 1 to [`MAX_ORDER`].
    pub fn new(layer: &OneLayer, sensitivity: Sensitivity, order: usize) -> Result<Self, Error> {
        check_size("order", order, MAX_ORDER)?;
        let lines = RGB_WAVELENGTHS_NM.map(|nm| Line::at(layer, nm));
        let transform = match sensitivity {
            Sensitivity::Gaussian => Transform::Gaussian(gaussians::<T>(layer)),
            Sensitivity::Tabulated => Transform::Table(table::<T>(layer)),
        };
        Ok(Self {
            line: pack_lines::<T>(lines),
            order,
            transform,
        })
    }
}

/// The middles of equal steps in wavelength, nm.
fn wavelengths() -> impl Iterator<Item = f64> {
    let step = (VISIBLE_NM[1] - VISIBLE_NM[0]) / STEPS as f64;
    (0..STEPS).map(move |i| VISIBLE_NM[0] + (i as f64 + 0.5) * step)
}

fn table<T: Number>(layer: &OneLayer) -> Box<[Rgb<Complex<T>>]> {
    let weights = ChannelWeights::new(layer.white, layer.space);
    let samples: Vec<_> = wavelengths()
        .map(|nm| (1.0 / nm - CARRIER, weights.at(nm)))
        .collect();
    let white: Rgb<f64> = std::array::from_fn(|c| samples.iter().map(|(_, w)| w[c]).sum());
    // One entry before 0 and two beyond the end, for the interpolation.
    let count = (TABLE_END_NM / TABLE_STEP_NM) as usize + 4;
    let entry = |i: usize| {
        let path = (i as f64 - 1.0) * TABLE_STEP_NM;
        let mut sums = [Complex::real(0.0); 3];
        for &(sigma, w) in &samples {
            let wave = phasor(sigma * path);
            for c in 0..3 {
                sums[c] = sums[c] + wave.scaled(w[c] / white[c]);
            }
        }
        sums.map(|z: Complex<f64>| Complex::new(T::new(z.re), T::new(z.im)))
    };
    (0..count).map(entry).collect()
}

fn gaussians<T: Number>(layer: &OneLayer) -> [Gaussian<T::Rgb>; 4] {
    let samples: Vec<_> = wavelengths()
        .map(|nm| {
            let power = layer.white.power(nm);
            (nm, matching_functions(nm).map(|value| value * power))
        })
        .collect();
    // x falls to its minimum between its maxima, near 445 and 600 nm.
    let valley = samples
        .iter()
        .filter(|(nm, _)| (445.0..600.0).contains(nm))
        .min_by(|a, b| a.1[0].total_cmp(&b.1[0]))
        .map_or(504.0, |(nm, _)| *nm);
    let rows = ColorSpace::rows(layer.space);
    let whole = |i: usize| samples.iter().map(|(_, xyz)| xyz[i]).sum::<f64>();
    let wholes = [0, 1, 2].map(whole);
    let white = rows.map(|row| (0..3).map(|i| row[i] * wholes[i]).sum::<f64>());
    // The curve, and the wavelengths of it.
    let pieces = [
        (0, VISIBLE_NM[0], valley),
        (0, valley, VISIBLE_NM[1]),
        (1, VISIBLE_NM[0], VISIBLE_NM[1]),
        (2, VISIBLE_NM[0], VISIBLE_NM[1]),
    ];
    pieces.map(|(curve, from, to)| {
        let piece = samples.iter().filter(|(nm, _)| (from..to).contains(nm));
        let (mut mass, mut first, mut second) = (0.0, 0.0, 0.0);
        for (nm, xyz) in piece {
            let (sigma, w) = (1.0 / nm, xyz[curve]);
            mass += w;
            first += w * sigma;
            second += w * sigma * sigma;
        }
        let mean = first / mass;
        let variance = second / mass - mean * mean;
        let parts: [f64; 3] = std::array::from_fn(|c| rows[c][curve] * mass / white[c]);
        Gaussian {
            parts: pack::<T>(parts),
            mean: pack::<T>([mean; 3]),
            falloff: pack::<T>([2.0 * PI * PI * variance; 3]),
        }
    })
}

impl<T: Number> Transform<T> {
    /// At a path difference (nm) per channel.
    #[inline(always)]
    fn at(&self, path: T::Rgb) -> Complex<T::Rgb> {
        match self {
            Self::Gaussian(gaussians) => {
                let mut sum = Complex::real(T::Rgb::new(0.0));
                for gaussian in gaussians {
                    let fall = (-(gaussian.falloff * path * path)).exp();
                    sum = sum + phasor(gaussian.mean * path).scaled(fall * gaussian.parts);
                }
                sum
            }
            Self::Table(table) => {
                let position = path * T::Rgb::new(1.0 / TABLE_STEP_NM);
                let entries = T::channels(position);
                let found: [Complex<T>; 3] =
                    std::array::from_fn(|c| interpolated(table, entries[c], c));
                let found = Complex::new(T::rgb(found.map(|z| z.re)), T::rgb(found.map(|z| z.im)));
                found * phasor(path * T::Rgb::new(CARRIER))
            }
        }
    }
}

/// Between the middle two of four entries, meeting them with a continuous derivative (Catmull & Rom
/// 1974).
#[inline(always)]
fn interpolated<T: Number>(table: &[Rgb<Complex<T>>], position: T, c: usize) -> Complex<T> {
    let last = TABLE_END_NM / TABLE_STEP_NM;
    if !position.lt(T::new(last)).any() {
        return Complex::real(T::new(0.0));
    }
    let index = position.floor_to_index();
    let t = position - T::new(index as f64);
    let [a, b, c, d] = [0, 1, 2, 3].map(|step| table[index + step][c]);
    let half = T::new(0.5);
    let linear = c - a;
    let square = a.scaled(T::new(2.0)) - b.scaled(T::new(5.0)) + c.scaled(T::new(4.0)) - d;
    let cube = (b - c).scaled(T::new(3.0)) + d - a;
    b + (linear + (square + cube.scaled(t)).scaled(t)).scaled(t * half)
}

impl<T: Number> Method<T> for Harmonics<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let (cos_theta, thickness_nm) = held(cos_theta, thickness_nm);
        let (zero, half, two) = (T::Rgb::new(0.0), T::Rgb::new(0.5), T::Rgb::new(2.0));
        let waves = self.line.waves(cos_theta);
        let (_, loss) = self.line.round_trip(&waves, thickness_nm);
        let q = waves.film[S];
        let path = q.re * thickness_nm * two;
        let mut is_point = q.re.le(q.im) | self.line.wavenumber.le(zero);
        // The constant term, and per polarisation the first harmonic's amplitude and -g.
        let mut sum = zero;
        let terms = [S, P].map(|pol| {
            let series = waves.amplitudes(pol).series(loss);
            let g = series.g;
            let is_resonant = series.g_loss.le(zero)
                | (g.norm_squared().gt(T::Rgb::new(RESONANT)) & loss.gt(zero));
            is_point = is_point | is_resonant;
            let (incoherent, first) = series.harmonics(is_resonant);
            sum = sum + incoherent;
            is_point = is_point | first.norm_squared().gt(T::Rgb::new(GREATEST_FIRST_SQUARED));
            (first, -g)
        });
        let [(mut s, s_factor), (mut p, p_factor)] = terms;
        for m in 1..=self.order {
            let transform = self.transform.at(path * T::Rgb::new(m as f64));
            let both = s + p;
            sum = sum + two * (both.re * transform.re - both.im * transform.im);
            (s, p) = (s * s_factor, p * p_factor);
        }
        let series = sum * half;
        if !is_point.any() {
            return T::channels(series);
        }
        let point = self.line.reflectance(&waves, thickness_nm);
        T::channels(T::Rgb::select(is_point, point, series))
    }
}
