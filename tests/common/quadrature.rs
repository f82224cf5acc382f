//! Integration over the hemisphere that knows nothing of the library's own sampling: an adaptive
//! product rule in (cos theta, phi).

use glam::DVec3;

/// Nodes and weights of the 4-point Gauss-Legendre rule on [-1, 1]: Abramowitz and Stegun, table
/// 25.4, and of its 7-point companion, whose difference tells the error.
const GAUSS_4: [(f64, f64); 4] = [
    (-0.861136311594053, 0.347854845137454),
    (-0.339981043584856, 0.652145154862546),
    (0.339981043584856, 0.652145154862546),
    (0.861136311594053, 0.347854845137454),
];
const GAUSS_7: [(f64, f64); 7] = [
    (-0.949107912342759, 0.129484966168870),
    (-0.741531185599394, 0.279705391489277),
    (-0.405845151377397, 0.381830050505119),
    (0.0, 0.417959183673469),
    (0.405845151377397, 0.381830050505119),
    (0.741531185599394, 0.279705391489277),
    (0.949107912342759, 0.129484966168870),
];

/// A rectangle in (z, phi), which are uniform in solid angle.
#[derive(Clone, Copy)]
pub struct Patch {
    pub z: [f64; 2],
    pub phi: [f64; 2],
}

impl Patch {
    /// One cell of a regular grid over the hemisphere.
    pub fn cell(i: usize, j: usize, rows: usize, columns: usize) -> Self {
        let row = |i: usize| i as f64 / rows as f64;
        let column = |j: usize| j as f64 / columns as f64 * std::f64::consts::TAU;
        Self {
            z: [row(i), row(i + 1)],
            phi: [column(j), column(j + 1)],
        }
    }

    fn quarters(self) -> [Self; 4] {
        let middle = |[from, to]: [f64; 2]| (from + to) / 2.0;
        let (z, phi) = (middle(self.z), middle(self.phi));
        [
            Self {
                z: [self.z[0], z],
                phi: [self.phi[0], phi],
            },
            Self {
                z: [z, self.z[1]],
                phi: [self.phi[0], phi],
            },
            Self {
                z: [self.z[0], z],
                phi: [phi, self.phi[1]],
            },
            Self {
                z: [z, self.z[1]],
                phi: [phi, self.phi[1]],
            },
        ]
    }

    fn rule<const N: usize>(
        self,
        nodes: &[(f64, f64)],
        f: &impl Fn(DVec3) -> [f64; N],
    ) -> [f64; N] {
        let half = |[from, to]: [f64; 2]| (to - from) / 2.0;
        let place = |[from, to]: [f64; 2], x: f64| (from + to) / 2.0 + (to - from) / 2.0 * x;
        let mut around = [(0.0, 0.0); GAUSS_7.len()];
        for (around, (y, _)) in around.iter_mut().zip(nodes) {
            *around = place(self.phi, *y).sin_cos();
        }
        let mut sum = [0.0; N];
        for (x, weight_z) in nodes {
            let z = place(self.z, *x);
            let radius = (1.0 - z * z).max(0.0).sqrt();
            for ((sin, cos), (_, weight_phi)) in around.iter().zip(nodes) {
                let value = f(DVec3::new(radius * cos, radius * sin, z));
                for c in 0..N {
                    sum[c] += weight_z * weight_phi * value[c];
                }
            }
        }
        sum.map(|sum| sum * half(self.z) * half(self.phi))
    }

    /// Those of the points (z, phi) that lie in the patch.
    fn inside(self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let is_inside = |[z, phi]: &[f64; 2]| {
            (self.z[0]..self.z[1]).contains(z) && (self.phi[0]..self.phi[1]).contains(phi)
        };
        points.iter().copied().filter(is_inside).collect()
    }

    /// As [`Self::integrate`], after the patch is quartered until the `points` in (z, phi) fill what they
    /// lie in: a lobe that samples show cannot fall between the nodes of a rule, however narrow it is. The
    /// points only choose where to look closely; any choice gives the same integral.
    pub fn integrate_about<const N: usize>(
        self,
        f: &impl Fn(DVec3) -> [f64; N],
        tolerance: f64,
        depth: u32,
        points: &[[f64; 2]],
    ) -> [f64; N] {
        /// Below the rounding of directions in single precision nothing narrower is to be found.
        const LEAST_WIDTH: f64 = 1e-7;
        /// Of the tolerance, for a quarter that has few points: little is left to integrate there.
        const LEAST_SHARE: f64 = 0.1;
        if self.is_filled(points) || self.z[1] - self.z[0] < LEAST_WIDTH {
            return self.integrate(f, tolerance, depth);
        }
        let mut sum = [0.0; N];
        for quarter in self.quarters() {
            let inside = quarter.inside(points);
            let share = (inside.len() as f64 / points.len() as f64).max(LEAST_SHARE);
            let part = quarter.integrate_about(f, tolerance * share, depth, &inside);
            for c in 0..N {
                sum[c] += part[c];
            }
        }
        sum
    }

    /// Whether the points are few, or spread over both halves of the patch in either coordinate.
    fn is_filled(self, points: &[[f64; 2]]) -> bool {
        const FEW: usize = 20;
        /// A peak of which a half of the patch holds less of the points is resolved by the rules.
        const MOST_IN_A_HALF: f64 = 0.9;
        let middle = [self.z, self.phi].map(|[from, to]| (from + to) / 2.0);
        points.len() < FEW
            || [0, 1].into_iter().all(|axis| {
                let upper = points.iter().filter(|point| point[axis] > middle[axis]);
                let share = upper.count() as f64 / points.len() as f64;
                (1.0 - MOST_IN_A_HALF..=MOST_IN_A_HALF).contains(&share)
            })
    }

    /// The integral per solid angle, to about the absolute `tolerance`. `depth` bounds how often
    /// the patch is quartered.
    pub fn integrate<const N: usize>(
        self,
        f: &impl Fn(DVec3) -> [f64; N],
        tolerance: f64,
        depth: u32,
    ) -> [f64; N] {
        let coarse = self.rule(&GAUSS_4, f);
        let fine = self.rule(&GAUSS_7, f);
        let error = (0..N)
            .map(|c| (fine[c] - coarse[c]).abs())
            .fold(0.0, f64::max);
        if error <= tolerance || depth == 0 {
            return fine;
        }
        let mut sum = [0.0; N];
        for quarter in self.quarters() {
            let part = quarter.integrate(f, tolerance / 4.0, depth - 1);
            for c in 0..N {
                sum[c] += part[c];
            }
        }
        sum
    }
}
