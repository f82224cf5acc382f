//! The series at one angle, for any thickness.

use super::terms::{Media, Terms, safe_inverse};
use super::{Nodes, Powers, Series};
use crate::num::{F64x4, Mask, PI, Real, widest};
use crate::optics::Complex;
use crate::optics::stack::{P, S};

/// With |g|^2 above 1 less this, or with more than so much power in its terms, the series is not summed:
/// the reflectance at the wavelength is taken. Waves that do not travel come to that, and have no fringes.
const RESONANT: f64 = 1e-13;
const MOST_POWER: f64 = 4.0;
/// e to this counts as 0.
const FAINT: f64 = -25.0;

/// A stack seen at one angle, ready for any thickness of the summed layer.
#[derive(Debug)]
pub(in super::super) struct Column<'a> {
    pub(super) series: &'a Series,
    /// One per [`Nodes`], or one for all.
    pub(super) blocks: Vec<Block>,
    /// [`Series::path`].
    pub(super) path: f64,
}

/// Where the harmonics end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Order {
    pub whole: f64,
    pub part: f64,
    /// 1 where they do end, 0 where all are summed.
    pub cut: f64,
}

/// A stack at some nodes and one angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    terms: [Terms; 2],
    /// What they are where the summed layer does not absorb.
    undamped: [Damped; 2],
    /// 2 q: turns of a round trip per wavelength of thickness, and the damping's exponent over 2 pi.
    pub(super) round: Complex<F64x4>,
    is_damped: bool,
}

/// [`Terms`] with the damping of a thickness.
#[derive(Clone, Copy, Debug)]
struct Damped {
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

/// R and T of the channels, summed over the nodes in each place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    reflectance: [F64x4; 3],
    transmittance: [F64x4; 3],
}

impl Column<'_> {
    /// At a thickness of the layer that varies, nm; ignored if none does.
    pub(in super::super) fn at(&self, thickness_nm: f64) -> Powers {
        let thickness_nm = self.series.fixed_nm.unwrap_or(thickness_nm);
        let order = self.series.order(self.path * thickness_nm);
        widest(
            #[inline(always)]
            || {
                let mut sum = Sum::default();
                for (i, nodes) in self.series.nodes.iter().enumerate() {
                    let block = self.blocks.get(i).unwrap_or(&self.blocks[0]);
                    sum.add(block, nodes, thickness_nm, order);
                }
                sum.powers()
            },
        )
    }
}

impl Sum {
    #[inline(always)]
    pub(super) fn add(&mut self, block: &Block, nodes: &Nodes, thickness_nm: f64, order: Order) {
        let thickness = nodes.sigma * F64x4::new(thickness_nm);
        let turns = block.round.re * thickness;
        let [cos, sin] = turns.circle();
        let z = Complex::new(cos, sin);
        let damped;
        let [s, p] = if block.is_damped {
            let exponent = block.round.im * thickness * F64x4::new(-2.0 * PI);
            let decay = exponent.exp();
            let [s, p] = &block.terms;
            damped = [s.damped(exponent, decay), p.damped(exponent, decay)];
            &damped
        } else {
            &block.undamped
        };
        let (s, p) = (s.powers(z, turns, order), p.powers(z, turns, order));
        let half = F64x4::new(0.5);
        let (r, t) = ((s.0 + p.0) * half, (s.1 + p.1) * half);
        for c in 0..3 {
            self.reflectance[c] = self.reflectance[c] + nodes.weights[c] * r;
            self.transmittance[c] = self.transmittance[c] + nodes.weights[c] * t;
        }
    }

    #[inline(always)]
    pub(super) fn powers(&self) -> Powers {
        Powers {
            reflectance: self.reflectance.map(F64x4::sum),
            transmittance: self.transmittance.map(F64x4::sum),
        }
    }
}

impl Block {
    #[inline(always)]
    pub(super) fn new(media: Media<'_>, cos_theta: f64, sigma: F64x4) -> Self {
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

impl Terms {
    /// With the amplitude's damping on a round trip: e to the exponent.
    #[inline(always)]
    fn damped(&self, exponent: F64x4, decay: F64x4) -> Damped {
        let one = F64x4::new(1.0);
        let (g, h) = (self.g.scaled(decay), self.h.scaled(decay));
        let loss = one - g.norm_squared();
        let power = h.norm_squared();
        let is_resonant = loss.lt(F64x4::new(RESONANT)) | power.gt(loss * F64x4::new(MOST_POWER));
        let inverse = F64x4::select(is_resonant, one, one / loss);
        let pairs = power * inverse;
        Damped {
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

impl Damped {
    /// R and T at z, the phase of a round trip, which is so many turns.
    #[inline(always)]
    fn powers(&self, z: Complex<F64x4>, turns: F64x4, order: Order) -> (F64x4, F64x4) {
        let (zero, one, two) = (F64x4::new(0.0), F64x4::new(1.0), F64x4::new(2.0));
        let gz = self.g * z;
        let inverse = safe_inverse(Complex::new(one + gz.re, gz.im));
        let all = z * inverse;
        let mut sum = all;
        let last = self.ln_g * F64x4::new(order.whole);
        let is_seen = last.gt(F64x4::new(FAINT));
        if order.cut > 0.0 && is_seen.any() {
            let size = F64x4::select(is_seen, last.exp(), zero) * F64x4::new(order.cut);
            let [cos, sin] = ((self.turn + turns) * F64x4::new(order.whole)).circle();
            let part = F64x4::new(order.part);
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
