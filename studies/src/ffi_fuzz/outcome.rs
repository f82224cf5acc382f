//! What every call must keep to.

use pellicle::capi::*;
use std::ffi::CStr;

/// Whether the call succeeded; a failure must be one of those documented for it, and be explained.
pub fn succeeded(status: PellicleStatus, documented: &[PellicleStatus]) -> bool {
    if status == PELLICLE_OK {
        return true;
    }
    // SAFETY: the message is NUL-terminated and lives until this thread's next failure.
    let message = unsafe { CStr::from_ptr(pellicle_last_error()) };
    let message = message.to_str().expect("messages are UTF-8");
    assert!(documented.contains(&status), "status {status}: {message}");
    assert!(!message.is_empty(), "status {status} without a message");
    false
}

/// An output with a pattern that no call writes.
pub struct Output<T> {
    bytes: Vec<u8>,
    kind: std::marker::PhantomData<T>,
}

const PATTERN: u8 = 0x5A;

impl<T: Copy> Output<T> {
    pub fn new() -> Self {
        Self {
            bytes: vec![PATTERN; size_of::<T>()],
            kind: std::marker::PhantomData,
        }
    }

    pub fn pointer(&mut self) -> *mut T {
        self.bytes.as_mut_ptr().cast()
    }

    /// What a successful call wrote. Every pattern of bytes must be a T.
    pub fn get(&self) -> T {
        // SAFETY: as large as T; read at any alignment.
        unsafe { self.bytes.as_ptr().cast::<T>().read_unaligned() }
    }

    /// Panics if anything was written.
    pub fn must_be_untouched(&self) {
        assert!(
            self.bytes.iter().all(|byte| *byte == PATTERN),
            "an output was written"
        );
    }
}

/// Panics unless each is finite, not negative and at most `greatest`.
pub fn must_be_within(numbers: &[f32], greatest: f32) {
    let is_good = |x: &f32| x.is_finite() && *x >= 0.0 && *x <= greatest;
    assert!(
        numbers.iter().all(is_good),
        "{numbers:?} beyond [0, {greatest}]"
    );
}

/// Panics unless it is none at all, or one of the handle's lobes with good numbers.
pub fn must_be_sample(sample: &PellicleSample, info: &PellicleBsdfInfo) {
    let numbers = [
        sample.pdf,
        sample.weight[0],
        sample.weight[1],
        sample.weight[2],
        sample.eta,
    ];
    must_be_within(&numbers, f32::INFINITY);
    let length = glam::Vec3::from(sample.wi).length();
    if sample.flags == 0 {
        assert!(
            length == 0.0 && numbers == [0.0; 5] && sample.lobe == 0,
            "half a sample"
        );
        return;
    }
    // The direction to the viewer may be off by 1e-3, what lies about its mirror image by twice that.
    assert!((length - 1.0).abs() < 2e-3, "wi = {:?}", sample.wi);
    assert!(sample.flags & !info.flags == 0 && sample.lobe < info.lobe_count);
}
