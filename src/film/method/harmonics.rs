//! Fourier series of the fringes.

use super::compiled_method::CompiledMethod;
use super::info::{MethodInfo, OneLayerCompile};
use super::media::{MediaAtWavelength, pack_media, phasor};
use super::one_layer::{OneLayer, check_size, clamped};
use crate::error::Error;
use crate::num::{Lane, Mask, PI, Real, Rgb};
use crate::optics::stack::{P, S};
use crate::optics::{ChannelWeights, Complex, RGB_WAVELENGTHS_NM, VISIBLE_NM};

pub(super) const INFO: MethodInfo = MethodInfo {
    sizes: &[1, 2, 3, 4, 6, 8, 12, 16],
    cost_ns: |order| 55.0 + 28.0 * order as f64,
    ..MethodInfo::one_layer(
        "harmonics",
        OneLayerCompile {
            single: compile,
            double: compile,
            work: |order| format!("{order} harmonics, a table look-up each"),
        },
    )
};

/// The greatest order of the series.
const MAX_ORDER: usize = 16;
/// The step of the table, nm of path difference: a sixtieth of the shortest period of the demodulated
/// transform, 2 / (1 / 380 - 1 / 780) nm.
const TABLE_STEP_NM: f64 = 24.0;
/// From here on the transform counts as 0: fringes finer than 1 / 40 of the visible range.
const TABLE_END_NM: f64 = 36_000.0;
/// The number of steps of the integrals over the visible range.
const STEPS: usize = 2000;
/// With |r01 r12 E|^2 above this the series does not converge.
const RESONANT: f64 = 0.9999;

/// |C(1)|^2 of a function between 0 and 1 is at most 1 / pi^2, here with room for rounding. Films
/// that exceed it absorb so much that E's phase and modulus are not independent.
const GREATEST_FIRST_SQUARED: f64 = 1.01 / (PI * PI);

/// The wavenumber that the table is demodulated by: the middle of the visible range, per nm.
const CARRIER: f64 = 0.5 * (1.0 / VISIBLE_NM[0] + 1.0 / VISIBLE_NM[1]);

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
/// Cost: Fresnel amplitudes for three channels; per order one phase and a look-up in a table of S,
/// shared by the polarisations.
///
/// Fails where |g| is large, at grazing angles and on metals, because the series is truncated. At
/// thickness 0 it differs from the bare base by the terms left out, 2 |C(1)| |g|^N / (1 - |g|). Some
/// films are evaluated at the three wavelengths instead, as in `airy_rgb.rs`: those in which waves decay
/// faster than they oscillate, those that equal a neighbour (the bare base), and absorbing ones with |g|
/// near 1 or |C(1)| above 1 / pi (metals).
struct Harmonics<T: Lane> {
    media: MediaAtWavelength<T::Rgb>,
    order: usize,
    /// S of the three channels at equal steps of the path difference, demodulated by `CARRIER`.
    transform: Box<[Rgb<Complex<T>>]>,
}

/// The method up to an order of 1 to 16.
fn compile<T: Lane + Into<f64>>(
    layer: &OneLayer,
    order: usize,
) -> Result<Box<dyn CompiledMethod<T>>, Error> {
    check_size("order", order, MAX_ORDER)?;
    let media = RGB_WAVELENGTHS_NM.map(|nm| MediaAtWavelength::at(layer, nm));
    Ok(Box::new(Harmonics::<T> {
        media: pack_media::<T>(media),
        order,
        transform: transform::<T>(layer),
    }))
}

/// The middles of equal steps in wavelength, nm.
fn wavelengths() -> impl Iterator<Item = f64> {
    let step = (VISIBLE_NM[1] - VISIBLE_NM[0]) / STEPS as f64;
    (0..STEPS).map(move |i| VISIBLE_NM[0] + (i as f64 + 0.5) * step)
}

/// The table of S.
fn transform<T: Lane>(layer: &OneLayer) -> Box<[Rgb<Complex<T>>]> {
    let weights = ChannelWeights::new(layer.white, layer.space);
    let samples: Vec<_> = wavelengths()
        .map(|nm| (1.0 / nm - CARRIER, weights.at(nm)))
        .collect();
    let white: Rgb<f64> = std::array::from_fn(|c| samples.iter().map(|(_, w)| w[c]).sum());
    // The interpolation needs an entry before 0 and two beyond the end.
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

/// S at a path difference (nm) per channel.
#[inline(always)]
fn transform_at<T: Lane + Into<f64>>(
    transform: &[Rgb<Complex<T>>],
    path: T::Rgb,
) -> Complex<T::Rgb> {
    let position = T::channels(path * T::Rgb::new(1.0 / TABLE_STEP_NM));
    let found: Rgb<Complex<T>> = std::array::from_fn(|c| interpolated(transform, position[c], c));
    let found = Complex::new(T::rgb(found.map(|z| z.re)), T::rgb(found.map(|z| z.im)));
    found * phasor(path * T::Rgb::new(CARRIER))
}

/// A cubic between the middle two of four entries, with continuous derivatives at the entries (Catmull
/// & Rom 1974).
#[inline(always)]
fn interpolated<T: Lane + Into<f64>>(
    table: &[Rgb<Complex<T>>],
    position: T,
    c: usize,
) -> Complex<T> {
    let last = TABLE_END_NM / TABLE_STEP_NM;
    if !position.lt(T::new(last)).any() {
        return Complex::real(T::new(0.0));
    }
    let index = position.into() as usize;
    let t = position - T::new(index as f64);
    let [a, b, c, d] = [0, 1, 2, 3].map(|step| table[index + step][c]);
    let half = T::new(0.5);
    let linear = c - a;
    let square = a.scaled(T::new(2.0)) - b.scaled(T::new(5.0)) + c.scaled(T::new(4.0)) - d;
    let cube = (b - c).scaled(T::new(3.0)) + d - a;
    b + (linear + (square + cube.scaled(t)).scaled(t)).scaled(t * half)
}

impl<T: Lane + Into<f64>> CompiledMethod<T> for Harmonics<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let [cos_theta, thickness_nm] = clamped(cos_theta, thickness_nm);
        let (zero, half, two) = (T::Rgb::new(0.0), T::Rgb::new(0.5), T::Rgb::new(2.0));
        let waves = self.media.waves(cos_theta);
        let (_, loss) = self.media.round_trip(&waves, thickness_nm);
        let q = waves.film[S];
        let path = q.re * thickness_nm * two;
        let mut is_point = q.re.le(q.im) | self.media.wavenumber.le(zero);
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
            let transform = transform_at(&self.transform, path * T::Rgb::new(m as f64));
            let both = s + p;
            sum = sum + two * (both.re * transform.re - both.im * transform.im);
            (s, p) = (s * s_factor, p * p_factor);
        }
        let series = sum * half;
        if !is_point.any() {
            return T::channels(series);
        }
        let point = self.media.reflectance(&waves, thickness_nm);
        T::channels(T::Rgb::select(is_point, point, series))
    }
}
