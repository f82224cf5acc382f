//! One layer at one wavelength, or at three side by side: the waves in the three media, the amplitudes
//! of the interfaces, and the reflectance of all beams together.
//!
//! The mathematics and the sign conventions are those of [`crate::optics::stack`], for one layer; what
//! depends on the media alone is computed once.

use super::one_layer::OneLayer;
use crate::num::{Lane, Mask, Real, Rgb};
use crate::optics::Complex;
use crate::optics::stack::{Crossing, P, S, round_trip_loss};

/// A squared sum of fields below this counts as 0: cosine and film are too small to reflect.
const VANISHED_SQUARED: f64 = 1e-30;

/// A medium relative to the ambient one.
#[derive(Clone, Copy, Debug)]
struct RelativeMedium<R> {
    /// n^2 - n0^2.
    excess: Complex<R>,
    permittivity: Complex<R>,
    inverse_permittivity: Complex<R>,
}

/// The ambient, the film and the base at one wavelength, or at three side by side.
#[derive(Clone, Copy, Debug)]
pub(super) struct MediaAtWavelength<R> {
    ambient: R,
    inverse_ambient: R,
    film: RelativeMedium<R>,
    base: RelativeMedium<R>,
    /// 1 / lambda, per nm; 0 if the film equals a neighbour, so that its thickness has no effect.
    pub(super) wavenumber: R,
}

/// The waves at a cosine: for s and p the ratio w of the tangential fields, q and q / n^2.
#[derive(Clone, Copy, Debug)]
pub(super) struct Waves<R> {
    pub(super) near: [R; 2],
    pub(super) film: [Complex<R>; 2],
    pub(super) base: [Complex<R>; 2],
}

impl RelativeMedium<f64> {
    fn new(ambient: f64, index: Complex<f64>) -> Self {
        let near = Complex::real(ambient);
        let permittivity = index * index;
        Self {
            excess: (index - near) * (index + near),
            permittivity,
            inverse_permittivity: permittivity.inverse(),
        }
    }
}

impl<R: Real> RelativeMedium<R> {
    /// q^2 = n^2 - n0^2 sin^2, and w for s and p.
    #[inline(always)]
    fn wave(&self, q0: R, w0: [R; 2]) -> [Complex<R>; 2] {
        let zero = R::new(0.0);
        let is_near = self.excess.re.equals(zero) & self.excess.im.equals(zero);
        let q_squared = self.excess + Complex::real(q0 * q0);
        let q = if self.excess.im.gt(zero).any() {
            q_squared.sqrt_upper()
        } else {
            // Transparent: q is real or imaginary.
            let root = q_squared.re.abs().sqrt();
            let is_evanescent = q_squared.re.lt(zero);
            Complex::new(
                R::select(is_evanescent, zero, root),
                R::select(is_evanescent, root, zero),
            )
        };
        let ratio = q * self.inverse_permittivity;
        [
            Complex::select(is_near, Complex::real(w0[S]), q),
            Complex::select(is_near, Complex::real(w0[P]), ratio),
        ]
    }
}

impl MediaAtWavelength<f64> {
    /// The media at a wavelength, nm.
    pub(super) fn at(layer: &OneLayer, wavelength_nm: f64) -> Self {
        let ambient = layer.ambient.index(wavelength_nm).re;
        let film = layer.film.index(wavelength_nm);
        let base = layer.base.index(wavelength_nm);
        let is_matched = film == base || film == Complex::real(ambient);
        Self {
            ambient,
            inverse_ambient: 1.0 / ambient,
            film: RelativeMedium::new(ambient, if is_matched { base } else { film }),
            base: RelativeMedium::new(ambient, base),
            wavenumber: if is_matched { 0.0 } else { 1.0 / wavelength_nm },
        }
    }

    /// Half the change of n1^2 - n0^2 and of n0^2 to another wavelength's.
    pub(super) fn half_change_to(&self, other: &Self) -> (Complex<f64>, f64) {
        let excess = (other.film.excess - self.film.excess).scaled(0.5);
        let square = 0.5 * (other.ambient * other.ambient - self.ambient * self.ambient);
        (excess, square)
    }
}

/// Three numbers side by side.
pub(super) fn pack<T: Lane>(numbers: [f64; 3]) -> T::Rgb {
    T::rgb(numbers.map(T::new))
}

/// Three complex numbers side by side.
pub(super) fn pack_complex<T: Lane>(numbers: [Complex<f64>; 3]) -> Complex<T::Rgb> {
    Complex::new(
        pack::<T>(numbers.map(|z| z.re)),
        pack::<T>(numbers.map(|z| z.im)),
    )
}

/// Three wavelengths side by side.
pub(super) fn pack_media<T: Lane>(media: [MediaAtWavelength<f64>; 3]) -> MediaAtWavelength<T::Rgb> {
    let relative = |media: [RelativeMedium<f64>; 3]| RelativeMedium {
        excess: pack_complex::<T>(media.map(|m| m.excess)),
        permittivity: pack_complex::<T>(media.map(|m| m.permittivity)),
        inverse_permittivity: pack_complex::<T>(media.map(|m| m.inverse_permittivity)),
    };
    MediaAtWavelength {
        ambient: pack::<T>(media.map(|m| m.ambient)),
        inverse_ambient: pack::<T>(media.map(|m| m.inverse_ambient)),
        film: relative(media.map(|m| m.film)),
        base: relative(media.map(|m| m.base)),
        wavenumber: pack::<T>(media.map(|m| m.wavenumber)),
    }
}

/// The amplitudes of the two interfaces for one polarisation, and the powers that they let pass.
#[derive(Clone, Copy, Debug)]
pub(super) struct InterfaceAmplitudes<R> {
    /// r01.
    pub(super) top: Complex<R>,
    /// r12.
    pub(super) bottom: Complex<R>,
    /// 1 - r01^2 = t01 t10.
    pub(super) crossing: Complex<R>,
    /// 1 - |r01|^2 and 1 - |r12|^2, without cancellation.
    pub(super) top_loss: R,
    pub(super) bottom_loss: R,
}

/// The geometric series of all beams of one polarisation: [`InterfaceAmplitudes`] with the loss 1 - |E| of a
/// round trip.
#[derive(Clone, Copy, Debug)]
pub(super) struct BeamSeries<R> {
    /// r01.
    top: Complex<R>,
    /// g = r01 r12 |E|; each beam is -g E / |E| times the one before.
    pub(super) g: Complex<R>,
    /// h = (1 - r01^2) r12 |E|, the first beam from below.
    h: Complex<R>,
    /// 1 - |g|^2, without cancellation where little is absorbed.
    pub(super) g_loss: R,
}

impl<R: Real> InterfaceAmplitudes<R> {
    /// The series for the loss of a round trip.
    #[inline(always)]
    pub(super) fn series(&self, loss: R) -> BeamSeries<R> {
        let decay = R::new(1.0) - loss;
        let bottom = self.bottom.scaled(decay);
        let bottom_loss = loss * (R::new(2.0) - loss) + decay * decay * self.bottom_loss;
        BeamSeries {
            top: self.top,
            g: self.top * bottom,
            h: self.crossing * bottom,
            g_loss: self.top_loss + self.top.norm_squared() * bottom_loss,
        }
    }
}

impl<R: Real> BeamSeries<R> {
    /// The reflectance without interference, |r01|^2 + |h|^2 / (1 - |g|^2), and the factor of the
    /// first harmonic, conj(r01) h - g |h|^2 / (1 - |g|^2). Neither is used where `is_resonant`.
    #[inline(always)]
    pub(super) fn harmonics(&self, is_resonant: R::Mask) -> (R, Complex<R>) {
        let safe = R::select(is_resonant, R::new(1.0), self.g_loss);
        let pairs = self.h.norm_squared() / safe;
        let conjugate = Complex::new(self.top.re, -self.top.im);
        let first = conjugate * self.h - self.g.scaled(pairs);
        (self.top.norm_squared() + pairs, first)
    }
}

/// 1 / b, and 0 for b = 0.
#[inline(always)]
fn safe_inverse<R: Real>(b: Complex<R>) -> Complex<R> {
    let norm = b.norm_squared();
    let one = R::new(1.0);
    let factor = one / R::select(norm.lt(R::new(VANISHED_SQUARED)), one, norm);
    Complex::new(b.re * factor, -(b.im * factor))
}

impl<R: Real> Waves<R> {
    /// The Fresnel amplitudes of the tangential fields: r = (w - w') / (w + w').
    #[inline(always)]
    pub(super) fn amplitudes(&self, pol: usize) -> InterfaceAmplitudes<R> {
        let (near, film, base) = (
            Complex::real(self.near[pol]),
            self.film[pol],
            self.base[pol],
        );
        let four = R::new(4.0);
        let above = safe_inverse(near + film);
        let below = safe_inverse(film + base);
        let overlap = film.re * base.re + film.im * base.im;
        InterfaceAmplitudes {
            top: (near - film) * above,
            bottom: (film - base) * below,
            crossing: (film * above * above).scaled(four * self.near[pol]),
            top_loss: four * self.near[pol] * film.re * above.norm_squared(),
            bottom_loss: four * overlap * below.norm_squared(),
        }
    }
}

impl<R: Real> MediaAtWavelength<R> {
    /// The waves at a cosine in [0, 1].
    #[inline(always)]
    pub(super) fn waves(&self, cos_theta: R) -> Waves<R> {
        let near = [self.ambient * cos_theta, cos_theta * self.inverse_ambient];
        Waves {
            near,
            film: self.film.wave(near[S], near),
            base: self.base.wave(near[S], near),
        }
    }

    /// The factor E = exp(2 i q d 2 pi / lambda) of a round trip through the film: its phase in turns,
    /// and the loss 1 - |E|.
    #[inline(always)]
    pub(super) fn round_trip(&self, waves: &Waves<R>, thickness_nm: R) -> (R, R) {
        let q = waves.film[S];
        let thickness = thickness_nm * self.wavenumber;
        let turns = q.re * thickness * R::new(2.0);
        (turns, round_trip_loss(q, thickness))
    }

    /// R of unpolarised light, all beams together (Airy 1833), by the tangential fields: with
    /// c = (1 + E) / 2 and s = (1 - E) / 2, U = c w2 + s w1 and V = c + s w2 / w1, which keep their
    /// digits in thin films at grazing angles.
    #[inline(always)]
    pub(super) fn reflectance(&self, waves: &Waves<R>, thickness_nm: R) -> R {
        let (zero, half, one) = (R::new(0.0), R::new(0.5), R::new(1.0));
        let crossing = Crossing::new(waves.film[S], thickness_nm * self.wavenumber);
        let (cosine, sine) = (crossing.cosine, crossing.sine);
        let over_q = crossing.sine_over_q;
        let back = [over_q, over_q * self.film.permittivity];
        let [s, p] = [S, P].map(|pol| {
            let base = waves.base[pol];
            let u = cosine * base + sine * waves.film[pol];
            let v = (cosine + back[pol] * base).scaled(waves.near[pol]);
            let incident = (v + u).norm_squared();
            let is_nothing = incident.lt(R::new(VANISHED_SQUARED));
            let safe = R::select(is_nothing, one, incident);
            R::select(is_nothing, zero, (v - u).norm_squared() / safe)
        });
        (s + p) * half
    }
}

/// A complex number of modulus 1 at an angle in turns.
#[inline(always)]
pub(super) fn phasor<R: Real>(turns: R) -> Complex<R> {
    Complex::new(turns.cos_turns(), turns.sin_turns())
}

/// The sum of the three lanes of each channel.
#[inline(always)]
pub(super) fn totals<T: Lane>(sums: [T::Rgb; 3]) -> Rgb<T> {
    sums.map(|sum| {
        let [a, b, c] = T::channels(sum);
        a + b + c
    })
}
