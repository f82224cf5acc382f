//! All beams, averaged over bands of wavenumber.

use super::compiled_method::CompiledMethod;
use super::info::{MethodInfo, OneLayerCompile};
use super::media::{MediaAtWavelength, Waves, pack, pack_complex, pack_media, phasor, totals};
use super::one_layer::{OneLayer, check_size, clamped};
use crate::error::Error;
use crate::num::{Lane, Mask, PI, Real, Rgb, angle_turns};
use crate::optics::stack::{P, S};
use crate::optics::{ChannelWeights, Complex, VISIBLE_NM};

/// The one method for one layer that a plan chooses unasked: its errors are steady.
pub(super) const INFO: MethodInfo = MethodInfo {
    sizes: &[8, 16, 32, 64, 128, 256],
    cost_ns: |count| 200.0 + 16.0 * count as f64,
    is_automatic: true,
    ..MethodInfo::one_layer(
        "bands",
        OneLayerCompile {
            single: |layer, count| Ok(Box::new(Bands::new(layer, count)?)),
            double: |layer, count| Ok(Box::new(Bands::new(layer, count)?)),
            work: |count| format!("all reflected beams over {count} bands, 2 arctangents each"),
        },
    )
};

/// The greatest number of bands.
const MAX_BANDS: usize = 256;
/// The number of points per band of the integrals of the weights.
const WEIGHT_STEPS: usize = 256;
/// The reflectance counts as constant across a band in which half the phase changes by fewer turns.
const FLAT_TURNS: f64 = 1e-3;
/// Where 1 - |r01 r12 E|^2 is below this, in films that absorb, the closed form is not used.
const RESONANT: f64 = 1e-4;
/// Where |r01 r12 E|^2 is below this, two terms of the logarithm's series are used.
const FAINT: f64 = 1e-6;

/// The exact reflectance averaged in closed form over K bands of equal width in wavenumber; the weights
/// are the integrals of the channels over each band. Our own: any number of fringes in a band is
/// integrated exactly, so that thick films tend to the incoherent limit.
///
/// With psi the phase of g E, g = r01 r12, a film that does not absorb transmits (Airy 1833), per
/// polarisation,
///
/// ```text
/// T(psi) = (1 - |r01|^2) (1 - |r12|^2) / |1 + g E|^2
/// ```
///
/// a Poisson kernel. Its mean over \[psi - D, psi + D\] is the incoherent one,
/// (1 - |r01|^2) (1 - |r12|^2) / (1 - |g|^2), times A / D, where A is the angle of the vector
/// ((1 + |g|^2) cos D + 2 Re(g E), (1 - |g|^2) sin D), E at the middle, plus the whole turns that bring
/// it next to D. A film that absorbs has, with |E| taken at the middle of the band,
///
/// ```text
/// R = |r01|^2 + |h|^2 / (1 - |g|^2) + 2 Re(C mean(z / (1 + g z)))    h = (1 - r01^2) r12 |E|
/// C = conj(r01) h - g |h|^2 / (1 - |g|^2)                            z = E / |E|, g with |E|
/// ```
///
/// and since z / (1 + g z) is the derivative of ln(1 + g z) / (i g) with respect to the phase, its
/// mean is a quotient of differences. Dispersion enters by the indices at the middle of each band
/// and, in the width D, by their change across it.
///
/// Cost: per three bands, in lanes, a phase and two arctangents. With dispersion the width's phase and
/// Fresnel's amplitudes, which are otherwise the same for all bands, are added; in an absorbing film two
/// more phases, two logarithms and the reflectance at the middle.
///
/// The error falls as 1 / K^2, because a channel's weight, the extinction of the film and Fresnel's
/// amplitudes count as constant within a band. A film so thin that its phase changes by less than
/// 1 / 500 of a turn across a band is evaluated at the band's middle; at thickness 0 this is the bare
/// base. So are evanescent films, and absorbing ones where |g| is near 1 or, with surface waves, above.
#[derive(Clone, Debug)]
struct Bands<T: Lane> {
    bands: Box<[ThreeBands<T::Rgb>]>,
    is_constant: bool,
}

/// Three bands side by side.
#[derive(Clone, Copy, Debug)]
struct ThreeBands<R> {
    /// The media at the middle of each band.
    media: MediaAtWavelength<R>,
    /// The width in wavenumber, per nm; 0 if the film equals a neighbour.
    width: R,
    /// Half the change of n1^2 - n0^2 across the band.
    film_change: Complex<R>,
    /// Half the change of n0^2 across the band.
    ambient_change: R,
    weights: [R; 3],
}

/// The amplitudes of a polarisation's fringes.
#[derive(Clone, Copy, Debug)]
struct FringeAmplitudes<R> {
    /// g = r01 r12.
    g: Complex<R>,
    /// |g|^2.
    g_squared: R,
    /// 1 - |g|^2.
    g_loss: R,
    /// The incoherent transmittance.
    mean: R,
}

/// The change of E's phase across half a band.
#[derive(Clone, Copy, Debug)]
struct HalfBandPhase<R> {
    /// In turns.
    turns: R,
    /// 1 / turns; 1 where the reflectance counts as constant.
    inverse: R,
    /// exp(2 pi i turns)
    edge: Complex<R>,
}

impl<T: Lane> Bands<T> {
    /// The method with 1 to 256 bands.
    fn new(layer: &OneLayer, count: usize) -> Result<Self, Error> {
        check_size("bands", count, MAX_BANDS)?;
        let weights = ChannelWeights::new(layer.white, layer.space);
        let [first, last] = [VISIBLE_NM[1], VISIBLE_NM[0]].map(|nm| 1.0 / nm);
        let width = (last - first) / count as f64;
        let edge = |k: usize| first + width * k as f64;
        let mut shares: Vec<Rgb<f64>> = (0..count)
            .map(|k| share(&weights, edge(k), width))
            .collect();
        let white: [f64; 3] = std::array::from_fn(|c| shares.iter().map(|s| s[c]).sum());
        for share in &mut shares {
            *share = std::array::from_fn(|c| share[c] / white[c]);
        }
        let bands = (0..count.div_ceil(3)).map(|group| {
            // Bands of weight 0 fill up the last three.
            let k = [0, 1, 2].map(|lane| (3 * group + lane).min(count - 1));
            let share =
                [0, 1, 2].map(|lane| shares.get(3 * group + lane).copied().unwrap_or([0.0; 3]));
            let media = k.map(|k| MediaAtWavelength::at(layer, 1.0 / (edge(k) + 0.5 * width)));
            let changes = k.map(|k| {
                let [a, b] =
                    [edge(k), edge(k + 1)].map(|sigma| MediaAtWavelength::at(layer, 1.0 / sigma));
                a.half_change_to(&b)
            });
            let widths = media.map(|media| if media.wavenumber > 0.0 { width } else { 0.0 });
            ThreeBands {
                media: pack_media::<T>(media),
                width: pack::<T>(widths),
                film_change: pack_complex::<T>(changes.map(|(film, _)| film)),
                ambient_change: pack::<T>(changes.map(|(_, ambient)| ambient)),
                weights: std::array::from_fn(|c| pack::<T>(share.map(|w| w[c]))),
            }
        });
        Ok(Self {
            bands: bands.collect(),
            is_constant: layer.is_constant(),
        })
    }
}

/// The integrals of the channels over a band, by the midpoint rule in wavenumber.
fn share(weights: &ChannelWeights, start: f64, width: f64) -> Rgb<f64> {
    let mut sums = [0.0; 3];
    for i in 0..WEIGHT_STEPS {
        let sigma = start + (i as f64 + 0.5) * width / WEIGHT_STEPS as f64;
        let nm = 1.0 / sigma;
        let at = weights.at(nm);
        for c in 0..3 {
            // d lambda = lambda^2 d sigma
            sums[c] += at[c] * nm * nm;
        }
    }
    sums
}

impl<T: Lane> CompiledMethod<T> for Bands<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let [cos_theta, thickness_nm] = clamped(cos_theta, thickness_nm);
        let zero = T::Rgb::new(0.0);
        let mut waves = self.bands[0].media.waves(cos_theta);
        let mut fringes = [S, P].map(|pol| FringeAmplitudes::new(&waves, pol));
        let mut phase = self.bands[0].half_band_phase(&waves, cos_theta, thickness_nm);
        let mut sums = [zero; 3];
        for (i, group) in self.bands.iter().enumerate() {
            if i > 0 && !self.is_constant {
                waves = group.media.waves(cos_theta);
                fringes = [S, P].map(|pol| FringeAmplitudes::new(&waves, pol));
                phase = group.half_band_phase(&waves, cos_theta, thickness_nm);
            }
            let q = waves.film[S];
            let mean = if q.im.gt(zero).any() {
                group.absorbing(&waves, cos_theta, thickness_nm)
            } else {
                group.transparent(&waves, &fringes, &phase, thickness_nm)
            };
            for (sum, weight) in sums.iter_mut().zip(group.weights) {
                *sum = *sum + mean * weight;
            }
        }
        totals(sums)
    }
}

impl<R: Real> FringeAmplitudes<R> {
    #[inline(always)]
    fn new(waves: &Waves<R>, pol: usize) -> Self {
        let amplitudes = waves.amplitudes(pol);
        let g = amplitudes.top * amplitudes.bottom;
        // 1 - |r01 r12|^2 from the losses of both interfaces, which keep their digits where |g| is near 1.
        let (above, below) = (amplitudes.top_loss, amplitudes.bottom_loss);
        let g_loss = above + amplitudes.top.norm_squared() * below;
        let is_lost = g_loss.gt(R::new(0.0));
        let quotient = above * below / R::select(is_lost, g_loss, R::new(1.0));
        Self {
            g,
            g_squared: g.norm_squared(),
            g_loss,
            mean: R::select(is_lost, quotient, R::new(0.0)),
        }
    }
}

impl<R: Real> ThreeBands<R> {
    /// Half the change of E's phase across the band, in turns: d q sigma between the edges.
    #[inline(always)]
    fn half_turns(&self, waves: &Waves<R>, cos_theta: R, thickness_nm: R) -> R {
        let q = waves.film[S];
        let zero = R::new(0.0);
        let change = self.film_change + Complex::real(self.ambient_change * cos_theta * cos_theta);
        let norm = q.norm_squared();
        let is_zero = norm.le(zero);
        // q changes by change(q^2) / (2 q); half the change of the square on both sides.
        let slope = (change.re * q.re + change.im * q.im) / R::select(is_zero, R::new(1.0), norm);
        let dispersion = R::select(is_zero, zero, self.media.wavenumber * slope);
        ((q.re * self.width + dispersion) * thickness_nm).abs()
    }

    /// The change of phase that the mean for a transparent film needs.
    #[inline(always)]
    fn half_band_phase(&self, waves: &Waves<R>, cos_theta: R, thickness_nm: R) -> HalfBandPhase<R> {
        let one = R::new(1.0);
        let turns = self.half_turns(waves, cos_theta, thickness_nm);
        let is_flat = turns.lt(R::new(FLAT_TURNS));
        HalfBandPhase {
            turns,
            inverse: one / R::select(is_flat, one, turns),
            edge: phasor(turns),
        }
    }

    /// The mean over the band for a transparent film.
    #[inline(always)]
    fn transparent(
        &self,
        waves: &Waves<R>,
        fringes: &[FringeAmplitudes<R>; 2],
        phase: &HalfBandPhase<R>,
        thickness_nm: R,
    ) -> R {
        let (half, one, two) = (R::new(0.5), R::new(1.0), R::new(2.0));
        let (turns, _) = self.media.round_trip(waves, thickness_nm);
        let e = phasor(turns);
        let [s, p] = [S, P].map(|pol| {
            let fringe = &fringes[pol];
            let ge = fringe.g.re * e.re - fringe.g.im * e.im;
            let across = fringe.g_loss * phase.edge.im;
            let along = (one + fringe.g_squared) * phase.edge.re + two * ge;
            let angle = angle_turns(across, along);
            let angle = angle + (phase.turns - angle).round();
            one - fringe.mean * angle * phase.inverse
        });
        let mean = (s + p) * half;
        let is_flat = phase.turns.lt(R::new(FLAT_TURNS));
        if !is_flat.any() {
            return mean;
        }
        R::select(is_flat, self.media.reflectance(waves, thickness_nm), mean)
    }

    /// The mean over the band for a film that absorbs, or is evanescent, in one of the three bands.
    #[inline(never)]
    fn absorbing(&self, waves: &Waves<R>, cos_theta: R, thickness_nm: R) -> R {
        let (zero, half, one, two) = (R::new(0.0), R::new(0.5), R::new(1.0), R::new(2.0));
        let (turns, loss) = self.media.round_trip(waves, thickness_nm);
        let width = self.half_turns(waves, cos_theta, thickness_nm);
        let is_flat = width.lt(R::new(FLAT_TURNS));
        let width = R::select(is_flat, one, width);
        let z = phasor(turns);
        let (edge, double) = (phasor(width), phasor(width * two));
        let point = self.media.reflectance(waves, thickness_nm);
        let [s, p] = [S, P].map(|pol| {
            let series = waves.amplitudes(pol).series(loss);
            let (g, g_loss) = (series.g, series.g_loss);
            let g_squared = g.norm_squared();
            let is_resonant = g_loss.lt(R::new(RESONANT));
            let is_point = is_flat | is_resonant;
            let (incoherent, d) = series.harmonics(is_resonant);

            // ln of the quotient of 1 + g z at the edges: its modulus from the difference of their
            // squares, its angle from the product of one with the other's conjugate.
            let g_z = g * z;
            let lower = one + two * (g_z.re * edge.re + g_z.im * edge.im) + g_squared;
            // It is at least (1 - |g|)^2 and so at least (1 - |g|^2)^2 / 4.
            let lower = lower.max(g_loss * g_loss * R::new(0.25));
            let lower = R::select(is_resonant, one, lower);
            let growth = -(R::new(4.0) * edge.im * g_z.im) / lower;
            let across = two * g_z.re * edge.im + g_squared * double.im;
            let along = one + two * g_z.re * edge.re + g_squared * double.re;
            let angle = angle_turns(across, along) * R::new(2.0 * PI);
            let logarithm = Complex::new(half * growth.ln_1p(), angle);
            // mean z / (1 + g z) = ln / (i g times the change of the phase)
            let phase = width * R::new(4.0 * PI);
            let is_faint = g_squared.lt(R::new(FAINT));
            let ig = Complex::new(-g.im, g.re).scaled(phase);
            let safe = Complex::select(is_faint, Complex::real(one), ig);
            let closed = logarithm * safe.inverse();
            // z sin(D) / D - g z^2 sin(2 D) / (2 D), D half the change of the phase.
            let first = z.scaled(two * edge.im / phase);
            let second = (g_z * z).scaled(double.im / phase);
            let mean = Complex::select(is_faint, first - second, closed);
            let ripple = two * (d.re * mean.re - d.im * mean.im);
            let r = incoherent + ripple;
            (r.max(zero).min(one), is_point)
        });
        // Where either polarisation needs the value at the middle, both take it.
        R::select(s.1 | p.1, point, (s.0 + p.0) * half)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::{ColorSpace, Medium, White};

    /// The closed forms against the average of the same reflectance at many wavenumbers, with the
    /// extinction so small that it does not change within a band.
    #[test]
    fn mean_over_a_band_is_that_of_many_wavenumbers() {
        let medium = |eta: f64, k: f64| Medium::rgb([eta; 3], [k; 3]).unwrap();
        let bases = [(1.0, 0.0), (1.33, 0.0), (1.5, 3.0), (2.5, 0.0)];
        for (eta, k) in bases {
            for film_k in [0.0, 1e-8] {
                let (film, base) = (medium(1.5, film_k), medium(eta, k));
                let layer =
                    OneLayer::new(Medium::vacuum(), film, base, White::E, ColorSpace::Rec709)
                        .unwrap();
                let group = Bands::<f64>::new(&layer, 3).unwrap().bands[0];
                let width = (1.0 / VISIBLE_NM[0] - 1.0 / VISIBLE_NM[1]) / 3.0;
                for (cos_theta, d) in [(1.0, 100.0), (0.5, 900.0), (0.1, 3000.0), (0.02, 40.0)] {
                    let [c, t] = clamped::<f64>(cos_theta, d);
                    let waves = group.media.waves(c);
                    let fringes = [S, P].map(|pol| FringeAmplitudes::new(&waves, pol));
                    let found = if film_k > 0.0 {
                        group.absorbing(&waves, c, t)
                    } else {
                        group.transparent(&waves, &fringes, &group.half_band_phase(&waves, c, t), t)
                    };
                    let count = 20_000;
                    let mut sum = 0.0;
                    for i in 0..count {
                        let sigma = 1.0 / VISIBLE_NM[1] + width * (i as f64 + 0.5) / count as f64;
                        let media = MediaAtWavelength::at(&layer, 1.0 / sigma);
                        sum += media.reflectance(&media.waves(cos_theta), d);
                    }
                    let expected = sum / f64::from(count);
                    let found = f64::channels(found)[0];
                    assert!(
                        (found - expected).abs() < 1e-6,
                        "{eta} {k} {film_k} {cos_theta} {d}: {found} {expected}"
                    );
                }
            }
        }
    }
}
