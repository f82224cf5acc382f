//! The sum of the series over beams at four wavenumbers and one angle, for any thickness.

use super::terms::{BeamTerms, StackMedia, safe_inverse};
use crate::film::colors::Colors;
use crate::num::{F64x4, Mask, PI, Real, widest};
use crate::optics::Complex;
use crate::optics::stack::{P, S};

/// Where 1 - |g|^2 is below this, the reflectance at the single wavelength replaces the series. Waves
/// that do not travel reach that, and they have no fringes.
const RESONANT: f64 = 1e-13;
/// The same where |h|^2 / (1 - |g|^2) is above this.
const MOST_POWER: f64 = 4.0;
/// e to this power counts as 0.
const FAINT: f64 = -25.0;

/// Four wavenumbers (per nm) and their weights in the channels; those that only fill the register have
/// weight 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wavenumbers {
    pub sigma: F64x4,
    pub weights: [F64x4; 3],
}

/// The truncation of the harmonics.
#[derive(Clone, Copy, Debug)]
pub(super) struct Truncation {
    /// The number of the last harmonic with weight 1.
    pub whole: f64,
    /// The weight of the next harmonic.
    pub part: f64,
    /// 1 where the harmonics are truncated, 0 where all are summed.
    pub cut: f64,
}

/// A stack at four wavenumbers and one angle.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct StackAtAngle {
    terms: [BeamTerms; 2],
    /// The terms for a summed layer that does not absorb.
    undamped: [DampedTerms; 2],
    /// 2 q: turns of a round trip per wavelength of thickness, and the damping's exponent over 2 pi.
    pub round: Complex<F64x4>,
    is_damped: bool,
}

/// [`BeamTerms`] with the damping of a thickness.
#[derive(Clone, Copy, Debug, Default)]
struct DampedTerms {
    top: Complex<F64x4>,
    g: Complex<F64x4>,
    h: Complex<F64x4>,
    /// C.
    fringe: Complex<F64x4>,
    /// R and T without interference.
    incoherent: F64x4,
    through: F64x4,
    is_resonant: <F64x4 as Real>::Mask,
    /// ln |g|.
    ln_g: F64x4,
    turn: F64x4,
}

/// R and T of the channels, one partial sum in each lane.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ChannelSums {
    reflectance: [F64x4; 3],
    transmittance: [F64x4; 3],
}

impl ChannelSums {
    /// Adds what [`ChannelSums::add`] does for every entry of `wavenumbers`, each with its own stack or all with
    /// the only one.
    #[inline(never)]
    pub(super) fn add_all(
        &mut self,
        stacks: &[StackAtAngle],
        wavenumbers: &[Wavenumbers],
        thickness_nm: f64,
        truncation: Truncation,
    ) {
        widest(
            #[inline(always)]
            || {
                let mut sums = *self;
                for (i, wavenumbers) in wavenumbers.iter().enumerate() {
                    let stack = stacks.get(i).unwrap_or(&stacks[0]);
                    sums.add(stack, wavenumbers, thickness_nm, truncation);
                }
                *self = sums;
            },
        );
    }

    /// Adds the reflectance and transmittance at four wavenumbers and a thickness of the summed layer.
    #[inline(always)]
    fn add(
        &mut self,
        stack: &StackAtAngle,
        wavenumbers: &Wavenumbers,
        thickness_nm: f64,
        truncation: Truncation,
    ) {
        let thickness = wavenumbers.sigma * F64x4::new(thickness_nm);
        let turns = stack.round.re * thickness;
        let [cos, sin] = turns.circle();
        let z = Complex::new(cos, sin);
        let damped;
        let [s, p] = if stack.is_damped {
            let exponent = stack.round.im * thickness * F64x4::new(-2.0 * PI);
            let decay = exponent.exp();
            let [s, p] = &stack.terms;
            damped = [s.damped(exponent, decay), p.damped(exponent, decay)];
            &damped
        } else {
            &stack.undamped
        };
        let (s, p) = (
            s.powers(z, turns, truncation),
            p.powers(z, turns, truncation),
        );
        let half = F64x4::new(0.5);
        let (r, t) = ((s.0 + p.0) * half, (s.1 + p.1) * half);
        for c in 0..3 {
            self.reflectance[c] = self.reflectance[c] + wavenumbers.weights[c] * r;
            self.transmittance[c] = self.transmittance[c] + wavenumbers.weights[c] * t;
        }
    }

    /// The sums over the lanes.
    #[inline(always)]
    pub(super) fn colors(&self) -> Colors<f64> {
        Colors {
            reflectance: self.reflectance.map(F64x4::sum),
            transmittance: self.transmittance.map(F64x4::sum),
        }
    }
}

impl StackAtAngle {
    /// The stack at a cosine on the side of the light.
    #[inline(always)]
    pub(super) fn new(media: StackMedia<'_>, cos_theta: f64, sigma: F64x4) -> Self {
        let (terms, round) = media.terms(cos_theta, sigma);
        let (zero, one) = (F64x4::new(0.0), F64x4::new(1.0));
        Self {
            undamped: [terms[S].damped(zero, one), terms[P].damped(zero, one)],
            terms,
            is_damped: round.im.gt(zero).any(),
            round,
        }
    }
}

impl StackAtAngle {
    /// Whether the four wavenumbers resolve every resonance of the layers above and below the summed one: no
    /// denominator changes between neighbours by more than its own magnitude.
    pub(super) fn is_resolved(&self) -> bool {
        let denominators = self.terms.iter().flat_map(|terms| terms.denominators);
        denominators.into_iter().all(|z| {
            let [re, im] = [z.re.to_array(), z.im.to_array()];
            (1..F64x4::COUNT).all(|i| {
                let change = (re[i] - re[i - 1]).powi(2) + (im[i] - im[i - 1]).powi(2);
                let [a, b] = [i - 1, i].map(|i| re[i].powi(2) + im[i].powi(2));
                // NaN, where a scale has overflowed, counts as resolved.
                let is_narrow = change > a.min(b);
                !is_narrow
            })
        })
    }
}

impl BeamTerms {
    /// The terms with the damping of the amplitude on a round trip, decay = exp(exponent).
    #[inline(always)]
    fn damped(&self, exponent: F64x4, decay: F64x4) -> DampedTerms {
        let one = F64x4::new(1.0);
        let (g, h) = (self.g.scaled(decay), self.h.scaled(decay));
        let loss = one - g.norm_squared();
        let power = h.norm_squared();
        let is_resonant = loss.lt(F64x4::new(RESONANT)) | power.gt(loss * F64x4::new(MOST_POWER));
        let inverse = F64x4::select(is_resonant, one, one / loss);
        let pairs = power * inverse;
        DampedTerms {
            g,
            h,
            top: self.top,
            fringe: Complex::new(self.top.re, -self.top.im) * h - g.scaled(pairs),
            incoherent: self.top.norm_squared() + pairs,
            through: self.through * decay * inverse,
            is_resonant,
            ln_g: self.ln_g + exponent,
            turn: self.turn,
        }
    }
}

impl DampedTerms {
    /// R and T at z = exp(2 pi i turns), the phase of a round trip.
    #[inline(always)]
    fn powers(&self, z: Complex<F64x4>, turns: F64x4, truncation: Truncation) -> (F64x4, F64x4) {
        let (zero, one, two) = (F64x4::new(0.0), F64x4::new(1.0), F64x4::new(2.0));
        let gz = self.g * z;
        let inverse = safe_inverse(Complex::new(one + gz.re, gz.im));
        let all = z * inverse;
        let mut sum = all;
        let last = self.ln_g * F64x4::new(truncation.whole);
        let is_seen = last.gt(F64x4::new(FAINT));
        if truncation.cut > 0.0 && is_seen.any() {
            let size = F64x4::select(is_seen, last.exp(), zero) * F64x4::new(truncation.cut);
            let [cos, sin] = ((self.turn + turns) * F64x4::new(truncation.whole)).circle();
            let part = F64x4::new(truncation.part);
            let next = Complex::new(one - part - part * gz.re, -(part * gz.im));
            let power = Complex::new(cos, sin).scaled(size) * next;
            sum = sum * Complex::new(one - power.re, -power.im);
        }
        let fringe = self.fringe.re * sum.re - self.fringe.im * sum.im;
        let g = self.g.re * sum.re - self.g.im * sum.im;
        let r = self.incoherent + two * fringe;
        let t = self.through * (one - two * g);
        if !self.is_resonant.any() {
            return (r, t);
        }
        let direct = (self.top + self.h * all).norm_squared();
        (
            F64x4::select(self.is_resonant, direct, r),
            F64x4::select(self.is_resonant, self.through * inverse.norm_squared(), t),
        )
    }
}
