//! The single-precision elementary functions against the C library's in double precision.
//!
//! The bounds are those stated in `src/num/elementary.rs`. Every 97th float of each range is tried;
//! the step is prime to every power of two, so all mantissa bits are exercised.

use pellicle::num::Real;

/// Distance in units in the last place of the true value.
fn ulps(found: f32, truth: f64) -> f64 {
    let rounded = truth as f32;
    let ulp = f64::from(rounded.abs().next_up()) - f64::from(rounded.abs());
    (f64::from(found) - truth).abs() / ulp
}

/// Floats between two positive bounds, by their bits.
fn floats(from: f32, to: f32) -> impl Iterator<Item = f32> {
    (from.to_bits()..=to.to_bits())
        .step_by(97)
        .map(f32::from_bits)
}

fn worst(inputs: impl Iterator<Item = f32>, error: impl Fn(f32) -> f64) -> (f64, f32) {
    inputs.fold((0.0, 0.0), |worst, x| {
        let error = error(x);
        assert!(!error.is_nan(), "NaN at {x}");
        if error > worst.0 { (error, x) } else { worst }
    })
}

fn assert_below(bound: f64, (error, at): (f64, f32), name: &str) {
    println!("{name}: {error:.3} at {at:e}");
    assert!(error <= bound, "{name}: {error} at {at:e}, stated {bound}");
}

#[test]
fn exp_is_accurate() {
    let error = |x: f32| ulps(Real::exp(x), f64::from(x).exp());
    assert_below(1.5, worst(floats(1e-30, 88.0), error), "exp(x)");
    assert_below(
        1.5,
        worst(floats(1e-30, 87.3).map(|x| -x), error),
        "exp(-x)",
    );
    assert_eq!(Real::exp(-1e30_f32), 0.0);
    assert_eq!(Real::exp(0.0_f32), 1.0);
}

#[test]
fn exp_m1_is_accurate() {
    let error = |x: f32| ulps(Real::exp_m1(x), f64::from(x).exp_m1());
    assert_below(3.0, worst(floats(1e-30, 88.0), error), "exp_m1(x)");
    assert_below(
        3.0,
        worst(floats(1e-30, 87.3).map(|x| -x), error),
        "exp_m1(-x)",
    );
}

#[test]
fn ln_is_accurate() {
    let error = |x: f32| ulps(Real::ln(x), f64::from(x).ln());
    assert_below(1.5, worst(floats(f32::MIN_POSITIVE, f32::MAX), error), "ln");
    assert_eq!(Real::ln(0.0_f32), f32::NEG_INFINITY);
}

#[test]
fn ln_1p_is_accurate() {
    let error = |x: f32| ulps(Real::ln_1p(x), f64::from(x).ln_1p());
    assert_below(2.0, worst(floats(1e-30, 1e30), error), "ln_1p(x)");
    assert_below(
        2.0,
        worst(floats(1e-30, 1.0f32.next_down()).map(|x| -x), error),
        "ln_1p(-x)",
    );
    assert_eq!(Real::ln_1p(-1.0_f32), f32::NEG_INFINITY);
}

#[test]
fn turns_are_accurate() {
    let phase = |x: f32| (f64::from(x) - f64::from(x).round()) * std::f64::consts::TAU;
    let cosine = |x: f32| (f64::from(Real::cos_turns(x)) - phase(x).cos()).abs();
    let sine = |x: f32| (f64::from(Real::sin_turns(x)) - phase(x).sin()).abs();
    assert_below(2e-7, worst(floats(1e-30, 1e9), cosine), "cos_turns");
    assert_below(
        2e-7,
        worst(floats(1e-30, 1e9).map(|x| -x), cosine),
        "cos_turns(-x)",
    );
    assert_below(2e-7, worst(floats(1e-30, 1e9), sine), "sin_turns");
    assert_below(
        2e-7,
        worst(floats(1e-30, 1e9).map(|x| -x), sine),
        "sin_turns(-x)",
    );
}
