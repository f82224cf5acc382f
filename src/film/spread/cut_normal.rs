//! Gauss rules of a normal distribution that is cut at its ends.

/// An end that is further away than this number of deviations cuts 3e-6 of the distribution and is ignored.
const FAR: f64 = 4.5;
/// The distance of the ends at which rules are stored, in deviations. Between them three rules are interpolated,
/// which is off by 1e-4 at most for waves of up to 1.5 radians per deviation.
const STEP: f64 = 0.25;
const ROWS: usize = 19;
/// The greatest number of nodes of a rule for one end.
const MOST: usize = 7;
/// The numbers of nodes of the rules for one end.
const COUNTS: [usize; 3] = [3, 5, MOST];
/// The number of rules. The last two have [`WIDE`] and [`WIDEST`] nodes, for waves of up to 4 radians per deviation
/// and for peaks as narrow as a fifth of it.
pub(in crate::film) const ORDERS: usize = COUNTS.len() + 2;
/// The number of nodes where both ends are near, those of the last rules, and how far they reach, in deviations.
const LEGENDRE: usize = 12;
const WIDE: usize = 24;
const WIDEST: usize = 64;
const REACH: f32 = 4.0;
/// Nodes of the sums that stand for integrals where the rules are made.
const FINE: usize = 96;
const SUPPORT: f64 = 9.0;

/// Nodes in deviations from the middle, and weights, which are positive and sum to 1.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct Rule {
    nodes: [f32; WIDEST],
    weights: [f32; WIDEST],
    count: usize,
}

/// Rules for every distance of the ends. Weights are positive because the rules of both neighbours are, and nodes
/// stay between the ends.
#[derive(Clone, Debug)]
pub(in crate::film) struct CutNormal {
    /// Nodes and weights by the number of nodes and the distance of the lower end; the upper one is far.
    rows: [[[[f32; MOST]; 2]; ROWS]; COUNTS.len()],
    legendre: [[f32; LEGENDRE]; 2],
    wide: [[f32; WIDE]; 2],
    widest: [[f32; WIDEST]; 2],
}

impl CutNormal {
    /// On the heap, as films are made on small stacks.
    #[inline(never)]
    pub fn new() -> Box<Self> {
        let fine = legendre::<FINE>();
        let row = |order: usize, row: usize| gauss(COUNTS[order], STEP * row as f64, &fine);
        Box::new(Self {
            rows: std::array::from_fn(|order| std::array::from_fn(|i| row(order, i))),
            legendre: legendre().map(|numbers| numbers.map(|x| x as f32)),
            wide: legendre().map(|numbers| numbers.map(|x| x as f32)),
            widest: legendre().map(|numbers| numbers.map(|x| x as f32)),
        })
    }

    /// The rule of an order below [`ORDERS`] for a distribution whose lower and upper end are at these distances from
    /// the middle, in deviations, at least 0. It has more nodes where both are near.
    pub fn rule(&self, order: usize, [lower, upper]: [f32; 2]) -> Rule {
        let far = FAR as f32;
        if order == COUNTS.len() {
            return between(&self.wide, lower, upper);
        }
        if order > COUNTS.len() {
            return between(&self.widest, lower, upper);
        }
        if lower < far && upper < far {
            return between(&self.legendre, lower, upper);
        }
        let sign = if upper < far { -1.0 } else { 1.0 };
        let position = lower.min(upper).min(far) / STEP as f32;
        let middle = (position.round() as usize).clamp(1, ROWS - 2);
        let t = position - middle as f32;
        let parts = [0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)];
        let rows = &self.rows[order][middle - 1..];
        let mixed = |which: usize, i: usize| -> f32 {
            (0..3).map(|row| parts[row] * rows[row][which][i]).sum()
        };
        let mut rule = Rule::EMPTY;
        rule.count = COUNTS[order];
        for i in 0..COUNTS[order] {
            rule.nodes[i] = sign * mixed(0, i);
            rule.weights[i] = mixed(1, i);
        }
        rule
    }
}

/// The rule of Gauss and Legendre, weighted by the distribution.
fn between<const N: usize>(legendre: &[[f32; N]; 2], lower: f32, upper: f32) -> Rule {
    let [from, to] = [-lower.min(REACH), upper.min(REACH)];
    let mut rule = Rule::EMPTY;
    rule.count = N;
    let mut total = 0.0;
    for (i, (node, weight)) in legendre[0].iter().zip(legendre[1]).enumerate() {
        let x = 0.5 * ((from + to) + (to - from) * node);
        let weight = weight * (-0.5 * x * x).exp();
        (rule.nodes[i], rule.weights[i]) = (x, weight);
        total += weight;
    }
    for weight in &mut rule.weights[..N] {
        *weight /= total;
    }
    rule
}

impl Rule {
    const EMPTY: Self = Self {
        nodes: [0.0; WIDEST],
        weights: [0.0; WIDEST],
        count: 0,
    };

    /// The number of nodes.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Nodes and weights.
    #[inline(always)]
    pub fn iter(&self) -> impl Iterator<Item = (f32, f32)> + '_ {
        let nodes = self.nodes[..self.count].iter().copied();
        nodes.zip(self.weights[..self.count].iter().copied())
    }
}

/// The Gauss rule of n nodes for the normal density above -`lower`, by Stieltjes' procedure over sums (Gautschi 2004,
/// "Orthogonal Polynomials: Computation and Approximation", section 2.2).
fn gauss(n: usize, lower: f64, fine: &[[f64; FINE]; 2]) -> [[f32; MOST]; 2] {
    let half = 0.5 * (SUPPORT + lower);
    let at: Vec<f64> = fine[0].iter().map(|x| half * (1.0 + x) - lower).collect();
    let mut mass: Vec<f64> = at.iter().map(|t| (-0.5 * t * t).exp()).collect();
    for (mass, weight) in mass.iter_mut().zip(fine[1]) {
        *mass *= weight;
    }
    let total: f64 = mass.iter().sum();
    // p(k + 1) = (t - a(k)) p(k) - b(k) p(k - 1), monic, with norms h(k).
    let (mut a, mut b, mut norms) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for k in 0..n {
        let (mut norm, mut moment) = (0.0, 0.0);
        for (t, mass) in at.iter().zip(&mass) {
            let p = polynomial(&a[..k], &b[..k], *t);
            norm += mass / total * p * p;
            moment += mass / total * t * p * p;
        }
        norms[k] = norm;
        a[k] = moment / norm;
        b[k] = if k > 0 { norm / norms[k - 1] } else { 0.0 };
    }
    // The roots lie apart, so that a walk finds each between two signs.
    const STEPS: usize = 3000;
    let p = |t: f64| polynomial(&a, &b, t);
    let step = (SUPPORT + lower) / STEPS as f64;
    let mut rule = [[0.0; MOST]; 2];
    let mut found = 0;
    for i in 0..STEPS {
        let [mut low, mut high] = [i, i + 1].map(|i| i as f64 * step - lower);
        let sign = p(low).signum();
        if found == n || sign == p(high).signum() {
            continue;
        }
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if p(middle).signum() == sign {
                low = middle;
            } else {
                high = middle;
            }
        }
        let squares: f64 = (0..n)
            .map(|k| polynomial(&a[..k], &b[..k], low).powi(2) / norms[k])
            .sum();
        (rule[0][found], rule[1][found]) = (low as f32, (1.0 / squares) as f32);
        found += 1;
    }
    rule
}

/// The monic polynomial of a three-term recurrence.
fn polynomial(a: &[f64], b: &[f64], t: f64) -> f64 {
    let (mut before, mut now) = (0.0, 1.0);
    for (a, b) in a.iter().zip(b) {
        (before, now) = (now, (t - a) * now - b * before);
    }
    now
}

/// Nodes and weights of the rule of Gauss and Legendre on [-1, 1], by Newton's iteration.
fn legendre<const N: usize>() -> [[f64; N]; 2] {
    let n = N as f64;
    let mut rule = [[0.0; N]; 2];
    let [nodes, weights] = &mut rule;
    for (i, (node, weight)) in nodes.iter_mut().zip(weights).enumerate() {
        let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut before, mut now) = (0.0, 1.0);
            for k in 1..=N {
                let k = k as f64;
                (before, now) = (now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k);
            }
            slope = n * (x * now - before) / (x * x - 1.0);
            x -= now / slope;
        }
        *node = x;
        *weight = 2.0 / ((1.0 - x * x) * slope * slope);
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against wrong nodes and weights: mean, variance and a wave of the cut distribution, wherever the ends are,
    /// against sums over a hundred thousand points. Weights are positive, and nodes lie between the ends.
    #[test]
    fn rules_average_waves() {
        let rules = CutNormal::new();
        for i in 0..=20 {
            let near = 0.245 * f64::from(i);
            for far in [f64::INFINITY, 5.0, 4.0, 2.0, 0.5] {
                for [lower, upper] in [[near, far], [far, near]] {
                    check(&rules, lower, upper);
                }
            }
        }
    }

    fn check(rules: &CutNormal, lower: f64, upper: f64) {
        let [from, to] = [-lower.min(8.0), upper.min(8.0)];
        let average = |f: &dyn Fn(f64) -> f64| {
            const POINTS: usize = 4000;
            let (mut sum, mut total) = (0.0, 0.0);
            for i in 0..POINTS {
                let x = from + (to - from) * (i as f64 + 0.5) / POINTS as f64;
                let weight = (-0.5 * x * x).exp();
                sum += weight * f(x);
                total += weight;
            }
            sum / total
        };
        for (order, wave, allowed) in [
            (0, 0.4, 2e-4),
            (1, 1.0, 2e-4),
            (2, 1.5, 3e-4),
            (3, 3.5, 3e-4),
            (4, 9.0, 3e-4),
        ] {
            let rule = rules.rule(order, [lower as f32, upper as f32]);
            let mut total = 0.0;
            for (node, weight) in rule.iter() {
                let node = f64::from(node);
                assert!(weight > 0.0, "{lower} {upper}: {weight}");
                assert!(
                    (-lower - 1e-6..=upper + 1e-6).contains(&node),
                    "{lower} {upper}: {node}"
                );
                total += f64::from(weight);
            }
            assert!((total - 1.0).abs() < 1e-5, "{lower} {upper}: {total}");
            let functions: [&dyn Fn(f64) -> f64; 3] =
                [&|x| x, &|x| (wave * x).cos(), &|x| (wave * x).sin()];
            for f in functions {
                let found: f64 = rule
                    .iter()
                    .map(|(node, weight)| f64::from(weight) * f(f64::from(node)))
                    .sum();
                let expected = average(f);
                assert!(
                    (found - expected).abs() < allowed,
                    "{order}, ends {lower} {upper}: {found} is not {expected}"
                );
            }
        }
    }
}
