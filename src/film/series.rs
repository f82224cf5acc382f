//! Any stack in double precision, all harmonics of one layer at once: what tables are filled with.

use super::FilmDescription;
use super::quadrature::equidistant;
use crate::error::Error;
use crate::math::{PI, Rgb};
use crate::optics::stack::{Incidence, P, S, Side, Slab};
use crate::optics::{ChannelWeights, Complex};

/// With |g|^2 above 1 less this, or with more than so much power in its terms, the series is not summed:
/// the reflectance at the wavelength is taken. Waves that do not travel come to that, and have no fringes.
const RESONANT: f64 = 1e-13;
const MOST_POWER: f64 = 4.0;
/// e to this counts as 0.
const FAINT: f64 = -25.0;
/// The greatest ratio of a medium's group index and its index.
const MOST_GROUP: f64 = 1.7;
/// Cosines below this are taken for it: there a film either mirrors, or nothing is there.
const LEAST_COSINE: f64 = 1e-9;

/// Reflectance and transmittance per channel, not clipped.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Powers {
    pub reflectance: Rgb<f64>,
    pub transmittance: Rgb<f64>,
}

/// The spectrum at N wavenumbers, without the fringes that so few cannot tell apart.
///
/// At one wavenumber sigma the amplitude reflected by all beams in one layer is, with z = exp(i phi)
/// the phase of a round trip through it,
///
/// ```text
/// r = r_top + h z / (1 + g z)
/// R = |r_top|^2 + |h|^2 / (1 - |g|^2) + 2 Re(C Q)      Q = z / (1 + g z) = sum of (-g)^(m - 1) z^m
/// T = T0 (1 - 2 Re(g Q)) / (1 - |g|^2)                 C = conj(r_top) h - g |h|^2 / (1 - |g|^2)
/// ```
///
/// where r_top, g and h contain the layers above and below and the damping |E|. The m-th harmonic has
/// m fringes for one of the layer. N nodes a distance delta apart tell fringes apart up to a path of
/// 1 / (2 delta), and take what is finer for something coarser; but the eye's curves are so smooth that
/// what is finer should vanish. So Q is summed up to the harmonic M = 1 / (2 delta path) and no further,
/// in closed form:
///
/// ```text
/// Q = z (1 - (-g z)^M) / (1 + g z)
/// ```
///
/// with a part of the next harmonic, so that the sum is continuous in the path. It is exact to rounding
/// for any finesse and thickness of this layer once 1 / (2 delta) exceeds the longest path at which the
/// channels show fringes (some 15 micrometres at 1e-4). The other layers' fringes are sampled: their
/// paths ask for more nodes. The same decomposition as in
/// [`Harmonics`](super::Harmonics), whose transform it evaluates at all orders at once; our own.
#[derive(Clone, Debug)]
pub(super) struct Series {
    nodes: Vec<Node>,
    /// Indices per node: ambient, layers, base.
    indices: Vec<Complex<f64>>,
    /// Least and greatest thickness of each layer.
    ranges: Vec<[f64; 2]>,
    /// The layer whose harmonics are summed.
    summed: Option<usize>,
    /// Its thickness, if that does not vary.
    fixed_nm: Option<f64>,
    /// 1 / (2 delta), nm.
    longest_path: f64,
    /// Indices are the same at all nodes, and no layer but the summed one has a thickness.
    is_uniform: bool,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    sigma: f64,
    weights: Rgb<f64>,
}

/// Where the harmonics end.
#[derive(Clone, Copy, Debug)]
struct Order {
    whole: f64,
    part: f64,
}

/// What does not depend on the thickness of the summed layer, at one wavenumber and polarisation.
#[derive(Clone, Copy, Debug)]
struct Terms {
    top: Complex<f64>,
    g: Complex<f64>,
    h: Complex<f64>,
    /// |top|^2.
    top_squared: f64,
    /// ln |g|, and the angle of -g in turns.
    ln_g: f64,
    turn: f64,
    /// T without interference and damping, times 1 - |g|^2.
    through: f64,
    /// Of g for no damping.
    g_squared: f64,
}

/// [`Terms`] with the damping of a thickness.
#[derive(Clone, Copy, Debug)]
struct Damped {
    top: Complex<f64>,
    g: Complex<f64>,
    h: Complex<f64>,
    /// C.
    fringe: Complex<f64>,
    /// R and T without interference.
    incoherent: f64,
    through: f64,
    is_resonant: bool,
    /// ln |g|.
    ln_g: f64,
    turn: f64,
}

/// A stack seen at one angle, ready for any thickness of the summed layer.
#[derive(Debug)]
pub(super) struct Column<'a> {
    series: &'a Series,
    terms: Vec<[Terms; 2]>,
    /// What they are where the summed layer does not absorb.
    undamped: Vec<[Damped; 2]>,
    /// q of the summed layer times 2 sigma: turns per nm, and the damping's exponent.
    rounds: Vec<Complex<f64>>,
    /// [`Series::path`].
    path: f64,
}

impl Powers {
    #[inline(always)]
    fn add(&mut self, node: &Node, damped: &[Damped; 2], turns: f64, order: Order) {
        let z = circle(turns);
        let [s, p] = [S, P].map(|pol| damped[pol].powers(z, turns, order));
        let (r, t) = (0.5 * (s.0 + p.0), 0.5 * (s.1 + p.1));
        for c in 0..3 {
            self.reflectance[c] += node.weights[c] * r;
            self.transmittance[c] += node.weights[c] * t;
        }
    }
}

impl Series {
    /// With N nodes.
    pub(super) fn new(description: &FilmDescription, count: usize) -> Result<Self, Error> {
        let weights = ChannelWeights::new(description.white, description.color_space);
        let rule = equidistant(&weights, count, 0.0);
        let spacing = rule[1].0 - rule[0].0;
        let media = |nm: f64| {
            let layers = description.layers.iter().map(move |l| l.medium.index(nm));
            std::iter::once(description.ambient.index(nm))
                .chain(layers)
                .chain(std::iter::once(description.base.index(nm)))
        };
        let indices = rule.iter().flat_map(|(sigma, _)| media(1.0 / sigma));
        let indices: Vec<_> = indices.collect();
        let ranges: Vec<_> = description.layers.iter().map(|l| l.thickness_nm).collect();
        let nodes = rule
            .into_iter()
            .map(|(sigma, weights)| Node { sigma, weights });
        let thickest = || {
            (0..ranges.len()).max_by(|&a, &b| {
                let path = |i: usize| ranges[i][1] * indices[i + 1].re;
                path(a).total_cmp(&path(b))
            })
        };
        let summed = description.varying().or_else(thickest);
        let is_uniform = ranges.len() < 2
            && indices
                .chunks(ranges.len() + 2)
                .all(|media| media == &indices[..ranges.len() + 2]);
        Ok(Self {
            nodes: nodes.collect(),
            summed,
            fixed_nm: description
                .varying()
                .is_none()
                .then(|| summed.map_or(0.0, |layer| ranges[layer][0])),
            indices,
            ranges,
            longest_path: 0.5 / spacing,
            is_uniform,
        })
    }

    /// At one angle and thickness (of the layer that varies, ignored if none does), without allocating.
    pub(super) fn at(&self, side: Side, cos_theta: f64, thickness_nm: f64) -> Powers {
        let thickness_nm = self.fixed_nm.unwrap_or(thickness_nm);
        let media = self.ranges.len() + 2;
        let cos_theta = cos_theta.max(LEAST_COSINE);
        let mut powers = Powers::default();
        let round = |node: usize| {
            let indices = &self.indices[node * media..(node + 1) * media];
            self.terms(side, cos_theta, &self.nodes[node], indices).1
        };
        let order = self.order(self.path(round) * thickness_nm);
        for (node, indices) in self.nodes.iter().zip(self.indices.chunks(media)) {
            let (terms, round) = self.terms(side, cos_theta, node, indices);
            let damping = -2.0 * PI * round.im * thickness_nm;
            let damped = terms.map(|terms| terms.damped(damping));
            powers.add(node, &damped, round.re * thickness_nm, order);
        }
        powers
    }

    /// How fast the phase of a round trip changes with the wavenumber, in turns and per nm of thickness:
    /// the path that fringes belong to, longer than that of the phase in dispersive media. The greatest
    /// of both ends and the middle.
    fn path(&self, round: impl Fn(usize) -> Complex<f64>) -> f64 {
        let last = self.nodes.len() - 1;
        let spacing = self.nodes[1].sigma - self.nodes[0].sigma;
        // Where the wave begins to travel along the layer within the spectrum, its phase has a root there
        // and no path.
        let most = self.summed.map_or(0.0, |layer| {
            let media = self.ranges.len() + 2;
            let indices = self.indices.iter().skip(layer + 1).step_by(media);
            MOST_GROUP * indices.map(|index| index.re).fold(0.0, f64::max)
        });
        let between = |node: usize| {
            let path = (round(node + 1).re - round(node).re).abs() / spacing;
            path.min(2.0 * most)
        };
        between(0).max(between(last / 2)).max(between(last - 1))
    }

    /// The last harmonic that the nodes tell apart at a path, nm, and the part of the next one that makes
    /// the sum continuous in the path; that fades within a quarter of the longest path.
    fn order(&self, path: f64) -> Order {
        let last = self.longest_path / path.max(1e-3);
        let whole = last.floor();
        let fading = 1.0 - 4.0 * ((whole + 1.0) / last - 1.0);
        let part = (last - whole).min(fading).max(0.0);
        Order { whole, part }
    }

    /// Bytes of the nodes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.indices)
    }

    /// How many nodes.
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// At an angle; `cos_theta` in the half-space that the light comes from.
    pub(super) fn column(&self, side: Side, cos_theta: f64) -> Column<'_> {
        let media = self.ranges.len() + 2;
        let (mut terms, mut rounds) = (Vec::new(), Vec::new());
        terms.reserve_exact(self.nodes.len());
        rounds.reserve_exact(self.nodes.len());
        for (node, indices) in self.nodes.iter().zip(self.indices.chunks(media)) {
            let (both, round) = self.terms(side, cos_theta.max(LEAST_COSINE), node, indices);
            terms.push(both);
            rounds.push(round);
            if self.is_uniform {
                let over_sigma = round.scaled(1.0 / node.sigma);
                rounds.clear();
                rounds.extend(self.nodes.iter().map(|n| over_sigma.scaled(n.sigma)));
                break;
            }
        }
        let undamped = terms.iter().map(|terms| terms.map(|t| t.damped(0.0)));
        Column {
            series: self,
            undamped: undamped.collect(),
            terms,
            path: self.path(|node| rounds[node]),
            rounds,
        }
    }

    fn terms(
        &self,
        side: Side,
        cos_theta: f64,
        node: &Node,
        indices: &[Complex<f64>],
    ) -> ([Terms; 2], Complex<f64>) {
        let last = indices.len() - 1;
        // Media from the light onwards.
        let medium = |i: usize| match side {
            Side::Ambient => indices[i],
            Side::Base => indices[last - i],
        };
        let layer_of = |i: usize| match side {
            Side::Ambient => i - 1,
            Side::Base => last - 1 - i,
        };
        let near = Incidence::new(medium(0).re, cos_theta);
        let far = near.wave(medium(last));
        let summed = self.summed.map_or(last, |layer| match side {
            Side::Ambient => layer + 1,
            Side::Base => last - 1 - layer,
        });
        let inside = near.wave(medium(summed));
        let slab = |i: usize| {
            let thickness_nm = self.ranges[layer_of(i)][0];
            Slab::new(&near.wave(medium(i)), thickness_nm, 1.0 / node.sigma)
        };
        let near_w = near.immittance();
        // The layers below the summed one, from the far half-space.
        let mut below = [S, P].map(|pol| (far.immittance[pol], Complex::real(1.0)));
        let mut decay_below = 1.0;
        for i in (summed + 1..last).rev() {
            let cross = slab(i);
            for (pol, (u, v)) in below.iter_mut().enumerate() {
                (*u, *v) = cross.carry(pol, *u, *v);
            }
            decay_below *= cross.decay;
        }
        // The layers above it, as a matrix per polarisation: images of (1, 0) and (0, 1).
        let one = Complex::real(1.0);
        let zero = Complex::real(0.0);
        let mut above = [[(one, zero), (zero, one)]; 2];
        let mut decay_above = 1.0;
        let mut determinant = one;
        for i in (1..summed.min(last)).rev() {
            let cross = slab(i);
            for (pol, columns) in above.iter_mut().enumerate() {
                for (u, v) in columns {
                    (*u, *v) = cross.carry(pol, *u, *v);
                }
            }
            decay_above *= cross.decay;
            determinant = determinant * cross.round_trip();
        }
        let both = [S, P].map(|pol| {
            let (w0, w1) = (Complex::real(near_w[pol]), inside.immittance[pol]);
            let (u2, v2) = below[pol];
            let [(a, c), (b, d)] = above[pol];
            let (p, q) = (w0 * (c * w1 + d), a * w1 + b);
            let (p1, q1) = (w0 * (d - c * w1), b - a * w1);
            let inverse = safe_inverse(p + q);
            let sum = w1 * v2 + u2;
            let bottom = (w1 * v2 - u2) * safe_inverse(sum);
            let top = (p - q) * inverse;
            let g = (p1 + q1) * inverse * bottom;
            let h = (w0 * w1 * determinant * inverse * inverse * bottom).scaled(4.0);
            // 4 w0 Re(w far) |E| / |(w1 v2 + u2) / (2 w1) (p + q)|^2
            let forward = (sum * safe_inverse(w1)).scaled(0.5) * (p + q);
            let flux = 4.0 * near_w[pol] * far.immittance[pol].re;
            let through =
                flux * decay_above * decay_below / forward.norm_squared().max(f64::MIN_POSITIVE);
            let g_squared = g.norm_squared();
            Terms {
                top,
                g,
                h,
                top_squared: top.norm_squared(),
                ln_g: 0.5 * g_squared.max(f64::MIN_POSITIVE).ln(),
                turn: (-g.im).atan2(-g.re) * (0.5 / PI),
                through,
                g_squared,
            }
        });
        let round = if summed == last {
            Complex::real(0.0)
        } else {
            inside.immittance[S].scaled(2.0 * node.sigma)
        };
        (both, round)
    }
}

impl Column<'_> {
    /// At a thickness of the layer that varies, nm; ignored if none does.
    pub(super) fn at(&self, thickness_nm: f64) -> Powers {
        let thickness_nm = self.series.fixed_nm.unwrap_or(thickness_nm);
        let mut powers = Powers::default();
        let order = self.series.order(self.path * thickness_nm);
        for (i, (node, round)) in self.series.nodes.iter().zip(&self.rounds).enumerate() {
            let turns = round.re * thickness_nm;
            if round.im > 0.0 {
                let damping = -2.0 * PI * round.im * thickness_nm;
                let terms = self.terms.get(i).unwrap_or(&self.terms[0]);
                powers.add(
                    node,
                    &terms.map(|terms| terms.damped(damping)),
                    turns,
                    order,
                );
            } else {
                let damped = self.undamped.get(i).unwrap_or(&self.undamped[0]);
                powers.add(node, damped, turns, order);
            }
        }
        powers
    }
}

impl Terms {
    /// With the amplitude's damping on a round trip, the exponent of e.
    #[inline(always)]
    fn damped(&self, damping: f64) -> Damped {
        let decay = if damping < 0.0 { damping.exp() } else { 1.0 };
        let (g, h) = (self.g.scaled(decay), self.h.scaled(decay));
        let loss = 1.0 - self.g_squared * decay * decay;
        let is_resonant = loss < RESONANT || h.norm_squared() > MOST_POWER * loss;
        let inverse = if is_resonant { 1.0 } else { 1.0 / loss };
        let pairs = h.norm_squared() * inverse;
        Damped {
            g,
            h,
            top: self.top,
            fringe: Complex::new(self.top.re, -self.top.im) * h - g.scaled(pairs),
            incoherent: self.top_squared + pairs,
            through: self.through * decay * inverse,
            is_resonant,
            ln_g: self.ln_g + damping,
            turn: self.turn,
        }
    }
}

impl Damped {
    /// R and T at z, the phase of a round trip, which is so many turns.
    #[inline(always)]
    fn powers(&self, z: Complex<f64>, turns: f64, order: Order) -> (f64, f64) {
        let gz = self.g * z;
        let denominator = Complex::new(1.0 + gz.re, gz.im);
        if self.is_resonant {
            let inverse = safe_inverse(denominator);
            let r = (self.top + self.h * z * inverse).norm_squared();
            return (r, self.through * inverse.norm_squared());
        }
        let mut sum = z * denominator.inverse();
        let Order { whole, part } = order;
        let last = whole * self.ln_g;
        if last > FAINT {
            let power = circle(whole * (self.turn + turns)).scaled(last.exp());
            let power = power * Complex::new(1.0 - part - part * gz.re, -(part * gz.im));
            sum = sum * Complex::new(1.0 - power.re, -power.im);
        }
        let fringe = self.fringe.re * sum.re - self.fringe.im * sum.im;
        let g = self.g.re * sum.re - self.g.im * sum.im;
        (
            self.incoherent + 2.0 * fringe,
            self.through * (1.0 - 2.0 * g),
        )
    }
}

/// exp(2 pi i turns) to 1e-11, by Taylor's series about the nearest quarter of a turn; without the
/// mathematical library, whose results differ from machine to machine.
#[inline(always)]
fn circle(turns: f64) -> Complex<f64> {
    /// Adding it rounds to a whole number, which is then in the lowest bits.
    const WHOLE: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52
    let shifted = 4.0 * turns + WHOLE;
    let t = (turns - 0.25 * (shifted - WHOLE)) * (2.0 * PI);
    let z = t * t;
    let sine = 1.0 / 362_880.0 - z * (1.0 / 39_916_800.0);
    let sine = 1.0 / 120.0 - z * (1.0 / 5040.0 - z * sine);
    let sine = t * (1.0 - z * (1.0 / 6.0 - z * sine));
    let cosine = 1.0 / 40_320.0 - z * (1.0 / 3_628_800.0 - z * (1.0 / 479_001_600.0));
    let cosine = 1.0 - z * (0.5 - z * (1.0 / 24.0 - z * (1.0 / 720.0 - z * cosine)));
    let quarter = shifted.to_bits();
    let (re, im) = if quarter & 1 == 0 {
        (cosine, sine)
    } else {
        (-sine, cosine)
    };
    let sign = f64::from_bits(1.0f64.to_bits() | (quarter & 2) << 62);
    Complex::new(re * sign, im * sign)
}

fn safe_inverse(z: Complex<f64>) -> Complex<f64> {
    if z.norm_squared() < f64::MIN_POSITIVE {
        Complex::real(0.0)
    } else {
        z.inverse()
    }
}

#[cfg(test)]
mod tests;
