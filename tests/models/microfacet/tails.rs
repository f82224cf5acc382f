//! The distributions whose masking is a table, and what is read off the model of them: D with implicit
//! masking and F = 1, Smith's Lambda by the ratio of both maskings.

use crate::common::calls::Calls;
use glam::DVec3;
use pellicle::bsdf::Precision;
use pellicle::{Bsdf, Description};
use std::f64::consts::PI;

pub const ALPHAS: [f32; 7] = [1e-4, 1e-3, 0.01, 0.1, 0.3, 0.6, 1.0];

#[derive(Clone, Copy, Debug)]
pub struct Surface {
    pub distribution: &'static str,
    /// `abc_exponent` or `sgd_p`.
    pub shape: f32,
    pub alpha: f32,
}

impl Surface {
    pub fn all() -> impl Iterator<Item = Self> {
        let mut kinds = vec![("blinn_phong", 0.0)];
        kinds.extend([0.5, 0.8, 1.0, 1.2, 1.5, 2.0, 4.0, 10.0].map(|c| ("abc", c)));
        kinds.extend([0.0, 0.44, 1.0, 1.5, 2.0, 4.0].map(|p| ("sgd", p)));
        let of = |(distribution, shape)| {
            ALPHAS.map(|alpha| Self {
                distribution,
                shape,
                alpha,
            })
        };
        kinds.into_iter().flat_map(of)
    }

    pub fn bsdf<T: Precision>(&self, masking: &str) -> Bsdf<T> {
        let description = Description::new("microfacet")
            .choose("distribution", self.distribution)
            .choose("masking", masking)
            .set("alpha", &[self.alpha])
            .set("f0", &[1.0; 3]);
        let description = match self.distribution {
            "abc" => description.set("abc_exponent", &[self.shape]),
            "sgd" => description.set("sgd_p", &[self.shape]),
            _ => description,
        };
        Bsdf::new(&description).unwrap()
    }

    pub fn density<T: Precision>(&self) -> impl Fn(T::Vector) -> T {
        let bsdf = self.bsdf::<T>("implicit");
        // f = D F G / (4 (n.l)(n.v)) with G = (n.l)(n.v); the value has one more n.l.
        move |h| {
            let [_, _, z] = h.into();
            bsdf.value(h, h, None)[0] * T::new(4.0) / z
        }
    }

    /// G1 of directions of an elevation: with wi mirrored from wo, h is the normal and
    /// G = 1 / (1 + 2 Lambda).
    pub fn masking<T: Precision>(&self) -> impl Fn(T::Vector) -> T {
        let [smith, implicit] = ["smith", "implicit"].map(|masking| self.bsdf::<T>(masking));
        move |wo| {
            let [x, y, z] = wo.into();
            let wi = [-x, -y, z].into();
            let correlated = smith.value(wo, wi, None)[0] / implicit.value(wo, wi, None)[0] * z * z;
            T::new(2.0) * correlated / (T::new(1.0) + correlated)
        }
    }
}

/// A direction over +X from the tangent of its angle to +Z.
pub fn over_x(tangent: f64) -> DVec3 {
    let z = 1.0 / (1.0 + tangent * tangent).sqrt();
    DVec3::new(tangent * z, 0.0, z)
}

/// Adaptive Simpson's rule.
pub fn integrate(f: &impl Fn(f64) -> f64, [a, b]: [f64; 2], tolerance: f64) -> f64 {
    fn refine(
        f: &impl Fn(f64) -> f64,
        [a, b]: [f64; 2],
        [fa, fm, fb]: [f64; 3],
        tolerance: f64,
        depth: u32,
    ) -> f64 {
        let m = (a + b) / 2.0;
        let [fl, fr] = [f((a + m) / 2.0), f((m + b) / 2.0)];
        let coarse = (b - a) / 6.0 * (fa + 4.0 * fm + fb);
        let fine = (b - a) / 12.0 * (fa + 4.0 * fl + 2.0 * fm + 4.0 * fr + fb);
        if depth == 0 || (fine - coarse).abs() < 15.0 * tolerance {
            return fine + (fine - coarse) / 15.0;
        }
        refine(f, [a, m], [fa, fl, fm], tolerance / 2.0, depth - 1)
            + refine(f, [m, b], [fm, fr, fb], tolerance / 2.0, depth - 1)
    }
    let pieces = 64;
    let edge = |k: usize| a + (b - a) * k as f64 / pieces as f64;
    (0..pieces)
        .map(|k| {
            let [a, b] = [edge(k), edge(k + 1)];
            let at = [f(a), f((a + b) / 2.0), f(b)];
            refine(f, [a, b], at, tolerance / pieces as f64, 30)
        })
        .sum()
}

/// Range of ln tan in which all but 1e-16 of the area is.
pub fn range(alpha: f32) -> [f64; 2] {
    [f64::from(alpha).ln() - 19.0, 19.0]
}

/// The projected area between two ln tan.
pub fn area(density: &impl Fn(DVec3) -> f64, range: [f64; 2]) -> f64 {
    let per_ln = |x: f64| {
        let h = over_x(x.exp());
        // dw = sin dtheta dphi, and dtheta = sin cos d(ln tan).
        2.0 * PI * density(h) * h.z * h.x * h.x * h.z
    };
    integrate(&per_ln, range, 1e-11)
}

/// The integral of D(h) max(0, <w, h>), azimuths by Simpson's rule.
pub fn visible_area(density: &impl Fn(DVec3) -> f64, w: DVec3, [from, to]: [f64; 2]) -> f64 {
    let per_ln = |x: f64| {
        let h = over_x(x.exp());
        // The part of the ring that is seen reaches to the azimuth where <w, h> = 0.
        let tilt = w.z * h.z / (w.x * h.x);
        let last = if tilt >= 1.0 { PI } else { (-tilt).acos() };
        let seen = |phi: f64| w.z * h.z + w.x * h.x * phi.cos();
        let step = last / 128.0;
        let ring: f64 = (0..64)
            .map(|k| [0.0, 1.0, 2.0].map(|j| seen((f64::from(2 * k) + j) * step)))
            .map(|[a, b, c]| (a + 4.0 * b + c) * step / 3.0)
            .sum();
        2.0 * ring * density(h) * h.x * h.x * h.z
    };
    // Rings are seen whole up to the complement of w's angle. The area is at least w.z / 2 and a fifth
    // of the density's width.
    let kink = (w.z / w.x).ln().clamp(from, to);
    let tolerance = 1e-9 * (w.z + 0.2 / (PI * density(DVec3::Z)).sqrt());
    integrate(&per_ln, [from, kink], tolerance) + integrate(&per_ln, [kink, to], tolerance)
}

/// Angles at which masking does something: their cotangents are from 1e-4 alpha, which is less than
/// the mean slope, to 10, which is more.
pub fn viewers(alpha: f32) -> impl Iterator<Item = DVec3> {
    let least = 0.1f64.ln();
    let most = (1e4 / f64::from(alpha)).ln();
    (0..12).map(move |k| over_x((least + (most - least) * f64::from(k) / 11.0).exp()))
}
