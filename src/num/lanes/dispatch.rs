//! Runs double-precision loops with AVX2 where the processor has it.

#![allow(unsafe_code)]

/// Calls `work`, in a copy compiled for AVX2 where the processor has it. No operation is fused, so that
/// every processor finds the same bits. `work` should be a long loop, and everything that it calls must be
/// inlined to gain from AVX2.
#[inline]
pub fn widest<R>(work: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2.
        return unsafe { with_avx2(work) };
    }
    work()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<R>(work: impl FnOnce() -> R) -> R {
    work()
}
