//! Two habits of Blender Cycles 5.0 (`intern/cycles/kernel/closure/bsdf_util.h`, `fresnel_iridescence`), each applied to
//! the truth, which shows the error of the habit alone:
//!
//! - Where the upper interface reflects totally, n0 sin(theta0) >= n1, it returns R = 1. Light that tunnels through the
//!   film, or that the base absorbs, is lost.
//! - Below a thickness d of 1 nm the film's index is mix(n0, n1, s), s = 3 d^2 - 2 d^3, so that the film vanishes.

use super::stack::{Stack, Truth};
use pellicle::num::Rgb;
use pellicle::optics::{Medium, VISIBLE_NM};

/// A habit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Habit {
    MirrorAtTotalReflection,
    FadeBelow1Nm,
}

/// The thickness below which films fade, nm.
const FADE_NM: f64 = 1.0;
/// Cycles knows one index; of a medium that disperses it is taken to be that at this wavelength, nm.
const MIDDLE_NM: f64 = 550.0;

impl Habit {
    pub const ALL: [Self; 2] = [Self::MirrorAtTotalReflection, Self::FadeBelow1Nm];

    /// In tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::MirrorAtTotalReflection => "truth, but R = 1 at total reflection on the film",
            Self::FadeBelow1Nm => "truth, but films fade below 1 nm",
        }
    }

    /// What the habit makes of a stack's reflectance, not clipped; none where it changes nothing.
    pub fn changed(self, stack: &Stack, cos_theta: f64, thickness_nm: f64) -> Option<Rgb<f64>> {
        match self {
            Self::MirrorAtTotalReflection => {
                let [above, film] = [&stack.ambient, &stack.film].map(|m| m.index(MIDDLE_NM));
                let sine = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
                let is_total = film.im == 0.0 && above.re * sine >= film.re && film.re < above.re;
                is_total.then_some([1.0; 3])
            }
            Self::FadeBelow1Nm if thickness_nm < FADE_NM => {
                let truth = faded(stack, thickness_nm);
                Some(truth.reflectance(cos_theta, thickness_nm))
            }
            Self::FadeBelow1Nm => None,
        }
    }
}

/// With the film's index between the ambient's and its own.
fn faded(stack: &Stack, thickness_nm: f64) -> Truth {
    let t = (thickness_nm / FADE_NM).clamp(0.0, 1.0);
    let part = t * t * (3.0 - 2.0 * t);
    let mixed = |nm: f64| {
        let [above, film] = [&stack.ambient, &stack.film].map(|medium| medium.index(nm));
        [above.re + part * (film.re - above.re), part * film.im]
    };
    let film = if stack.ambient.constant().is_some() && stack.film.constant().is_some() {
        let [eta, k] = mixed(MIDDLE_NM);
        Medium::rgb([eta; 3], [k; 3])
    } else {
        const STEP_NM: f64 = 5.0;
        let steps = ((VISIBLE_NM[1] - VISIBLE_NM[0]) / STEP_NM) as usize;
        let nm: Vec<f64> = (0..=steps)
            .map(|i| VISIBLE_NM[0] + STEP_NM * i as f64)
            .collect();
        let [eta, k] = [0, 1].map(|i| nm.iter().map(|nm| mixed(*nm)[i]).collect::<Vec<f64>>());
        Medium::table(&nm, &eta, &k)
    };
    let stack = Stack {
        film: film.unwrap(),
        ..stack.clone()
    };
    stack.truth().unwrap()
}

/// Frustrated total reflection is lost; below the critical angle nothing changes. R of a gap of no thickness is 0.
#[test]
fn a_gap_without_thickness_becomes_a_mirror() {
    let gap = Stack::constant([[1.5, 0.0], [1.0, 0.0], [1.5, 0.0]]);
    let habit = Habit::MirrorAtTotalReflection;
    assert_eq!(habit.changed(&gap, 0.5, 0.0), Some([1.0; 3]));
    assert_eq!(habit.changed(&gap, 0.8, 0.0), None);
    assert!(gap.truth().unwrap().reflectance(0.5, 1e-3)[0] < 1e-6);
}

/// At a quarter of a nanometre s is 5 / 32: in thin films the amplitude added to the bare base's is proportional
/// to the difference of squares (O. Heavens, "Optical Properties of Thin Solid Films", section 4.9), here of the soap film
/// R = (pi d (n^2 - 1) / lambda)^2.
#[test]
fn films_fade_smoothly() {
    let soap = Stack::constant([[1.0, 0.0], [1.33, 0.0], [1.0, 0.0]]);
    let faded = Habit::FadeBelow1Nm.changed(&soap, 1.0, 0.25).unwrap();
    let truth = soap.truth().unwrap().reflectance(1.0, 0.25);
    let expected = (((1.0f64 + 0.33 * 5.0 / 32.0).powi(2) - 1.0) / (1.33f64.powi(2) - 1.0)).powi(2);
    for (faded, truth) in faded.into_iter().zip(truth) {
        assert!(
            (faded / truth / expected - 1.0).abs() < 0.01,
            "{faded:e} {truth:e}"
        );
    }
    assert_eq!(Habit::FadeBelow1Nm.changed(&soap, 1.0, 1.0), None);
}
