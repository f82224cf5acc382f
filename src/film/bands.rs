//! All beams, averaged over bands of wavenumber.

use super::layer::{Line, Waves, pack, pack_complex, pack_lines, phasor};
use super::quadrature::totals;
use super::{Method, OneLayer, check_size, held};
use crate::error::Error;
use crate::num::{Lane, Mask, PI, Real, Rgb, angle_turns};
use crate::optics::stack::{P, S};
use crate::optics::{ChannelWeights, Complex, VISIBLE_NM};

/// The greatest number of bands.
const MAX_BANDS: usize = 256;
/// The step of the integrals of the weights, as a part of a band.
const WEIGHT_STEPS: usize = 256;
/// Across a band with fewer turns of half the phase than this, the reflectance counts as constant.
const FLAT_TURNS: f64 = 1e-3;
/// With |r01 r12 E|^2 above 1 less this, in films that absorb, the mean is not in closed form.
const RESONANT: f64 = 1e-4;
/// |r01 r12 E|^2 below which two terms of the logarithm's series are used.
const FAINT: f64 = 1e-6;

/// The exact reflectance averaged in closed form over K bands of equal width in wavenumber, each
/// with the integrals of the channels over it as weights. Our own: fringes, however many lie in a
/// band, are integrated exactly, so that thick films go to the incoherent limit by themselves.
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
/// ((1 + |g|^2) cos D + 2 Re(g E), (1 - |g|^2) sin D), E at the middle, with as many whole turns as
/// bring it next to D. A film that absorbs has, with |E| taken at the middle of the band,
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
/// Cost: per three bands, in lanes, a phase and two arctangents; with dispersion also the width's
/// phase and Fresnel's amplitudes, which are otherwise the same for all bands; in an absorbing film
/// two phases and two logarithms more, and the reflectance at the middle.
///
/// The error falls as 1 / K^2. Fails at what lies within one band: a channel's weight is taken for
/// constant there, as are the extinction of the film and Fresnel's amplitudes. A film so thin that
/// its phase changes by less than 1 / 500 of a turn across a band is evaluated at the band's middle;
/// at thickness 0 this is the bare base. The same holds in an evanescent film, and in absorbing ones
/// where |g| is near 1 or, with surface waves, beyond.
#[derive(Clone, Debug)]
pub struct Bands<T: Lane> {
    bands: Box<[Group<T::Rgb>]>,
    is_constant: bool,
}

/// Three bands side by side.
#[derive(Clone, Copy, Debug)]
struct Group<R> {
    /// At the middle.
    line: Line<R>,
    /// The width in wavenumber, per nm; 0 if the film equals a neighbour.
    width: R,
    /// Half the change across the band of n1^2 - n0^2 and of n0^2.
    film_change: Complex<R>,
    ambient_change: R,
    weights: [R; 3],
}

/// What a polarisation's reflectance consists of, before phases are known.
#[derive(Clone, Copy, Debug)]
struct Fringe<R> {
    /// g = r01 r12.
    g: Complex<R>,
    /// |g|^2, and 1 less it.
    g_squared: R,
    g_loss: R,
    /// The incoherent transmittance.
    mean: R,
}

/// The width of a band for a film.
#[derive(Clone, Copy, Debug)]
struct Span<R> {
    /// Half the change of E's phase, in turns; its inverse, if it is not flat; and the phasor.
    turns: R,
    inverse: R,
    edge: Complex<R>,
}

impl<T: Lane> Bands<T> {
    /// For a film, with 1 to 256 bands.
    pub fn new(layer: &OneLayer, count: usize) -> Result<Self, Error> {
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
            // The last three are filled up with the last band, at weight 0.
            let k = [0, 1, 2].map(|lane| (3 * group + lane).min(count - 1));
            let share =
                [0, 1, 2].map(|lane| shares.get(3 * group + lane).copied().unwrap_or([0.0; 3]));
            let lines = k.map(|k| Line::at(layer, 1.0 / (edge(k) + 0.5 * width)));
            let changes = k.map(|k| {
                let [a, b] = [edge(k), edge(k + 1)].map(|sigma| Line::at(layer, 1.0 / sigma));
                a.half_change_to(&b)
            });
            let is_film = lines.map(|line| if line.wavenumber > 0.0 { width } else { 0.0 });
            Group {
                line: pack_lines::<T>(lines),
                width: pack::<T>(is_film),
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

impl<T: Lane> Method<T> for Bands<T> {
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T> {
        let (cos_theta, thickness_nm) = held(cos_theta, thickness_nm);
        let zero = T::Rgb::new(0.0);
        let mut waves = self.bands[0].line.waves(cos_theta);
        let mut fringes = [S, P].map(|pol| Fringe::new(&waves, pol));
        let mut span = self.bands[0].span(&waves, cos_theta, thickness_nm);
        let mut sums = [zero; 3];
        for (i, group) in self.bands.iter().enumerate() {
            if i > 0 && !self.is_constant {
                waves = group.line.waves(cos_theta);
                fringes = [S, P].map(|pol| Fringe::new(&waves, pol));
                span = group.span(&waves, cos_theta, thickness_nm);
            }
            let q = waves.film[S];
            let mean = if q.im.gt(zero).any() {
                group.absorbing(&waves, cos_theta, thickness_nm)
            } else {
                group.transparent(&waves, &fringes, &span, thickness_nm)
            };
            for (sum, weight) in sums.iter_mut().zip(group.weights) {
                *sum = *sum + mean * weight;
            }
        }
        totals(sums)
    }
}

impl<R: Real> Fringe<R> {
    #[inline(always)]
    fn new(waves: &Waves<R>, pol: usize) -> Self {
        let amplitudes = waves.amplitudes(pol);
        let g = amplitudes.top * amplitudes.bottom;
        // 1 - |r01 r12|^2 from the losses of both, which have all their digits where g has few.
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

impl<R: Real> Group<R> {
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
        let dispersion = R::select(is_zero, zero, self.line.wavenumber * slope);
        ((q.re * self.width + dispersion) * thickness_nm).abs()
    }

    /// What the mean for a transparent film needs of the band's width.
    #[inline(always)]
    fn span(&self, waves: &Waves<R>, cos_theta: R, thickness_nm: R) -> Span<R> {
        let one = R::new(1.0);
        let turns = self.half_turns(waves, cos_theta, thickness_nm);
        let is_flat = turns.lt(R::new(FLAT_TURNS));
        Span {
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
        fringes: &[Fringe<R>; 2],
        span: &Span<R>,
        thickness_nm: R,
    ) -> R {
        let (half, one, two) = (R::new(0.5), R::new(1.0), R::new(2.0));
        let (turns, _) = self.line.round_trip(waves, thickness_nm);
        let e = phasor(turns);
        let [s, p] = [S, P].map(|pol| {
            let fringe = &fringes[pol];
            let ge = fringe.g.re * e.re - fringe.g.im * e.im;
            let across = fringe.g_loss * span.edge.im;
            let along = (one + fringe.g_squared) * span.edge.re + two * ge;
            let angle = angle_turns(across, along);
            let angle = angle + (span.turns - angle).round();
            one - fringe.mean * angle * span.inverse
        });
        let mean = (s + p) * half;
        let is_flat = span.turns.lt(R::new(FLAT_TURNS));
        if !is_flat.any() {
            return mean;
        }
        R::select(is_flat, self.line.reflectance(waves, thickness_nm), mean)
    }

    /// The mean over the band for a film that absorbs, or is evanescent, in some band.
    #[inline(never)]
    fn absorbing(&self, waves: &Waves<R>, cos_theta: R, thickness_nm: R) -> R {
        let (zero, half, one, two) = (R::new(0.0), R::new(0.5), R::new(1.0), R::new(2.0));
        let (turns, loss) = self.line.round_trip(waves, thickness_nm);
        let width = self.half_turns(waves, cos_theta, thickness_nm);
        let is_flat = width.lt(R::new(FLAT_TURNS));
        let width = R::select(is_flat, one, width);
        let z = phasor(turns);
        let (edge, double) = (phasor(width), phasor(width * two));
        let point = self.line.reflectance(waves, thickness_nm);
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
            // At least (1 - |g|)^2 and so (1 - |g|^2)^2 / 4.
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
        // The point value is of both polarisations together: one alone is not worth a kernel.
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
                    let (c, t) = held::<f64>(cos_theta, d);
                    let waves = group.line.waves(c);
                    let fringes = [S, P].map(|pol| Fringe::new(&waves, pol));
                    let found = if film_k > 0.0 {
                        group.absorbing(&waves, c, t)
                    } else {
                        group.transparent(&waves, &fringes, &group.span(&waves, c, t), t)
                    };
                    let count = 20_000;
                    let mut sum = 0.0;
                    for i in 0..count {
                        let sigma = 1.0 / VISIBLE_NM[1] + width * (i as f64 + 0.5) / count as f64;
                        let line = Line::at(&layer, 1.0 / sigma);
                        sum += line.reflectance(&line.waves(cos_theta), d);
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
